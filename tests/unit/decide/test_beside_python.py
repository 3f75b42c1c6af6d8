"""C++ in a folder beside Python's code is compiled where a page has CMake compile it."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
CMAKE = "cmake_minimum_required(VERSION 3.5)\nproject(ranges)\n{}add_executable(ranges ranges.cpp)\n"
FILES = {"train.py": "import torch\n", "requirements.txt": "torch==1.13.1\n", "ranges/ranges.cpp": "int main() {}\n"}
BUILD = "mkdir build && cd build\ncmake ..\nmake\n"


def compiled(decision: Decision) -> list[str]:
    return [each.folder for each in decision.scripts]


@pytest.mark.parametrize(
    ("page", "text"),
    [
        ("README.md", f"```\ncd ranges\n{BUILD}```\n"),
        ("README.md", f"```\ngit clone https://github.com/lab/demo.git\ncd demo/ranges\n{BUILD}```\n"),
        ("ranges/README.md", f"```\n{BUILD}```\n"),
        ("ranges/README.md", f"```\ncd ranges\n{BUILD}```\n"),
    ],
)
def test_what_the_page_compiles_is_compiled(tree: Tree, page: str, text: str) -> None:
    decision = tree({**FILES, "ranges/CMakeLists.txt": CMAKE.format("find_package(OpenCV REQUIRED)\n"), page: text})
    assert decision.kind in {"python", "cuda"}
    assert compiled(decision) == ["ranges"]
    assert "libopencv-dev" in decision.apt_guessed


@pytest.mark.parametrize(
    ("asked", "page"),
    [
        ("", "Only Python.\n"),
        ("", f"## Optional: C++\n```\ncd ranges\n{BUILD}```\n"),
        ("find_package(NobodyKnows REQUIRED)\n", f"```\ncd ranges\n{BUILD}```\n"),
        ("find_package(Pangolin REQUIRED)\n", f"```\ncd ranges\n{BUILD}```\n"),  # no package has it
        ("find_package(catkin REQUIRED)\ncatkin_package()\n", f"```\ncd ranges\n{BUILD}```\n"),
        ("", f"```\ngit clone https://github.com/lab/other.git\ncd other\n{BUILD}```\n"),
    ],
)
def test_the_rest_is_left_alone(tree: Tree, asked: str, page: str) -> None:
    assert compiled(tree({**FILES, "ranges/CMakeLists.txt": CMAKE.format(asked), "README.md": page})) == []


@pytest.mark.parametrize(
    ("asked", "heading", "told"),
    [
        ("find_package(Pangolin REQUIRED)\n", "Setup", True),
        ("find_package(Pangolin REQUIRED)\n", "Optional", False),
        ("find_package(OpenCV REQUIRED)\n", "Setup", False),
    ],
)
def test_what_is_not_compiled_is_told(tree: Tree, asked: str, heading: str, told: bool) -> None:
    page = f"## {heading}\n```\ncd ranges\n{BUILD}```\n"
    decision = tree({**FILES, "ranges/CMakeLists.txt": CMAKE.format(asked), "README.md": page})
    assert any("compile ranges" in each.message and "Pangolin" in each.message for each in decision.warnings) is told


@pytest.mark.parametrize(("asked", "left"), [("find_package(OpenCV REQUIRED)\n", True), ("", False)])
def test_a_copy_gets_no_packages_for_itself(tree: Tree, asked: str, left: bool) -> None:
    page = f"## Setup\n```\ncd external/ranges\n{BUILD}```\n"
    files = {f"external/{name}" if "/" in name else name: text for name, text in FILES.items()}
    decision = tree({**files, "external/ranges/CMakeLists.txt": CMAKE.format(asked), "README.md": page})
    assert compiled(decision) == ([] if left else ["external/ranges"])
    assert any("compile external/ranges" in each.message for each in decision.warnings) is left


def test_the_page_of_a_copy_is_for_its_own_readers(tree: Tree) -> None:
    files = {"external/ranges/CMakeLists.txt": CMAKE.format(""), "external/ranges/ranges.cpp": "int main() {}\n"}
    page = f"# Ranges\n## Install\n```\n{BUILD}```\n"
    decision = tree({**FILES, **files, "external/ranges/README.md": page})
    assert (compiled(decision), decision.warnings) == ([], ())


def test_the_options_of_the_page_are_given(tree: Tree) -> None:
    page = f"```\ncd ranges\n{BUILD}```\n".replace("cmake", "cmake -DWITH_VIEW=OFF -DPYTHON_EXECUTABLE=/opt/python")
    decision = tree({**FILES, "ranges/CMakeLists.txt": CMAKE.format(""), "README.md": page})
    assert "cmake -DCMAKE_BUILD_TYPE=Release -DWITH_VIEW=OFF .. &&" in decision.scripts[0].command


def test_pip_compiles_what_setup_py_does(tree: Tree) -> None:
    setup = (
        "from setuptools import Extension, setup\nfrom setuptools.command.build_ext import build_ext\n\n\n"
        "class CMakeExtension(Extension):\n    pass\n\n\n"
        "setup(name='ranges', ext_modules=[CMakeExtension('ranges')], cmdclass={'build_ext': build_ext})\n"
    )
    page = f"```\npip install ./ranges\ncd ranges\n{BUILD}```\n"
    files = {"ranges/CMakeLists.txt": CMAKE.format(""), "ranges/setup.py": setup, "README.md": page}
    assert compiled(tree({**FILES, **files})) == []


ROOT = {
    "CMakeLists.txt": CMAKE.format("find_package(Eigen3 REQUIRED)\n"),
    "ranges.cpp": "#include <Eigen/Core>\nint main() {}\n",
    "scripts/train.py": "import numpy\n\nif __name__ == '__main__':\n    print(numpy.pi)\n",
    "environment.yml": "name: ranges\ndependencies:\n  - python=3.9\n  - numpy\n",
}
RUN = "```\npython scripts/train.py\n```\n"


@pytest.mark.parametrize(
    ("more", "page", "folders"),
    [
        ({}, f"```\nconda env create -f environment.yml\n{BUILD}```\n", [""]),
        ({}, f"```\ngit clone https://github.com/lab/ranges.git\ncd ranges\n{BUILD}```\n", [""]),
        ({}, "```\nconda env create -f environment.yml\n```\n", []),
        ({}, f"## Optional: C++\n```\n{BUILD}```\n", []),
        ({}, f"```\ngit clone https://github.com/lab/other.git\ncd other\n{BUILD}```\n", []),
        ({"setup.py": "from setuptools import setup\nsetup(name='ranges')\n"}, f"```\n{BUILD}```\n", []),
        ({"CMakeLists.txt": CMAKE.format("find_package(NobodyKnows REQUIRED)\n")}, f"```\n{BUILD}```\n", []),
        ({"thirdparty/x/CMakeLists.txt": "find_package(NobodyKnows REQUIRED)\n"}, f"```\n{BUILD}```\n", [""]),
    ],
)
def test_the_project_at_the_root_beside_an_environment(
    tree: Tree, more: dict[str, str], page: str, folders: list[str]
) -> None:
    decision = tree({**ROOT, **more, "README.md": f"# Ranges\n\n{page}\n{RUN}"})
    assert decision.kind == "python"
    assert compiled(decision) == folders
    assert not folders or "libeigen3-dev" in decision.apt_guessed
