"""How a launch file is started: by its package and name, or by its path where the package has none or two of it."""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Iterable, Mapping

from roslab.decide.candidate import launched_by
from roslab.decide.ros.slips import meant
from roslab.evidence.facts import Evidence
from roslab.evidence.launch_file import LaunchFile
from roslab.knowledge.released import ever_released

_OPTIONS = frozenset(
    {"--screen", "--log", "--wait", "-v", "--local", "--core", "--no-summary", "--skip-log-check", "--disable-title"}
    | {"-d", "--debug", "-n", "--noninteractive", "-a", "--show-all-subprocesses-output"}
)
"""Options without a value, with which both start something.

https://github.com/ros/ros_comm (tools/roslaunch/src/roslaunch/__init__.py) and https://github.com/ros2/launch_ros
(ros2launch/ros2launch/command/launch.py), 2026-11-29
"""


def launch_calls(evidence: Evidence) -> Mapping[str, tuple[str, ...]]:
    """Return what follows ``roslaunch`` or ``ros2 launch`` for each launch file of a package, by its path.

    Both look for the name in every folder of the package and refuse to choose between two
    (ros/ros: core/roslib/src/roslib/packages.py; ros2/launch_ros: ros2launch/ros2launch/api/api.py; 2026-11-23).
    What is not installed they do not find either.
    """
    named = [(each.file, each.package, each.file.rpartition("/")[2]) for each in evidence.launch if each.package]
    often = Counter((package, name) for _, package, name in named)
    alone = {each.file for each in evidence.launch if each.by_path or not each.installed}
    return {
        file: (file,) if file in alone or often[package, name] > 1 else (package, name) for file, package, name in named
    }


def found_by_path(evidence: Evidence) -> Mapping[tuple[str, str], str]:
    """Return the launch files that their packages do not install, by package and name, where the package has no other.

    Only their paths start them.
    """
    often = Counter((each.package, each.file.rpartition("/")[2]) for each in evidence.launch)
    apart = (each for each in evidence.launch if each.by_path or not each.installed)
    named = ((each.package, each.file.rpartition("/")[2], each.file) for each in apart)
    return {(package, name): file for package, name, file in named if package and often[package, name] == 1}


def as_found(words: tuple[str, ...], by_path: Mapping[tuple[str, str], str]) -> tuple[str, ...]:
    """Return package, options, launch file and arguments, with the path of a file that the package does not install."""
    package, *rest = words
    at = next((index for index, word in enumerate(rest) if not word.startswith("-")), len(rest))
    file = by_path.get((package, rest[at])) if at < len(rest) else None
    return (*rest[:at], file, *rest[at + 1 :]) if file else words


def demanded(launch: LaunchFile, words: Iterable[str] = ()) -> frozenset[str]:
    """Return the arguments that have to be given to a launch file and are not among these, ``NAME:=VALUE``.

    Not those that it declares in parts which the others leave out.
    """
    if not launch.demands:
        return frozenset()
    from roslab.evidence.ros.launch_conditions import holds  # noqa: PLC0415 - most launch files ask for nothing

    given = {name: value for name, is_given, value in (word.partition(":=") for word in words) if is_given}
    asked = (each for each in launch.demands if not any(holds(when, given) is False for when in each.conditions))
    return frozenset(each.name for each in asked) - given.keys()


def names_of_launch_files(evidence: Evidence) -> dict[str, frozenset[str]]:
    """Return the names of the launch files of each package, ``""`` for those of none."""
    found: dict[str, set[str]] = {}
    for launch in evidence.launch:
        found.setdefault(launch.package or "", set()).add(launch.file.rpartition("/")[2])
    return {package: frozenset(names) for package, names in found.items()}


def of_own_package(words: tuple[str, ...], launched: Mapping[str, Collection[str]]) -> tuple[str, ...]:
    """Return package, launch file and arguments, with the tree's package of nearly that name which has the file.

    A page may misspell it. What is a package of a distribution is meant.
    """
    package, *rest = words
    if package in launched or not rest or ever_released(package):
        return words
    near = [name for name in meant(package, launched.keys()) if rest[0] in launched[name]]
    return (near[0], *rest) if len(near) == 1 else words


def from_root(command: str, files: Collection[str]) -> str:
    """Return a command that starts a launch file by its path with the path from the root, as far as the tree has it.

    A page may write one in the reader's home: ``roslaunch ~/ws/src/NAME/launch/a.launch``. Options before the package
    or the path come behind: ``roslaunch --screen a.launch``.
    """
    at = 1 if command.startswith("roslaunch ") else 2 if command.startswith("ros2 launch ") else 0
    words = command.split(" ")
    if at and words[at] in _OPTIONS:
        first = next((index for index in range(at, len(words)) if words[index] not in _OPTIONS), at)
        words = [*words[:at], *words[first:], *words[at:first]]
        command = " ".join(words)
    if not at or not words[at].startswith(("~", "/", "$")):
        return command
    path = _below(words[at], files)
    return " ".join((*words[:at], path, *words[at + 1 :])) if path else command


def _below(written: str, files: Collection[str]) -> str:
    """Return the file of the tree, in a folder of it, that a path from above the repository names, ``""`` for none."""
    return max((file for file in files if "/" in file and written.endswith(f"/{file}")), key=len, default="")


def call_of(written: str, calls: Mapping[str, tuple[str, ...]], alone: Collection[str], page: str) -> tuple[str, ...]:
    """Return what follows ``roslaunch`` for a launch file that a page names by its path, ``()`` for none of the tree.

    ``alone``: those that belong to no package, which both start by their paths alone; ``page``: that page. A path may
    begin above the repository: ``ws/src/NAME/launch/a.launch``.
    """
    there = written in calls or written in alone
    path = written if there else _below(written, (*calls, *alone)) or written
    name = written.rpartition("/")[2]
    named = [call for file, call in calls.items() if file.rpartition("/")[2] == name]
    return (
        calls.get(path)
        or ((path,) if path in alone else ())
        or (named[0] if len(named) == 1 else without_package(written, alone, page))
    )


def is_path(written: str, calls: Mapping[str, tuple[str, ...]], alone: Collection[str], page: str) -> bool:
    """Tell whether what follows ``ros2 launch`` is the path of a launch file of the tree: no package stands before."""
    by_path = without_package(written, alone, page)
    return bool(by_path or ("/" in written and call_of(written, calls, (), page)))


def without_package(written: str, alone: Collection[str], page: str) -> tuple[str, ...]:
    """Return the path of a launch file of no package as it is from the root, ``()`` for none of the tree.

    A page may be in the workspace, of which the repository is ``src/NAME``, or have its reader go to a folder first:
    then ``launch/a.launch.py`` is the only one whose path ends so. A name alone is that of the only one below the
    folder of the ``page``, for the page at the root of one in ``launch``.
    """
    found = [file for file in alone if file == written or written.endswith(f"/{file}")]
    folder = page[: page.rfind("/") + 1]
    beneath = [file for file in alone if file.endswith(f"/{written}")]
    below = [file for file in beneath if file.startswith(folder or "launch/")]
    below = below if len(below) == 1 or "/" not in written else beneath
    return (max(found, key=len),) if found else tuple(below) if len(below) == 1 else ()


def started_launch(
    evidence: Evidence, argv: tuple[str, ...] | str, calls: Mapping[str, tuple[str, ...]] | None = None
) -> LaunchFile | None:
    """Return the launch file of a package of the tree that a command starts; ``calls`` as ``launch_calls`` tells."""
    if isinstance(argv, str):
        return None
    words = launched_by(argv)
    calls = launch_calls(evidence) if calls is None else calls
    found = (each for each in evidence.launch if (call := calls.get(each.file)) and words[: len(call)] == call)
    return next(found, None) if words else None
