"""Projects of CMake beside the one that is built, which it never adds."""

from __future__ import annotations

import time
from collections.abc import Callable
from pathlib import Path

import pytest

from roslab.decide.decision import Decision
from roslab.decide.system.unreached import unreached
from roslab.evidence.gather import gather
from roslab.repository.checkout import Repository

Tree = Callable[[dict[str, str]], Decision]
TOP = "cmake_minimum_required(VERSION 3.10)\nproject(demo CXX)\nadd_executable(demo main.cpp)\n{}"
OTHER = (
    "cmake_minimum_required(VERSION 3.10)\nproject(other CXX)\nfind_package({} REQUIRED)\nadd_executable(other b.cpp)\n"
)
FILES = {"main.cpp": "int main() {}\n", "src/other/b.cpp": "int main() {}\n"}


@pytest.mark.parametrize(
    ("rest", "page", "needed"),
    [
        ("", "", False),
        ("add_subdirectory(src/other)\n", "", True),
        ("option(OTHER o OFF)\nif(OTHER)\nadd_subdirectory(src/other)\nendif()\n", "cmake -DOTHER=ON ..", True),
        ("foreach(part ${PARTS})\nadd_subdirectory(src/${part})\nendforeach()\n", "", True),
        ("add_subdirectory(src/${PART})\n", "", True),
        ("add_subdirectory(lib/${PART})\n", "", False),
        ("", "cd src/other\nmkdir build && cd build\ncmake ..\nmake", True),
        ("", "cd src/else\nmkdir build && cd build\ncmake ..\nmake", False),
    ],
)
def test_what_is_never_added_needs_nothing(tree: Tree, rest: str, page: str, *, needed: bool) -> None:
    made = {"CMakeLists.txt": TOP.format(rest), "src/other/CMakeLists.txt": OTHER.format("GSL")}
    decision = tree({**FILES, **made, "README.md": f"# Build\n```\nmkdir build && cd build\n{page}\n```\n"})
    assert ("libgsl-dev" in {*decision.apt, *decision.apt_guessed}) is needed


@pytest.mark.parametrize(
    ("rest", "page", "built"),
    [
        ("", "", []),
        ("", "cd src/other\nmkdir build && cd build\ncmake ..\nmake", []),
        ("add_subdirectory(src/other)\n", "", ["libtorch"]),
    ],
)
def test_libtorch_is_fetched_for_nothing_that_is_not_built(tree: Tree, rest: str, page: str, built: list[str]) -> None:
    made = {"CMakeLists.txt": TOP.format(rest), "src/other/CMakeLists.txt": OTHER.format("Torch")}
    decision = tree({**FILES, **made, "README.md": f"# Build\n```\n{page}\n```\n"})
    assert [each.name for each in decision.source] == built


@pytest.mark.parametrize(("root", "needed"), [("", True), ("pyproject.toml", False)])
def test_what_pip_compiles_needs_its_own(tree: Tree, root: str, *, needed: bool) -> None:
    build = '[build-system]\nrequires = ["scikit-build-core"]\nbuild-backend = "scikit_build_core.build"\n'
    made = {"CMakeLists.txt": TOP.format(""), "src/other/CMakeLists.txt": OTHER.format("GSL")}
    made["src/other/pyproject.toml"] = f'{build}[project]\nname = "other"\nversion = "1"\n'
    if root:
        made[root] = f'{build}[project]\nname = "demo"\nversion = "1"\n'
    decision = tree({**FILES, **made})
    assert ("libgsl-dev" in {*decision.apt, *decision.apt_guessed}) is needed


def test_thousands_of_projects_that_a_page_compiles_cost_little(tmp_path: Path) -> None:
    made, page = {"CMakeLists.txt": TOP.format("")}, ""
    for number in range(1500):
        made[f"src/part{number}/CMakeLists.txt"] = OTHER.format("GSL")
        page += f"```\ncd src/part{number}\nmkdir build && cd build\ncmake ..\nmake\n```\n"
    for path, text in {**FILES, **made, "README.md": f"# Build\n{page}"}.items():
        target = tmp_path / path
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text(text, encoding="utf-8")
    evidence = gather(Repository.open(tmp_path))
    before = time.process_time()
    found = [unreached(evidence) for _ in range(9)]
    assert time.process_time() - before < 2
    assert "src/part0/CMakeLists.txt" not in found[0]


@pytest.mark.parametrize(
    "package", ["", "<package><name>demo</name><buildtool_depend>cmake</buildtool_depend></package>"]
)
@pytest.mark.parametrize(("adds", "needed"), [("", False), ("add_subdirectory(examples/own)\n", True)])
def test_what_tests_of_a_project_ask_for_that_the_built_one_does_not_add(
    tree: Tree, package: str, adds: str, needed: bool
) -> None:
    files = {
        "CMakeLists.txt": f"cmake_minimum_required(VERSION 3.10)\nproject(demo)\nadd_subdirectory(src)\n{adds}",
        "src/CMakeLists.txt": "add_executable(demo demo.cpp)\n",
        "src/demo.cpp": "int main() { return 0; }\n",
        "examples/own/CMakeLists.txt": "cmake_minimum_required(VERSION 3.10)\nproject(own)\nadd_subdirectory(test)\n",
        "examples/own/test/CMakeLists.txt": "find_package(Boost REQUIRED COMPONENTS system)\nadd_executable(t t.cpp)\n",
        "examples/own/test/t.cpp": "int main() { return 0; }\n",
    }
    decision = tree(files | ({"package.xml": package} if package else {}))
    assert ("libboost-all-dev" in decision.apt) is needed


@pytest.mark.parametrize(("folder", "needed"), [("include/solver", False), ("src/solver", True)])
def test_the_page_of_a_library_among_the_headers_compiles_nothing_here(
    tree: Tree, folder: str, *, needed: bool
) -> None:
    lists = f"{OTHER.format('GSL')}enable_testing()\nadd_test(NAME b COMMAND other)\n"
    made = {"CMakeLists.txt": TOP.format(""), f"{folder}/CMakeLists.txt": lists, f"{folder}/b.cpp": "int main() {}\n"}
    page = "# Install\n```\nmkdir build && cd build\ncmake ..\nmake install\n```\n"
    decision = tree({**FILES, **made, f"{folder}/README.md": page, "README.md": "# Demo\n"})
    assert ("libgsl-dev" in {*decision.apt, *decision.apt_guessed}, decision.ctest) == (needed, needed)
