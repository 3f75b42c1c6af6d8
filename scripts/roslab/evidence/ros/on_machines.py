"""Distributions in what an editor, a build or catkin wrote on the author's machine, and in scripts that work on it.

Scripts and lists of any name may also tell it by the packages that they install on it: ``ros-melodic-joy``.
"""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator

from roslab.evidence import places
from roslab.evidence.facts import Mention
from roslab.evidence.lex.lines import end_of_line, matching_lines
from roslab.knowledge.distros import distros
from roslab.repository.checkout import Repository, nearest
from roslab.repository.listing import File
from roslab.values.pattern import pattern

EDITOR = ".vscode"
SETUPS = ("CMakeCache.txt", "setup.sh", "setup.bash", "_setup_util.py")
"""What CMake, catkin and colcon write into a build, devel or install folder, with the underlay's path."""
_CALLED, _KEPT = "colcon_command_prefix_", ".env"
"""How the names of those files begin and end. https://github.com/colcon/colcon-core (colcon_core/shell), 2026-11-28."""
SCRIPTS = (".sh", ".bash", ".zsh", ".service", ".desktop", ".tmux")
LISTS = (".txt", ".yml", ".yaml")
_LISTS = pattern(
    r"(?:^|[^a-z])(?:(?:apt|debs?|packages?|dep(?:endencie)?s|ros|install)[^/]*\.txt$|(?:ansible|playbooks?)(?:[^a-z]|$))",
    re.IGNORECASE,
)
"""The path of what lists packages: for a reader, a script, or Ansible."""
LARGEST = 64 * 1024
MOST = 40
"""Files that are read: a build folder has one for each package."""
TOPLEVEL = "CMakeLists.txt"
"""What ``catkin_init_workspace`` puts into ``src``: a link to the toplevel.cmake of the distribution."""
LONGEST = 200
"""Most bytes of a link that was committed as a file."""
_LEFT = pattern(r"(?:^|[-_.])(?:old|legacy|deprecated|obsolete|backup|bak)(?:[-_.]|$)", re.IGNORECASE)
"""A script that its author keeps and runs no more."""
_NAMED = r"/opt/ros/([a-z]+)\b(?!\.)"
_EACH = pattern(_NAMED)
_PACKAGE = r"(?<![\w/.-])ros-([a-z]+)-[a-z]"
_PACKAGES = pattern(_PACKAGE)
_REMOVED = pattern(r"\b(?:remove|purge|autoremove|uninstall)\b[^\n;&|]*")
_BUILT = pattern(rf"[^\n]{{0,400}}?{_NAMED}")
_ENVIRONMENT = pattern(r"ROS_DISTRO=([a-z]+)\s*$", re.MULTILINE)
_LINK = pattern(r"/opt/ros/([a-z]+)/share/catkin/cmake/toplevel\.cmake\s*$")
_SOURCED = pattern(rf"(?![ \t]*#)[^#\n]{{0,400}}?{_NAMED}")
_INSTALLED = pattern(rf"(?![ \t]*#)[^#\n]{{0,400}}?{_PACKAGE}")
_SET = pattern(rf"(?![ \t]*//)[^\n]{{0,400}}?(?:{_NAMED}|\"ros\.distro\"[ \t]*:[ \t]*\"([a-z]+)\")")


def read(repository: Repository) -> Iterator[Mention]:
    """Yield each distribution that such a file names, at its first place in it, the nearest files first.

    A script that names several chooses among them, or is for several machines: it tells nothing.
    """
    found = [file for file in repository.suffixed(".json") if posixpath.basename(file.folder) == EDITOR]
    for file in nearest(file for file in found if not places.aside(file.path))[:MOST]:
        yield from _named(file, repository.read(file))
    scripts = (*repository.suffixed(*SCRIPTS), *repository.named("Makefile", ".bashrc", "bashrc"))
    scripts = tuple(f for f in scripts if f.name.lower() not in SETUPS and not _LEFT.search(f.name))
    for file in nearest(f for f in scripts if not places.aside(f.path))[:MOST]:
        text = repository.read(file)
        sourced = set(_EACH.findall(text)) & distros().keys()
        if len(sourced) == 1:
            yield from _named(file, text)
        elif not sourced:
            yield from _of_packages(file, text)
    lists = (f for f in repository.suffixed(*LISTS) if _LISTS.search(f.path) and f.size <= LARGEST)
    for file in nearest(f for f in lists if not places.aside(f.path) and f.name != TOPLEVEL)[:MOST]:
        yield from _of_packages(file, repository.read(file))
    yield from _links(repository)


def built(whole: Repository) -> Iterator[Mention]:
    """Yield each distribution that what a build wrote names: ``whole`` has the spaces of workspaces, too.

    colcon keeps the environment of each of its calls, which tells also where ROS comes from conda.
    """
    found = [*whole.named(*SETUPS), *(file for file in whole.suffixed(_KEPT) if file.name.startswith(_CALLED))]
    for file in nearest(file for file in found if not places.aside(file.path))[:MOST]:
        yield from _named(file, whole.read(file))


def is_link(mention: Mention) -> bool:
    """Tell whether catkin's link into its distribution says so: somebody made a workspace of it there."""
    return mention.topic == "machine" and posixpath.basename(mention.file) == TOPLEVEL


def _links(repository: Repository) -> Iterator[Mention]:
    """Yield the distribution that each such link leads to; git writes it as a file where there can be no links."""
    links = [path for path in repository.listing.outside if posixpath.basename(path) == TOPLEVEL]
    found = [(path, repository.leads_to(path)) for path in links]
    found += [(file.path, repository.read(file)) for file in repository.named(TOPLEVEL) if file.size <= LONGEST]
    for path, target in found[:MOST]:
        match = _LINK.match(target)
        if match and match[1] in distros() and not places.aside(path):
            said = f"{path} is a link to {target.strip()}"
            yield Mention(topic="machine", value=match[1], source="code", file=path, line=1, text=said)


def _of_packages(file: File, text: str) -> Iterator[Mention]:
    """Yield the one distribution whose packages a file names, but to remove them."""
    text = _REMOVED.sub("", text)
    if len(set(_PACKAGES.findall(text)) & distros().keys()) == 1:
        yield from _told(file, text, _INSTALLED, "ros-")


def _named(file: File, text: str) -> Iterator[Mention]:
    said_by = _SOURCED if file.suffix in SCRIPTS and file.name not in SETUPS else _BUILT
    lines, word = (_SET, "ros") if file.suffix == ".json" else (said_by, "/opt/ros/")
    lines, word = (_ENVIRONMENT, "ROS_DISTRO=") if file.suffix == _KEPT else (lines, word)
    yield from _told(file, text, lines, word)


def _told(file: File, text: str, lines: re.Pattern[str], word: str) -> Iterator[Mention]:
    told: set[str] = set()
    for match in matching_lines(lines, text, word) if word in text else ():
        name = next(filter(None, match.groups()))
        if name in distros() and name not in told:
            told.add(name)
            line = text.count("\n", 0, match.start()) + 1
            said = text[match.start() : end_of_line(text, match.start())].strip()[:120]
            yield Mention(topic="machine", value=name, source="code", file=file.path, line=line, text=said)
