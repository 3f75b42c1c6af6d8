"""A command that could be the default, and the words of it that name its program."""

from __future__ import annotations

import posixpath
import shlex
from collections.abc import Container, Mapping, Sequence
from typing import Literal

from roslab.evidence.prose.blanks import ARGUMENTS
from roslab.values.dataclass import dataclass

LAUNCHERS = ("roslaunch", "rosrun", "ros2")
"""What starts something of a package."""
Demands = Literal["required", "open", "given", ""]
"""What the program says of an option that was left out: it stops without it, or may; ``given``: the page writes
``<args>`` or the like for what it is given."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Candidate:
    """A command that starts something, and where it was found."""

    argv: tuple[str, ...]
    why: str
    file: str
    line: int
    strong: bool
    """The author's text says to run it."""
    heading: str = ""
    """The titles of the sections of the page that run it."""
    files: tuple[str, ...] = ()
    """Arguments that the tree has."""
    inside: str = ""
    """The folder that it has to be started in."""
    cut: bool = False
    """Arguments that the reader fills in were left out, and they have no default."""
    lacking: tuple[str, ...] = ()
    """Arguments that its launch file demands and that it does not give: so it stops at once."""
    demands: Demands = ""
    absent: tuple[str, ...] = ()
    """Arguments that name a file which neither the tree nor a download has, each after its option."""
    blanks: tuple[str, ...] = ()
    """Names of arguments with a value that the reader fills in (``map:=…``): they are left out."""
    variables: tuple[str, ...] = ()
    """Variables that the page starts it with, ``NAME=VALUE``."""
    installed: bool = False
    """pip installs the program with the repository."""
    elsewhere: bool = False
    """It is a script that cannot do without a folder of its author's computer."""
    behind: bool = False
    """Its section launches a package that nothing brings before it."""
    alone: bool = False
    """A node of ROS 1 whose page starts no master but by launch files."""
    unmade: bool = False
    """A node that it starts is installed by no package, so that it stops; or its launch file starts none."""
    views: bool = False
    """Its launch file shows the model of a robot, and starts nothing else."""
    contained: bool = False
    """A container of an author's Dockerfile starts it."""
    session: bool = False
    """A file of tmuxinator, or a script that is called after starting, runs it."""
    tried: bool = False
    """A page has the reader run it to see whether it works."""
    makes: tuple[str, ...] = ()
    """Folders that the page makes right before it."""
    names: tuple[str, ...] = ()
    """What the whole is called: the repository, as far as git knows it, and its only package."""
    of_python: bool = False
    """It is a shell script that starts a program of Python."""


def there(candidate: Candidate, within: str | None = None) -> str:
    """Return the command line that goes to the folder in which the program has to be started, and starts it.

    Before that, it makes the folders that the page makes. ``within``: the path to that folder, if another one.
    """
    folder = candidate.inside or "."
    ours = {*candidate.files, *(word for word in candidate.argv if word.endswith(".py"))}
    words = [posixpath.relpath(word, folder) if word in ours else word for word in candidate.argv]
    if words[0].startswith(f"./{folder}/"):
        words[0] = f"./{posixpath.relpath(words[0], folder)}"
    goes = candidate.inside if within is None else within
    before = f"cd {shlex.quote(goes)} && " if goes else ""
    before += f"mkdir -p {shlex.join(candidate.makes)} && " if candidate.makes else ""
    return f"{before}exec {shlex.join(words)}"


def demanded(told: Container[str], said: str) -> Demands:
    """Return what is known of arguments that were left out: of options the program tells, of ``<args>`` the page."""
    if "required" in told:
        return "required"
    return "open" if "open" in told else "given" if f" {ARGUMENTS}" in said else ""


def inside_of(argv: Sequence[str], page: str, beside: Container[str], made: Mapping[str, str]) -> str:
    """Return the folder in which a page has a program started, ``""`` where any will do; ``page``: where the page is.

    ``beside``: programs that are started in the folder of their build. What make compiles in a folder (``made``) is
    started there where it is given a path above.
    """
    if argv[0].startswith(("python", "bash")) or argv[0] in beside:
        return page
    folder = made.get(argv[0].rpartition("/")[2], "")
    return folder if any(word.rpartition("=")[2].startswith("../") for word in argv[1:]) else ""


def is_python(candidate: Candidate) -> bool:
    """Tell whether a command starts a file of Python, with the word before it or as pip installed it."""
    program = candidate.argv[0]
    return program.startswith("python") or (candidate.installed and program.endswith(".py"))


def is_component(argv: Sequence[str]) -> bool:
    """Tell whether a command starts a component of ROS 2, whose package and class are two words more."""
    return tuple(argv[:3]) == ("ros2", "component", "standalone")


def launched_by(argv: tuple[str, ...]) -> tuple[str, ...]:
    """Return the words of a command behind those that start a launch file, if it does."""
    return argv[1:] if argv[0] == "roslaunch" else argv[2:] if argv[:2] == ("ros2", "launch") else ()


def program_of(argv: tuple[str, ...]) -> tuple[str, ...]:
    """Return the words of a command that name the program, without its arguments; any Python counts as ``python3``."""
    words = {"ros2": 4, "roslaunch": 3, "rosrun": 3}.get(argv[0], 1) + is_component(argv)
    if argv[0] in {"bash", "sh", "make"}:
        return argv[:2]
    if argv[0].startswith("python"):
        from roslab.values.python_options import program_of_python  # noqa: PLC0415 - not for ROS

        return ("python3", *program_of_python(argv)[0])
    return argv[:words]
