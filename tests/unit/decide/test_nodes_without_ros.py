"""Nodes of ROS in Python are told where the image has no ROS."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.config.model import Config, Kind
from roslab.decide.base import BaseImage
from roslab.decide.decision import Decision
from roslab.decide.nodes_without_ros import decide_nodes
from roslab.decide.python.image_python import Python
from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import Evidence
from roslab.evidence.program import Program

Tree = Callable[[dict[str, str]], Decision]
MAIN = "if __name__ == '__main__':\n    main()\n"
NODE = f"import rclpy\ndef main():\n    rclpy.init()\n{MAIN}"
PROGRAM = f"import numpy\nimport cv2\nimport scipy\nimport yaml\nimport torch\ndef main():\n    pass\n{MAIN}"
NO_PYTHON = Python(version=None, manager="system")
INDEX = "--extra-index-url https://example.org/simple\n"
TREE = {
    "train.py": PROGRAM,
    "robot/send.py": NODE,
    "robot/receive.py": NODE,
    "requirements.txt": "numpy\ntorch\n",
    "README.md": "```\npython train.py\n```\n",
}


@pytest.mark.parametrize(
    ("more", "said"),
    [
        ({}, ["robot/receive.py and 1 other program cannot start"]),
        ({"robot/receive.py": PROGRAM}, ["robot/send.py cannot start"]),
        ({"robot/receive.py": PROGRAM, "robot/send.py": "import numpy\n"}, []),
        ({"environment.yml": "name: a\ndependencies:\n- python=3.10\n- ros-humble-rclpy\n"}, []),
        ({"requirements.txt": f"{INDEX}rclpy\nnumpy\n"}, []),
        ({"requirements.txt": f"{INDEX}numpy\n"}, ["robot/receive.py and 1 other program cannot start"]),
        ({"requirements.txt": "rclpy\nnumpy\n"}, ["robot/receive.py and 1 other program cannot start"]),
        ({"README.md": f"```\npip install {INDEX.strip()} rclpy-all\npython train.py\n```\n"}, []),
    ],
)
def test_nodes_without_ros(tree: Tree, more: dict[str, str], said: list[str]) -> None:
    told = [w.message.partition(":")[0] for w in tree({**TREE, **more}).warnings if "has no ROS" in w.message]
    assert told == said


@pytest.mark.parametrize(
    ("kind", "base", "told"),
    [("python", "ubuntu:24.04", 1), ("python", "osrf/ros:jazzy-desktop", 0), ("ros2", "ubuntu:24.04", 0)],
)
def test_an_image_with_ros(kind: Kind, base: str, told: int) -> None:
    used = Dependency(namespace="import", name="rclpy", strength="used", file="a.py", line=1)
    evidence = Evidence(code=(used,), programs=(Program(file="a.py", line=9, kind="node"),))
    assert len(decide_nodes(evidence, Config(), kind, BaseImage(image=base, ubuntu=None), NO_PYTHON).warnings) == told
