"""A plain Python program that reads bags gets Ubuntu's own packages of ROS 1, or is told what it lacks."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
MAIN = "if __name__ == '__main__':\n    main()\n"
BAGS = f"import rosbag\nimport yaml\nfrom geometry_msgs.msg import Pose\ndef main():\n    pass\n{MAIN}"
TREE = {
    "tools/read.py": BAGS,
    "tools/merge.py": BAGS,
    "tools/plot.py": f"import yaml\nimport numpy\n{MAIN}",
    "requirements.txt": "PyYAML\nnumpy\n",
    "setup.py": "from setuptools import setup\nsetup(name='tools', packages=['tools'])\n",
}
CONDA = "name: a\ndependencies:\n- python=3.7\n- pyyaml\n"


@pytest.mark.parametrize(
    ("more", "packages", "told"),
    [
        ({}, {"python3-rosbag", "python3-geometry-msgs"}, 0),
        ({"tools/merge.py": f"import rclpy\n{BAGS}"}, set(), 0),
        ({"tools/read.py": BAGS.replace("import rosbag\n", ""), "tools/merge.py": ""}, set(), 0),
        ({"tools/read.py": BAGS.replace("import rosbag", "import genpy"), "tools/merge.py": ""}, None, 0),
        ({"environment.yml": CONDA}, set(), 1),
        ({"environment.yml": f"{CONDA}- ros-noetic-rosbag\n"}, set(), 0),
    ],
)
def test_bags(tree: Tree, more: dict[str, str], packages: set[str] | None, told: int) -> None:
    decision = tree({**TREE, **more})
    found = {name for name in decision.apt_guessed if name.endswith(("-rosbag", "-msgs", "-genpy"))}
    assert found == ({"python3-genpy", "python3-geometry-msgs"} if packages is None else packages)
    said = [w.message for w in decision.warnings if "the image has no ROS 1" in w.message]
    assert len(said) == told
    assert all("stops at its import of rosbag" in message and "`kind: ros1`" in message for message in said)
