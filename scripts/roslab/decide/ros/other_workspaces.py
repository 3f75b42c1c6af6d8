"""Of several workspaces or copies of packages with the same names, the one that is built: a build tool stops at two."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Sequence

from roslab.decide.decision import Warning_
from roslab.decide.reasons import warn
from roslab.evidence import places
from roslab.evidence.facts import Evidence, PackageManifest
from roslab.values.pattern import pattern

_SOURCES = pattern(r"((?:[^/]+/)*?[^/]+)/src/.+/package\.xml$")
"""A package in the ``src`` of a workspace below the root."""
_MAIN = pattern(r"(?:^|[-_/])main(?:[-_]|$)", re.IGNORECASE)
_CALLS = {"roslaunch": 1, "ros2": 2}
"""Where the package stands in what starts a launch file."""

MOST_NAMED = 6
"""Most folders that one warning names."""
Launches = tuple[tuple[str, ...], ...]
"""Of each launch that pages start, in their order: where the file may lie."""


def page_launches(evidence: Evidence) -> Launches:
    """Return the launch files that pages at the root start; of several with the same call, those where the page is."""
    return tuple(_page_launches(evidence))


def _page_launches(evidence: Evidence) -> Iterator[tuple[str, ...]]:
    for mention in evidence.mentions:
        words = mention.value.split()
        at = _CALLS.get(words[0], 0) if mention.topic == "command" and words and "/" not in mention.file else 0
        if not at or len(words) < at + 2 or (at == 2 and words[1] != "launch"):
            continue
        package, name = words[at : at + 2]
        named = [each.file for each in evidence.launch if each.package == package and each.file.endswith(f"/{name}")]
        here = [file for file in named if mention.inside and file.startswith(f"{mention.inside}/")]
        if named:
            yield tuple(here or named)


def started(folders: Collection[str], launches: Launches) -> frozenset[str]:
    """Return the folders in which the first launch that any of them has may lie."""
    for files in launches:
        if found := frozenset(folder for folder in folders if any(file.startswith(f"{folder}/") for file in files)):
            return found
    return frozenset()


def other_workspaces(manifests: Sequence[PackageManifest], launches: Launches) -> set[str]:
    """Return the workspaces of a tree that hold packages of the same names as one that is built, and those of tests.

    The one is built of which a page at the root starts a launch file; of the others the one that is called the main
    one, else the one with most packages.
    """
    inside: dict[str, set[str]] = {}
    for manifest in manifests:
        found = _SOURCES.match(manifest.file)
        if found and manifest.name and not manifest.ignored:
            inside.setdefault(found[1], set()).add(manifest.name)
    tests = {root for root in inside if places.test(f"{root}/src")}
    tests = tests if len(tests) < len(inside) else set()
    left = sorted(inside.keys() - tests)
    out = set(tests)
    for group in (started(left, launches), left):
        last = [root for root in left if root in group and root not in out]
        best = max(last, key=lambda root: (bool(_MAIN.search(root)), len(inside[root])), default="")
        out |= {root for root in left if root != best and inside[root] & inside.get(best, set())}
    return out


def warn_of_others(
    evidence: Evidence, built: Sequence[PackageManifest], doubles: Sequence[str]
) -> tuple[Warning_, ...]:
    """Warn of workspaces and copies that are left out since packages of the same names are built."""
    names = {manifest.name: manifest for manifest in built}
    same = [
        (folder, names[manifest.name])
        for folder in doubles
        for manifest in evidence.manifests
        if manifest.name in names and not manifest.ignored and f"{manifest.file}/".startswith(f"{folder}/")
    ]
    if not same:
        return ()
    folders = list(dict.fromkeys(folder for folder, _ in same))
    named = ", ".join(folders[:MOST_NAMED]) + (f" and {len(folders) - MOST_NAMED} more" * (len(folders) > MOST_NAMED))
    message = f"not built: {named}, with packages of the same names as those that are built, {same[0][1].name} for one"
    return (warn(f"{message}; the input `path` builds a folder as if it were the whole", same[0][1]),)
