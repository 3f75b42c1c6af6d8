"""Launch files of ROS 1 and 2 (XML, Python, YAML).

They are searched by patterns, not parsed: a launch file in Python is a program, one in XML is full of substitutions,
and a package's name looks the same in all of them.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from typing import TypedDict

from roslab.evidence import places
from roslab.evidence.dependency import Dependency, Strength
from roslab.evidence.launch_file import LaunchFile
from roslab.evidence.lex.lines import matches_at, matching_lines
from roslab.evidence.lex.xml_comments import without_xml_comments
from roslab.evidence.ros import better_launch, demanded_arguments, launch_programs, launch_variables, reached
from roslab.evidence.ros.declared_arguments import declared_arguments
from roslab.evidence.ros.executed import executed
from roslab.evidence.ros.included_launches import included
from roslab.evidence.ros.launch_conditions import conditional, kept_by, started
from roslab.evidence.ros.launch_switches import switches
from roslab.evidence.ros.named_interpreters import named_interpreters
from roslab.evidence.ros.own_plugins import without_own
from roslab.evidence.ros.to_fill import to_fill
from roslab.evidence.ros.uninstalled import marked
from roslab.evidence.ros.unmade_nodes import with_unmade
from roslab.evidence.ros.worlds import opens_window
from roslab.repository.checkout import File, Repository, nearest
from roslab.values.dataclass import replace
from roslab.values.pattern import pattern

MAX_SIZE = 256 * 1024
MAX_FILES = 800
"""Most launch files, and most parameter files, that are opened, those nearest to the root first."""
_XML = pattern(r"\.launch$|\.launch\.xml$|\.launch\.inc$|\.test$")
_PYTHON = pattern(r"(?:\.launch|_launch|[-_.]?launch[-_]\w+|^launch)\.py$")
_YAML = pattern(r"\.launch\.ya?ml$|_launch\.ya?ml$")
_PACKAGE = r"[a-z][a-z0-9_-]{1,60}"
_ATTRIBUTE = pattern(rf"\bpkg\s*[=:]\s*[\"']?({_PACKAGE})\b(?![\w/$(])")
FIND = pattern(rf"\$\(\s*find(?:-pkg-share|-pkg-prefix)?\s+['\"]?({_PACKAGE})['\"]?\s*\)|package://({_PACKAGE})/")
_PYTHON_PACKAGE = pattern(
    rf"(?:FindPackage(?:Share|Prefix)|get_package_(?:share_directory|prefix|share_path|path))"
    rf"\(\s*(?:package\s*=\s*)?[\"']({_PACKAGE})[\"']"
    rf"|\b(?:package|node_package|pkg)\s*=\s*[\"']({_PACKAGE})[\"']|\bros2\s+(?:run|launch)\s+({_PACKAGE})\b"
)
_NODELET = pattern(rf"\bload\s+({_PACKAGE})/[A-Za-z]")
_PLUGIN = pattern(
    rf"^[ \t]{{0,99}}(?:-[ \t]{{0,99}})?(?:\{{[ \t]{{0,99}})?(?:name[ \t]*:[ \t]*\S+[ \t]*,[ \t]*)?"
    rf"(?:plugin|type|base_(?:local|global)_planner|planner_plugin|class|kinematics_solver)[ \t]*:[ \t]*"
    rf"[\"']?({_PACKAGE})(?:/|::)[A-Z]\w+",
    re.MULTILINE,
)
_PARAM_PLUGIN = pattern(
    rf"name=\"(?:base_(?:local|global)_planner|planning_plugin)\"\s+(?:default|value)=\"({_PACKAGE})(?:/|::)[A-Z]"
)
_WORDS: dict[re.Pattern[str], tuple[str, ...]] = {
    _ATTRIBUTE: ("pkg",),
    FIND: ("$(", "package://"),
    _PYTHON_PACKAGE: ("FindPackage", "get_package_", "package", "node_package", "pkg", "ros2"),
    _NODELET: ("load",),
    _PARAM_PLUGIN: ('name="base_', 'name="planning_plugin'),
}
"""What every match of a pattern begins with, one of them."""
_PLUGINS = ("plugin", "type", "planner", "class", "kinematics_solver")
"""What stands on every line that ``_PLUGIN`` matches."""
_NEW = pattern(r"find-pkg-share|<node_container|\bexec=|\bnamespace=|<composable_node")
"""Words that only ROS 2 uses in XML launch files."""
_NEWER = ("find-pkg-share", "<node_container", "exec=", "namespace=", "<composable_node")
"""What stands in its matches."""
_GUI = pattern(r"\b(?:rviz2?|rqt\w*|gzclient|gzweb|plotjuggler|image_view|foxglove_studio)\b")
_VIEWERS = ("rviz", "rqt", "gzclient", "gzweb", "plotjuggler", "image_view", "foxglove_studio")
"""What its matches begin with."""
_NAMES = pattern(r"\b(?:pkg|package|type|exec|executable|plugin|cmd)\s?=\s?\[?\s?[\"']\Z")
"""What stands before the name of a viewer that is started."""
_OF_LAUNCH = pattern(r"[\w.-]{0,60}(?:\.|_)launch\b")
"""What follows it in the name of a launch file."""
_REMARK = pattern(r"\n[ \t]*#[^\n]*")
"""That of a hash begins with the end of the line before, which is found many times faster than its own beginning."""
_NAME = pattern(r"<name>\s*([\w-]+)\s*</name>")
_STARTED = pattern(r"<(node|test)\s([^>]{0,2000})>")
_STARTS = pattern(r"<(?:node|test|include|executable|composable_node|(?:ros_)?gz_)")
"""What begins an element of XML that starts something: ``gz_server`` and ``ros_gz_bridge`` start Gazebo and its bridge.

https://gazebosim.org/docs/all/ros2_launch_gazebo, read 2026-11-29
"""
_SETS = pattern(r"<(?:ros)?param\b")
"""One that sets a parameter."""
_QUOTED = pattern(r"([\w-]+)\s*=\s*[\"']([^\"']*)[\"']")
_NO_PACKAGE = frozenset({"find", "pkg", "package", "name", "python", "python3", "self"})


def read(repository: Repository) -> tuple[LaunchFile, ...]:
    """Return every launch file, sorted by path, with the packages that it starts or finds files in."""
    packages = repository.once(names_by_folder)
    found = []
    for file in _candidates(repository):
        text = repository.read(file)
        python, xml = file.name.endswith(".py"), _XML.search(file.name) or file.name.endswith(".xml")
        if not (better_launch.is_launch_file(file.name, text) if python else not xml or "<launch" in text):
            continue
        text = without_xml_comments(text) if xml else _REMARK.sub("\n", f"\n{text}")[1:]
        old = bool(xml) and not _new(text) and not file.name.endswith(".launch.xml")
        owner = places.innermost(file.folder, packages)
        package = None if owner is None else packages[owner]
        found.append(
            LaunchFile(
                file=file.path,
                line=1,
                package=package,
                ros=1 if old else 2,
                dependencies=tuple(_named(without_own(text, repository, packages.values()), file, python=python)),
                gui=_shows(text) or opens_window(text, conditional, python=python),
                viewers=_waiting(text),
                includes=included(text, file.name, package),
                nodes=tuple(dict.fromkeys(launch_programs.nodes(text, started))),
                executes=tuple(executed(text, started)) if python else (),
                idle=bool(xml) and bool(_SETS.search(text)) and not _STARTS.search(text),
                to_fill=tuple(to_fill(text)) if xml else (),
                interpreters=named_interpreters(text),
                arguments=declared_arguments(text),
                demands=demanded_arguments.in_xml(text)
                if xml
                else demanded_arguments.in_python(text)
                if python
                else (),
                switches=switches(text) if old else (),
                variables=launch_variables.needed(text, conditional) if xml else (),
                **_tested(text, repository if old else None),
            )
        )
    whole = reached.with_reached(repository, tuple(found), packages, conditional)
    return with_unmade(marked(whole, repository, packages), repository, packages)


def _new(text: str) -> bool:
    """Tell whether an XML file uses a word that only ROS 2 knows."""
    return any(word in text for word in _NEWER) and bool(_NEW.search(text))


def _shows(text: str) -> bool:
    """Tell whether a file names a viewer: yes unless every one it starts has a condition that is false by default."""
    found = list(matches_at(_GUI, text, *_VIEWERS))
    named = _started_viewers(text)
    included = any(_OF_LAUNCH.match(text, match.end()) for match in found)
    waiting = named and all(started(text, match.start(), match.end()) is False for match in named)
    return bool(found) and not (waiting and not included)


def _waiting(text: str) -> tuple[tuple[str, str], ...]:
    """Return the arguments that keep viewers from being started, each with the value by which it does."""
    return tuple(
        dict.fromkeys(each for found in _started_viewers(text) for each in kept_by(text, found.start(), found.end()))
    )


def _started_viewers(text: str) -> list[re.Match[str]]:
    found = matches_at(_GUI, text, *_VIEWERS)
    return [match for match in found if _NAMES.search(text, max(0, match.start() - 40), match.start())]


class _Tested(TypedDict):
    tests: int
    compiled: tuple[tuple[str, str], ...]


def _tested(text: str, repository: Repository | None) -> _Tested:
    """Return the fields of a file's tests for rostest; ``None`` for a file of ROS 2, which has none."""
    if repository is None or "<test" not in text:
        return _Tested(tests=0, compiled=())
    tags = [(match[1], dict(_QUOTED.findall(match[2]))) for match in _STARTED.finditer(text)]
    programs = ((said.get("pkg", ""), said.get("type", "")) for _, said in tags)
    return _Tested(
        tests=sum(tag == "test" for tag, _ in tags),
        compiled=tuple(dict.fromkeys(each for each in programs if not repository.named(each[1]))),
    )


def _candidates(repository: Repository) -> list[File]:
    named = (
        file
        for file in repository.suffixed(".launch", ".xml", ".py", ".yaml", ".yml", ".inc", ".test")
        if file.size <= MAX_SIZE
        and (
            _XML.search(file.name)
            or _PYTHON.search(file.name)
            or _YAML.search(file.name)
            or (file.name.endswith((".xml", ".py")) and file.folder.endswith("launch"))
        )
        and not places.vendored(file.path)
    )
    return sorted(_nearest(named), key=lambda file: file.path)


def _nearest(files: Iterable[File]) -> list[File]:
    return nearest(files)[:MAX_FILES]


def _named(text: str, file: File, *, python: bool) -> Iterator[Dependency]:
    patterns = (_PYTHON_PACKAGE, _NODELET, _PLUGIN) if python else (_ATTRIBUTE, FIND, _NODELET, _PARAM_PLUGIN, _PLUGIN)
    seen: set[str] = set()
    for dependency in matches(text, file, patterns):
        if dependency.name not in seen:
            seen.add(dependency.name)
            yield dependency
    yield from launch_programs.started_first(text, file, conditional)
    for match, waiting in better_launch.named(text):
        if match[1] not in seen:
            asked = _of_ros(match[1], match, text, file)
            yield replace(asked, strength="optional") if waiting else asked
    asked_by = launch_programs.of_parameters(text)
    yield from (_of_ros(match[1], match, text, file) for match in asked_by if match[1] not in seen)


def matches(text: str, file: File, patterns: tuple[re.Pattern[str], ...]) -> Iterator[Dependency]:
    """Yield the package of each match; one under a condition is optional."""
    for each in patterns:
        line_by_line = each is _PLUGIN
        for match in matching_lines(each, text, *_PLUGINS) if line_by_line else matches_at(each, text, *_WORDS[each]):
            name = next(group for group in match.groups() if group)
            if each in (_PLUGIN, _PARAM_PLUGIN, _NODELET):
                from roslab.knowledge.plugin_classes import plugin_package  # noqa: PLC0415 - few trees name plugins

                name = plugin_package(name)
            if name and name not in _NO_PACKAGE:
                yield _of_ros(name, match, text, file)


def _of_ros(name: str, match: re.Match[str], text: str, file: File) -> Dependency:
    strength: Strength = "optional" if conditional(text, match.start(), match.end()) else "used"
    return Dependency(
        namespace="ros", name=name, strength=strength, file=file.path, line=_line(text, match), role="exec"
    )


def _line(text: str, match: re.Match[str]) -> int:
    return text.count("\n", 0, match.start()) + 1


def names_by_folder(repository: Repository) -> dict[str, str]:
    """Return ``{folder: package}`` of the package.xml files; a package of rosbuild is named like its folder."""
    found = {file.folder: file.folder.rpartition("/")[2] for file in repository.named("manifest.xml") if file.folder}
    for file in repository.named("package.xml"):
        match = _NAME.search(repository.read(file))
        if match:
            found[file.folder] = match[1]
    return found
