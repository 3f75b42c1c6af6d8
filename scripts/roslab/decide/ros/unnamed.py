"""The ROS distribution of what names none: of the last commit's time, else the default."""

from __future__ import annotations

from roslab.config.model import Kind
from roslab.decide.decision import Choice
from roslab.decide.reasons import Placed, because, warn
from roslab.decide.ros.by_packages import by_packages
from roslab.decide.ros.distro_dates import dated, of_its_time, supported
from roslab.decide.ros.distro_weights import Weight
from roslab.evidence.facts import Evidence, Mention
from roslab.knowledge.distros import Distro, default_distro, distros


def of_unnamed(evidence: Evidence, kind: Kind, unknown: dict[str, frozenset[str]]) -> Choice[Distro | None]:
    """Return the distribution of the last commit's time, else the default; if that lacks a key, one with every key."""
    from roslab.decide.ros.by_python import by_python  # noqa: PLC0415 - nearly every tree says more
    from roslab.decide.ros.lost_keys import with_every_launched, with_every_package  # noqa: PLC0415
    from roslab.decide.ros.python3_nodes import with_python3  # noqa: PLC0415

    date = dated(evidence)
    at: Placed | None = date
    answer = of_its_time(kind, date.value if date else None)
    why = "no distribution is named: the default"
    if date:
        default = default_distro(1 if kind == "ros1" else 2).name
        usual = "the default fits" if answer == default else f"{answer}, not the default {default}, fits"
        why = f"no distribution is named; {usual} the last commit, of {date.value}"
    old = next((m for m in evidence.mentions if _is_python2(m)), None)
    three = any(m.topic == "python" and m.value.startswith("3") for m in evidence.mentions)
    if kind == "ros1" and old and not three and not distros()[answer].python.startswith("2"):
        of_python2 = (found for found in distros().values() if found.python.startswith("2") and found.ros == 1)
        answer = max(of_python2, key=lambda found: found.preference).name
        why = f"no distribution is named, and {answer} is the last with Python 2: “{old.text.strip()[:60]}”"
        date = at = old
    if not three and (theirs := by_packages(evidence, 1 if kind == "ros1" else 2)) and not unknown.get(theirs[0]):
        answer, why, at = theirs
    elif (newer := with_python3(evidence, 1 if kind == "ros1" else 2, answer)) and not unknown.get(newer[0]):
        answer, why, at = newer
    ours = by_python(evidence, 1 if kind == "ros1" else 2)
    if ours and not unknown.get(ours[0]):
        answer, why, at = ours
    if lacks := sorted(unknown.get(answer, ())):
        fitting = [name for name, missing in unknown.items() if not missing]
        then = [name for name in fitting if date and date.topic == "date" and supported(name, date.value)]
        why = "no distribution is named: the default of those that have what the packages declare and the code needs"
        best = max(then or fitting, key=lambda name: distros()[name].preference, default=answer)
        if then and date:
            why = (
                f"no distribution is named; {answer}, which fits the last commit, of {date.value}, has no {lacks[0]}, "
            )
            why += f"and {best} was there, too"
        answer = best
    fitting = [name for name, missing in unknown.items() if not missing]
    if older := with_every_package(evidence, 1 if kind == "ros1" else 2, answer, fitting):
        why = f"no distribution is named, and {older[0]} is the last that released {older[1].name}"
        answer, at = older
    there_then = [name for name in fitting if date and date.topic == "date" and supported(name, date.value)]
    if not older and (other := with_every_launched(evidence, 1 if kind == "ros1" else 2, answer, there_then)):
        why = f"no distribution is named; {answer} has no {other[1].name}, which launch files need, and {other[0]} has"
        answer, at = other
    message = f"nothing says which ROS distribution this is for: {answer} is used; set base.ros in roslab.yaml"
    reason = because("ros_distro", answer, why, at, weight=Weight.DEFAULT)
    return Choice(answer=distros()[answer], reasons=(reason,), warnings=(warn(message),))


def _is_python2(mention: Mention) -> bool:
    return mention.topic == "python" and mention.value.startswith("2") and mention.source in {"readme", "code"}
