"""The day that the image is to be of: what did not exist then is chosen by nothing but the author's own word."""

from __future__ import annotations

from collections.abc import Iterable

from roslab.config.model import Config
from roslab.decide.decision import Choice, Reason
from roslab.decide.reasons import because, configured, warn
from roslab.evidence.facts import Evidence, Mention
from roslab.knowledge.distros import distros, ubuntu_released
from roslab.values.dataclass import replace

PAPER = "paper"
"""The day of the newest commit, else of the citation file."""
_WEIGHT = 500


def decide_day(evidence: Evidence, config: Config) -> Choice[str | None]:
    """Return the day (``YYYY-MM-DD``) that ``date`` asks for, ``None`` if it asks for none."""
    if config.date is None:
        return Choice(answer=None)
    if config.date != PAPER:
        return Choice(answer=config.date, reasons=(configured(config, "date", config.date, "date"),))
    found = next(iter(evidence.worked_on), None)
    if found is None:
        message = "`date: paper` finds neither a commit nor a citation file with a year: the image is of today"
        return Choice(answer=None, warnings=(warn(message, config.origin("date")),))
    why = because("date", found.value, f"date: paper, and {found.file} says {found.text}", found, weight=_WEIGHT)
    return Choice(answer=found.value, reasons=(why,))


def as_of(evidence: Evidence, day: str | None) -> Evidence:
    """Return the evidence with the day in place of the date of the last commit."""
    if day is None:
        return evidence
    then = Mention(topic="date", value=day, source="commit", file="", line=0, text=f"the image is to be of {day}")
    kept = (mention for mention in evidence.mentions if mention.topic != "date")
    return replace(evidence, mentions=(*kept, then), day=day)


def existed(evidence: Evidence, codename: str) -> bool:
    """Tell whether a distribution of ROS or a release of Ubuntu was there on the evidence's day, if it has one."""
    if evidence.day is None:
        return True
    found = distros().get(codename)
    return (found.released if found else ubuntu_released().get(codename, "")) <= evidence.day


def there(evidence: Evidence, reasons: Iterable[Reason]) -> list[Reason]:
    """Return the reasons for what was there on the evidence's day."""
    return [reason for reason in reasons if existed(evidence, reason.answer)]
