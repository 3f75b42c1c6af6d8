"""Packages that launch files find, or nodes import, and nothing brings, looked for at the repository's owner."""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Collection, Iterable
from itertools import islice, pairwise, takewhile

from roslab.config.model import BuildTool, Config, Source, SourceBuild, workspace_tool
from roslab.decide.decision import Choice
from roslab.decide.launch_calls import started_launch
from roslab.decide.launch_needs import lacking_elsewhere
from roslab.decide.reasons import because
from roslab.decide.ros.built_sources import Sources
from roslab.decide.ros.distro_dates import dated
from roslab.decide.ros.slips import meant
from roslab.decide.ros.sought import MOST, PACKAGE, folder_for, tried
from roslab.decide.ros.sought_addresses import public_owner
from roslab.decide.ros.sought_by_pages import in_clones, run_by_page
from roslab.decide.ros.sought_imports import linked_of_owner, modules_of_links, modules_of_owner
from roslab.decide.ros.source_names import address, plain
from roslab.decide.ros.weights import Weight
from roslab.evidence.facts import Evidence
from roslab.evidence.ros.vcs import https
from roslab.knowledge.holders import holders
from roslab.knowledge.released import ever_released
from roslab.values.dataclass import replace
from roslab.values.origin import Place
from roslab.values.requirement import Requirement


def with_found_by_launches(
    choice: Choice[Sources],
    evidence: Evidence,
    config: Config,
    command: tuple[str, ...] | str,
    *,
    ros_distro: str | None,
    build_tool: BuildTool,
    installed: Iterable[Requirement] = (),
) -> Choice[Sources]:
    """Return the sources with a repository of the same owner for each package that only other launch files need.

    Before these comes where a table knows such a package to be. ``command``: the default one, whose launch file's
    packages are looked for already. Not for the old formats, whose images never had them, nor a package that others
    published, nor one a slip away from a package of the tree, or that a clone has under a longer name. So it is with
    what programs look for while they run, and with modules that nodes import and nothing brings, in the place of whose
    repository comes one of that name that the code links to; ``installed``: what pip installs. Several packages whose
    names begin alike are first looked for in a repository that is called so. And before all come packages that the
    README runs, in what that page clones. Last, modules of no table are looked for in what pages name of the owner's.
    """
    build: SourceBuild | None = "none" if build_tool == "rosmake" else workspace_tool(build_tool)
    owner = public_owner(evidence)
    if build is None or config.compatible or not ros_distro:
        return choice
    sources = choice.answer
    where = tried(sources.sought)
    taken = {address(evidence.origin)} | {address(source.repo or "") for source in sources.everything}
    own = {manifest.name for manifest in evidence.manifests if manifest.name}
    date = dated(evidence)
    found = [*sources.sought]
    reasons = []
    owners = {each.file: each.package for each in evidence.launch}
    needed = lacking_elsewhere(evidence, started_launch(evidence, command), sources, ros_distro)
    imported = {asked.name: asked for asked in modules_of_owner(evidence, installed)}
    looked_up = {
        each.name: each
        for each in evidence.code
        if each.namespace == "ros" and (each.role, each.strength) == ("exec", "used") and each.name not in own
    }
    free = {
        name: asked
        for name, asked in (looked_up | needed | imported).items()
        if not (
            name in where
            or name in sources.names
            or sources.renamed(name)
            or not PACKAGE.fullmatch(name)
            or ever_released(name)
            or meant(name, own)
        )
        and not ever_released(owners.get(asked.file) or "")  # what was published is not the owner's
    }
    tabled = holders(free) if build.startswith("catkin") else {}
    for git in evidence.commented:  # where the code says that it took something from
        name = plain(git.name)
        if name in imported and name in free:
            tabled.setdefault(git.url, (name,))
    there = {name for held in tabled.values() for name in held}
    guessed = {f"{owner}/{name}": names for name, names in _families(free.keys() - there).items() if owner}
    for name in (each for each in free if owner and each not in there):
        guessed[f"{owner}/{name}"] = (name, *guessed.get(f"{owner}/{name}", ()))
    brought = sources.names | {plain(name) for name in where} | {plain(source.name) for source in sources.everything}
    run = {} if sources.with_unknown_packages else run_by_page(evidence, ros_distro, brought)
    cloned = in_clones(run, evidence, taken)
    held = tabled | guessed
    held |= {url: tuple(dict.fromkeys((*names, *held.get(url, ())))) for url, names in cloned.items()}
    for url, names in held.items():
        if address(url) in taken or len(found) >= MOST:
            continue
        asked = (run if url in cloned else free)[names[0]]
        source = Source(
            name=folder_for(url, [*sources.sources, *found]),
            repo=f"{url}.git",
            build=build,
            before=date.value if date else "",
            holding=names,
            place=Place(file=asked.file, line=asked.line),
        )
        found.append(source)
        who = "nodes import" if names[0] in imported else "only launch files need"
        who = "programs look for" if names[0] in looked_up.keys() - needed.keys() else who
        who = f"{asked.file} runs programs of" if url in cloned else who
        why = "and nothing known brings it: it may be there, and is left out where not"
        reasons.append(because("source", source.name, f"{who} {', '.join(names)}, {why}", asked, weight=Weight.SOUGHT))
    answer = replace(sources, sought=tuple(found))
    return _with_modules(
        replace(choice, answer=answer, reasons=(*choice.reasons, *reasons)), evidence, installed, taken, build=build
    )


def _with_modules(
    choice: Choice[Sources],
    evidence: Evidence,
    installed: Iterable[Requirement],
    taken: Collection[str],
    *,
    build: SourceBuild,
) -> Choice[Sources]:
    """Return the sources with what pages name of the owner's for modules of no table that are looked for nowhere yet.

    ``taken``: addresses of what is cloned anyway.
    """
    links = linked_of_owner(evidence)
    found = [*choice.answer.sought]
    sought = {name for each in found for name in each.holding}
    asked = tuple(each for each in modules_of_links(evidence, installed) if each.name not in sought) if links else ()
    if not asked:
        return choice
    modules = tuple(each.name for each in asked)
    date = dated(evidence)
    reasons = []
    for git in links:
        at = next((i for i, each in enumerate(found) if address(each.repo or "") == address(git.url)), None)
        if at is not None:
            found[at] = replace(found[at], holding=(*found[at].holding, *modules))
        elif address(git.url) not in taken and len(found) < MOST:
            source = Source(
                name=folder_for(git.url, [*choice.answer.sources, *found]),
                repo=f"{https(git.url).removesuffix('.git')}.git",
                build=build,
                before=date.value if date else "",
                holding=modules,
                place=Place(file=asked[0].file, line=asked[0].line),
            )
            found.append(source)
            why = f"the code imports {', '.join(modules)}, and {git.file} names this repository of the same owner"
            reasons.append(because("source", source.name, why, asked[0], weight=Weight.SOUGHT))
    answer = replace(choice.answer, sought=tuple(found), modules=frozenset(modules))
    return replace(choice, answer=answer, reasons=(*choice.reasons, *reasons))


def _families(names: Collection[str]) -> dict[str, tuple[str, ...]]:
    """Return the longest names of two words or more with which those of several packages begin, each with these.

    ``a_b`` for ``a_b_utils`` and ``a_b_description``: the repository that holds such packages is often called so.
    """
    found: dict[str, tuple[str, ...]] = {}
    ordered = sorted(names)
    for name, other in pairwise(ordered):
        pairs = zip(name.split("_")[:-1], other.split("_")[:-1], strict=False)
        begin = "_".join(word for word, _ in takewhile(lambda pair: pair[0] == pair[1], pairs))
        if "_" in begin and begin not in found and not ever_released(begin):
            behind = islice(ordered, bisect_left(ordered, f"{begin}_"), None)
            found[begin] = tuple(takewhile(lambda each: each.startswith(f"{begin}_"), behind))  # noqa: B023 - read here
    return found
