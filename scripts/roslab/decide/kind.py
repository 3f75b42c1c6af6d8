"""What a repository is: ROS 1, ROS 2, deep learning on CUDA, plain Python or plain C++."""

from __future__ import annotations

from typing import cast

from roslab.config.model import WORKSPACE_TOOLS, Config, Kind
from roslab.decide.beside_cpp import built_otherwise, compiles_nothing, mostly_cpp, to_compile, uncompiled, with_helpers
from roslab.decide.built_by_pages import built_by_page, only_by_pip, without_ros
from roslab.decide.cuda.for_libtorch import for_libtorch
from roslab.decide.cuda.signs import includes_tensorrt, sign_of_cuda, warnings_of_cuda
from roslab.decide.decision import Choice, Reason, Warning_
from roslab.decide.last_signs import OTHER_BUILDER, last_signs
from roslab.decide.programs import top_of
from roslab.decide.reasons import Placed, because, configured, page_of, ranked, strongest, warn
from roslab.decide.ros.plain_workspace import beside_catkin, built_by_cmake_alone, built_together, parts_of_cmake
from roslab.decide.ros.run_outside import run_outside
from roslab.decide.ros.without_manifest import CLIENTS, by_cmake, called_by_program, client_of, installed_by_author
from roslab.decide.ros.without_manifest import run_by_page as ros_by_page
from roslab.decide.ros.workspace import built_by_rosbuild, of_rosbuild, packages_of, ros_versions
from roslab.decide.ros.wrappers import run_by_page, wraps
from roslab.decide.stopped_cmake import left_to_python, told_of_stop
from roslab.decide.without_optional_ros import called_optional, told_of_optional_ros
from roslab.evidence import places
from roslab.evidence.facts import Evidence, PackageManifest
from roslab.knowledge.distros import distro, distros
from roslab.values.pattern import pattern

_ROS_NAME = pattern(r"(?:^|[-_.])ros[12]?(?:[-_.]|$)")
"""A repository of this name is for ROS, and its packages wrap nothing."""


class Weight:
    """How much each reason for a kind counts.

    What only one kind has counts more than what several have; the root counts more than folders below it.
    """

    PACKAGES = 500  # only ROS's tools build them
    CATKIN_ALONE = 470  # without ROS, CMake stops
    BUILT = 460  # a C++ project that its page builds with CMake, and never with pip
    NEVER_CALLED = 440  # a package whose CMake calls nothing of ROS: what its page builds with counts more
    BINDINGS = 450  # a C++ project whose setup.py only wraps it: wins over that setup.py
    ROS_ALONE = 410  # its program imports what only ROS has: wins over a setup.py, which knows nothing of it
    INSTALLABLE = 400  # pip installs the repository itself
    CONDA = 380  # it fits this code, but perhaps only its development
    OWN_LIST = 370  # a list that only ROS's tools read: wins over requirements, which a collection may have too
    ROSBUILD = 365  # wins over CMake, which rosbuild uses itself
    MAKE = 355  # wins over requirements, as CMake does
    CMAKE = 360  # wins over requirements, which a C++ project may have for its scripts
    REQUIREMENTS = 350
    LIST = 300  # a list of repositories in a folder, or as submodules
    INSTALLABLE_BELOW = 250  # in a subfolder it may be a part or a tool
    CONDA_BELOW = 240
    REQUIREMENTS_BELOW = 230
    WRAPPER = 200  # ROS packages that only wrap a Python program: any manifest of the program wins
    CMAKE_BELOW = 150  # where most of the code is C++, or the Python is for helpers alone
    EXAMPLES = 140  # ROS packages that are examples of another program, whose manifest wins
    CUDA_SIGN = 130  # code or CUDA sources without any manifest
    RUN = 210  # a program that the page at the root runs, where ROS packages only wrap it
    PROGRAM = 120
    CODE = 100  # it may belong to a library or be a helper script
    ROSBUILD_PART = 90  # one such folder may be an example
    CMAKE_PART = 90
    DEFAULT = 1
    DESCRIPTION = -10  # programs of every kind read robot descriptions
    OF_FRAMEWORK = 5  # added to the manifest's weight for Python: with a framework the kind is cuda


class Lean:
    """What decides between ROS 1 and 2 for a repository made for both; each outweighs all below it."""

    BY_SOURCE = (("branch", 60), ("dockerfile", 12), ("ci", 10), ("readme", 6), ("filename", 4))
    MORE_PACKAGES = 5
    NEWER = 2  # ROS 2, where nothing else tells


def decide_kind(evidence: Evidence, config: Config, folder_name: str = "") -> Choice[Kind]:
    """Return what kind of repository it is; ``folder_name`` is its name."""
    reasons: list[Reason] = []
    if config.kind:
        reasons.append(configured(config, "kind", config.kind, "kind"))
    elif config.base.ros and (known := distro(config.base.ros.partition("-")[0])):
        reasons.append(configured(config, "kind", f"ros{known.ros}", "base.ros"))
    elif config.base.cuda:
        reasons.append(configured(config, "kind", "cuda", "base.cuda"))
    reasons += [*_ros(evidence, named=bool(_ROS_NAME.search(folder_name.lower()))), *_python(evidence), *_cpp(evidence)]
    if not reasons:
        reasons += last_signs(evidence)
    if not reasons:
        other = any(said.topic == "other_builder" for said in evidence.mentions)  # its code is in another language
        code = next((each for each in evidence.code if each.namespace == "include" and not other), None)
        why = (
            "C or C++ alone, and nothing shows how it is compiled" if code else "nothing shows what it is: the default"
        )
        reasons.append(because("kind", "cpp" if code else "python", why, code, weight=Weight.DEFAULT))
    best = strongest(reasons)
    kind = cast("Kind", best.answer)
    told = (*_warnings(evidence, kind, best.weight), *told_of_stop(evidence, kind))
    return Choice(answer=kind, reasons=ranked(reasons, kind), warnings=told)


def _ros(evidence: Evidence, *, named: bool) -> list[Reason]:
    """Return what speaks for ROS 1 and for ROS 2; ``named``: the repository is named after ROS."""
    packages = packages_of(evidence)
    by_itself = by_cmake(evidence)
    in_modules = by_itself is not None and bool(evidence.manifests)  # all packages are those of submodules
    catkin = [manifest for manifest in packages.built if not (in_modules or of_rosbuild(manifest))]
    reasons = _packages(evidence, tuple(catkin), named=named) if catkin else _meta(evidence)
    rosbuild = [project for project in evidence.cmake if "rosbuild" in project.macros and not in_modules]
    if rosbuild:
        weight = Weight.ROSBUILD if built_by_rosbuild(evidence) else Weight.ROSBUILD_PART
        reasons.append(because("kind", "ros1", "it is built by rosbuild", rosbuild[0], weight=weight))
    if not reasons and (said := built_together(evidence)):
        why = f"packages of plain CMake, which {page_of(said.file)} has colcon build together"
        reasons.append(because("kind", "ros2", why, said, weight=Weight.PACKAGES))
    if not reasons and (plain := beside_catkin(evidence)):
        needed, stops = plain
        why = f"a package of plain CMake, built beside catkin's: it needs {needed.name}, which ROS 1 alone brings"
        weight = Weight.CATKIN_ALONE if stops else Weight.NEVER_CALLED
        reasons.append(because("kind", "ros1", why, needed, weight=weight))
    if not (reasons or rosbuild) and by_itself:
        why = "its CMake requires packages of ROS, and nothing is a package"
        reasons.append(because("kind", by_itself[1], why, by_itself[0], weight=Weight.CATKIN_ALONE))
    if not reasons and called_optional(evidence):
        return []
    if not reasons and (client := client_of(evidence)):
        why = f"its program imports {client.name}, which ROS alone brings"
        reasons.append(because("kind", CLIENTS[client.name], why, client, weight=Weight.ROS_ALONE))
    if not reasons and (has := installed_by_author(evidence)):
        reasons.append(because("kind", has[1], has[2], has[0], weight=Weight.ROS_ALONE))
    if not (reasons or evidence.manifests) and (run := ros_by_page(evidence) or called_by_program(evidence)):
        at, kind, why = run
        reasons.append(because("kind", kind, why, at, weight=Weight.ROS_ALONE))
    for manifest in packages.assets[:1]:
        why = "a package.xml with nothing to build beside it: the description of a robot"
        of = "ros2" if ros_versions(manifest) == {2} else "ros1"
        reasons.append(because("kind", of, why, manifest, weight=Weight.DESCRIPTION))
    return reasons


def _packages(evidence: Evidence, built: tuple[PackageManifest, ...], *, named: bool) -> list[Reason]:
    """Return the reasons that packages give: the ROS that builds them, and for packages of both what favours one."""
    macros = {project.file.rpartition("/")[0]: project.macros for project in evidence.cmake}
    by_version: dict[int, list[PackageManifest]] = {1: [], 2: []}
    for manifest in built:
        for version in ros_versions(manifest, macros.get(manifest.file.rpartition("/")[0], ())):
            by_version[version].append(manifest)
    files = [m.file for m in (*by_version[1], *by_version[2])]
    wrapper = not named and wraps(evidence, files)
    around = any("/" not in project.file for project in evidence.cmake)  # the library that the examples wrap
    around = around and not without_ros(evidence)
    examples = not (named or around) and all(places.sample(file.rpartition("/")[0]) for file in files)
    outside = None if named or wrapper or examples else run_outside(evidence)
    reasons: list[Reason] = []
    for version, made in by_version.items():
        if not made:
            continue
        others = len(by_version[3 - version])
        weight = Weight.WRAPPER if wrapper else Weight.EXAMPLES if examples else Weight.PACKAGES
        weight = Weight.NEVER_CALLED if built_by_cmake_alone(evidence, made) or outside else weight
        weight += _leaning(evidence, version, len(made) - others) if others else 0
        number = "a package" if len(made) == 1 else f"{len(made)} packages"
        why = f"{number} built by {'catkin' if version == 1 else 'ament'}"
        why += f", and {page_of(outside.file)} runs only what CMake makes without them" if outside else ""
        why += ", a wrapper beside a Python project" if wrapper else ", which are examples" if examples else ""
        reasons.append(because("kind", f"ros{version}", why, made[0], weight=weight))
    return reasons


def _warnings(evidence: Evidence, kind: Kind, weight: int) -> tuple[Warning_, ...]:
    """Warn about packages of rosbuild beside others, which no build tool builds together, and of a CUDA for nothing.

    And about C++ that nothing says how to compile, or code that another build tool compiles, by the weight of the kind.
    """
    optional = told_of_optional_ros(evidence) if kind in {"python", "cuda"} else ()
    if kind == "python" or (kind == "cpp" and weight in {OTHER_BUILDER, Weight.DEFAULT}):
        otherwise = built_otherwise(evidence) if weight <= Weight.PROGRAM else ()
        open_ = uncompiled(evidence) if weight <= Weight.DEFAULT else ()
        return (*optional, *warnings_of_cuda(evidence), *(otherwise or open_))
    old = next((p for p in evidence.cmake if "rosbuild" in p.macros and not places.test(p.file)), None)
    called = evidence.manifests and by_cmake(evidence)  # CMake may call make in a submodule
    if kind != "ros1" or old is None or called or any(map(of_rosbuild, packages_of(evidence).built)):
        return optional
    message = "rosbuild's packages (manifest.xml) are not built here: catkin does not know them"
    hint = "what they need is installed; build them with rosmake under `custom` in roslab.yaml"
    return (warn(f"{message}; {hint}", old),)


def _leaning(evidence: Evidence, version: int, majority: int) -> int:
    """Return how strongly a repository made for both favours a version: by branch, images, CI, README, packages."""
    sides_of = {name: found.ros for name, found in distros().items()} | {"ros1": 1, "ros2": 2}
    score = Lean.MORE_PACKAGES * (majority > 0) + Lean.NEWER * (version == 2)
    for source, rank in Lean.BY_SOURCE:
        named = (m.value for m in evidence.mentions if m.topic == "distro" and m.source == source)
        if {sides_of[value] for value in named if value in sides_of} == {version}:
            score += rank
    return score


def _meta(evidence: Evidence) -> list[Reason]:
    """Read a repository that only lists others: its vcs files, its submodules and the distributions that pages name.

    A list at the root that only ROS's tools read outweighs requirements; submodules count only if the text uses one of
    ROS's build tools. The branches of a list name distributions, too.
    """
    listed = [source for source in evidence.sources if source.kind == "vcs"]
    named = (*(m.value for m in evidence.mentions if m.topic == "distro"), *(source.ref for source in listed))
    sides = [found.ros for name in named if (found := distro(name))]
    own = [source for source in listed if "/" not in source.file and source.file.endswith((".repos", ".rosinstall"))]
    tools = {m.value for m in evidence.mentions if m.topic == "build_tool"}
    if not listed and not tools.isdisjoint(WORKSPACE_TOOLS) and sides:
        listed = [source for source in evidence.sources if source.kind == "submodule"]
    if not listed or not (sides or own):
        return []
    lead = sides.count(2) - sides.count(1)
    version = 2 if lead > 0 or (lead == 0 and listed[0].file.endswith(".repos")) else 1
    why = f"{len(listed)} repositories to import" + (f", and a ROS {version} distribution is named" if sides else "")
    weight = Weight.OWN_LIST if own and not parts_of_cmake(evidence, own) else Weight.LIST
    return [because("kind", f"ros{version}", why, (own or listed)[0], weight=weight)]


def _python(evidence: Evidence) -> list[Reason]:
    """Return the reasons for plain Python, and for CUDA if there is a framework or CUDA source."""
    place = _python_place(evidence)
    found = sign_of_cuda(evidence)
    reasons = []
    if place:
        at, why, weight = place
        reasons.append(because("kind", "cuda" if found else "python", why, at, weight=weight))
    if found:
        weight = place[2] + Weight.OF_FRAMEWORK if place else Weight.CUDA_SIGN
        reasons.append(because("kind", "cuda", found.why, found, weight=weight))
    return reasons


def _python_place(evidence: Evidence) -> tuple[Placed, str, int] | None:
    """Return the strongest sign of Python: its place, the reason and its weight."""
    for project in evidence.python:
        if project.meant and not places.vendored(project.file):
            weight = Weight.INSTALLABLE_BELOW if project.folder else Weight.INSTALLABLE
            return project, "pip can install it" if project.installable else "it has a setup.py", weight
    for environment in evidence.conda:
        aside = places.vendored(environment.file) or places.test(environment.file)
        if not (aside or to_compile(evidence, environment)):
            weight = Weight.CONDA_BELOW if "/" in environment.file else Weight.CONDA
            return environment, "a conda environment", weight
    for requirement in evidence.requirements:
        if requirement.purpose == "run":
            weight = Weight.REQUIREMENTS_BELOW if "/" in requirement.file else Weight.REQUIREMENTS
            return requirement, "Python requirements", weight
    if run := run_by_page(evidence):
        return run, "a Python program, which the page at the root runs, with nothing of ROS", Weight.RUN
    if evidence.programs:
        return evidence.programs[0], "a Python program", Weight.PROGRAM
    imported = next((d for d in evidence.code if d.namespace == "import"), None)
    return (imported, "Python code", Weight.CODE) if imported else None


def _cpp(evidence: Evidence) -> list[Reason]:
    """Return the reasons that the CMake project nearest to the root gives: C++, or CUDA if it compiles that.

    Without one, those of a Makefile, which is one of C and C++, or of a script that compiles in its place.
    """
    top = top_of(evidence)
    if top is None:
        return _by_make(evidence)
    root = "/" not in top.file
    compiled = "CUDA" in top.languages or evidence.cuda_files
    on_gpu = ("cuda" in top.macros and compiled) or includes_tensorrt(evidence) or for_libtorch(evidence)
    answer = "cuda" if on_gpu else "cpp"
    bindings = any(not project.folder and "cmake" in project.extensions for project in evidence.python)
    if root and bindings and mostly_cpp(evidence) and not only_by_pip(evidence):
        return [because("kind", answer, "a CMake project with Python bindings", top, weight=Weight.BINDINGS)]
    said = None if "rosbuild" in top.macros else built_by_page(evidence)  # rosbuild's packages are made by CMake, too
    if root and said and mostly_cpp(evidence):
        return [
            because(
                "kind",
                answer,
                f"a CMake project, which {page_of(said.file)} builds with CMake alone",
                said,
                weight=Weight.BUILT,
            )
        ]
    most = (mostly_cpp(evidence) or with_helpers(evidence)) and not places.sample(top.file)
    below = Weight.CMAKE_BELOW if most else Weight.CMAKE_PART
    weight = Weight.CMAKE if root and not (left_to_python(evidence) or compiles_nothing(evidence)) else below
    return [because("kind", answer, "a CMake project", top, weight=weight)]


def _by_make(evidence: Evidence) -> list[Reason]:
    for made in evidence.makefiles[:1]:
        answer = "cuda" if made.cuda and evidence.cuda_files else "cpp"
        weight = Weight.CMAKE_BELOW if made.folder else Weight.MAKE
        what = "a script that compiles C++" if made.script else "a Makefile that compiles C++"
        what = f"a project of {made.by}" if made.by else what
        return [because("kind", answer, what, made, weight=weight)]
    return []
