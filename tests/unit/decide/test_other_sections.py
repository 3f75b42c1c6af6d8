"""What the titles of sections tell: lines of apt for another distribution, and programs that a section tests."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
PACKAGE = "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend></package>"
PROGRAMS = {"train.py": "import torch\nmain()\n", "test.py": "import torch\nmain()\n", "make.sh": "python list.py\n"}
OURS = "## Ubuntu 16.04 with ROS Kinetic\n```\nsudo apt install libglog-dev\n```\n"


@pytest.mark.parametrize(
    ("title", "page", "installed"),
    [
        ("Ubuntu 18.04 with ROS Melodic and Gazebo 9", OURS, False),
        ("Ubuntu 18.04", OURS, False),
        ("Ubuntu 14.04 or newer", OURS, True),
        ("Ubuntu 16.04 and 18.04", OURS, True),
        ("Gazebo", OURS, True),
        ("Ubuntu 18.04", "## Packages\n```\nsudo apt install libglog-dev\n```\n", True),
    ],
)
def test_lines_for_another_ubuntu(tree: Tree, title: str, page: str, installed: bool) -> None:
    text = f"# Demo\nROS Kinetic is recommended\n{page}## {title}\n```\nsudo apt install gazebo9\n```\n"
    decision = tree({"package.xml": PACKAGE, "CMakeLists.txt": "project(demo)\n", "README.md": text})
    assert decision.ros_distro == "kinetic"
    assert ("gazebo9" in decision.apt_guessed) is installed
    assert "libglog-dev" in decision.apt_guessed


@pytest.mark.parametrize(
    ("page", "command"),
    [
        (
            "## Getting started\n### Test WALK\npython test.py\n### Train WALK\nbash make.sh\npython train.py\n",
            "test.py",
        ),
        ("## Usage\n### Training\npython train.py\n### Testing\npython test.py\n", "train.py"),
        ("## Usage\n### Testing\npython test.py\n### Training\npython train.py\n", "train.py"),
        ("## Usage\n### Test cases\npython test.py\n### Training\npython train.py\n", "train.py"),
        ("## Data\n### Test\npython test.py\n## Usage\npython train.py\n", "train.py"),
    ],
)
def test_what_was_trained_is_tested_in_a_section_about_starting(tree: Tree, page: str, command: str) -> None:
    text = "".join(f"```\n{line}\n```\n" if line[:2] in {"py", "ba"} else f"{line}\n" for line in page.splitlines())
    decision = tree({**PROGRAMS, "requirements.txt": "torch\n", "README.md": f"# Walk\n{text}"})
    assert decision.command == ("python", command)
