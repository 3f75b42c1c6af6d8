"""ROS 2 packages of Python that do not say where their programs go: colcon puts them into ``bin``.

There ``ros2 run`` and launch files find none: they look into ``lib/PACKAGE``, which ``install_scripts`` in setup.cfg
names. https://docs.ros.org/en/rolling/How-To-Guides/Developing-a-ROS-2-Package.html, read 2026-11-29.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from roslab.evidence.facts import Mention
from roslab.evidence.ros.launch import names_by_folder
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

_PROGRAMS = pattern(r"\bconsole_scripts\b|\bscripts\s*=")
_SAYS = pattern(
    r"install[-_]scripts|script[-_]dir|^[ \t]*\[(?:install|develop)\]|[\"']lib(?:/|[\"']\s*,)", re.MULTILINE
)
"""The option, its sections, to which nothing can be added, or programs that setup.py installs itself."""
_TOOL = "ament_python"


def read(repository: Repository) -> Iterator[Mention]:
    """Yield the name of each such package, with its folder."""
    for folder, name in repository.once(names_by_folder).items():
        above = f"{folder}/".lstrip("/")
        setup = repository.read(f"{above}setup.py")
        match = _PROGRAMS.search(setup) if _TOOL in repository.read(f"{above}package.xml") else None
        if match and not _SAYS.search(setup) and not _SAYS.search(repository.read(f"{above}setup.cfg")):
            line = setup.count("\n", 0, match.start()) + 1
            yield Mention(
                topic="in_bin",
                value=name,
                source="code",
                file=f"{above}setup.py",
                line=line,
                text=match[0],
                inside=folder,
            )
