"""From a failed build's log and the plan to what is proposed for roslab.yaml: the same for all who explain it."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from roslab.explain.answer import Answer
from roslab.repair import generated, holders, leaving, other_python
from roslab.repair.absent import without_absent
from roslab.repair.change import Given, Repair
from roslab.repair.repair import repair
from roslab.values.dataclass import dataclass, replace

Ask = Callable[[Sequence[str]], str]
"""Returns the answer to questions, one a line. Raises ``BuildError``."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Asking:
    """Who is asked where no table knows an answer, ``None`` where nobody may be."""

    files: Ask | None = None
    """The apt of the image's base, for the packages that hold files: see ``holders``."""
    wheels: Ask | None = None
    """pip's index, for the Pythons that a release has wheels for: see ``other_python``."""


NOBODY = Asking()


def proposed(
    answer: Answer,
    given: Given,
    *,
    asking: Asking = NOBODY,
    start: bool = False,
    again: bool = False,
    whole: bool = False,
) -> Repair:
    """Return what is proposed, in the order in which ``roslab build`` tries it.

    First what tables, plan and log settle; then the package of apt, then the Python that somebody who is asked names;
    last, in ``left``, what the image is built without. Each comes only where nothing before it is certain.
    In place of an author's Dockerfile, to which nothing is added, one is generated: that is in ``left``, too.
    ``start``: the answer is to the log of the default command of an image that was built. ``again``: what was added for
    the same cause did not help. ``whole``: nothing is left out.
    """
    found = without_absent(repair(answer, given), answer.left_out)
    found = found.starting if start else found
    if again:
        found = Repair(places=found.places)
    elif asking.files:
        found = holders.completed(found, answer, given, asking.files)
    if asking.wheels:
        found = other_python.completed(found, answer, given, asking.wheels)
    if given.plan.author_dockerfile and not start:
        return replace(found, left=generated.in_place_of(answer, given))
    if start or whole or found.certain.changes:
        return found
    left = leaving.left_out(answer, given)
    return replace(found, left=left.changes, kept=left.why)


def unasked(found: Repair, answer: Answer, given: Given) -> tuple[str, ...]:
    """Return who could be asked for a repair, each with what for; nobody where something is certain."""
    if found.certain.changes:
        return ()
    files = holders.sought_for(answer, given)
    releases = other_python.sought(answer, given)
    return (
        *(["apt which package holds what is missing"] if files else []),
        *([f"pip's index for which Python it has a wheel of {releases[0].asked.written}"] if releases else []),
    )
