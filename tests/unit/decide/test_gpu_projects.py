"""Projects whose setup.py stops without a GPU, and the Python part of a package that plain CMake builds."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision
from roslab.evidence.python.needs_gpu import needs_gpu

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
