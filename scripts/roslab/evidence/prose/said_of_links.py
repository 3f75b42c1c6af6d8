"""What a page says of a repository beside its link: that it is a fork, or that it is not public or may not work."""

from __future__ import annotations

import re

from roslab.values.pattern import pattern

MOST = 240
"""Most characters before a link, and most of a sentence, that are read."""
_FORK = pattern(
    r"\b(?:forked|forks?(?! (?:of|from|it|me|this|the|your)\b)"
    r"|(?:our|my) (?:own )?(?:[\w-]+ )?(?:version|copy)|(?:modified|patched|customi[sz]ed|adapted) (?:version|copy))\b",
    re.IGNORECASE,
)
"""What is linked is a fork; not a fork of what is linked, nor what a reader is asked to do."""
_CHANGED = pattern(r"\b(?:modified|patched|customi[sz]ed|adapted) (?:the )?[`*]*([\w-]+)", re.IGNORECASE)
"""What its author has changed, by name: ``Modified octomap, with labels``."""
_CALLED_CHANGED = pattern(
    r"(?:custom(?:i[sz]ed)?|modified|patched|forked)[_-](\w[\w.-]*)|"
    r"(\w[\w.-]*?)[_-](?:custom(?:i[sz]ed)?|modified|patched|fork(?:ed)?)",
    re.IGNORECASE,
)
"""The name of a repository that says so itself: ``customized_grid_map``."""
_NAMED = pattern(
    r"\b(?:forked|modified|patched|customi[sz]ed|adapted|own)\b[^\]\n]{0,30}\b(?:version|copy) of "
    r"(?:the )?(?:official |original )?[`*]{0,3}([\w-]+)[`*]{0,3}\]\(<?$"
    r"|\bfork of (?:the )?(?:official |original )?[`*]{0,3}([\w-]+)[`*]{0,3}\]\(<?$",
    re.IGNORECASE,
)
"""What a link's own words, up to its address, say that it is a fork of."""
_USED = pattern(
    r"\b(?:us(?:e|ing)|need(?:ed|s)?|requires?|install(?:ing)?)\s+(?:(?:the|our|my|this|an?|following)\s+){0,3}"
    r"\[[^\]\n]{1,80}\]\(<?$",
    re.IGNORECASE,
)
"""A sentence that has the reader use what it links to, up to the address."""
_NOT_USED = pattern(r"\b(?:not|never|instead of|rather than|if|optional\w*|alternativ\w*)\b|n't\b", re.IGNORECASE)
_ASKS = pattern(r"\b(?:to|please|can|could|may|should|you|and|or)\s+(?:also\s+)?$", re.IGNORECASE)
_UNAVAILABLE = pattern(
    r"(?:\bnot|n't|\bno longer)(?: (?:yet|currently|be|been|made|still))*"
    r" (?:publi\w+|available|released|open[- ]?sourced?|accessible)\b",
    re.IGNORECASE,
)
_UNCERTAIN = pattern(
    r"(?:\b(?:may|might|does|do|will|would) not|\b(?:doesn|don|won|wouldn)'t) work\b(?! without\b)"
    r"|\b(?:don'?t|do not|not) (?:know|sure|certain)\b[^.]{0,60}\bworks?\b",
    re.IGNORECASE,
)
_ELSEWHERE = pattern(
    r"\b(?:on|for|in|under|with|to) (?:\w+ ){0,2}"
    r"(?:windows|mac ?os(?: ?x)?|osx|arm(?:64|v\d\w*)?|aarch64|jetson\w*|raspberry|wsl\d?|"
    r"conda|pip|ubuntu|debian|fedora|arch|ros ?[12]?|(?:ros ?[12]? )?(?:indigo|jade|kinetic|lunar|melodic|noetic|"
    r"foxy|galactic|humble|iron|jazzy|rolling)|python|(?:other|older|newer|previous|earlier|later) \w+)\b",
    re.IGNORECASE,
)
"""What is said of another system or release is said of no other."""
_OF_CODE = pattern(
    r"\b(?:forks?|forked|original|upstream|version|repo(?:sitory)?|code|package|library|source|solver|it|this)\b",
    re.IGNORECASE,
)
_SENTENCE = pattern(r"(?<=[.!?])\s+|(?<=[.!?]\*)\s*\*?\s+")
_MARKS = " \t\n*_:;,)(`-"


def forked(before: str, after: str, name: str) -> bool:
    """Tell whether a page calls what it links to a fork or a version of its own, or the link's own name does.

    ``before`` and ``after``: what stands before and behind the link, in its line or item; ``name``: its repository's.
    """
    for text in (before, after):
        if any(not _ASKS.search(text[: match.start()]) for match in _FORK.finditer(text)):
            return True
        changed = (match[1] for match in _CHANGED.finditer(text) if not _ASKS.search(text[: match.start()]))
        if any(_spelled(each) == _spelled(name) for each in changed):
            return True
    return unchanged(name) != name


def fork_of(before: str) -> str:
    """Return what a link's own words say that it is a fork of, else ``""``; ``before``: up to its address."""
    found = _NAMED.search(before)
    return (found[1] or found[2]) if found else ""


def used(before: str) -> bool:
    """Tell whether the sentence of a link has the reader use what it leads to; ``before``: up to its address."""
    found = _USED.search(before)
    sentence = _SENTENCE.split(before[: found.start()])[-1] if found else ""
    return found is not None and not _NOT_USED.search(sentence)


def unchanged(name: str) -> str:
    """Return the name of what a repository was forked from, where its own says so, else its own."""
    called = _CALLED_CHANGED.fullmatch(name)
    return called[1] or called[2] if called else name


def _spelled(name: str) -> str:
    return name.lower().replace("-", "_")


def doubt(after: str) -> str:
    """Return the sentence behind a link that says that the code is not public or may not work, ``""`` without one."""
    for sentence in _SENTENCE.split(after):
        uncertain = _UNAVAILABLE.search(sentence) or _UNCERTAIN.search(sentence)
        if uncertain and len(sentence) <= MOST and _OF_CODE.search(sentence) and not _ELSEWHERE.search(sentence):
            return " ".join(sentence.split()).strip(_MARKS)
    return ""
