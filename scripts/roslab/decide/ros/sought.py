"""Packages that nothing brings, and the repositories in which the build looks for them.

Planning asks no host. What the author's other code may hold is therefore tried while the image is built: a repository
that is not there, or does not hold the package, stops nothing.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping
from collections.abc import Set as AbstractSet

from roslab.config.model import BuildTool, Config, Source, workspace_tool
from roslab.decide.decision import Choice
from roslab.decide.reasons import because
from roslab.decide.ros.built_sources import Sources
from roslab.decide.ros.clones import taken_apart
from roslab.decide.ros.credited import credited
from roslab.decide.ros.misnamed import BUILD_TYPES, library_called, of_pip
from roslab.decide.ros.slips import meant
from roslab.decide.ros.sought_addresses import addresses_of, by_authors
from roslab.decide.ros.sought_links import listed_by_pages, of_ubuntu
from roslab.decide.ros.source_names import address, akin, day_of_clone, fixed, plain, stands_already
from roslab.decide.ros.vcs_files import distros_in
from roslab.decide.ros.weights import Weight
from roslab.decide.ros.workspace import Packages
from roslab.decide.system.by_everybody import PAGES
from roslab.evidence.dependency import Dependency, GitSource
from roslab.evidence.facts import Evidence
from roslab.evidence.ros.vcs import https
from roslab.knowledge.holders import holders
from roslab.knowledge.recipes import recipe_at
from roslab.values.dataclass import replace
from roslab.values.origin import Place
from roslab.values.pattern import pattern

PACKAGE = pattern(r"(?!lib(?!\w+_(?:ros2?|msgs|srvs|interfaces)(?!\w))|python)[a-z][a-z0-9]*(?:_[a-z0-9]+)*")
"""A name that a package of ROS may have (REP 144), and no package of a system is likely to: ``libvelo_ros``."""
_LIBRARY = pattern(r"lib[a-z0-9]+(?:_[a-z0-9]+)*")
_OF_SYSTEM = pattern(r"[^a-z0-9-]|^(?:lib|python|ros-)|-(?:dev|pip)$")
"""In a name with a dash that is none of a package of ROS."""
MOST = 12
"""Most repositories that a build tries."""
MOST_UNLIKE = 3
"""Most clones of a page that are looked through for a package that none of them is called like."""


def with_sought(
    choice: Choice[Sources],
    evidence: Evidence,
    config: Config,
    *,
    build_tool: BuildTool,
    needed: Iterable[Dependency],
    known: AbstractSet[str],
    cloned: Iterable[GitSource],
    refs: Mapping[str, str],
    before: str,
) -> Choice[Sources]:
    """Return the sources with the repositories in which the build looks for what nothing brings.

    ``needed``: names that the build uses or the code may name, ``known``: what the repository, rosdep and the
    distribution have, ``cloned``: what pages clone, ``refs``: the branch of a clone by its address; ``before``: the day
    of what has none. None for the old formats, whose images never had them; where a source whose packages are not known
    may hold them, only what pages clone or, where none is called alike, list as needed, and the owner's repository of
    exactly a package's name where that source is most likely another package alone. Nor what a submodule that is not
    checked out most likely has, or what is one slip away from a known name that the repository has elsewhere.
    """
    sources = choice.answer
    build = workspace_tool(build_tool)
    if build is None or config.compatible:
        return choice
    own = {manifest.name for manifest in evidence.manifests if manifest.name}
    folders = {
        each.name.partition("/")[0] for each in evidence.code if each.namespace == "include" and "/" in each.name
    }
    lacking = _lacking(needed, known | sources.names, own, folders)
    named = known & {each.name for m in evidence.manifests for each in m.dependencies}
    named |= known & {each.name for project in evidence.cmake for each in project.dependencies}
    named |= known & {each.name for each in evidence.code if each.namespace == "import"}
    lacking = {n: asked for n, asked in lacking.items() if not (meant(n, named) or credited(n, evidence))}
    nowhere = {name: asked for name, asked in lacking.items() if not sources.may_hold(name)}
    taken = {address(source.repo or "") for source in (*sources.sources, *sources.submodules)}
    taken |= {address(git.url) for git in evidence.sources if stands_already(git, known, sources.names)}
    copied = _copied(evidence)
    taken |= {address(git.url) for git in evidence.sources if plain(git.name) in copied}
    found: list[Source] = []
    reasons = []
    clones = _cloned(cloned, lacking, evidence, taken, known)
    tabled = holders(lacking) if build.startswith("catkin") else {}
    guessed = {name: asked for name, asked in nowhere.items() if not any(name in held for held in tabled.values())}
    likely = {**tabled, **dict(addresses_of(guessed, evidence, known))}
    addresses = clones | {url: names for url, names in likely.items() if url not in clones}
    alike = {name: asked for name, asked in lacking.items() if sources.hardly_holds(name)}
    for url, names in addresses_of(alike, evidence, known):
        if called := tuple(name for name in names if url.endswith(f"/{name}")):
            addresses.setdefault(url, called)
    names_of_clones = [source.name for source in sources.everything]
    perhaps = (name for name in lacking if name not in nowhere)  # in a clone, whatever that is called
    unsure = tuple(name for name in perhaps if not any(akin(name, other) for other in names_of_clones))
    for git in listed_by_pages(evidence, address(evidence.origin or ""), known, unsure) if unsure else ():
        addresses.setdefault(https(git.url).removesuffix(".git"), unsure)
    for url, names in by_authors((*unsure, *guessed), evidence):
        addresses.setdefault(url, names)
    for url, names in [each for each in addresses.items() if address(each[0]) not in taken][:MOST]:
        name, asked = folder_for(url, [*sources.sources, *found]), lacking[names[0]]
        place = Place(file=asked.file, line=asked.line)
        ref = refs.get(address(url))
        day = day_of_clone(ref, before)
        source = Source(name=name, repo=f"{url}.git", ref=ref, build=build, before=day, holding=names, place=place)
        found.append(source)
        why = f"nothing known brings {', '.join(names)}: it may be there, and is left out where it is not"
        reasons.append(because("source", name, why, asked, weight=Weight.SOUGHT))
    for git, parts in _parts(evidence, sources, known):
        url, ref, place = https(git.url), fixed(git.ref), Place(file=git.file, line=git.line)
        name = folder_for(url, [*sources.sources, *found])
        found.append(Source(name=name, repo=url, ref=ref, build=build, before=before, holding=parts, place=place))
        why = f"{git.file} takes {', '.join(parts)} out of it"
        reasons.append(because("source", name, why, git, weight=Weight.SOUGHT))
    return replace(choice, answer=replace(sources, sought=tuple(found)), reasons=(*choice.reasons, *reasons))


def _copied(evidence: Evidence) -> frozenset[str]:
    """Return the names of folders in which several packages lie: a repository that is called so was copied there."""
    held: dict[str, set[str]] = {}
    for manifest in evidence.manifests:
        for name in manifest.file.split("/")[:-2]:
            held.setdefault(plain(name), set()).add(manifest.file)
    return frozenset(name for name, files in held.items() if len(files) > 1)


def folder_for(url: str, others: Iterable[Source]) -> str:
    """Return the name of a repository's folder in the workspace, with its owner's where another has that name."""
    owner, _, name = url.removesuffix(".git").rpartition("/")
    return name if all(other.name != name for other in others) else f"{plain(owner)}_{name}"


def _parts(
    evidence: Evidence, sources: Sources, known: AbstractSet[str]
) -> Iterator[tuple[GitSource, tuple[str, ...]]]:
    """Yield the clones of which pages keep some folders alone, each with these, where others of the page are cloned.

    Such a folder is called like the package in it.
    """
    files = {source.place.file for source in sources.sources if source.place}
    for git in taken_apart(evidence):
        parts = tuple(part for part in git.parts if part not in known | sources.names and PACKAGE.fullmatch(part))
        if parts and git.file in files:
            yield git, parts


def tried(sought: Iterable[Source]) -> dict[str, str]:
    """Return for each package that is looked for where that is, in words."""
    found: dict[str, str] = {}
    for source in sought:
        for name in source.holding:
            url = (source.repo or "").removesuffix(".git")
            found[name] = f"{found[name]} and {url}" if name in found else url
    return found


def without(
    choice: Choice[Sources], packages: Packages, left_out: Collection[str], *, none: bool = False
) -> Choice[Sources]:
    """Return the sources without those looked in that hold nothing but what packages need which are not built.

    ``none``: the build looks in none.
    """
    sought = choice.answer.sought
    kept = () if none else _without(sought, packages, left_out)
    lost = {source.name for source in sought} - {source.name for source in kept}
    reasons = (each for each in choice.reasons if each.weight != Weight.SOUGHT or each.answer not in lost)
    return replace(choice, answer=replace(choice.answer, sought=kept), reasons=tuple(reasons))


def _without(sought: tuple[Source, ...], packages: Packages, left_out: Collection[str]) -> tuple[Source, ...]:
    asking = {m.name: {d.name for d in m.dependencies} for m in packages.built}
    built = {name for each, names in asking.items() if each not in left_out for name in names}
    lost = {name for each, names in asking.items() if each in left_out for name in names} - built
    return tuple(source for source in sought if not lost.issuperset(source.holding))


def _lacking(
    needed: Iterable[Dependency], known: AbstractSet[str], own: set[str], folders: AbstractSet[str]
) -> Mapping[str, Dependency]:
    """Return the declared packages of ROS that are not known, by their names.

    One with a dash in its name only where one of the tree begins with the same word: ``hpp-core`` and ``hpp-util``; one
    that is called like a library of the system only where the code includes headers of a folder of its name.
    ``folders``: those of which the code includes headers.
    """
    found: dict[str, Dependency] = {}
    families = {name.partition("-")[0] for name in own if "-" in name}
    for asked in needed:
        of_ros = asked.namespace in {"rosdep", "ros"} and asked.role not in {"test", "doc"}
        if not of_ros or asked.strength != "declared" or asked.name in known or plain(asked.name) in known:
            continue
        sibling = asked.name.partition("-")[0] in families and not _OF_SYSTEM.search(asked.name)
        named = asked.name in BUILD_TYPES or of_pip(asked.name) or library_called(asked.name, None)
        library = asked.name in folders and _LIBRARY.fullmatch(asked.name)
        if (PACKAGE.fullmatch(asked.name) or library or sibling) and not named:
            found.setdefault(asked.name, asked)
    return found


def _cloned(
    cloned: Iterable[GitSource],
    lacking: Mapping[str, Dependency],
    evidence: Evidence,
    taken: AbstractSet[str],
    known: AbstractSet[str],
) -> dict[str, tuple[str, ...]]:
    """Return the addresses of what pages clone, each with the packages that it may hold though it is not called so.

    Those are all where it is of the repository's owner, else those that share a word with it, or begin with the same
    one; then those that no clone is called like, where the package that asks for them has the page, or where a page at
    the root clones few others: ``px_comm`` is in ``px-ros-pkg``. Not what Ubuntu has.
    """
    cloned = [git for git in cloned if not of_ubuntu(git)]
    names = tuple(lacking)
    owner = address(evidence.origin).rpartition("/")[0] if evidence.origin else ""
    found: dict[str, tuple[str, ...]] = {}
    for git in cloned:
        of_owner = address(git.url).rpartition("/")[0] == owner
        if held := tuple(name for name in names if of_owner or akin(name, git.name)):
            found.setdefault(https(git.url).removesuffix(".git"), held)
    left = [asked for name, asked in lacking.items() if not any(akin(name, git.name) for git in cloned)]
    for git in cloned:
        if held := tuple(asked.name for asked in left if _of_page(asked, git)):
            found.setdefault(https(git.url).removesuffix(".git"), held)
    others = [git for git in cloned if known.isdisjoint((git.name, plain(git.name))) and address(git.url) not in taken]
    root = _of_root(others, tuple(asked.name for asked in left), evidence)
    return found | {url: names for url, names in root.items() if url not in found}


def _of_root(cloned: Iterable[GitSource], names: tuple[str, ...], evidence: Evidence) -> dict[str, tuple[str, ...]]:
    """Return the addresses of what pages at the root clone, each with ``names``, where these are few.

    Not what a recipe compiles, or a branch for one distribution; nor where the page tells what belongs in a workspace.
    """
    told = {git.file for git in evidence.sources if git.beside}
    root = [git for git in cloned if git.file.endswith(PAGES) and not git.file.count("/")]
    root = [git for git in root if git.file not in told and not distros_in(git.ref or "")]
    found = {https(git.url).removesuffix(".git"): names for git in root if names and not recipe_at(address(git.url))}
    return found if len(found) <= MOST_UNLIKE else {}


def _of_page(asked: Dependency, git: GitSource) -> bool:
    """Tell whether the page in the folder of the package that asks clones a repository; of the first page all are."""
    folder = git.file.rpartition("/")[0]
    return bool(folder) and git.file.endswith(PAGES) and folder == asked.file.rpartition("/")[0]
