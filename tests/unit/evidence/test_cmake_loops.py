"""Programs that CMake makes in loops: one in each round."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.config.model import Config
from roslab.decide import decide
from roslab.evidence.gather import gather
from roslab.evidence.native import cmake
from roslab.repository.checkout import Repository

BOTH = "foreach(x a b)\nadd_executable(${x} m.cpp)\nendforeach()\n"
OF_FILES = (
    "foreach(f src/a.cpp src/b.cpp)\nget_filename_component(name ${f} NAME_WE)\nset(exe run_${name})\n"
    "add_executable(${exe} ${f})\nendforeach()\n"
)


def programs(root: Path, text: str) -> list[str]:
    (root / "CMakeLists.txt").write_text(f"project(demo)\n{text}")
    (project,) = cmake.read(Repository.open(root))
    return [name for name, _ in project.executables]


@pytest.mark.parametrize(
    ("text", "names"),
    [
        ("foreach(x a b)\nadd_executable(${x} ${x}.cpp)\nendforeach()\n", ["a", "b"]),
        ("set(ALL a b)\nforeach(x ${ALL})\nadd_executable(${x}_node ${x}.cpp)\nendforeach()\n", ["a_node", "b_node"]),
        ("set(ALL a;b)\nforeach(x IN LISTS ALL)\nadd_executable(${x} ${x}.cpp)\nendforeach()\n", ["a", "b"]),
        ("set(M a b)\nforeach(x IN LISTS M ITEMS c)\nadd_executable(${x} x.cpp)\nendforeach()\n", ["a", "b", "c"]),
        ("foreach(i RANGE 1 3)\nadd_executable(part${i} ${i}.cpp)\nendforeach()\n", ["part1", "part2", "part3"]),
        ("foreach(i RANGE 1)\nadd_executable(part${i} ${i}.cpp)\nendforeach()\n", ["part0", "part1"]),
        (OF_FILES, ["run_a", "run_b"]),
        (
            "foreach(x a b)\nforeach(y 1 2)\nadd_executable(${x}${y} m.cpp)\nendforeach()\nendforeach()\n",
            ["a1", "a2", "b1", "b2"],
        ),
        ("foreach(x a b)\nadd_executable(one one.cpp)\nendforeach()\nadd_executable(two two.cpp)\n", ["one", "two"]),
        ("foreach(x IN ZIP_LISTS A B)\nadd_executable(${x_0} m.cpp)\nendforeach()\n", []),
        ("foreach(x ${UNKNOWN})\nadd_executable(${x} ${x}.cpp)\nendforeach()\n", []),
    ],
)
def test_each_round_makes_its_own(tmp_path: Path, text: str, names: list[str]) -> None:
    assert programs(tmp_path, text) == names


def test_loops_in_loops_end(tmp_path: Path) -> None:
    values = " ".join(f"v{i}" for i in range(150))
    loops = "".join(f"foreach(x{i} {values})\n" for i in range(6))
    text = f"{loops}add_executable(a${{x0}}${{x5}} m.cpp)\n" + "endforeach()\n" * 6
    assert 0 < len(programs(tmp_path, text)) <= 200


def test_the_files_and_libraries_of_each_round(tmp_path: Path) -> None:
    text = (
        "foreach(x a b)\nadd_library(${x} ${x}.cpp)\nadd_executable(run_${x} m.cpp)\n"
        "set_target_properties(run_${x} PROPERTIES OUTPUT_NAME start_${x})\nendforeach()\n"
    )
    assert programs(tmp_path, text) == ["start_a", "start_b"]
    (project,) = cmake.read(Repository.open(tmp_path))
    assert project.made == ("a", "b")


def test_none_of_several_is_the_only_one(tmp_path: Path) -> None:
    files = {
        "CMakeLists.txt": f"project(d)\n{BOTH}add_executable(z m.cpp)\n",
        "m.cpp": "int main() {}\n",
    }
    for name, text in files.items():
        (tmp_path / name).write_text(text)
    decision = decide(gather(Repository.open(tmp_path)), Config(), folder_name="demo")
    assert list(decision.command_candidates) == [("a",), ("b",), ("z",)]


@pytest.mark.parametrize(("page", "names"), [("./bin/link_test", ["a", "link_test"]), ("make link_test", ["a"])])
def test_a_program_that_a_page_runs_is_none_of_the_tests(tmp_path: Path, page: str, names: list[str]) -> None:
    files = {
        "CMakeLists.txt": "project(d)\nadd_executable(a m.cpp)\nadd_executable(link_test t.cpp)\n",
        "m.cpp": "int main() {}\n",
        "t.cpp": "int main() {}\n",
        "README.md": f"# Demo\n\n## Usage\n```\n{page}\n```\n",
    }
    for name, text in files.items():
        (tmp_path / name).write_text(text)
    decision = decide(gather(Repository.open(tmp_path)), Config(), folder_name="demo")
    assert sorted(argv[0] for argv in decision.command_candidates) == names
