"""A list whose repositories have branches of a distribution's name tells of ROS, and of that distribution."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
LIST = "repositories:\n"
ENTRY = "  part{0}:\n    type: git\n    url: https://github.com/example/part{0}.git\n    version: {1}\n"
PAGE = "# Training\n\n## Usage\n```bash\n./setup.sh\nros2 launch arm demo.launch.py\n```\n"


@pytest.mark.parametrize(
    ("branches", "page", "kind", "distro"),
    [
        (("iron", "main"), PAGE, "ros2", "iron"),
        (("iron", "iron"), f"{PAGE}ROS 2 Humble\n", "ros2", "humble"),
        (("noetic", "main"), "# Training\n", "ros1", "noetic"),
        (("main", "v1.0"), PAGE, "python", None),
    ],
)
def test_of_a_list_of_any_name(tree: Tree, branches: tuple[str, ...], page: str, kind: str, distro: str | None) -> None:
    listed = LIST + "".join(ENTRY.format(number, branch) for number, branch in enumerate(branches))
    files = {"README.md": page, "repos.txt": listed, "setup.sh": "#!/bin/bash\nvcs import < repos.txt\n"}
    decision = tree(files)
    assert (decision.kind, decision.ros_distro) == (kind, distro)


def test_two_distributions_tell_of_none(tree: Tree) -> None:
    listed = LIST + ENTRY.format(1, "iron") + ENTRY.format(2, "jazzy")
    decision = tree({"README.md": PAGE, "all.repos": listed})
    assert decision.kind == "ros2"
    assert not any("has its name" in reason.reason for reason in decision.reasons)
