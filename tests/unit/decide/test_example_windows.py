"""A compiled example that is the command opens its window; one that is not started asks for none."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
SHOWS = '#include <opencv2/highgui.hpp>\nint main() { cv::imshow("a", b); }\n'
CMAKE = "project(demo)\nfind_package(OpenCV REQUIRED)\nadd_executable({name} {file})\n"


@pytest.mark.parametrize(
    ("name", "file", "gui"), [("kitti", "examples/kitti.cpp", True), ("run", "src/run.cpp", False)]
)
def test_the_window_of_an_example(tree: Tree, name: str, file: str, *, gui: bool) -> None:
    files = {"CMakeLists.txt": CMAKE.format(name=name, file=file), "examples/kitti.cpp": SHOWS}
    decision = tree({"README.md": f"# Demo\n```\n./{name}\n```\n", file: SHOWS if gui else "int main() {}\n", **files})
    assert decision.gui is gui
