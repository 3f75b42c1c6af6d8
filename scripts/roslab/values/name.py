"""Names of Python packages as an index compares them."""

from __future__ import annotations

from functools import cache

from roslab.values.pattern import pattern

_RUN = pattern(r"[-_.]+")
_OTHER = pattern(r"[^a-z0-9]")


@cache
def canonicalize_name(name: str) -> str:
    """Return the name in lower case with one hyphen for each run of ``-``, ``_`` and ``.``.

    ``packaging.utils`` has the same function and a slow start, which a repository without pip's packages need not wait
    for. https://peps.python.org/pep-0503/#normalized-names.
    """
    return _RUN.sub("-", name).lower()


def bare_name(name: str) -> str:
    """Return the letters and digits of a name in lower case, to compare names that are written in several ways."""
    return _OTHER.sub("", name.lower())
