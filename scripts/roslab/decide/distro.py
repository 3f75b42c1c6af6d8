"""Which ROS distribution: evidence is ranked by where it stands, words are never counted."""

from __future__ import annotations

import re
from dataclasses import dataclass, replace

from roslab.config.model import Config, Kind
from roslab.decide.decision import Reason, Warning_
from roslab.decide.reasons import configured, ranked
from roslab.decide.workspace import packages_of
from roslab.evidence import places
from roslab.evidence.conditions import holds
from roslab.evidence.facts import Evidence, Mention, Recipe
from roslab.knowledge.distros import Distro, distro, distros, distros_of, ubuntus
from roslab.knowledge.libraries import library
from roslab.knowledge.released import released, rosdep_keys

DEFAULT = {"ros1": "noetic", "ros2": "humble"}
"""Where nothing is said: the last of ROS 1, and the ROS 2 that most repositories of 120 work on."""
UNFIT = 400
"""What a distribution loses that lacks a declared key: more than a recipe outweighs a branch's convention."""
FAMILY = 2
"""Images of more distributions than this are a family, one for each: none of them says which is meant."""
_AGAINST = re.compile(
    r"not (?:been )?(?:tested|supported|work)|n't work|unsupported|no longer|deprecated|end[- ]of[- ]life|\beol\b|coming soon|todo|"
    r"(?:see|use|switch to|checkout|check out|available (?:in|on|at)|go to)\s+(?:the\s+)?[\w\"'`/-]*\s*(?:branch|tag)|\bbranch\b.*\bfor\b|for .*\bbranch\b|"
    r"\bport(?:ed)?\b|previous(?:ly)?|legacy|\bold(?:er)?\b|archive",
    re.IGNORECASE,
)
_TESTED = re.compile(
    r"test(?:ed)?\b|prerequisite|require|depend|install|ubuntu|support|compatible|/opt/ros/|ros-[a-z]+-|catkin|colcon|>=|≥|develop(?:ed)? (?:on|with|under|in)|recommend|using ros|\bros[ :_-]",
    re.IGNORECASE,
)
_BADGE = re.compile(r"badge|build\.ros2?\.org|shields\.io|\[!\[")
_AT_LEAST = re.compile(r"(?:>=|≥|or (?:later|newer|above|higher))", re.IGNORECASE)


@dataclass(frozen=True, kw_only=True, slots=True)
class DistroChoice:
    """The distribution (``None`` where the repository is not ROS), with what speaks for and against."""

    distro: Distro | None = None
    reasons: tuple[Reason, ...] = ()
    warnings: tuple[Warning_, ...] = ()


def decide_distro(evidence: Evidence, config: Config, kind: Kind) -> DistroChoice:
    """Return the ROS distribution that the repository is made for."""
    if config.base.ros and (known := distro(config.base.ros.partition("-")[0])):
        return DistroChoice(distro=known, reasons=(configured(config, "ros_distro", known.name, "base.ros"), *_demoted(_reasons(evidence, known.ros))))
    if kind not in {"ros1", "ros2"}:
        return DistroChoice()
    ros = 1 if kind == "ros1" else 2
    unknown = unknown_keys(evidence, ros)
    reasons = [_fitted(reason, unknown) for reason in _reasons(evidence, ros)]
    if config.base.ubuntu and (fitting := distros_of(config.base.ubuntu, 1 if ros == 1 else 2)):
        inside = [reason for reason in reasons if reason.answer in fitting]
        answer = max(inside, key=lambda reason: (reason.weight, _rank(reason.answer))).answer if inside else fitting[0]
        reason = configured(config, "ros_distro", answer, "base.ubuntu")
        return DistroChoice(distro=distros()[answer], reasons=(reason, *_demoted(reasons)))
    reasons += _fitting(reasons, unknown)
    if not reasons:
        answer = _default(kind, unknown)
        default = Reason(question="ros_distro", answer=answer, reason="nothing is said: the default", weight=1)
        warning = Warning_(message=f"nothing says which ROS distribution this is for: {answer} is taken; name it as base.ros in roslab.yaml")
        return DistroChoice(distro=distros()[answer], reasons=(default,), warnings=(warning,))
    best = max(reasons, key=lambda reason: (reason.weight, _rank(reason.answer)))
    return DistroChoice(distro=distros()[best.answer], reasons=ranked(reasons, best.answer))


def unknown_keys(evidence: Evidence, ros: int) -> dict[str, frozenset[str]]:
    """Return, for each distribution of a ROS version, the declared keys that it lacks and a better one has.

    A package needs what its authors' distribution has: keys that came later rule out older ones, and the reverse.
    """
    packages = packages_of(evidence)
    sources = {source.name for source in evidence.sources}
    variables = {"ROS_VERSION": str(ros)}
    keys = {d.name for m in packages.built for d in m.dependencies if d.role != "doc" and holds(d.condition, variables)}
    keys -= packages.names | sources | rosdep_keys() | {key for key in keys if library("cmake", key, None) is not None}
    if not keys:
        return {}
    lacking = {name: frozenset(keys - released(name)) for name, found in distros().items() if found.ros == ros and name != "rolling"}
    least = min(lacking.values(), key=len)
    return {name: missing - least if len(missing) > len(least) else frozenset() for name, missing in lacking.items()}


def _fitted(reason: Reason, unknown: dict[str, frozenset[str]]) -> Reason:
    """Weigh a distribution less that lacks what the packages declare: its mention is older than they are."""
    missing = sorted(unknown.get(reason.answer, ()))
    if not missing:
        return reason
    text = f"{reason.reason}; but {reason.answer} has no {', '.join(missing[:3])}"
    return replace(reason, reason=text, weight=max(1, reason.weight - UNFIT))


def _fitting(reasons: list[Reason], unknown: dict[str, frozenset[str]]) -> list[Reason]:
    """Offer the best distribution that has every declared key, where one that is named lacks some."""
    fitting = [name for name, missing in unknown.items() if not missing]
    if not fitting or not any(unknown.get(reason.answer) for reason in reasons):
        return []
    best = max(fitting, key=_rank)
    return [Reason(question="ros_distro", answer=best, reason="it has every key that the packages declare", weight=100)]


def _default(kind: Kind, unknown: dict[str, frozenset[str]]) -> str:
    """Return the default, or the longest supported one that has all keys where the default lacks some."""
    answer = DEFAULT[kind]
    if unknown.get(answer):
        fitting = [name for name, missing in unknown.items() if not missing]
        answer = max(fitting, key=_rank, default=answer)
    return answer


def _demoted(reasons: list[Reason]) -> tuple[Reason, ...]:
    return tuple(reason for reason in ranked(reasons, "") if not reason.decisive)


def _rank(name: str) -> int:
    return distros()[name].preference


def _reasons(evidence: Evidence, ros: int) -> list[Reason]:
    """Return the best reason for each distribution of that ROS version."""
    found: dict[str, Reason] = {}
    for reason in (*_recipes(evidence), *(r for m in evidence.mentions if (r := _mention(m, ros))), *_branches(evidence, ros)):
        known = distro(reason.answer)
        if known is None or known.ros != ros:
            continue
        if reason.answer not in found or reason.weight > found[reason.answer].weight:
            found[reason.answer] = reason
    return list(found.values())


def _recipes(evidence: Evidence) -> list[Reason]:
    """Read the author's images: the project's own before CI's, near the root before deep ones; a family of images is a list."""
    named = {name for recipe in evidence.recipes for name in _names(recipe.base or "")}
    return [
        Reason(
            question="ros_distro",
            answer=name,
            reason=f"the author's image is FROM {recipe.base}",
            file=recipe.file,
            line=recipe.base_line,
            weight=_recipe_weight(recipe) if len(named) <= FAMILY else 440,
        )
        for recipe in evidence.recipes
        for name in _names(recipe.base or "")
    ]


def _recipe_weight(recipe: Recipe) -> int:
    weight = {"project": 700, "ci": 520, "deploy": 450, "documentation": 300, "vendored": 50, "broken": 200}[recipe.purpose]
    return weight - 5 * recipe.file.count("/") + (20 if recipe.copies_repository else 0)


def _names(image: str) -> list[str]:
    """Return the distributions in an image's name: ``ros:noetic-perception``, ``…/ros-humble:main``."""
    return [word for word in re.split(r"[^a-z]+", image.lower()) if word in distros()]


def _mention(mention: Mention, ros: int) -> Reason | None:
    if mention.topic == "distro":
        return _distro_mention(mention)
    if mention.topic == "ubuntu":
        codename = ubuntus().get(mention.value, mention.value)
        if codename == mention.value and mention.source == "readme" and "ubuntu" not in mention.text.lower():
            return None  # "bionic" is also an arm, "focal" a length
        fitting = distros_of(codename, 1 if ros == 1 else 2)
        if fitting and mention.source in {"readme", "recipe", "ci"}:
            weight = {"recipe": 260, "ci": 240, "readme": 230}[mention.source] - 5 * mention.file.count("/")
            return Reason(question="ros_distro", answer=fitting[0], reason=f"Ubuntu {mention.value}: {mention.text[:120]}", file=mention.file, line=mention.line, weight=weight)
    if mention.topic == "base":
        names = _names(mention.value)
        if names:
            return Reason(question="ros_distro", answer=names[0], reason=f"CI runs in {mention.value}", file=mention.file, line=mention.line, weight=520)
    return None


def _distro_mention(mention: Mention) -> Reason | None:
    if mention.value not in distros():
        return None
    depth = 5 * mention.file.count("/")
    if mention.source == "branch":
        return _reason(mention, 900, f"the branch is {mention.text}")
    if places.vendored(mention.file):
        return _reason(mention, 20, "a copied file names it")
    if mention.source == "filename":
        return _reason(mention, 420 - depth, f"a file is named {mention.text}")
    if mention.source == "ci":
        return _reason(mention, 500 - depth, f"CI: {mention.text[:120]}")
    if mention.source == "recipe":
        return _reason(mention, 430 - depth, f"the author's image: {mention.text[:120]}")
    if mention.source == "script":
        return _reason(mention, 330 - depth, f"a script: {mention.text[:120]}")
    weight = 400 if _TESTED.search(mention.text) else 300
    if _AGAINST.search(mention.text):
        weight -= 180
    if _BADGE.search(mention.text):
        weight -= 20
    if places.documentation(mention.file):
        weight -= 60
    return _reason(mention, weight - 3 * depth, mention.text[:160])


def _reason(mention: Mention, weight: int, text: str) -> Reason:
    return Reason(question="ros_distro", answer=mention.value, reason=text, file=mention.file, line=mention.line, weight=weight)


def _branches(evidence: Evidence, ros: int) -> list[Reason]:
    """A branch ``ros2`` is where development goes on: it follows rolling, and releases live on branches of their own."""
    if ros != 2:
        return []
    return [
        Reason(question="ros_distro", answer="rolling", reason=f"the branch is {m.text}: where ROS 2 development goes on", file=m.file, line=m.line, weight=410)
        for m in evidence.mentions
        if m.source == "branch" and m.value == "ros2" and m.text == "ros2"
    ]
