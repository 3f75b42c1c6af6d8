"""Names of Python packages as an index compares them."""

from __future__ import annotations

from functools import cache

from roslab.values.pattern import pattern

_RUN = pattern(r"[-_.]+")
_SECOND = pattern(r"(?<=[a-z]\w)-\d$")
_OTHER = pattern(r"[^a-z0-9]")


@cache
def canonicalize_name(name: str) -> str:
    """Return the name in lower case with one hyphen for each run of ``-``, ``_`` and ``.``.

    ``packaging.utils`` has the same function and a slow start, which a repository without pip's packages need not wait
    for. https://peps.python.org/pep-0503/#normalized-names.
    """
    return _RUN.sub("-", name).lower()


def of_fork(name: str) -> str:
    """Return the name of what a repository is a fork of, by its own: GitHub calls a second ``d4rl`` ``d4rl-1``.

    https://docs.github.com/en/pull-requests/collaborating-with-pull-requests/working-with-forks, 2026-11-27
    """
    return _SECOND.sub("", canonicalize_name(name))


def bare_name(name: str) -> str:
    """Return the letters and digits of a name in lower case, to compare names that are written in several ways."""
    return _OTHER.sub("", name.lower())
