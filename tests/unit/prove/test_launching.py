"""A launch is watched until it has tried all of the nodes that it lists."""

from __future__ import annotations

import subprocess
import threading
from pathlib import Path

import pytest

from roslab.config.model import ProofGoals
from roslab.knowledge.launches import waiting_nodes
from roslab.plan.proof import Proof
from roslab.prove import watch
from roslab.prove.processes import Census

LISTED = """\
SUMMARY
========

PARAMETERS
 * /rosdistro: noetic
 * /says/rate: 10

NODES
  /
    none (robot/absent.py)
    says (robot/says.py)
  /left/
    cam_1 (robot/camera_node)

auto-starting new master
process[master]: started with pid [47]
ROS_MASTER_URI=http://localhost:11311

process[rosout-1]: started with pid [57]
started core service [/rosout]
"""
TRIED = """\
process[says-2]: started with pid [60]
ERROR: cannot launch node of type [robot/absent.py]: Cannot locate node of type [absent.py] in package [robot].
\x1b[1mprocess[left/cam_1-4]: started with pid [66]\x1b[0m
"""
START = Proof(name="the default command starts", command=("roslaunch", "robot", "all.launch"), may_run_on=True)


@pytest.mark.parametrize(
    ("log", "waiting"),
    [
        ("", 0),
        (LISTED, 3),
        (LISTED + TRIED.splitlines(keepends=True)[0], 2),
        (LISTED + TRIED, 0),
        (LISTED + TRIED + "process[says-5]: started with pid [90]\n", 0),
        ("[INFO] [launch]: All log files can be found below /root/.ros\n[INFO] [talker-1]: process started\n", 0),
        ("a program\n    that lists (things/in brackets)\n", 0),
    ],
    ids=["nothing", "listed", "one", "all", "anew", "ros2", "another"],
)
def test_the_nodes_that_a_launch_has_not_tried(log: str, waiting: int) -> None:
    assert waiting_nodes(log) == waiting


@pytest.mark.parametrize(("given", "until"), [(None, 0.9), (1, 1.0)], ids=["default", "seconds-of-roslab.yaml"])
def test_a_slow_launch_is_watched_longer(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, given: int | None, until: float
) -> None:
    monkeypatch.setattr(watch, "PROOF_SECONDS", 0.3)
    monkeypatch.setattr(watch, "COUNTING_PAUSE", 0.05)
    monkeypatch.setattr(Census, "look", lambda *_: None)  # there is no container
    log = tmp_path / "log"
    log.write_text(LISTED)
    later = threading.Timer(0.6, lambda: log.write_text(LISTED + TRIED))
    with subprocess.Popen(["sleep", "60"]) as process:
        later.start()
        try:
            seen = watch.Watch(
                process=process,
                container="",
                proof=START,
                goals=ProofGoals(seconds=given),
                camera=None,
                probe=None,
                log=log,
            )
            code, seconds = seen.end()
        finally:
            later.cancel()
            process.kill()
    assert code is None
    assert until <= seconds < 10
