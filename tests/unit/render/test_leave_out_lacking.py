"""The script that hides packages where nothing brings what they require."""

from __future__ import annotations

import subprocess
from pathlib import Path

import pytest

from roslab.pipeline import plan_repository
from roslab.render.dockerfile import dockerfile

pytestmark = pytest.mark.usefixtures("scripts_on_path")


def _package(folder: Path, name: str) -> None:
    folder.mkdir(parents=True)
    needs = "<depend>quad_x</depend>" if name == "extra" else ""
    text = f"<package>\n<name>{name}</name>\n<buildtool_depend>catkin</buildtool_depend>{needs}\n</package>\n"
    (folder / "package.xml").write_text(text)
    found = " COMPONENTS quad_x" if name == "extra" else ""
    (folder / "CMakeLists.txt").write_text(f"project({name})\nfind_package(catkin REQUIRED{found})\n")


@pytest.mark.parametrize(("cloned", "hidden"), [("quad_x", False), ("other", True)])
def test_what_a_clone_brings_is_built(tmp_path: Path, cloned: str, hidden: bool) -> None:
    _package(tmp_path / "src/mine/extra", "extra")
    _package(tmp_path / "src/clone", cloned)
    ran = subprocess.run(
        ["leave-out-lacking", "quad_x", "src/mine/extra"], cwd=tmp_path, capture_output=True, text=True, check=True
    )
    assert (tmp_path / "src/mine/extra/CATKIN_IGNORE").exists() == hidden
    assert (tmp_path / "src/mine/extra/COLCON_IGNORE").exists() == hidden
    assert ("nothing brings quad_x" in ran.stdout) == hidden


@pytest.mark.parametrize(
    ("noted", "asks", "hidden"),
    [
        ("quad_x", "find_package( quad_x REQUIRED)", False),
        ("quad_x", "find_package(catkin REQUIRED COMPONENTS quad_x)", True),
        ("quad_xy", "find_package(quad_x REQUIRED)", True),
    ],
)
def test_a_plain_library_is_found_by_its_name_and_not_by_catkin(
    tmp_path: Path, noted: str, asks: str, hidden: bool
) -> None:
    for name in ("extra", "above"):
        _package(tmp_path / "src/mine" / name, name)
    (tmp_path / "src/mine/extra/CMakeLists.txt").write_text(f"project(extra)\n{asks}\n")
    (tmp_path / "src/quad/.git").mkdir(parents=True)
    (tmp_path / "src/quad/.git/roslab-plain").write_text(f"{noted}\n")
    folders = ["src/mine/extra", "src/mine/above"]
    subprocess.run(["leave-out-lacking", "quad_x", *folders], cwd=tmp_path, check=True)
    assert [(tmp_path / folder / "CATKIN_IGNORE").exists() for folder in folders] == [hidden, hidden]


def test_the_image_calls_it_with_all_that_it_calls(tmp_path: Path) -> None:
    for name in ("mpc", "extra"):
        _package(tmp_path / name, name)
    (tmp_path / ".git").mkdir()
    (tmp_path / ".git/config").write_text('[remote "origin"]\n\turl = https://github.com/lab/mpc\n')
    (tmp_path / "README.md").write_text("ROS Noetic. Used with https://github.com/lab/control.\n")
    text = dockerfile(plan_repository(tmp_path).plan)
    assert " && leave-out-lacking quad_x /home/${NB_USER}/ws/src/mpc/extra \\\n" in text
    assert " && raise-standard 14 'PCL pcl " in text
    assert " libpcl-all-dev' src --but src/mpc \\\n" in text
    called = (
        "/build-needed /plain-apart /warnings-pass /headers-first /read-manifest /workspace-packages /required-by-cmake"
    )
    assert f"/leave-out-lacking /declare-needs /raise-standard /leave-out-failed {called} " in text
