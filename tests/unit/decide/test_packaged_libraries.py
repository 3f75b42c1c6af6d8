"""A library that a page installs from its own source of apt is compiled only where that source is no more."""

from __future__ import annotations

import os
import re
import subprocess
from pathlib import Path

import pytest

from roslab.pipeline import plan_repository
from roslab.render.dockerfile import dockerfile

PACKAGE = "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend></package>"
CMAKE = "project(demo)\nfind_package(catkin REQUIRED)\nfind_package(GTSAM REQUIRED)\n"
PPA = "add-apt-repository ppa:borglab/gtsam-release-4.0\napt update\n"


def _text(tmp_path: Path, page: str, cmake: str = CMAKE) -> str:
    (tmp_path / "package.xml").write_text(PACKAGE)
    (tmp_path / "CMakeLists.txt").write_text(cmake)
    (tmp_path / "README.md").write_text(f"ROS Noetic\n```\n{page}\n```\n")
    return dockerfile(plan_repository(tmp_path).plan)


@pytest.mark.parametrize(
    ("page", "asks"),
    [
        (f"{PPA}apt install libgtsam-dev libgtsam-unstable-dev", True),
        ("apt install libgtsam-dev", False),
        (f"apt install libgtsam-dev\n{PPA}", False),
        (f"{PPA}apt install libother-dev", False),
    ],
)
def test_apt_is_asked_before_the_recipe_is_built(tmp_path: Path, page: str, *, asks: bool) -> None:
    text = _text(tmp_path, page)
    assert "git clone https://github.com/borglab/gtsam.git" in text
    assert ("if apt-get install --simulate --yes --no-install-recommends libgtsam-dev >/dev/null; then" in text) is asks


@pytest.mark.parametrize("there", [True, False])
def test_it_is_built_where_apt_has_it_not(tmp_path: Path, *, there: bool) -> None:
    (tmp_path / "tree").mkdir()
    text = _text(tmp_path / "tree", f"{PPA}apt install libgtsam-dev")
    run = re.search(r"RUN --mount=\S+ \\\n +(apt-get update \\\n && if apt-get install --simulate[\s\S]*?)\n\n", text)
    assert run
    (tmp_path / "bin").mkdir()
    stand_ins = {
        "apt-get": f'[ "$1" = update ] || {str(there).lower()}',
        "git": "exit 0",
        "configure-library": "exit 0",
        "fetch-submodules": "exit 0",
        "warnings-pass": 'shift; "$@"',
    }
    stand_ins |= {"make": f"touch {tmp_path}/built", "mkdir": "exit 0", "compile-jobs": "echo 1", "nproc": "echo 1"}
    for name, body in stand_ins.items():
        (tmp_path / "bin" / name).write_text(f"#!/bin/bash\n{body}\n")
        (tmp_path / "bin" / name).chmod(0o755)
    script = "cd() { :; }\n" + run[1]
    path = {"PATH": f"{tmp_path / 'bin'}:{os.environ['PATH']}"}
    done = subprocess.run(["bash", "-c", script], env=path, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert (tmp_path / "built").exists() is not there
    assert ("gtsam is not compiled" in done.stdout) is there


def test_a_library_after_it_has_the_packages_of_apt(tmp_path: Path) -> None:
    text = _text(tmp_path, f"{PPA}apt install libgtsam-dev", f"{CMAKE}find_package(Pangolin REQUIRED)\n")
    stages = dict(re.findall(r"^FROM \w+ AS library-\d-(\w+)\n([\s\S]*?)(?=^FROM )", text, re.MULTILINE))
    assert [name for name, stage in stages.items() if "install-optional-apt libgtsam-dev" in stage] == ["pangolin"]


def test_apt_is_asked_with_its_login(tmp_path: Path) -> None:
    (tmp_path / "roslab.yaml").write_text("format: 3\nsecrets: [apt_auth]\n")
    text = _text(tmp_path, f"{PPA}apt install libgtsam-dev")
    asked = [step for step in text.split("\nRUN ") if "apt-get install --simulate --yes" in step and "gtsam" in step]
    assert asked
    assert all("--mount=type=secret,id=apt_auth" in step for step in asked)
