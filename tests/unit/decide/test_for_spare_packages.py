"""Libraries from source for packages that the default command does not need: where they fail, nothing else stops."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.pipeline import plan_repository
from roslab.render.dockerfile import dockerfile
from trees import tree_of

MANIFEST = """<package format="3"><name>{name}</name><version>1.0.0</version><description>a</description>
<maintainer email="a@example.org">a</maintainer><license>MIT</license><buildtool_depend>ament_cmake</buildtool_depend>
<depend>rclcpp</depend>{more}<export><build_type>ament_cmake</build_type></export></package>
"""
PAGE = "# Sight\n\n## Dependencies\n- [acme-sight](https://github.com/acme/acme-sight): compile it\n"
STARTED = "# Robot\nROS 2 Humble\n\n## Usage\n```\nros2 launch drive drive.launch.py\n```\n"


def _package(name: str, *found: str, more: str = "") -> dict[str, str]:
    finds = "".join(f"find_package({each} REQUIRED)\n" for each in ("ament_cmake", "rclcpp", *found))
    return {
        f"{name}/package.xml": MANIFEST.format(name=name, more=more),
        f"{name}/CMakeLists.txt": f"cmake_minimum_required(VERSION 3.8)\nproject({name})\n{finds}ament_package()\n",
    }


def planned(root: Path, page: str = STARTED, **files: str) -> tuple[list[tuple[str, bool]], tuple[str, ...], str]:
    """Return the libraries, each with whether its failure stops nothing, the packages that may fail, the Dockerfile."""
    launch = {"drive/launch/drive.launch.py": "from launch import LaunchDescription\n"}
    written = {**_package("drive"), **_package("sight", "acme-sight"), "sight/README.md": PAGE, "README.md": page}
    tree_of(root, {**written, **launch, **files})
    plan = plan_repository(root).plan
    return [(each.name, each.unasked) for each in plan.libraries], plan.workspace.may_fail, dockerfile(plan)


def test_what_one_package_aside_asks_for_stops_nothing(tmp_path: Path) -> None:
    libraries, may_fail, text = planned(tmp_path / "robot")
    assert libraries == [("acme-sight", True)]
    assert may_fail == ("sight",)
    assert "roslab: left out: acme-sight cannot be built, which nothing that must be there requires" in text
    assert "leave-out-failed --keep drive src/robot/sight -- " in text


@pytest.mark.parametrize(
    ("page", "files"),
    [
        (STARTED, _package("drive", more="<depend>sight</depend>")),  # it compiles with that
        (STARTED, _package("drive", "acme-sight")),
        (STARTED.replace("drive drive", "sight sight"), {"sight/launch/sight.launch.py": "import launch\n"}),
        ("# Robot\nROS 2 Humble\n", {"sight/launch/sight.launch.py": "import launch\n"}),  # a shell is started
    ],
)
def test_what_the_default_command_needs_stops_the_build(tmp_path: Path, page: str, files: dict[str, str]) -> None:
    libraries, may_fail, text = planned(tmp_path, page, **files)
    assert (libraries, may_fail) == ([("acme-sight", False)], ())
    assert "acme-sight" in text
    assert "cannot be compiled: the build stops" in text


def test_what_only_a_package_that_is_left_out_asks_for_is_not_built(tmp_path: Path) -> None:
    libraries, _, text = planned(tmp_path, **_package("sight", "acme-sight", "closed-driver"))
    assert libraries == []
    assert "--packages-skip sight" in text


def test_the_warning_says_for_whom_it_is_built(tmp_path: Path) -> None:
    planned(tmp_path)
    said = [each for each in plan_repository(tmp_path).plan.warnings if "acme-sight" in each.message]
    what = "acme-sight is built for sight, which the default command does not need"
    assert [(each.message, each.file) for each in said] == [
        (f"{what}: where it cannot be built, the image goes without", "sight/README.md")
    ]
