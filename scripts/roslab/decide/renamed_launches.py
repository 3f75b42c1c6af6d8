"""A page that launches from a package which exists nowhere: a file of the tree of almost that name may be meant.

Authors rename a package, or a launch file, and forget the page.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from roslab.decide.ros.slips import meant
from roslab.evidence.facts import Evidence
from roslab.knowledge.released import ever_released
from roslab.values.pattern import pattern

Declared = Mapping[tuple[str, str], frozenset[str]]
"""The arguments that each launch file declares, by its package and its name."""
_ENDING = pattern(r"(?:[._]launch)?\.(?:launch|py|xml|ya?ml)$")


def declared_by(evidence: Evidence) -> Declared:
    """Return those of the launch files of all packages."""
    launches = (each for each in evidence.launch if each.package and each.installed and not each.tests)
    return {(str(each.package), each.file.rpartition("/")[2]): frozenset(each.arguments) for each in launches}


def renamed(words: tuple[str, ...], declared: Declared) -> tuple[str, ...]:
    """Return package, launch file and arguments of the tree for those that a page names, ``()`` where none is meant.

    ``words`` are what follows ``roslaunch``, with a package that exists nowhere, and that is no other one of a family
    (``detection2``). The tree has one package with launch files, and a single one of them is called like the page's,
    contains its name or ends with it, and declares the arguments that the page gives.
    """
    if len(words) < 2:
        return ()
    said, (file, *rest) = words[0], words[1:]
    stem = _ENDING.sub("", file)
    asked = {word.partition(":=")[0] for word in rest if ":=" in word}
    alone = len({package for package, _ in declared}) == 1
    packages = {package for package, _ in declared}
    numbered = said.rstrip("0123456789") in {package.rstrip("0123456789") for package in packages}
    if not (alone and stem) or numbered or meant(said, packages):
        return ()
    named = {each: _ENDING.sub("", each[1]) for each in declared}
    for fits in (str.__eq__, str.endswith, str.__contains__):
        found = [each for each, name in named.items() if fits(name, stem) and asked <= declared[each]]
        if found:
            return (*found[0], *rest) if len(found) == 1 else ()
    return ()


def renamings(evidence: Evidence) -> Iterator[tuple[str, str]]:
    """Yield each package that exists nowhere and of which pages launch, with the file of the tree that is taken."""
    declared = declared_by(evidence)
    own = {manifest.name for manifest in evidence.manifests}
    for mention in evidence.mentions:
        at_root = mention.topic == "command" and mention.source == "readme" and "/" not in mention.file
        words = tuple(mention.value.split()) if at_root else ()
        start = 1 if words[:1] == ("roslaunch",) else 2 if words[:2] == ("ros2", "launch") else 0
        package = words[start] if start and len(words) > start else ""
        nowhere = bool(package) and package not in own and not ever_released(package)
        if nowhere and (found := renamed(words[start:], declared)):
            yield package, " ".join(found[:2])
