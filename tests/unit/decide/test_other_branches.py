"""Sections of a page, and workflows, that are for another branch than the one checked out."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import pytest

from roslab.config.model import Config
from roslab.decide import decide
from roslab.decide.decision import Decision
from roslab.evidence.gather import gather
from roslab.repository.checkout import Repository

PACKAGE = "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend></package>"
URL = "https://github.com/me/demo.git"
PAGE = f"""\
# Demo

Install on Ubuntu 20.04 with ROS Noetic
---------------------------------------
### Packages
```
sudo apt install ros-noetic-joy gazebo9
```
### Code
```
git clone -b dev/noetic {URL}
```

Install on Ubuntu 16.04 with ROS Kinetic
----------------------------------------
```
sudo apt install ros-kinetic-joy libglog-dev
git clone {URL}
```

Ubuntu 16.04 with Gazebo 9
--------------------------
```
sudo apt install libgazebo9-dev
cd ~/ws/src/demo
git checkout dev/gazebo9
```
"""
RELEASE = f"""\
# Demo
Tested with ROS Melodic

## Install
```
git clone -b v1.2 {URL}
sudo apt install libglog-dev
```
## Develop
```
git clone {URL}
```
"""
WORKFLOW = "on:\n  push:\n    branches: ['dev/noetic']\njobs:\n  build:\n    name: ROS Noetic\n"


@dataclass(frozen=True, slots=True)
class Case:
    """A page, and what is taken of it for a branch."""

    page: str
    branch: str
    distro: str
    installed: str
    not_installed: tuple[str, ...] = ()


def decided(folder: Path, page: str, branch: str) -> Decision:
    root = folder / "demo"
    files = {"package.xml": PACKAGE, "CMakeLists.txt": "project(demo)\n", "README.md": page}
    for path, text in (files | ({".github/workflows/noetic.yml": WORKFLOW} if page is PAGE else {})).items():
        (root / path).parent.mkdir(parents=True, exist_ok=True)
        (root / path).write_text(text, encoding="utf-8")
    return decide(gather(Repository.open(root, branch=branch)), Config(), folder_name="demo")


@pytest.mark.parametrize(
    "case",
    [
        Case(PAGE, "master", "kinetic", "libglog-dev", ("gazebo9", "libgazebo9-dev")),
        Case(PAGE, "dev/noetic", "noetic", "gazebo9", ("libglog-dev", "libgazebo9-dev")),
        Case(RELEASE, "master", "melodic", "libglog-dev"),
    ],
)
def test_a_section_that_clones_another_branch_is_for_that(tmp_path: Path, case: Case) -> None:
    decision = decided(tmp_path, case.page, case.branch)
    assert decision.ros_distro == case.distro
    assert case.installed in decision.apt_guessed
    assert not {*case.not_installed} & {*decision.apt, *decision.apt_guessed}


def test_a_distribution_that_is_not_recommended_is_not_recommended(tmp_path: Path) -> None:
    page = "Developed with ROS Melodic.\nROS Kinetic works, but such a setup is not recommended.\n"
    assert decided(tmp_path, page, "master").ros_distro == "melodic"
