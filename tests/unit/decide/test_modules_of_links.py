"""Modules of no table are looked for in what a page names of the repository's owner."""

from __future__ import annotations

import subprocess
from pathlib import Path

import pytest

from roslab.pipeline import plan_repository
from roslab.plan.plan import Plan
from roslab.render.dockerfile import dockerfile
from trees import tree_of

LINK = "It needs the library at https://github.com/{}/toolbox.\n"
FILES = {
    "sight/package.xml": "<package><name>sight</name><buildtool_depend>catkin</buildtool_depend></package>",
    "sight/CMakeLists.txt": "project(sight)\nfind_package(catkin REQUIRED)\ncatkin_package()\n",
    "sight/src/look.py": "import rospy\nimport numpy\nfrom FaultFinder import find\n",
}
MAKES = f"{FILES['sight/CMakeLists.txt']}add_library(FaultFinder SHARED a.cpp)\n"


def planned(root: Path, page: str, **files: str) -> Plan:
    tree_of(root, {**FILES, "README.md": f"# Sight\nROS Noetic\n\n{page}", **files})
    subprocess.run(["git", "init", "--quiet"], cwd=root, check=True)
    origin = "https://github.com/lab/sight"
    subprocess.run(["git", "remote", "add", "origin", origin], cwd=root, check=True)
    return plan_repository(root).plan


def test_it_is_looked_for_there(tmp_path: Path) -> None:
    plan = planned(tmp_path, LINK.format("lab"))
    assert [(each.repo, each.holding) for each in plan.workspace.sources] == [
        ("https://github.com/lab/toolbox.git", ("FaultFinder",))
    ]
    text = dockerfile(plan)
    assert "toolbox FaultFinder\n" in text
    assert "--want FaultFinder" not in text
    said = next(each.message for each in plan.warnings if "FaultFinder" in each.message)
    assert "unless toolbox (https://github.com/lab/toolbox) brings it" in said


@pytest.mark.parametrize(
    ("page", "code"),
    [
        (LINK.format("others"), {}),
        (LINK.format("lab"), {"sight/src/look.py": "import rospy\nimport numpy\n"}),
        (LINK.format("lab"), {"sight/src/look.py": "try:\n    import FaultFinder\nexcept ImportError:\n    pass\n"}),
        (LINK.format("lab"), {"sight/src/FaultFinder.py": "find = None\n"}),
        ("See https://github.com/lab/sight.\n", {}),
        (LINK.format("lab"), {"sight/src/look.py": "", "third_party/a/b.py": "import FaultFinder\n"}),
        (LINK.format("lab"), {"sight/CMakeLists.txt": MAKES}),
        (LINK.format("lab"), {"sight/src/look.py": "", "pico/main.py": "import machine\nimport utime\n"}),
    ],
)
def test_what_another_owns_or_a_table_knows_is_not(tmp_path: Path, page: str, code: dict[str, str]) -> None:
    assert planned(tmp_path, page, **code).workspace.sources == ()
