"""What a proof comes to: its exit code, and the nodes that a launch lost on the way."""

from __future__ import annotations

import pytest

from roslab.knowledge.launches import dead_nodes
from roslab.plan.proof import Proof
from roslab.prove.verdict import End, verdict

START = Proof(name="the default command starts", command=("roslaunch", "robot", "a.launch"), may_run_on=True)
GUESS = Proof(name=START.name, command=START.command, may_run_on=True, required=False, guessed=True)
TEST = Proof(name="the repository's test", command=("true",))
DEAD = ("talker-2 died with exit code 1",)

ROS_1 = """\
started roslaunch server http://robot:33445/
process[rosout-1]: started with pid [61]
\x1b[1mprocess[talker-2]: started with pid [64]\x1b[0m
\x1b[31m[talker-2] process has died [pid 64, exit code 1, cmd /ws/devel/lib/robot/talker __name:=talker __log:=/x.log].
log file: /home/jovyan/.ros/log/a/talker-2*.log\x1b[0m
[helper-3] process has finished cleanly
"""
ROS_1_REQUIRED = (
    "\x1b[31m" + "=" * 80 + "REQUIRED process [map_server-4] has died!\n"
    "process has died [pid 92, exit code -11, cmd /opt/ros/noetic/lib/map_server/map_server].\n"
    "log file: /x/map_server-4*.log\nInitiating shutdown!\n" + "=" * 80 + "\x1b[0m\n"
)
ROS_1_MISSING = """\
\x1b[31mERROR: cannot launch node of type [robot/no_such_node]: Cannot locate node of type [no_such_node] in package \
[robot]. Make sure file exists in package path and permission is set to executable (chmod +x)\x1b[0m
"""
ROS_2 = """\
[INFO] [talker-1]: process started with pid [63]
[INFO] [listener-2]: process started with pid [65]
[talker-1] Traceback (most recent call last):
[talker-1] ModuleNotFoundError: No module named 'scipy'
[ERROR] [talker-1]: process has died [pid 63, exit code 1, cmd '/ws/install/robot/lib/robot/talker --ros-args'].
[INFO] [listener-2]: process has finished cleanly [pid 65]
"""
ROS_2_MISSING = """\
[ERROR] [program-1]: exception occurred while executing process:
Traceback (most recent call last):
FileNotFoundError: [Errno 2] No such file or directory: '/no/such/program'
[INFO] [first-4]: process started with pid [2514]
[INFO] [first-4]: process has finished cleanly [pid 2514]
"""
ROS_2_ENDED = """\
[ERROR] [crash-3]: process has died [pid 1378, exit code 3, cmd 'crash'].
[INFO] [first-4]: process has finished cleanly [pid 1380]
[INFO] [stubborn-2]: sending signal 'SIGINT' to process[stubborn-2]
[INFO] [worker-1]: sending signal 'SIGINT' to process[worker-1]
[worker-1] KeyboardInterrupt
[ERROR] [worker-1]: process has died [pid 1373, exit code -2, cmd 'worker'].
[ERROR] [stubborn-2]: process[stubborn-2] failed to terminate '2' seconds after receiving 'SIGINT', escalating
[INFO] [stubborn-2]: sending signal 'SIGTERM' to process[stubborn-2]
[ERROR] [stubborn-2]: process has died [pid 1376, exit code -15, cmd 'stubborn'].
"""


@pytest.mark.parametrize(
    ("log", "expected"),
    [
        (ROS_1, ("talker-2 died with exit code 1",)),
        (ROS_1_REQUIRED, ("map_server-4 died with exit code -11",)),
        (ROS_1_MISSING, ("robot/no_such_node cannot be started",)),
        (ROS_2, ("talker-1 died with exit code 1",)),
        (ROS_2 * 20, ("talker-1 died with exit code 1",)),
        (ROS_2_MISSING, ("program-1 cannot be started",)),
        (ROS_2_ENDED, ("crash-3 died with exit code 3",)),
        (
            ROS_2 + ROS_2_ENDED.replace("worker-1", "talker-1"),
            ("talker-1 died with exit code 1", "crash-3 died with exit code 3"),
        ),
        (ROS_1_MISSING + ROS_1, ("robot/no_such_node cannot be started", "talker-2 died with exit code 1")),
        ("[robot] my process has died [pid 3, exit code 1\nINFO: process has died\n[a-1] process has died\n", ()),
        ("", ()),
    ],
)
def test_the_nodes_that_a_launch_lost(log: str, expected: tuple[str, ...]) -> None:
    assert dead_nodes(log) == expected


@pytest.mark.parametrize(
    ("proof", "end", "passed", "said"),
    [
        (START, End(code=None, seconds=10.02), True, "passed: still running after 10 s"),
        (START, End(code=0, seconds=1.23), True, "passed in 1.2 s"),
        (START, End(code=3, seconds=1.0), False, "failed with exit code 3 after 1.0 s"),
        (TEST, End(code=None, seconds=1800.0), False, "failed: no end within 1800 s"),
        (
            START,
            End(code=None, seconds=10.0, dead=DEAD),
            False,
            "failed: talker-2 died with exit code 1, though the launch itself still ran after 10.0 s",
        ),
        (
            START,
            End(code=0, seconds=2.0, dead=DEAD),
            False,
            "failed: talker-2 died with exit code 1, though the launch itself ended with 0 after 2.0 s",
        ),
        (
            START,
            End(code=1, seconds=2.0, dead=DEAD * 2),
            False,
            "failed with exit code 1 after 2.0 s: talker-2 died with exit code 1, talker-2 died with exit code 1",
        ),
    ],
)
def test_the_verdict(proof: Proof, end: End, passed: bool, said: str) -> None:
    assert verdict(proof, end) == (passed, said)


def test_a_guess_is_never_a_failure_and_never_proved_either() -> None:
    passed, said = verdict(GUESS, End(code=None, seconds=10.0, dead=DEAD))
    assert passed
    assert said.startswith("not proved: the guessed command failed: talker-2 died with exit code 1, though ")
    assert said.endswith("; name the right one as `command` in roslab.yaml")


def test_many_dead_nodes_are_counted() -> None:
    dead = tuple(f"n-{number} died with exit code 1" for number in range(30))
    _, said = verdict(START, End(code=None, seconds=10.0, dead=dead))
    assert "n-4 died with exit code 1 and 25 more, though" in said
    assert "n-5 " not in said


def test_a_missing_display_is_told_where_it_may_be_the_reason() -> None:
    why = "Xvfb is not installed (on Debian and Ubuntu: apt install xvfb)"
    assert verdict(START, End(code=0, seconds=1.0), without=why) == (True, "passed in 1.0 s")
    assert verdict(START, End(code=1, seconds=1.0), without=why) == (
        False,
        f"failed with exit code 1 after 1.0 s; it had no display: {why}",
    )
