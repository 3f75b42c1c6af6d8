"""The script that takes the branch of a clone which holds the messages and headers that the code includes."""

from __future__ import annotations

import os
import subprocess
from pathlib import Path

import pytest

from roslab.pipeline import plan_repository
from roslab.render.dockerfile import dockerfile
from trees import tree_of

pytestmark = pytest.mark.usefixtures("scripts_on_path")
XML = '<package format="2"><name>{}</name><buildtool_depend>catkin</buildtool_depend></package>\n'
ROS2 = XML.replace("catkin", "ament_cmake")


def _git(folder: Path, *words: str, day: str = "2019-05-20") -> None:
    identity = ("-c", "user.name=a", "-c", "user.email=a@b.c", "-c", "init.defaultBranch=main")
    dates = {"GIT_AUTHOR_DATE": f"{day}T12:00:00Z", "GIT_COMMITTER_DATE": f"{day}T12:00:00Z"}
    subprocess.run(["git", *identity, *words], cwd=folder, env=os.environ | dates, check=True, capture_output=True)


@pytest.fixture
def workspace(tmp_path: Path) -> Path:
    """Return a workspace with a clone: acme_msgs has Pose, the branch devel a message more, newest yet another."""
    remote, folder = tmp_path / "remote", tmp_path / "ws/src"
    (remote / "acme_msgs/msg").mkdir(parents=True)
    (remote / "acme_msgs/package.xml").write_text(XML.format("acme_msgs"))
    (remote / "acme_msgs/msg/Pose.msg").write_text("int8 a\n")
    for file in ("include/acme_msgs/Frames.h", "cfg/Gripper.cfg"):
        (remote / "acme_msgs" / file).parent.mkdir(parents=True)
        (remote / "acme_msgs" / file).write_text("\n")
    (remote / "acme/include/acme").mkdir(parents=True)
    (remote / "acme/include/acme/config.h.in").write_text("\n")
    (remote / "acme/package.xml").write_text(XML.format("acme"))
    _git(remote, "init", "--quiet")
    for branch, name, day in (
        ("main", "", "2019-05-20"),
        ("devel", "Grip", "2020-01-01"),
        ("newest", "Lift", "2022-01-01"),
        ("ros2", "Twin", "2023-01-01"),
    ):
        if name:
            _git(remote, "checkout", "--quiet", "-b", branch, "main")
            (remote / f"acme_msgs/msg/{name}.msg").write_text("int8 a\n")
            (remote / f"acme/include/acme/{name.lower()}.hpp").write_text("\n")
        if branch == "newest":
            (remote / "acme/include/acme/other.hpp").write_text("\n")
        if branch == "ros2":
            (remote / "acme/package.xml").write_text(ROS2.format("acme"))
        _git(remote, "add", ".", day=day)
        _git(remote, "commit", "--quiet", "--message", branch, day=day)
    _git(remote, "checkout", "--quiet", "main")
    folder.mkdir(parents=True)
    _git(folder, "clone", "--quiet", remote.as_uri(), "acme")
    return folder


def _run(workspace: Path, *words: str) -> tuple[str, set[str]]:
    """Return what the script says, and the messages that the clone then has."""
    answer = subprocess.run(["take-message-branches", *words], capture_output=True, text=True, check=True)
    return answer.stdout, {file.stem for file in workspace.rglob("*.msg")}


@pytest.mark.parametrize(
    ("interfaces", "has", "said"),
    [
        (("acme_msgs/Pose",), {"Pose"}, ""),
        (("acme_msgs/pose", "acme_msgs/PoseRequest", "acme/Lost"), {"Pose"}, "includes Lost of acme,"),
        (("acme_msgs/Grip",), {"Pose", "Grip"}, "its branch devel is taken"),
        (("acme_msgs/grip", "acme_msgs/Pose"), {"Pose", "Grip"}, "its branch devel is taken"),
        (("acme_msgs/Lift",), {"Pose", "Lift"}, "its branch newest is taken"),
        (("acme_msgs/Grip", "acme_msgs/Lift"), {"Pose"}, "what includes that cannot be built"),
        (("acme_msgs/Lost",), {"Pose"}, "includes Lost of acme_msgs, which acme does not have"),
        (("other_msgs/Lost",), {"Pose"}, ""),
        (("acme_msgs/Frames",), {"Pose"}, ""),  # a header of its own
        (("acme_msgs/GripperConfig",), {"Pose"}, ""),  # of dynamic_reconfigure
        (("acme/grip.hpp",), {"Pose", "Grip"}, "includes grip.hpp of acme, which acme does not have: its branch devel"),
        (("acme/grip.hpp", "acme/config.h"), {"Pose", "Grip"}, "its branch devel is taken"),
        (("acme/grip.hpp", "acme/made.h"), {"Pose", "Grip"}, "its branch devel is taken"),  # CMake may make one
        (("acme/config.h", "acme/made.h", "acme_msgs/Pose.h"), {"Pose"}, ""),
        (("acme/twin.hpp",), {"Pose"}, ""),  # of the other ROS
        (("acme/other.hpp",), {"Pose", "Lift"}, "its branch newest is taken"),
    ],
)
def test_the_branch_with_the_messages(workspace: Path, interfaces: tuple[str, ...], has: set[str], said: str) -> None:
    told, found = _run(workspace, str(workspace), *interfaces)
    assert found == has
    assert said in told
    assert bool(told) == bool(said)


def test_a_day_and_a_given_commit(workspace: Path) -> None:
    told, found = _run(workspace, "--before", "2021-01-01", str(workspace), "acme_msgs/Lift")
    assert (found, "cannot be built" in told) == ({"Pose"}, True)
    told, found = _run(workspace, "--keep", "other", "--keep", "acme", str(workspace), "acme_msgs/Grip")
    assert (found, "cannot be built" in told) == ({"Pose"}, True)


@pytest.mark.parametrize(
    ("include", "called"),
    [
        ("acme_msgs/Grip.h", " acme_msgs/Grip\n"),
        ("acme_msgs/msg/grip__struct.hpp", " acme_msgs/grip\n"),
        ("sensor_msgs/Imu.h", ""),
        ("other_msgs/Own.h", ""),
        ("acme_msgs/detail/grip.hpp", " acme_msgs/grip.hpp\n"),
        ("boost/grip.hpp", ""),
        ("other_msgs/grip.hpp", ""),
    ],
)
def test_the_image_looks_for_what_the_code_includes(tmp_path: Path, include: str, called: str) -> None:
    packages = {
        f"{name}/{file}": text
        for name in ("mine", "other_msgs")
        for file, text in (
            ("package.xml", f"<package><name>{name}</name><buildtool_depend>catkin</buildtool_depend></package>"),
            ("CMakeLists.txt", f"project({name})\nfind_package(catkin REQUIRED)\ncatkin_package()\n"),
        )
    }
    packages["mine/CMakeLists.txt"] += "add_executable(a src/a.cpp)\n"
    page = "ROS Noetic\n```\ncd src\ngit clone https://github.com/lab/acme_msgs\ncd ..\ncatkin_make\n```\n"
    manifest = packages["mine/package.xml"].replace("</package>", "<build_depend>acme_msgs</build_depend></package>")
    files = {"mine/src/a.cpp": f"#include <{include}>\nint main() {{}}\n", "mine/package.xml": manifest}
    tree_of(tmp_path, {**packages, **files, "README.md": page})
    text = dockerfile(plan_repository(tmp_path).plan)
    line = next((each for each in text.split("\n") if each.startswith("RUN take-message-branches ")), "")
    assert bool(line) == bool(called)
    assert f"{line}\n".endswith(called or "\n")
