"""Every distribution of the table has a Dockerfile that builds it today: exactly this one.

``REPRO_REFRESH=1 pytest tests/golden`` rewrites them: read the diff. What many of them have stands once.
"""

from __future__ import annotations

import os

import pytest

from golden_files import DISTROS, GOLDEN, folded, of_distros
from roslab.knowledge.distros import distros
from roslab.pipeline import plan_repository
from roslab.render.dockerfile import dockerfile

PACKAGE = """\
<package format="3">
  <name>robot</name><version>1.0.0</version><description>x</description>
  <maintainer email="a@example.org">a</maintainer><license>MIT</license>
  <buildtool_depend>{tool}</buildtool_depend><depend>{client}</depend>
</package>
"""
TOOLS = {1: ("catkin", "roscpp", "catkin_package"), 2: ("ament_cmake", "rclcpp", "ament_package")}
CMAKE = "cmake_minimum_required(VERSION 2.8.3)\nproject(robot)\nfind_package({tool} REQUIRED)\n{end}()\n"


@pytest.fixture(scope="module")
def generated(tmp_path_factory: pytest.TempPathFactory) -> dict[str, str]:
    """Return the Dockerfile of one package for each distribution, all of them from this process."""
    place = tmp_path_factory.mktemp("robot") / "robot"
    place.mkdir()
    found = {}
    for name, release in distros().items():
        ros1 = release.ros == 1
        tool, client, end = (
            ("catkin", "roscpp", "catkin_package") if ros1 else ("ament_cmake", "rclcpp", "ament_package")
        )
        (place / "package.xml").write_text(PACKAGE.format(tool=tool, client=client))
        (place / "CMakeLists.txt").write_text(CMAKE.format(tool=tool, end=end))
        (place / "roslab.yaml").write_text(f"format: 3\nbase: {{ros: {name}}}\napt: [libeigen3-dev]\npip: [numpy]\n")
        found[name] = dockerfile(plan_repository(place).plan)
    return found


def test_every_distribution_has_exactly_this_dockerfile(generated: dict[str, str]) -> None:
    if os.environ.get("REPRO_REFRESH") == "1":
        (GOLDEN / DISTROS).mkdir(exist_ok=True)
        for path in (GOLDEN / DISTROS).iterdir():
            path.unlink()
        for name, text in generated.items():
            (GOLDEN / DISTROS / name).write_text(folded("Dockerfile", text))
    kept = of_distros()
    assert sorted(kept) == sorted(generated)
    for name, text in generated.items():
        assert text == kept[name], f"{name} changed: if that is right, REPRO_REFRESH=1 and read the diff"


def test_an_ended_distribution_comes_from_its_snapshot_and_a_maintained_one_knows_of_its_own(
    generated: dict[str, str],
) -> None:
    for name, text in generated.items():
        release = distros()[name]
        (step,) = [line for line in text.splitlines() if line.startswith(" && renew-package-sources ")]
        snapshot = f"http://snapshots.ros.org/{name}/final/ubuntu {release.ubuntu} ros-snapshots"
        before, _, after = step.partition(" --after ")
        assert (snapshot in before) == (release.rosdistro_tag is not None), step
        assert (snapshot in after) == (release.rosdistro_tag is None and not release.never_ends), step
        assert (f"--tables {release.rosdistro_tag}" in text) == (release.rosdistro_tag is not None)
