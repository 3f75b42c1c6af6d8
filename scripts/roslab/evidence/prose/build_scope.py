"""Which defaults of ARG hold at a line of a Dockerfile: a stage does not see those of another one.

https://docs.docker.com/build/building/variables/#scoping, read 2026-11-27.
"""

from __future__ import annotations

from roslab.values.dataclass import dataclass, field


@dataclass
class Scope:
    """The variables of each stage; those before the first FROM are everybody's.

    Docker asks a stage to declare the latter once more; one that does not is read as if it had.
    """

    of_all: dict[str, str] | None = None
    """Before the first FROM."""
    name: str = ""
    """Of the stage that is being read."""
    stages: dict[str, tuple[dict[str, str], frozenset[str]]] = field(default_factory=dict)
    fixed: set[str] = field(default_factory=set)
    """Set by ENV, which a default of ARG does not change."""

    def enter(self, known: dict[str, str], start: str, name: str) -> None:
        """Begin a stage: ``known`` keeps what is everybody's, and what the stage that it starts from had."""
        if self.of_all is None:
            self.of_all = dict(known)
        if self.name:
            self.stages[self.name] = (dict(known), frozenset(self.fixed))
        inherited, fixed = self.stages.get(start, ({}, frozenset()))
        known.clear()
        known.update(self.of_all | inherited)
        self.name, self.fixed = name, {*fixed}

    def argument(self, known: dict[str, str], name: str, default: str) -> None:
        """Read a default: the nearest counts, but for a variable that ENV sets."""
        if default and name not in self.fixed:
            known[name] = default
