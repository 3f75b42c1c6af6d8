"""What CMake takes only where an option is set: nobody sets one that is off by default."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
MANIFEST = "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend></package>"
MADE = "project(demo)\nfind_package(catkin REQUIRED COMPONENTS roscpp)\n"
OFF, ON = "option(WITH_BRISK 'more corners' OFF)\n", "option(WITH_BRISK 'more corners' ON)\n"
FINDS = "if(WITH_BRISK)\nfind_package(brisk REQUIRED)\nendif()\n"


@pytest.mark.parametrize(
    ("files", "page", "cloned"),
    [
        ({"CMakeLists.txt": f"{MADE}{OFF}{FINDS}"}, "", False),
        ({"CMakeLists.txt": f"{MADE}{OFF}{FINDS.replace('WITH_BRISK', '${WITH_BRISK}')}"}, "", False),
        ({"CMakeLists.txt": f"{MADE}{ON}{FINDS}"}, "", True),
        ({"CMakeLists.txt": f"{MADE}{OFF}set(WITH_BRISK ON)\n{FINDS}"}, "", True),
        ({"CMakeLists.txt": f"{MADE}{OFF}{FINDS}"}, "```\ncd build\ncmake -DWITH_BRISK=ON ..\n```\n", True),
        (
            {
                "CMakeLists.txt": f"{MADE}include(cmake/setup.cmake)\ninclude(cmake/brisk.cmake)\n",
                "cmake/setup.cmake": "include(options)\n",
                "cmake/options.cmake": OFF,
                "cmake/brisk.cmake": FINDS,
            },
            "",
            False,
        ),
        ({"CMakeLists.txt": f"{MADE}{OFF}add_subdirectory(lib)\n", "lib/CMakeLists.txt": FINDS}, "", False),
        ({"CMakeLists.txt": f"{MADE}add_subdirectory(lib)\n{OFF}", "lib/CMakeLists.txt": FINDS}, "", True),
    ],
)
def test_what_waits_for_an_option_that_is_off_is_not_cloned(
    tree: Tree, files: dict[str, str], page: str, cloned: bool
) -> None:
    decision = tree({"package.xml": MANIFEST, "README.md": f"ROS Noetic\n{page}", **files})
    assert ("ethzasl_brisk" in {source.name for source in decision.source}) == cloned


def test_a_program_that_waits_for_an_option_of_an_included_file_is_not_the_obvious_one(tree: Tree) -> None:
    files = {
        "CMakeLists.txt": "project(x CXX)\ninclude(cmake/options.cmake)\nadd_subdirectory(apps)\n",
        "cmake/options.cmake": "option(WITH_APPS 'programs' OFF)\n",
        "apps/CMakeLists.txt": "if(WITH_APPS)\nadd_executable(show show.cpp)\nendif()\n",
        "apps/show.cpp": "int main() {}\n",
    }
    assert tree(files).command == ("bash",)
    assert tree({**files, "README.md": "```\ncd build\ncmake -DWITH_APPS=ON ..\n```\n"}).command == ("show",)


LINKED = "It needs [eigen-odd](https://github.com/lab/eigen-odd).\n"


@pytest.mark.parametrize(
    ("cmake", "page", "built"),
    [
        ("option(WITH_ODD 'a solver' ON)\nif(WITH_ODD)\n{}endif()\n", "", True),
        ("include(cmake/options.cmake)\nif(WITH_ODD)\n{}endif()\n", "", True),
        ("if(WITH_ODD)\n{}endif()\n", "", False),
        ("option(WITH_ODD 'a solver' OFF)\nif(WITH_ODD)\n{}endif()\n", "", False),
        ("option(WITH_ODD 'a solver' ON)\nif(NOT WITH_ODD)\n{}endif()\n", "", False),
        ("option(WITH_ODD 'a solver' ON)\nif(WITH_ODD)\n{}endif()\n", "cmake -DWITH_ODD:BOOL=OFF ..", False),
    ],
)
def test_what_an_option_asks_for_that_is_on_is_required(tree: Tree, cmake: str, page: str, built: bool) -> None:
    made = "project(x CXX)\nadd_executable(show show.cpp)\n" + cmake.format("find_package(eigen-odd REQUIRED)\n")
    readme = f"{LINKED}```\ncd build\n{page}\n```\n"
    files = {"CMakeLists.txt": made, "show.cpp": "int main() {}\n", "README.md": readme}
    files["cmake/options.cmake"] = "option(WITH_ODD 'a solver' ON)\n"
    decision = tree(files)
    assert ([source.name for source in decision.source] == ["eigen-odd"]) == built


APPS = {
    "CMakeLists.txt": "project(x)\nadd_subdirectory(src)\nif(BUILD_EXAMPLES)\nadd_subdirectory(examples)\nendif()\n",
    "src/CMakeLists.txt": "add_library(x x.cpp)\n",
    "src/x.cpp": "int x() { return 0; }\n",
    "examples/CMakeLists.txt": "add_executable(calib_app app.cpp)\n",
    "examples/app.cpp": "int main() {}\n",
    "data/samples/param.json": "{}\n",
    "README.md": "## Run\n\n```\n./build/examples/calib_app ./data/samples/param.json\n```\n",
}


def test_what_a_page_runs_turns_on_the_option_that_nothing_declares(tree: Tree) -> None:
    decision = tree(APPS)
    assert decision.command == ("calib_app", "data/samples/param.json")
    assert decision.cmake_options == ("-DBUILD_EXAMPLES=ON",)


def test_a_program_of_both_branches_waits_for_no_option(tree: Tree) -> None:
    made = "if(USE_GPU)\nadd_executable(calib_app a.cu)\nelse()\nadd_executable(calib_app app.cpp)\nendif()\n"
    decision = tree(
        {**APPS, "CMakeLists.txt": "project(x CXX)\nadd_subdirectory(examples)\n", "examples/CMakeLists.txt": made}
    )
    assert decision.command == ("calib_app", "data/samples/param.json")
    assert decision.cmake_options == ()


@pytest.mark.parametrize(
    ("variable", "lines", "options"),
    [
        ("WITH_VIEWER", "find_package(Odd)\nif(Odd_FOUND)\nset(WITH_VIEWER ON)\nendif()\n", ()),
        ("WITH_VIEWER", "set(WITH_VIEWER ${Odd_FOUND})\n", ()),
        ("WITH_VIEWER", "# set(WITH_VIEWER ON)\n", ("-DWITH_VIEWER=ON",)),
        ("WITH_VIEWER", "set(WITH_VIEWER OFF CACHE BOOL 'a window')\n", ("-DWITH_VIEWER=ON",)),
        ("WITH_VIEWER", "if(NOT DEFINED WITH_VIEWER)\nset(WITH_VIEWER OFF)\nendif()\n", ("-DWITH_VIEWER=ON",)),
        ("USE_CUDA", "", ()),
    ],
)
def test_what_the_tree_sets_itself_is_not_given(
    tree: Tree, variable: str, lines: str, options: tuple[str, ...]
) -> None:
    made = f"project(x CXX)\n{lines}if({variable})\nadd_executable(calib_app examples/app.cpp)\nendif()\n"
    decision = tree({**APPS, "CMakeLists.txt": made, "examples/CMakeLists.txt": ""})
    assert decision.command == ("calib_app", "data/samples/param.json")
    assert decision.cmake_options == options
