"""What is built from its source: vcs files, README clones that a manifest asks for, libraries of the table of recipes."""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass, replace

from roslab.config.model import BuildTool, Config, Kind, Place, Source
from roslab.decide.decision import Reason, Warning_
from roslab.evidence import places
from roslab.evidence.facts import Dependency, Evidence, GitSource
from roslab.evidence.vcs import https
from roslab.knowledge.distros import distros

_EXTRA = re.compile(r"nightly|tools?|simulat|extra|optional|\bci\b|test|debug|docs?|develop|ssh|upstream|example|demo", re.IGNORECASE)
_WORDS = re.compile(r"[a-z]+")


@dataclass(frozen=True, kw_only=True, slots=True)
class SourceChoice:
    """What is built from source, in this order, and the vcs files it came from."""

    sources: tuple[Source, ...] = ()
    vcs: tuple[str, ...] = ()
    names: frozenset[str] = frozenset()
    """Names that these sources answer for: no key and no package is needed for them."""
    reasons: tuple[Reason, ...] = ()
    warnings: tuple[Warning_, ...] = ()


def decide_sources(
    evidence: Evidence,
    config: Config,
    kind: Kind,
    *,
    ros_distro: str | None,
    build_tool: BuildTool,
    needed: Iterable[Dependency],
    own: frozenset[str],
    folder_name: str,
) -> SourceChoice:
    """Return the sources; ``needed`` are the names that a manifest or CMake asks for, ``own`` the repository's packages."""
    ros = kind in {"ros1", "ros2"}
    reasons: list[Reason] = []
    warnings: list[Warning_] = []
    chosen: dict[str, Source] = {}
    for index, source in enumerate(config.source):
        chosen[source.name] = source
        place = source.place
        reasons.append(Reason(question="source", answer=source.name, reason=f"source.{index} says so", file=place.file if place else config.file, line=place.line if place else None, weight=1000))
    itself = {folder_name.lower(), *(name.lower() for name in own if len(own) == 1)}
    files = _vcs_files(evidence, config, ros_distro) if ros else ()
    for git in evidence.sources:
        if git.kind == "vcs" and git.file in files and not _is(git, itself):
            _add(chosen, git, build_tool, reasons, f"{git.file} lists it")
    wanted = _wanted(needed)
    for git in _clones(evidence, ros=ros):
        if _is(git, itself) or _plain(git.name) in own:
            continue
        dependency = wanted.get(_plain(git.name))
        if dependency is None:
            continue
        _add(chosen, git, build_tool, reasons, f"{dependency.file}:{dependency.line} needs {dependency.name}, and it is cloned here")
        if dependency.strength == "declared" and dependency.namespace == "rosdep":
            message = f"{dependency.name} is also cloned from {git.url} ({git.file}:{git.line}): a package of that name that rosdep knows may be another one; the clone is used"
            warnings.append(Warning_(message=message, file=dependency.file, line=dependency.line))
    for git in evidence.sources:
        if git.kind == "submodule":
            reasons.append(Reason(question="source", answer=git.name, reason=f"a submodule, {git.url}: check it out with the repository", file=git.file, line=git.line, weight=10, decisive=False))
    names = frozenset(_plain(name) for name in chosen) | frozenset(chosen)
    return SourceChoice(sources=tuple(chosen.values()), vcs=files, names=names, reasons=tuple(reasons), warnings=tuple(warnings))


def _add(chosen: dict[str, Source], git: GitSource, build_tool: BuildTool, reasons: list[Reason], why: str) -> None:
    name = re.sub(r"[^\w.-]+", "_", git.name.strip("/").rpartition("/")[2]) or "source"
    if name in chosen or any(source.repo and _url(source.repo) == _url(git.url) for source in chosen.values()):
        return
    build = build_tool if build_tool in {"catkin_make", "catkin_tools", "colcon"} else "none"
    chosen[name] = Source(name=name, repo=https(git.url), ref=_ref(git.ref), build=build, place=Place(file=git.file, line=git.line))  # type: ignore[arg-type]
    reasons.append(Reason(question="source", answer=name, reason=why, file=git.file, line=git.line, weight=500))


def _ref(ref: str | None) -> str | None:
    return ref if ref and re.fullmatch(r"[\w./+-]+", ref) and not ref.startswith("-") else None


def _url(url: str) -> str:
    return https(url).removesuffix(".git").rstrip("/").lower()


def _plain(name: str) -> str:
    return re.sub(r"[-_.]+", "_", name.rpartition("/")[2]).lower()


def _is(git: GitSource, names: set[str]) -> bool:
    """Tell whether a list names the repository itself."""
    return _plain(git.name) in {_plain(name) for name in names} or _url(git.url).rpartition("/")[2] in names


def _wanted(needed: Iterable[Dependency]) -> dict[str, Dependency]:
    found: dict[str, Dependency] = {}
    for dependency in needed:
        found.setdefault(_plain(dependency.name), dependency)
        if dependency.name.startswith("lib"):
            found.setdefault(_plain(dependency.name[3:]), dependency)
    return found


def _clones(evidence: Evidence, *, ros: bool) -> list[GitSource]:
    """Clone lines, the README's before CI's, those with a ref first; only a ROS workspace takes sister packages."""
    kinds = {"clone", "git_url"} if ros else set()
    found = [git for git in evidence.sources if git.kind in kinds and not places.vendored(git.file)]
    found += [clone for recipe in evidence.recipes if recipe.purpose == "project" and ros for clone in recipe.clones]
    return sorted(found, key=lambda git: (git.kind != "git_url", git.ref is None, git.file.count("/"), git.file, git.line))


def _vcs_files(evidence: Evidence, config: Config, ros_distro: str | None) -> tuple[str, ...]:
    """Return the vcs files to import: roslab.yaml's, else those for this distribution, else the plainest of each folder."""
    if config.vcs is not None:
        return config.vcs
    files = list(dict.fromkeys(source.file for source in evidence.sources if source.kind == "vcs"))
    distinct = [(file, [word for word in _WORDS.findall(file.rpartition("/")[2].lower()) if word in distros()]) for file in files]
    named = [file for file, words in distinct if ros_distro in words]
    plain = [file for file, words in distinct if not words]
    candidates = named or plain
    if any("not-released" in file for file in candidates):
        candidates = [file for file in candidates if "not-released" in file]
    https_only = [file for file in candidates if not _EXTRA.search(file.rpartition("/")[2])]
    candidates = https_only or [file for file in candidates if "ssh" not in file] or candidates
    if not candidates:
        return ()
    depth = min(file.count("/") for file in candidates)
    nearest = [file for file in candidates if file.count("/") == depth]
    return tuple(nearest)


def with_recipes(choice: SourceChoice, recipes: Iterable[tuple[Source, Dependency]]) -> SourceChoice:
    """Put libraries of the table of recipes before the sister packages that link them."""
    added: list[Source] = []
    reasons = list(choice.reasons)
    for source, dependency in recipes:
        if source.name in choice.names or any(source.name == other.name for other in added):
            continue
        added.append(source)
        reasons.append(Reason(question="source", answer=source.name, reason=f"{dependency.name} is needed and no package of this Ubuntu holds it", file=dependency.file, line=dependency.line, weight=400))
    return replace(choice, sources=(*added, *choice.sources), names=choice.names | {source.name for source in added}, reasons=tuple(reasons))
