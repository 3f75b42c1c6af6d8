"""Lists of repositories that lie in another repository: the build reads them there for what is missing."""

from __future__ import annotations

import shlex
from collections.abc import Iterator

from roslab.config.model import Source
from roslab.decide.decision import Choice
from roslab.decide.reasons import because
from roslab.decide.ros.built_sources import Sources
from roslab.decide.ros.source_names import address, drifts, fixed
from roslab.decide.ros.weights import Weight
from roslab.evidence.dependency import Dependency, GitSource
from roslab.evidence.facts import Evidence, Mention
from roslab.evidence.ros.vcs import https
from roslab.values.dataclass import replace
from roslab.values.origin import Place
from roslab.values.pattern import pattern

_RAW = pattern(
    r"https://(?:raw\.githubusercontent\.com/([\w.-]+/[\w.-]+)|github\.com/([\w.-]+/[\w.-]+)/(?:raw|blob))/([\w.-]+)/([\w./-]+)"
)
"""A file of a repository by its address: owner and name, branch, path."""
_PATH = pattern(r"[\w.+/-]+")


def with_lists(choice: Choice[Sources], missing: Dependency | None, evidence: Evidence, before: str) -> Choice[Sources]:
    """Return the sources with the repositories from which lists are handed on, where a package is ``missing``.

    ``before``: the day of what is cloned without a tag or commit.
    """
    there = {source.name for source in choice.answer.everything}
    found = {source.name: (source, said) for source, said in _lists(evidence, before)} if missing else {}
    added = [each for name, each in found.items() if name not in there]
    why = "takes a list of repositories from it, and nothing known brings a package"
    reasons = (because("source", s.name, f"{said.file} {why}", said, weight=Weight.LISTED) for s, said in added)
    sources = (*choice.answer.sources, *(source for source, _ in added))
    return replace(choice, answer=replace(choice.answer, sources=sources), reasons=(*choice.reasons, *reasons))


def _lists(evidence: Evidence, before: str) -> Iterator[tuple[Source, Mention]]:
    """Yield the repositories with such a list, at the branch that is cloned, each with what hands the list on.

    The build keeps no other list of them: of what this one names it clones what holds a missing package.
    """
    here = address(evidence.origin) if evidence.origin else ""
    for said in (mention for mention in evidence.mentions if mention.topic == "handed"):
        url, ref, path = _by_address(said.value) or _in_clone(said, evidence) or ("", None, "")
        if not url or address(url) == here or not _PATH.fullmatch(path):
            continue
        kept = f"! -path {shlex.quote(f'./{path}')}"
        yield (
            Source(
                name=url.removesuffix(".git").rpartition("/")[2],
                repo=https(url),
                ref=fixed(ref),
                build="none",
                before="" if ref and not drifts(ref) else before,
                unasked=True,
                prepare=f"find . -type f \\( -name '*.rosinstall' -o -name '*.repos' \\) {kept} -delete",
                place=Place(file=said.file, line=said.line),
            ),
            said,
        )


def _by_address(value: str) -> tuple[str, str | None, str] | None:
    match = _RAW.fullmatch(value)
    return (f"https://github.com/{match[1] or match[2]}.git", match[3], match[4]) if match else None


def _in_clone(said: Mention, evidence: Evidence) -> tuple[str, str | None, str] | None:
    """Return the clone of the same script or Dockerfile in whose folder the list is, and the path there."""
    clones: list[GitSource] = [git for git in evidence.sources if git.kind == "clone" and git.file == said.file]
    clones += [git for each in evidence.dockerfiles if each.file == said.file for git in each.clones]
    for git in clones:
        _, there, path = f"/{said.value}".rpartition(f"/{git.folder}/")
        if there:
            return git.url, git.ref, path
    return None
