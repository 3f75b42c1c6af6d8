"""A Dockerfile that removes a clone before it clones another repository into the same folder."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
FIRST, SECOND = "https://github.com/ann/arm.git", "https://github.com/lab/arm.git"


def _tree(steps: str) -> dict[str, str]:
    manifest = (
        "<package><name>mine</name><buildtool_depend>catkin</buildtool_depend><depend>arm_control</depend></package>"
    )
    lines = ["mkdir -p /ws/src", "cd /ws/src", *steps.splitlines()]
    return {
        "package.xml": manifest,
        "CMakeLists.txt": "project(mine)\nfind_package(catkin REQUIRED arm_control)\ncatkin_package()\n",
        "README.md": "ROS Noetic\n",
        "docker/Dockerfile": f"FROM osrf/ros:noetic-desktop\nRUN {' && '.join(lines)}\nCOPY . /ws/src/mine\n",
    }


@pytest.mark.parametrize(
    ("steps", "cloned", "parts"),
    [
        (f"git clone {FIRST}\nrm -rf arm\ngit clone {SECOND}", [SECOND], {}),
        (
            f"git clone {FIRST}\ncp -r arm/arm_description/ .\nrm -rf arm\ngit clone {SECOND}",
            [SECOND],
            {FIRST: ("arm_description",)},
        ),
        (
            f"git clone {FIRST}\nmv arm/models/arm_description .\nrm -r /ws/src/arm\ngit clone {SECOND}",
            [SECOND],
            {FIRST: ("arm_description",)},
        ),
        (f"git clone {FIRST}\ncp arm/LICENSE .\nrm -rf arm\ngit clone {SECOND}", [SECOND], {}),  # no package
        (f"git clone {FIRST}\nrm -rf arm/docs\ngit clone {SECOND}", [FIRST], {SECOND: ("arm_control",)}),
        (f"git clone {FIRST}\ngit clone {SECOND}", [FIRST], {SECOND: ("arm_control",)}),  # one of them may hold it
        (f"git clone {FIRST}\nrm -rf arm\ngit clone {FIRST}", [FIRST], {}),
        (f"git clone {FIRST}\ncp -r arm/arm_description .\nrm -rf arm", [FIRST], {}),  # nothing takes its place
    ],
)
def test_the_one_that_stays_is_cloned(
    tree: Tree, steps: str, cloned: list[str], parts: dict[str, tuple[str, ...]]
) -> None:
    decision = tree(_tree(steps))
    assert [source.repo for source in decision.source if not source.holding] == cloned
    assert {source.repo: source.holding for source in decision.source if source.holding} == parts
    names = [source.name for source in decision.source]
    assert len({*names}) == len(names)
