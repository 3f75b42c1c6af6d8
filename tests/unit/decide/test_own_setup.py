"""Scripts that source the workspace from the repository's own folder find it there."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.pipeline import plan_repository
from roslab.render.dockerfile import dockerfile

MANIFEST = (
    "<package format='3'><name>{}</name><version>0.1.0</version>"
    "<buildtool_depend>ament_cmake</buildtool_depend></package>"
)
CMAKE = "cmake_minimum_required(VERSION 3.8)\nproject(demo)\nfind_package(ament_cmake REQUIRED)\nament_package()\n"
HERE = '#!/bin/bash\nhere=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)\n'
ABOVE = HERE.replace(']}")"', ']}")/.."')
SOURCED = 'source "$here/install/setup.bash"\nros2 launch demo map.launch.py\n'


@pytest.mark.parametrize(
    ("script", "text", "linked"),
    [
        ("run.sh", HERE + SOURCED, True),
        ("tools/run.sh", ABOVE + SOURCED, True),
        ("tools/run.sh", HERE + SOURCED, False),
        ("run.sh", ABOVE + SOURCED, False),  # of the workspace that the repository lies in
        ("run.sh", "here=$HOME/ws\n" + SOURCED, False),
        ("run.sh", HERE + SOURCED.replace("install", "devel"), False),
    ],
)
@pytest.mark.parametrize("folder", ["demo", "src/demo"])
def test_the_setup_script_is_linked_where_scripts_look_for_it(
    tmp_path: Path, folder: str, script: str, text: str, *, linked: bool
) -> None:
    files = {f"{folder}/package.xml": MANIFEST.format("demo"), f"{folder}/CMakeLists.txt": CMAKE, script: text}
    for path, written in files.items():
        (tmp_path / path).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / path).write_text(written)
    plan = plan_repository(tmp_path).plan
    overlay = folder == "demo"
    inside = (f"{plan.workspace.folder}/install", "../../install")
    assert (inside in plan.workspace.links) == (linked and overlay)
    line = f"|| ln --symbolic ../../install /home/${{NB_USER}}/{plan.workspace.folder}/install"
    assert (line in dockerfile(plan)) == (linked and overlay)
