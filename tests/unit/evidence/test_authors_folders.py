"""A folder of the author's computer in a file of CMake: taken by the build, read by the program, or by nobody."""

from __future__ import annotations

import time
from pathlib import Path

import pytest

from roslab.evidence.native import authors_folders
from trees import tree_of

DEFINES = (
    'project(a)\nadd_executable(a a.cpp)\ntarget_compile_definitions(a PUBLIC\n  DATA_DIR="/home/ana/data/set"\n)\n'
)


def _told(folder: Path, cmake: str, code: str) -> list[tuple[str, str, int]]:
    return list(authors_folders.read(tree_of(folder, {"CMakeLists.txt": cmake, "a.cpp": code})))


@pytest.mark.parametrize(
    "cmake", [DEFINES, 'project(a)\n\n\nadd_definitions(-DDATA_DIR="/home/ana/data/set")\nadd_executable(a a.cpp)\n']
)
def test_what_the_code_has_as_a_macro_is_read_when_it_runs(tmp_path: Path, cmake: str) -> None:
    ((message, _, line),) = _told(tmp_path, cmake, "const char *data = DATA_DIR;\n")
    assert message.startswith("/home/ana/data/set is a folder of its author's computer: the code has it as DATA_DIR, ")
    assert line == 4


@pytest.mark.parametrize("code", ["int MY_DATA_DIR;\n", "// std::string path = DATA_DIR;\nint main() {}\n"])
def test_a_macro_that_no_code_names_is_not_told(tmp_path: Path, code: str) -> None:
    assert _told(tmp_path, DEFINES, code) == []


def test_a_library_is_a_file(tmp_path: Path) -> None:
    ((message, *_),) = _told(tmp_path, "target_link_libraries(a /home/ana/lib/libx.so.2)\n", "int main() {}\n")
    assert message.startswith("/home/ana/lib/libx.so.2 is a file of its author's computer: ")


def test_what_the_build_takes_is_told_with_what_else_there_is(tmp_path: Path) -> None:
    cmake = f"{DEFINES}include_directories(/home/ana/lib/include)\n"
    ((message, _, line),) = _told(tmp_path, cmake, "int main() {}\n")
    assert message.startswith("/home/ana/lib/include is a folder of its author's computer: what the build takes ")
    assert line == 6


def test_a_folder_that_an_unused_macro_has_is_told_where_the_build_takes_it(tmp_path: Path) -> None:
    cmake = 'project(a)\nadd_definitions(-DUNUSED="/home/ana/lib/")\ninclude_directories(/home/ana/lib/)\n'
    ((message, _, line),) = _told(tmp_path, cmake, "int main() {}\n")
    assert message.startswith("/home/ana/lib/ is a folder of its author's computer: what the build takes ")
    assert line == 3


def test_each_place_has_its_own_reason(tmp_path: Path) -> None:
    cmake = 'project(a)\ninclude_directories(/home/ana/lib/)\nadd_definitions(-DDATA_DIR="/home/ana/lib/")\n'
    ((message, _, line),) = _told(tmp_path, cmake, "const char *data = DATA_DIR;\n")
    assert message.startswith("/home/ana/lib/ is a folder of its author's computer, and so is one more: what the build")
    assert line == 2


@pytest.mark.parametrize("macros", ["-DDATA_DIR={0} -DOLD={0}", "-DOLD={0} -DDATA_DIR={0}"])
def test_of_two_macros_of_one_folder_the_used_one_is_told(tmp_path: Path, macros: str) -> None:
    defined = macros.format('"/home/ana/lib/"')
    cmake = f"project(a)\nadd_definitions({defined})\n"
    ((message, _, _),) = _told(tmp_path, cmake, "const char *data = DATA_DIR;\n")
    assert message.startswith("/home/ana/lib/ is a folder of its author's computer: the code has it as DATA_DIR, ")


def test_many_macros_and_many_sources_take_little_time(tmp_path: Path) -> None:
    cmake = "".join(f'add_definitions(-DM{number}="/home/ana/{number}")\n' for number in range(1_500))
    names = "".join(f"// M{number}\n" for number in range(1_500))
    sources = {f"src/{number}.cpp": f"int M;\n{names}" for number in range(100)}
    repository = tree_of(tmp_path, {"CMakeLists.txt": cmake, **sources})
    start = time.process_time()
    assert list(authors_folders.read(repository)) == []
    assert time.process_time() - start < 2
