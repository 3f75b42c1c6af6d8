"""Pins of requirement files that a bot raised, one line at a time, by the subjects of its commits."""

from __future__ import annotations

from collections.abc import Iterable

from roslab.knowledge.pinned_pythons import together
from roslab.repository.checkout import Repository
from roslab.values.name import canonicalize_name
from roslab.values.pattern import pattern
from roslab.values.requirement import Requirement

_SUBJECT = pattern(
    r"(?:\w+(?:\([\w-]+\))?!?:\s+)?(?:[Bb]ump|[Uu]pdate)\s+(?:dependency\s+)?([A-Za-z][\w.-]*)\s+"
    r"(?:requirement\s+)?from\s+=*v?(\d[\w.]*)\s+to\s+=*v?(\d[\w.]*?)(?:\s.*)?"
)
"""As Dependabot and pyup write it: ``Bump torch from 1.8.0 to 2.2.0``, ``build(deps): bump torch from …``.

https://docs.github.com/en/code-security/dependabot, read 2026-11-27.
"""


def raised(repository: Repository, path: str, asked: Iterable[Requirement]) -> tuple[tuple[str, str, str], ...]:
    """Return what the commits of a file raised; git is asked only where no Python has wheels for all of its pins."""
    pins = [(each.key, each.release) for each in asked if each.release and not (each.url or each.marker)]
    if together(pins) is not None:
        return ()
    found = (_SUBJECT.fullmatch(subject) for subject in repository.subjects(path))
    return tuple((canonicalize_name(match[1]), match[2], match[3]) for match in found if match)
