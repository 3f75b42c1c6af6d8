"""What was chosen to be built from source, and which packages it may hold."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.config.model import Source
from roslab.decide.ros.source_names import address, plain, telling_words
from roslab.evidence.dependency import Dependency
from roslab.knowledge.ros_sources import alone, collections, held_by
from roslab.values.dataclass import dataclass, replace


@dataclass(frozen=True, kw_only=True, slots=True)
class Sources:
    """What is built from source, in this order, and the vcs files it came from."""

    sources: tuple[Source, ...] = ()
    vcs: tuple[str, ...] = ()
    submodules: tuple[Source, ...] = ()
    """What belongs in the tree and is not there, submodules and clones; the name of each is its path."""
    libraries: tuple[tuple[str, Dependency], ...] = ()
    """Names of rows in the table of recipes that these sources link, with what asks for each."""
    sought: tuple[Source, ...] = ()
    """Repositories in which the build looks for packages that nothing brings."""
    modules: frozenset[str] = frozenset()
    """Those of the names for which it looks that are modules of Python."""
    names: frozenset[str] = frozenset()
    """Names that these sources provide: they need no rosdep key and no package."""

    asked: frozenset[str] = frozenset()
    """The names, in one spelling, that the tree asks for: a clone of such a name is most likely that package alone."""
    of_lists: frozenset[str] = frozenset()
    """The names of those that only hold lists: the build clones what these name that holds one of ``sought_there``."""
    sought_there: frozenset[str] = frozenset()
    """What manifests and CMake name, in one spelling, where there are such lists."""
    started: tuple[str, ...] = ()
    """Packages that the launch file of the default command needs and the repository does not have."""
    within: frozenset[str] = frozenset()
    """Names of the submodules that lie in folders of packages: no tool of ROS looks for others there.

    https://docs.ros.org/en/independent/api/catkin_pkg/html/catkin_pkg.html (find_package_paths), 2026-11-27
    """

    @property
    def everything(self) -> tuple[Source, ...]:
        """What is cloned, and what is looked in."""
        return (*self.sources, *self.submodules, *self.sought)

    @property
    def with_unknown_packages(self) -> bool:
        """A clone may hold packages whose names are not known: it is no library, nor known to be a single package."""
        return any(self._unknown())

    def may_hold(self, wanted: str) -> bool:
        """Tell whether a clone may hold a package.

        One that the tree asks for by its name, or that only a table of this program names, holds what is named alike;
        what lists name is cloned for what manifests and CMake name.
        """
        words = telling_words(wanted) | {plain(wanted)}
        others = self._called_otherwise()
        unknown = any(name not in others or words & (telling_words(name) | {name}) for name in self._unknown())
        return unknown or plain(wanted) in self.sought_there

    def hardly_holds(self, wanted: str) -> bool:
        """Tell whether a package can only be in clones that are most likely another package alone, called alike.

        Where there are lists they come first: they may name the branch or commit that is meant.
        """
        others = self._called_otherwise() - {plain(wanted)}
        return not self.of_lists and self.may_hold(wanted) and others.issuperset(self._unknown())

    def renamed(self, wanted: str) -> str:
        """Return the package of a clone that has a package's name behind one more word, ``""`` where none has.

        Names of several words only: ``kr_trackers_manager`` stands for ``trackers_manager``.
        """
        found = (name for name in sorted(self.names) if "_" in wanted and name.endswith(f"_{wanted}"))
        return next((name for name in found if "_" not in name.removesuffix(f"_{wanted}")), "")

    def _called_otherwise(self) -> frozenset[str]:
        """Return the names of the clones that the tree asks for by name, or that only a table of this program names."""
        known = {address(url) for url in collections()}
        tabled = (each for each in self.sources if not each.listed and address(each.repo or "") in known)
        return self.asked | {plain(source.name) for source in tabled}

    def _unknown(self) -> Iterator[str]:
        """Yield the names of the clones whose packages are not known."""
        single = {address(url) for url in alone()}
        for source in (*self.sources, *self.submodules):
            aside = source.name in self.within or source.name in self.of_lists
            if source.build != "cmake" and not aside and address(source.repo or "") not in single:
                yield plain(source.name)


def with_tabled(sources: Sources, ros: int, distro: str) -> Sources:
    """Return the sources with the names of all packages that the table finds in what is cloned, also unasked ones.

    Not of what launch files alone ask for, of which the rest is not built.
    """
    cloned = [each for each in sources.sources if each.repo and not each.only]
    held = {name for each in cloned for name in held_by(address(each.repo or ""), ros, distro)}
    return replace(sources, names=sources.names | held) if held else sources
