"""A container gets the machine's GPU where what it starts computes there in any case, also of ROS."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
BASE = {
    "README.md": "ROS Noetic\n",
    "package.xml": (
        "<package format='2'><name>mapper</name><version>0.1.0</version><description>d</description>"
        "<maintainer email='a@b.c'>a</maintainer><license>MIT</license>"
        "<buildtool_depend>catkin</buildtool_depend></package>"
    ),
    "CMakeLists.txt": "project(mapper)\nfind_package(catkin REQUIRED)\n",
    "launch/mapper.launch": (
        '<launch><arg name="settings" default="robot.yaml"/><node pkg="mapper" type="map.py" name="map">'
        '<param name="file" value="$(find mapper)/config/$(arg settings)"/></node></launch>\n'
    ),
    "scripts/map.py": "#!/usr/bin/env python3\nimport rospy\nimport torch\nfrom parts import step\n",
    "scripts/parts.py": "def step(image):\n    return image\n",
    "scripts/other.py": "import torch\nimage = torch.ones(3).cuda()\n",
    "config/robot.yaml": "rate: 1\n",
}
MOVES = "def step(image):\n    return image.cuda()\n"


@pytest.mark.parametrize(
    ("files", "gpu"),
    [
        ({}, False),
        ({"config/robot.yaml": "device: cuda\n"}, True),
        ({"config/robot.yaml": "device: 'cuda:0' # the first\n"}, True),
        ({"config/robot.yaml": "device: cpu # or cuda\n"}, False),
        ({"config/robot.yaml": "# device: cuda\n"}, False),
        ({"config/other.yaml": "device: cuda\n"}, False),
        ({"scripts/parts.py": MOVES}, True),
        ({"scripts/parts.py": "def step(image):\n    if image:\n        return image.cuda()\n"}, False),
        ({"scripts/parts.py": "def step(image):\n    # return image.cuda()\n    return image\n"}, False),
        ({"scripts/parts.py": f"import torch\nHAS = torch.cuda.is_available()\n{MOVES}"}, False),
        ({"scripts/parts.py": "import torch\ndevice = torch.device('cuda')\n"}, True),
        ({"config/robot.yaml": "device: cuda\n", "roslab.yaml": "format: 3\n"}, True),
    ],
)
def test_what_the_default_command_starts_asks_for_it(tree: Tree, files: dict[str, str], *, gpu: bool) -> None:
    decision = tree({**BASE, **files})
    assert decision.command == ("roslaunch", "mapper", "mapper.launch")
    told = [w for w in decision.warnings if "computes on a GPU in any case" in w.message]
    assert (decision.kind, decision.gpu, len(told)) == ("ros1", gpu, int(gpu))


def test_what_another_launch_file_starts_does_not(tree: Tree) -> None:
    other = BASE["launch/mapper.launch"].replace("map.py", "other.py")
    page = "ROS Noetic\n# Usage\n```\nroslaunch mapper mapper.launch\n```\n"
    assert not tree({**BASE, "README.md": page, "launch/other.launch": other}).gpu
