"""A clone of the workspace that is plain Python and that the code imports is installed by pip, with what it needs."""

from __future__ import annotations

import os
import subprocess
from pathlib import Path

import pytest

from roslab.pipeline import plan_repository
from roslab.render import image_scripts
from roslab.render.dockerfile import dockerfile

SCRIPT = Path(image_scripts.__path__[0]) / "install-python-clones.sh"
STAND_IN = """#!/bin/bash
# A stand-in of Python with pip, which has installed `known`, and of the script for single packages, which is noted
if [ "$(basename "$0")" = python3 ]; then [ "${{*: -1}}" = known ]; exit; fi
echo "$@" >>{folder}/calls
"""


def test_only_what_has_no_package_is_installed(tmp_path: Path) -> None:
    paths = ("alone/setup.py", "modern/pyproject.toml", "known/setup.py", "words/README.md", "both/setup.py")
    for path in (*paths, "other/known/setup.py"):
        (tmp_path / path).parent.mkdir(parents=True)
        (tmp_path / path).touch()
    (tmp_path / "both/CMakeLists.txt").touch()
    (tmp_path / "sister/inner").mkdir(parents=True)
    (tmp_path / "sister/setup.py").touch()
    (tmp_path / "sister/inner/package.xml").touch()
    for name in ("python3", "install-optional-pip"):
        (tmp_path / name).write_text(STAND_IN.format(folder=tmp_path))
        (tmp_path / name).chmod(0o755)
    folders = {name: str(tmp_path / name) for name in ("alone", "modern", "known", "words", "both", "sister", "gone")}
    variables = {**os.environ, "PATH": f"{tmp_path}:{os.environ['PATH']}"}
    guessed = str(tmp_path / "other/known")
    command = ["bash", str(SCRIPT), "python3", "--quiet", "--", *folders.values(), f"--instead={guessed}"]
    subprocess.run(command, env=variables, check=True)
    taken = (folders["alone"], folders["modern"], guessed)
    installed = [f"python3 --quiet -- --no-build-isolation={folder}" for folder in taken]
    assert (tmp_path / "calls").read_text().splitlines() == installed
    ignored = {name for name, folder in folders.items() if Path(folder, "COLCON_IGNORE").exists()}
    assert ignored == {"alone", "modern", "known"}


@pytest.mark.parametrize(
    ("name", "code", "called"),
    [
        ("fast_tracker", "import fast_tracker\n", True),
        ("fast_tracker", "try:\n    import fast_tracker\nexcept ImportError:\n    pass\n", False),
        ("fast_tracker", "import rclpy\n", False),
        ("cv_bridge", "import cv_bridge\n", False),  # ROS's own
    ],
)
def test_the_image_does_so_for_what_is_imported(tmp_path: Path, name: str, code: str, *, called: bool) -> None:
    package = (
        f"<package><name>robot</name><exec_depend>{name}</exec_depend><export><build_type>ament_python</build_type>"
    )
    page = f"ROS 2 Humble\n```\ncd ~/ros2_ws/src\ngit clone https://github.com/lab/{name}.git\ncolcon build\n```\n"
    files = {"package.xml": f"{package}</export></package>", "README.md": page, "robot/node.py": code}
    files["setup.py"] = "from setuptools import setup\nsetup(name='robot', packages=['robot'])\n"
    for path, text in files.items():
        (tmp_path / path).parent.mkdir(exist_ok=True)
        (tmp_path / path).write_text(text)
    text = dockerfile(plan_repository(tmp_path).plan)
    assert f"https://github.com/lab/{name}.git" in text
    assert (f" -- /home/${{NB_USER}}/ws/src/{name}\n" in text and "install-python-clones python3 " in text) == called
    assert ("COPY --from=scripts /install-optional-pip /usr/local/bin/" in text) >= called
    assert "RUN install-plain-clones /" not in text
    assert ("python3-pip" in text) == called


@pytest.mark.parametrize(("ros", "code", "called"), [("Noetic", "toppra", True), ("Humble", "toppra", False)])
def test_it_takes_the_place_of_what_pip_would_have_by_that_name(
    tmp_path: Path, ros: str, code: str, *, called: bool
) -> None:
    """ROS 2 released a package of that name, and ROS 1 did not."""
    tool = "catkin" if ros == "Noetic" else "ament_cmake"
    package = f"<package><name>robot</name><buildtool_depend>{tool}</buildtool_depend><depend>{code}</depend></package>"
    page = f"ROS {ros}\n```\ncd ~/ws/src\ngit clone https://github.com/lab/{code}.git\n```\n"
    files = {"package.xml": package, "README.md": page, "scripts/plan.py": f"import {code}\n"}
    files["CMakeLists.txt"] = f"project(robot)\nfind_package({tool} REQUIRED)\n"
    for path, text in files.items():
        (tmp_path / path).parent.mkdir(exist_ok=True)
        (tmp_path / path).write_text(text)
    text = dockerfile(plan_repository(tmp_path).plan)
    assert (f" -- --instead=/home/${{NB_USER}}/ws/src/{code}\n" in text) == called
