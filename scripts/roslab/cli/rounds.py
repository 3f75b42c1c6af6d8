"""The rounds of one build: until an image is good enough, and then for as long as its command can be made to start."""

from __future__ import annotations

import os
from collections.abc import Callable

from roslab.cli.repairing import Repairing
from roslab.engine.docker import FailedBuild, name_image, remove_image
from roslab.errors import BuildError, Problem, RoslabError
from roslab.pipeline import Planned
from roslab.plan.ladder import Ladder, lost
from roslab.values.dataclass import dataclass
from roslab.values.pattern import pattern

_RAISED = pattern(r"(?:\[[^\]\n]{1,100}\] )?(?P<said>[A-Za-z_][\w.]{0,80}(?:Error|Exception)(?:: [^\n]{1,300}|:?$))")
"""An exception, behind what a launch of ROS 2 writes before the lines of a node."""
_END, _LAST = 4000, 3
"""The characters, and of these the last lines, that may hold it: a launch and ros2 run say more after it."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Made:
    """What one round made and named."""

    images: tuple[tuple[str, Ladder | None], ...]
    """The name of each image, and how far it got; ``None`` where nothing was proved."""
    missed: FailedBuild | None = None
    """How the default command died, though the image is good enough without it."""


Check = Callable[[Made], None]
"""Raises ``BuildError`` where what was made is not to be named."""
Once = Callable[[Planned, Check], Made]
"""Builds, proves and names once. Raises ``FailedBuild`` if the build or a proof fails."""


def first(once: Once, repairing: Repairing, check: Check = lambda _: None) -> Made:
    """Build until an image is good enough. Raises ``FailedBuild`` if no certain repair is left."""
    while True:
        try:
            return once(repairing.planned, check)
        except FailedBuild as error:  # noqa: PERF203 - a round takes minutes
            repairing.repair(error)


def better(once: Once, repairing: Repairing, made: Made) -> Made:
    """Repair and build again for as long as the command of what was made does not start, and that has a certain repair.

    What was made is named already. It keeps its name if what follows it fails, or is no better.
    """
    while made.missed and repairing.start(made.missed):
        after = _after(once, repairing, made)
        if after is None:
            break
        made = after
    return made


def _after(once: Once, repairing: Repairing, before: Made) -> Made | None:
    """Return what the next rounds make, ``None`` if that is no better than what was made before them."""
    # An image that loses its name to a better one would stay without any
    asides = [
        (name, f"{name.rpartition(':')[0]}:roslab-before-{os.getpid()}-{number}")
        for number, (name, _) in enumerate(before.images)
    ]
    kept: list[tuple[str, str]] = []
    try:
        for name, aside in asides:
            name_image(name, aside)
            kept.append((name, aside))
        return first(once, repairing, lambda now: _compare(before, now, repairing))
    except RoslabError as error:
        for name, aside in kept:  # of several, one may have been named before the engine refused the next
            name_image(aside, name)
        repairing.back(error, before.images[0][0])
        return None
    finally:
        for _, aside in asides:
            remove_image(aside)


def _raised(dead: FailedBuild) -> str:
    """Return the exception of Python with which a command ended: what stood before it in the log, it went on after."""
    last = [line for line in dead.log[-_END:].splitlines() if line.strip()][-_LAST:]
    return next((found["said"] for line in reversed(last) if (found := _RAISED.match(line))), "")


def _compare(before: Made, now: Made, repairing: Repairing) -> None:
    """Raise ``BuildError`` if an image is no better than the one before the repair."""
    if now.missed and repairing.is_back(now.missed):
        raise BuildError(Problem(message="its command does not start for the same cause"))
    if now.missed and before.missed and (said := _raised(now.missed)) and said == _raised(before.missed):
        raise BuildError(Problem(message=f"its command still ends with {said}"))
    had = dict(before.images)
    for name, ladder in now.images:
        old = had.get(name)
        if ladder and old and (rung := lost(old, ladder)):
            raise BuildError(Problem(message=f"{name} loses rung {rung.number}, {rung.name}: {rung.said}"))
