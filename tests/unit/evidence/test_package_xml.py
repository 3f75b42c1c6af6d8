"""package.xml of every format, also those that are no well-formed XML."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.evidence.facts import PackageManifest
from roslab.evidence.ros import package_xml
from roslab.repository.checkout import Repository


def read(tmp_path: Path, *files: tuple[str, str]) -> tuple[PackageManifest, ...]:
    for path, text in files:
        target = tmp_path / path
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text(text, encoding="utf-8")
    return package_xml.read(Repository.open(tmp_path))


def keys(manifest: PackageManifest, role: str) -> list[str]:
    return [d.name for d in manifest.dependencies if d.role == role]


def test_format_1_has_build_and_run_dependencies(tmp_path: Path) -> None:
    (manifest,) = read(
        tmp_path,
        (
            "package.xml",
            (
                "<package>\n  <name>demo</name>\n  <buildtool_depend>catkin</buildtool_depend>\n"
                "  <build_depend>roscpp</build_depend>\n  <run_depend>tf</run_depend>\n</package>\n"
            ),
        ),
    )
    assert (manifest.name, manifest.format, manifest.build_types) == ("demo", 1, (("catkin", None),))
    assert (keys(manifest, "build"), keys(manifest, "exec"), keys(manifest, "buildtool")) == (
        ["roscpp"],
        ["tf"],
        ["catkin"],
    )
    assert [d.line for d in manifest.dependencies if d.name == "tf"] == [5]


def test_a_depend_of_format_2_is_for_building_and_running(tmp_path: Path) -> None:
    (manifest,) = read(tmp_path, ("package.xml", '<package format="2"><name>a</name><depend>tf2</depend></package>'))
    assert (keys(manifest, "build"), keys(manifest, "exec")) == (["tf2"], ["tf2"])


def test_conditions_of_format_3_are_kept_as_written(tmp_path: Path) -> None:
    (manifest,) = read(
        tmp_path,
        (
            "package.xml",
            (
                '<package format="3"><name>a</name><depend condition="$ROS_VERSION == 2">rclcpp</depend><export>'
                '<build_type condition="$ROS_VERSION == 1">catkin</build_type>'
                '<build_type condition="$ROS_VERSION == 2">ament_cmake</build_type></export></package>'
            ),
        ),
    )
    assert manifest.build_types == (("catkin", "$ROS_VERSION == 1"), ("ament_cmake", "$ROS_VERSION == 2"))
    assert manifest.dependencies[0].condition == "$ROS_VERSION == 2"


def test_the_export_names_where_an_unreleased_package_is(tmp_path: Path) -> None:
    (manifest,) = read(
        tmp_path,
        (
            "package.xml",
            (
                "<package><name>a</name><export>\n"
                '<git_url target="glow" url="https://github.com/jbehley/glow.git" branch="v0.1"/></export></package>'
            ),
        ),
    )
    (source,) = manifest.sources
    assert (source.name, source.ref, source.kind, source.line) == ("glow", "v0.1", "git_url", 2)


@pytest.mark.parametrize("text", ["", "<package><name>a</name", "no xml at all", "<package>" + "<a>" * 3000])
def test_what_is_malformed_is_named_and_read_as_far_as_it_goes(tmp_path: Path, text: str) -> None:
    (manifest,) = read(tmp_path, ("package.xml", text))
    assert manifest.malformed


@pytest.mark.parametrize(
    ("text", "names", "told"),
    [
        ("roscpp  std_msgs\n tf2", ["roscpp", "std_msgs", "tf2"], True),
        (" roscpp\n", ["roscpp"], False),
        ("roscpp (see below)", ["roscpp (see below)"], False),
        ("", [], False),
    ],
)
def test_an_element_with_several_names_is_told_and_names_each(
    tmp_path: Path, text: str, names: list[str], *, told: bool
) -> None:
    xml = f"<package><name>demo</name><build_depend>{text}</build_depend></package>"
    (manifest,) = read(tmp_path, ("package.xml", xml))
    assert keys(manifest, "build") == names
    assert (manifest.together is not None) == told
    assert not manifest.malformed


def test_a_stray_text_loses_no_key(tmp_path: Path) -> None:
    text = (
        "<package>\n<name>a</name>\n<build_depend>roscpp</build_depend>pcl_ros>\n<run_depend>tf</run_depend></package>"
    )
    (manifest,) = read(tmp_path, ("package.xml", text))
    assert [d.name for d in manifest.dependencies] == ["roscpp", "tf"]


def test_a_missing_end_tag_loses_no_key(tmp_path: Path) -> None:
    text = "<package>\n<name>a</name>\n<build_depend>roscpp</build_depend>\n<run_depend>tf</run_depend>\n"
    (manifest,) = read(tmp_path, ("package.xml", text))
    assert manifest.malformed
    assert [d.name for d in manifest.dependencies] == ["roscpp", "tf"]


def test_entities_are_not_read_from_disk(tmp_path: Path) -> None:
    secret = tmp_path / "secret.txt"
    secret.write_text("hidden", encoding="utf-8")
    text = (
        f'<?xml version="1.0"?><!DOCTYPE p [<!ENTITY x SYSTEM "file://{secret}">]>'
        "<package><name>demo</name><depend>&x;</depend><run_depend>tf</run_depend></package>"
    )
    (manifest,) = read(tmp_path, ("package.xml", text))
    assert [d.name for d in manifest.dependencies] == ["tf"]


def test_entities_are_not_expanded(tmp_path: Path) -> None:
    bomb = "".join(f'<!ENTITY {b} "{f"&{a};" * 10}">' for a, b in zip("abcdefgh", "bcdefghi", strict=True))
    text = f'<!DOCTYPE p [<!ENTITY a "ha">{bomb}]><package><name>demo</name><depend>&i;</depend></package>'
    (manifest,) = read(tmp_path, ("package.xml", text))
    assert manifest.dependencies == ()


@pytest.mark.parametrize("marker", ["COLCON_IGNORE", "AMENT_IGNORE", "CATKIN_IGNORE"])
def test_what_lies_below_a_marker_is_ignored(tmp_path: Path, marker: str) -> None:
    xml = "<package><name>a</name></package>"
    found = read(tmp_path, (f"attic/{marker}", ""), ("attic/deep/a/package.xml", xml), ("attica/package.xml", xml))
    assert [(m.file, m.ignored) for m in found] == [("attic/deep/a/package.xml", True), ("attica/package.xml", False)]


def test_another_programs_package_xml_is_passed_over(tmp_path: Path) -> None:
    assert read(tmp_path, ("package.xml", "<pkg><name>a</name></pkg>")) == ()


def test_invalid_bytes_end_in_a_fact_not_in_an_error(tmp_path: Path) -> None:
    (tmp_path / "package.xml").write_bytes(b"<package><name>a\xff</name><depend>tf</depend></package>")
    (manifest,) = package_xml.read(Repository.open(tmp_path))
    assert [d.name for d in manifest.dependencies] == ["tf", "tf"]
