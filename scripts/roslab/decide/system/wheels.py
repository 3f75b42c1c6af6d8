"""System packages that wheels need and do not carry, and the system's own packages of what ROS code imports."""

from __future__ import annotations

from roslab.decide.decision import Python
from roslab.decide.python.environment import specifiers
from roslab.decide.python.pins import name_of
from roslab.evidence import places
from roslab.evidence.facts import Dependency, Evidence
from roslab.knowledge.frameworks import imports, wheels

_PYTHON2 = frozenset({"trusty", "xenial", "bionic"})
"""Where ROS 1 has Python 2, so that a package of ROS code is ``python-NAME``."""
_RENAMED: dict[str, dict[str, str]] = {
    "libgl1": {"xenial": "libgl1-mesa-glx", "trusty": "libgl1-mesa-glx"},
    "libegl1": {"xenial": "libegl1-mesa", "trusty": "libegl1-mesa"},
    "libgl1-mesa-glx": {"noble": "libgl1", "resolute": "libgl1", "bookworm": "libgl1"},
    "libosmesa6": {"resolute": "libosmesa6"},
}
"""https://packages.ubuntu.com, read 2026-08-22."""


def apt_for_wheels(python: Python, ubuntu: str | None, evidence: Evidence) -> tuple[tuple[str, Dependency], ...]:
    """Return ``(apt name, the requirement or import that needs it)``; ``ubuntu`` is ``None`` on Debian bookworm."""
    found: dict[str, Dependency] = {}
    where = _places(evidence)
    for line in specifiers(evidence, python):
        name = name_of(line)
        for apt in wheels().get(name, ()):
            renamed = _RENAMED.get(apt, {}).get(ubuntu or "bookworm", apt)
            found.setdefault(renamed, where.get(line) or where.get(line.partition(" @ ")[2]) or _unplaced(line))
    if python.manager == "system":
        for dependency in evidence.code:
            if dependency.namespace != "import" or dependency.strength != "used" or places.test(dependency.file):
                continue
            apt_name = (imports().get(dependency.name) or (None, None))[1]
            if apt_name:
                if ubuntu in _PYTHON2:
                    apt_name = apt_name.replace("python3-", "python-")
                found.setdefault(apt_name, dependency)
            if dependency.name in {"matplotlib", "pylab"}:
                found.setdefault("python-tk" if ubuntu in _PYTHON2 else "python3-tk", dependency)
    return tuple(found.items())


def _places(evidence: Evidence) -> dict[str, Dependency]:
    """Return where each requirement line stands, the manifests before prose."""
    found: dict[str, Dependency] = {}
    sources = (
        *(file.dependencies for file in evidence.requirements),
        *(project.dependencies for project in evidence.python),
        *(environment.dependencies for environment in evidence.conda),
        *(authored.dependencies for authored in evidence.dockerfiles),
        evidence.prose,
    )
    for dependencies in sources:
        for dependency in dependencies:
            if dependency.namespace == "pip":
                found.setdefault(dependency.name, dependency)
    return found


def _unplaced(line: str) -> Dependency:
    return Dependency(namespace="pip", name=line, strength="used", file="", line=1)
