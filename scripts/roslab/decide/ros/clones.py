"""The repositories that manifests, pages and lists name for the workspace, those for its distribution first."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from collections.abc import Set as AbstractSet

from roslab.decide.ros.credited import credited
from roslab.decide.ros.source_names import SHORTEST, address, fixed, itself_in, moves, plain
from roslab.decide.ros.vcs_files import distros_in
from roslab.decide.ros.workspace import of_one_ros, packages_of
from roslab.decide.system.by_everybody import PAGES
from roslab.evidence import places
from roslab.evidence.dependency import Dependency, GitSource
from roslab.evidence.facts import Evidence
from roslab.knowledge.libraries import library
from roslab.knowledge.recipes import recipe_at


def clones(evidence: Evidence, ros_distro: str | None) -> list[GitSource]:
    """Return what manifests and pages clone: from a package.xml first, then with a ref, then from the nearest page.

    Clones in a Dockerfile for another distribution are left out, and those in whose place another one is cloned.
    """
    dockerfiles = {authored.file: distros_in(authored.base or "") for authored in evidence.dockerfiles}
    found = _all(evidence)
    gone = {*_replaced(found)}
    found = [git for git in found if not dockerfiles.get(git.file) or ros_distro in dockerfiles[git.file]]
    found = [git for git in found if git not in gone]
    return sorted(found, key=lambda g: (g.kind != "git_url", g.ref is None, g.file.count("/"), g.file, g.line))


def refs_of(found: Iterable[GitSource], ros_distro: str | None) -> dict[str, str]:
    """Return for each address the branch, tag or commit that pages and scripts clone of it, or link to.

    That for this distribution before others, and none that is for other distributions alone.
    """
    refs: dict[str, str] = {}
    for git in sorted(found, key=lambda git: ros_distro not in distros_in(git.ref or "")):
        ref, others = fixed(git.ref), distros_in(git.ref or "")
        if ref and (not others or ros_distro in others):
            refs.setdefault(address(git.url), ref)
    return refs


def only_below(git: GitSource) -> bool:
    """Tell whether only a page below the root, which may be about another project, has it cloned."""
    page = "/" in git.file and git.file.endswith(PAGES) and not places.documentation(git.file)
    return git.kind == "clone" and git.strength == "prose" and page


def taken_apart(evidence: Evidence) -> list[GitSource]:
    """Return the clones of which only a part stays, for another repository is cloned into their folder."""
    return [git for git in _replaced(_all(evidence)) if git.parts]


def _replaced(found: list[GitSource]) -> Iterator[GitSource]:
    """Yield the clones that are removed before the same text clones another repository into their folder."""
    last = {(git.file, git.folder): git for git in sorted(found, key=lambda git: git.line)}
    for git in found:
        other = last[git.file, git.folder]
        if git.removed and address(other.url) != address(git.url):
            yield git


def _all(evidence: Evidence) -> list[GitSource]:
    found = [git for git in evidence.sources if git.kind in {"clone", "git_url"} and not places.vendored(git.file)]
    found += [clone for authored in evidence.dockerfiles if authored.purpose == "project" for clone in authored.clones]
    return [git for git in found if not git.installed and "/archive/" not in git.url]


def beside(evidence: Evidence, ros_distro: str | None) -> Iterator[GitSource]:
    """Yield what the page at the root, or a script that it runs, clones into the workspace; first those of this ROS.

    What industrial_ci builds before the repository comes last.
    """
    run = {word.rpartition("/")[2] for m in evidence.mentions if "/" not in m.file for word in m.value.split()[:2]}
    found = [git for git in evidence.sources if git.beside and not places.vendored(git.file)]
    found = [git for git in found if "/" not in git.file or git.file.rpartition("/")[2] in run]
    upstream = [git for git in evidence.sources if git.kind == "upstream"]
    for git in sorted((*found, *upstream), key=lambda git: ros_distro not in distros_in(git.ref or "")):
        if not (others := distros_in(git.ref or "")) or ros_distro in others:
            yield git


def with_itself(
    evidence: Evidence,
    ros_distro: str | None,
    itself: set[str],
    own: AbstractSet[str],
    known: AbstractSet[str],
) -> Iterator[tuple[GitSource, str]]:
    """Yield what the page at the root has everybody clone into the workspace where it clones the repository itself.

    Each with the reason for it; ``own``: the repository's packages, ``known``: they and what the distribution released.
    Of that nothing is cloned but a fork of the same owner, or a branch of its own.
    """
    for git in beside(evidence, ros_distro):
        if git.kind != "clone" or git.aside or itself_in(git, itself) or plain(git.name) in own:
            continue
        here = [
            each for each in evidence.sources if each.beside and (each.file, each.heading) == (git.file, git.heading)
        ]
        near = [each for each in here if itself_in(each, itself) and not each.aside]
        changed = git.ref is not None and not distros_in(git.ref) and not moves(git.ref)
        changed = changed or any(_owner(git) == _owner(each) for each in near)
        if near and (changed or git.name not in known):
            yield git, f"{git.file} has everybody clone it into the workspace, beside the repository itself"


def for_unknown(
    evidence: Evidence, ros_distro: str | None, itself: set[str], known: AbstractSet[str], unknown: Dependency
) -> Iterator[tuple[GitSource, str]]:
    """Yield what is cloned into the workspace, each with the reason: one of them may hold an unknown package."""
    for git in beside(evidence, ros_distro):
        if not itself_in(git, itself) and plain(git.name) not in known and git.name not in known:
            why = f"{git.file} clones it into the workspace, and no distribution released {unknown.name}"
            yield git, f"{why} ({unknown.file}:{unknown.line})"


def _owner(git: GitSource) -> str:
    return address(git.url).rpartition("/")[0]


def unreleased(needed: Iterable[Dependency], known: AbstractSet[str]) -> Dependency | None:
    """Return a package of ROS that the repository needs or starts and that nothing brings so far, if there is any."""
    for asked in needed:
        of_ros = asked.namespace in {"rosdep", "ros"} and asked.role not in {"test", "doc"}
        if of_ros and asked.strength != "prose" and asked.name not in known and not library("cmake", asked.name, None):
            return asked
    return None


def linked(
    evidence: Evidence, needed: Iterable[Dependency], known: AbstractSet[str], ros: int
) -> Iterator[tuple[GitSource, Dependency]]:
    """Yield the repositories that pages only link to, each with the package that it has to bring.

    That is one which a manifest or CMake asks for and which is not ``known``; it has the name of the repository, or one
    that begins with it where nothing known has that name. The nearest page comes first; that of a package which is not
    built, for it is of the other ROS, may link to a fork for that one.
    """
    needed = tuple(needed)
    packages = of_one_ros(packages_of(evidence), evidence, "ros1" if ros == 1 else "ros2")
    aside = tuple(f"{folder}/" for folder in packages.doubles)
    found = [git for git in evidence.sources if git.kind == "link" and not places.vendored(git.file)]
    found = [git for git in found if not git.file.startswith(aside) and not _library(git, evidence)]
    found.sort(key=lambda git: (git.file.count("/"), git.file, git.line))
    asking = [asked for asked in needed if asked.name not in known and _built_with(asked)]
    lacking = {plain(asked.name): asked for asked in asking if not credited(asked.name, evidence)}
    for exact in (True, False):
        for git in found:
            name = plain(git.name)
            begins = not exact and len(name) >= SHORTEST and name not in known
            meant = [each for each in lacking if each == name or (begins and each.startswith(f"{name}_"))]
            if meant:
                yield git, lacking[meant[0]]
            for each in meant:
                del lacking[each]


def _library(git: GitSource, evidence: Evidence) -> bool:
    """Tell whether a repository is a plain library: a recipe compiles it, or a page does so and installs it."""
    url = address(git.url)
    return recipe_at(url) is not None or any(each.installed and address(each.url) == url for each in evidence.sources)


def _declared(asked: Dependency) -> bool:
    return asked.strength == "declared" and asked.role not in {"test", "doc"}


def _built_with(asked: Dependency) -> bool:
    """Tell whether a package of ROS is one that a manifest declares or CMake requires."""
    return asked.namespace in {"rosdep", "ros"} and _declared(asked)
