"""The weight of each mention of a distribution: by its place and its sentence, never by how often it is named."""

from __future__ import annotations

import re
from collections.abc import Iterator

from roslab.decide.decision import Reason
from roslab.decide.reasons import because
from roslab.decide.ros.addresses import only_general, only_read, released_for
from roslab.decide.ros.distro_dates import dated, later
from roslab.decide.ros.distro_weights import Weight
from roslab.decide.ros.equal_dockerfiles import of_equal_dockerfiles
from roslab.decide.ros.listed_branches import listed_branches
from roslab.decide.ros.lower_bounds import bounds, least
from roslab.decide.ros.of_ubuntus import of_ubuntu, weight_of_ubuntu
from roslab.evidence import places
from roslab.evidence.facts import AuthorDockerfile, Evidence, Mention
from roslab.knowledge.distros import distros
from roslab.values.dataclass import replace
from roslab.values.origin import Place
from roslab.values.pattern import pattern

FAMILY = 2  # Dockerfiles for more distributions are a family: none of them tells which distribution is meant
LEFT_BEHIND = 182  # days, from a distribution's end on, so long CI and Dockerfiles may still be for it
QUOTED = 160  # most characters of a sentence that are quoted
_AGAINST = pattern(
    r"not (?:been )?(?:tested|supported|recommended|work)|n't work|unsupported|no longer|deprecated|"
    r"end[- ]of[- ]life|\beol\b|coming soon|todo|"
    r"(?:see|use|switch (?:over )?to|check ?out|available (?:in|on|at)|go to)\s+"
    r"(?:the\s+)?[\w\"'`/-]*\s*(?:branch|tag)|"
    r"\bbranch\b.*\bfor\b|for .*\bbranch\b|\bport(?:ed)?\b|previous(?:ly)?|legacy|\bold(?:er)?\b|archive|"
    r"\b(?:get|got|see|have|meet|encounter)\w*\b[^.]{0,30}\b(?:errors?|problems?|issues?)\b",
    re.IGNORECASE,
)
"""The sentence speaks of another time or another branch."""
_THIS = pattern(r"\b(?:this is the|this|the current)\s+(?:[\w\"'`/-]+\s+)?branch\b", re.IGNORECASE)
"""The sentence speaks of the branch that it stands in."""
_FOR = pattern(
    r"test(?:ed)?\b|prerequisite|require|depend|install|ubuntu|support|compatible|/opt/ros/|ros-[a-z]+-|catkin|colcon|"
    r">=|≥|develop(?:ed)? (?:on|with|under|in)|recommend|using ros|\bros[ :_-]",
    re.IGNORECASE,
)
"""The sentence tells what to install or use."""
_TESTED = pattern(r"\b(?:test(?:ed)?|developed|validated|verified|requires?|required)\b", re.IGNORECASE)
"""The sentence tells what the authors used, or what everybody needs."""
_EXAMPLE = pattern(r"\b(?:for example|for instance|e\.g\.)(?!\w)", re.IGNORECASE)
"""The sentence only shows how a name is written."""
_RECOMMENDED = pattern(r"(?<!not )(?<!n't )\brecommend", re.IGNORECASE)
_LIST = (".repos", ".rosinstall")
_SENTENCE = pattern(r"(?<=[.;!?])\s+|\s*\|\s*")
_NO_LETTERS = pattern(r"[^a-z]+")
_OFFICIAL = pattern(r"(?:.*/)?ros[12]?(?:[:@]|$)")
_WHAT = {"filename": "a file is named", "ci": "CI:", "dockerfile": "the author's image:", "script": "a script:"}


def reasons_for(evidence: Evidence, ros: int) -> list[Reason]:
    """Return the best reason for each distribution of a ROS version that is named anywhere."""
    found: dict[str, Reason] = {}
    read = [*_dockerfiles(evidence), *_mentions(evidence, ros), *_branches(evidence, ros), *_channels(evidence)]
    read += listed_branches(evidence, ros)
    read = [reason for reason in read if (known := distros().get(reason.answer)) and known.ros == ros]
    for reason in read:
        if reason.answer not in found or reason.weight > found[reason.answer].weight:
            found[reason.answer] = reason
    said = {
        m: _weighed(m)[1] if m.topic == "distro" else weight_of_ubuntu(m, evidence)
        for m in evidence.mentions
        if bounds(m)
    }
    firm = [reason for reason in found.values() if reason.weight > Weight.TELLS_TO_HAVE - Weight.AGAINST]
    for reason in least(evidence, firm, ros, said):
        found[reason.answer] = max(reason, found.get(reason.answer, reason), key=lambda each: each.weight)
    tested = _tested(evidence, ros)
    return [_untested(reason, tested) for reason in of_equal_dockerfiles(found.values(), read, evidence)]


def _tested(evidence: Evidence, ros: int) -> set[str]:
    """Return the distributions of a ROS version that CI builds on."""
    said = (m for m in evidence.mentions if m.source == "ci" and not places.vendored(m.file))
    names = {name for m in said for name in ([m.value] if m.topic == "distro" else _names(m.value))}
    return {name for name in names if name in distros() and distros()[name].ros == ros}


def _untested(reason: Reason, tested: set[str]) -> Reason:
    """Lower the weight of a branch's name where CI tests only other distributions: the branch was named long ago.

    A branch for a distribution newer than all that CI names was just made, and CI is to follow; rolling has no age.
    """
    if reason.weight != Weight.BRANCH or not tested or reason.answer in tested:
        return reason
    dated = [distros()[name].released for name in tested if not distros()[name].never_ends]
    if dated and distros()[reason.answer].released > max(dated):
        return reason
    others = ", ".join(sorted(tested))
    return replace(reason, reason=f"{reason.reason}; but CI tests {others} alone", weight=Weight.SPEAKS_OF_IT)


def stale(reason: Reason, day: str | None) -> bool:
    """Tell whether a reason for a distribution is of an earlier time than the day that the image is to be of.

    A page tells what the authors used, and people use what has ended. CI and Dockerfiles stay behind unnoticed, and an
    Ubuntu alone tells of a distribution only while that is maintained.
    """
    end = distros()[reason.answer].eol
    if day is None or end is None or end >= day:
        return False
    if reason.reason.startswith("Ubuntu "):
        return True
    left_behind = later(end, LEFT_BEHIND)
    return reason.reason.startswith(("CI", "the author's image")) and left_behind < day


def _dockerfiles(evidence: Evidence) -> Iterator[Reason]:
    """Yield the distributions of the author's Dockerfiles: the project's before CI's, then by depth."""
    own = [authored for authored in evidence.dockerfiles if authored.purpose != "vendored"]
    named = {name for authored in own for name in _names(authored.base or "")}
    for authored in evidence.dockerfiles:
        for name in _names(authored.base or ""):
            family = authored in own and len(named) > FAMILY
            weight = Weight.FAMILY if family else _dockerfile_weight(authored)
            why = f"the author's image starts from {authored.base}"
            place = Place(file=authored.file, line=authored.base_line)
            yield because("ros_distro", name, why, place, weight=weight)


def _dockerfile_weight(authored: AuthorDockerfile) -> int:
    weight = Weight.DOCKERFILE[authored.purpose] + (Weight.COPIES if authored.copies_repository else 0)
    return weight - Weight.DEEPER * authored.file.count("/")


def _names(image: str) -> list[str]:
    """Return the distributions in an image's name: ``ros:noetic-perception``, ``…/ros-humble:main``."""
    return [word for word in _NO_LETTERS.split(image.lower()) if word in distros()]


def _mentions(evidence: Evidence, ros: int) -> Iterator[Reason]:
    copied = {authored.file for authored in evidence.dockerfiles if authored.purpose == "vendored"}
    for mention in evidence.mentions:
        if bounds(mention):
            continue
        if mention.topic == "distro" and mention.value in distros():
            why, weight = _weighed(mention)
            weight = min(weight, Weight.VENDORED) if mention.file in copied else weight
            yield because("ros_distro", mention.value, why, mention, weight=weight)
        elif mention.topic == "ubuntu" and mention.source in Weight.UBUNTU:
            yield from of_ubuntu(mention, evidence, ros)
        elif mention.topic == "base":
            for name in _names(mention.value):
                weight = Weight.CI_IMAGE if _OFFICIAL.match(mention.value) else Weight.PLACE["ci"] - Weight.DEEPER
                yield because("ros_distro", name, f"CI runs in {mention.value}", mention, weight=weight)


def _weighed(mention: Mention) -> tuple[str, int]:
    """Return the reason that a mention of a distribution gives, and its weight."""
    depth = mention.file.count("/") * (not mention.file.startswith("."))  # .github counts as the root
    deeper = Weight.DEEPER * depth
    if mention.source == "branch":
        tabled = not mention.file.startswith(".git/")
        what = f"a table has it for the branch {mention.text}" if tabled else f"the branch is {mention.text}"
        return what, Weight.TABLE if tabled else Weight.BRANCH
    if places.vendored(mention.file):
        return "a file copied from another project names it", Weight.VENDORED
    if mention.source == "filename" and mention.file.endswith(_LIST):
        return f"a list is named {mention.text}", Weight.LIST - deeper
    if mention.source in Weight.PLACE:
        return f"{_WHAT.get(mention.source, 'a path:')} {mention.text[:120]}", Weight.PLACE[mention.source] - deeper
    said = _sentences(mention.text, mention.value)
    weight = max(Weight.EXAMPLE if released_for(mention.file, s) else _spoken(s, mention.value) for s in said)
    weight -= Weight.DOCUMENTATION if places.documentation(mention.file) else 0
    return f"“{_quoted(mention)}”", weight - Weight.DEEPER_PAGE * depth


def _quoted(mention: Mention) -> str:
    """Return the sentence that names a distribution, cut with an ellipsis if it is long."""
    said = next(iter(_sentences(mention.text, mention.value))).strip().rstrip(";:,")
    return said if len(said) <= QUOTED else said[: QUOTED - 1].rstrip() + "…"


def _sentences(text: str, value: str) -> list[str]:
    """Return the sentences and table cells that contain a name, the whole text if none does."""
    return [part for part in _SENTENCE.split(text) if value in part.lower()] or [text]


def _spoken(sentence: str, value: str) -> int:
    if only_general(sentence, value):
        return Weight.EXAMPLE
    if only_read(sentence, value):
        return Weight.ADDRESS
    weight = Weight.TELLS_TO_HAVE if _FOR.search(sentence) else Weight.SPEAKS_OF_IT
    if _EXAMPLE.search(sentence):
        return Weight.EXAMPLE
    if _THIS.search(sentence):
        return Weight.RECOMMENDED
    weight = Weight.RECOMMENDED if _RECOMMENDED.search(sentence) else weight
    return weight - (Weight.AGAINST if _AGAINST.search(sentence) else 0)


def _channels(evidence: Evidence) -> Iterator[Reason]:
    """Yield the distribution whose packages a conda environment or pixi takes: ``robostack-jazzy``."""
    for environment in evidence.conda:
        for channel in environment.channels if not places.vendored(environment.file) else ():
            for name in _names(channel) if "robostack" in channel else ():
                weight = Weight.CHANNEL - Weight.DEEPER * environment.file.count("/")
                yield because("ros_distro", name, f"its packages come from {channel}", environment, weight=weight)
        asked = (p.name for p in environment.packages) if not places.vendored(environment.file) else ()
        for package in [package for package in asked if package.startswith("ros-")][:1]:
            for name in _names(package.split("-")[1]):
                weight = Weight.CHANNEL - Weight.DEEPER * environment.file.count("/")
                yield because("ros_distro", name, f"it asks for {package}", environment, weight=weight)


def _branches(evidence: Evidence, ros: int) -> Iterator[Reason]:
    """Yield rolling for a branch named ``ros2``: development happens there; releases have branches of their own.

    Such a name tells of no release, so the only one that the README says it was tested on counts more.
    """
    rolling = [found.name for found in distros().values() if found.ros == ros == 2 and found.never_ends]
    for mention in evidence.mentions:
        if mention.source == "branch" and mention.text == "ros2":
            why, weight = "the branch is ros2, where ROS 2 development goes on", Weight.ROS2_BRANCH
            if (only := _only_tested(evidence)) is not None:
                why, weight = f"{why}; but {only.file} says {only.value} alone", Weight.SPEAKS_OF_IT
            for name in rolling:
                yield because("ros_distro", name, why, mention, weight=weight)


def _only_tested(evidence: Evidence) -> Mention | None:
    """Return where the root's README tells of tests on the one ROS 2 release that it names.

    The release must have been out, and not ended, at the last commit: the sentence may be older than the code.
    """
    date = dated(evidence)
    said = [
        m
        for m in evidence.mentions
        if m.topic == "distro" and m.source == "readme" and "/" not in m.file and not bounds(m)
    ]
    of_ros2 = [m for m in said if m.value in distros() and distros()[m.value].ros == 2]
    if date is None or len({m.value for m in of_ros2}) != 1:
        return None
    release = distros()[of_ros2[0].value]
    if release.never_ends or not release.released <= date.value <= (release.eol or date.value):
        return None
    return next((m for m in of_ros2 if _tells_of_tests(m)), None)


def _tells_of_tests(mention: Mention) -> bool:
    sentences = _sentences(mention.text, mention.value)
    return any(_TESTED.search(each) and _spoken(each, mention.value) >= Weight.TELLS_TO_HAVE for each in sentences)
