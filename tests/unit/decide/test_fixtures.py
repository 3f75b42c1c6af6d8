"""What the tests of a package read is no evidence for the repository."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.config.model import Config
from roslab.decide import decide
from roslab.decide.decision import Decision
from roslab.evidence.gather import gather
from roslab.repository.checkout import Repository

LIST = "- git:\n    uri: https://github.com/acme/tools.git\n    local-name: tools\n"
SCRIPT = "sudo apt-get install -y libsodium-dev\nsudo dpkg -i made_$VERSION.deb\n"


def decided(tmp_path: Path, files: dict[str, str]) -> Decision:
    xml = "<package><name>a</name><buildtool_depend>catkin</buildtool_depend><depend>roscpp</depend></package>"
    made = "project(a)\nfind_package(catkin REQUIRED)\n"
    for path, text in ({"src/a/package.xml": xml, "src/a/CMakeLists.txt": made} | files).items():
        (tmp_path / path).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / path).write_text(text)
    return decide(gather(Repository.open(tmp_path)), Config(), folder_name="thing")


@pytest.mark.parametrize(
    ("folder", "read"),
    [("src/a/test/checks", False), ("src/a/tests", False), ("src/a", True), ("test", True), ("src/test", True)],
)
def test_a_list_or_script_in_the_test_folder_of_a_package_is_a_fixture(tmp_path: Path, folder: str, read: bool) -> None:
    made = decided(tmp_path, {f"{folder}/full.rosinstall": LIST, f"{folder}/make_packages.sh": SCRIPT})
    assert any(source.name == "tools" for source in gather(Repository.open(tmp_path)).sources) == read
    assert any("dpkg -i" in warning.message for warning in made.warnings) == read


@pytest.mark.parametrize(("folder", "told"), [("src/a/test/fake", False), ("src/old", True)])
def test_a_package_of_rosbuild_below_tests_is_not_told_as_unbuilt(tmp_path: Path, folder: str, told: bool) -> None:
    made = decided(tmp_path, {f"{folder}/CMakeLists.txt": "include(rosbuild)\nrosbuild_init()\n"})
    assert any("rosbuild's packages" in warning.message for warning in made.warnings) == told
