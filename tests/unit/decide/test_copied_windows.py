"""A library of windows opens them where it is copied into the tree, too, and where only its calls show it."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
CMAKE = "project(demo)\nadd_executable(demo src/main.cpp)\n"
HEADER = "pangolin/display/display.h"


@pytest.mark.parametrize(
    ("code", "copy", "gui"),
    [
        (f"#include <{HEADER}>\n", f"thirdparty/pangolin/include/{HEADER}", True),
        (f"#include <{HEADER}>\n", f"include/{HEADER}", False),  # the library itself
        ("#include <SDL3/SDL.h>\n", "README.md", True),
        ('#include "view.h"\nvoid show() { cv::namedWindow("a"); }\n', "src/view.h", True),
        ('#include "view.h"\nint read() { return cv::waitKey(1); }\n', "src/view.h", True),
        ("void waitKey();\n// cv::waitKey(1)\n", "README.md", False),
    ],
)
def test_windows(tree: Tree, code: str, copy: str, *, gui: bool) -> None:
    decision = tree({"CMakeLists.txt": CMAKE, "src/main.cpp": code + "int main() {}\n", copy: ""})
    assert decision.gui is gui
