"""An old file's image on the real engine: JupyterLab in it unasked, its notebook executed, its paths as they were.

What docker_run.sh makes of an image of today is in test_run_script.py.
"""

from __future__ import annotations

import json
import shutil
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from .laboratory import Laboratory

ROOT = Path(__file__).resolve().parent.parent.parent
NAME = "lab-old-talker"
OLD = f"""\
name: {NAME}

base:
  ubuntu: 16.04
  ros: kinetic-ros-base

build: catkin_make

apt:
  - nano

pip3:
  - enum-compat

custom:
  - cd $HOME/{NAME}
  - touch made-by-custom
  - touch $HOME/catkin_ws/src/{NAME}/made-by-the-other-path
"""
Inside = Callable[[str], "subprocess.CompletedProcess[str]"]


@pytest.fixture(scope="module")
def image(lab: Laboratory, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Path]:
    """Return a repository with an old file, whose image was built by its own docker_build.sh."""
    folder = tmp_path_factory.mktemp("old") / "talker"
    shutil.copytree(ROOT / "examples" / "ros1_talker", folder)
    (folder / "roslab.yaml").write_text(OLD)
    env = dict(lab.environment)
    create = [sys.executable, "-I", str(ROOT / "scripts"), "create", str(folder)]
    for command in (create, [str(folder / "docker_build.sh"), "--progress", "plain"]):
        answer = subprocess.run(command, env=env, capture_output=True, text=True, check=False, timeout=1800)
        assert answer.returncode == 0, answer.stderr[-4000:]
    yield folder
    subprocess.run(["docker", "image", "rm", "--force", NAME], env=env, capture_output=True, check=False)


@pytest.fixture
def inside(lab: Laboratory, image: Path) -> Inside:
    """Return a function that runs a line of bash in a container, through docker_run.sh."""

    def run(script: str) -> subprocess.CompletedProcess[str]:
        return subprocess.run(
            [str(image / "docker_run.sh"), "bash", "-c", script],
            env=dict(lab.environment),
            stdin=subprocess.DEVNULL,
            capture_output=True,
            text=True,
            check=False,
            timeout=300,
        )

    return run


def test_the_notebook_of_an_old_image_runs_cell_by_cell(inside: Inside) -> None:
    script = "/opt/jupyter/bin/jupyter execute --output=/tmp/done.ipynb README.ipynb >&2 && cat /tmp/done.ipynb"
    answer = inside(script)
    assert answer.returncode == 0, answer.stderr[-4000:]
    cells = [cell for cell in json.loads(answer.stdout)["cells"] if cell["cell_type"] == "code"]
    assert len(cells) == 2
    for cell, messages in zip(cells, (10, 3), strict=True):
        assert not [output for output in cell["outputs"] if output["output_type"] == "error"]
        printed = "".join(text for output in cell["outputs"] for text in output.get("text", ()))
        assert printed.count("I heard: hello ") == messages


def test_the_paths_of_old_lead_to_the_source(inside: Inside) -> None:
    answer = inside(
        f"cd ~/{NAME} && pwd -P && stat -c '%U %n' made-by-custom made-by-the-other-path && "
        f"cd ~/catkin_ws/src/{NAME} && pwd -P && test -w CMakeLists.txt && id -un"
    )
    folder = f"/home/jovyan/ws/src/{NAME}"
    assert answer.stdout.split("\n") == [
        folder,
        "jovyan made-by-custom",
        "jovyan made-by-the-other-path",
        folder,
        "jovyan",
        "",
    ], answer.stderr


def test_what_was_asked_for_is_there(inside: Inside) -> None:
    answer = inside("nano --version && python3 -m pip show enum-compat && rospack find ros1_talker")
    assert answer.returncode == 0, answer.stderr
    assert answer.stdout.splitlines()[-1] == f"/home/jovyan/ws/src/{NAME}"
