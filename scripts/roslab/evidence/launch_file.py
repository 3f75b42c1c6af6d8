"""What one launch file tells."""

from __future__ import annotations

from typing import Literal, NamedTuple

from roslab.evidence.dependency import Dependency
from roslab.values.dataclass import dataclass


class When(NamedTuple):
    """A condition that the values of arguments may decide."""

    holds_if: bool
    """It holds where the expression is true, or where it is not."""
    expression: str
    """One of Python, ``""`` where nothing is known of it."""
    defaults: tuple[tuple[str, str], ...]
    """Of the arguments that it asks for, and those of which these have their values: what each has by itself."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Demand:
    """An argument without a default, which has to be given where all conditions around its declaration hold."""

    name: str
    conditions: tuple[When, ...] = ()


@dataclass(frozen=True, kw_only=True, slots=True)
class LaunchFile:
    """A launch file, ROS 1 (XML) or ROS 2 (Python, XML, YAML)."""

    file: str
    line: int
    package: str | None
    """The name of the package that it belongs to."""
    ros: Literal[1, 2]
    dependencies: tuple[Dependency, ...]
    gui: bool
    """Whether it starts rviz, rqt, Gazebo's client or the like."""
    viewers: tuple[tuple[str, str], ...] = ()
    """Arguments whose values keep viewers from being started, each with that value."""
    tests: int = 0
    """Number of its tests for rostest."""
    compiled: tuple[tuple[str, str], ...] = ()
    """Of a file with tests: package and program of what it starts that is no file of the tree."""
    reached: tuple[Dependency, ...] = ()
    """Packages that what it starts needs, whatever the arguments are: other launch files, descriptions, programs."""
    gone: tuple[tuple[str, str, str, int], ...] = ()
    """What it includes of the tree's packages in any case and they do not have: package, name, and where it does."""
    includes: tuple[tuple[str, str], ...] = ()
    """Package and name of the others that it names, as it does to include them; ``""`` where it says no package."""
    nodes: tuple[tuple[str, str], ...] = ()
    """Package and program of each node that it starts."""
    executes: tuple[tuple[str, str, int], ...] = ()
    """Programs that it starts by their names beside its nodes, each with the folder of its author's and its line."""
    idle: bool = False
    """It sets parameters, and names no node and no other launch file."""
    to_fill: tuple[tuple[str, int], ...] = ()
    """Paths of files that it loads in any case and that its reader is to fill in, each with its line."""
    unmade: tuple[tuple[str, str, str], ...] = ()
    """Of these the package, the program and the one most like it, where it is a package of the tree without that."""
    arguments: tuple[str, ...] = ()
    """Those that it declares."""
    demands: tuple[Demand, ...] = ()
    """Arguments without a default, without which it is not started."""
    switches: tuple[tuple[str, str], ...] = ()
    """Packages of which it includes something only where an argument is true, as it is by default, each with that."""
    variables: tuple[tuple[str, int], ...] = ()
    """Variables of the environment without which it does not start, each with its line."""
    foreign: tuple[tuple[str, str], ...] = ()
    """Files that it starts whose first line names an interpreter of the author's machine, each with that."""
    interpreters: tuple[tuple[str, int], ...] = ()
    """Pythons of the author's machine that it names to start something by them, each with its line."""
    without_ros: frozenset[str] = frozenset()
    """Those of them that import nothing of ROS: any Python of their version starts them."""
    elsewhere: tuple[tuple[str, str, int], ...] = ()
    """Programs of Python that it starts, each with a folder of the author's machine that it puts on its path, where."""
    loaded: tuple[str, ...] = ()
    """Files of the tree that it loads or starts whatever the arguments are, itself first."""
    installed: bool = True
    """Not, if it lies in a folder that the build of its package does not name."""
    by_path: bool = False
    """It is started by its path alone: its package installs programs, and no launch files."""
