"""A package that compiles a file which the tree does not have cannot be configured: the others are built without it."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]


def package(name: str, *lines: str, needs: str = "rclcpp", folder: str = "") -> dict[str, str]:
    asks = f"<buildtool_depend>ament_cmake</buildtool_depend><depend>{needs}</depend>"
    xml = f"<package><name>{name}</name>{asks}</package>"
    code = "\n".join((f"project({name})", "find_package(ament_cmake REQUIRED)", *lines, "ament_package()", ""))
    place = f"{folder}{name}"
    return {f"{place}/package.xml": xml, f"{place}/CMakeLists.txt": code, f"{place}/src/{name}.cpp": "int main() {}\n"}


ARM = package("arm", "add_executable(arm src/arm.cpp)")


@pytest.mark.parametrize(
    ("lines", "left"),
    [
        (("add_executable(eye eye.cpp)",), True),
        (("add_library(eye ${CMAKE_CURRENT_SOURCE_DIR}/eye.cpp)",), True),
        (("add_executable(eye src/eye.cpp)",), False),
        (("if(WITH_EYE)", "add_executable(eye eye.cpp)", "endif()"), False),
        (("add_custom_command(OUTPUT eye.cpp COMMAND make_eye)", "add_executable(eye eye.cpp)"), False),
        (("execute_process(COMMAND python3 make_eye.py)", "add_executable(eye eye.cpp)"), False),
        (("set(CODE eye.cpp)", "add_executable(eye ${CODE})"), False),
        (("add_executable(eye ${CMAKE_BINARY_DIR}/eye.cpp)",), False),
        (("add_executable(eye lib/eye.cpp)",), False),
    ],
)
def test_a_package_without_its_code(tree: Tree, lines: tuple[str, ...], *, left: bool) -> None:
    modules = {".gitmodules": '[submodule "l"]\n\tpath = eye/lib\n\turl = https://github.com/lab/l.git\n'}
    decision = tree({**ARM, **package("eye", *lines), **modules})
    assert decision.left_out == (("eye",) if left else ())
    told = [
        each.message for each in decision.warnings if "does not have" in each.message and "compiles" in each.message
    ]
    missing = "CMake compiles eye/eye.cpp, which the tree does not have: eye is left out of the build"
    assert told == ([f"{missing}; add the file, or correct the path"] if left else [])


HOME = "/home/mia/sim"


@pytest.mark.parametrize(
    ("lines", "left"),
    [
        ((f"add_subdirectory({HOME}/cmake/rpc rpc)",), True),
        ((f"set(SIM {HOME}/)", 'add_subdirectory("${SIM}/cmake/rpc" rpc)'), True),
        ((f"include({HOME}/cmake/rpc.cmake)",), True),
        ((f"include({HOME}/cmake/rpc.cmake OPTIONAL)",), False),
        ((f"set(SIM {HOME} CACHE PATH where)", "add_subdirectory(${SIM}/cmake/rpc rpc)"), False),
        (("option(SIM sim OFF)", "if(SIM)", f"add_subdirectory({HOME}/cmake/rpc rpc)", "endif()"), False),
        ((f"function(later)\nadd_subdirectory({HOME}/rpc)\nendfunction()",), False),
        (("add_subdirectory(/usr/src/googletest gtest)",), False),
        (("add_subdirectory(/home/mia/ws/src/lab/eye/src)",), False),
        ((f"# add_subdirectory({HOME}/cmake/rpc rpc)",), False),
    ],
)
def test_a_package_that_adds_a_folder_of_its_authors_computer(
    tree: Tree, lines: tuple[str, ...], *, left: bool
) -> None:
    decision = tree({**ARM, **package("eye", *lines, "add_executable(eye src/eye.cpp)")})
    assert decision.left_out == (("eye",) if left else ())
    told = [each.message for each in decision.warnings if each.message.startswith("CMake adds")]
    what = "a folder of its author's computer: eye is left out of the build; add the folder to the tree"
    assert len(told) == left
    assert all(each.endswith(what) for each in told)


LINKED = "target_link_libraries(eye {})"


@pytest.mark.parametrize(
    ("lines", "left"),
    [
        ((LINKED.format(f"pthread {HOME}/lib/librpc.so"),), True),
        ((f"set(RPC {HOME}/lib/librpc.so.1)", LINKED.format("${RPC}")), True),
        ((f"link_libraries({HOME}/lib/librpc.a)",), True),
        ((f"set(RPC {HOME}/lib/librpc.so CACHE PATH where)", LINKED.format("${RPC}")), False),
        ((f"if(RPC)\n{LINKED.format(f'{HOME}/lib/librpc.so')}\nendif()",), False),
        ((LINKED.format(f"-L{HOME}/lib"),), False),
        ((LINKED.format(f"{HOME}/lib"),), False),
        ((LINKED.format("/home/mia/ws/src/eye/lib/librpc.so"),), False),
        ((LINKED.format("/usr/lib/librpc.so"),), False),
    ],
)
def test_a_package_that_links_a_library_of_its_authors_computer(
    tree: Tree, lines: tuple[str, ...], *, left: bool
) -> None:
    code = package("eye", "add_executable(eye src/eye.cpp)", *lines)
    decision = tree({**ARM, **code, "eye/lib/librpc.so": ""})
    assert decision.left_out == (("eye",) if left else ())
    told = [
        each.message for each in decision.warnings if each.message.startswith("CMake links /home/mia/sim/lib/librpc")
    ]
    what = "a file of its author's computer: eye is left out of the build; add the library to the tree"
    assert len(told) == left
    assert all(each.endswith(what) for each in told)


def test_a_command_that_needs_what_is_left_out_is_told(tree: Tree) -> None:
    def nodes(*names: str) -> str:
        return "".join(f'<node name="{each}" pkg="{each}" type="{each}"/>' for each in names)

    told = "the default command needs eye, which is left out of the build"
    for names in (("arm",), ("arm", "eye")):
        arm = catkin("arm", "add_executable(arm src/arm.cpp)", all=nodes(*names))
        eye = catkin("eye", "find_package(AcmeSight REQUIRED)", "add_executable(eye src/eye.cpp)")
        code = {"arm/src/arm.cpp": "int main() {}\n", "eye/src/eye.cpp": "int main() {}\n"}
        decision = tree({**arm, **eye, **code, "README.md": "ROS Noetic\n```\nroslaunch arm all.launch\n```\n"})
        assert decision.left_out == ("eye",)
        places = [each.file for each in decision.warnings if each.message.startswith(told)]
        assert places == (["arm/launch/all.launch"] if "eye" in names else [])


def test_headers_of_what_is_left_out_are_not_told(tree: Tree) -> None:
    code = {"eye/src/eye.cpp": '#include "simulator/rpc.hpp"\nint main() {}\n'}
    compiled = "add_executable(eye src/eye.cpp)"
    assert any("rpc.hpp" in w.message for w in tree({**ARM, **package("eye", compiled), **code}).warnings)
    files = {**ARM, **package("eye", f"add_subdirectory({HOME}/rpc rpc)", compiled), **code}
    assert not any("rpc.hpp" in each.message for each in tree(files).warnings)


def catkin(name: str, *lines: str, **launches: str) -> dict[str, str]:
    xml = f"<package><name>{name}</name><buildtool_depend>catkin</buildtool_depend></package>"
    code = "\n".join((f"project({name})", "find_package(catkin REQUIRED)", *lines, "catkin_package()", ""))
    files = {f"{name}/launch/{file}.launch": f"<launch>{text}</launch>\n" for file, text in launches.items()}
    return {f"{name}/package.xml": xml, f"{name}/CMakeLists.txt": code, **files}


@pytest.mark.parametrize(("sim", "answer"), [("/home/mia/sim/rpc", "plan"), ("rpc", "all")])
def test_a_launch_file_that_needs_none_of_them_is_meant_first(tree: Tree, sim: str, answer: str) -> None:
    node = '<node name="{0}" pkg="{0}" type="{0}"/>'
    whole = '<include file="$(find eye)/launch/eye.launch"/>' + node.format("arm")
    arm = catkin("arm", "add_executable(arm src/arm.cpp)", all=whole, plan=node.format("arm"))
    eye = catkin("eye", f"add_subdirectory({sim} rpc)", "add_executable(eye src/eye.cpp)", eye=node.format("eye"))
    code = {"arm/src/arm.cpp": "int main() {}\n", "eye/src/eye.cpp": "int main() {}\n"}
    page = "```\nroslaunch arm all.launch\n```\n```\nroslaunch arm plan.launch\n```\n"
    made = {"eye/rpc/CMakeLists.txt": "add_library(rpc rpc.cpp)\n", "eye/rpc/rpc.cpp": "\n"}
    decision = tree({**arm, **eye, **code, **made, "README.md": page})
    assert decision.command == ("roslaunch", "arm", f"{answer}.launch")
    assert decision.left_out == (("eye",) if answer == "plan" else ())


@pytest.mark.parametrize(("line", "left"), [("", ()), ("add_subdirectory(lid)", ("eye",))])
def test_a_package_inside_of_another_is_not_configured(tree: Tree, line: str, left: tuple[str, ...]) -> None:
    eye = package("eye", "add_executable(eye src/eye.cpp)", line)
    assert tree({**ARM, **eye, **package("lid", "add_executable(lid lid.cpp)", folder="eye/")}).left_out == left


def test_what_needs_it_goes_with_it(tree: Tree) -> None:
    hand = package("hand", "add_executable(hand src/hand.cpp)", needs="eye")
    decision = tree({**ARM, **hand, **package("eye", "add_executable(eye eye.cpp)")})
    assert decision.left_out == ("eye", "hand")


@pytest.mark.parametrize("page", ["", "ros2 run eye eye\n"])
def test_where_nothing_else_is_built_it_is_told(tree: Tree, page: str) -> None:
    files = package("eye", "add_executable(eye eye.cpp)") | (ARM if page else {})
    decision = tree({**files, "README.md": f"```\n{page}```\n"})
    assert not decision.left_out
    assert any("colcon will stop at eye" in each.message for each in decision.warnings)


PAGE = "```\ncd {}\ncolcon build\n```\n"


@pytest.mark.parametrize(
    ("page", "more", "spare"),
    [
        (PAGE.format("ros2_ws"), {}, ("eye",)),
        (PAGE.format("~/workspaces/ros2_ws"), {}, ("eye",)),
        (PAGE.format("~/other_ws"), {}, ()),
        ("```\ncolcon build\n```\n", {}, ()),
        (PAGE.format("ros2_ws") + PAGE.format("eye_ws"), package("nose", folder="eye_ws/src/"), ()),
        (PAGE.format("ros2_ws") + "```\nros2 run eye eye\n```\n", {}, ()),
        (PAGE.format("ros2_ws"), package("hand", needs="eye", folder="ros2_ws/src/"), ()),
    ],
)
def test_a_package_outside_of_the_workspace_of_the_page_may_fail(
    tree: Tree, page: str, more: dict[str, str], spare: tuple[str, ...]
) -> None:
    inside = package("arm", "add_executable(arm src/arm.cpp)", folder="ros2_ws/src/")
    decision = tree({**inside, **package("eye", "add_executable(eye src/eye.cpp)"), **more, "README.md": page})
    assert decision.may_fail == spare
