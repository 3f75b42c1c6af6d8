"""What the README runs comes before what other pages do, and a reason names the page that it speaks of."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
CODE = {"a.py": "import numpy\n", "b.py": "import numpy\n", "requirements.txt": "numpy\n"}
RUNS = "# {title}\n\n```\npython {file}\n```\n"


def reason(decision: Decision) -> tuple[object, str, str | None, int | None]:
    """Return the command with why and where."""
    said = next(each for each in decision.reasons if each.question == "command" and each.decisive)
    return decision.command, said.reason, said.file, said.line


@pytest.mark.parametrize(
    ("page", "why"),
    [
        ("INSTALL.md", "the README runs it, before 1 other"),
        ("GETTING_STARTED.md", "the README runs it, before 1 other"),
        ("docs/SETUP.md", "the README runs it; 1 other was found beside it"),
    ],
)
def test_the_readme_comes_first(tree: Tree, page: str, why: str) -> None:
    files = {"README.md": RUNS.format(title="Demo", file="a.py"), page: RUNS.format(title="Usage", file="b.py")}
    assert reason(tree({**CODE, **files})) == (("python", "a.py"), why, "README.md", 4)


@pytest.mark.parametrize("page", ["INSTALL.md", "USAGE.md", "docs/SETUP.md"])
def test_another_page_has_its_name(tree: Tree, page: str) -> None:
    found = reason(tree({**CODE, "README.md": "# Demo\n", page: RUNS.format(title="Usage", file="b.py")}))
    assert found == (("python", "b.py"), f"the only one: {page} runs it", page, 4)


def test_a_page_in_another_language_has_its_name_too(tree: Tree) -> None:
    found = reason(tree({**CODE, "README_CN.md": RUNS.format(title="Usage", file="b.py")}))
    assert found[1:] == ("the only one: README_CN.md runs it", "README_CN.md", 4)


def test_what_both_run_is_the_readmes(tree: Tree) -> None:
    pages = {"README.md": RUNS.format(title="Demo", file="a.py"), "INSTALL.md": RUNS.format(title="Run", file="a.py")}
    assert reason(tree({**CODE, **pages}))[1:] == ("the only one: the README runs it", "README.md", 4)


def test_what_the_readme_only_evaluates_with_comes_after_what_another_page_runs(tree: Tree) -> None:
    pages = {
        "README.md": RUNS.format(title="Demo", file="plot_a.py"),
        "USAGE.md": RUNS.format(title="Run", file="b.py"),
    }
    assert reason(tree({**CODE, "plot_a.py": "import numpy\n", **pages}))[0] == ("python", "b.py")


@pytest.mark.parametrize(("page", "named"), [("README.md", "the README"), ("INSTALL.md", "INSTALL.md")])
def test_the_page_that_builds_with_cmake_has_its_name(tree: Tree, page: str, named: str) -> None:
    build = "# Build\n\n```\nmkdir build && cd build\ncmake ..\nmake\n```\n"
    files = {
        "CMakeLists.txt": "project(demo CXX)\nadd_executable(demo a.cc)\n",
        "a.cc": "#include <Eigen/Core>\nint main() {}\n",
        page: build,
    }
    said = [each.reason for each in tree(files).reasons if each.question == "kind"]
    assert f"a CMake project, which {named} builds with CMake alone" in said
