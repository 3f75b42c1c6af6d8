"""Python packages that no manifest names: guessed from install lines and imports."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Set

from roslab.config.model import Kind
from roslab.decide.notebook_server import package_of_server
from roslab.decide.notebooks import opened
from roslab.decide.python.bare import repository_of
from roslab.decide.python.built_here import built_here
from roslab.decide.python.extras import for_developers
from roslab.decide.python.linked_repositories import Linked, linked_repositories
from roslab.decide.python.manifests import with_includes
from roslab.decide.python.on_index import on_index
from roslab.decide.python.other_lists import as_in_list, named_in_list
from roslab.decide.python.parts import in_baselines
from roslab.decide.python.pins import Pin, of_conda
from roslab.decide.python.pythons import ANY
from roslab.evidence import places
from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import Evidence, Mention, RequirementFile
from roslab.evidence.python.manager_lines import GROUP
from roslab.evidence.python_project import PythonProject
from roslab.evidence.ros.vcs import https
from roslab.knowledge.frameworks import imports, released_together, tabled
from roslab.knowledge.guesses import ros_modules, same_module, successors, tooling, tools_of_developers
from roslab.knowledge.windows import shown_with
from roslab.values.dataclass import replace
from roslab.values.name import canonicalize_name, of_fork
from roslab.values.pattern import pattern
from roslab.values.requirement import Requirement
from roslab.values.requirement_line import stated

_FOR_DEVELOPERS = pattern(r"(?:^|/)(?:\.(?:github|circleci|travis|gitlab)|(?:bitbucket|azure)-pipelines\.|docs?\d?/)")
_REPOSITORY = pattern(r"git\+\w+://(?:[^@/]*@)?([\w.-]+/[\w.-]+/[\w.-]+?)(?:\.git)?(?:[@#].*)?$")
FRAMEWORKS = frozenset({"torch", "tensorflow", "jax", "keras"})
"""Of an image of ROS, only those that a node imports are guessed: they are large."""
MAX_GUESSES = 40


def guesses(
    evidence: Evidence, pins: tuple[Pin, ...], kind: Kind, *, manifests: bool, known: set[str], loose: Set[str]
) -> tuple[Requirement, ...]:
    """Return the packages that only prose, Dockerfiles and imports name, each once, from the best source.

    Of the ``known`` ones, those that a page gives an older version: ``loose`` are declared in any version.
    """
    found: dict[str, Requirement] = {}
    ros = kind in {"ros1", "ros2"}
    own = {canonicalize_name(project.name).replace("-", "") for project in evidence.python if project.name}
    urls = {_repository(pin.requirement.url) for pin in pins if pin.trust >= 2}
    urls = {*urls, _repository(f"git+{https(evidence.origin)}")} - {""}  # the origin's own address is the tree itself
    built = built_here(evidence)
    for pin in sorted((pin for pin in pins if pin.trust == 1), key=_specific):
        aside = bool(_FOR_DEVELOPERS.search(pin.requirement.file))
        if (
            pin.requirement.origin != "prose"
            or _repository(pin.requirement.url) in urls
            or (pin.name in known and not (pin.name in loose and pin.requirement.limited and pin.requirement.specifier))
            or (pin.requirement.vcs and pin.name.replace("-", "") in own)
            or (pin.requirement.vcs and _had(pin.name, evidence, found))
            or pin.name == "pip"
            or (pin.requirement.role in {"listed", "bounded"} and pin.name in built)
            or (pin.name in tooling("installers") and not pin.release)
            or (aside and pin.name in tools_of_developers())
            or (pin.name in tooling("checkers") and not pin.requirement.specifier and not _of_image(pin))
        ):
            continue
        plain = pin.requirement.role in {"", "conda"}
        asked = _as_in_extra(pin.requirement, evidence) if plain else pin.requirement
        if _names_the_build(pin.requirement, of=found.setdefault(pin.name, asked)):
            found[pin.name] = pin.requirement
    first = opened(evidence, kind)
    if first and not {"jupyter", "jupyterlab", "notebook"} & {*known, *found}:
        of_server = package_of_server(evidence)
        found[of_server] = stated(of_server, "prose", first.file, first.line)
    tools = tooling("installers") | tools_of_developers()
    heavy = bool(known & {"torch", "tensorflow", "jax"})
    offered, limits = linked_repositories(evidence), _limits(evidence)
    ways = {each.value: stated(each.text, "import", each.file, each.line) for each in told_ways(evidence)}
    for dependency in _imported(evidence, kind, manifests=manifests):
        package, apt = imports().get(dependency.name) or (on_index(evidence, dependency), None)
        package = package or (named_in_list(evidence, dependency) if dependency.name not in imports() else None)
        if not package and (said := _said(dependency, offered, {} if ros else ways, ros=ros)):
            if not {canonicalize_name(dependency.name), said.key} & {*known, *found}:
                found[said.key] = replace(said, file=dependency.file, line=dependency.line)
            continue
        name = canonicalize_name(package) if package else ""
        covered = not package or name in known or name in found or name in built
        covered = covered or repository_of(name) in {*known, *found}
        covered = covered or any(same_module(name, other) for other in (*known, *found))
        if not package or covered or name in tools or (heavy and name in FRAMEWORKS):
            continue
        by_apt = bool(apt) or dependency.name in ros_modules()
        if ros and (by_apt or (name in FRAMEWORKS and dependency.role != "node")):
            continue  # a ROS image's Python is the system's: what apt has comes from there
        version = (dependency.version or "") if dependency.role == "told" else limits.get(name, "")
        guess = _as_in_extra(stated(package + version, "import", dependency.file, dependency.line), evidence)
        found[name] = guess if name in FRAMEWORKS else as_in_list(guess, evidence)
    return tuple(found.values())[:MAX_GUESSES]


def _said(dependency: Dependency, offered: Linked, ways: Mapping[str, Requirement], *, ros: bool) -> Requirement | None:
    """Return the repository that a page links to for a module of no table, or what the code tells to install for it."""
    if dependency.name in imports():
        return None
    linked = offered.of_module(dependency, ros=ros)
    return linked if linked and not places.aside(dependency.file) else ways.get(dependency.name)


def told_ways(evidence: Evidence) -> Iterator[Mention]:
    """Yield what the code tells to install for a module of no table that it does without, or stops without.

    No part of the repository itself: that is told for its extras.
    """
    own = {canonicalize_name(project.name) for project in evidence.python if project.name}
    for each in evidence.mentions:
        if each.topic == "told_way" and each.value not in imports() and stated(each.text).key not in own:
            yield each


def _tries_torch(evidence: Evidence) -> bool:
    """Tell whether CMake only tries to find torch: where pip's is there, whose CUDA the base lacks, it stops.

    https://github.com/pytorch/pytorch/blob/v2.1.0/cmake/Caffe2Config.cmake.in, read 2026-11-27.
    """
    asked = (each for made in evidence.cmake if not places.aside(made.file) for each in made.dependencies)
    found = [each.strength for each in asked if each.namespace == "cmake" and each.name == "Torch"]
    return bool(found) and all(strength == "optional" for strength in found)


def _limits(evidence: Evidence) -> dict[str, str]:
    """Return by name the versions that packages of the tree allow of what they need, installed or not."""
    asked = (each for project in evidence.python if not places.vendored(project.file) for each in project.requirements)
    bound = (each for each in asked if each.role == "" and each.below and not each.url and not each.marker)
    return {each.key: str(each.specifier) for each in bound}


def _as_in_extra(guess: Requirement, evidence: Evidence) -> Requirement:
    """Return a guess as an extra of the project at the root asks for it, under whichever name: ``pygame-ce>=2.5``.

    Not where extras ask for it in several ways, as for a CPU and a GPU; one that leaves its versions open is none of
    these. Nor as one does that is for tests or documentation, nor as a build without windows where the code opens one
    by it.
    """
    if guess.limited or guess.specifier or guess.url or guess.extras:
        return guess
    asked = [each for project in evidence.python if not project.folder for each in project.requirements]
    asked = [each for each in asked if each.role == "extra" and not each.group.startswith(GROUP)]
    asked = [each for each in asked if not for_developers(each.group)]
    extra = [each for each in asked if each.key == guess.key or (each.name and same_module(guess.key, each.key))]
    told = {each.key for each in extra if each.text != each.name}
    said = [each for each in extra if each.key not in told or each.text != each.name]
    same = said[0] if len({each.text for each in said}) == 1 else None
    if same is None or not same.package or same.url or same.marker:
        return guess
    if same.key.endswith("-headless") and _shows(guess, evidence):
        return guess
    return replace(same, origin=guess.origin, role="", file=guess.file, line=guess.line)


def _shows(guess: Requirement, evidence: Evidence) -> bool:
    """Tell whether the code opens a window by a package: ``opencv-python`` by ``cv2.imshow``."""
    calls = (each for each in evidence.code if each.namespace == "call" and each.role != "build")
    return any(guess.key.startswith(each.name) and not places.aside(each.file) for each in calls)


def to_show(evidence: Evidence, known: Set[str]) -> Iterator[Requirement]:
    """Yield what a library needs to open a window where code imports it and has it open one; not what is ``known``."""
    used = {each.name for each in evidence.code if each.namespace == "import"}
    for each in evidence.code:
        opens = each.namespace == "call" and each.name in shown_with() and not places.aside(each.file)
        if opens and each.name in used:
            asked = stated(shown_with()[each.name], "import", each.file, each.line)
            if asked.key not in known:
                yield asked
                return


def _imported(evidence: Evidence, kind: Kind, *, manifests: bool) -> Iterator[Dependency]:
    """Yield the imports that count: those that may fail where no manifest is, or where the code says what to install.

    A framework beside a manifest is not among these: it is another way to do the same. So is a module that is only
    tried beside the one that took its place.
    """
    used = {each.name for each in evidence.code if each.namespace == "import" and each.strength == "used"}
    compared = in_baselines(evidence, kind)
    ways = {each.value for each in told_ways(evidence)}
    for each in evidence.code:
        told = (each.role == "told" and each.name not in FRAMEWORKS) or each.name in ways
        tried = (each.name == "torch" and _tries_torch(evidence)) or successors().get(each.name) in used
        counts = each.strength == "used" or (each.strength == "optional" and (told or not manifests) and not tried)
        if each.namespace == "import" and counts and not (places.test(each.file) or compared(each.file)):
            yield each


def _of_image(pin: Pin) -> bool:
    """Tell whether the line is of a Dockerfile of the author's: what that installs is in his own image, too."""
    return "dockerfile" in pin.requirement.file.rpartition("/")[2].lower()


def _repository(url: str) -> str:
    """Return the repository of a ``git+`` URL, so that two spellings of one package are not both installed."""
    match = _REPOSITORY.search(url)
    return match[1].lower() if match else ""


def _had(name: str, evidence: Evidence, found: Mapping[str, Requirement]) -> bool:
    """Tell whether a repository is that of the tree's own project, or of a package that a line names in a release."""
    pinned = {key for key, each in found.items() if each.release and not each.url}
    own = {canonicalize_name(project.name) for project in evidence.python if project.name}
    return any(same_module(name, other) for other in (*own, *pinned))


def _names_the_build(asked: Requirement, of: Requirement) -> bool:
    """Tell whether a command installs the release that a sentence names, as the build for one CUDA: ``+cu101``."""
    release, _, local = (asked.release or "").partition("+")
    return bool(local) and not asked.role and of.role in {"listed", "bounded"} and of.release == release


def _specific(pin: Pin) -> tuple[int, int, int]:
    """Return the sort key for mentions of a package: those with a version first, then those nearest to the root."""
    authored = pin.requirement.file.lower().rpartition("/")[2]
    return (
        not (pin.release or pin.requirement.role == "bounded"),
        pin.requirement.file.count("/"),
        "docker" in authored,
    )


def loose_names(
    evidence: Evidence, files: Iterable[RequirementFile], projects: Iterable[PythonProject]
) -> frozenset[str]:
    """Return the packages that manifests declare without an upper bound; frameworks are pinned by other rules."""
    asked = [each for file in with_includes(evidence, files) for each in file.requirements]
    asked += [each for project in projects for each in project.requirements if each.role in {"", "source"}]
    limited = {each.key for each in asked if each.limited}
    beside = {name for names in released_together().values() for name in names}
    return frozenset(each.key for each in asked if each.name) - limited - FRAMEWORKS - beside


def known_requirements(
    evidence: Evidence, files: tuple[RequirementFile, ...], projects: tuple[PythonProject, ...], conda: str | None
) -> tuple[Requirement, ...]:
    """Return what is installed anyway, as it is written there."""
    asked = [each for file in with_includes(evidence, files) for each in file.requirements]
    asked += [each for project in projects for each in project.requirements if each.role in {"", "source", "member"}]
    for environment in evidence.conda:
        if environment.file == conda:
            asked += [*environment.requirements, *of_conda(environment)]
    return tuple(each for each in asked if ANY.may(each))


def known_names(
    evidence: Evidence, files: tuple[RequirementFile, ...], projects: tuple[PythonProject, ...], conda: str | None
) -> set[str]:
    """Return the packages that are installed anyway, and the names of the tree's own projects."""
    asked = known_requirements(evidence, files, projects, conda)
    known = {each.key for each in asked} | {of_fork(each.name) for each in asked if each.vcs}
    known |= {canonicalize_name(project.name) for project in evidence.python if project.name}
    unseen = (project.folder for project in projects if not project.name)  # most are called as their folder
    known |= {canonicalize_name(folder.rpartition("/")[2]) for folder in unseen if folder}
    return known | {tabled(name) for name in known}
