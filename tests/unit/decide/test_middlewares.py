"""The middleware of ROS 2 that a tree chooses is in the image."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision
from trees import HUMBLE, NOETIC

Tree = Callable[[dict[str, str]], Decision]
_CYCLONE = ["ros-humble-rmw-cyclonedds-cpp"]


@pytest.mark.parametrize(
    ("path", "text", "found"),
    [
        ("env.sh", "export RMW_IMPLEMENTATION=rmw_cyclonedds_cpp # the other\n", _CYCLONE),
        ("env.sh", 'export RMW_IMPLEMENTATION="${RMW_IMPLEMENTATION:-rmw_cyclonedds_cpp}"\n', _CYCLONE),
        (
            "docker-compose.yml",
            "services:\n  a:\n    environment:\n      RMW_IMPLEMENTATION: rmw_cyclonedds_cpp\n",
            _CYCLONE,
        ),
        ("docs/start.md", "```\nexport RMW_IMPLEMENTATION=rmw_cyclonedds_cpp\n```\n", _CYCLONE),
        ("launch/a.launch.py", "SetEnvironmentVariable('RMW_IMPLEMENTATION', 'rmw_cyclonedds_cpp')\n", _CYCLONE),
        ("launch/a.launch.py", "os.environ['RMW_IMPLEMENTATION'] = 'rmw_cyclonedds_cpp'\n", _CYCLONE),
        (
            "launch/a.launch.xml",
            '<launch><set_env name="RMW_IMPLEMENTATION" value="rmw_cyclonedds_cpp"/></launch>\n',
            _CYCLONE,
        ),
        ("env.sh", "# export RMW_IMPLEMENTATION=rmw_cyclonedds_cpp\n", []),
        ("env.sh", "export RMW_IMPLEMENTATION=rmw_fastrtps_cpp\n", []),  # the base has it
        ("env.sh", "export RMW_IMPLEMENTATION=rmw_of_nobody_cpp\n", []),
        ("env.sh", 'echo "RMW_IMPLEMENTATION: $RMW_IMPLEMENTATION, else rmw_cyclonedds_cpp"\n', []),
    ],
)
def test_the_package_of_a_middleware(tree: Tree, path: str, text: str, found: list[str]) -> None:
    assert [name for name in tree(HUMBLE | {path: text}).apt_guessed if "rmw" in name] == found


def test_ros_1_has_none(tree: Tree) -> None:
    assert not [
        name
        for name in tree(NOETIC | {"run.sh": "export RMW_IMPLEMENTATION=rmw_cyclonedds_cpp\n"}).apt_guessed
        if "rmw" in name
    ]
