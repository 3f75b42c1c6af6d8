"""Releases from which on something works: ``Indigo+``, ``Ubuntu 18.04 or newer`` name none that it was made on."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from functools import cache

from roslab.decide.decision import Reason
from roslab.decide.reasons import because
from roslab.decide.ros.distro_dates import dated, of_its_time
from roslab.evidence.facts import Evidence, Mention
from roslab.knowledge.distros import Distro, distro, distros, distros_of, ever, successor, ubuntus
from roslab.values.open_ended import OF_LANGUAGES
from roslab.values.pattern import pattern

_ADORNED = r"(?:\]\([^)\n]{1,150}\))?[*_`\"')]{0,4}"
_ON = (
    r"(?:\+(?![\w+])|[\s,]{0,3}[(\[]?(?:or|and|&)\s+(?:(?:any|all|every)\s+)?(?:newer|later(?!\s+(?:with|on|in|by|to|also)\b)|"
    rf"above|higher|greater|up|upwards?|onwards?|beyond|more\s+recent)\b|[\s,(]{{1,3}}onwards?\b|{OF_LANGUAGES})"
)
"""What says after a name that later ones are meant too."""
_LEAST = r"(?:>=|≥|\bat\s+least|\bminimum(?:\s+version)?(?:\s+is)?:?)\s{0,3}(?:ros\s*[12]?\s+)?[*_`\"'\[]{0,3}"


@cache
def bounds(mention: Mention) -> bool:
    """Tell whether a page names a distribution, or an Ubuntu, as the oldest on which it works; several ask it."""
    if mention.source != "readme" or mention.topic not in {"distro", "ubuntu"}:
        return False
    if mention.topic == "ubuntu":
        return "ubuntu" in mention.text.lower() and bool(_said_of_ubuntu(mention.value).search(mention.text))
    return bool(_said(mention.value).search(mention.text))


@cache
def _said(name: str) -> re.Pattern[str]:
    """Return the pattern of a name as a lower bound: before its own second word, or a list that goes on."""
    others = "|".join(sorted(ever()))
    more = rf"(?:\s{{0,2}}(?:[/,]|\bor\b|\band\b)\s{{0,2}}(?:ros\s)?(?:{others})\b{_ADORNED}){{0,5}}"
    second = r"(?:\s+(?!or\b|and\b|with\b|on\b)[a-z]+[)*_`]{0,3})?"
    return pattern(rf"\b{name}\b{_ADORNED}{more}{second}{_ON}|{_LEAST}{name}\b", re.IGNORECASE)


@cache
def _said_of_ubuntu(name: str) -> re.Pattern[str]:
    """Return the pattern of an Ubuntu as a lower bound: before its codename in parentheses, or a list that goes on."""
    further = rf"(?:\s{{0,2}}(?:[/,]|\bor\b|\band\b)\s{{0,2}}(?:ubuntu\s)?\d\d\.\d\d\b{_ADORNED}){{0,5}}"
    second = rf"(?:\s+lts\b)?(?:\s{{0,2}}\([a-z ]{{1,30}}\))?{_ADORNED}"
    least = (
        r"(?:>=|≥|\bat\s+least)\s{0,3}(?:ubuntu\s+)?[*_`\"'\[]{0,3}|\bubuntu\s{0,3}(?:version\s{0,3})?(?:>=|≥)\s{0,3}"
    )
    return pattern(
        rf"(?<![\w.]){re.escape(name)}(?![a-z0-9_]){_ADORNED}{further}{second}{_ON}|(?:{least}){re.escape(name)}(?![a-z0-9_])",
        re.IGNORECASE,
    )


def least(evidence: Evidence, named: Iterable[Reason], ros: int, weights: dict[Mention, int]) -> Iterator[Reason]:
    """Yield the distribution for a page that only names the oldest one: of the last commit's time, or the oldest.

    None where a distribution from that one on is ``named``, which then decides. ``weights``: how much each lower bound
    counts.
    """
    listed = [distros()[reason.answer].released for reason in named]
    date = dated(evidence)
    answer = distros()[of_its_time("ros1" if ros == 1 else "ros2", date.value if date else None)]
    for mention, weight in weights.items():
        oldest = _oldest(mention.value, ros)
        if oldest is None or oldest.ros != ros or any(released >= oldest.released for released in listed):
            continue
        found = max(answer, oldest, key=lambda each: each.released)
        fits = f": {found.name} fits the last commit, of {date.value}" if date and found == answer else ""
        yield because("ros_distro", found.name, f"“{mention.text[:120]}”{fits}", mention, weight=weight)


def _oldest(name: str, ros: int) -> Distro | None:
    """Return the distribution itself, or the one of an Ubuntu; the next one where it never had an image."""
    on_it = distros_of(ubuntus().get(name, name), 1 if ros == 1 else 2)
    return distro(on_it[0] if on_it else name) or successor(name)
