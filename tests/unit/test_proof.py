"""How a proof's command is told."""

from __future__ import annotations

import pytest

from roslab.config.model import Config
from roslab.decide.decision import Decision
from roslab.decide.python.image_python import Python
from roslab.plan.proof import LONGEST, Proof, describe
from roslab.plan.proofs import proofs
from roslab.plan.workspace import workspace


@pytest.mark.parametrize(
    ("command", "told"),
    [
        (("python3", "demo.py", "a b"), "python3 demo.py 'a b'"),
        (("bash", "-c", "roscore & sleep 1\n"), "bash -c 'roscore & sleep 1'"),
        (("python3", "-c", "import os\nprint(1)\n", "a", "b"), "python3 -c 'import os …' a b"),
        ((), "(the image's own command)"),
    ],
)
def test_a_command_is_told_on_one_line(command: tuple[str, ...], told: str) -> None:
    assert describe(Proof(name="x", command=command)) == told


def test_a_long_command_is_cut() -> None:
    told = describe(Proof(name="x", command=("echo", "word" * 100)))
    assert len(told) == LONGEST
    assert told.endswith("…")


@pytest.mark.parametrize(("command", "display"), [(("bash",), False), (("rviz",), True), ("rqt_plot", True)])
def test_a_shell_by_default_draws_nothing(command: tuple[str, ...] | str, display: bool) -> None:
    decision = Decision(
        kind="ros1",
        ros_distro="noetic",
        ubuntu="focal",
        base_image="ros:noetic-ros-base",
        build_tool="catkin_make",
        python=Python(version="3.8", manager="system"),
        command=command,
        gui=True,
    )
    assert [proof.display for proof in proofs(decision, workspace(decision, Config(), (), "robot"))] == [display]
