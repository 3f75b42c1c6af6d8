"""Scripts in ``scripts/`` of a package of ROS that start launch files in several terminals: what they call for that."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator

from roslab.evidence import places
from roslab.evidence.dependency import Dependency
from roslab.evidence.prose.called_in_scripts import calls_of
from roslab.knowledge.compiled import programs
from roslab.knowledge.session_programs import session_programs, terminals
from roslab.repository.checkout import Repository, nearest
from roslab.values.endings import SHELL_SCRIPTS
from roslab.values.pattern import pattern

MOST = 20
"""Most such scripts that are read, those nearest to the root first."""
MAX_SIZE = 64 * 1024
_LAUNCHES = pattern(r"^[^#\n]*\b(?:roslaunch|ros2[ \t]+launch)[ \t]+[\w./${\"-]")


def read(repository: Repository) -> Iterator[Dependency]:
    """Yield the packages of apt with what these scripts call, each once for a script.

    They are how the author starts the package, also where no page says so; all other scripts may be for anything.
    """
    folders = {posixpath.join(file.folder, "scripts") for file in repository.named("package.xml")}
    scripts = (file for file in repository.suffixed(*SHELL_SCRIPTS) if file.folder in folders) if folders else ()
    for file in nearest(file for file in scripts if file.size <= MAX_SIZE and not places.aside(file.path))[:MOST]:
        text = repository.read(file)
        if not any(map(_LAUNCHES.match, text.split("\n"))):
            continue
        found = dict(calls_of(text))
        if terminals().isdisjoint(found):
            continue
        for name in sorted(found.keys() & session_programs()):
            yield Dependency(
                namespace="apt",
                name=programs()[name],
                strength="used",
                file=file.path,
                line=found[name],
                role="session_script",
            )
