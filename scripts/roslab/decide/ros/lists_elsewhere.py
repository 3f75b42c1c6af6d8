"""Lists of repositories that lie in another repository: the build reads them there for what is missing."""

from __future__ import annotations

import shlex
from collections.abc import Iterable, Iterator

from roslab.config.model import Source
from roslab.decide.decision import Choice
from roslab.decide.reasons import because
from roslab.decide.ros.built_sources import Sources
from roslab.decide.ros.sought import folder_for
from roslab.decide.ros.source_names import address, day_of_clone, fixed, itself_in, plain
from roslab.decide.ros.weights import Weight
from roslab.evidence.dependency import Dependency, GitSource
from roslab.evidence.facts import Evidence, Mention
from roslab.evidence.ros.vcs import https, nobodys
from roslab.values.dataclass import replace
from roslab.values.origin import Place
from roslab.values.pattern import pattern

_RAW = pattern(
    r"https://(?:raw\.github(?:usercontent)?\.com/(?P<raw>[\w.-]+/[\w.-]+)|"
    r"(?P<owned>(?:github\.com|gitlab\.com|bitbucket\.org)/[\w.-]+/[\w.-]+)/(?:-/)?(?:raw|blob))"
    r"/(?:refs/heads/)?(?P<ref>[\w.-]+)/(?P<path>[\w./-]+)"
)
"""A file of a repository by its address: owner and name, branch, path."""
_OF_ROS = frozenset({"https://github.com/ros2/ros2", "https://github.com/ros/rosdistro"})
"""Their lists name what a distribution released."""
_PATH = pattern(r"[\w.+/-]+")
_NAME = pattern(r"[A-Za-z0-9_][\w.-]*")
"""A name that a folder may have: none of ``..``, ``.git`` and ``-x``, as odd addresses end."""


def with_lists(
    choice: Choice[Sources], missing: Dependency | None, evidence: Evidence, before: str, itself: set[str]
) -> Choice[Sources]:
    """Return the sources with the repositories from which lists are handed on, where a package is ``missing``.

    ``before``: the day of what is cloned without a tag or commit; ``itself``: the repository's own names, as the one
    that it is a fork of has them, too.
    """
    there = choice.answer.everything
    found = list(_lists(evidence, there, before, itself)) if missing else []
    why = "takes a list of repositories from it, and nothing known brings a package"
    reasons = (because("source", s.name, f"{said.file} {why}", said, weight=Weight.LISTED) for s, said in found)
    names = frozenset(source.name for source, _ in found)
    sources = (*choice.answer.sources, *(source for source, _ in found))
    named = [each for manifest in evidence.manifests for each in manifest.dependencies]
    named += [each for project in evidence.cmake for each in project.dependencies]
    asked = {plain(each.name) for each in named if each.namespace in {"rosdep", "ros"}}
    sought = frozenset(asked) if found else frozenset[str]()
    answer = replace(choice.answer, sources=sources, of_lists=names, sought_there=sought)
    return replace(choice, answer=answer, reasons=(*choice.reasons, *reasons))


def _lists(
    evidence: Evidence, there: Iterable[Source], before: str, itself: set[str]
) -> Iterator[tuple[Source, Mention]]:
    """Yield the repositories with such lists, each once, with what hands the first of its lists on.

    Each at the branch that is cloned, or that the first address names. The build keeps no other lists of them: of what
    these name it clones what holds a missing package.
    """
    others = list(there)
    known = {address(each.repo) for each in others if each.repo}
    if evidence.origin:
        known.add(address(evidence.origin))
    by_address: dict[str, list[tuple[GitSource, str, Mention]]] = {}
    for said in (mention for mention in evidence.mentions if mention.topic == "handed"):
        git, path = _by_address(said) or _in_clone(said, evidence) or (None, "")
        if git and _PATH.fullmatch(path) and address(git.url) not in known and not itself_in(git, itself):
            by_address.setdefault(address(git.url), []).append((git, path, said))
    for same in by_address.values():
        git, _, said = same[0]
        url = https(git.url).rstrip("/")
        name, ref = folder_for(url, others), fixed(git.ref)
        if nobodys(url) or not _NAME.fullmatch(name) or any(each.name == name for each in others):
            continue
        paths = dict.fromkeys(path for _, path, _ in same)
        kept = " ".join(f"! -path {shlex.quote(f'./{path}')}" for path in paths)
        source = Source(
            name=name,
            repo=url,
            ref=ref,
            build="none",
            before=day_of_clone(ref, before),
            unasked=True,
            prepare=f"find . -type f \\( -name '*.rosinstall' -o -name '*.repos' \\) {kept} -delete",
            place=Place(file=said.file, line=said.line),
        )
        others.append(source)
        yield source, said


def repository_of(url: str) -> str:
    """Return the address of the repository in which a file lies by its own address, ``""`` where that tells none."""
    match = _RAW.fullmatch(url)
    return f"https://{match['owned'] or 'github.com/' + match['raw']}.git" if match else ""


def _by_address(said: Mention) -> tuple[GitSource, str] | None:
    match, url = _RAW.fullmatch(said.value), repository_of(said.value)
    if match is None or address(url) in _OF_ROS:
        return None
    name = url.rpartition("/")[2].removesuffix(".git")
    git = GitSource(name=name, url=url, ref=match["ref"], strength="prose", file=said.file, line=said.line, kind="link")
    return git, match["path"]


def _in_clone(said: Mention, evidence: Evidence) -> tuple[GitSource, str] | None:
    """Return the clone of the same script or Dockerfile in whose folder the list is, and the path there."""
    clones: list[GitSource] = [git for git in evidence.sources if git.kind == "clone" and git.file == said.file]
    clones += [git for each in evidence.dockerfiles if each.file == said.file for git in each.clones]
    for git in clones:
        _, there, path = f"/{said.value}".rpartition(f"/{git.folder}/")
        if there:
            return git, path
    return None
