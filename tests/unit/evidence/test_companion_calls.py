"""Each call of the table of companions is found in code that makes it, and in no code that only looks like it."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from hanging import ends
from roslab.evidence.python import called, companions
from roslab.knowledge.table import rows
from roslab.repository.checkout import Repository

CALLS = (
    ("cv2", "from cv2.typing import MatLike", "opencv-python>=4.8.0.76"),
    ("cv2", "import os\nimport cv2.typing", "opencv-python>=4.8.0.76"),
    ("cv2", "from cv2 import typing", "opencv-python>=4.8.0.76"),
    ("mujoco", "from mujoco import mjx", "mujoco-mjx"),
    ("mujoco", "import mujoco.mjx as mjx", "mujoco-mjx"),
    ("pandas", "frame.to_excel('a.xlsx')", "openpyxl"),
    ("pandas", "with pd.ExcelWriter(path) as out: pass", "openpyxl"),
    ("pandas", "frame.to_excel(path, engine='xlsxwriter')", "XlsxWriter"),
    ("pandas", "pd.read_excel(path, sheet_name=0)", "openpyxl"),
    ("pandas", "pd.read_excel('old.xls')", "xlrd"),
    ("pandas", "pd.read_hdf('a.h5')", "tables"),
    ("pandas", "store = pd.HDFStore('a.h5')", "tables"),
    ("pandas", "print(frame.to_markdown())", "tabulate"),
    ("pandas", "frame.to_parquet(path)", "pyarrow"),
    ("pandas", "pd.read_feather(path)", "pyarrow"),
    ("pandas", "pd.read_html(page)", "lxml"),
    ("pandas", "frame.to_latex(index=False)", "jinja2"),
    ("plotly", "fig.write_image('a.png')", "kaleido"),
    ("plotly", "import plotly.express as px", "pandas"),
    ("plotly", "go.FigureWidget(fig)", "anywidget"),
    ("gymnasium", "env = gym.wrappers.RecordVideo(env, 'films')", "moviepy"),
    ("gym", "env = RecordVideo(env, 'films')", "moviepy"),
    ("stable-baselines3", "env = VecVideoRecorder(env, 'films')", "moviepy"),
    ("stable-baselines3", "model.set_logger(configure(path, ['stdout', 'tensorboard']))", "tensorboard"),
    ("torch", "from torch.utils import data, tensorboard", "tensorboard"),
    ("torch", "writer.add_video('film', frames)", "moviepy"),
    ("tensorboardx", "writer.add_video('film', frames)", "moviepy"),
    ("torch", "torch.onnx.export(model, x, 'a.onnx')", "onnx"),
    ("torchvision", "torchvision.io.read_video(path)", "av"),
    ("torchvision", "from torchvision.io import write_video", "av"),
    ("torchvision", "datasets.CocoDetection(root, file)", "pycocotools"),
    ("torchmetrics", "fid = FrechetInceptionDistance(feature=64)", "torch-fidelity"),
    ("torchmetrics", "m = MeanAveragePrecision()", "pycocotools"),
    ("pytorch-lightning", "Trainer(callbacks=[RichProgressBar()])", "rich"),
    ("lightning", "Trainer(callbacks=[RichProgressBar()])", "rich"),
    ("imageio", "imageio.mimsave('film.mp4', frames, fps=30)", "imageio-ffmpeg"),
    ("imageio", "imageio.v2.get_writer(os.path.join(out, 'film.mp4'))", "imageio-ffmpeg"),
    ("imageio", "name = f'{out}/film.mp4'\nimageio.mimsave(name, frames)", "imageio-ffmpeg"),
    ("trimesh", "mesh.ray.intersects_location(a, b)", "rtree"),
    ("trimesh", "trimesh.proximity.signed_distance(mesh, points)", "rtree"),
    ("trimesh", "parts = mesh.split(only_watertight=False)", "networkx"),
    ("trimesh", "trimesh.load('arm.dae')", "pycollada"),
    ("trimesh", "mesh.convex_decomposition()", "vhacdx"),
    ("trimesh", "mesh.simplify_quadric_decimation(100)", "fast-simplification"),
    ("trimesh", "hull = mesh.convex_hull", "scipy"),
    ("trimesh", "trimesh.creation.extrude_polygon(shape, 1)", "shapely"),
    ("trimesh", "trimesh.creation.extrude_polygon(shape, 1)", "mapbox_earcut"),
    ("trimesh", "trimesh.boolean.union([a, b])", "manifold3d"),
    ("transformers", "AutoModel.from_pretrained(name, device_map='auto')", "accelerate"),
    ("transformers", "args = TrainingArguments(out)", "accelerate"),
    ("transformers", "AutoModel.from_pretrained(name, load_in_8bit=True)", "bitsandbytes"),
    ("transformers", "T5Tokenizer.from_pretrained(name)", "sentencepiece"),
    ("diffusers", "pipe.enable_model_cpu_offload()", "accelerate"),
    ("diffusers", "from diffusers import StableDiffusionPipeline", "transformers"),
    ("diffusers", "export_to_video(frames, 'a.mp4')", "imageio"),
    ("diffusers", "export_to_video(frames, 'a.mp4')", "imageio-ffmpeg"),
    ("ray", "from ray import tune", "ray[tune]"),
    ("ray", "from ray.rllib.algorithms import ppo", "ray[rllib]"),
    ("ray", "from ray import serve", "ray[serve]"),
    ("wandb", "wandb.log({'film': wandb.Video(frames, fps=4)})", "moviepy"),
    ("wandb", "wandb.log({'film': wandb.Video(frames, fps=4)})", "imageio"),
    ("dask", "import dask.dataframe as dd", "dask[dataframe]"),
    ("dask", "from dask.distributed import Client", "dask[distributed]"),
    ("networkx", "nx.drawing.nx_pydot.write_dot(g, 'a')", "pydot"),
    ("networkx", "from networkx.drawing.nx_agraph import graphviz_layout", "pygraphviz"),
    ("networkx", "nx.pagerank(g)", "scipy"),
    ("pyvista", "plotter.open_movie('a.mp4')", "imageio"),
    ("pyvista", "plotter.open_movie('a.mp4')", "imageio-ffmpeg"),
    ("pyvista", "plotter.open_gif('a.gif')", "imageio"),
    ("xarray", "xr.open_dataset('a.nc')", "netCDF4"),
    ("optuna", "optuna.visualization.plot_contour(study)", "plotly"),
    ("optuna", "optuna.samplers.CmaEsSampler(seed=1)", "cmaes"),
    ("optuna", "optuna.importance.get_param_importances(study)", "scikit-learn"),
    ("tensorflow", "tf.keras.utils.plot_model(model)", "pydot"),
    ("keras", "plot_model(model)", "pydot"),
    ("scikit-image", "image = skimage.data.astronaut()", "pooch"),
    ("scikit-image", "from skimage import io, data", "pooch"),
    ("scipy", "from scipy import datasets", "pooch"),
    ("fastapi", "def up(file: UploadFile): pass", "python-multipart"),
    ("fastapi", "async def live(socket: WebSocket): pass", "websockets"),
    ("cvxpy", "problem.solve(solver=cp.ECOS)", "ecos"),
    ("cvxpy", "problem.solve(solver='GUROBI')", "gurobipy"),
    ("cvxpy", "problem.solve(solver=cvxpy.MOSEK)", "Mosek"),
    ("cvxpy", "problem.solve(solver=cp.GLPK_MI)", "cvxopt"),
    ("cvxpy", "problem.solve(solver=cp.PROXQP)", "proxsuite"),
    ("cvxpy", "problem.solve(solver=cp.PIQP)", "piqp"),
    ("cvxpy", "problem.solve(solver=cp.SCIP)", "pyscipopt"),
    ("qpsolvers", "solve_ik(tasks, dt, solver='quadprog')", "quadprog"),
    ("qpsolvers", "solve_qp(P, q, solver='osqp')", "osqp"),
    ("qpsolvers", "solve_qp(P, q, solver='proxqp')", "proxsuite"),
    ("qpsolvers", "solve_qp(P, q, solver='cvxopt')", "cvxopt"),
    ("qpsolvers", "solve_qp(P, q, solver='ecos')", "ecos"),
    ("qpsolvers", "solve_qp(P, q, solver='scs')", "scs"),
    ("qpsolvers", "solve_qp(P, q, solver='highs')", "highspy"),
    ("qpsolvers", "solve_qp(P, q, solver='daqp')", "daqp"),
    ("qpsolvers", "solve_qp(P, q, solver='piqp')", "piqp"),
    ("qpsolvers", "solve_qp(P, q, solver='clarabel')", "clarabel"),
    ("pyomo", "pyo.SolverFactory('appsi_highs')", "highspy"),
    ("scipy", "from scipy.spatial.transform import Rotation as R", "scipy>=1.2"),
    ("scipy", "from scipy.spatial import transform\n\nr = transform.Rotation.from_matrix(m)", "scipy>=1.4"),
)
ELSEWHERE = frozenset({"torch-cluster", "gymnasium[box2d]", "gym[box2d]", "pygame", "ninja"})
"""What other tests have code for."""


def needed(tmp_path: Path, code: str) -> set[tuple[str, str]]:
    (tmp_path / "train.py").write_text(f"import os\n{code}\n")
    return {(each.value, each.text) for each in companions.read(Repository.open(tmp_path))}


@pytest.mark.parametrize(("package", "code", "needs"), CALLS)
def test_a_call_is_found(tmp_path: Path, package: str, code: str, needs: str) -> None:
    assert (package, needs) in needed(tmp_path, code)


def test_every_row_of_a_call_has_code_that_makes_it() -> None:
    tested = {(package, needs) for package, _, needs in CALLS}
    others = {("stable-baselines3", name) for name in ("tensorboard", "rich", "tqdm")}
    known = {(each["package"], each["needs"]) for each in rows("companions") if each["needs"] not in ELSEWHERE}
    assert known == tested | others


@pytest.mark.parametrize(
    "code",
    [
        "# frame.to_excel('a.xlsx')",
        "pd.read_csv(path)",
        "frame.to_parquet(path, engine='fastparquet')",
        "imageio.imread('a.png')",
        "imageio.mimsave('a.gif', frames)",
        "model.to(device)  # device_map",
        "AutoModel.from_pretrained(name, device_map=None)",
        "problem.solve(solver=cp.OSQP)",
        "from stable_baselines3.common.monitor import Monitor",
        "def plot(model): pass",
        "xr.open_dataset('a.zarr', engine='zarr')",
        "parts = text.split(',')",
    ],
)
def test_what_only_looks_like_a_call_is_none(tmp_path: Path, code: str) -> None:
    assert not needed(tmp_path, code)


@pytest.mark.parametrize(
    ("code", "apt"),
    [
        ("film = FuncAnimation(fig, step)\nfilm.save('film.mp4', fps=30)", ["ffmpeg"]),
        ("film.save(path, writer='ffmpeg')", ["ffmpeg"]),
        ("writer = FFMpegWriter(fps=15)", ["ffmpeg"]),
        ("film.save('film.gif', writer='imagemagick')", ["imagemagick"]),
        ("from gym import wrappers\nenv = wrappers.Monitor(env, 'films')", ["ffmpeg"]),
        ("from gym.wrappers import Monitor, TimeLimit", ["ffmpeg"]),
        ("tf.keras.utils.plot_model(model)", ["graphviz"]),
        ("SolverFactory('glpk')", ["glpk-utils"]),
        ("pyo.SolverFactory('cbc')", ["coinor-cbc"]),
        ("film = FuncAnimation(fig, step)\nfilm.save('film.gif')", []),
        ("# writer = FFMpegWriter(fps=15)", []),
        ("from stable_baselines3.common.monitor import Monitor\nenv = Monitor(env)", []),
        ("SolverFactory('ipopt')", []),
    ],
)
def test_a_library_starts_a_program(tmp_path: Path, code: str, apt: list[str]) -> None:
    (tmp_path / "train.py").write_text(f"import os\n{code}\n")
    found = called.read(Repository.open(tmp_path))
    assert [(each.name, each.role) for each in found] == [(name, "called") for name in apt]


def test_imports_without_end_take_no_time() -> None:
    code = "from scipy.spatial.transform import Rotation\n" * 12_000
    with ends():
        assert not any(re.search(row["pattern"], code) for row in rows("companions") if row["needs"] == "scipy>=1.4")
