"""A project of Autotools is a way to compile C++, where nothing else builds the tree."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
CONFIGURE = """dnl AX_NOT_THIS
AC_INIT([planner], [1.0])
AM_INIT_AUTOMAKE([foreign])
AX_CXX_COMPILE_STDCXX_11([noext], [mandatory])
AC_CHECK_LIB([fftw3], [fftw_execute])
PKG_CHECK_MODULES([GLIB], [glib-2.0 >= 2.40 eigen3])
AC_CONFIG_FILES([Makefile src/Makefile])
AC_OUTPUT
"""
FILES = {
    "configure.ac": CONFIGURE,
    "Makefile.am": "SUBDIRS = src\n",
    "src/Makefile.am": "bin_PROGRAMS = \\\n  planner\nnoinst_PROGRAMS = probe\nplanner_SOURCES = main.cpp\n"
    "planner_LDADD = $(GLIB_LIBS) -lusb-1.0\n",
    "src/main.cpp": "#include <Eigen/Dense>\nint main() {}\n",
}
ANEW = "autoreconf --force --install && sh ./configure"
BUILD = 'make --jobs="$(compile-jobs)" && make install && ldconfig'
TOOLS = {"autoconf", "autoconf-archive", "automake", "libtool", "pkg-config"}


def test_it_is_configured_made_and_installed(tree: Tree) -> None:
    decision = tree(FILES)
    assert (decision.kind, decision.build_tool) == ("cpp", "none")
    (script,) = decision.scripts
    assert (script.folder, script.command, script.required) == ("", f"{ANEW} && {BUILD}", True)
    assert {*decision.apt} >= {"libglib2.0-dev", "libeigen3-dev"}
    assert "cmake" not in decision.apt
    assert {*decision.apt_guessed} >= TOOLS | {"libfftw3-dev", "libusb-1.0-0-dev"}
    assert decision.command == ("./src/planner",)
    assert not [each for each in decision.warnings if "nothing shows" in each.message]


def test_what_its_macros_look_for_is_installed(tree: Tree) -> None:
    told = f"{CONFIGURE}AC_PROG_YACC\nAM_GNU_GETTEXT_VERSION([0.19])\n# AC_PROG_LEX\nMY_AC_PROG_FC\n"
    tools = {"bison", "gettext", "autopoint", "flex", "gfortran"}
    assert {*tree({**FILES, "configure.ac": told}).apt_guessed} & tools == {"bison", "gettext", "autopoint"}


@pytest.mark.parametrize(
    ("more", "made"),
    [
        ({}, ""),
        ({"configure.ac": CONFIGURE + "AC_CONFIG_MACRO_DIR([m4])\n"}, "mkdir --parents m4 && "),
        ({"Makefile.am": "ACLOCAL_AMFLAGS = -I m4\n"}, "mkdir --parents m4 && "),
        ({"configure.ac": CONFIGURE + "AC_CONFIG_MACRO_DIR([m4])\n", "m4/a.m4": "dnl a\n"}, ""),
    ],
    ids=["none", "configure", "automake", "there"],
)
def test_the_folder_of_macros_that_git_does_not_keep_is_made(tree: Tree, more: dict[str, str], made: str) -> None:
    (script,) = tree({**FILES, **more}).scripts
    assert script.command == f"{made}{ANEW} && {BUILD}"


@pytest.mark.parametrize("run", ["./probe", "planner a.txt"])
def test_what_a_page_runs_of_it(tree: Tree, run: str) -> None:
    page = f"# Planner\n## Usage\n```\n./configure\nmake\nsudo make install\n{run}\n```\n"
    assert tree({**FILES, "a.txt": "1", "README.md": page}).command == tuple(run.split())


def test_a_configure_without_its_source_is_called_as_it_is(tree: Tree) -> None:
    decision = tree({"configure": "#!/bin/sh\n", "Makefile.in": "all:\n", "a.cpp": "int main() {}\n"})
    (script,) = decision.scripts
    assert script.command == f"sh ./configure && {BUILD}"
    assert "autoconf" not in decision.apt


def test_one_in_a_folder(tree: Tree) -> None:
    decision = tree({f"planner/{path}": text for path, text in FILES.items()})
    assert [script.folder for script in decision.scripts] == ["planner"]
    assert decision.command == ("./planner/src/planner",)


@pytest.mark.parametrize(
    "files",
    [
        {"CMakeLists.txt": "project(x)\nadd_executable(x src/main.cpp)\n"},
        {"third_party/configure.ac": CONFIGURE, "configure.ac": ""},
        {"a.py": "import numpy\n", "b.py": "import numpy\n"},
    ],
    ids=["cmake", "copied", "python"],
)
def test_what_is_built_otherwise_is_not(tree: Tree, files: dict[str, str]) -> None:
    files = {path: text for path, text in ({**FILES, **files}).items() if text}
    assert not [each for each in tree(files).scripts if "configure" in each.command]
