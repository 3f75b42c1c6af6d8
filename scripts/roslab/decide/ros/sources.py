"""What is built from source: vcs files, clones that a manifest asks for, libraries from the table of recipes."""

from __future__ import annotations

from collections.abc import Iterable

from roslab.config.model import BuildTool, Config, Kind, Source, workspace_tool
from roslab.decide.decision import Choice, Reason, Warning_
from roslab.decide.reasons import because, configured, warn
from roslab.decide.ros.built_sources import Sources, with_tabled
from roslab.decide.ros.by_page import by_page
from roslab.decide.ros.clones import clones, for_unknown, linked, only_below, refs_of, unreleased, with_itself
from roslab.decide.ros.credited import told_by_pages
from roslab.decide.ros.distro_dates import dated
from roslab.decide.ros.for_launches import only_for_launches
from roslab.decide.ros.imported_clones import with_imported
from roslab.decide.ros.in_tree import in_tree, inside_packages, not_cloned
from roslab.decide.ros.itself import names_of_itself
from roslab.decide.ros.linked_workspaces import with_workspace
from roslab.decide.ros.lists_elsewhere import with_lists
from roslab.decide.ros.misnamed import left_over
from roslab.decide.ros.required_links import required_links
from roslab.decide.ros.sought import with_sought
from roslab.decide.ros.source_names import (
    address,
    as_clone,
    asked_for,
    called_like,
    day_of_clone,
    fixed,
    itself_in,
    plain,
    wanted_names,
)
from roslab.decide.ros.source_warnings import doubted, loose, private
from roslab.decide.ros.twice import folder_of, listed_twice, twice
from roslab.decide.ros.used import spoken_of, used_by_build
from roslab.decide.ros.vcs_files import vcs_files
from roslab.decide.ros.weights import Weight
from roslab.decide.system.lies_beside import lies_beside
from roslab.decide.system.own_options import own_options
from roslab.decide.system.switches import given, waits
from roslab.evidence.dependency import Dependency, GitSource
from roslab.evidence.facts import Evidence
from roslab.evidence.ros.vcs import https
from roslab.knowledge.recipes import recipe_at
from roslab.knowledge.released import released, rosdep_keys
from roslab.knowledge.ros_sources import RosSource, day_of, ros_sources
from roslab.values.dataclass import dataclass, field, replace
from roslab.values.origin import Place
from roslab.values.secret import SSH


def decide_sources(
    evidence: Evidence,
    config: Config,
    kind: Kind,
    *,
    ros_distro: str | None,
    build_tool: BuildTool,
    needed: tuple[Dependency, ...],
    own: frozenset[str],
    folder_name: str,
    launched: tuple[Dependency, ...] = (),
) -> Choice[Sources]:
    """Return the sources; ``needed``: names that a manifest or CMake asks for, ``own``: the repository's packages.

    ``launched``: packages that only the launch file of the default command needs.
    """
    date = None if config.compatible else dated(evidence)
    chosen = _Chosen(
        build_tool=build_tool,
        ros=2 if kind == "ros2" else 1,
        by_ssh=SSH in config.secrets,
        before=date.value if date else "",
        private=frozenset(address(git.url) for git in evidence.sources if git.private),
    )
    chosen.configure(config)
    chosen.in_tree(evidence, config)
    if kind not in {"ros1", "ros2"}:
        return chosen.choice(())
    itself = names_of_itself(evidence, folder_name, own)
    chosen.itself = {name for name in itself if name not in own}
    known = released(ros_distro or "") | own
    needed = tuple(each for each in needed if each.namespace != "rosdep" or not left_over(each.name, ros_distro))
    lacking = bool(unreleased(needed, known | rosdep_keys()))
    files = vcs_files(evidence, config, ros_distro, lacking=lacking, itself=itself)
    for git in evidence.sources:
        if git.kind == "vcs" and git.file in files and not listed_twice(git, evidence, itself, own):
            library = recipe_at(address(git.url)) if kind == "ros1" and not config.compatible else None
            if library:  # plain CMake, in which catkin sees no package
                chosen.library(library, git)
            else:
                chosen.add(git, f"{git.file} lists it")
    options = " ".join(own_options(evidence, config, folder_name, build_tool)) or given(evidence)
    wanted = wanted_names(each for each in needed if not waits(each, options))
    answered: set[str] = set()
    found = clones(evidence, ros_distro)
    exact = {wanted[name].name for name in {plain(git.name) for git in found} if name in wanted}
    for git in found:
        other = twice(git, itself, own) or lies_beside(git, evidence)
        if not other and (asked := asked_for(git, wanted, known | exact)):  # no other clone stands for these
            answered.add(asked.name)
            chosen.clone(git, asked, known | rosdep_keys())
    for git, why in with_itself(evidence, ros_distro, itself, own, known):
        chosen.add(git, why)
    if unknown := unreleased(needed, known | rosdep_keys() | answered | {*chosen.sources}):
        for git, why in for_unknown(evidence, ros_distro, itself, own | known, unknown):
            chosen.add(git, why)
    used = tuple(used_by_build(evidence, needed))
    chosen.required(evidence, (*used, *launched), known | rosdep_keys() | answered, itself | own, ros_distro or "")
    chosen.known((*used, *launched), known | rosdep_keys(), 1 if kind == "ros1" else 2, ros_distro or "")
    chosen.linked(evidence, used, known | rosdep_keys() | answered, itself)
    there = known | rosdep_keys() | by_page(used, evidence)
    choice = with_lists(chosen.choice(files), unknown, evidence, chosen.before, itself)
    choice = with_workspace(choice, unknown, evidence, chosen.before, itself)
    names = frozenset(plain(each.name) for each in needed)
    started = tuple(each.name for each in launched)
    answer = replace(choice.answer, asked=names, within=inside_packages(evidence), started=started)
    answer = with_imported(answer, evidence, chosen.ros)
    answer = with_tabled(answer, chosen.ros, ros_distro or "")
    return with_sought(
        replace(choice, answer=answer),
        evidence,
        config,
        build_tool=build_tool,
        needed=(*used, *launched, *spoken_of(evidence, needed)),
        known=there,
        cloned=told_by_pages(found, evidence, itself, own),
        refs=refs_of((*found, *(git for git in evidence.sources if git.kind == "link")), ros_distro),
        before=chosen.before,
    )


@dataclass
class _Chosen:
    """The sources chosen so far."""

    build_tool: BuildTool
    ros: int
    by_ssh: bool
    """The build has a key: addresses of ssh stay as they are."""
    before: str = ""
    """The date of the repository's last commit: what it clones without a ref is taken as it was then."""
    sources: dict[str, Source] = field(default_factory=dict)
    reasons: list[Reason] = field(default_factory=list)
    warnings: list[Warning_] = field(default_factory=list)
    libraries: dict[str, Dependency] = field(default_factory=dict)
    empty: list[Source] = field(default_factory=list)
    packages: set[str] = field(default_factory=set)
    """Packages that the table finds in these repositories."""
    wanted: dict[str, list[tuple[str, Dependency]]] = field(default_factory=dict)
    asked: set[str] = field(default_factory=set)  # names that the build uses, and neither rosdep nor ROS has
    private: frozenset[str] = frozenset()
    """Addresses of what pages call private."""
    itself: set[str] = field(default_factory=set)
    """The repository's own names."""
    others: set[str] = field(default_factory=set)
    """Addresses of the table in whose place another repository is cloned."""

    def add(self, git: GitSource, why: str, *, tabled: bool = False) -> bool:
        """Add a repository unless one of that name or URL was added before; tell whether it was added.

        ``tabled``: this program's table names it, not the repository.
        """
        urls = {address(source.repo) for source in (*self.sources.values(), *self.empty) if source.repo}
        named = self.sources.keys() | {each.name.rpartition("/")[2] for each in self.empty}
        name = folder_of(git, named | self.itself)
        if name in named or address(git.url) in urls:
            return False
        ref = fixed(git.ref)
        self.sources[name] = Source(
            name=name,
            repo=git.by_ssh if self.by_ssh and git.by_ssh else https(git.url),
            ref=ref,
            build=workspace_tool(self.build_tool) or "none",
            before=day_of_clone(ref, self.before),
            unasked=only_below(git) or bool(git.doubt),
            listed=not tabled,
            lists=git.lists,
            place=Place(file=git.file, line=git.line),
        )
        self.reasons.append(because("source", name, why, git, weight=Weight.LISTED))
        if git.private or address(git.url) in self.private:
            self.warnings.append(private(name, git))
        if git.doubt:
            self.warnings.append(doubted(name, git))
        return True

    def configure(self, config: Config) -> None:
        """Add what roslab.yaml names; nothing replaces it."""
        for index, source in enumerate(config.source):
            self.sources[source.name] = source
            self.reasons.append(configured(config, "source", source.name, f"source.{index}"))

    def clone(self, git: GitSource, asked: Dependency, elsewhere: frozenset[str]) -> None:
        """Add what a page or a manifest clones; warn if rosdep has a package of that name too."""
        new = self.add(git, f"{asked.file}:{asked.line} needs {asked.name}, and it is cloned here")
        if new:
            self._may_be_cmake(git, asked)
        self.others |= {address(row.repo) for row in ros_sources(asked.name, self.ros)[-1:]} - {address(git.url)}
        if new and asked.namespace == "rosdep" and asked.name in elsewhere:
            message = f"{asked.name} is cloned from {git.url} ({git.file}:{git.line})"
            more = "rosdep has a package of the same name, which may be another one: the clone is used"
            if asked.name not in {git.name, plain(git.name)}:  # its key stays
                more = "rosdep has a package of the same name, which is installed, too: the build may find either"
            self.warnings.append(warn(f"{message}; {more}", asked))

    def _may_be_cmake(self, git: GitSource, asked: Dependency) -> None:
        """Mark what was added last where it may be plain CMake: the build asks for it by its name, for catkin."""
        if self.build_tool.startswith("catkin") and asked.role != "exec" and called_like(git, asked):
            name = next(reversed(self.sources))
            self.sources[name] = replace(self.sources[name], unread=True)

    def in_tree(self, evidence: Evidence, config: Config) -> None:
        """Report the submodules, and what a page clones into the tree; what is not there is cloned in the image."""
        found, reasons = in_tree(evidence, config, self.before)
        self.reasons += reasons
        self.warnings += not_cloned(evidence, config)
        self.empty += [source for _, source in found]
        self.warnings += [private(git.name, git) for git, _ in found if git.private]
        for git, _ in found:
            self._linked(git, self.ros)

    def library(self, name: str, git: GitSource) -> None:
        """Note a library of the table that a list names: it is built before the workspace."""
        asked = Dependency(
            namespace="cmake", name=git.name, strength="declared", file=git.file, line=git.line, role="build"
        )
        self.libraries.setdefault(name, asked)

    def _linked(self, git: GitSource, ros: int) -> None:
        """Note the library that a submodule links, if the table of unreleased packages knows the submodule."""
        for found in ros_sources(git.name.rpartition("/")[2], ros):
            if found.library and address(found.repo) == address(git.url):
                asked = Dependency(
                    namespace="ros", name=found.package, strength="declared", file=git.file, line=git.line, role="build"
                )
                self.libraries.setdefault(found.library, asked)

    def known(self, needed: Iterable[Dependency], elsewhere: frozenset[str], ros: int, distro: str) -> None:
        """Add unreleased packages from the table for names that nothing else provides.

        If the author already clones the same repository, its ref is kept and the rest comes from the table.
        """
        for asked in needed:
            if asked.namespace not in {"rosdep", "ros", "cmake"} or asked.name in elsewhere:
                continue
            self.asked.add(asked.name)
            for found in ros_sources(asked.name, ros, distro):
                if address(found.repo) in self.others:
                    continue
                git = as_clone(found, asked)
                self.add(git, f"{asked.name} is needed, and no distribution released {found.package}", tabled=True)
                if git.name in self.sources:
                    self.packages.add(found.package)
                    self.wanted.setdefault(git.name, []).append((found.package, asked))
                    self._complete(git.name, found, asked, distro)

    def _complete(self, name: str, found: RosSource, asked: Dependency, distro: str) -> None:
        source = self.sources[name]
        if source.repo is None or address(source.repo) != address(found.repo):
            return  # another repository of that name
        if found.library:
            self.libraries.setdefault(found.library, asked)
        options = source.cmake_options or found.options.format(distro=distro)
        day = day_of(found, distro, self.before) if source.ref == found.ref else source.before
        self.sources[name] = replace(source, prepare=found.prepare, cmake_options=options, before=day)

    def required(
        self, evidence: Evidence, needed: Iterable[Dependency], known: frozenset[str], itself: set[str], distro: str
    ) -> None:
        """Add what a page lists among the required repositories, in whose place no table's is cloned."""
        for git, asked in required_links(evidence, needed, known | {*self.sources}, self.ros, distro):
            why = f"{asked.file}:{asked.line} needs {asked.name}, and {git.file} lists it as required"
            if not itself_in(git, itself) and self.add(git, why):
                self.others |= {address(row.repo) for row in ros_sources(asked.name, self.ros)} - {address(git.url)}

    def linked(self, evidence: Evidence, needed: Iterable[Dependency], known: frozenset[str], itself: set[str]) -> None:
        """Add what pages link to for packages that are needed and that nothing brings so far."""
        others = [each for each in needed if each.name not in self.packages]
        for git, asked in linked(evidence, others, known | {*self.sources}, self.ros):
            why = f"{asked.file}:{asked.line} needs {asked.name}, and {git.file} links to it"
            if not itself_in(git, itself) and self.add(git, why):
                self._may_be_cmake(git, asked)

    def choice(self, files: tuple[str, ...]) -> Choice[Sources]:
        """Return the sources with their reasons and warnings."""
        return Choice(
            answer=Sources(
                sources=only_for_launches(self.sources.values(), self.wanted, self.asked, others=bool(self.empty)),
                vcs=files,
                submodules=tuple(self.empty),
                libraries=tuple(self.libraries.items()),
                names=frozenset(self.sources) | {plain(name) for name in self.sources} | self.packages,
            ),
            reasons=tuple(self.reasons),
            warnings=(*self.warnings, *loose(self.sources.values())),
        )
