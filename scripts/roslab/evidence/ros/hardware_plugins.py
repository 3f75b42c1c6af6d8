"""The hardware of ros2_control that robot descriptions load, which few package.xml name."""

from __future__ import annotations

from roslab.evidence import places
from roslab.evidence.dependency import Dependency
from roslab.evidence.lex.xml_comments import without_xml_comments
from roslab.repository.checkout import Repository, nearest
from roslab.values.pattern import pattern

MAX_SIZE = 256 * 1024
MAX_FILES = 800
"""Most files that are opened, those nearest to the root first."""
_PART = pattern(
    r"<(?P<end>/?)hardware(?=[\s>])|<plugin>\s{0,99}(?P<package>[a-z][a-z0-9_]{1,80})/\w{1,80}\s{0,99}</plugin>"
)
"""Where hardware begins or ends, and a plugin by its package and its class.
https://control.ros.org/jazzy/doc/getting_started/getting_started.html#hardware-description-in-urdf, read 2026-11-27."""


def read(repository: Repository) -> tuple[Dependency, ...]:
    """Return the packages of the plugins, each once, where it is loaded first."""
    described = repository.suffixed(".xacro", ".urdf")
    files = [file for file in described if file.size <= MAX_SIZE and not places.vendored(file.path)]
    found: dict[str, Dependency] = {}
    for file in nearest(files)[:MAX_FILES]:
        text = repository.read(file)
        inside = False
        for match in _PART.finditer(without_xml_comments(text)) if "<plugin>" in text else ():
            if not match["package"]:
                inside = not match["end"]
                continue
            from roslab.knowledge.hardware_plugins import package_of_hardware  # noqa: PLC0415 - few trees have hardware

            if inside and (name := package_of_hardware(match["package"])) not in found:
                line = match.string.count("\n", 0, match.start()) + 1
                found[name] = Dependency(
                    namespace="ros", name=name, strength="used", file=file.path, line=line, role="exec"
                )
    return tuple(found.values())
