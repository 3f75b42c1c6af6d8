"""Programs that CMake files call: of ExternalProject_Add, execute_process and their like."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.evidence.native import called_programs, fetching
from roslab.repository.checkout import Repository


@pytest.mark.parametrize(
    ("cmake", "called"),
    [
        (
            'ExternalProject_Add(a\n UPDATE_COMMAND ""\n CONFIGURE_COMMAND cd ../a && ./autogen.sh && ./configure\n)',
            ["cd", "autogen.sh", "configure"],
        ),
        ("ExternalProject_Add(a PATCH_COMMAND ${CMAKE_COMMAND} -E env A=b patch -p1)", ["patch"]),
        ('execute_process(COMMAND sh -c "cd a;unzip b.zip")', ["cd", "unzip"]),
        (
            "ExternalProject_Add(a HG_REPOSITORY http://a.org/hg)\nExternalProject_Add(b SVN_REPOSITORY c)",
            ["hg", "svn"],
        ),
        ("find_program(FLEX NAMES flex)\nadd_custom_command(OUTPUT a.c COMMAND ${FLEX} a.l)", ["flex"]),
        ("exec_program(wget ARGS a)", ["wget"]),
        ("add_custom_target(patch DEPENDS unzip COMMENT curl)", []),
        ("option(OLD old OFF)\nif(OLD)\nexecute_process(COMMAND wget a)\nendif()", []),
        ("if(WIN32)\nexecute_process(COMMAND wget a)\nendif()", []),
        ("if(NOT A_FOUND)\nexecute_process(COMMAND wget a)\nendif()", ["wget"]),
    ],
)
def test_what_stands_where_a_program_does(cmake: str, called: list[str]) -> None:
    assert [name for name, _ in called_programs.programs(cmake)] == called


def test_the_packages_of_these_programs_are_needed_and_those_of_copied_code_are_not(tmp_path: Path) -> None:
    for path, text in {
        "solver/CMakeLists.txt": "project(solver)\nExternalProject_Add(a CONFIGURE_COMMAND autoreconf -fi)\n",
        "thirdparty/old/CMakeLists.txt": "execute_process(COMMAND wget a)\n",
        "solver/test/CMakeLists.txt": "execute_process(COMMAND curl a)\n",
    }.items():
        (tmp_path / path).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / path).write_text(text, encoding="utf-8")
    found = fetching.read(Repository.open(tmp_path)).programs
    assert [(each.name, each.role, each.file, each.line) for each in found] == [
        (name, "run", "solver/CMakeLists.txt", 2) for name in ("autoconf", "automake", "libtool", "pkg-config")
    ]


def test_a_library_of_csharp_is_compiled_with_what_brings_its_compiler(tmp_path: Path) -> None:
    (tmp_path / "CMakeLists.txt").write_text(
        "project(demo)\nadd_custom_target(api ALL COMMAND mcs -out:api.dll -pkg:dotnet -target:library *.cs)\n",
        encoding="utf-8",
    )
    found = fetching.read(Repository.open(tmp_path)).programs
    assert [(each.name, each.line) for each in found] == [("mono-devel", 2)]
