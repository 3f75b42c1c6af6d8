"""A repository whose packages all lie in submodules is a workspace: it is built after these are cloned."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.pipeline import plan_repository
from roslab.render.dockerfile import dockerfile
from trees import tree_of

MODULES = '[submodule "arm"]\n\tpath = stack/arm\n\turl = https://github.com/lab/arm.git\n'


@pytest.mark.parametrize(
    ("page", "built"),
    [
        ("ROS Noetic\n```\ncatkin_make\n```\n", "catkin_make"),
        ("ROS 2 Humble\n```\ncolcon build\n```\n", "colcon build"),
        ("ROS Noetic\n", None),
    ],
)
def test_a_workspace_of_submodules(tmp_path: Path, page: str, built: str | None) -> None:
    root = tmp_path / "demo"
    tree_of(root, {".gitmodules": MODULES, "README.md": page})
    plan = plan_repository(root).plan
    assert plan.workspace.folder == ("ws/src/demo" if built else "demo")
    assert plan.workspace.may_fail == (("stack/arm",) if built else ())
    text = dockerfile(plan)
    assert ("leave-out-failed --own src/demo src/demo/stack/arm -- " in text) is bool(built)
    assert built is None or f" {built} " in text.replace("headers-first ", " ")
