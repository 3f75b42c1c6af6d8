"""Packages that functions of others need: ``knn_graph`` of torch_geometric that of torch-cluster."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Set

from roslab.evidence.facts import Evidence
from roslab.values.requirement import Requirement
from roslab.values.requirement_line import stated


def companions_of(
    evidence: Evidence, guessed: Iterable[Requirement], declared: Iterable[Requirement], known: Set[str]
) -> Iterator[Requirement]:
    """Yield what used functions of packages among ``guessed`` and the ``known`` ones need and nothing names.

    An extra of such a package is asked for in the version of the guess, if those ``declared`` have it not.
    """
    extras = {(each.key, extra) for each in declared for extra in each.extras}
    by_name = {each.key: each for each in guessed}
    named = {*known, *by_name}
    for used in evidence.mentions:
        if used.topic != "companion" or used.value not in named:
            continue
        asked = stated(used.text, "import", used.file, used.line)
        guess = by_name.get(used.value)
        if asked.key != used.value:
            if asked.key not in named:
                named.add(asked.key)
                yield asked
        elif asked.extras and not (guess.extras or guess.url if guess else _has(asked, extras)):
            yield stated(f"{used.text}{guess.specifier if guess else ''}", "import", used.file, used.line)


def _has(asked: Requirement, extras: Set[tuple[str, str]]) -> bool:
    """Tell whether a package is declared with an extra that is asked for, or with all of its extras."""
    return any((asked.key, extra) in extras for extra in (*asked.extras, "all"))
