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


def _installed(tmp_path: Path, configure: str, *words: str) -> str:
    """Run the script with a stand-in of the script that configures a library; return what it says."""
    (tmp_path / "opt").mkdir()
    (tmp_path / "opt/setup.bash").touch()
    script = SCRIPT.read_text().replace("/opt/ros/${ROS_DISTRO}", str(tmp_path / "opt"))
    script = script.replace("/usr/local/share/roslab", str(tmp_path))
    stand_ins = {"configure-library": configure, "make": "exit 0", "compile-jobs": "echo 1", "ldconfig": "exit 0"}
    stand_ins["warnings-pass"] = 'shift\n"$@"'
    (tmp_path / "bin").mkdir()
    for name, body in stand_ins.items():
        (tmp_path / "bin" / name).write_text(f"#!/bin/bash\n{body}\n")
        (tmp_path / "bin" / name).chmod(0o755)
    path = {"PATH": f"{tmp_path / 'bin'}:{os.environ['PATH']}"}
    done = subprocess.run(["bash", "-c", script, "x", *words], env=path, capture_output=True, text=True, check=True)
    return done.stdout


def test_only_what_has_no_package_is_compiled(tmp_path: Path) -> None:
    for name in ("stonefish", "broken", "sister/inner"):
        (tmp_path / name).mkdir(parents=True)
        (tmp_path / name / "CMakeLists.txt").write_text("project(x)\n")
    (tmp_path / "sister/CMakeLists.txt").write_text("project(x)\n")
    (tmp_path / "sister/inner/package.xml").write_text("<package><name>inner</name></package>\n")
    (tmp_path / "words").mkdir()
    (tmp_path / "broken/.git").mkdir()
    (tmp_path / "broken/.git/roslab-plain").write_text("broken\n")
    folders = [str(tmp_path / name) for name in ("stonefish", "broken", "sister", "words", "gone")]
    said = _installed(tmp_path, f'echo "$2" >>{tmp_path}/calls\n[[ "$2" != *broken ]]', *folders)
    assert (tmp_path / "calls").read_text().split() == [*folders[:2], folders[1]]
    assert "roslab: left out: broken cannot be compiled" in said
    assert (tmp_path / "left-out.txt").read_text() == "source broken\n"
    assert not (tmp_path / "broken/.git/roslab-plain").exists(), "what requires it is left out, too"


def test_what_another_one_needs_is_installed_before_it(tmp_path: Path) -> None:
    for name in ("quad_map", "quad_map_core", "unasked"):
        (tmp_path / "src" / name / ".git").mkdir(parents=True)
        (tmp_path / "src" / name / "CMakeLists.txt").write_text("project(x)\n")
        if name != "unasked":
            (tmp_path / "src" / name / ".git/roslab-plain").write_text(f"{name}\n")
    calls = tmp_path / "calls"
    needs = f'[[ "$2" = *core ]] || grep --quiet core {calls} || exit 1\necho "$(basename "$2")" >>{calls}'
    (tmp_path / "calls").touch()
    (tmp_path / "src/mapper/.git").mkdir(parents=True)
    (tmp_path / "src/mapper/.git/roslab-plain").write_text("mapper\n")
    (tmp_path / "src/mapper/CMakeLists.txt").write_text("project(mapper)\n")
    (tmp_path / "src/mapper/package.xml").write_text("<package><name>mapper</name></package>\n")
    said = _installed(tmp_path, needs, "--in", str(tmp_path / "src"), str(tmp_path / "src/quad_map"))
    assert (tmp_path / "calls").read_text().split() == ["quad_map_core", "quad_map"]
    assert "left out" not in said
    assert said.count("it is compiled by CMake") == 2
    assert sorted(each.parent.name for each in tmp_path.rglob("COLCON_IGNORE")) == ["quad_map", "quad_map_core"]


def test_what_has_a_makefile_alone_is_installed_by_it_where_it_is_noted(tmp_path: Path) -> None:
    for name in ("forces", "pages"):
        (tmp_path / "src" / name / ".git").mkdir(parents=True)
        (tmp_path / "src" / name / "Makefile").touch()
    (tmp_path / "src/forces/.git/roslab-plain").write_text("forces\n")
    said = _installed(tmp_path, "exit 1", "--in", str(tmp_path / "src"), str(tmp_path / "src/pages"))
    assert f"{tmp_path}/src/forces has no package.xml: it is compiled by its Makefile" in said
    assert "pages" not in said
    assert "left out" not in said


def test_the_image_does_so_for_what_is_only_tried(tmp_path: Path) -> None:
    package = (
        "<package><name>demo</name><depend>quad_map</depend><buildtool_depend>ament_cmake</buildtool_depend></package>"
    )
    (tmp_path / "package.xml").write_text(package)
    (tmp_path / "CMakeLists.txt").write_text(
        "project(demo)\nfind_package(ament_cmake)\nfind_package(quad_map REQUIRED)\n"
    )
    (tmp_path / ".git").mkdir()
    (tmp_path / ".git/config").write_text('[remote "origin"]\n\turl = https://github.com/lab/demo\n')
    (tmp_path / ".git/HEAD").write_text("ref: refs/heads/humble\n")
    text = dockerfile(plan_repository(tmp_path).plan)
    assert "\nRUN clone-holding" in text
    assert "\nRUN install-plain-clones --in /home/${NB_USER}/ws/src\n" in text


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
    named = " /home/${NB_USER}/ws/src/stonefish" if called else ""
    assert f"\nRUN install-plain-clones --in /home/${{NB_USER}}/ws/src{named}\n" in text, "and what clones need in turn"
    assert text.index("--complete") < text.index("\nRUN install-plain-clones")
    assert "COPY --from=scripts /configure-library /usr/local/bin/" in text
