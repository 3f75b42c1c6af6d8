"""A workspace's repository, to which a page sends its reader: its lists name what its author compiles beside this."""

from __future__ import annotations

from roslab.config.model import Source
from roslab.decide.decision import Choice
from roslab.decide.reasons import because
from roslab.decide.ros.built_sources import Sources
from roslab.decide.ros.sought import folder_for
from roslab.decide.ros.source_names import address, akin, day_of_clone, fixed, itself_in
from roslab.decide.ros.weights import Weight
from roslab.evidence.dependency import Dependency, GitSource
from roslab.evidence.facts import Evidence
from roslab.evidence.ros.vcs import https, nobodys
from roslab.values.dataclass import replace
from roslab.values.origin import Place
from roslab.values.pattern import pattern

_NAME = pattern(r"([A-Za-z0-9][\w.-]{1,60}?)[_-](?:(?:catkin|colcon|ros2?|dev)[_-])?(?:ws|workspace)")
"""https://wiki.ros.org/catkin/workspaces and https://docs.ros.org/en/rolling/Tutorials/Beginner-Client-Libraries call
such a folder ``catkin_ws`` and ``ros2_ws``, 2026-11-28."""


def with_workspace(
    choice: Choice[Sources], missing: Dependency | None, evidence: Evidence, before: str, itself: set[str]
) -> Choice[Sources]:
    """Return the sources with the first such repository of a page at the root, where a package is ``missing``.

    It is of the repository's owner, or shares a word of its name with the repository. ``before``: the day of what is
    cloned without a tag or commit; ``itself``: the repository's own names.
    """
    sources = choice.answer
    taken = {address(each.repo) for each in sources.everything if each.repo} | {address(evidence.origin or "")}
    found = (git for git in evidence.sources if _sends(git, evidence, itself) and address(git.url) not in taken)
    git = next(found, None) if missing else None
    if git is None:
        return choice
    url, ref = https(git.url).rstrip("/"), fixed(git.ref)
    source = Source(
        name=folder_for(url, sources.everything),
        repo=url,
        ref=ref,
        build="none",
        before=day_of_clone(ref, before),
        unasked=True,
        lists=True,
        place=Place(file=git.file, line=git.line),
    )
    why = f"{git.file} sends the reader to this workspace, whose lists name what is compiled in it"
    reason = because("source", source.name, why, git, weight=Weight.LISTED)
    return replace(
        choice, answer=replace(sources, sources=(*sources.sources, source)), reasons=(*choice.reasons, reason)
    )


def _sends(git: GitSource, evidence: Evidence, itself: set[str]) -> bool:
    match = _NAME.fullmatch(git.name) if git.kind in {"link", "clone"} and "/" not in git.file else None
    if match is None or git.private or git.aside or nobodys(git.url) or itself_in(git, itself):
        return False
    owner = address(evidence.origin or "").rpartition("/")[0]
    return address(git.url).rpartition("/")[0] == owner or any(akin(match[1], name) for name in itself)
