"""What the image runs when nothing is said, and for which platforms it can exist."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import pytest

from roslab.config.model import Config, Kind
from roslab.decide.command import decide_command
from roslab.decide.decision import Decision
from roslab.decide.platforms import decide_platforms
from roslab.decide.processor import OnX86
from roslab.decide.python.image_python import Python
from roslab.decide.python.installed import installed
from roslab.evidence import facts
from roslab.evidence.cmake_project import CMakeProject
from roslab.evidence.conda_environment import CondaEnvironment
from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import Evidence, Mention, RequirementFile
from roslab.evidence.launch_file import LaunchFile
from roslab.evidence.program import Program
from roslab.values.conda import conda_package
from roslab.values.requirement_line import stated

Tree = Callable[[dict[str, str]], Decision]
MAIN = Program(file="train.py", line=3, kind="main")
LAUNCH = LaunchFile(file="launch/a.launch", line=1, package="me", ros=1, dependencies=(), gui=True)


def run(value: str) -> Mention:
    return Mention(topic="command", value=value, source="readme", file="README.md", line=9, text=value)


def test_a_shell_where_several_could_be_meant() -> None:
    evidence = Evidence(programs=(MAIN, Program(file="eval.py", line=1, kind="main")))
    choice = decide_command(evidence, Config(), "python", None)
    assert choice.answer.command == ("bash",)
    assert choice.answer.candidates == (("python3", "train.py"), ("python3", "eval.py"))


def test_the_one_obvious_program() -> None:
    choice = decide_command(Evidence(programs=(MAIN,)), Config(), "python", None)
    assert choice.answer.command == ("python3", "train.py")
    choice = decide_command(Evidence(launch=(LAUNCH,)), Config(), "ros1", None)
    assert (choice.answer.command, choice.answer.gui) == (("roslaunch", "me", "a.launch"), True)


def test_a_launch_file_of_tests_starts_nothing() -> None:
    tests = replace(LAUNCH, file="launch/b.test", tests=2)
    named = replace(LAUNCH, file="launch/talker_launch_test.py")
    found = (facts.TestFile(file=named.file, line=1, runner="launch_test"),)
    choice = decide_command(Evidence(launch=(LAUNCH, tests, named), tests=found), Config(), "ros1", None)
    assert choice.answer.candidates == (("roslaunch", "me", "a.launch"),)


@pytest.mark.parametrize(
    "value",
    [
        "python other.py",
        "python train.py --data /path/to/data",
        "python -m venv x",
        "python setup.py install",
        "roslaunch a b",
    ],
)
def test_what_cannot_be_run_here_is_no_candidate(value: str) -> None:
    assert decide_command(Evidence(mentions=(run(value),)), Config(), "python", None).answer.candidates == ()


def test_the_readme_comes_first_and_the_configuration_wins() -> None:
    evidence = Evidence(
        programs=(MAIN, Program(file="b.py", line=1, kind="main")), mentions=(run("python train.py --go"),)
    )
    assert decide_command(evidence, Config(), "cuda", None).answer.command == ("python", "train.py", "--go")
    assert decide_command(evidence, Config(command="ls", gui=False), "cuda", None).answer.command == "ls"


def platforms(
    *lines: str, base: str = "ubuntu:22.04", kind: Kind = "python", ros: str | None = None, cuda: str | None = None
) -> tuple[str, ...]:
    found = tuple(stated(line, "manifest", "r.txt") for line in lines)
    file = RequirementFile(
        file="r.txt", line=1, requirements=found, includes=(), constraints=(), options=(), purpose="run"
    )
    python = Python(version="3.10", manager="venv", requirements=("r.txt",))
    evidence = Evidence(requirements=(file,))
    choice = decide_platforms(evidence, Config(), kind, base, ros, cuda, python, installed(evidence, python), OnX86())
    assert len(choice.answer.built) + len(choice.answer.refused) == 2
    return choice.answer.built


BOTH = ("linux/amd64", "linux/arm64")


def test_platforms() -> None:
    assert platforms("numpy") == BOTH
    assert platforms(base="ros:humble-ros-base", kind="ros2", ros="humble") == BOTH
    assert platforms(base="osrf/ros:noetic-desktop", kind="ros1", ros="noetic") == BOTH[:1]
    assert platforms(kind="cuda", cuda="11.8", base="nvidia/cuda:11.8.0-cudnn8-devel-ubuntu22.04") == BOTH[:1]
    assert platforms("open3d==0.12.0") == BOTH[:1]
    assert platforms("open3d==0.18.0") == BOTH
    assert platforms("mujoco-py") == BOTH[:1]


def test_conda_builds_of_one_platform() -> None:
    packages = tuple(package for package in [conda_package("numpy=1.2=py39h_0")] if package)
    environment = CondaEnvironment(file="e.yml", line=1, name=None, python="3.9", packages=packages, requirements=())
    python = Python(version="3.9", manager="conda", conda_file="e.yml")
    choice = decide_platforms(
        Evidence(conda=(environment,)), Config(), "python", "ubuntu:22.04", None, None, python, (), OnX86()
    )
    assert choice.answer.refused[0][0] == "linux/arm64"


def test_configured_platforms() -> None:
    config = Config(platforms=("linux/arm64",))
    python = Python(version=None, manager="system")
    assert decide_platforms(Evidence(), config, "ros1", "osrf/ros:x", None, None, python, (), OnX86()).answer.built == (
        "linux/arm64",
    )


def readme(value: str, line: int) -> Mention:
    return Mention(topic="command", value=value, source="readme", file="README.md", line=line, text=value)


def test_the_first_call_of_a_program_counts() -> None:
    mentions = (readme("python3 train.py --epochs 3", 5), readme("python3 train.py", 9))
    choice = decide_command(Evidence(programs=(MAIN,), mentions=mentions), Config(), "python", None)
    assert choice.answer.command == ("python3", "train.py", "--epochs", "3")


def test_the_only_program_that_cmake_compiles() -> None:
    project = CMakeProject(
        file="CMakeLists.txt", line=1, name="x", top_level=True, languages=("CXX",), macros=(),
        executables=(("align", 7), ("test_align", 9)), dependencies=(),
    )  # fmt: skip
    choice = decide_command(Evidence(cmake=(project,)), Config(), "cpp", None)
    assert choice.answer.command == ("align",)
    assert (choice.reasons[0].file, choice.reasons[0].line) == ("CMakeLists.txt", 7)


def test_a_command_whose_file_shows_a_picture_has_a_window() -> None:
    call = Dependency(namespace="call", name="matplotlib", strength="used", file="train.py", line=9)
    for file, gui in (("train.py", True), ("tools/plot.py", False)):
        evidence = Evidence(programs=(MAIN,), code=(replace(call, file=file),))
        assert decide_command(evidence, Config(), "python", None).answer.gui is gui


@pytest.mark.parametrize(
    ("more", "command"),
    [("", ("bash",)), ("# Usage\n```\nbash scripts/start_all.sh\n```\n", ("bash", "scripts/start_all.sh"))],
)
def test_a_script_that_the_build_runs_is_no_command(tree: Tree, more: str, command: tuple[str, ...]) -> None:
    scripts = {"scripts/build_lib.sh": "cmake -S lib -B out\nmake -C out\n", "scripts/start_all.sh": "python -m demo\n"}
    page = f"# Installation\n```\nbash scripts/build_lib.sh\n```\n{more}"
    own = {"setup.py": "from setuptools import setup\nsetup(name='demo', install_requires=['numpy'])\n"}
    root = "# Demo\nSee [the guide](docs/source/installation.md).\n```\npython gone.py\n```\n"
    decision = tree({**own, **scripts, "README.md": root, "docs/source/installation.md": page})
    assert [each.path for each in decision.scripts] == ["scripts/build_lib.sh"]
    assert decision.command == command
