"""One letter of a name stands for a number: the lowest of the files that fit is meant."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision
from roslab.values.numbered import first_of_its_kind, numbered

Tree = Callable[[dict[str, str]], Decision]
MANIFEST = (
    "<package format='2'><name>{}</name><version>0.1.0</version><description>d</description>"
    "<maintainer email='a@b.c'>a</maintainer><license>MIT</license>"
    "<buildtool_depend>catkin</buildtool_depend></package>"
)
CMAKE = "cmake_minimum_required(VERSION 3.0)\nproject({})\nfind_package(catkin REQUIRED)\ncatkin_package()\n"
PROGRAM = "if __name__ == '__main__':\n    print(1)\n"


def package(name: str, *launched: str) -> dict[str, str]:
    files = {"package.xml": MANIFEST.format(name), "CMakeLists.txt": CMAKE.format(name)}
    files |= {f"launch/{each}.launch": "<launch/>\n" for each in launched}
    return {f"{name}/{path}": text for path, text in files.items()}


@pytest.mark.parametrize(
    ("name", "found"),
    [
        ("demox.launch", "demo2.launch"),
        ("demoX.launch", "demo2.launch"),
        ("demoN.launch", "demo2.launch"),
        ("demo#.launch", "demo2.launch"),
        ("demo*.launch", "demo2.launch"),
        ("demo.launch", ""),
        ("demox.launch.py", ""),
        ("x.launch", ""),
        ("matrix.launch", ""),
    ],
)
def test_a_letter_for_a_number(name: str, found: str) -> None:
    assert numbered(name, ["demo10.launch", "demo2.launch", "1.launch", "demo_a.launch"]) == found


def test_the_first_of_those_that_differ_in_a_number() -> None:
    assert first_of_its_kind("demo6.launch", ["demo6.launch", "demo10.launch", "demo2.launch", "a1.launch"]) == (
        "demo2.launch"
    )


@pytest.mark.parametrize(
    ("said", "command", "hint"),
    [
        ("roslaunch demo runx.launch", "roslaunch demo run1.launch", ""),
        ("roslaunch demo runx.launch #(x=1,2)", "roslaunch demo run1.launch", ""),
        ("roslaunch demo run7.launch", "bash", "it has run1.launch"),
        ("roslaunch demo mapx.launch", "bash", ""),
    ],
)
def test_the_lowest_launch_file_is_started(tree: Tree, said: str, command: str, hint: str) -> None:
    files = {
        **package("demo", "run3", "run1", "run2", "yours"),
        "README.md": f"ROS Noetic\n\n# Use\n```sh\n{said}\n```\n",
    }
    decision = tree(files)
    assert " ".join(decision.command) == command
    told = [w.message for w in decision.warnings if "has no such launch file" in w.message]
    assert [hint in message for message in told] == [True] * (command == "bash")


@pytest.mark.parametrize(
    ("said", "command"),
    [
        ("python3 stepN.py", "python3 step1.py"),
        ("python3 stepx.py", "python3 step1.py"),
        ("./runx.sh", "bash run3.sh"),
        ("python3 step2.py --config config/robotX.yaml", "python3 step2.py --config config/robot1.yaml"),
        ("python3 step2.py --config config/otherX.yaml", "python3 step2.py --config config/otherX.yaml"),
    ],
)
def test_so_are_programs_and_settings(tree: Tree, said: str, command: str) -> None:
    files = {"step1.py": PROGRAM, "step2.py": PROGRAM, "run3.sh": "python3 step1.py\n", "config/robot1.yaml": "a: 1\n"}
    assert " ".join(tree({**files, "README.md": f"# Use\n```\n{said}\n```\n"}).command) == command


def test_a_package_of_which_a_page_launches_something_is_kept(tree: Tree) -> None:
    names = [f"part_{letter}" for letter in "abcdefgh"]
    files = {path: text for name in names for path, text in package(name).items()}
    page = "ROS Noetic\n\n# Use\n```\nroslaunch part_c gone.launch\n```\n"
    decision = tree({**files, "README.md": page})
    assert decision.command == ("bash",)
    assert "part_c" not in decision.spare
    assert "part_d" in decision.spare
    assert decision.must_build == ("part_c",)
