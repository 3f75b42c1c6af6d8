"""The day that the image is to be of: what did not exist then is chosen by nothing but the author's own word."""

from __future__ import annotations

from collections.abc import Iterable

from roslab.config.model import Config
from roslab.decide.decision import Choice, Reason
from roslab.decide.reasons import because, configured, warn
from roslab.evidence.facts import Evidence, Mention
from roslab.knowledge.days import long_ago
from roslab.knowledge.distros import distros, ubuntu_released
from roslab.values.dataclass import replace

PAPER = "paper"
"""The day of the newest commit, else of the citation file."""
TODAY = "today"
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


def decide_days(evidence: Evidence, config: Config) -> tuple[Choice[str | None], Choice[str | None], Evidence]:
    """Return the day of the image, the day of pip's packages where that is another, and the evidence of these days."""
    day, of_pip = decide_day(evidence, config), decide_pip_day(evidence, config)
    return day, of_pip, replace(as_of(evidence, day.answer), pip_day=of_pip.answer)


def decide_pip_day(evidence: Evidence, config: Config) -> Choice[str | None]:
    """Return the day of pip's packages where it is not that of the whole image, ``None`` for today's packages.

    Unless ``pip_date`` says it, the day of the last commit where that is long ago: what the code was written for and no
    file pins. An old format is followed as it was.
    """
    last = next((each for each in evidence.worked_on if each.source == "commit"), None)
    if config.pip_date == TODAY:
        return Choice(answer=None, reasons=(configured(config, "pip_date", TODAY, "pip_date"),))
    if config.pip_date and config.pip_date != PAPER:
        said = configured(config, "pip_date", config.pip_date, "pip_date")
        return Choice(answer=config.pip_date, reasons=(said,))
    if config.pip_date == PAPER and last is None:
        message = "`pip_date: paper` finds no commit: pip's packages are of today"
        return Choice(answer=None, warnings=(warn(message, config.origin("pip_date")),))
    if last is None or (config.pip_date is None and (last.value >= long_ago() or config.date or config.compatible)):
        return Choice(answer=None)
    because_of = "pip_date: paper" if config.pip_date else "the last commit is old; `pip_date: today` takes today's"
    why = f"what pip installs without a version is of {last.value}: {because_of}"
    return Choice(answer=last.value, reasons=(because("pip_date", last.value, why, last, weight=_WEIGHT),))


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
