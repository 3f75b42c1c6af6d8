"""Steps of the installation that nothing in the image repeats: each is told once, with its line."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Iterator, Mapping

from roslab.config.model import Config, Kind
from roslab.decide import guides
from roslab.decide.brought_archives import in_its_place, libraries
from roslab.decide.decision import Choice, Warning_
from roslab.decide.matlab_code import matlab_code
from roslab.decide.reasons import warn
from roslab.decide.ros.by_page import by_own_source
from roslab.decide.ros.lists_elsewhere import repository_of
from roslab.decide.ros.patched import told_by
from roslab.decide.ros.source_names import address, akin, itself_in, plain
from roslab.decide.ros.vcs_files import spelling
from roslab.decide.system.by_everybody import PAGES
from roslab.decide.system.in_place import in_place
from roslab.decide.system.packages import SystemPackages
from roslab.decide.system.stated_pythons import only_python
from roslab.evidence import places
from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import Evidence, Mention
from roslab.knowledge.distros import ubuntus
from roslab.knowledge.frameworks import imports
from roslab.knowledge.libraries import library
from roslab.knowledge.released import ever_released
from roslab.values.pattern import pattern

_FETCHES = pattern(r"\b(?:wget|curl|vcs|wstool|rosinstall|rosws)\s")
"""Programs that fetch a list of repositories, or import one by its address."""
_OF_ROS = pattern(r"\bros2?-apt-source\b")
"""The package with ROS's own source of apt, which the base image has: https://github.com/ros-infrastructure/ros-apt-source,
2026-11-26."""
_UNASKED = "for nothing that is built asks for it by name"
MOST = 8
"""Most steps that are told of one kind."""
NAMED = 4
"""Most of one script's steps that are named."""


def decide_steps(
    evidence: Evidence,
    config: Config,
    kind: Kind,
    *,
    taken: Iterable[str],
    addresses: Iterable[str],
    itself: set[str],
    added: Iterable[str] = (),
    fetched: Iterable[str] = (),
    system: SystemPackages,
) -> Choice[None]:
    """Return warnings about what pages and scripts install by other means than apt, pip, conda and known sources.

    ``taken`` are names and ``addresses`` are addresses of what the image has, ``itself`` are names of the
    repository, ``added`` are the package sources that the image gets, ``fetched`` the addresses of files that it gets,
    and ``system`` its packages.
    """
    if config.compatible or config.custom:
        return Choice(answer=None)
    names = {plain(name) for name in (*taken, *by_own_source((git.name for git in evidence.sources), evidence))}
    addresses = tuple(addresses)
    there = {address(each) for each in addresses}
    done = told_by(evidence, addresses)
    lists = _lists(evidence, there) if config.vcs is None else ()
    cloned = _cloned(evidence, kind, names, there, itself, system=system)
    data = _data(evidence, names, {*fetched})
    there_anyway = libraries(evidence, system.installed)
    steps = _fetched(evidence, names, {*added}, done, there_anyway, kind=kind)
    others = (*guides.told(evidence), *matlab_code(evidence, config))
    return Choice(answer=None, warnings=(*others, *steps, *lists, *cloned, *data))


def _fetched(
    evidence: Evidence,
    names: set[str],
    added: set[str],
    done: Collection[tuple[str, int]],
    there: Mapping[str, str],
    *,
    kind: Kind,
) -> Iterator[Warning_]:
    """Yield a warning for each step, of those of one script one for all."""
    told: dict[str, list[Mention]] = {}
    seen: set[str] = set()
    for mention in evidence.mentions:
        if (
            mention.topic == "step"
            and mention.source in {"readme", "script"}
            and (mention.file, mention.line) not in done
            and not places.vendored(mention.file)
            and not (kind in {"ros1", "ros2"} and _OF_ROS.search(mention.value))
            and not only_python(mention.value, kind)
            and not (_answered(mention.value, names) or added & {*mention.value.split()})
            and in_its_place(mention.value, there) != ""
        ):
            step = mention.value.partition(" | ")[0]
            if step not in seen:
                told.setdefault(mention.file if mention.source == "script" else step, []).append(mention)
            seen.add(step)
    for first, *others in list(told.values())[:MOST]:
        named = ", ".join(_named(each.value, there) for each in (first, *others[: NAMED - 1]))
        more = f" and {len(others) + 1 - NAMED} more, see the script" if others[NAMED - 1 :] else ""
        what = "they bring" if others else "it brings"
        message = f"not part of the image: {named}{more}; put what {what} under `apt`, `source` or `custom`"
        yield warn(f"{message} in roslab.yaml", first)


def _named(step: str, there: Mapping[str, str]) -> str:
    """Return a step as it is told, with the release of Ubuntu that the image has in its place."""
    instead = in_its_place(step, there)
    return f"`{step}` (Ubuntu's {instead} is there instead)" if instead else f"`{step}`"


def _data(evidence: Evidence, names: set[str], fetched: set[str]) -> Iterator[Warning_]:
    """Yield one warning for all the data that pages near the root fetch and the image does not.

    Where none of these starts anything, pages below that do so count instead.
    """
    told: dict[str, Mention] = {}
    starting = {each.file for each in evidence.mentions if each.topic == "command" and each.source == "readme"}
    below = not any(map(_near, starting))
    for mention in (each for each in evidence.mentions if each.topic == "data"):
        near = _near(mention.file) or (below and mention.file in starting and not places.aside(mention.file))
        near = near and mention.source == "readme"
        there = mention.value.partition(" ")[2] in fetched or _answered(mention.value, names)
        if near and not there:
            told.setdefault(mention.value, mention)
    if told:
        first, *others = told.values()
        more = f" and {len(others)} more" if others else ""
        message = f"data that a page fetches is not part of the image: `{first.value}`{more}"
        yield warn(f"{message}; fetch it into a volume, or by `custom` in roslab.yaml", first)


def _near(page: str) -> bool:
    return page.count("/") <= 1 and not places.aside(page)


def _lists(evidence: Evidence, addresses: Collection[str]) -> Iterator[Warning_]:
    """Yield a warning for each list of repositories that a page or a script fetches and that the tree does not have.

    Not for one that the build reads in its repository: ``addresses`` are those of what it clones.
    """
    there = {spelling(source.file.rpartition("/")[2]) for source in evidence.sources if source.kind == "vcs"}
    told: dict[str, Warning_] = {}
    for mention in evidence.mentions:
        said = mention.topic == "vcs_file" and mention.source in {"readme", "script"}
        said = said and spelling(mention.value) not in there and not places.vendored(mention.file)
        if not said or not _FETCHES.search(mention.text):
            continue
        for url in re.findall(rf"https?://[^\s\"'`<>()]+/{re.escape(mention.value)}\b", mention.text, re.IGNORECASE):
            if address(repository_of(url)) in addresses:
                continue
            message = f"not imported: {url}, a list of repositories that the tree does not have"
            advice = "add the file, and name it under `vcs` in roslab.yaml"
            told.setdefault(url, warn(f"{message}; {advice}", mention))
    yield from list(told.values())[:MOST]


def _answered(step: str, names: set[str]) -> bool:
    """Tell whether something of the image has a name that stands in the step."""
    words = plain(step.replace("/", "-"))
    return any(name in words for name in names if len(name) > 3)


def _cloned(
    evidence: Evidence, kind: Kind, names: set[str], there: set[str], itself: set[str], *, system: SystemPackages
) -> Iterator[Warning_]:
    """Yield a warning for each repository that a page clones and that neither the build nor a table asks for.

    Also for one that the author's Dockerfile clones, which is not built here. Not where a folder of packages is called
    like it.
    """
    told: dict[str, Warning_] = {}
    authored = [git for each in evidence.dockerfiles if each.purpose == "project" for git in each.clones]
    asks = (each for project in evidence.cmake for each in project.dependencies if each.required)
    alike = {_stem(each.name): each for each in asks if not _by_ubuntu(each.name, system.installed)}
    unknown = [each for each in evidence.code if each.namespace == "import" and _nobody_has(each, names)]
    copied = {plain(part) for manifest in evidence.manifests for part in manifest.file.split("/")[:-1]}
    there = there | {address(git.url) for git in evidence.sources if git.kind == "submodule" and not git.absent}
    for git in (*evidence.sources, *authored) if kind in {"ros1", "ros2", "cpp"} else ():
        aside = places.vendored(git.file) or places.documentation(git.file) or places.test(git.file)
        aside = aside or not (git.file.endswith(PAGES) or git in authored)
        if git.kind != "clone" or git.strength != "prose" or aside or itself_in(git, itself):
            continue
        if address(git.url) in there or plain(git.name) in names | copied or _by_ubuntu(git.name, system.installed):
            continue
        asked = alike.get(_stem(git.name))
        why = f"though {asked.file}:{asked.line} requires {asked.name}, which it may be" if asked else _UNASKED
        if not asked and (used := next((each for each in unknown if akin(each.name, git.name)), None)):
            why = f"though {used.file}:{used.line} imports {used.name}, which it may bring"
        if not asked and (by := in_place(git.name, system)):
            why = f"for apt brings what is needed of that name: {', '.join(by[:NAMED])}"
        message = f"not cloned: {git.url}, {why}; if it is needed, give it under `source` in roslab.yaml"
        told.setdefault(address(git.url), warn(message, git))
    yield from list(told.values())[:MOST]


def _nobody_has(used: Dependency, names: set[str]) -> bool:
    """Tell whether the code always imports a module that neither a table nor the image knows."""
    known = used.name in imports() or plain(used.name) in names or ever_released(used.name)
    return not known and used.strength == "used" and not places.aside(used.file)


def _stem(name: str) -> str:
    """Return a name without ``lib`` and its number: ``realsense2`` is of ``librealsense``."""
    return plain(name).removeprefix("lib").rstrip("0123456789")


def _by_ubuntu(name: str, installed: Collection[str]) -> bool:
    """Tell whether every Ubuntu packages what CMake calls so, or the image has the packages that one has for it."""
    found = library("cmake", name, None)
    if found is None or found.apt:
        return found is not None
    rows = (library("cmake", name, codename) for codename in ubuntus().values())
    return any(row and row.apt and {*row.apt} <= {*installed} for row in rows)
