"""Words of a program's name that say what its package or its repository is there for: ``x_teleop/teleop.launch``."""

from __future__ import annotations

import re
from collections.abc import Iterator
from os.path import commonprefix

from roslab.decide.candidate import LAUNCHERS, Candidate, program_of
from roslab.evidence.facts import Evidence
from roslab.values.pattern import pattern

FEWEST = 4
"""Fewest letters that two words share: ``eval`` and ``evaluate``."""
_ENDING = pattern(r"e?[sdr]?|[eo]rs?|ings?|(?:at|it|uat|rat|erat)?(?:e[sd]?|ed|ing|ors?|ions?)")
"""What two forms of a word end in, after what they share: ``calibrate``, ``calibration``; ``record``, ``recorder``."""
_BREAK = pattern(r"[^A-Za-z0-9]+|(?<=[a-z])(?=[A-Z])")
_BESIDE = pattern(r"_(?:msgs|srvs|interfaces|description)$")
_UPKEEP = pattern(
    r"install\w*|set|setup|up|build|make|compile|config\w*|clone|update|fetch|clean|docker\w*|lint|tidy|udev\w*|reset|kill\w*|"
    r"stop|shut|down|v?env|conda|environment|create|get|add|init\w*|sync|pull|source|load|activate|git|repos?|"
    r"repositor(?:y|ies)|sub|modules?|submodules?|dep(?:s|endenc(?:y|ies))|data|datasets?|weights?|models?|assets?",
    re.IGNORECASE,
)
"""Words that say nothing of a purpose, whatever the repository is called."""
_MAKES = frozenset({"generate", "extract"})
_OF_DATA = pattern(
    r"data\w*|sets?|samples?|train\w*|prepar\w*|pre|process\w*|labels?|annotations?|splits?|features?|maps?|paths?"
)
"""Words of what is made for another program."""


def of_purpose(candidate: Candidate, found: str) -> bool:
    """Tell whether a word ``found`` in a program's name is one of its package's or of the whole tree's, too.

    Of one package of several only where it is the same: that may be there to serve the others.
    """
    words = program_of(candidate.argv)
    package = words[-2] if words[0] in LAUNCHERS else ""
    if found.strip("_.-") in package.split("_"):
        return True
    there = [word for name in candidate.names for word in words_of(name)]
    # Behind the first word stands what it is done to
    first = next((word for word in words_of(found) if not _UPKEEP.fullmatch(word)), "")
    return any(alike(first, other) for other in there) if first else False


def names_of_whole(evidence: Evidence) -> Iterator[str]:
    """Yield what the whole is called: the repository, and the only package beside those of messages."""
    if evidence.origin:
        yield evidence.origin.rstrip("/").rpartition("/")[2].removesuffix(".git")
    names = {manifest.name for manifest in evidence.manifests if manifest.name}
    own = {name for name in names if not _BESIDE.search(name)}
    yield from own if len(own) == 1 else ()


def words_of(name: str) -> Iterator[str]:
    """Yield the words of a name, in small letters."""
    yield from (word.lower() for word in _BREAK.split(name) if word)


def alike(one: str, other: str) -> bool:
    """Tell whether two words are forms of one: what they share is long enough, and the rest of each is an ending."""
    root = commonprefix((one, other))  # noqa: RUF071 - of letters, not of folders
    ends = [word[len(root) :] for word in (one, other)]
    ends = [end[1:] if end[:1] == root[-1:] and len(end) > 1 else end for end in ends]  # plot, plotter
    return one == other or (len(root) >= FEWEST and all(map(_ENDING.fullmatch, ends)))


def of_section(candidate: Candidate) -> bool:
    """Tell whether the title of a program's section names all that the program makes: ``generate_relevancy``.

    A section about data, or about making them, has programs that only serve another one.
    """
    verb, *made = words_of(program_of(candidate.argv)[-1].rpartition("/")[2].partition(".")[0])
    title = tuple(words_of(candidate.heading.rpartition(" / ")[2]))
    if verb not in _MAKES or not made or any(alike(verb, word) or _OF_DATA.fullmatch(word) for word in (*title, *made)):
        return False
    return all(any(alike(word, other) for other in title) for word in made)
