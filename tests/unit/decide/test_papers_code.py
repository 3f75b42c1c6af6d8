"""Code of papers that is no ROS: what small trees in its manner come to, from the files to the decision."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.config.model import Config
from roslab.decide import decide
from roslab.decide.decision import Decision
from roslab.evidence.gather import gather
from roslab.knowledge.never import never
from roslab.repository.checkout import Repository
from roslab.values.requirement import Requirement

MAIN = 'import torch\n\nif __name__ == "__main__":\n    pass\n'


def decided(tmp_path: Path, files: dict[str, str]) -> Decision:
    for name, text in files.items():
        path = tmp_path / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
    return decide(gather(Repository.open(tmp_path)), Config(), folder_name="paper")


def lines(asked: tuple[Requirement, ...]) -> tuple[str, ...]:
    return tuple(each.text for each in asked)


@pytest.mark.parametrize(
    ("line", "ubuntu"),
    [
        ("`fx` is the focal length", "jammy"),
        ("$f_x, f_y$: the focal distances, in pixels", "jammy"),
        ("the pinhole camera (Focal + principal point and image size)", "jammy"),
        ("works with focal or depth images", "jammy"),
        ("Tested on focal.", "focal"),
        ("- `focal`", "focal"),
        ("builds on focal and newer", "focal"),
        ("Packages: focal, jammy (planned)", "focal"),
        ("the Docker image focal has it", "focal"),
    ],
)
def test_a_camera_has_a_focal_length_and_ubuntu_a_release(tmp_path: Path, line: str, ubuntu: str) -> None:
    assert decided(tmp_path, {"CMakeLists.txt": "project(slam)\n", "README.md": f"{line}\n"}).ubuntu == ubuntu


def test_a_small_driver_beside_a_python_program_makes_no_cpp_project(tmp_path: Path) -> None:
    files = {
        "main.py": MAIN,
        "robot.py": "import numpy\n",
        "utils.py": "import cv2\n",
        "camera/CMakeLists.txt": "project(camera)\nadd_executable(camera camera.cpp)\n",
        "camera/camera.cpp": "#include <librealsense2/rs.hpp>\n",
    }
    assert decided(tmp_path, files).kind == "cuda"


def test_cmake_that_requires_cuda_for_sources_of_its_own_is_cuda(tmp_path: Path) -> None:
    cmake = {"CMakeLists.txt": "project(fusion)\nfind_package(CUDA REQUIRED)\n"}
    assert decided(tmp_path, cmake).kind == "cpp"
    assert decided(tmp_path, {**cmake, "src/reduce.cu": ""}).kind == "cuda"


def test_an_examples_requirements_choose_no_cuda(tmp_path: Path) -> None:
    files = {"main.py": MAIN, "requirements.txt": "torch==2.7.1\n"}
    decision = decided(tmp_path, {**files, "examples/old/requirements.txt": "torch==1.11.0+cu113\n"})
    assert decision.cuda == "12.6"


def test_the_authors_own_image_has_its_own_cuda(tmp_path: Path) -> None:
    files = {"main.py": MAIN, "requirements.txt": "torch==1.11.0+cu113\n"}
    assert decided(tmp_path, files).cuda == "11.3"
    decision = decided(tmp_path, {**files, "Dockerfile": "FROM nvidia/cuda:12.2.2-runtime-ubuntu22.04\nCOPY . /app\n"})
    assert (decision.dockerfile, decision.cuda) == ("Dockerfile", "12.2")
    assert next(r for r in decision.reasons if r.question == "cuda").reason.endswith(
        "nvidia/cuda:12.2.2-runtime-ubuntu22.04"
    )


AUTHORED = "FROM {}\nCOPY . /app\nRUN make\n"


@pytest.mark.parametrize(
    ("bases", "best"),
    [
        ({"Dockerfile.ubuntu20": "ubuntu:20.04", "Dockerfile.ubuntu24": "ubuntu:24.04"}, "Dockerfile.ubuntu24"),
        ({"Dockerfile.cuda": "nvidia/cuda:11.8.0-devel-ubuntu22.04", "Dockerfile.x": "ubuntu:22.04"}, "Dockerfile.x"),
        ({"docker/a/b/Dockerfile": "ubuntu:22.04", "Dockerfile.desktop": "ubuntu:22.04"}, "Dockerfile.desktop"),
        ({"docker/Dockerfile.a": "lab/slam:latest", "docker/Dockerfile.u": "ubuntu:22.04"}, "docker/Dockerfile.u"),
        ({"docker/Dockerfile": "ubuntu:22.04", "Dockerfile.dev2": "ubuntu:22.04"}, "docker/Dockerfile"),
    ],
)  # fmt: skip
def test_of_several_dockerfiles_the_one_for_everybody(tmp_path: Path, bases: dict[str, str], best: str) -> None:
    files = {"CMakeLists.txt": "project(slam)\n"} | {name: AUTHORED.format(base) for name, base in bases.items()}
    assert decided(tmp_path, files).dockerfile == best


def test_what_is_struck_through_is_installed_no_more(tmp_path: Path) -> None:
    readme = "* ~~PyTorch 0.3:~~\n  ~~```\n  pip install torch==0.3.1\n  ```~~\n* 1.0+:\n```\npip install torch\n```\n"
    assert lines(decided(tmp_path, {"main.py": MAIN, "README.md": readme}).pip) == ("torch",)


def test_a_python_that_the_pinned_opencv_has_a_wheel_for(tmp_path: Path) -> None:
    decision = decided(tmp_path, {"main.py": MAIN, "requirements.txt": "torch>=1.1\nopencv-python==4.1.2.30\n"})
    assert decision.python.version == "3.8"


@pytest.mark.parametrize(
    ("readme", "command"),
    [
        ("python demo.py --images=<path to images>\n", ("python", "demo.py")),
        ("python demo.py --run yyy-yy\n", ("python", "demo.py")),
        ("python demo.py\n", ("python", "demo.py")),
        ("python demo.py\npython plot.py\n", ("python", "demo.py")),
        ("python script.py\npython demo.py\n", ("python", "script.py")),  # no less a program for having no guard
        ("python download.py\npython tools/make_dataset.py\npython demo.py\n", ("python", "demo.py")),
        ("python -m tools.kitti_dataset create\n", ("bash",)),
        ("python demo.py --hid [32,32]\n", ("python", "demo.py", "--hid", "[32,32]")),
        ("python demo.py nets=['out/a.pth','b.pth'] n=1\n", ("python", "demo.py", "nets=[out/a.pth,b.pth]", "n=1")),
        ("python demo.py net=[path/to/net] n=1\n", ("python", "demo.py", "n=1")),
        ("CUDA_VISIBLE_DEVICES=0 python demo.py\n", ("python", "demo.py")),
        ("poetry run python demo.py\n", ("python", "demo.py")),
        ("uv run --extra viz demo.py --fast\n", ("python", "demo.py", "--fast")),
        ("mpirun -np 4 python demo.py\n", ("python", "demo.py")),
        ("torchrun --nproc_per_node=2 demo.py\n", ("python", "demo.py")),
        ("bash run.sh\n", ("bash", "run.sh")),
        ("./run.sh --all\npython demo.py\n", ("bash", "run.sh", "--all")),
        ("sh get.sh\n", ("bash",)),
        ("python test_simple.py --image a.jpg\npython demo.py\n", ("python", "test_simple.py", "--image", "a.jpg")),
        ("./demo.py -v\n", ("python", "demo.py", "-v")),
        ("python demo.py [...]\n", ("python", "demo.py")),
        ("python tests/a_test.py\n", ("bash",)),
    ],
)
def test_what_the_readme_runs(tmp_path: Path, readme: str, command: tuple[str, ...]) -> None:
    files = {"demo.py": MAIN, "eval.py": MAIN, "tests/a_test.py": MAIN, "plot.py": "import numpy\n"}
    files |= {
        "script.py": "import numpy\n",
        "run.sh": "",
        "test_simple.py": MAIN,
        "tools/make_dataset.py": MAIN,
        "tools/kitti_dataset.py": MAIN,
    }
    files["requirements.txt"] = "torch\n"
    assert decided(tmp_path, {**files, "README.md": f"```\n{readme}```\n"}).command == command


def test_a_page_deep_in_the_tree_does_not_say_what_the_whole_runs(tmp_path: Path) -> None:
    files = {"demo.py": MAIN, "data/convert.py": MAIN, "requirements.txt": "torch\n"}
    files["README.md"] = "```\npython demo.py --data my/data\n```\n"
    assert decided(tmp_path, {**files, "data/README.md": "```\npython data/convert.py\n```\n"}).command == (
        "python", "demo.py", "--data", "my/data",
    )  # fmt: skip


def test_a_compiled_project_is_not_its_helper_script(tmp_path: Path) -> None:
    files = {"CMakeLists.txt": "project(mpc)\nadd_executable(mpc main.cc)\n", "tools/plot.py": MAIN}
    assert decided(tmp_path, {**files, "README.md": "```\npython tools/plot.py\n```\n"}).command == ("bash",)
    assert decided(tmp_path, {**files, "README.md": "Build it.\n"}).command == ("mpc",)


@pytest.mark.parametrize(
    "name",
    [
        "nvidia-headless-470",
        "xserver-xorg-video-nvidia-470",
        "cuda-compat-11-1",
        "libnvidia-gl-535",
        "cuda",
        "cuda-11-8",
    ],
)
def test_no_image_holds_the_hosts_driver(name: str) -> None:
    assert never().match(name)
    assert not never().match("libnvidia-container-tools")
    assert not never().match("nvidia-cuda-toolkit")
    assert not never().match("cuda-toolkit-11-8")
    assert never(cuda=True).match("cuda-toolkit-11-8")  # the base has one


@pytest.mark.parametrize(
    ("builds", "kept"), [(("110", "111", "116"), "116"), (("110", "11x", "12x"), "11x"), (("102", "110"), "102")]
)
def test_of_a_list_by_cudas_version_one_build_is_installed(tmp_path: Path, builds: tuple[str, ...], kept: str) -> None:
    page = "# Install\npip install cupy\n" + "".join(f"pip install cupy-cuda{build}\n" for build in builds)
    files = {"main.py": MAIN, "requirements.txt": "torch==1.13.1+cu116\n", "README.md": page}
    assert lines(decided(tmp_path, files).python.pip_guessed) == (f"cupy-cuda{kept}",)


TF1 = "import tensorflow as tf\n\nx = tf.placeholder(tf.float32)\n"


def test_the_api_of_tensorflow_1_needs_a_python_that_it_was_made_for(tmp_path: Path) -> None:
    decision = decided(tmp_path, {"train.py": TF1, "README.md": "Tested with CUDA 11.8.\n"})
    assert (decision.python.version, decision.python.manager) == ("3.7", "conda")
    assert "tensorflow<2" in lines(decision.python.bounds)


def test_what_is_said_of_python_outweighs_what_the_code_uses(tmp_path: Path) -> None:
    assert decided(tmp_path, {"train.py": TF1, "README.md": "Python 3.6 is required.\n"}).python.version == "3.6"


def test_the_compatible_api_of_tensorflow_2_is_not_that_of_1(tmp_path: Path) -> None:
    code = "import tensorflow as tf\nimport tensorflow.compat.v1 as tf1\nx = tf1.placeholder(tf.float32)\n"
    assert lines(decided(tmp_path, {"train.py": code}).python.bounds) == ()


def test_print_as_a_statement_is_python_2(tmp_path: Path) -> None:
    old = 'import numpy\nprint "done"\n'
    files = {"a.py": old, "b.py": old, "c.py": "import numpy\nprint(1)\n"}
    assert decided(tmp_path, files).python.version == "2.7"
    assert decided(tmp_path, {**files, "b.py": "print(2)\n"}).python.version != "2.7"


def test_of_several_images_each_has_its_own_python(tmp_path: Path) -> None:
    torch = (
        "FROM nvidia/cuda:11.3.1-base-ubuntu20.04\nRUN conda create -n a python=3.8\nRUN pip install torch==1.10.0\n"
    )
    old = "FROM ubuntu:18.04\nRUN conda create -n a python=3.7\nRUN pip install tensorflow-gpu==1.15.0\n"
    files = {"main.py": MAIN, "docker/sim/Dockerfile": torch, "docker/tensorflow/Dockerfile": old}
    assert decided(tmp_path, files).python.version == "3.8"


def test_an_image_that_names_no_python_has_its_ubuntus(tmp_path: Path) -> None:
    authored = "FROM nvidia/cuda:11.6.2-devel-ubuntu20.04\nRUN pip3 install torch==1.13.1+cu116\n"
    assert decided(tmp_path, {"main.py": MAIN, "docker/Dockerfile": authored}).python.version == "3.8"


def test_what_a_manifest_leaves_free_and_the_readme_pins(tmp_path: Path) -> None:
    files = {"main.py": MAIN, "requirements.txt": "torch>=1.4\ntorchvision\nnumpy\n"}
    readme = "```\npip install torch==1.10.0+cu113 torchvision==0.11.1+cu113\n```\n"
    decision = decided(tmp_path, {**files, "README.md": readme})
    assert lines(decision.python.bounds) == ("torch==1.10.0+cu113", "torchvision==0.11.1+cu113", "numpy<2")
    assert any("cu113" in option for option in decision.python.options)
    assert decided(tmp_path, {**files, "README.md": readme.replace("1.10.0", "1.2.0")}).python.bounds == ()


def test_a_project_that_asks_for_what_is_on_no_index(tmp_path: Path) -> None:
    files = {
        "gym/setup.py": "from setuptools import setup\nsetup(name='gym', install_requires=['isaacgym', 'rl', 'scipy'])",
        "rl/setup.py": "from setuptools import setup\nsetup(name='rl', install_requires=['torch'])\n",
        "requirements.txt": "sklearn\ntensorflow-gpu==2.5.0\ndataclasses; python_version < '3.7'\n",
    }
    decision = decided(tmp_path, files)
    assert decision.python.projects == ("rl", "gym"), "what another one needs comes first"
    assert decision.python.alone == ("gym",)
    assert set(lines(decision.python.pip)) == {
        "scikit-learn", "tensorflow-gpu==2.5.0", 'dataclasses; python_version < "3.7"', "scipy",
    }  # fmt: skip
    messages = [warning.message for warning in decision.warnings]
    assert any("isaacgym: it is behind a login" in message for message in messages)
    assert not {"isaacgym", "sklearn"} & set(lines(decision.pip))


def test_what_uv_takes_from_elsewhere(tmp_path: Path) -> None:
    root = """\
[project]
name = "policy"
version = "1"
dependencies = ["torch==2.7.1", "data", "policy-client"]
[tool.uv.sources]
data = { git = "https://example.org/lab/data", rev = "0cf8648" }
policy-client = { workspace = true }
[build-system]
requires = ["hatchling"]
build-backend = "hatchling.build"
"""
    client = '[project]\nname = "policy-client"\nversion = "1"\ndependencies = ["msgpack"]\n'
    decision = decided(tmp_path, {"pyproject.toml": root, "packages/client/pyproject.toml": client})
    assert decision.python.projects == ("packages/client", ".")
    assert decision.python.alone == (".",)
    assert lines(decision.python.pip) == ("torch==2.7.1", "data @ git+https://example.org/lab/data@0cf8648")


def test_a_copied_library_brings_no_ci_and_no_prose(tmp_path: Path) -> None:
    files = {"main.py": MAIN, "pybind11/docs/install.md": "```\npip install would be\n```\n"}
    files["lib/.github/workflows/ci.yml"] = "jobs:\n  a:\n    steps:\n      - run: sudo apt install intel-oneapi\n"
    decision = decided(tmp_path, files)
    assert lines(decision.pip) == ("torch",)
    assert "intel-oneapi" not in decision.apt_guessed


def test_condas_opencv_by_the_number_that_pip_has(tmp_path: Path) -> None:
    files = {"main.py": "import cv2\n", "README.md": "```\nconda install opencv=3.3.1\n```\n"}
    assert lines(decided(tmp_path, files).pip) == ("opencv-python==3.3.1.*",)


def test_one_build_of_a_package_for_the_cuda_of_the_image(tmp_path: Path) -> None:
    authored = "FROM nvidia/cuda:{}\nRUN pip install spconv-cu{}\n"
    files = {"main.py": MAIN, "requirements.txt": "torch==1.13.1+cu116\n"}
    files["docker/Dockerfile"] = authored.format("10.2-devel-ubuntu18.04", "102")
    files["docker/cu116.Dockerfile"] = authored.format("11.6.2-devel-ubuntu20.04", "116")
    assert lines(decided(tmp_path, files).python.pip_guessed) == ("spconv-cu116",)


def test_what_a_sentence_runs(tmp_path: Path) -> None:
    files = {"train.py": MAIN, "test.py": MAIN, "requirements.txt": "torch\n"}
    files["README.md"] = "## Usage\n- To train a new network : run `train.py`\n- To test it : run `test.py`\n"
    assert decided(tmp_path, files).command == ("python", "train.py")


def test_an_example_that_the_readme_runs_is_a_program(tmp_path: Path) -> None:
    files = {"examples/pid.py": MAIN, "examples/learn.py": MAIN, "requirements.txt": "numpy\n"}
    files["README.md"] = "## Use\n```sh\ncd examples/\npython3 pid.py # position\npython3 learn.py\n```\n"
    assert decided(tmp_path, files).command == ("python3", "examples/pid.py")


def test_a_section_about_somebody_elses_machines_comes_last(tmp_path: Path) -> None:
    files = {"cloud/launch.py": MAIN, "scripts/plan.py": MAIN, "requirements.txt": "torch\n"}
    files["README.md"] = (
        "## Running on Azure\n### Launching\n`python cloud/launch.py`\n"
        "## Planning\n```\npython scripts/plan.py --logs a/b\n```\n"
    )
    assert decided(tmp_path, files).command == ("python", "scripts/plan.py", "--logs", "a/b")


def test_examples_may_be_called_tests(tmp_path: Path) -> None:
    files = {"examples/test_robot.py": MAIN, "requirements.txt": "numpy\n"}
    files["README.md"] = "## Tutorial\n[robot](examples/test_robot.py) - ```$ python -m examples.test_robot```\n"
    assert decided(tmp_path, files).command == ("python", "-m", "examples.test_robot")


PIXI = """\
[workspace]
channels = ["conda-forge"]
platforms = ["linux-64"]
[tasks]
app = "FAST=1 python tools/app.py"
lint = { cmd = "ruff check", depends-on = ["app"] }
[dependencies]
python = "3.11.*"
numpy = "<2"
open3d = { version = ">=0.19, <0.20", channel = "conda-forge" }
[target.osx-arm64.dependencies]
clang = "*"
[pypi-dependencies]
rerun-sdk = ">=0.22"
torch = { version = "==2.4.1", index = "https://download.pytorch.org/whl/cu124" }
helper = { path = ".", editable = true }
"""


def test_a_manifest_of_pixi_is_an_environment(tmp_path: Path) -> None:
    found = decided(
        tmp_path, {"pixi.toml": PIXI, "tools/app.py": MAIN, "README.md": "## Demo\n```\npixi run app\n```\n"}
    )
    python = found.python
    assert (python.version, python.manager, python.conda_channels) == ("3.11", "conda", ("conda-forge",))
    assert python.conda_specs == ("python=3.11.*", "numpy<2", "open3d>=0.19,<0.20")
    assert [each.text for each in python.pip] == ["rerun-sdk>=0.22", "torch==2.4.1"]
    assert "--extra-index-url https://download.pytorch.org/whl/cu124" in python.options
    assert found.command == ("python", "tools/app.py")


def test_pixi_beside_a_project_counts_where_the_readme_uses_it(tmp_path: Path) -> None:
    text = "[project]\nname = 'a'\ndependencies = ['numpy']\n[build-system]\nrequires = ['setuptools']\n"
    text += (
        PIXI.replace("[workspace]", "[tool.pixi.workspace]")
        .replace("\n[", "\n[tool.pixi.")
        .replace("tool.pixi.tool.", "tool.")
    )
    files = {"pyproject.toml": text, "tools/app.py": MAIN}
    assert not decided(tmp_path / "a", {**files, "README.md": "`pip install a`\n"}).python.conda_file
    found = decided(tmp_path / "b", {**files, "README.md": "```\npixi run app\n```\n"}).python
    assert (found.conda_file, found.projects) == ("pyproject.toml", (".",))


@pytest.mark.parametrize(
    ("page", "module", "command"),
    [
        ("python -m demo.train", "src/demo/train.py", ("python", "-m", "demo.train")),
        ("python3 -m demo --fast", "python/lib/demo/__main__.py", ("python3", "-m", "demo", "--fast")),
        ("python -m demo.train", "third_party/demo/train.py", ("bash",)),
        ("python -m venv env", "tools/venv.py", ("bash",)),
        ("python -m demo.train", "demo/train.py", ("python", "-m", "demo.train")),
    ],
)
def test_a_module_of_a_package_that_pip_installs(
    tmp_path: Path, page: str, module: str, command: tuple[str, ...]
) -> None:
    setup = "from setuptools import setup\nsetup(name='demo', packages=['demo'], package_dir={'': 'src'})\n"
    page = f"# Usage\n```\n{page}\n```\n"
    decision = decided(tmp_path, {"setup.py": setup, module: "import numpy\n", "README.md": page})
    assert decision.command == command


def test_beside_a_list_at_the_root_an_examples_framework_is_no_sign_of_cuda(tmp_path: Path) -> None:
    examples = {"examples/net/requirements.txt": "tensorflow\n", "examples/net/run.py": "import tensorflow\n"}
    setup = "from setuptools import setup\nsetup(name='demo')\n"
    files = {"setup.py": setup, "demo/main.py": "import numpy\n", **examples}
    assert decided(tmp_path, files).kind == "cuda"
    assert decided(tmp_path, {**files, "requirements.txt": "numpy\n"}).kind == "python"


def test_a_file_of_tests_is_no_program_beside_another(tmp_path: Path) -> None:
    files = {"python/unit_tests.py": MAIN, "python/requirements.txt": "numpy\n"}
    assert decided(tmp_path, files).command == ("python3", "python/unit_tests.py")
    assert decided(tmp_path, {**files, "python/example.py": MAIN}).command == ("python3", "python/example.py")
    assert decided(tmp_path, {**files, "python/test.py": MAIN}).command == ("bash",)


def test_a_module_of_a_folder_that_a_page_goes_to(tmp_path: Path) -> None:
    page = "# Usage\n```\ncd code\npython -m tools.train --fast\n```\n"
    files = {"code/tools/train.py": "import numpy\n", "code/README.txt": "", "README.md": page}
    assert decided(tmp_path, files).command == "cd code && exec python -m tools.train --fast"


def test_a_folder_of_folders_named_like_a_package_is_not_that_package(tmp_path: Path) -> None:
    files = {"examples/gym/envs/__init__.py": "import gym\n", "main.py": MAIN.replace("torch", "gym, envs")}
    assert lines(decided(tmp_path, files).pip) == ("gym",)
    assert lines(decided(tmp_path, {**files, "examples/gym/__init__.py": ""}).pip) == ("gym",)
    assert lines(decided(tmp_path, {**files, "gym/__init__.py": ""}).pip) == ()


def test_names_of_which_the_index_has_no_release(tmp_path: Path) -> None:
    decision = decided(tmp_path, {"main.py": MAIN, "requirements.txt": "torch\nopencv\nPIL\n"})
    assert {"opencv-python", "Pillow"} <= set(lines(decision.python.pip))
    assert not {"opencv", "PIL"} & set(lines(decision.python.pip))
