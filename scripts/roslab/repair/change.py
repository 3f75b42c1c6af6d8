"""The values of a repair: each change of roslab.yaml with what it is for and who asked for it."""

from __future__ import annotations

from collections.abc import Callable

from roslab.config.addition import Entry
from roslab.config.model import Config
from roslab.evidence.facts import Evidence
from roslab.knowledge.repairs import CLONES, LISTS
from roslab.plan.plan import Plan
from roslab.values.dataclass import dataclass, replace
from roslab.values.origin import Origin, Place

STARTING = ("apt", "pip", "gui", "env.PYTHONPATH", "submodules", CLONES)
"""Keys that give a program what it lacks at its start; the others change how the image is compiled."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Given:
    """What a repair is made from, besides the log."""

    plan: Plan
    evidence: Evidence
    config: Config
    files: frozenset[str]
    """Paths of the repository's files."""
    read: Callable[[str], str] | None = None
    """Returns the text of one of them, ``""`` of what is no text."""
    added: frozenset[str] = frozenset()
    """Keys of roslab.yaml that a repair before this one set."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Worked:
    """The values that were worked out, or why there are none."""

    values: tuple[str, ...] = ()
    instead: str = ""
    certain: bool = True
    why: str = ""
    key: str = ""
    """The key of roslab.yaml, where it is another than the table's."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Asked:
    """Who asked for what was missing."""

    what: str
    """``the header glog/logging.h``."""
    place: Place | None = None

    def __str__(self) -> str:
        return f"{self.what} ({self.place})" if self.place else self.what


@dataclass(frozen=True, kw_only=True, slots=True)
class Change:
    """One value for one key of roslab.yaml."""

    key: str
    value: str
    instead: str = ""
    """The value of a list that it replaces."""
    failure: str
    """Id of the known failure that it repairs."""
    certain: bool
    asked: Asked
    why: str = ""
    """What is said in place of who asked."""
    written: Origin | None = None
    """Where somebody gave the key, which has one value, the value that ``instead`` holds."""

    @property
    def told(self) -> str:
        """The change and what it is for; where somebody gave another value, who has to exchange it."""
        yours = f"; {self.written} says {self.instead}, which is yours to exchange" if self.written else ""
        return f"{self}, {self.why or f'for {self.asked}'}{yours}"

    @property
    def entry(self) -> Entry:
        """The change as it is written; a line of its own says who asked."""
        why = f"for {self.asked}" if self.certain else f"likely, for {self.asked}"
        note = self.why or (f"in place of {self.instead}" if self.instead else why)
        return Entry(key=self.key, value=self.value, instead=self.instead, note=note)

    def __str__(self) -> str:
        value = f"{self.instead} becomes {self.value}" if self.instead else self.value
        return f"{self.key}: {value}" if self.key not in (*LISTS, CLONES) else f"{self.key}: [{value}]"


@dataclass(frozen=True, kw_only=True, slots=True)
class Repair:
    """The repair of a failed build."""

    changes: tuple[Change, ...] = ()
    refused: tuple[tuple[str, str], ...] = ()
    """Why nothing can be written for a failure: its id (``""`` for an unknown one) and the reason."""
    places: tuple[Place | None, ...] = ()
    """For each explanation of the answer, the place in the repository that asked for what failed."""
    left: tuple[Change, ...] = ()
    """Changes with which the image is built without something that fails, where nothing that is added is certain."""
    kept: str = ""
    """Why nothing is left out, of what could be."""

    @property
    def certain(self) -> Repair:
        """The same repair, with its certain changes alone."""
        return replace(self, changes=tuple(change for change in self.changes if change.certain))

    @property
    def starting(self) -> Repair:
        """The same repair, with the changes alone that can help a command which does not start."""
        return replace(self, changes=tuple(change for change in self.changes if change.key in STARTING))

    @property
    def entries(self) -> tuple[Entry, ...]:
        """The changes as they are written."""
        return tuple(change.entry for change in self.changes)
