"""Packages that do not compile: left out where the command needs none of them, and nothing else does."""

from __future__ import annotations

import io
from pathlib import Path

import pytest

from roslab.cli.repairing import given
from roslab.config.addition import added
from roslab.explain.answer import explain
from roslab.pipeline import plan_repository
from roslab.repair.leaving import Left, left_out, told
from trees import tree_of

PATH = "/home/jovyan/ws/src/robot/arm_extra/main.cpp"
ERROR = f"{PATH}:3:10: error: \u2018grip\u2019 was not declared; did you mean \u2018rip\u2019?"
WHY = "does not compile: 'grip' was not declared at arm_extra/main.cpp:3; "
DEMO = {"README.md": "# Arm\n\n```\nrosrun arm_demo arm_demo_node\n```\n"}
LAUNCH = {"README.md": "# Arm\n\n```\nroslaunch arm_demo demo.launch\n```\n"}


def package(name: str, *needs: str, role: str = "depend", files: dict[str, str] | None = None) -> dict[str, str]:
    depends = "".join(f"<{role}>{each}</{role}>" for each in needs)
    own = {
        "package.xml": f'<package format="2"><name>{name}</name><version>1.0.0</version>'
        f"<buildtool_depend>catkin</buildtool_depend>{depends}</package>",
        "CMakeLists.txt": f"cmake_minimum_required(VERSION 3.0)\nproject({name})\nfind_package(catkin REQUIRED)\n"
        f"catkin_package()\nadd_executable({name}_node main.cpp)\n",
        "main.cpp": "int main() {\n  // nothing\n  return grip();\n}\n",
        **(files or {}),
    }
    return {f"{name}/{path}": text for path, text in own.items()}


def log(*lines: str, command: str = "catkin_make -j2") -> str:
    said = "".join(f"#6 1.2 {line}\n" for line in lines)
    return f'#6 [3/4] RUN {command}\n{said}#6 ERROR: process "/bin/sh -c {command}" did not complete: exit code: 1\n'


def made(name: str) -> str:
    return f"make[2]: *** [robot/{name}/CMakeFiles/{name}_node.dir/build.make:76: x.o] Error 1"


def left(folder: Path, files: dict[str, str], text: str, config: str = "base: {ros: noetic}\n") -> Left:
    tree_of(folder / "robot", {**files, "roslab.yaml": f"format: 3\n{config}"})
    planned = plan_repository(folder / "robot")
    return left_out(explain(io.BytesIO(text.encode())), given(planned))


CODE = log(ERROR, made("arm_extra"))
TWO = {**package("arm_demo"), **package("arm_extra")}


def test_what_the_command_does_not_need_is_left_out_and_told(tmp_path: Path) -> None:
    found = left(tmp_path, {**TWO, **DEMO}, CODE)
    said = f"leaves out arm_extra, which {WHY}the command does not need it"
    assert list(told(found.changes)) == [said]
    text = added("format: 3\n", [change.entry for change in found.changes])
    assert text == f"format: 3\nskip_packages:\n  - arm_extra  # {WHY}the command does not need it\n"
    tree_of(tmp_path / "robot", {"roslab.yaml": text})
    assert plan_repository(tmp_path / "robot").decision.left_out == ("arm_extra",)


@pytest.mark.parametrize(
    ("text", "said"),
    [
        (log(ERROR, "Failed   <<< arm_extra [1.2s, exited with code 2]", command="colcon build"), WHY),
        (log(ERROR, "<== Failed to process package 'arm_extra':", command="catkin_make_isolated"), WHY),
        (log(ERROR, "Failed    <<< arm_extra   [ 1.2 seconds ]", command="catkin build"), WHY),
        (
            log(
                "CMake Error at robot/arm_extra/CMakeLists.txt:3 (find_package):",
                '  By not providing "Findnowhere.cmake" in CMAKE_MODULE_PATH',
            ),
            "does not compile: The ROS package nowhere is missing at arm_extra/CMakeLists.txt:3; ",
        ),
        (
            log(
                "CMake Error at CMakeLists.txt:3 (find_package):",
                '  By not providing "Findnowhere.cmake" in CMAKE_MODULE_PATH',
                "Failed   <<< arm_extra [1.2s, exited with code 1]",
                command="colcon build",
            ),
            "does not compile: The ROS package nowhere is missing at arm_extra/CMakeLists.txt:3; ",
        ),
        (
            log("/usr/bin/ld: main.cpp:(.text+0x5): undefined reference to `grip()'", made("arm_extra")),
            "does not compile: undefined reference to `grip()'; ",
        ),
    ],
)
def test_each_tool_and_each_kind_of_error(tmp_path: Path, text: str, said: str) -> None:
    (change,) = left(tmp_path, {**TWO, **DEMO, "CMakeLists.txt.in": ""}, text).changes
    assert change.value == "arm_extra"
    assert said in change.why


NODE = '<launch><node pkg="arm_extra" type="arm_extra_node" name="a"/></launch>\n'
INCLUDE = '<launch><include file="$(find arm_more)/more.launch"/></launch>\n'
DEEP = {
    **package(
        "arm_demo", files={"demo.launch": '<launch><node pkg="arm_demo" type="arm_demo_node" name="a"/></launch>\n'}
    ),
    **package("arm_extra"),
}


@pytest.mark.parametrize(
    ("files", "why"),
    [
        ({**TWO, "README.md": "```\nrosrun arm_extra arm_extra_node\n```\n"}, "the command needs arm_extra"),
        ({**DEEP, **package("arm_demo", "arm_extra"), **DEMO}, "the command needs arm_extra"),
        ({**TWO, **package("arm_demo", "arm_extra", role="exec_depend"), **DEMO}, "the command needs arm_extra"),
        ({**TWO, **package("arm_demo", files={"demo.launch": NODE}), **LAUNCH}, "the command needs arm_extra"),
        (
            {
                **TWO,
                **package("arm_demo", files={"demo.launch": INCLUDE}),
                **package("arm_more", files={"more.launch": NODE}),
                **LAUNCH,
            },
            "the command needs arm_extra",
        ),
        (
            {**TWO, **package("arm_demo", files={"main.cpp": "#include <arm_extra/Grip.h>\nint main() {}\n"}), **DEMO},
            "the command needs arm_extra",
        ),
        (
            {**TWO, **package("arm_demo", files={"node.py": "from arm_extra.msg import Grip\n"}), **DEMO},
            "the command needs arm_extra",
        ),
        (
            {**TWO, **package("arm_demo", files={"scripts/go": "rosrun arm_extra arm_extra_node\n"}), **DEMO},
            "the command needs arm_extra",
        ),
        (
            {**TWO, **package("arm_demo", files={"a.yaml": "type: arm_extra/Controller\n"}), **DEMO},
            "the command needs arm_extra",
        ),
        # The package that depends on it goes too, and that one is started
        (
            {**TWO, **package("arm_demo", "arm_mid"), **package("arm_mid", "arm_extra"), **DEMO},
            "the command needs arm_extra",
        ),
        # A shell: nothing tells what the image is for
        ({**TWO, **package("arm_mid", "arm_extra")}, "other packages need it"),
        (
            package("arm_extra", files={"CMakeLists.txt": "project(arm_extra)\nadd_library(arm_extra main.cpp)\n"}),
            "no other package would be left",
        ),
    ],
)
def test_what_is_needed_stays(tmp_path: Path, files: dict[str, str], why: str) -> None:
    found = left(tmp_path, files, CODE)
    assert found.changes == ()
    assert f"arm_extra does not compile, and {why}" in found.why


@pytest.mark.parametrize(
    ("files", "config"),
    [
        ({**TWO, "robot.sh": "#!/bin/sh\nrosrun arm_extra arm_extra_node\n"}, "command: ./robot.sh\n"),
        ({**TWO, **DEMO}, "test: rosrun arm_extra arm_extra_node --check\n"),
        ({**TWO, **package("arm_extra", files={"run.py": "print(1)\n"})}, "command: python3 arm_extra/run.py\n"),
    ],
)
def test_what_a_command_or_a_test_of_roslab_yaml_names_stays(
    tmp_path: Path, files: dict[str, str], config: str
) -> None:
    assert left(tmp_path, files, CODE, f"base: {{ros: noetic}}\n{config}").changes == ()


def test_what_needs_it_goes_with_it(tmp_path: Path) -> None:
    found = left(tmp_path, {**TWO, **package("arm_more", "arm_extra"), **DEMO}, CODE)
    (change,) = found.changes
    assert change.why.endswith("the command does not need it; with it arm_more, which cannot be built without it")


def test_of_a_shell_a_leaf_is_left_out_and_at_most_half(tmp_path: Path) -> None:
    found = left(tmp_path, TWO, CODE)
    assert [change.why for change in found.changes] == [f"{WHY}nothing else needs it"]
    both = log(ERROR, made("arm_extra"), made("arm_other"))
    found = left(tmp_path, {**TWO, **package("arm_other")}, both)
    assert found == Left(
        why="arm_extra, arm_other do not compile, and more than half of the packages would be left out"
    )


@pytest.mark.parametrize(
    "text",
    [
        log("write /usr/lib/a.so: No space left on device", made("arm_extra")),
        log("c++: fatal error: Killed signal terminated program cc1plus", made("arm_extra")),
        log(ERROR, made("clone_of_another")),
        log(ERROR, made("arm_extra"), made("clone_of_another")),
        log("E: Unable to locate package zoo", command="apt-get install zoo"),
        "Traceback (most recent call last):\nModuleNotFoundError: No module named 'arm_extra'\n",
    ],
)
def test_what_is_no_fault_of_the_repository_s_packages_leaves_nothing_out(tmp_path: Path, text: str) -> None:
    assert left(tmp_path, {**TWO, **DEMO}, text) == Left()


@pytest.mark.parametrize(
    ("config", "files"),
    [
        ("base: {ros: noetic}\nskip_packages: [arm_extra]\n", {}),
        ("dockerfile: Dockerfile\n", {"Dockerfile": "FROM ros:noetic\nCOPY . .\nRUN catkin_make\n"}),
        ("base: {ros: noetic}\nbuild: none\n", {}),
    ],
)
def test_not_twice_and_not_of_what_the_author_builds(tmp_path: Path, config: str, files: dict[str, str]) -> None:
    assert left(tmp_path, {**TWO, **DEMO, **files}, CODE, config) == Left()


SIGHT = {
    **TWO,
    "arm_extra/CMakeLists.txt": "project(arm_extra)\nfind_package(catkin REQUIRED)\nfind_package(acme-sight REQUIRED)\n"
    "catkin_package()\nadd_executable(arm_extra_node main.cpp)\n",
    "arm_extra/README.md": "Compile https://github.com/acme/acme-sight.\n",
}
STOPS = (
    "roslab: {} of https://github.com/acme/acme-sight, which arm_extra/README.md:1 names, cannot be {}: the build stops"
)


@pytest.mark.parametrize(
    ("page", "library", "step", "value"),
    [
        (DEMO, "acme-sight", "compiled", "arm_extra"),
        (DEMO, "acme-sight", "cloned", "arm_extra"),
        ({"README.md": DEMO["README.md"].replace("demo", "extra")}, "acme-sight", "compiled", ""),  # it is started
        (DEMO, "acme-hand", "compiled", ""),  # no package asks for it
        ({**package("arm_third"), "README.md": "# Arm\n"}, "acme-sight", "compiled", "arm_extra"),  # a shell is started
    ],
)
def test_what_asks_for_a_library_in_which_the_build_stopped(
    tmp_path: Path, page: dict[str, str], library: str, step: str, value: str
) -> None:
    error = "/tmp/sources/acme-sight/a.cpp:3:10: fatal error: Missing.h: No such file or directory"
    found = left(tmp_path, {**SIGHT, **page}, log(error, f"{STOPS.format(library, step)}, see above why"))
    assert [change.value for change in found.changes] == [value] * bool(value)
    started = "extra" in page["README.md"]
    assert found.why.startswith("acme-sight cannot be built, which arm_extra asks for, and the command needs" * started)
    assert bool(found.why) == started
    for change in found.changes:
        assert change.why.startswith(f"needs {library}, which cannot be built: ")
        tree_of(tmp_path / "robot", {"roslab.yaml": f"format: 3\nskip_packages: [{value}]\n"})
        assert plan_repository(tmp_path / "robot").plan.libraries == ()
