"""Folders with repositories of others, whose packages do not stop the build of a workspace."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.pipeline import plan_repository
from roslab.render.dockerfile import dockerfile

MANIFEST = (
    "<package format='3'><name>{}</name><version>0.1.0</version>"
    "<buildtool_depend>ament_cmake</buildtool_depend></package>"
)
CMAKE = "cmake_minimum_required(VERSION 3.8)\nproject({})\nfind_package(ament_cmake REQUIRED)\nament_package()\n"


def planned(root: Path, packages: list[str], others: tuple[str, ...] = ()) -> tuple[tuple[str, ...], str]:
    """Return the folders that are apart, and the Dockerfile."""
    for path in packages:
        (root / path).mkdir(parents=True)
        (root / path / "package.xml").write_text(MANIFEST.format(path.rpartition("/")[2]))
        (root / path / "CMakeLists.txt").write_text(CMAKE.format(path.rpartition("/")[2]))
    for path in others:
        (root / path).parent.mkdir(parents=True, exist_ok=True)
        (root / path).write_text("text\n")
    plan = plan_repository(root).plan
    return plan.workspace.apart, dockerfile(plan)


WHOLE = ("camera/LICENSE", "camera/README.md")


def test_a_copied_repository_stops_no_build(tmp_path: Path) -> None:
    apart, text = planned(tmp_path, ["mine", "camera/driver", "camera/msgs"], WHOLE)
    assert apart == ("camera",)
    folder = f"src/{tmp_path.name}/camera"
    assert f"leave-out-failed {folder} -- build-needed --apart camera src/{tmp_path.name} " in text


@pytest.mark.parametrize(
    ("packages", "others"),
    [
        (["mine", "camera/driver"], ("camera/LICENSE",)),  # a part of its own
        (["mine", "camera"], WHOLE),  # a package with a licence
        (["camera/driver", "camera/msgs"], WHOLE),  # all that there is
    ],
)
def test_its_own_packages_are_not(tmp_path: Path, packages: list[str], others: tuple[str, ...]) -> None:
    apart, text = planned(tmp_path, packages, others)
    assert apart == ()
    assert "leave-out-failed" not in text
