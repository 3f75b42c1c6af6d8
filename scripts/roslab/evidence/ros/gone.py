"""Launch files of the tree's own packages that another one includes, and that the tree does not have."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping

from roslab.evidence.lex.xml_comments import without_xml_comments
from roslab.evidence.ros import better_launch
from roslab.repository.checkout import File, Repository
from roslab.values.pattern import pattern

_INCLUDE = pattern(
    r"<include\s[^<>]{0,300}?\bfile\s{0,9}=\s{0,9}[\"']\$\(\s*find(?:-pkg-share)?\s+([\w-]{1,60})\s*\)/([\w./-]{1,200})[\"']"
)
_LAUNCH = pattern(r".*(?:\.launch|_launch)(?:\.(?:py|xml|ya?ml))?|.*\.xml")
_MADE = ("", ".in", ".em", ".erb", ".xacro", ".j2")
"""What a file of the tree from which a build makes another has behind its name."""


def included_elsewhere(
    repository: Repository, file: File, packages: Mapping[str, str], conditional: Callable[[str, int, int], bool]
) -> Iterator[tuple[str, str, str, int]]:
    """Yield package and name of what a launch file includes in any case and nothing is called like, with its place.

    ``packages``: the folder of each package of the tree. A folder without any file may be that of a submodule.
    """
    text = repository.read(file)
    for match, waits in _includes(file, text, conditional):
        package, path = match[1], match[2]
        name = path.rpartition("/")[2]
        if waits or package not in packages or not _LAUNCH.fullmatch(name):
            continue
        if not any(repository.named(f"{name}{ending}") for ending in _MADE):
            yield package, name, file.path, text.count("\n", 0, match.start()) + 1


def _includes(
    file: File, text: str, conditional: Callable[[str, int, int], bool]
) -> Iterator[tuple[re.Match[str], bool]]:
    """Yield each place that includes a file of a package, and whether a condition decides about it."""
    if file.name.endswith(".py"):
        found = (each for each in better_launch.named(text) if each[0][0].startswith(".include"))
        yield from found
    elif "<include" in text:
        bare = without_xml_comments(text, spaced=True)
        for match in _INCLUDE.finditer(bare):
            yield match, conditional(bare, match.start() + 1, match.end())
