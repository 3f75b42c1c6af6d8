"""A repository that only a page below the root has cloned: where it cannot be had, the image goes without."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.pipeline import plan_repository
from roslab.render.dockerfile import dockerfile

FILES = {
    "arm/package.xml": "<package><name>arm</name><buildtool_depend>catkin</buildtool_depend>"
    "<depend>acme_msgs</depend></package>",
    "arm/CMakeLists.txt": "project(arm)\nfind_package(catkin REQUIRED COMPONENTS acme_msgs)\n",
}
PAGE = "ROS Noetic\n```\ncd ~/catkin_ws/src\ngit clone https://github.com/acme/acme_msgs.git\n```\n"


@pytest.mark.parametrize(
    ("page", "tolerated"),
    [("arm/README.md", True), ("README.md", False), ("docs/install.md", False)],
)
def test_it_is_told_and_stops_nothing(tmp_path: Path, page: str, *, tolerated: bool) -> None:
    for path, text in (FILES | {page: PAGE}).items():
        (tmp_path / path).parent.mkdir(exist_ok=True)
        (tmp_path / path).write_text(text)
    text = dockerfile(plan_repository(tmp_path).plan)
    assert ("RUN clone-listed --ros1 --plain https://github.com/acme/acme_msgs.git" in text) != tolerated
    assert ("{ git clone https://github.com/acme/acme_msgs.git" in text) == tolerated
    assert ("roslab: left out: acme_msgs cannot be cloned" in text) == tolerated
