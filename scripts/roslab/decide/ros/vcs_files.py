"""Which lists of sister repositories are imported into the workspace."""

from __future__ import annotations

import re
from collections.abc import Iterable
from collections.abc import Set as AbstractSet

from roslab.config.model import Config
from roslab.decide.ros.list_names import ubuntus_in
from roslab.evidence.dependency import GitSource
from roslab.evidence.facts import Evidence, Mention
from roslab.knowledge.compiled import public_hosts
from roslab.knowledge.distros import distros
from roslab.knowledge.system_names import other_systems
from roslab.values.pattern import pattern

_BETWEEN = frozenset("-_.")
"""What may stand between the words of a name."""
_EXTRA = pattern(
    r"(?<![a-z])(?:nightly|tools?|simulat\w*|extras?|optionals?|ci|test(?:s|ing)?|debug|doc(?:s|umentation)?|develop\w*|"
    r"ssh|upstream|examples?|demos?)(?![a-z])",
    re.IGNORECASE,
)
_PARTS = pattern(r"[-_.]+")
_WORDS = pattern(r"[a-z]+")
_ROS = pattern(r"(?<![a-z0-9])ros[-_.]?([12])(?![0-9])(?![-_.]?bridge)", re.IGNORECASE)
"""Which ROS a path names. What is between both, ros1_bridge, is built for ROS 2."""


def vcs_files(
    evidence: Evidence,
    config: Config,
    ros_distro: str | None,
    *,
    lacking: bool,
    itself: AbstractSet[str] = frozenset(),
) -> tuple[str, ...]:
    """Return the vcs files to import: roslab.yaml's, else those of this distribution or its Ubuntu, else the plainest.

    A path may name ROS 1 or ROS 2 (``ros2.repos``): the lists of the other are of another workspace.
    Where a page names some of them, or CI for its upstream workspace, those are meant: the page at the root's first,
    then those of the root. ``lacking``: something is needed that no distribution has. Otherwise what CI alone builds is
    not needed; a list below the root is imported only where a page, a Dockerfile or CI names it, for it may be data of
    a program. ``itself``: the repository's names, in lower case, which say nothing of what a list is for. A list that
    CI builds as its downstream workspace names who needs the repository:
    https://github.com/ros-industrial/industrial_ci/blob/master/doc/index.rst
    """
    if config.vcs is not None:
        return config.vcs
    files = list(dict.fromkeys(source.file for source in evidence.sources if source.kind == "vcs"))
    left = _downstream(evidence)
    files = [file for file in files if _name(file).lower() not in left]
    private = private_twins(evidence)
    files = [file for file in files if file not in private]
    files = _of_ros(files, ros_distro)
    distinct = [(file, distros_in(_name(file)) | ubuntus_in(_name(file))) for file in files]
    known = distros().get(ros_distro or "")
    of_ubuntu = [file for file, words in distinct if known is not None and known.ubuntu in words]
    named = [file for file, words in distinct if ros_distro in words] or of_ubuntu
    plainest = _plainest(named or [file for file, words in distinct if not words], itself)
    said = [mention for mention in evidence.mentions if mention.topic == "vcs_file"]
    pages = {mention.value for mention in said if mention.source == "readme"}
    above = {
        mention.value for mention in said if mention.source == "ci" and "upstream_workspace" in mention.text.lower()
    }
    first = {mention.value for mention in said if mention.source == "readme" and "/" not in mention.file}
    built = {_name(file) for file in plainest if "/" not in file} & above
    for named_in in (first, built, pages, above):
        spelled = {spelling(name) for name in named_in}
        plainest = [file for file in plainest if spelling(_name(file)) in spelled] or plainest
    nearest = min((file.count("/") for file in plainest), default=0)
    found = tuple(file for file in plainest if file.count("/") == nearest)
    anywhere = {mention.value for mention in said}
    if not (lacking or config.compatible) and {*map(_name, found)} <= above - pages - _by_images(said):
        return ()  # CI also tries it with what is not released yet
    sure = not nearest or lacking or config.compatible
    return found if sure else tuple(file for file in found if _name(file).lower() in anywhere)


def _extra(name: str) -> bool:
    """Tell whether a list is for more than what everybody needs, or for another system."""
    return bool(_EXTRA.search(name)) or not other_systems().isdisjoint(_WORDS.findall(name))


def distros_in(text: str) -> set[str]:
    """Return the distributions that a file's name or an image's tag names."""
    return set(_WORDS.findall(text.lower())) & distros().keys()


def _of_ros(files: list[str], ros_distro: str | None) -> list[str]:
    """Return the lists without those of the other ROS, and without those of the same name as one for this ROS."""
    known = distros().get(ros_distro or "")
    of = {file: {*_ROS.findall(file)} for file in files}
    if known is None or not any(of.values()):
        return files
    own = str(known.ros)
    twins = {_unmarked(file) for file in files if own in of[file]}
    return [file for file in files if own in of[file] or not (of[file] or _unmarked(file) in twins)]


def _unmarked(file: str) -> tuple[str, ...]:
    return tuple(word for word in spelling(_ROS.sub("", file)) if word)


def spelling(name: str) -> tuple[str, ...]:
    """Return the words of a file's name, in one order: ``all_public.repos`` and ``all.repos.public`` are one list."""
    return tuple(sorted(_PARTS.split(name.lower())))


def private_twins(evidence: Evidence) -> set[str]:
    """Return the lists with addresses of ssh at hosts of their authors, of which another has most for everybody."""
    listed: dict[str, list[GitSource]] = {}
    for git in evidence.sources:
        if git.kind == "vcs":
            listed.setdefault(git.file, []).append(git)
    private = {file: {git.name for git in found} for file, found in listed.items() if all(map(_private, found))}
    public = [{git.name for git in found} for found in listed.values() if not any(map(_private, found))]
    return {file for file, names in private.items() if any(2 * len(names & other) > len(names) for other in public)}


def _private(git: GitSource) -> bool:
    return bool(git.by_ssh) and git.url.partition("://")[2].partition("/")[0] not in public_hosts()


def _by_images(said: Iterable[Mention]) -> set[str]:
    return {mention.value for mention in said if mention.source not in {"ci", "readme"}}


def _downstream(evidence: Evidence) -> set[str]:
    """Return the lists that CI names for a downstream workspace, and never for an upstream one."""
    lines = [(m.value, m.text.lower()) for m in evidence.mentions if m.topic == "vcs_file" and m.source == "ci"]
    below = {value for value, text in lines if "downstream_workspace" in text}
    return below - {value for value, text in lines if "upstream_workspace" in text}


def _plainest(files: list[str], itself: AbstractSet[str]) -> list[str]:
    """Return the lists of unreleased packages if there are any, else all lists, without those for tests or tools."""
    files = [file for file in files if "not-released" in file] or files
    plain = [file for file in files if not _extra(_without(_name(file).lower(), itself))]
    return plain or [file for file in files if "ssh" not in file] or files


def _without(name: str, itself: AbstractSet[str]) -> str:
    """Return a file's name without the repository's own in front, whatever stands between the words of either."""
    letters = [place for place, letter in enumerate(name) if letter not in _BETWEEN]
    bare = "".join(name[place] for place in letters)
    spelled = ("".join(letter for letter in own if letter not in _BETWEEN) for own in itself)
    longest = max((len(own) for own in spelled if own and bare.startswith(own)), default=0)
    return name[letters[longest - 1] + 1 :] if longest else name


def _name(path: str) -> str:
    return path.rpartition("/")[2]
