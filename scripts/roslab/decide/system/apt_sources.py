"""Package sources that a page or a Dockerfile adds: followed where it installs a package after it."""

from __future__ import annotations

from collections.abc import Collection, Iterator

from roslab.config.model import Config
from roslab.decide.decision import Choice, Reason, Warning_
from roslab.decide.reasons import because, warn
from roslab.decide.system.stated_pythons import may_bring
from roslab.evidence import places
from roslab.evidence.apt_source import AptSource, host_of
from roslab.evidence.facts import Evidence
from roslab.knowledge.apt_sources import added_sources, keys_of_sources, known_sources
from roslab.knowledge.distros import ubuntus
from roslab.values.pattern import pattern

WEIGHT = 40
"""Sources do not compete, so it only orders the report."""
NEAR = 60
"""Most lines between a source and what is installed from it."""
_OF_ROS = "ros-"
PPA = "ppa:"
_COMPUTED = pattern(r"[$`{}()…]")


def decide_apt_sources(
    evidence: Evidence, config: Config, installed: Collection[str], ubuntu: str | None, base_image: str = ""
) -> Choice[tuple[str, ...]]:
    """Return the sources to add: ``ppa:OWNER/NAME``, or lines of apt in which ``signed-by`` is the address of the key.

    ``installed``: the packages of the image. One whose key cannot be trusted, or that is for another release of Ubuntu,
    is told.
    """
    if config.compatible or ubuntu is None:
        return Choice(answer=())
    added: dict[str, Reason] = {}
    told: list[Warning_] = []
    for source in (*evidence.apt_sources, *_ppas(evidence)):
        asked = _asked(source, evidence, installed)
        url = source.url.replace("{codename}", ubuntu)
        host = host_of(url) or ""
        if not asked or places.vendored(source.file) or host in known_sources():
            continue
        suite = source.suite.format(codename=ubuntu) if "{" in source.suite else source.suite
        release = suite.partition("-")[0]
        key = keys_of_sources().get(host) or source.key  # what a page fetches beside it may be another source's
        why_not = None if key else source.refused
        if release in ubuntus().values() and release != ubuntu:
            why_not = f"it is for {release}, the image is {ubuntu}"
        if _COMPUTED.search(url):
            why_not = "the page computes its address"
        if why_not:
            message = f"not added: the package source {url}, with which {_who(source)} installs {asked}: {why_not}"
            told.append(warn(message, source))
            continue
        ppa = url.startswith(PPA)  # its key comes from Launchpad
        line = url if ppa else " ".join((f"deb [signed-by={key}]", url, suite, *source.components))
        why = f"{_who(source)} installs {asked} from it"
        added.setdefault(line, because("dependencies", url, why, source, weight=WEIGHT))
    for each in (row for row in added_sources() if not row.base.fullmatch(base_image)):
        name = next((name for name in sorted(installed) if each.packages.fullmatch(name)), None)
        there = any(host_of(each.url) == host_of(line.split()[2]) for line in added if " " in line)
        if name and not there and ubuntu in each.ubuntu:
            suite = f"{ubuntu} {each.components}" if each.components else "/"
            line = f"deb [signed-by={each.key}] {each.url} {suite}"
            added[line] = because(
                "dependencies", each.url, f"{name} is there, and in no archive of Ubuntu", None, weight=WEIGHT
            )
    return Choice(answer=tuple(added), reasons=tuple(added.values()), warnings=tuple(told))


def _ppas(evidence: Evidence) -> Iterator[AptSource]:
    """Yield the PPAs that pages and scripts add."""
    for mention in evidence.mentions:
        said = mention.value.split() if mention.topic == "step" and mention.source in {"readme", "script"} else []
        for name in [word for word in said if word.startswith(PPA)]:
            yield AptSource(
                url=name, suite="", components=(), key=None, refused=None, file=mention.file, line=mention.line
            )


def _who(source: AptSource) -> str:
    return "the page" if source.file.lower().endswith((".md", ".rst", ".txt")) else source.file


def _asked(source: AptSource, evidence: Evidence, installed: Collection[str]) -> str | None:
    """Return the first package of the image that is installed after the source was added."""
    said = [*evidence.prose, *(each for authored in evidence.dockerfiles for each in authored.dependencies)]
    lines = {
        each.line: each.name
        for each in reversed(said)
        if each.namespace == "apt"
        and each.file == source.file
        and 0 < each.line - source.line <= NEAR
        and each.name in installed
        and may_bring(source.url, each.name)
        and not each.name.startswith(_OF_ROS)
    }
    return lines[min(lines)] if lines else None
