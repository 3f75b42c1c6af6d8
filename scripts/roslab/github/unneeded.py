"""Which versions of an image are no longer needed: those that failed a proof, closed branches' tags, old layers."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from fnmatch import fnmatchcase

from roslab.config.model import TagParts
from roslab.engine.versions import Manifest, Version
from roslab.github.tags import OWN, RESERVED, cleaned, of_slim
from roslab.values.dataclass import dataclass, field
from roslab.values.pattern import pattern

CACHE = pattern(r"buildcache-(?P<branch>.+)-[0-9a-f]{8}-(?:all|linux)(?:-[a-z0-9-]+)?(?P<tree>\.tree)?")
"""A tag of cached layers or of a build tree, as ``cache`` forms it."""
ATTESTED = pattern(r"sha256-(?P<hex>[0-9a-f]{64})(?:\..+)?")
"""The tag under which a registry without referrers stores attestations and signatures of a digest.
https://github.com/opencontainers/distribution-spec/blob/main/spec.md#referrers-tag-schema"""
PROPOSED = pattern(r"pr-(?P<number>\d+)")


@dataclass(frozen=True, kw_only=True, slots=True)
class Names:
    """Names of the repository's branches and pull requests."""

    branches: frozenset[str] = frozenset()
    git_tags: frozenset[str] = frozenset()
    closed: frozenset[str] = frozenset()
    """Names of branches whose pull request is closed."""
    closed_pulls: frozenset[str] = frozenset()
    """Numbers of the closed pull requests."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Rules:
    """What the caller asked for."""

    days: int
    keep: tuple[str, ...] = ()
    """Tags, with ``*`` and ``?``, and digests that are never removed."""
    parts: TagParts = field(default_factory=TagParts)
    pull: str = ""
    """Number of the only pull request whose image is removed, ``""`` if all that is not needed is."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Removal:
    """One version to remove, and why."""

    version: Version
    reason: str


def chosen(
    versions: Sequence[Version], manifests: Mapping[str, Manifest], names: Names, rules: Rules
) -> tuple[Removal, ...]:
    """Return what to remove, each index before its parts: if removal stops midway, no index lacks a part.

    ``manifests`` has every existing version by digest. A digest with a tag of any other kind stays, with all that it
    refers to. So do versions younger than the given days (a build may be running), and the attestations and signatures
    of a digest that stays.
    """
    going: dict[str, Removal] = {}
    closed = frozenset[str]() if rules.pull else _closed(versions, names)
    for version in versions:
        if version.tags and (reason := _tagged(version, names, rules, closed)):
            going[version.digest] = Removal(version=version, reason=reason)
    loose = [version for version in versions if _loose(version, rules)]
    attested = {f"sha256:{match['hex']}" for match in _matches(ATTESTED, versions)}
    roots = {version.digest for version in versions} - set(going) - {version.digest for version in loose}
    held = _reached(roots | {v.digest for v in loose if v.digest in attested}, manifests)
    for version in loose:
        subject = manifests[version.digest].subject if version.digest in manifests else None
        if version.digest not in held and subject not in held:
            reason = (
                f"no tag and no index names it for {int(version.days or 0)} days: its proof failed, or it was replaced"
            )
            going[version.digest] = Removal(version=version, reason=reason)
    for version in versions:
        subjects = {f"sha256:{match['hex']}" for match in _matches(ATTESTED, [version])}
        if subjects and subjects <= set(going):
            going[version.digest] = Removal(version=version, reason="says something about a digest that goes")
    found = (*going.values(), *_parts(going, versions, manifests))
    return tuple(sorted(found, key=lambda each: not _reached({each.version.digest}, manifests) - {each.version.digest}))


def _parts(
    going: Mapping[str, Removal], versions: Sequence[Version], manifests: Mapping[str, Manifest]
) -> tuple[Removal, ...]:
    """Return the versions to which only removed indexes refer."""
    listed = {version.digest: version for version in versions}
    held = _reached(set(listed) - set(going) - _children(going, manifests, listed), manifests)
    found: dict[str, Removal] = {}
    for digest in going:
        for child in manifests[digest].children if digest in manifests else ():
            version = listed.get(child, Version(digest=child))
            if child not in going and child not in held and not version.tags:
                found.setdefault(child, Removal(version=version, reason=f"a part of {digest[:19]}, which goes"))
    return tuple(found.values())


def _children(going: Iterable[str], manifests: Mapping[str, Manifest], listed: Mapping[str, Version]) -> set[str]:
    """Return the untagged children of the versions that are removed."""
    named = {child for digest in going if digest in manifests for child in manifests[digest].children}
    return {child for child in named if child not in listed or not listed[child].tags}


def _reached(roots: Iterable[str], manifests: Mapping[str, Manifest]) -> set[str]:
    """Return digests with everything that they refer to, directly or indirectly."""
    found: set[str] = set()
    waiting = list(roots)
    while waiting:
        digest = waiting.pop()
        if digest not in found:
            found.add(digest)
            waiting += manifests[digest].children if digest in manifests else ()
    return found


def _loose(version: Version, rules: Rules) -> bool:
    old = version.days is not None and version.days >= rules.days
    return not rules.pull and not version.tags and old and version.digest not in rules.keep


def _tagged(version: Version, names: Names, rules: Rules, closed: frozenset[str]) -> str:
    """Return why a tagged version is removed, ``""`` if one of its tags is a reason to keep it."""
    if version.digest in rules.keep or any(fnmatchcase(tag, kept) for tag in version.tags for kept in rules.keep):
        return ""
    reasons = []
    for tag in version.tags:
        name = _named(tag, rules.parts, names)
        if name is not None and OWN.fullmatch(name):
            continue  # a commit's tag is removed with its branch's; without one it stays
        pulls = frozenset({rules.pull}) if rules.pull else names.closed_pulls
        reason = _cached(tag, version, rules, closed) or (_gone(name, pulls, closed) if name is not None else "")
        if not reason:
            return ""
        reasons.append(reason)
    return "; ".join(dict.fromkeys(reasons))


def _cached(tag: str, version: Version, rules: Rules, closed: frozenset[str]) -> str:
    match = CACHE.fullmatch(tag)
    if not match:
        return ""
    what = "a build tree" if match["tree"] else "layers"
    if match["branch"] in {name[:80] for name in closed}:
        return f"{what} of the branch {match['branch']}, which is closed"
    if not rules.pull and version.days is not None and version.days >= rules.days:
        return f"{what} that no build wrote for {int(version.days)} days"
    return ""


def _gone(name: str, closed_pulls: frozenset[str], closed: frozenset[str]) -> str:
    if (match := PROPOSED.fullmatch(name)) and match["number"] in closed_pulls:
        return f"the pull request {match['number']} is closed"
    if name in closed and not RESERVED.fullmatch(name):
        return f"the branch {name} is closed"
    return ""


def _closed(versions: Sequence[Version], names: Names) -> frozenset[str]:
    """Return the names of closed branches, in the form used in tags, that nothing else has.

    A tag of cached layers was made for a branch, so it also names a closed branch if that branch no longer exists.
    """
    living = {cleaned(name) for name in (*names.branches, *names.git_tags)}
    cached = {match["branch"] for match in _matches(CACHE, versions) if len(match["branch"]) < 80}
    return frozenset(({cleaned(name) for name in names.closed} | cached) - living - {name[:80] for name in living})


def _bare(tag: str, parts: TagParts) -> str | None:
    """Return a tag without the caller's prefix and suffix, ``None`` if it has others and belongs to another call."""
    if len(tag) < len(parts.prefix) + len(parts.suffix):
        return None
    if not (tag.startswith(parts.prefix) and tag.endswith(parts.suffix)):
        return None
    return tag.removeprefix(parts.prefix).removesuffix(parts.suffix)


def _named(tag: str, parts: TagParts, names: Names) -> str | None:
    """Return ``_bare``, of a slim image's tag that of the whole one's; a branch may end in the same word."""
    whole, slim = _bare(tag, parts), _bare(tag, of_slim(parts))
    known = {cleaned(each) for each in (*names.branches, *names.git_tags, *names.closed)}
    return whole if slim is None or whole in known else slim


def _matches(pattern: re.Pattern[str], versions: Iterable[Version]) -> list[re.Match[str]]:
    return [match for version in versions for tag in version.tags if (match := pattern.fullmatch(tag))]
