"""Lists of requirements called almost as usual: ``requirments.txt``, ``requirements``, ``requirements-pip``."""

from __future__ import annotations

from roslab.evidence import places
from roslab.evidence.facts import RequirementFile
from roslab.knowledge.frameworks import imports
from roslab.repository.checkout import Repository
from roslab.values.name import canonicalize_name
from roslab.values.pattern import pattern

_USUAL = ("requirements", "requirement")
_ENDS = (".txt", ".in", ".pip")
_MOST = 2
"""Most letters that a name is longer or shorter by."""
_FOR_PIP = pattern(r"requirements?[-_](?:pip3?|py(?:thon)?3?)")
"""Who has another list beside it, for conda or for apt."""
_NEAR = 0.83
"""How alike it is to a usual one: two letters of twelve are others."""


def named(repository: Repository) -> frozenset[str]:
    """Return the text files at the top, and beside code of Python, that are called so; anywhere those for pip."""
    close = [name for name in repository.by_name if _close(name)]
    files = repository.named(*close) if close else ()
    beside = {file.folder for file in repository.suffixed(".py")} if files else set()
    return frozenset(
        file.path
        for file in files
        if not file.folder
        or ((file.folder in beside or _FOR_PIP.fullmatch(file.name.lower())) and not places.vendored(file.path))
    )


def only_packages(file: RequirementFile, lines: int) -> bool:
    """Tell whether each of the lines in a file is one of pip's, and whether they are of packages that pip has.

    A list of what the system has is made of names as well, but has no versions in Python's spelling.
    """
    asked = file.requirements
    read = len(asked) + len(file.includes) + len(file.constraints) + len(file.options)
    if not asked or read != lines or not all(each.package and each.name and each.role != "repaired" for each in asked):
        return False
    known = {canonicalize_name(package) for package, _ in imports().values() if package}
    return any(each.specifier for each in asked) or all(each.key in known for each in asked)


def _close(name: str) -> bool:
    """Tell whether a file's name, with a suffix of such lists or with none, is almost a usual one."""
    lowered = name.lower()
    if _FOR_PIP.fullmatch(lowered):
        return True
    stem = next((lowered.removesuffix(end) for end in _ENDS if lowered.endswith(end)), lowered)
    if not stem.startswith("r") or "." in stem:
        return False
    if not any(abs(len(stem) - len(usual)) <= _MOST for usual in _USUAL):
        return False
    from difflib import get_close_matches  # noqa: PLC0415 - few trees have such a name

    return bool(get_close_matches(stem, _USUAL, n=1, cutoff=_NEAR))
