"""Every row of every table has its source, its date, and names that are names."""

from __future__ import annotations

import csv
import re
import sys
from pathlib import Path

import pytest

import roslab.knowledge
from roslab.knowledge import libraries, released
from roslab.knowledge.apt_renames import name_in
from roslab.knowledge.distros import distros, distros_of, rosdistro_tag, ubuntus
from roslab.knowledge.never import never
from roslab.knowledge.recipes import recipe
from roslab.knowledge.ros_sources import ros_sources
from roslab.knowledge.table import rows

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

FOLDER = Path(roslab.knowledge.__file__).parent
TABLES = sorted(path.stem for path in FOLDER.glob("*.csv"))
LIBRARY_TABLES = ("cmake", "pkg_config", "links", "includes", "headers")
APT = re.compile(r"[a-z0-9][a-z0-9.+-]+\Z")
OURS = re.compile(r"^(?:scripts|knowledge|roslab)/")
DATE = re.compile(r"20\d\d-[01]\d-[0-3]\d\Z")
RECIPES = tomllib.loads((FOLDER / "recipes.toml").read_text(encoding="utf-8"))


@pytest.mark.parametrize("table", TABLES)
def test_every_row_has_a_source_and_a_date(table: str) -> None:
    with (FOLDER / f"{table}.csv").open(encoding="utf-8", newline="") as stream:
        reader = csv.reader(stream)
        header = next(reader)
        assert {"source", "date"} <= set(header)
        for number, row in enumerate(reader, 2):
            assert len(row) == len(header), f"{table}.csv:{number} has {len(row)} fields"
            fields = dict(zip(header, row, strict=True))
            assert fields["source"].strip(), f"{table}.csv:{number} has no source"
            assert not OURS.search(fields["source"]), f"{table}.csv:{number}: a file of this project is no source"
            assert DATE.match(fields["date"]), f"{table}.csv:{number}: {fields['date']!r} is no date"


@pytest.mark.parametrize("table", LIBRARY_TABLES)
def test_libraries_name_packages_releases_and_recipes_that_exist(table: str) -> None:
    known = set(ubuntus().values())
    for row in rows(table):
        for name in (*row["apt"].split(), *row.get("beside", "").split()):
            assert APT.match(name), f"{table}: {name!r} is no package name"
        assert set(row["ubuntu"].split()) <= known, row
        assert not row.get("recipe") or row["recipe"] in RECIPES, row


@pytest.mark.parametrize("row", rows("headers"), ids=lambda row: row["header"])
def test_what_a_failed_build_is_told_is_known_before(row: dict[str, str]) -> None:
    assert libraries.header(row["header"], "jammy") is not None


@pytest.mark.parametrize("table", LIBRARY_TABLES)
def test_no_name_has_two_rows_for_one_ubuntu(table: str) -> None:
    seen: set[tuple[str, str]] = set()
    for row in rows(table):
        name = row.get("name") or row.get("module") or row["header"]
        for release in row["ubuntu"].split() or ["*"]:
            assert (name, release) not in seen, f"{table}: {name} twice for {release}"
            seen.add((name, release))


def test_only_one_distribution_of_each_ros_is_the_default() -> None:
    for ros in (1, 2):
        assert len([found for found in distros().values() if found.ros == ros and found.default]) == 1
        assert len([found for found in distros().values() if found.ros == ros and found.never_ends]) == ros - 1


def test_distributions_stand_on_known_ubuntus_and_in_order() -> None:
    for found in distros().values():
        assert found.ubuntu in ubuntus().values()
        assert DATE.match(found.released)
        assert found.eol is None or found.eol > found.released
        assert found.rosdistro_tag is None or re.fullmatch(r"[a-z]+/(?:20\d\d-\d\d-\d\d|final)", found.rosdistro_tag)
    assert distros_of("focal", 1) == ("noetic",)
    assert distros_of("jammy", 2)[0] == "humble"
    assert rosdistro_tag("melodic") == "melodic/2023-06-27"
    assert rosdistro_tag("jazzy") is rosdistro_tag(None) is None


@pytest.mark.parametrize("name", sorted(distros()))
def test_released_packages_are_names(name: str) -> None:
    found = released.released(name)
    assert len(found) > 300
    assert all(re.fullmatch(r"[A-Za-z][\w-]*", package) for package in found)


@pytest.mark.parametrize("name", sorted(RECIPES))
def test_recipes_are_pinned_and_complete(name: str) -> None:
    found = RECIPES[name]
    archives = found.get("archives", {})
    addresses = [archive.format(ref=found["ref"]) for archive in archives.values()] or [found["repo"]]
    assert not archives or (archives.keys() == {"amd64", "arm64"} and found["installs"])
    assert all(address.startswith("https://") for address in addresses)
    assert found["source"].startswith(("https://", "PyPI: "))
    assert DATE.match(str(found["date"]))
    for ref in (
        found["ref"],
        *found.get("ref_on", {}).values(),
        *found.get("releases", {}).values(),
        *found.get("of_day", {}).values(),
    ):
        assert re.fullmatch(r"[0-9a-f]{40}|v?\d[\w.-]*", ref), f"{name}: {ref!r} is no tag or commit"
    assert set(found.get("ref_on", {})) <= set(ubuntus().values())
    assert all(APT.match(package) for package in found.get("depends", ()))
    assert [source.name for source in recipe(name, "focal")] == [*found.get("after", ()), name]


def test_a_library_differs_by_ubuntu() -> None:
    found = {release: libraries.library("cmake", "GeographicLib", release) for release in ("focal", "noble")}
    assert [entry.apt for entry in found.values() if entry] == [("libgeographic-dev",), ("libgeographiclib-dev",)]
    assert libraries.library("cmake", "NoSuchLibrary", "focal") is None
    assert libraries.library("cmake", "OpenMP", "focal") == libraries.Library()


def test_what_cmake_has_itself_is_no_package_of_ros() -> None:
    """A package that a distribution released is installed, and no row says that it needs nothing."""
    nothing = [row["name"] for row in rows("cmake") if not (row["apt"] or row["ros"] or row["recipe"])]
    assert [name for name in nothing if released.ever_released(name)] == []


@pytest.mark.parametrize("name", ["fast_gicp", "ndt_omp", "apriltag_mit"])
def test_a_package_of_ros_that_cmake_asks_for(name: str) -> None:
    assert libraries.library("cmake", name, "jammy") is None
    assert released.ever_released(name)


@pytest.mark.parametrize(
    ("path", "apt"),
    [
        ("Eigen/Core", ("libeigen3-dev",)),
        ("GL/glew.h", ("libglew-dev",)),
        ("opencv2/core.hpp", ("libopencv-dev",)),
        ("boost/bind.hpp", ("libboost-dev",)),
        ("boost/algorithm/string.hpp", ("libboost-dev",)),
        ("boost/thread.hpp", ("libboost-all-dev",)),
        ("boost/filesystem/path.hpp", ("libboost-all-dev",)),
    ],
)
def test_a_header_is_known_by_its_folder_or_its_path(path: str, apt: tuple[str, ...]) -> None:
    found = libraries.header(path, "focal")
    assert found is not None
    assert found.apt == apt


@pytest.mark.parametrize(
    ("path", "ubuntu", "apt"),
    [
        ("dc1394/dc1394.h", "focal", ("libdc1394-22-dev",)),
        ("dc1394/dc1394.h", "noble", ("libdc1394-dev",)),
        ("jasper/jasper.h", "xenial", ("libjasper-dev",)),
        ("jasper/jasper.h", "focal", ()),
        ("ogg/ogg.h", "focal", ("libogg-dev",)),
    ],
)
def test_a_header_of_a_failed_build_is_of_its_ubuntus(path: str, ubuntu: str, apt: tuple[str, ...]) -> None:
    found = libraries.header(path, ubuntu)
    assert found is not None
    assert (found.apt, found.elsewhere) == (apt, not apt)


def test_drivers_are_never_installed() -> None:
    assert all(
        never().match(name)
        for name in ("nvidia-driver-535", "docker.io", "linux-headers-generic", "librealsense2-dkms")
    )
    assert not any(never().match(name) for name in ("libopencv-dev", "nvidia-cuda-toolkit", "cmake"))


def test_a_package_has_its_name_of_each_release() -> None:
    assert [name_in("libgl1", release) for release in ("xenial", "noble")] == ["libgl1-mesa-glx", "libgl1"]
    assert [name_in("libgl1-mesa-glx", release) for release in ("focal", "noble")] == ["libgl1-mesa-glx", "libgl1"]
    assert name_in("libgl1-mesa-glx", "bookworm") == "libgl1"


def test_every_pattern_can_be_compiled() -> None:
    """The program compiles each at its first use."""
    tables = [name for name in TABLES if "pattern" in rows(name)[0]]
    assert len(tables) > 3
    for name in tables:
        for row in rows(name):
            re.compile(row["pattern"])


_SOURCES = rows("ros_sources")
_FAMILIES = {(row["repo"], row["ros"]) for row in _SOURCES}


@pytest.mark.parametrize("row", _SOURCES, ids=lambda row: f"{row['package']}-{row['ros']}")
def test_a_source_of_ros_is_for_distributions_that_lack_it_and_brings_what_it_needs(row: dict[str, str]) -> None:
    ros = int(row["ros"])
    named = row["distros"].split()
    of_ros = [name for name, found in distros().items() if found.ros == ros]
    assert set(named) <= set(of_ros)
    assert re.fullmatch(r"https://[\w.-]+/[\w.-]+/[\w.-]+\.git", row["repo"])
    branch = r"|[A-Za-z][\w.-]*(/[\w.-]+)?|\{distro\}" if ros == 2 else ""  # many ports to ROS 2 are branches
    assert re.fullmatch(rf"[0-9a-f]{{40}}|v?\d[\w.-]*{branch}|", row["ref"]), row["ref"]
    assert not row["library"] or row["library"] in RECIPES
    having = {name for name in distros() if row["package"] in released.released(name)}
    assert not having & {*named}, f"{', '.join(having)} released it"
    assert {*of_ros} - having
    for distro in {*(named or of_ros)} - having:
        there = {source.package for source in ros_sources(row["package"], ros, distro)} | released.released(distro)
        lacking = {*row["after"].split()} - there
        assert not lacking, f"{', '.join(lacking)}, which it needs on {distro}, has no row"


@pytest.mark.parametrize("family", sorted(_FAMILIES), ids=lambda family: family[0].rpartition("/")[2])
def test_one_repository_of_ros_is_taken_once_and_in_one_way(family: tuple[str, str]) -> None:
    ours = [row for row in _SOURCES if (row["repo"], row["ros"]) == family]
    for column in ("ref", "alone", "prepare", "options", "library"):
        assert len({row[column] for row in ours}) == 1, column
    assert len(ours) == 1 or not ours[0]["alone"], "what is alone in its repository has no sister there"
    assert len({row["package"] for row in ours}) == len(ours)
    needed = {name for row in ours for name in row["after"].split()}
    assert needed <= {row["package"] for row in _SOURCES if row["ros"] == family[1]}, "each need has a row"


def test_a_package_has_one_source_for_a_version_of_ros() -> None:
    assert len({(row["package"], row["ros"]) for row in _SOURCES}) == len(_SOURCES)


def test_no_two_sources_of_ros_have_one_folder() -> None:
    folders = {(row["repo"].rpartition("/")[2], row["ros"]) for row in _SOURCES}
    assert len(folders) == len(_FAMILIES)
