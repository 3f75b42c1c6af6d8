"""CMake files beside packages that setup.py builds: colcon does not read them, they are of another ROS."""

from __future__ import annotations

from roslab.evidence.cmake_project import CMakeProject
from roslab.evidence.facts import PackageManifest


def without(projects: tuple[CMakeProject, ...], manifests: tuple[PackageManifest, ...]) -> tuple[CMakeProject, ...]:
    """Return the projects without those that lie beside the package.xml of a package for setup.py alone."""
    alone = {m.file.rpartition("/")[0] for m in manifests if {name for name, _ in m.build_types} == {"ament_python"}}
    return tuple(each for each in projects if each.file.rpartition("/")[0] not in alone)
