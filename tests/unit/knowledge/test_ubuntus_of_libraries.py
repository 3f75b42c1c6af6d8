"""What one name of a library has for an Ubuntu, its other names have too; what only ROS has there is taken from it."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator

import pytest

from roslab.decide.system.names import Target, resolve
from roslab.evidence.dependency import Dependency
from roslab.knowledge.distros import ubuntus
from roslab.knowledge.table import rows

NAMES = {"cmake": "name", "pkg_config": "module", "links": "name", "includes": "header", "headers": "header"}
OTHERWISE = {
    "Box2D": "older releases, with a capital",
    "Box2D/": "older releases, with a capital",
    "box2d": "newer releases, in small letters",
    "box2d/": "newer releases, in small letters",
    "Geographic": "called GeographicLib since 2.0",
    "GoogleTest": "older packages have no configuration file",
    "PythonExtensions": "a module of scikit-build, which older releases lack",
    "QGLViewer": "the library of xenial has Qt's release in its name",
}
"""Names without the package of others on an Ubuntu, and why that is right."""


def _holes() -> Iterator[str]:
    entries: dict[tuple[str, str], list[dict[str, str]]] = defaultdict(list)
    for table, key in NAMES.items():
        for row in rows(table):
            entries[table, row[key]].append(row)
    there = {
        (apt, u) for found in entries.values() for r in found for u in r["ubuntu"].split() for apt in r["apt"].split()
    }
    for (_, name), found in entries.items():
        covered = {release for row in found for release in row["ubuntu"].split() or ubuntus().values()}
        packages = {apt for row in found for apt in row["apt"].split()}
        if any((apt, release) in there for apt in packages for release in {*ubuntus().values()} - covered):
            yield name


def test_no_name_lacks_what_another_one_has() -> None:
    assert {*_holes()} == {*OTHERWISE}


def _asked(namespace: str, name: str, ros: str | None, ubuntu: str) -> tuple[tuple[str, ...], bool]:
    asked = Dependency(namespace=namespace, name=name, strength="declared", file="a", line=1, role="build")  # type: ignore[arg-type]
    found = resolve(asked, Target(ros_distro=ros, ubuntu=ubuntu))
    return found.apt, found.known


@pytest.mark.parametrize(
    ("namespace", "name", "ros", "ubuntu", "apt"),
    [
        ("cmake", "KDL", "indigo", "trusty", "ros-indigo-orocos-kdl"),
        ("cmake", "orocos_kdl", "kinetic", "xenial", "ros-kinetic-orocos-kdl"),
        ("pkg-config", "orocos-kdl", "kinetic", "xenial", "ros-kinetic-orocos-kdl"),
        ("cmake", "KDL", "melodic", "bionic", "liborocos-kdl-dev"),
        ("cmake", "KDL", None, "trusty", ""),
        ("cmake", "nanoflann", "kinetic", "xenial", ""),
        ("cmake", "VTK", "indigo", "trusty", "libvtk5-dev"),
        ("cmake", "PNG", "indigo", "trusty", "libpng12-dev"),
        ("include", "GeographicLib/Geodesic.hpp", "indigo", "trusty", "libgeographiclib-dev"),
        ("pkg-config", "libdc1394-2", "indigo", "trusty", "libdc1394-22-dev"),
    ],
)
def test_older_ubuntus(namespace: str, name: str, ros: str | None, ubuntu: str, apt: str) -> None:
    assert _asked(namespace, name, ros, ubuntu) == (((apt,), True) if apt else ((), False))
