"""Cloned packages that the author has the build pass over."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.config.model import Config
from roslab.decide.decision import Decision
from roslab.plan.plan import make_plan
from roslab.render.dockerfile import dockerfile

Tree = Callable[[dict[str, str]], Decision]
PACKAGE = "<package><name>{}</name><buildtool_depend>catkin</buildtool_depend>{}</package>"
FILES = {
    "demo/package.xml": PACKAGE.format("demo", "<depend>maps</depend>"),
    "demo/CMakeLists.txt": "project(demo)\nfind_package(catkin REQUIRED)\n",
    "viewer/package.xml": PACKAGE.format("viewer", ""),
    "viewer/CMakeLists.txt": "project(viewer)\nfind_package(catkin REQUIRED)\n",
    "deps.rosinstall": "- git: {local-name: maps, uri: 'https://github.com/lab/maps.git', version: '1.2'}\n",
}
START = "FROM ros:noetic\nWORKDIR /ws\nCOPY . src/demo\nRUN wstool merge src/demo/deps.rosinstall\n"
PAGE = "ROS Noetic\n```\ncd ~/catkin_ws\nwstool merge deps.rosinstall\n{}\ncatkin build\n```\n"


def marked(decision: Decision) -> dict[str, tuple[str, ...]]:
    return {source.name: source.marked for source in decision.source if source.marked}


@pytest.mark.parametrize(
    ("files", "expected"),
    [
        ({"Dockerfile": f"{START}RUN touch src/maps/CATKIN_IGNORE\n"}, {"maps": ("",)}),
        ({"docker/Dockerfile": f"{START}RUN touch /ws/src/maps/view/CATKIN_IGNORE\n"}, {"maps": ("view",)}),
        ({"README.md": PAGE.format("touch src/maps/view/CATKIN_IGNORE")}, {"maps": ("view",)}),
        ({"README.md": PAGE.format("cd src/maps\ntouch view/COLCON_IGNORE a/CATKIN_IGNORE")}, {"maps": ("view", "a")}),
        ({"README.md": PAGE.format("touch src/other/CATKIN_IGNORE")}, {}),
        ({"README.md": PAGE.format("touch src/maps/README")}, {}),
        ({"demo/README.md": PAGE.format("touch src/maps/CATKIN_IGNORE"), "README.md": "ROS Noetic\n"}, {}),
        ({"third_party/other/Dockerfile": f"{START}RUN touch src/maps/CATKIN_IGNORE\n"}, {}),
    ],
)
def test_what_is_marked(tree: Tree, files: dict[str, str], expected: dict[str, tuple[str, ...]]) -> None:
    assert marked(tree(FILES | files)) == expected


def test_a_package_of_the_tree(tree: Tree) -> None:
    files = FILES | {"docker/Dockerfile": f"{START}RUN touch src/demo/viewer/CATKIN_IGNORE\n"}
    decision = tree(files)
    assert decision.left_out == ("viewer",)
    assert any("the author's Dockerfile takes it out" in each.reason for each in decision.reasons)


def test_the_markers_are_made_before_the_manifests_are_read(tree: Tree) -> None:
    decision = tree(FILES | {"README.md": PAGE.format("touch src/maps/view/CATKIN_IGNORE")})
    text = dockerfile(make_plan(decision, Config(), folder_name="demo"))
    folder = "/home/${NB_USER}/ws/src/maps/view"
    step = f"RUN if [ -d {folder} ]; then touch {folder}/CATKIN_IGNORE {folder}/COLCON_IGNORE; fi\n"
    before, _, after = text.partition(step)
    assert "lab/maps.git" in before
    assert "&& install-rosdep-keys " in after
