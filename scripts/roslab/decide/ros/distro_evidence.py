"""What each mention of a distribution weighs: by where it stands and what its sentence says, never by how often."""

from __future__ import annotations

import re
from collections.abc import Iterator

from roslab.decide.decision import Reason
from roslab.decide.reasons import because
from roslab.evidence import places
from roslab.evidence.facts import AuthorDockerfile, Evidence, Mention
from roslab.knowledge.distros import distros, distros_of, ubuntus

FAMILY = 2
"""Images of more distributions than this are a family, one for each: none of them says which is meant."""
QUOTED = 160
"""Letters of a sentence that are quoted."""
_AGAINST = re.compile(
    r"not (?:been )?(?:tested|supported|work)|n't work|unsupported|no longer|deprecated|end[- ]of[- ]life|\beol\b|"
    r"coming soon|todo|"
    r"(?:see|use|switch to|check ?out|available (?:in|on|at)|go to)\s+(?:the\s+)?[\w\"'`/-]*\s*(?:branch|tag)|"
    r"\bbranch\b.*\bfor\b|for .*\bbranch\b|\bport(?:ed)?\b|previous(?:ly)?|legacy|\bold(?:er)?\b|archive",
    re.IGNORECASE,
)
"""The sentence speaks of another time or another branch."""
_FOR = re.compile(
    r"test(?:ed)?\b|prerequisite|require|depend|install|ubuntu|support|compatible|/opt/ros/|ros-[a-z]+-|catkin|colcon|"
    r">=|≥|develop(?:ed)? (?:on|with|under|in)|recommend|using ros|\bros[ :_-]",
    re.IGNORECASE,
)
"""The sentence tells what to have."""
_RECOMMENDED = re.compile(r"\brecommend", re.IGNORECASE)
_LIST = (".repos", ".rosinstall")
"""A list for one distribution holds what that one lacks: others may need no list."""
_SENTENCE = re.compile(r"(?<=[.;!?])\s+|\s*\|\s*")
_DOCKERFILES = {"project": 700, "ci": 520, "deploy": 450, "documentation": 300, "vendored": 50, "broken": 200}
_PLACES = {"filename": 420, "ci": 500, "dockerfile": 430, "script": 330}
_WHAT = {"filename": "a file is named", "ci": "CI:", "dockerfile": "the author's image:", "script": "a script:"}
_UBUNTU = {"dockerfile": 260, "ci": 240, "readme": 230}


def reasons_for(evidence: Evidence, ros: int) -> list[Reason]:
    """Return the best reason for each distribution of a ROS version that anything names."""
    found: dict[str, Reason] = {}
    for reason in (*_dockerfiles(evidence), *_mentions(evidence, ros), *_branches(evidence, ros)):
        known = distros().get(reason.answer)
        if known is None or known.ros != ros:
            continue
        if reason.answer not in found or reason.weight > found[reason.answer].weight:
            found[reason.answer] = reason
    return list(found.values())


def _dockerfiles(evidence: Evidence) -> Iterator[Reason]:
    """Read the author's images: the project's own before CI's, near the root before deep ones; a family is a list."""
    named = {name for authored in evidence.dockerfiles for name in _names(authored.base or "")}
    for authored in evidence.dockerfiles:
        for name in _names(authored.base or ""):
            weight = _dockerfile_weight(authored) if len(named) <= FAMILY else 440
            why = f"the author's image is FROM {authored.base}"
            yield Reason(
                question="ros_distro",
                answer=name,
                reason=why,
                file=authored.file,
                line=authored.base_line,
                weight=weight,
            )


def _dockerfile_weight(authored: AuthorDockerfile) -> int:
    return _DOCKERFILES[authored.purpose] - 5 * authored.file.count("/") + (20 if authored.copies_repository else 0)


def _names(image: str) -> list[str]:
    """Return the distributions in an image's name: ``ros:noetic-perception``, ``…/ros-humble:main``."""
    return [word for word in re.split(r"[^a-z]+", image.lower()) if word in distros()]


def _mentions(evidence: Evidence, ros: int) -> Iterator[Reason]:
    for mention in evidence.mentions:
        if mention.topic == "distro" and mention.value in distros():
            why, weight = _weighed(mention)
            yield because("ros_distro", mention.value, why, mention, weight=weight)
        elif mention.topic == "ubuntu" and mention.source in _UBUNTU:
            yield from _ubuntu(mention, ros)
        elif mention.topic == "base":
            for name in _names(mention.value):
                yield because("ros_distro", name, f"CI runs in {mention.value}", mention, weight=520)


def _ubuntu(mention: Mention, ros: int) -> Iterator[Reason]:
    """Take an Ubuntu for the distribution that lives on it."""
    codename = ubuntus().get(mention.value, mention.value)
    if codename == mention.value and mention.source == "readme" and "ubuntu" not in mention.text.lower():
        return  # "bionic" is also an arm, "focal" a length
    weight = _UBUNTU[mention.source] - 5 * mention.file.count("/")
    for name in distros_of(codename, 1 if ros == 1 else 2)[:1]:
        yield because("ros_distro", name, f"Ubuntu {mention.value}: {mention.text[:120]}", mention, weight=weight)


def _weighed(mention: Mention) -> tuple[str, int]:
    """Return why a distribution's name counts, and how much."""
    depth = 5 * mention.file.count("/") * (not mention.file.startswith("."))  # .github is a root's, as Jenkinsfile is
    if mention.source == "branch":
        return f"the branch is {mention.text}", 900
    if places.vendored(mention.file):
        return "a copied file names it", 20
    if mention.source == "filename" and mention.file.endswith(_LIST):
        return f"a list is named {mention.text}", 390 - depth
    if mention.source in _PLACES:
        return f"{_WHAT[mention.source]} {mention.text[:120]}", _PLACES[mention.source] - depth
    weight = max(_spoken(sentence) for sentence in _sentences(mention.text, mention.value))
    if places.documentation(mention.file):
        weight -= 60
    return f"“{_quoted(mention)}”", weight - 3 * depth


def _quoted(mention: Mention) -> str:
    """Return the sentence that names a distribution, marked where it is cut."""
    said = next(iter(_sentences(mention.text, mention.value))).strip().rstrip(";:,")
    return said if len(said) <= QUOTED else said[: QUOTED - 1].rstrip() + "…"


def _sentences(text: str, value: str) -> list[str]:
    """Return the sentences and table cells that hold a name, the whole text where cutting loses it."""
    return [part for part in _SENTENCE.split(text) if value in part.lower()] or [text]


def _spoken(sentence: str) -> int:
    against = 180 if _AGAINST.search(sentence) else 0
    return (420 if _RECOMMENDED.search(sentence) else 400 if _FOR.search(sentence) else 300) - against


def _branches(evidence: Evidence, ros: int) -> Iterator[Reason]:
    """Read a branch ``ros2`` as where development goes on: it follows rolling, releases have branches of their own."""
    for mention in evidence.mentions:
        if ros == 2 and mention.source == "branch" and mention.text == "ros2":
            why = "the branch is ros2: where ROS 2 development goes on"
            yield because("ros_distro", "rolling", why, mention, weight=410)
