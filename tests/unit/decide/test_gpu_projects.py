"""Projects whose setup.py stops without a GPU, and the Python part of a package that plain CMake builds."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

from roslab.decide.decision import Decision
from roslab.evidence.python.needs_gpu import needs_gpu
from roslab.pipeline import plan_repository
from roslab.render import image_scripts
from roslab.render.dockerfile import dockerfile

Tree = Callable[[dict[str, str]], Decision]
SETUP = "import torch\nfrom setuptools import setup\n{check}\nsetup(name='ops', packages=['ops'])\n"
RAISES = "if not torch.cuda.is_available():\n    raise RuntimeError('no GPU')"
XML = (
    "<package format='3'><name>{name}</name><depend>rclcpp</depend>"
    "<export><build_type>{build_type}</build_type></export></package>"
)
PYPROJECT = '[project]\nname = "net"\nversion = "1"\ndependencies = ["einops"]\n'


@pytest.mark.parametrize(
    ("check", "stops"),
    [
        (RAISES, True),
        ("assert torch.cuda.is_available()", True),
        ("if torch.cuda.is_available() and HOME:\n    x = 1\nelse:\n    raise NotImplementedError('no CUDA')", True),
        ("if not torch.cuda.is_available() and not FORCED:\n    raise RuntimeError('no GPU')", False),
        ("if torch.cuda.is_available() or FORCED:\n    x = 1\nelse:\n    raise RuntimeError('no GPU')", False),
        ("if not torch.cuda.is_available():\n    print('for the CPU')", False),
        ("if torch.cuda.is_available():\n    x = 1\nelse:\n    x = 2", False),
    ],
)
def test_what_stops_without_a_gpu(check: str, stops: bool) -> None:
    assert needs_gpu(SETUP.format(check=check)) is stops


ASKS_MORE = RAISES + "\nMAJOR = torch.cuda.get_device_capability()[0]"
OPS = {
    "run.py": "import MultiScale\n\nif __name__ == '__main__':\n    print(MultiScale)\n",
    "requirements.txt": "torch==1.13.1\n",
    "ops/ops/__init__.py": "",
    "ops/make.sh": "python setup.py build install\n",
}
EXTENSION = "from torch.utils.cpp_extension import CUDAExtension\nPARTS = [CUDAExtension('MultiScale', ['a.cu'])]\n"


@pytest.mark.parametrize(
    ("page", "projects", "line"),
    [
        ("pip install -e ops", ("ops",), '$(with-gpu-said)${PYTHONPATH:+:${PYTHONPATH}}" python3 -m pip install '),
        ("cd ops\nsh make.sh", (), "{ with-gpu-said bash make.sh || echo "),
    ],
)
def test_what_only_asks_for_a_gpu_is_told_that_there_is_one(
    tmp_path: Path, page: str, projects: tuple[str, ...], line: str
) -> None:
    files = {**OPS, "ops/setup.py": EXTENSION + SETUP.format(check=RAISES), "README.md": f"```\n{page}\n```\n"}
    for path, text in files.items():
        (tmp_path / path).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / path).write_text(text)
    plan = plan_repository(tmp_path).plan
    assert (plan.kind, plan.workspace.python_projects, plan.python.gpu_asked) == ("cuda", projects, ("ops",))
    assert line in dockerfile(plan)
    assert "COPY --from=scripts /with-gpu-said /usr/local/bin/" in dockerfile(plan)
    assert not any("no GPU" in each.message for each in plan.warnings)


@pytest.mark.parametrize(
    ("page", "config"),
    [
        ("# Build in docker\n```\ncd ops\nsh make.sh\n```\n```\npip install -e ops\n```\n", ""),
        ("# Run\n```\ncd ops\nsh make.sh\n```\n", "format: 3\ncustom: |\n  echo more\n"),
    ],
)
def test_a_project_whose_script_the_image_does_not_run_is_installed(tmp_path: Path, page: str, config: str) -> None:
    files = {**OPS, "ops/setup.py": EXTENSION + SETUP.format(check=RAISES), "README.md": page}
    for path, text in {**files, **({"roslab.yaml": config} if config else {})}.items():
        (tmp_path / path).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / path).write_text(text)
    plan = plan_repository(tmp_path).plan
    assert plan.workspace.python_projects == ("ops",)
    assert "make.sh" not in dockerfile(plan)


def test_what_asks_for_more_is_left_out(tree: Tree) -> None:
    decided = tree(
        {**OPS, "ops/setup.py": EXTENSION + SETUP.format(check=ASKS_MORE), "README.md": "pip install ./ops\n"}
    )
    assert (decided.python.projects, decided.python.gpu_asked) == ((), ())
    assert any(each.message.startswith("ops is not installed") for each in decided.warnings)


def test_torch_says_that_there_is_a_gpu(tmp_path: Path) -> None:
    for path in ("torch/__init__.py", "torch/cuda/__init__.py"):
        (tmp_path / path).parent.mkdir(parents=True, exist_ok=True)
    (tmp_path / "torch/__init__.py").write_text("from torch import cuda\n")
    (tmp_path / "torch/cuda/__init__.py").write_text("def is_available():\n    return False\n")
    ask = [sys.executable, "-c", "import torch; print(torch.cuda.is_available())"]
    script = Path(image_scripts.__path__[0]) / "with-gpu-said.sh"
    surroundings = {**os.environ, "PYTHONPATH": str(tmp_path)}
    for before, said in (((), "False"), (("bash", str(script)), "True")):
        done = subprocess.run([*before, *ask], env=surroundings, capture_output=True, text=True, check=True)
        assert done.stdout.strip() == said
    called = f'python() {{ "{sys.executable}" "$@"; }}; PYTHONPATH="$(bash {script}):{tmp_path}" python -c "{ask[-1]}"'
    done = subprocess.run(["bash", "-c", called], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "True"
    failed = subprocess.run(["bash", str(script), "sh", "-c", "exit 7"], env=surroundings, check=False)
    assert failed.returncode == 7


def test_a_part_that_needs_a_gpu_does_not_stop_the_build(tree: Tree) -> None:
    files = {
        "nodes/package.xml": XML.format(name="nodes", build_type="ament_cmake"),
        "nodes/CMakeLists.txt": "find_package(ament_cmake REQUIRED)\nament_package()\n",
        "extras/ops/setup.py": SETUP.format(check=RAISES),
        "extras/ops/ops/__init__.py": "",
        "README.md": "pip install ./extras/ops\n",
    }
    decided = tree(files)
    assert decided.python.projects == ()
    (told,) = [each.message for each in decided.warnings if "no GPU" in each.message]
    assert told.startswith("extras/ops is not installed")


def test_the_project_at_the_root_is_kept(tree: Tree) -> None:
    decided = tree({"setup.py": SETUP.format(check=RAISES), "ops/__init__.py": ""})
    assert decided.python.projects == (".",)
    assert any("may stop the build" in each.message for each in decided.warnings)


@pytest.mark.parametrize("page", ["pip install ./net\n", ""])
@pytest.mark.parametrize(("build_type", "projects"), [("cmake", ("net",)), ("ament_cmake", ())])
def test_pip_installs_the_python_part_of_a_package_of_plain_cmake(
    tree: Tree, build_type: str, projects: tuple[str, ...], page: str
) -> None:
    files = {
        "nodes/package.xml": XML.format(name="nodes", build_type="ament_cmake"),
        "nodes/CMakeLists.txt": "find_package(ament_cmake REQUIRED)\nament_package()\n",
        "net/package.xml": XML.format(name="net", build_type=build_type),
        "net/CMakeLists.txt": "cmake_minimum_required(VERSION 3.10)\nproject(net)\n",
        "net/pyproject.toml": PYPROJECT,
        "net/net/__init__.py": "",
        "docs/usage.md": f"```\n{page}```\n",
    }
    assert tree(files).python.projects == projects


def test_what_its_cmake_may_compile_is_not_compiled_again(tree: Tree) -> None:
    files = {
        "nodes/package.xml": XML.format(name="nodes", build_type="ament_cmake"),
        "nodes/CMakeLists.txt": "find_package(ament_cmake REQUIRED)\nament_package()\n",
        "net/package.xml": XML.format(name="net", build_type="cmake"),
        "net/CMakeLists.txt": "cmake_minimum_required(VERSION 3.10)\nproject(net)\n",
        "net/pyproject.toml": f'{PYPROJECT}[build-system]\nrequires = ["scikit-build-core"]\n',
        "net/net/__init__.py": "",
    }
    assert tree(files).python.projects == ()
