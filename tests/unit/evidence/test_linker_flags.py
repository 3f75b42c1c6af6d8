"""Libraries that variables of CMake name as the linker does."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.evidence.native import cmake
from roslab.repository.checkout import Repository

FLAGS = 'set(FFMPEG_DIR "/usr/lib/x86_64-linux-gnu")\nset(FFMPEG_LIBRARIES "-L${FFMPEG_DIR} -lpostproc -lavfilter")\n'


def _links(folder: Path, files: dict[str, str]) -> list[tuple[str, str, str]]:
    for name, text in files.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text)
    found = [each for project in cmake.read(Repository.open(folder)) for each in project.dependencies]
    return [(each.name, each.strength, each.file) for each in found if each.namespace == "link"]


@pytest.mark.parametrize("module", ["cmake_modules/Findffmpeg.cmake", "Findffmpeg.cmake"])
def test_those_of_a_find_module_of_the_tree_are_needed(tmp_path: Path, module: str) -> None:
    files = {"CMakeLists.txt": "project(a)\nfind_package(ffmpeg REQUIRED)\n", module: FLAGS}
    assert _links(tmp_path, files) == [("postproc", "used", module), ("avfilter", "used", module)]


@pytest.mark.parametrize(
    ("asked", "module", "strength"),
    [
        ("find_package(ffmpeg)", "if(APPLE)\n{}endif()\n", "optional"),
        ("if(WITH_VIDEO)\nfind_package(ffmpeg)\nendif()", "{}", "optional"),
        ("find_package(ffmpeg)", "list(APPEND LIBRARIES -lpostproc;-lavfilter)\n", "used"),
    ],
)
def test_those_under_a_condition_may_not_be(tmp_path: Path, asked: str, module: str, strength: str) -> None:
    files = {"CMakeLists.txt": f"project(a)\n{asked}\n", "cmake/Findffmpeg.cmake": module.format(FLAGS)}
    assert {each[1] for each in _links(tmp_path, files)} == {strength}


def test_what_a_variable_of_the_file_itself_names_is_needed(tmp_path: Path) -> None:
    text = 'project(a)\nset(LIBS ${LIBS} -lpostproc "-lavfilter -Wl,-rpath")\nset(NAME "some-lib a-lb")\n'
    assert [each[0] for each in _links(tmp_path, {"CMakeLists.txt": text})] == ["postproc", "avfilter"]


def test_a_module_that_nothing_asks_for_says_nothing(tmp_path: Path) -> None:
    files = {"CMakeLists.txt": "project(a)\nfind_package(other)\n", "cmake/Findffmpeg.cmake": FLAGS}
    assert _links(tmp_path, files) == []


def test_many_are_read_to_an_end(tmp_path: Path) -> None:
    many = "".join(f"set(L{number} -l{'x' * 500} -l)\n" for number in range(2000))
    files = {"CMakeLists.txt": "project(a)\nfind_package(ffmpeg)\n", "Findffmpeg.cmake": many[: 60 * 1024]}
    assert len(_links(tmp_path, files)) < 200
