"""A library that a page has every reader build, and that nothing in the code asks for by name."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from roslab.decide.decision import Decision
from roslab.pipeline import plan_repository
from roslab.render.dockerfile import dockerfile

Tree = Callable[[dict[str, str]], Decision]
PACKAGE = "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend></package>"
MADE = "project(demo)\nfind_package(catkin REQUIRED)\n"
BUILD = """\
git clone https://github.com/lab/odd_icp.git
cd odd_icp
mkdir build && cd build
cmake .. -DWITH_MP=ON && make -j
sudo make install
```
"""


def page(before: str = "- Install [odd_icp](https://github.com/lab/odd_icp):\n", build: str = BUILD) -> dict[str, str]:
    text = f"# Demo\nROS Noetic\n\n## Installation\n{before}\n```bash\n{build}"
    return {"package.xml": PACKAGE, "CMakeLists.txt": MADE, "README.md": text}


def built(decision: Decision) -> list[tuple[str, str, bool]]:
    return [(source.name, source.cmake_options, source.unasked) for source in decision.source]


def test_it_is_built_and_told(tree: Tree) -> None:
    decision = tree(page())
    assert built(decision) == [("odd_icp", "-DWITH_MP=ON", True)]
    (told,) = [warning.message for warning in decision.warnings if "odd_icp" in warning.message]
    assert told.startswith("https://github.com/lab/odd_icp.git is built because README.md has everybody build it")


def test_its_failure_stops_nothing(tmp_path: Path) -> None:
    for path, text in page().items():
        (tmp_path / path).write_text(text)
    text = dockerfile(plan_repository(tmp_path).plan)
    stage = text[text.index("AS library-1-odd-icp") :]
    assert "|| { rm -rf /installed; echo 'roslab: left out: odd_icp cannot be built" in stage
    (tmp_path / "CMakeLists.txt").write_text(MADE + "find_package(odd_icp REQUIRED)\n")
    assert "left out: odd_icp" not in dockerfile(plan_repository(tmp_path).plan)


@pytest.mark.parametrize(
    "before",
    [
        "odd_icp is optional:\n",
        "(Optional) Install odd_icp:\n",
        "If you want to look at the result, install its viewer:\n",
        "### Docker\n",
        "### Evaluation\n",
        "- odd_icp (可选)\n",
    ],
)
def test_what_not_everybody_needs_is_left_out(tree: Tree, before: str) -> None:
    assert built(tree(page(before))) == []


def test_a_sentence_of_the_item_before_counts_for_that_one_alone(tree: Tree) -> None:
    assert built(tree(page("- A viewer (optional)\n- Install odd_icp:\n"))) != []


@pytest.mark.parametrize(
    "build",
    [
        BUILD.replace("odd_icp", "eigen"),
        BUILD.replace("odd_icp", "ceres-solver"),
        BUILD.replace("odd_icp", "CMake"),
        BUILD.replace("odd_icp", "octomap"),
        BUILD.replace("sudo make install\n", ""),
        BUILD.replace("cmake .. -DWITH_MP=ON", "../configure"),
        BUILD.replace("odd_icp", "demo"),
    ],
)
def test_what_has_a_package_or_is_not_installed_by_cmake(tree: Tree, build: str) -> None:
    assert built(tree(page(build=build))) == []


def test_headers_may_lie_in_a_folder_without_the_lib_at_the_name_s_end(tree: Tree) -> None:
    files = {**page("", BUILD.replace("odd_icp", "sddlib")), "src/a.cpp": "#include <sdd/setoper.h>\n"}
    files["CMakeLists.txt"] = f"{MADE}add_executable(a src/a.cpp)\n"
    assert built(tree(files)) == [("sddlib", "-DWITH_MP=ON", False)], "the code asks for it"
    other = files | {"src/a.cpp": "#include <odd/setoper.h>\n"}
    assert built(tree(other)) == [("sddlib", "-DWITH_MP=ON", True)]


@pytest.mark.parametrize("asked", ["find_package(odd_icp QUIET)\n", "if(X)\nfind_package(odd_icp REQUIRED)\nendif()\n"])
def test_what_cmake_only_tries_is_optional(tree: Tree, asked: str) -> None:
    assert built(tree(page() | {"CMakeLists.txt": MADE + asked})) == []


def test_a_page_below_is_about_a_part(tree: Tree) -> None:
    files = page()
    assert built(tree({**files, "tools/README.md": files["README.md"], "README.md": "ROS Noetic\n"})) == []


@pytest.mark.parametrize(
    ("code", "names"),
    [
        ("#include <g2o/core/base_vertex.h>\n", [("g2o", False)]),
        ("#include <vector>\n", []),
        ('#include "own/core/base_vertex.h"\n', []),
    ],
)
def test_what_the_distribution_has_too_is_built_for_its_headers(
    tree: Tree, code: str, names: list[tuple[str, bool]]
) -> None:
    build = BUILD.replace("lab/odd_icp", "RainerKuemmerle/g2o").replace("odd_icp", "g2o")
    files = {**page("", build), "cmake/g2o.cmake": "find_path(G2O_INCLUDE_DIR g2o/core/base_vertex.h)\n"}
    files |= {"CMakeLists.txt": f"{MADE}include(cmake/g2o.cmake)\nadd_executable(a src/a.cpp)\n", "src/a.cpp": code}
    assert [(source.name, source.unasked) for source in tree(files).source] == names
