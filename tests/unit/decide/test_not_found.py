"""A library that find_library looks for and that is always linked comes from a table, or is told by its name."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
LOOK = "find_library(SOLVER_LIBRARY NAMES libacme81.so PATHS $ENV{ACME_HOME}/lib)\n"
LINK = "target_link_libraries(a ${SOLVER_LIBRARY})\n"


def project(lines: str, **more: str) -> dict[str, str]:
    return {
        "CMakeLists.txt": f"project(demo CXX)\n{lines}add_executable(a a.cpp)\n",
        "a.cpp": "int main() {}\n",
        **more,
    }


def told(decision: Decision) -> list[tuple[str, int | None]]:
    return [(w.message.split(",")[0], w.line) for w in decision.warnings if "find_library looks for" in w.message]


@pytest.mark.parametrize(
    ("files", "lines"),
    [
        (project(LOOK + LINK), [("CMake links acme81", 2)]),
        (
            project(f'{LOOK}set(ALL "m;${{SOLVER_LIBRARY}}")\ntarget_link_libraries(a ${{ALL}})\n'),
            [("CMake links acme81", 2)],
        ),
        (project(LOOK.replace(")\n", " REQUIRED)\n")), [("CMake links acme81", 2)]),
        (
            project(f'{LOOK}if(NOT SOLVER_LIBRARY)\nmessage(FATAL_ERROR "gone")\nendif()\n{LINK}'),
            [("CMake links acme81", 2)],
        ),
        (project(LOOK), []),  # nothing links it
        (project(f"{LOOK}if(SOLVER_LIBRARY)\n{LINK}endif()\n"), []),
        (project(f"{LOOK}if(NOT SOLVER_LIBRARY)\nset(SOLVER_LIBRARY dl)\nendif()\n{LINK}"), []),
        (project(f"option(WITH OFF)\nif(WITH)\n{LOOK}{LINK}endif()\n"), []),
        (project(LOOK.replace("libacme81.so", "dl") + LINK), []),  # the C library's
        (project(LOOK + LINK, **{"sdk/libacme81.so": "binary"}), []),  # the tree's
        (project(LOOK + LINK, **{"README.md": "```\nsudo apt install libacme-dev\n```\n"}), []),
    ],
)
def test_what_nothing_brings_is_told(tree: Tree, files: dict[str, str], lines: list[tuple[str, int]]) -> None:
    assert told(tree(files)) == lines


@pytest.mark.parametrize(("name", "count"), [("acme_proto_lib", 1), ("acme_proto", 0)])
def test_a_library_that_is_named_so_by_hand_is_no_package_s(tree: Tree, name: str, count: int) -> None:
    page = {"README.md": "```\nsudo apt install libacme-dev\n```\n"}
    assert len(told(tree(project(LOOK.replace("libacme81.so", name) + LINK, **page)))) == count


def test_what_a_table_has_is_built_or_installed(tree: Tree) -> None:
    both = LOOK.replace("libacme81.so", "libosqp.so") + LOOK.replace("SOLVER", "OTHER").replace("acme81.so", "nlopt.so")
    decision = tree(project(f"{both}target_link_libraries(a ${{SOLVER_LIBRARY}} ${{OTHER_LIBRARY}})\n"))
    assert not told(decision)
    assert [source.name for source in decision.source] == ["osqp"]
    assert "libnlopt-dev" in decision.apt_guessed


SDK = {"a.cpp": "#include <acme/acme.h>\nint main() {}\n"}


@pytest.mark.parametrize(
    ("files", "lines"),
    [
        (project("target_link_libraries(a acme)\n", **SDK), [2]),
        (project("target_link_libraries(a acme)\n"), []),  # it may be a target of a package
        (project("if(WITH)\ntarget_link_libraries(a acme)\nendif()\n", **SDK), []),
        (project("target_link_libraries(a acme)\n", **SDK, **{"lib/libacme.so": "binary"}), []),
        (project("add_library(acme b.cpp)\ntarget_link_libraries(a acme)\n", **SDK), []),
        (project("generate_parameter_library(acme src/acme.yaml)\ntarget_link_libraries(a acme)\n", **SDK), []),
        (project("target_link_libraries(a acme)\n", **SDK, **{"README.md": "```\napt install libacme-dev\n```\n"}), []),
    ],
)  # fmt: skip
def test_what_is_linked_and_included_and_nothing_brings_is_told(
    tree: Tree, files: dict[str, str], lines: list[int]
) -> None:
    said = [w.line for w in tree(files).warnings if "of which the code includes acme/acme.h" in w.message]
    assert said == lines


@pytest.mark.parametrize(("folder", "told"), [("third/Acme-SDK", False), ("third/other", True)])
def test_a_submodule_may_write_its_name_with_a_dash(tree: Tree, folder: str, *, told: bool) -> None:
    module = f'[submodule "{folder}"]\npath = {folder}\nurl = https://github.com/lab/{folder.rpartition("/")[2]}.git\n'
    files = {"a.cpp": "#include <AcmeSDK/acme.h>\nint main() {}\n", ".gitmodules": module}
    decision = tree(project("target_link_libraries(a AcmeSDK)\n", **files))
    assert any("CMake links AcmeSDK" in w.message for w in decision.warnings) == told


ADDRESS = "https://github.com/lab/acme"


@pytest.mark.parametrize(
    ("lines", "told"),
    [
        (f"FetchContent_Declare(acme GIT_REPOSITORY {ADDRESS}.git GIT_TAG v1)\n", False),
        ("FetchContent_Declare(acme URL ${ACME_URL})\n", False),
        (f"ExternalProject_Add(acme_ext URL {ADDRESS}/archive/1.0.zip)\n", False),
        ('CPMAddPackage("gh:lab/acme@1.3#v1.3")\n', False),
        ("CPMAddPackage(NAME acme GITHUB_REPOSITORY lab/acme VERSION 1.3)\n", False),
        ("include(cmake/deps.cmake)\n", False),
        ("FetchContent_Declare(other GIT_REPOSITORY https://github.com/lab/other)\n", True),
        ("", True),
    ],
)
def test_what_cmake_fetches_is_there(tree: Tree, lines: str, *, told: bool) -> None:
    included = f"FetchContent_Declare(acme URL {ADDRESS}/archive/1.0.zip)\n"
    files = project(f"{lines}target_link_libraries(a acme)\n", **SDK, **{"cmake/deps.cmake": included})
    assert any("CMake links acme" in w.message for w in tree(files).warnings) == told


def test_what_is_linked_and_included_must_be_there(tree: Tree) -> None:
    links = "target_link_libraries(a glpk)\nif(WITH)\ntarget_link_libraries(a udev)\nendif()\n"
    code = "#include <glpk.h>\n#include <libudev.h>\nint main() {}\n"
    decision = tree(project(links, **{"a.cpp": code}))
    assert "libglpk-dev" in decision.apt
    assert "libudev-dev" in decision.apt_guessed


def test_an_ubuntu_that_was_not_looked_up_may_lack_it(tree: Tree) -> None:
    page = "Ubuntu 14.04\n```\nsudo apt-get install ros-indigo-desktop\n```\n"
    links = "find_package(catkin REQUIRED)\ncatkin_package()\ntarget_link_libraries(a zstd gsl)\n"
    code = "#include <zstd.h>\n#include <gsl/gsl_rng.h>\nint main() {}\n"
    manifest = "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend></package>"
    decision = tree(project(links, **{"a.cpp": code, "package.xml": manifest, "README.md": page}))
    assert decision.ubuntu == "trusty"
    assert not {"libzstd-dev", "libgsl-dev", "libgsl0-dev"} & {*decision.apt}
    assert {"libzstd-dev", "libgsl0-dev"} <= {*decision.apt_guessed}


def test_a_library_that_is_linked_alone_is_only_tried(tree: Tree) -> None:
    decision = tree(project("target_link_libraries(a glpk)\n"))
    assert "libglpk-dev" in decision.apt_guessed


SCRIPT = "git clone https://github.com/lab/acme.git acme\ncd acme\ngit checkout tags/v1\ncd ..\nmkdir made\ncd made\n"
BUILDS = "cmake -DACME_SHARED=ON -DCMAKE_INSTALL_PREFIX=${BASE}/there ${BASE}/acme/acme\nmake\nmake install\n"


def test_a_clone_that_nothing_builds_brings_no_library(tree: Tree) -> None:
    files = project("target_link_libraries(a acme)\n", **SDK, **{"install.bash": SCRIPT})
    assert any("CMake links acme, of which" in w.message for w in tree(files).warnings)


def test_a_script_compiles_a_folder_of_a_clone_outside_of_it(tree: Tree) -> None:
    script = f"BASE=`pwd`\n{SCRIPT}{BUILDS}"
    decision = tree(project("target_link_libraries(a acme)\n", **SDK, **{"install.bash": script}))
    (library,) = decision.source
    assert (library.ref, library.cmake_folder, library.cmake_options) == ("v1", "../acme", "-DACME_SHARED=ON")
    assert not any("CMake links acme" in w.message for w in decision.warnings)


@pytest.mark.parametrize(
    ("call", "folder"),
    [
        ("cmake -S acme -B acme/build", None),
        ("cmake -Sacme/core -Bacme/build", "../core"),
        ("cmake -B acme/build acme/core", "../core"),
        ('cmake acme/core -B acme/build -G "Unix Makefiles" -D ACME_SHARED=ON', "../core"),
        ("cmake acme/core -DACME_SHARED=ON", "../core"),
    ],
)
def test_the_source_of_a_call_of_cmake_is_no_value_of_its_options(tree: Tree, call: str, folder: str | None) -> None:
    page = f"```\ngit clone https://github.com/lab/acme.git\n{call}\nsudo cmake --install acme/build\n```\n"
    decision = tree(project("find_package(acme REQUIRED)\n", **{"README.md": page}))
    assert [library.cmake_folder for library in decision.source] == [folder]


SIEVE = {
    "CMakeLists.txt": "project(demo CXX)\ninclude(cmake/Download.cmake)\ndemo_download()\n"
    "add_executable(a a.cpp)\ntarget_link_libraries(a sieve)\n",
    "a.cpp": "#include <sieve/sieve.h>\nint main() {}\n",
}
FETCHED = "GIT_REPOSITORY https://github.com/lab/net-of-wire.git GIT_TAG main"


@pytest.mark.parametrize(
    ("module", "count"),
    [
        ("set(A 1)", 1),
        (f"function(demo_download)\ndownload_project(PROJ sieve {FETCHED} QUIET)\nendfunction()", 0),
        (f"macro(demo_download)\nFetchContent_Declare(sieve {FETCHED})\nendmacro()", 0),
        (f"function(demo_download)\nCPMAddPackage(NAME sieve {FETCHED})\nendfunction()", 0),
        ("function(demo_download)\nadd_library(sieve INTERFACE)\nendfunction()", 0),
        ("add_library(sieve INTERFACE)", 0),
        ("function(demo_download)\nadd_library(sieve SHARED IMPORTED)\nendfunction()", 1),
    ],
)
def test_what_an_included_file_makes_or_downloads_is_there(tree: Tree, module: str, count: int) -> None:
    found = tree({**SIEVE, "cmake/Download.cmake": f"{module}\n"})
    assert sum("CMake links sieve" in warning.message for warning in found.warnings) == count


def test_what_an_included_file_links_is_the_project_s(tree: Tree) -> None:
    """A project for two build systems has a file for each, and includes the one that fits."""
    top = "project(demo CXX)\ninclude(${PROJECT_SOURCE_DIR}/plain.cmake)\n"
    made = "add_library(own own.cpp)\nadd_executable(a a.cpp)\ntarget_link_libraries(a own qhull)\n"
    found = tree({"CMakeLists.txt": top, "plain.cmake": made, "a.cpp": "int main() {}\n", "own.cpp": ""})
    assert "libqhull-dev" in (*found.apt, *found.apt_guessed)
    assert not found.warnings


PATH = "find_path(ACME_INCLUDE NAMES acme/solve.h PATHS /usr/local/include)\n"
STOP = 'if(NOT ACME_INCLUDE OR NOT SOLVER_LIBRARY)\nmessage(FATAL_ERROR "gone")\nendif()\n'


def of_stops(decision: Decision) -> list[tuple[str, int | None]]:
    return [(w.message.split(",")[0], w.line) for w in decision.warnings if w.message.startswith("CMake l")]


@pytest.mark.parametrize(
    ("files", "lines"),
    [
        (project(PATH + LOOK + STOP), [("CMake links acme81", 3)]),  # nothing links it by that variable
        (
            project(PATH + STOP.replace(" OR NOT SOLVER_LIBRARY", "")),
            [("CMake looks for the header acme/solve.h and stops without it", 2)],
        ),
        (project(PATH + LOOK + STOP.replace("FATAL_ERROR", "STATUS")), []),
        (project(PATH + LOOK + STOP.replace("OR", "AND")), []),  # one of the two will do
        (project(PATH + STOP.replace(" OR NOT SOLVER_LIBRARY", ""), **{"lib/acme/solve.h": ""}), []),
        (project(PATH.replace("acme/solve.h", "sys/mman.h") + STOP), []),
        (project(PATH.replace("acme/solve.h", "solve.h") + STOP), []),
        (project(PATH), []),
        (project(f"option(WITH OFF)\nif(WITH)\n{PATH}endif()\n{STOP}"), []),
    ],
)
def test_what_a_message_stops_without_is_required(
    tree: Tree, files: dict[str, str], lines: list[tuple[str, int]]
) -> None:
    assert of_stops(tree(files)) == lines


def test_a_header_that_a_message_stops_without_is_installed(tree: Tree) -> None:
    stop = STOP.replace(" OR NOT SOLVER_LIBRARY", "")
    decision = tree(project(PATH.replace("acme/solve.h", "yaml-cpp/yaml.h") + stop))
    assert "libyaml-cpp-dev" in decision.apt_guessed
    assert not of_stops(decision)


def test_vdt_is_built_from_its_repository(tree: Tree) -> None:
    looks = PATH.replace("acme/solve.h", "vdt/exp.h") + LOOK.replace("libacme81.so", "vdt")
    decision = tree(project(looks + STOP))
    assert [source.name for source in decision.source] == ["vdt"]
    assert not of_stops(decision)
