"""Libraries that a page or a Dockerfile clones and pip installs from the clone's folder: pip installs them from git."""

from __future__ import annotations

import posixpath
from collections.abc import Iterable, Iterator

from roslab.config.model import Kind
from roslab.decide.ros.source_names import address, folders, itself_in, moves
from roslab.evidence import places
from roslab.evidence.dependency import GitSource
from roslab.evidence.facts import Evidence
from roslab.evidence.ros.vcs import https
from roslab.knowledge.frameworks import framework_sources
from roslab.knowledge.released import released_for
from roslab.values.dataclass import replace
from roslab.values.name import bare_name, canonicalize_name
from roslab.values.pattern import pattern
from roslab.values.requirement import Requirement
from roslab.values.requirement_line import stated

_RELEASE = pattern(r"v?(\d+\.\d+\.\d+)")
"""The tag of a release of a framework."""


def with_cloned(evidence: Evidence, kind: Kind, folder_name: str) -> Evidence:
    """Return the evidence with a line of pip for each; ``folder_name`` is the repository's, which is none of them.

    A framework that a page has compiled comes as the wheel of that release. Beside ROS, only what the code imports by
    the name of its clone is one: other clones are packages of the workspace, and ROS has modules of its own.
    """
    if kind == "cpp":
        return evidence
    names = {project.name for project in evidence.python if project.name} | {folder_name}
    found = tuple(_asked(evidence, {name.lower() for name in names}))
    if kind in {"ros1", "ros2"}:
        found = tuple(each for each in found if _imported(each, evidence, 1 if kind == "ros1" else 2))
    return replace(evidence, prose_pip=(*evidence.prose_pip, *found)) if found else evidence


def _imported(asked: Requirement, evidence: Evidence, ros: int) -> bool:
    """Tell whether the code cannot do without a module called like a clone, which no package of that ROS brings.

    What a package.xml asks for by that name is in the workspace, where pip installs it if it is plain Python.
    """
    last = (asked.url or "").partition("#")[0].rpartition("/")[2]
    name = bare_name(last.partition("@")[0].removesuffix(".git"))
    used = (each.name for each in evidence.code if each.namespace == "import" and each.strength == "used")
    keys = {bare_name(key.name) for manifest in evidence.manifests for key in manifest.dependencies}
    return name not in keys and any(bare_name(each) == name and not released_for(each, ros) for each in used)


def _asked(evidence: Evidence, itself: set[str]) -> Iterator[Requirement]:
    clones = [git for git in evidence.sources if git.kind == "clone" and git.strength == "prose"]
    named = {asked.key for asked in evidence.prose_pip if asked.name}
    yield from _of_text(evidence, clones, evidence.prose_pip, itself, named)
    own = [each for each in evidence.dockerfiles if each.purpose == "project" and not places.example(each.file)]
    used = {bare_name(each.name) for each in evidence.code if each.namespace == "import" and each.strength == "used"}
    for authored in own:
        found = tuple(_of_text(evidence, authored.clones, authored.requirements, itself, named))
        # Of several, each is for another use: what the code always imports is needed by all
        found = found if len(own) == 1 else tuple(each for each in found if bare_name(each.name) in used)
        yield from found
        named |= {asked.key for asked in found}


def _of_text(
    evidence: Evidence, sources: Iterable[GitSource], lines: Iterable[Requirement], itself: set[str], named: set[str]
) -> Iterator[Requirement]:
    """Yield what lines of pip install from the folders of clones; ``named``: what is asked for by name."""
    clones = [git for git in sources if not itself_in(git, itself)]
    for asked in lines:
        if asked.role != "project" or asked.file.count("/") > 1:
            continue
        folder = f"/{posixpath.normpath(asked.written.partition('[')[0])}/"
        before = [g for g in clones if g.file == asked.file and g.line <= (asked.line or 0)]
        at = {name: git for git in before for name in folders(git) if f"/{name}/" in folder}
        name = max(at, key=lambda name: folder.rindex(f"/{name}/"), default=None)
        if name is None and before and _of_clone(asked.written, evidence):  # the page has not gone into the clone
            inside = f"git+{https(before[-1].url)}#subdirectory={folder.strip('/')}"
            yield replace(stated(inside, "prose", asked.file, asked.line), beside=asked.beside, editable=asked.editable)
        if name is None or canonicalize_name(at[name].name) in named:
            continue
        git = at[name]
        if package := framework_sources().get("/".join(address(git.url).split("/")[-2:])):
            match = _RELEASE.fullmatch(git.ref or "")
            yield stated(f"{package}=={match[1]}" if match else package, "prose", asked.file, git.line)
            continue
        below = folder.partition(f"/{name}/")[2].strip("/")  # it may hold one of its name
        if below and any(project.folder == below for project in evidence.python):
            continue  # a page may go into the repository itself after it
        ref = git.ref if git.ref and not (moves(git.ref) and name.endswith(git.ref)) else ""
        url = f"git+{https(git.url)}" + (f"@{ref}" if ref else "") + (f"#subdirectory={below}" if below else "")
        found = stated(url, "prose", asked.file, asked.line or 1)
        yield replace(found, beside=asked.beside, editable=asked.editable)


def _of_clone(written: str, evidence: Evidence) -> bool:
    """Tell whether a folder that pip is given by its name is a clone's: the code imports it, the tree lacks it."""
    name = written.partition("[")[0].strip("./")
    there = any(name in {project.folder, canonicalize_name(project.name or "")} for project in evidence.python)
    return not there and any(
        each.namespace == "import" and each.name == name and each.strength == "used" for each in evidence.code
    )
