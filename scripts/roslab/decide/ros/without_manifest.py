"""Code of ROS without a package.xml: nothing builds it, and it runs on a machine with ROS alone."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator

from roslab.config.model import Kind
from roslab.decide.cuda.signs import sign_of_cuda
from roslab.decide.programs import top_of
from roslab.decide.reasons import page_of
from roslab.decide.ros.plain_workspace import of_one_ros_alone
from roslab.evidence import places
from roslab.evidence.cmake_project import CMakeProject
from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import Evidence, Mention
from roslab.knowledge.distros import distro
from roslab.knowledge.frameworks import imports
from roslab.values.pattern import pattern

_PACKAGE = pattern(r"ros-([a-z]+)-[a-z0-9]")
CLIENTS = {"rospy": "ros1", "rclpy": "ros2"}
"""ROS's own libraries, which pip's index has not, and the kind of what needs each."""
_KINDS: dict[int, Kind] = {1: "ros1", 2: "ros2"}


def by_cmake(evidence: Evidence) -> tuple[CMakeProject | Dependency, Kind] | None:
    """Return what always requires packages of ROS in a tree without a package.xml, and the kind that brings them.

    That is a CMakeLists.txt with components of catkin, or what the project of the tree finds by its own name and only
    one ROS has: roscpp, rclcpp. That of a submodule, which the project may call make in, makes no package of the tree.
    """
    modules = tuple(f"{git.name}/" for git in evidence.sources if git.kind == "submodule")
    if any(not manifest.file.startswith(modules) for manifest in evidence.manifests):
        return None
    always = [
        project
        for project in evidence.cmake
        if (project.top_level or project.always)
        and not project.file.startswith(modules)
        and not (places.aside(project.file) or places.documentation(project.file))
    ]
    for project in always:
        asks = any(each.namespace == "ros" and each.strength == "declared" for each in project.dependencies)
        if asks and "catkin" in project.macros:
            return project, "ros1"
    top = top_of(evidence)
    for each in (d for p in always if top and p.top == top.top for d in p.dependencies if d.required):
        for version, kind in _KINDS.items():
            if not each.condition and each.namespace == "cmake" and each.name in of_one_ros_alone(version):
                return each, kind
    return None


def client_of(evidence: Evidence) -> Dependency | None:
    """Return the import of ROS's library by the module that is the program; ``None`` where it is a part among others.

    That is the module that imports, at its top, most of what the code takes from pip. What computes on CUDA is none:
    the image of a framework matters more to it.
    """
    used = [d for d in evidence.code if d.namespace == "import" and d.strength == "used" and not places.aside(d.file)]
    clients = [each for each in used if each.name in CLIENTS]
    if not clients or sign_of_cuda(evidence):
        return None
    of_pip = [each.file for each in used if each.name in imports()]
    return next((each for each in clients if 2 * of_pip.count(each.file) >= len(of_pip)), None)


def installed_by_author(evidence: Evidence) -> tuple[Dependency, str, str] | None:
    """Return the package of ROS that the project's Dockerfile installs, with the kind and why, if the code is of that.

    The author's image has it beside CUDA; its programs import ROS's library.
    """
    used = [d for d in evidence.code if d.namespace == "import" and d.strength == "used" and not places.aside(d.file)]
    clients = {CLIENTS[each.name]: each.name for each in used if each.name in CLIENTS}
    for authored in evidence.dockerfiles if len(clients) == 1 and not evidence.manifests else ():
        for each in authored.dependencies if authored.purpose == "project" else ():
            named = _PACKAGE.match(each.name)
            release = distro(named[1]) if named else None
            if release and (client := clients.get(f"ros{release.ros}")):
                return each, f"ros{release.ros}", f"the Dockerfile installs {each.name}, and programs import {client}"
    return None


def run_by_page(evidence: Evidence) -> tuple[Mention, str, str] | None:
    """Return where a page at the root starts what ROS alone runs, with the kind and why; ``None`` if it does not.

    That is a launch file of the tree that belongs to no package, or a node: the first program of the tree that the
    pages start, where no more than half of the others are none.
    """
    said = [m for m in evidence.mentions if m.topic == "command" and m.source == "readme" and "/" not in m.file]
    alone = {launch.file: launch.ros for launch in evidence.launch if not launch.package}
    for mention in said:
        words = mention.value.split()
        for start, ros in ((["roslaunch"], 1), (["ros2", "launch"], 2)):
            file = next(iter(words[len(start) :]), "")
            if words[: len(start)] == start and alone.get(file) == ros:
                return mention, f"ros{ros}", f"{page_of(mention.file)} starts {file}, which belongs to no package"
    clients = {d.name for d in evidence.code if d.name in CLIENTS and d.strength == "used" and not places.aside(d.file)}
    started = list(_started(evidence, said))
    nodes = {program.file for program in evidence.programs if program.kind == "node"}
    nodes &= {file for _, file in started}
    if len(clients) != 1 or not started or started[0][1] not in nodes or sign_of_cuda(evidence):
        return None
    client, files = clients.pop(), {file for _, file in started}
    return (started[0][0], CLIENTS[client], f"its program needs {client}") if 2 * len(nodes) >= len(files) else None


def called_by_program(evidence: Evidence) -> tuple[Mention, str, str] | None:
    """Return where the first program that a page at the root starts calls a tool of ROS, with the kind and why.

    Only where these pages name distributions of that ROS alone, and the code computes nothing on CUDA.
    """
    calls = {m.file: m for m in evidence.mentions if m.topic == "ros_call"}
    pages = [m for m in evidence.mentions if m.source == "readme" and "/" not in m.file] if calls else []
    started = (m.value.split() for m in pages if m.topic == "command" and m.value.startswith("python"))
    files = (posixpath.normpath(word) for words in started for word in words[1:] if word.endswith(".py"))
    file = next(files, "")
    if file not in calls or sign_of_cuda(evidence):
        return None
    call = calls[file]
    version = 2 if call.value.startswith("ros2") else 1
    named = {found.ros for m in pages if m.topic == "distro" and (found := distro(m.value))}
    return (call, _KINDS[version], f"its program calls `{call.value}`") if named == {version} else None


def _started(evidence: Evidence, said: list[Mention]) -> Iterator[tuple[Mention, str]]:
    """Yield the programs of the tree that pages start with Python, in their order."""
    programs = [program.file for program in evidence.programs]
    for mention in said:
        words = mention.value.split() if mention.value.startswith("python") else []
        for word in (posixpath.normpath(word) for word in words[1:] if word.endswith(".py")):
            ends = [file for file in programs if f"/{file}".endswith(f"/{word}")]
            if len(ends) == 1:
                yield mention, ends[0]
