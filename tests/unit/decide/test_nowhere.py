"""Headers that code includes as the tree's own, and that nothing in the tree is or makes."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]


def _package(name: str, more: str = "") -> dict[str, str]:
    return {
        f"{name}/package.xml": f"<package><name>{name}</name><buildtool_depend>catkin</buildtool_depend></package>",
        f"{name}/CMakeLists.txt": f"project({name})\nfind_package(catkin REQUIRED roscpp)\ncatkin_package()\n{more}",
    }


def _including(header: str, more: dict[str, str] | None = None, file: str = "mine/src/a.cpp") -> dict[str, str]:
    files = {**_package("mine", "add_executable(a src/a.cpp)\n"), **_package("other"), "other/msg/Some.msg": "int8 a\n"}
    files |= {"mine/src/a.cpp": "int main() {}\n", "README.md": "ROS Noetic\n"}
    return {**files, file: f'#include "{header}"\nint main() {{}}\n', **(more or {})}


def _told(decision: Decision) -> list[str]:
    return [each.message for each in decision.warnings if "nothing in the repository is or makes" in each.message]


@pytest.mark.parametrize(
    "header", ["other/Lost.h", "other/lost.h", "other/msg/lost.hpp", "../../lost/src/lost.h", "../../builder/lost.h"]
)
def test_a_package_that_includes_what_nothing_makes_stops_no_others(tree: Tree, header: str) -> None:
    decision = tree(_including(header))
    assert decision.may_fail == ("mine",)
    (told,) = _told(decision)
    assert told.startswith(f"mine includes {header}, ")


@pytest.mark.parametrize(
    ("header", "more"),
    [
        ("other/Some.h", {}),
        ("other/msg/some.hpp", {}),
        ("other/SomeRequest.h", {"other/srv/Some.srv": "---\n"}),
        ("other/DoActionGoal.h", {"other/action/Do.action": "---\n---\n"}),
        ("other/DoAction.h", {"other/action/Do.action": "---\n---\n"}),
        ("other/msg/bar_baz.hpp", {"other/msg/BarBaz.idl": "module other {};\n"}),
        ("other/msg/some__struct.hpp", {}),
        ("../../../devel/include/other/lost.h", {}),
        ("../../build/lost/lost.h", {}),
        ("other/SomeConfig.h", {"other/cfg/Some.cfg": "\n"}),
        ("other/lost.h", {"other/include/elsewhere/lost.h": "\n"}),
        ("other/version.h", {"other/cmake/version.h.in": "\n"}),
        ("other/made.h", _package("other", "add_custom_command(OUTPUT made.h COMMAND make_it)\n")),
        ("other/Lost.h", {"other/msg/Some.msg": "", "other/CATKIN_IGNORE": ""}),  # another one than that of the tree
        ("third/Lost.h", _package("third")),  # it makes no messages
        (
            "../../lost/src/lost.h",
            {".gitmodules": '[submodule "a"]\n\tpath = lost\n\turl = https://github.com/a/lost\n'},
        ),
        ("../generated/lost.h", {}),
    ],
)
def test_what_may_be_made_or_is_elsewhere_is_not_told(tree: Tree, header: str, more: dict[str, str]) -> None:
    decision = tree(_including(header, more))
    assert not _told(decision)
    assert decision.may_fail == ()


@pytest.mark.parametrize(
    ("file", "told"),
    [
        ("mine/include/mine/used.h", True),
        ("mine/include/mine/unused.h", False),
        ("mine/src/not_in_the_list.cpp", False),
        ("mine/examples/a.cpp", False),
    ],
)
def test_only_what_is_compiled_stops(tree: Tree, file: str, told: bool) -> None:
    more = {"mine/src/a.cpp": '#include "mine/used.h"\nint main() {}\n'}
    assert bool(_told(tree(_including("other/Lost.h", more, file)))) == told


def test_a_condition_may_leave_it_out(tree: Tree) -> None:
    code = '#ifdef WITH_LOST\n#include "other/Lost.h"\n#endif\nint main() {}\n'
    assert not _told(tree(_including("other/Lost.h", {"mine/src/a.cpp": code})))


MINE = "add_executable(a src/a.cpp)\n"
MADE = "${CMAKE_BINARY_DIR}/acmelib/acmelib.h"
FETCHED = (
    "include(FetchContent)\nFetchContent_Declare(words GIT_REPOSITORY https://github.com/me/words.git GIT_TAG v1)\n"
    "FetchContent_MakeAvailable(words)\n"
)
MODULE = '[submodule "{0}"]\n\tpath = {0}\n\turl = https://github.com/me/words.git\n'
LISTED = "repositories:\n  core:\n    type: git\n    url: https://github.com/me/core.git\n    version: main\n"


@pytest.mark.parametrize(
    ("code", "more", "told"),
    [
        ("#include <acmelib/acmelib.h>\n", {}, True),
        ("#ifndef A\n#define A\n#include <acmelib/acmelib.h>\n#endif\n", {}, True),
        ("#ifdef WITH\n#include <acmelib/acmelib.h>\n#endif\n", {}, False),
        ("#if __has_include(<acmelib/acmelib.h>)\n#include <acmelib/acmelib.h>\n#endif\n", {}, False),
        ("#include <acmelib/other.h>\n", {}, True),
        ("#include <acmelib/parts/other.hpp>\n", {}, True),
        ("#include <acmelib/other.h>\n", {"mine/src/other.h": "\n"}, False),
        ("#ifdef WITH\n#include <acmelib/other.h>\n#endif\n", {}, False),
        ("#include <mach/mach_time.h>\n#include <thrust/fill.h>\n", {}, False),
        ("#include <acmelib/other.h>\n", _package("mine", f"option(A a OFF)\nif(A)\n{MINE}endif()\n"), False),
        ("#include <acmelib/other.h>\n", _package("mine", f"option(A a ON)\nif(A)\n{MINE}endif()\n"), True),
        ("#include <glm/glm.hpp>\n", {}, False),
        ("#include <yaml-cpp/yaml.h>\n", {}, False),
        ("#include <acmelib/acmelib.h>\n", {"mine/include/acmelib/acmelib.h": "\n"}, False),
        ("#include <acmelib/acmelib.h>\n", {"README.md": "ROS Noetic\n```\napt install libacmelib-dev\n```\n"}, False),
        ("#include <acmelib/acmelib.h>\n", _package("mine", "add_executable(node src/b.cpp)\n"), False),
        (
            "#include <acmelib/acmelib.h>\n",
            _package("mine", "find_package(Acme)\nadd_executable(a src/a.cpp)\n"),
            False,
        ),
        ("#include <acmelib/acmelib.h>\n", _package("acmelib"), False),
        ("#include <acmelib/acmelib.h>\n", _package("mine", MINE + f"configure_file(a.in {MADE})\n"), False),
        ("#include <acmelib/acmelib.h>\n", {"mine/acmelib.h.in": ""}, False),
        ("#include <acmelib/acmelib.h>\n", _package("mine", MINE + FETCHED), False),
        ("#include <acmelib/acmelib.h>\n", _package("other", FETCHED), True),
        ("#include <acmelib/acmelib.h>\n", {".gitmodules": MODULE.format("mine/3rdparty/Words")}, False),
        ("#include <acmelib/acmelib.h>\n", {"README.md": "ROS Noetic\n", "a.repos": LISTED}, False),
    ],
)
def test_a_library_that_nothing_names_or_brings_is_told(
    tree: Tree, code: str, more: dict[str, str], *, told: bool
) -> None:
    files = _including("other/Some.h", {"mine/src/b.cpp": "int main() {}\n", "mine/src/a.cpp": code, **more})
    decision = tree(files)
    assert decision.may_fail == (("mine",) if told else ())
    said = [each for each in decision.warnings if "and nothing is known that brings acmelib" in each.message]
    assert [each.file for each in said] == (["mine/src/a.cpp"] if told else [])


@pytest.mark.parametrize(
    ("started", "then"), [("other", "mine is left out of the build"), ("mine", "will most likely")]
)
def test_the_build_goes_on_without_what_includes_such_a_library_unless_it_is_started(
    tree: Tree, started: str, then: str
) -> None:
    page = {"README.md": f"ROS Noetic\n```\ncatkin_make\nrosrun {started} a\n```\n"}
    decision = tree({**_including("acmelib/acmelib.h"), **page})
    assert ("mine" in decision.must_build) == (started == "mine")
    (said,) = [each.message for each in decision.warnings if "nothing is known that brings acmelib" in each.message]
    assert then in said


CPP = {"CMakeLists.txt": "project(demo)\nadd_executable(demo a.cpp)\n", "README.md": "Tested on Ubuntu 22.04\n"}


@pytest.mark.parametrize(
    ("files", "place"),
    [
        ({"a.cpp": "int a;\n#include <acmelib/parts.hpp>\n"}, ("a.cpp", 2)),
        ({"a.cpp": '#include "a.h"\n', "a.h": "#include <acmelib/parts.hpp>\n"}, ("a.h", 1)),
        ({"a.cpp": "int main() {}\n", "a.h": "#include <acmelib/parts.hpp>\n"}, None),
        ({"a.cpp": "int main() {}\n", "b.cpp": '#include "a.h"\n', "a.h": "#include <acmelib/parts.hpp>\n"}, None),
        ({"a.cpp": "int main() {}\n", "b.cpp": "#include <acmelib/parts.hpp>\n"}, None),
        ({"a.cpp": "#include <acmelib/parts.hpp>\n", "README.md": "```\napt install libacmelib-dev\n```\n"}, None),
    ],
)
def test_a_program_is_told_of_headers_that_what_it_compiles_includes(
    tree: Tree, files: dict[str, str], place: tuple[str, int] | None
) -> None:
    said = [w for w in tree({**CPP, **files}).warnings if "nothing is known that brings acmelib" in w.message]
    assert [(w.file, w.line) for w in said] == ([place] if place else [])


@pytest.mark.parametrize(
    ("main", "told"),
    [("", 0), ('#include "mine/grid.h"\n', 1), ('#include "other/Lost.h"\n', 1), ('#include "mine/area.h"\n', 1)],
)
def test_a_header_that_no_compiled_source_includes_stops_nothing(tree: Tree, main: str, told: int) -> None:
    files = _including("other/Lost.h", file="mine/include/mine/grid.h")
    files |= {
        "mine/include/mine/area.h": '#include "mine/grid.h"\n',
        "mine/src/a.cpp": f"{main}int main() {{}}\n",
        "mine/src/unlisted.cpp": '#include "mine/area.h"\n',
    }
    assert len(_told(tree(files))) == told


SET = "set(APP {})\n"


@pytest.mark.parametrize(
    ("lines", "told"),
    [
        (SET.format("a") + "add_executable(${APP} src/${APP}.cpp)\n", 0),
        (SET.format("b") + "add_executable(${APP} src/${APP}.cpp)\n", 1),
        (SET.format("c") + SET.format("a") + "add_executable(${APP} src/${APP}.cpp)\n", 0),
        ("add_executable(mine src/${APP}.cpp)\n" + SET.format("a"), 1),
        (SET.format("a") + "foreach(APP b c)\nadd_executable(${APP} src/${APP}.cpp)\nendforeach()\n", 1),
        (SET.format("a") + "if(X)\nset(APP b)\nendif()\nadd_executable(${APP} src/${APP}.cpp)\n", 1),
        (SET.format("a b") + "add_executable(mine src/${APP}.cpp)\n", 1),
    ],
)
def test_a_source_is_named_by_the_value_that_was_set_last(tree: Tree, lines: str, told: int) -> None:
    main = {"mine/src/a.cpp": "int main() {}\n"}
    files = _including("other/Lost.h", {**_package("mine", lines), **main}, file="mine/src/b.cpp")
    assert len(_told(tree(files))) == told
