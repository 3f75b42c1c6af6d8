"""Programs that CMake looks for and stops without, and of which no table knows the package."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.decide.decision import Warning_
from roslab.decide.reasons import warn
from roslab.decide.ros.source_names import plain
from roslab.decide.ros.workspace import Packages
from roslab.decide.system.built import Built
from roslab.decide.system.required import programs, similar
from roslab.evidence.facts import Evidence
from roslab.knowledge.compiled import programs as packaged
from roslab.values.pattern import pattern

_OF_ROS = pattern(r"(?:ament|catkin|colcon|gazebo|gz|ign|ros2?|rviz2?|rqt)(?:[_-]|$)|ros[a-z]+$")
"""Programs that come with packages of ROS and its simulators."""
_OF_CUDA = frozenset({"nvcc", "bin2c", "cuobjdump", "fatbinary", "nvdisasm", "nvlink", "nvprune", "ptxas"})
"""Those of CUDA's compiler: https://docs.nvidia.com/cuda/cuda-binary-utilities/, read 2026-11-27."""


def without_programs(evidence: Evidence, packages: Packages, built: Built) -> Iterator[tuple[str, Warning_]]:
    """Yield the file that looks for each such program, with a warning."""
    told: set[str] = set()
    for package, asked in programs(evidence, packages, built.kind):
        name, target = asked.name, built.target
        of_ros = bool(target.ros_distro) and (target.knows(name) or _OF_ROS.match(name))
        there = name in packaged() or of_ros or (target.cuda and name in _OF_CUDA) or similar(plain(name), built.names)
        if name in told or package in built.out or there:
            continue
        told.add(name)
        what = f"CMake looks for the program {name} and stops without it, and nothing is known that brings it"
        then = "name its package under `apt` in roslab.yaml, or install it under `custom`"
        yield asked.file, warn(f"{what}: {built.build_tool} will most likely stop at {package}; {then}", asked)
