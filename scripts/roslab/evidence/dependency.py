"""What a repository needs, by its source's name for it, and how far that can be trusted."""

from __future__ import annotations

from typing import Literal

from roslab.values.dataclass import dataclass

Strength = Literal["declared", "used", "optional", "prose"]
"""How far a dependency can be trusted.

``declared``: a manifest made for installing says so (package.xml, requirements.txt, a required ``find_package``);
``used``: the code uses it (an include, an import, a launch file's package); ``optional``: behind a condition or
``QUIET`` alone; ``prose``: written for humans (README) or for another machine (an author's Dockerfile, CI).
"""
Namespace = Literal[
    "rosdep",
    "apt",
    "cmake",
    "ros",
    "pkg-config",
    "include",
    "import",
    "link",
    "call",
    "nowhere",
    "unincluded",
    "controller",
    "program",
]
"""What kind of name it is: ``ros`` is a ROS package, ``cmake`` a name given to ``find_package``, ``call`` the library
of a call that opens a window, ``nowhere`` a header that the tree would have, and does not, ``unincluded`` a header of
the compiler whose names are used without it, ``controller`` what a parameter file calls a controller, whose role is the
package of its type, ``program`` what ``find_program`` looks for."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Dependency:
    """One thing that the repository needs, by its source's name for it; what pip is asked for is a ``Requirement``."""

    namespace: Namespace
    name: str
    strength: Strength
    file: str
    line: int
    version: str | None = None
    role: str = ""
    """``build``, ``exec``, ``test``, ``doc`` … as in its source."""
    condition: str | None = None
    """Its condition as written (``$ROS_VERSION == 1``, a CMake ``if``)."""
    required: bool = False
    """CMake stops without it where its condition holds."""
    heading: str = ""
    """The titles of the page that a line of apt stands under."""
    target: str = ""
    """The imported target of CMake that is linked, where ``version`` is the first release that has it."""
    below: tuple[str, ...] = ()
    """The folders of a library's own in which CMake looks for it: ``PATH_SUFFIXES``."""


@dataclass(frozen=True, kw_only=True, slots=True)
class GitSource:
    """A repository to clone beside this one or to build before it."""

    name: str
    url: str
    ref: str | None
    strength: Strength
    file: str
    line: int
    kind: Literal["vcs", "submodule", "git_url", "clone", "upstream", "fetch", "link", "inside"]
    """What names it: a vcs file, .gitmodules, package.xml's export, a clone line, CI's workspace, CMake, a link;

    a clone line for a path that is ``name``, from which the code imports or which CMake names."""
    taken: bool = False
    """The words of a comment before it say that code was taken from there, at ``ref``."""
    installed: bool = False
    """The page compiles it by hand with CMake and installs it, with these options."""
    options: str = ""
    configured: bool = False
    """CMake is called there before it is installed."""
    by_make: bool = False
    """A Makefile of its own installs it: nothing is called there before ``make``."""
    below: str = ""
    """The folder of it that CMake is called for, or in which make is, where that is not its own."""
    heading: str = ""
    """The titles of the page that a clone line stands under."""
    aside: bool = False
    """Its section, or the sentence above it, says that not everybody needs it."""
    itself: bool = False
    """The page has its name for a title, or it is the first below a sentence that says to clone this repository."""
    holds: bool = False
    """A link that a page gives for its dependencies: they can be found there, or it is listed among them."""
    of_packages: bool = False
    """A link in a section of the page at the root about other packages: ``Other relevant packages``."""
    told: bool = False
    """A link that a page has the reader install: ``Install [Name](https://github.com/owner/name)``."""
    to_install: bool = False
    """A link in a section that is about installing, or in one below it."""
    beside: bool = False
    """It is cloned into the ``src`` of a workspace, beside the repository itself."""
    absent: bool = False
    """A submodule that is not checked out; its ``ref`` is the commit that the repository records, if git tells it."""
    moved: str = ""
    """The name in .gitmodules of a submodule that lies at another path than its entry says: git finds none there."""
    by_name: bool = False
    """Its address is that of a repository which ROS lists under its name; it is the one if it has the commit."""
    lists: bool = False
    """What it lists itself is cloned with it."""
    into: str = ""
    """The name of the folder that it is cloned into, where that is not its own."""
    removed: bool = False
    """A later command removes its folder; only what it copies out of that before stays, the folders ``parts``."""
    parts: tuple[str, ...] = ()
    by_ssh: str = ""
    """The address of ssh that stands there, for a build that has a key; ``url`` is the same by https."""
    private: bool = False
    """A link to what a page calls private, or an address with somebody's login: others may not have it."""

    forked: bool = False
    """A link to what a page calls a fork, or a version of its author's own: what others released is not the same."""
    fork_of: str = ""
    """What the link's own words say that it is a fork of: ``nav2`` in ``[our fork of Nav2](https://…)``."""
    release: str = ""
    """The one release that a page names where it links to it; ``ref`` is its tag where the link leads to that."""
    doubt: str = ""
    """What a page says beside a link, where that is that the code is not public or may not work."""

    @property
    def folder(self) -> str:
        """Name of the folder in which it lies."""
        return self.into or self.name
