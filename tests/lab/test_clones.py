"""Repositories that a workspace clones: what they need in turn is cloned, and what nothing needs stops no build."""

from __future__ import annotations

import subprocess
import sys
import time
import uuid
from collections.abc import Callable, Iterator
from pathlib import Path
from subprocess import CompletedProcess

import pytest

from lab import doors, git_hosts
from lab.home import HERE
from lab.laboratory import Laboratory

WHO = ("-c", "user.name=a", "-c", "user.email=a@example.org", "-c", "commit.gpgsign=false")
PORT = 5017
CMAKE = """\
cmake_minimum_required(VERSION 3.0)
project({name} NONE)
find_package(catkin REQUIRED{components})
{more}catkin_package()
"""
MANIFEST = """\
<package format="2">
<name>{name}</name><version>1.0.0</version><description>d</description><license>MIT</license>
<maintainer email="m@example.org">m</maintainer><buildtool_depend>catkin</buildtool_depend>
{depends}</package>
"""


def _package(name: str, *needed: str, folder: str = "", more: str = "") -> dict[str, str]:
    """Return the files of a package of ROS 1 that needs others and compiles nothing."""
    at = f"{folder}/" if folder else ""
    components = f" COMPONENTS {' '.join(needed)}" if needed else ""
    depends = "".join(f"<depend>{each}</depend>\n" for each in needed)
    return {
        f"{at}CMakeLists.txt": CMAKE.format(name=name, components=components, more=more),
        f"{at}package.xml": MANIFEST.format(name=name, depends=depends),
    }


@pytest.fixture
def host(lab: Laboratory, tmp_path: Path) -> Iterator[str]:
    """Serve the repositories of an owner where a build reaches them, and return the owner's address.

    Nobody was called so before: a step from the engine's cache says nothing.
    """
    owner = f"code.example/lab-{uuid.uuid4().hex[:8]}"
    repositories = {
        "tools": {
            **_package("lab_filters", "lab_numbers", folder="lab_filters"),
            **_package("lab_pages", folder="lab_pages", more="find_package(NoSuchThing REQUIRED)\n"),
        },
        "lab_numbers": _package("lab_numbers"),
    }
    for name, files in repositories.items():
        folder = doors.write(tmp_path / "hosts" / owner / name, files)
        for words in (["init", "--quiet"], ["add", "--all"], [*WHO, "commit", "--quiet", "--message", "All"]):
            subprocess.run(["git", *words], cwd=folder, check=True, capture_output=True)
    ip = git_hosts.bridge(dict(lab.environment))
    command = [sys.executable, str(HERE / "git_server.py"), str(tmp_path / "hosts"), ip, str(PORT)]
    server = subprocess.Popen(command, stderr=subprocess.DEVNULL)
    try:
        while not git_hosts.answers(f"{ip}:{PORT}"):
            assert server.poll() is None
            time.sleep(0.05)
        yield f"http://{ip}:{PORT}/{owner}"
    finally:
        server.terminate()
        server.wait()


def test_a_clone_gets_what_it_needs_and_its_other_packages_stop_nothing(
    lab: Laboratory, roslab: Callable[..., CompletedProcess[str]], tmp_path: Path, host: str
) -> None:
    files = _package("lab_robot", "lab_filters") | {
        "roslab.yaml": "format: 3\nkind: ros1\nbase: {ros: noetic}\n"
        f"source: [{{name: tools, repo: '{host}/tools', build: catkin_make}}]\n"
        "test: cd ~/ws/devel/share && ls lab_robot lab_filters lab_numbers && ! ls lab_pages\n",
    }
    folder = doors.write(tmp_path / "lab_robot", files)
    answer = roslab("build", folder, "--tag", "repro-lab", env=lab.environment, timeout=900)
    assert answer.returncode == 0, answer.stderr[-4000:]
    assert f"roslab: {host}/lab_numbers brings lab_numbers" in answer.stderr
    assert "roslab: left out: lab_pages" in answer.stderr
