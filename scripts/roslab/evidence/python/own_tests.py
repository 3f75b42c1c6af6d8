"""Modules that only test themselves where they are started."""

from __future__ import annotations

from roslab.values.pattern import pattern

_TESTS = pattern(r"(?:\w+[ \t]*=[ \t]*)?(?:sys\.exit\()?(?:(?:doctest\.)?test(?:mod|file)|unittest\.main)\(")
_PREPARES = pattern(
    r"#|(?:import|from)[ \t]|(?:try|finally|else)[ \t]*:|except\b|pass\b|\w+\.(?:set_printoptions|seed)\(|\)"
)


def only_tests(text: str) -> bool:
    """Tell whether what follows ``if __name__ == "__main__"`` runs its doctests or unit tests and nothing else.

    Such a module is there to be imported.
    """
    first, *lines = text.partition(":")[2].split("\n")
    found = [first.strip()]
    for line in lines:
        if line.strip() and not line[0].isspace() and not line.startswith("#"):
            break
        found.append(line.strip())
    does = [line for line in found if line and not _PREPARES.match(line)]
    return bool(does) and all(map(_TESTS.match, does))
