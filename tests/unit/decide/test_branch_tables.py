"""A table of branches tells the distribution of the one that is checked out."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.config.model import Config
from roslab.decide import decide
from roslab.evidence.gather import gather
from roslab.repository.checkout import Repository

PACKAGE = (
    '<package format="3"><name>demo</name><buildtool_depend>ament_cmake</buildtool_depend>'
    "<export><build_type>ament_cmake</build_type></export></package>"
)
BUILD = "project(demo)\nfind_package(ament_cmake REQUIRED)\n"
ROWS = (
    "| Branch | ROS | Ubuntu |\n|---|:---:|---|\n"
    "| master | Jazzy | 24.04 |\n| main | Humble | 22.04 |\n| old | Foxy | 20.04 |\n"
)
LINKS = (
    "ROS Distro | Branch | Build status\n:---: | :---: | :---:\n"
    "**Jazzy** | [`jazzy`](https://github.com/me/d/tree/jazzy) | [![Jazzy](https://a/b.svg)](https://a/b)\n"
    "**Humble** | [`main`](https://github.com/me/d/tree/main) | [![Humble](https://a/c.svg)](https://a/c)\n"
)
COLUMNS = "| | Jazzy | Humble |\n|---|---|---|\n| Branch | `jazzy` | `main` |\n| Status | x | y |\n"
OTHERS = "| Package | Branch | ROS |\n|---|---|---|\n| talker | main | Humble |\n\nMade for ROS 2 Jazzy\n"
ENDED = "| Branch | ROS |\n|---|---|\n| main | Foxy (EOL) |\n| main | Jazzy |\n"


def distro_of(tmp_path: Path, page: str, branch: str | None, more: dict[str, str] | None = None) -> str | None:
    for path, text in {"package.xml": PACKAGE, "CMakeLists.txt": BUILD, "README.md": page, **(more or {})}.items():
        (tmp_path / path).write_text(text, encoding="utf-8")
    return decide(gather(Repository.open(tmp_path, branch=branch)), Config(), folder_name="demo").ros_distro


@pytest.mark.parametrize(
    ("page", "branch", "distro"),
    [
        (ROWS, "main", "humble"),
        (ROWS, "old", "foxy"),
        (ROWS, "master", "jazzy"),
        (ROWS, None, "jazzy"),
        (ROWS, "maintenance", "jazzy"),
        (LINKS, "main", "humble"),
        (LINKS, None, "jazzy"),
        (COLUMNS, "main", "humble"),
        (OTHERS, "main", "jazzy"),
        (ENDED, "main", "jazzy"),
    ],
)
def test_the_distribution_of_the_branch_checked_out(tmp_path: Path, page: str, branch: str, distro: str) -> None:
    assert distro_of(tmp_path, page, branch) == distro


def test_what_is_built_there_tells_more(tmp_path: Path) -> None:
    assert distro_of(tmp_path, ROWS, "main", {"Dockerfile": "FROM ros:jazzy\nCOPY . /ws/src\n"}) == "jazzy"
