"""The entry point of an image with ROS: it knows the workspace, and starts the master for which rosrun waits."""

from __future__ import annotations

import os
import shutil
import socket
import subprocess
import sys
from pathlib import Path

import pytest

SCRIPT = Path(__file__).parents[3] / "scripts/roslab/render/image_scripts/roslab-entrypoint.sh"
SAYS = """#!/bin/bash
if (: <"/dev/tcp/localhost/{port}") 2>/dev/null; then echo "$0 $* with a master"; else echo "$0 $* alone"; fi
"""
MASTER = """#!{python}
# Stands in for roscore: it answers for some seconds
import pathlib, socket, sys, time
pathlib.Path({called!r}).write_text(" ".join(sys.argv[1:]))
server = socket.create_server(("127.0.0.1", int(sys.argv[2])))
time.sleep(8)
"""


@pytest.fixture
def port() -> int:
    if not shutil.which("bash"):
        pytest.skip("there is no bash")
    with socket.create_server(("127.0.0.1", 0)) as server:
        return int(server.getsockname()[1])


def entered(folder: Path, port: int, uri: str, *command: str) -> str:
    """Return what the command of an image says, whose programs are stand-ins."""
    programs = {
        "rosrun": SAYS.format(port=port),
        "ros2": SAYS.format(port=port),
        "roscore": MASTER.format(python=sys.executable, called=str(folder / "called")),
    }
    for name, text in programs.items():
        (folder / name).write_text(text)
        (folder / name).chmod(0o755)
    (folder / "environment.bash").write_text(f"export ROS_MASTER_URI={uri}\n")
    text = SCRIPT.read_text().replace("/usr/local/share/roslab", str(folder))
    environment = {**os.environ, "PATH": f"{folder}:{os.environ['PATH']}"}
    done = subprocess.run(
        ["bash", "-c", text, "roslab-entrypoint", *command],
        env=environment,
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        text=True,
        timeout=60,
        check=True,
    )
    return done.stdout.strip().removeprefix(f"{folder}/")


@pytest.mark.parametrize(
    ("host", "command", "said"),
    [
        ("localhost", "rosrun demo talker", "rosrun demo talker with a master"),
        ("127.0.0.1", "rosrun demo talker", "rosrun demo talker with a master"),
        ("robot", "rosrun demo talker", "rosrun demo talker alone"),
        ("localhost", "ros2 run demo talker", "ros2 run demo talker alone"),
    ],
)
def test_rosrun_has_a_master(tmp_path: Path, port: int, host: str, command: str, said: str) -> None:
    assert entered(tmp_path, port, f"http://{host}:{port}/", *command.split()) == said
    called = (tmp_path / "called").read_text() if (tmp_path / "called").exists() else ""
    assert called == (f"-p {port}" if said.endswith("with a master") else "")


def test_a_master_that_answers_is_the_one(tmp_path: Path, port: int) -> None:
    with socket.create_server(("127.0.0.1", port)):
        said = entered(tmp_path, port, f"http://localhost:{port}", "rosrun", "demo", "talker")
    assert said == "rosrun demo talker with a master"
    assert not (tmp_path / "called").exists()


def test_without_ros_the_command_is_all(tmp_path: Path, port: int) -> None:
    assert entered(tmp_path, port, "''", "rosrun", "a") == "rosrun a alone"
