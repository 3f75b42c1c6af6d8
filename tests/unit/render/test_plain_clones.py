"""A clone that the workspace asks for by its name, and that is plain CMake, is compiled and installed before it."""

from __future__ import annotations

import os
import subprocess
from pathlib import Path

import pytest

from roslab.pipeline import plan_repository
from roslab.render import image_scripts
from roslab.render.dockerfile import dockerfile

SCRIPT = Path(image_scripts.__path__[0]) / "install-plain-clones.sh"


def test_only_what_has_no_package_is_compiled(tmp_path: Path) -> None:
    for name in ("stonefish", "broken", "sister/inner"):
        (tmp_path / name).mkdir(parents=True)
        (tmp_path / name / "CMakeLists.txt").write_text("project(x)\n")
    (tmp_path / "sister/CMakeLists.txt").write_text("project(x)\n")
    (tmp_path / "sister/inner/package.xml").write_text("<package><name>inner</name></package>\n")
    (tmp_path / "words").mkdir()
    (tmp_path / "opt").mkdir()
    (tmp_path / "opt/setup.bash").touch()
    script = SCRIPT.read_text().replace("/opt/ros/${ROS_DISTRO}", str(tmp_path / "opt"))
    script = script.replace("/usr/local/share/roslab", str(tmp_path))
    stand_ins = {
        "configure-library": f'echo "$2" >>{tmp_path}/calls\n[[ "$2" != *broken ]]',
        "make": "exit 0",
        "compile-jobs": "echo 1",
        "ldconfig": "exit 0",
    }
    (tmp_path / "bin").mkdir()
    for name, body in stand_ins.items():
        (tmp_path / "bin" / name).write_text(f"#!/bin/bash\n{body}\n")
        (tmp_path / "bin" / name).chmod(0o755)
    folders = [str(tmp_path / name) for name in ("stonefish", "broken", "sister", "words", "gone")]
    path = {"PATH": f"{tmp_path / 'bin'}:{os.environ['PATH']}"}
    done = subprocess.run(["bash", "-c", script, "x", *folders], env=path, capture_output=True, text=True, check=True)
    assert (tmp_path / "calls").read_text().split() == folders[:2]
    assert "roslab: left out: broken cannot be compiled" in done.stdout
    assert (tmp_path / "left-out.txt").read_text() == "source broken\n"


@pytest.mark.parametrize(
    ("cmake", "called"),
    [("find_package(Stonefish REQUIRED)\n", True), ("find_package(catkin REQUIRED stonefish_tools)\n", False)],
)
def test_the_image_does_so_for_what_cmake_asks_for(tmp_path: Path, cmake: str, called: bool) -> None:
    package = "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend></package>"
    page = "ROS Noetic\n```\ncd ~/catkin_ws/src\ngit clone https://github.com/lab/stonefish.git\n```\n"
    files = {"package.xml": package, "README.md": page}
    files["CMakeLists.txt"] = f"project(demo)\nfind_package(catkin REQUIRED)\n{cmake}"
    for name, text in files.items():
        (tmp_path / name).write_text(text)
    text = dockerfile(plan_repository(tmp_path).plan)
    assert "https://github.com/lab/stonefish.git" in text
    assert ("\nRUN install-plain-clones /home/${NB_USER}/ws/src/stonefish\n" in text) == called
    assert ("COPY --from=scripts /configure-library /usr/local/bin/" in text) == called
