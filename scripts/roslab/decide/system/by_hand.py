"""Libraries that a page compiles by hand or links to, or a list has, and CMake asks for: in stages of their own."""

from __future__ import annotations

import shlex
from collections.abc import Collection, Iterable, Iterator, Mapping
from typing import Literal

from roslab.config.model import Config, Kind, Source
from roslab.decide.linked_projects import linked_projects
from roslab.decide.ros.distro_dates import dated
from roslab.decide.ros.list_names import for_ubuntu, rank
from roslab.decide.ros.source_names import address, day_of_clone, drifts, fixed, moves, plain
from roslab.decide.ros.workspace import Packages
from roslab.decide.system.bare_links import bare_links
from roslab.decide.system.bare_names import bare, offered_name, with_joined, without_major
from roslab.decide.system.by_everybody import BARE, built_by_everybody, headers_of, includes, includes_inside, named_in
from roslab.decide.system.compiled_libraries import looked_for
from roslab.decide.system.lies_beside import with_beside
from roslab.decide.system.linked_releases import linked_releases, of_release
from roslab.decide.system.names import Target, resolve
from roslab.decide.system.needs import code_needs
from roslab.decide.system.newer_than_apt import newer_than_apt
from roslab.decide.system.switches import given, waits
from roslab.decide.system.tried_headers import included
from roslab.evidence import places
from roslab.evidence.dependency import Dependency, GitSource
from roslab.evidence.facts import Evidence
from roslab.evidence.ros.vcs import https
from roslab.knowledge.recipes import leaves_out, recipe_at
from roslab.values.dataclass import replace
from roslab.values.origin import Place
from roslab.values.pattern import pattern
from roslab.values.words import written

_SDK = pattern(r"_(?:sdk|cpp|core|library)$|(?<=[a-z]{3})lib$")

SCRIPTS = (".sh", ".bash", ".zsh")
SHORTEST = 3
"""Fewest letters of a name by which a link is taken for a library."""


def as_written(
    sources: Iterable[tuple[Source, Dependency]], evidence: Evidence
) -> tuple[tuple[Source, Dependency], ...]:
    """Give the libraries of the table the ref of CMake, a list or a link, or a page's and the options that it gives."""
    listed = (git for git in evidence.sources if git.kind == "vcs")
    fetched = (git for project in evidence.cmake for git in project.sources)
    by_url = {address(git.url): git for group in (fetched, listed, built_by_hand(evidence)) for git in group}
    forks = {plain(git.name): git for git in built_by_hand(evidence) if _of_its_own(git)}
    links, day = linked_releases(evidence), date.value if (date := dated(evidence)) else ""

    def written_by_author(source: Source) -> GitSource | None:
        fork = forks.get(plain(source.name)) if source.repo else None
        return by_url.get(address(source.repo or "")) or fork or of_release(source, links)

    named = ((written_by_author(each), each, asked) for each, asked in sources)
    return tuple(
        (with_beside(_like(source, git, day), git, evidence) if git else source, asked) for git, source, asked in named
    )


def _of_its_own(git: GitSource) -> bool:
    """Tell whether a clone is at a ref that others' repositories need not have: what is a fork adds to it there."""
    return git.kind == "clone" and not (git.aside or git.by_make or moves(git.ref)) and bool(fixed(git.ref))


def built_by_hand(evidence: Evidence) -> Iterator[GitSource]:
    """Yield what Dockerfiles for CI or an editor build, then scripts, the project's own, and pages, whose refs win."""
    for git in (git for group in reversed(_written(evidence)) for git in group):
        if git.installed and not places.vendored(git.file):
            yield git


def _written(evidence: Evidence) -> tuple[tuple[GitSource, ...], ...]:
    """Return what is cloned or named, by where: of a library in several, the first builds it as an image needs it."""
    pages = tuple(git for git in evidence.sources if not git.file.endswith(SCRIPTS))
    scripts = tuple(git for git in evidence.sources if git.file.endswith(SCRIPTS))
    return pages, tuple(_authored(evidence, "project")), scripts, tuple(_authored(evidence, "ci"))


def _authored(evidence: Evidence, purpose: Literal["project", "ci"]) -> Iterator[GitSource]:
    return (git for each in evidence.dockerfiles if each.purpose == purpose for git in each.clones)


def _like(source: Source, git: GitSource, day: str) -> Source:
    options = _options(shlex.split(source.cmake_options), git)
    place = Place(file=git.file, line=git.line)
    if not (ref := fixed(git.ref)):
        return replace(source, cmake_options=options, place=place) if git.options else source
    ref = source.ref if moves(ref) and source.ref else ref
    before = day if drifts(ref) else source.before
    fork = source.repo and git.kind == "clone" and address(git.url) != address(source.repo)
    repo = https(git.url) if fork else source.repo
    return replace(source, repo=repo, ref=ref, before=before, cmake_options=options, place=place)


def _options(ours: Iterable[str], git: GitSource) -> str:
    """Return those of our options that the author of a clone does not set himself, and his, as a shell reads them."""
    theirs = [written(word) for word in git.options.split()]
    said = {_named(word) for word in theirs}
    return shlex.join((*(word for word in ours if _named(word) not in said), *theirs))


def _named(option: str) -> str:
    """Return what an option of CMake sets, without its type and value."""
    return option.partition("=")[0].partition(":")[0]


def by_hand(
    evidence: Evidence, config: Config, kind: Kind, *, target: Target, packages: Packages, taken: frozenset[str]
) -> tuple[tuple[Source, Dependency], ...]:
    """Return the libraries that no table knows, that CMake asks for by name, and that a page or a list names.

    ``taken``: names that come from elsewhere. What a page installs above one of them is built before it, and what is
    installed at a ref where submodules that may ask for it are not checked out; and what a page has everybody install.
    Each is built as it was at the time of the repository's last commit.
    """
    if config.compatible or kind == "python":
        return ()
    day, offered = date.value if (date := dated(evidence)) else "", _offered(evidence, kind, target.ubuntu)
    taken |= {plain(git.name) for project in evidence.cmake for git in project.sources}  # CMake fetches it itself
    if kind in {"cpp", "cuda"}:
        taken |= {plain(name) for project, _ in linked_projects(evidence) for name in project.made}  # the tree's own
    free = {name: git for name, git in offered.items() if not {name, plain(git.name)} & taken}
    found: dict[GitSource, Dependency] = {}
    for name, asked in _asked(evidence, packages, target, free):
        if plain(asked.name) not in taken:
            found.setdefault(free[name], asked)
    unasked = {git for git, asked in found.items() if _only_named(git, asked)}
    last = {git.file: git.line for git in sorted(found, key=lambda git: git.line) if git.installed}
    unread = any(git.absent for git in evidence.sources)
    there, headers = {*taken, *named_in(evidence.cmake)}, headers_of(evidence)
    own = {each.file for each in evidence.dockerfiles if each.purpose == "project"}
    lacks = _lacks(evidence, packages, kind, target, free)
    for git in [each for each in dict.fromkeys(free.values()) if each not in found]:
        above = git.line < last.get(git.file, 0)  # what is below it may need it
        may_be = git.installed and (above or (unread and git.kind == "clone" and bool(fixed(git.ref))))
        by_page = may_be and _unknown(_by_page(git), target, pinned=False)
        header = includes(git, headers) or (includes_inside(git, evidence) if git.file in own else None)
        why = (_by_page(git), not above) if by_page else _wanted(git, kind, target, there, header, lacks)
        why = (header, True) if header and not why and git.file in own and _by_hand(git) else why
        if why:
            found[git] = why[0]
            unasked |= {git} if why[1] else set()
    files = [git.file for git in found]
    in_order = sorted(found, key=lambda git: (files.index(git.file), git.line))
    built = (
        (git, replace(_source(git, day), unasked=git in unasked, depends=_needs(git, offered.values(), target)))
        for git in in_order
    )
    return tuple((with_beside(source, git, evidence), found[git]) for git, source in built)


def _by_page(git: GitSource) -> Dependency:
    return Dependency(namespace="cmake", name=git.name, strength="declared", file=git.file, line=git.line)


def _wanted(  # noqa: PLR0917 - what is known of it
    git: GitSource,
    kind: Kind,
    target: Target,
    there: Collection[str],
    header: Dependency | None,
    lacks: Dependency | None,
) -> tuple[Dependency, bool] | None:
    """Return what speaks for a library that nothing asks for by its name, and whether the image may go without it.

    ``header``: an include of one called like it, ``lacks``: a link that nothing else brings.
    """
    if header and _by_script(git):
        return header, True  # the include may be for another machine, or in what is not compiled
    included, lacking = header is not None, lacks is not None
    if built_by_everybody(git, kind, target, there, included=included, lacking=lacking):
        return header or lacks or _by_page(git), header is None
    return None


def _lacks(
    evidence: Evidence, packages: Packages, kind: Kind, target: Target, offered: Mapping[str, GitSource]
) -> Dependency | None:
    """Return the first library that the build links and that nothing known, nor called like what is offered, brings."""
    linked = (asked for _, asked in bare_links(evidence, packages, kind))
    found = (asked for asked in linked if bare(asked.name) not in offered and not target.knows(asked.name))
    return next((replace(asked, role=BARE) for asked in found), None)


def _offered(evidence: Evidence, kind: Kind, ubuntu: str | None) -> dict[str, GitSource]:
    """Return what pages, lists and Dockerfiles name, by its bare name, the best of each name."""
    offered: dict[str, GitSource] = {}
    written = (git for group in _written(evidence) for git in group)
    for git in sorted(written, key=lambda g: (not g.installed, g.kind == "link", rank(g, ubuntu), g.ref is None)):
        listed = git.kind == "vcs" and kind not in {"ros1", "ros2"}  # of ROS, the workspace has what is listed
        built = git.installed and (git.configured or git.by_make)
        if (built or listed or git.kind == "link") and not places.vendored(git.file):
            offered.setdefault(bare(git.name), git)
            offered.setdefault(bare(git.folder), git)
    for git in [git for git in offered.values() if git.installed]:  # what it installs may be called without that
        offered.setdefault(_SDK.sub("", bare(git.name)), git)
        offered.setdefault(bare(recipe_at(address(git.url)) or git.name), git)
    libraries = [git for git in offered.values() if git.kind == "link" and bare(git.name) != plain(git.name)]
    for git in libraries:  # NAME_base without lib is as often the driver of a robot's base
        offered.setdefault(bare(git.name).removesuffix("_base"), git)
    return with_joined(offered)


def _by_script(git: GitSource) -> bool:
    """Tell whether a script compiles and installs a clone."""
    return _by_hand(git) and git.file.endswith(SCRIPTS)


def _by_hand(git: GitSource) -> bool:
    built = git.installed and (git.configured or git.by_make)
    return built and git.kind == "clone" and not git.aside


def _needs(git: GitSource, others: Iterable[GitSource], target: Target) -> tuple[str, ...]:
    """Return the packages that a library looks for, as far as they are known: its page seldom names them."""
    return tuple(dict.fromkeys((*_above(git, others, target), *looked_for(git))))


def _above(git: GitSource, others: Iterable[GitSource], target: Target) -> tuple[str, ...]:
    """Return the packages that bring what a page or a Dockerfile compiles above a library: it may need that."""
    before = (each for each in others if each.installed and each.file == git.file and each.line < git.line)
    asked = (
        Dependency(namespace="cmake", name=each.name, strength="declared", file=each.file, line=each.line)
        for each in sorted(dict.fromkeys(before), key=lambda each: each.line)
    )
    return tuple(dict.fromkeys(apt for each in asked for apt in resolve(each, target).apt))


def _asked(
    evidence: Evidence, packages: Packages, target: Target, offered: Mapping[str, GitSource]
) -> Iterator[tuple[str, Dependency]]:
    """Yield the names of what is offered that the build asks for, and that has to be built for it."""
    added = {bare(project.name) for project in evidence.cmake if project.name and not project.top_level}
    made = {(project.top, bare(target)) for project in evidence.cmake if project.added for target in project.made}
    tops = {project.file: project.top for project in evidence.cmake}
    options = given(evidence)
    of_extensions = (dependency for dependency in evidence.code if dependency.namespace == "link")
    for asked in (*code_needs(evidence, packages), *of_extensions):
        name = offered_name(bare(asked.name), offered)
        if name not in offered or len(name) < SHORTEST or waits(asked, options):
            continue
        if asked.namespace == "link" and (name in added or (tops.get(asked.file), name) in made):
            continue  # what a folder of the tree that CMake adds makes is linked from there
        git = offered[name]
        pinned = git.installed and bool(fixed(git.ref))
        by_file = git.installed and (asked.namespace, asked.strength) == ("link", "declared")
        newer = (pinned and newer_than_apt(asked, target, git)) or for_ubuntu(git, asked, target.ubuntu)
        tried = git.installed and included(asked, evidence)
        needed = replace(asked, strength="declared") if tried else asked  # CMake goes on, the compiler does not
        if by_file or newer or _unknown(needed, target, pinned=pinned):
            yield name, asked  # what is named by its file below /usr/local is there only where it was built


def of_majors(evidence: Evidence, sources: Iterable[Source]) -> Iterator[str]:
    """Yield the names with a major release by which CMake asks for libraries that are built by hand."""
    built = {bare(source.name) for source in sources if source.build == "cmake"}
    for project in evidence.cmake:
        asked = (each.name for each in project.dependencies if each.namespace == "cmake")
        yield from (name for name, without in without_major(asked).items() if without in built)


def _source(git: GitSource, day: str) -> Source:
    """Return a library as a page or a list has it; ``day``: that of the repository's last commit.

    What the table switches off of one that it knows is off, unless the page says otherwise.
    """
    ref = fixed(git.ref)
    ours = () if git.by_make else leaves_out(address(git.url))
    return Source(
        name=git.name,
        repo=https(git.url),
        ref=ref,
        before=day_of_clone(ref, day),
        build="cmake",
        cmake_options=_options(ours, git),
        cmake_folder=(git.below if git.by_make else f"../{git.below}") if git.below else None,
        unread=not git.by_make,
        by_make=git.by_make,
        place=Place(file=git.file, line=git.line),
    )


def _only_named(git: GitSource, asked: Dependency) -> bool:
    """Tell whether a link in prose and a name that is linked are all: no page builds it, no ``find_package`` asks."""
    return git.kind == "link" and not git.told and asked.namespace == "link"


def _unknown(asked: Dependency, target: Target, *, pinned: bool) -> bool:
    """Tell whether no table knows a name that the build requires; what CMake only tries is no reason to build it.

    ``pinned``: a page builds it at a ref, which then wins over a package of ROS, whose version is another.
    """
    asks = asked.namespace in {"cmake", "pkg-config"}
    required = asked.strength == "declared" if asks else asked.namespace == "link"
    meant = resolve(asked, target)
    of_ros = pinned and all(apt.startswith("ros-") for apt in meant.apt)
    return required and not ((meant.apt and not of_ros) or meant.recipe)
