"""Of a repository that only launch files want something of, the rest is hidden from the build tool at once."""

from __future__ import annotations

import re
import subprocess
from pathlib import Path

import pytest

from roslab.pipeline import plan_repository
from roslab.render.dockerfile import dockerfile
from trees import tree_of

PACKAGE = "<package><name>{}</name><buildtool_depend>catkin</buildtool_depend>{}</package>"
LAUNCH = '<launch><include file="$(find rotors_description)/launch/a.launch"/></launch>'


def _tree(tmp_path: Path, needs: str, page: str = "ROS Noetic\n") -> str:
    files = {
        "package.xml": PACKAGE.format("demo", needs),
        "CMakeLists.txt": "project(demo)\nfind_package(catkin REQUIRED)\n",
        "launch/demo.launch": LAUNCH,
        "README.md": page,
    }
    tree_of(tmp_path, files)
    return dockerfile(plan_repository(tmp_path).plan)


@pytest.mark.parametrize(("needs", "hides"), [("", True), ("<depend>rotors_description</depend>", False)])
def test_only_what_a_launch_file_wants_is_compiled(tmp_path: Path, needs: str, *, hides: bool) -> None:
    text = _tree(tmp_path, needs)
    assert "rotors_simulator.git" in text
    asked = r'needed="\$\(workspace-packages needed \S+/rotors_simulator rotors_description \| cut --fields=1\)"'
    call = r"then workspace-packages hide \S+/rotors_simulator \$\{needed\} >/dev/null; else echo"
    assert (bool(re.search(asked, text)), bool(re.search(call, text))) == (hides, hides)


@pytest.mark.parametrize(
    ("needs", "page", "hides"),
    [
        ("<depend>voxblox_msgs</depend>", "", True),
        ("<depend>voxblox_msgs</depend><depend>voxblox</depend>", "", False),
        ("<depend>voxblox_msgs</depend>", "```\ngit clone https://github.com/ethz-asl/voxblox.git\n```\n", False),
    ],
)
def test_messages_need_no_library_beside_them(tmp_path: Path, needs: str, page: str, *, hides: bool) -> None:
    text = _tree(tmp_path, needs, f"ROS Noetic\n{page}")
    assert "ethz-asl/voxblox.git" in text
    assert bool(re.search(r'needed="\$\(workspace-packages needed \S+/voxblox voxblox_msgs \|', text)) == hides
    if hides:
        assert "catkin_simple.git" in text
        assert "minkindr.git" not in text


@pytest.mark.usefixtures("scripts_on_path")
def test_what_makes_the_plugins_of_a_model_is_needed(tmp_path: Path) -> None:
    for name, needs in {"model": "", "plugins": "<depend>comm</depend>", "comm": "", "viewer": ""}.items():
        (tmp_path / name).mkdir()
        (tmp_path / name / "package.xml").write_text(PACKAGE.format(name, needs))
        (tmp_path / name / "CMakeLists.txt").write_text(f"add_library({name}_wheel a.cpp)\n")
    (tmp_path / "model/a.xacro").write_text('<plugin filename="libplugins_wheel.so"/><plugin filename="libgone.so"/>')
    done = subprocess.run(
        ["workspace-packages", "needed", str(tmp_path), "model"], capture_output=True, text=True, check=True
    )
    assert [line.split("\t")[0] for line in done.stdout.splitlines()] == ["model", "plugins", "comm"]


def test_what_may_be_another_package_of_it_is_not_hidden(tmp_path: Path) -> None:
    needs = "<depend>voxblox_msgs</depend><depend>voxblox_new_msgs</depend>"
    assert "/voxblox voxblox_msgs voxblox_new_msgs |" in _tree(tmp_path, needs)
