"""Everything that a repository needs beyond its rosdep keys, the most certain first."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from roslab.config.model import Kind
from roslab.decide.python.library_modules import OF_MODULE
from roslab.decide.ros.other_dockerfiles import distros_of
from roslab.decide.ros.workspace import Packages
from roslab.decide.system.by_make import builds_all
from roslab.decide.system.compiled_libraries import needs_of_libraries
from roslab.decide.system.documentation import without_documentation
from roslab.decide.system.names import written_for
from roslab.decide.system.required import programs
from roslab.decide.system.stated_pythons import without_pythons
from roslab.decide.system.switches import given, switched_off
from roslab.decide.system.tests import always_compiled, always_of_packages
from roslab.decide.system.unreached import unreached
from roslab.evidence import places
from roslab.evidence.dependency import Dependency, Strength
from roslab.evidence.facts import Evidence
from roslab.evidence.prose.called_in_scripts import IN_SCRIPT, PYTHON
from roslab.evidence.python.of_python3 import ROLE, ROLE_ELSEWHERE
from roslab.knowledge.authors_own import authors_own
from roslab.knowledge.compiled import programs as packaged
from roslab.knowledge.cuda_toolkits import host_compilers
from roslab.knowledge.distros import ubuntus_with_python2
from roslab.knowledge.frameworks import imports
from roslab.knowledge.libraries import library, qt_modules
from roslab.knowledge.released import ever_released, released
from roslab.values.dataclass import replace
from roslab.values.name import canonicalize_name
from roslab.values.pattern import pattern

TOOLKIT = "nvidia-cuda-toolkit"
ON_CUDA = "cuda"
"""Role of what compiles for CUDA."""
QMAKE = "qt5-qmake"
_OF_CODE = frozenset(
    {
        *("backend", "called", "configure", "fetch", "first_line", "in_script", "latex", "linked", "run"),
        *("session_script", "typelib"),
    }
)
"""Roles of packages that the code itself shows."""
_HEADERS = pattern(r"lib[a-z-]+-dev")
_STARTED = pattern(
    r"\b(?:rosrun|roslaunch|ros2\s+(?:run|launch|component\s+standalone))\s+(?:--?\S+\s+)*([a-z][a-z0-9_]+)\s"
)


def needs(
    evidence: Evidence, packages: Packages, kind: Kind, ros_distro: str | None
) -> Iterator[tuple[Dependency, bool]]:
    """Yield each need, and whether it is trusted: whether the build really uses the file that names it."""
    return without_documentation(_all(evidence, packages, kind, ros_distro))


def _all(
    evidence: Evidence, packages: Packages, kind: Kind, ros_distro: str | None
) -> Iterator[tuple[Dependency, bool]]:
    yield from _cmake(evidence, packages, compiled=kind in {"ros1", "ros2", "cpp"})
    for dependency in always_compiled(evidence) if kind == "cpp" else ():
        yield dependency, True
    if kind in {"ros1", "ros2"}:
        folders = frozenset(manifest.file.rpartition("/")[0] for manifest in packages.built)
        yield from ((dependency, True) for dependency in always_of_packages(evidence, folders))
    for dependency in evidence.code:
        # Others have a `python` of their own
        started_by = kind in {"ros1", "ros2"} and dependency.role in {"shebang", ROLE, ROLE_ELSEWHERE}
        elsewhere = dependency.name == PYTHON and kind not in {"ros1", "ros2"}
        if dependency.namespace == "include" or started_by or (dependency.role in _OF_CODE and not elsewhere):
            yield dependency, False
    yield from ((asked, True) for asked in evidence.code if asked.role == OF_MODULE)
    for dependency in _made(evidence) if kind in {"cpp", "cuda"} else ():
        yield dependency, dependency.strength == "declared"
    for dependency in needs_of_libraries(evidence) if kind != "python" else ():
        yield dependency, dependency.required
    for dependency in (*_programs(evidence, packages, kind), *started(evidence, kind)):
        yield dependency, False
    for dependency in without_pythons(_installed(evidence, ros_distro), kind):
        yield dependency, False


def _programs(evidence: Evidence, packages: Packages, kind: Kind) -> Iterator[Dependency]:
    """Yield the packages of the programs without which CMake stops."""
    for _, asked in programs(evidence, packages, kind):
        if apt := packaged().get(asked.name):
            yield replace(asked, namespace="apt", name=apt)


def of_another_python(dependency: Dependency, ubuntu: str | None) -> bool:
    """Tell whether a program or a script asks for nothing: for ``python`` where that is 2, for 3 where ROS's is 3."""
    of_python2 = ubuntu in ubuntus_with_python2()
    plain = dependency.role in {"shebang", IN_SCRIPT} and dependency.name == PYTHON
    return (plain and (of_python2 or ubuntu is None)) or (dependency.role in {ROLE, ROLE_ELSEWHERE} and not of_python2)


def _made(evidence: Evidence) -> Iterator[Dependency]:
    """Yield what Makefiles link and ask pkg-config for, that program itself, Qt with qmake, and what Autotools are."""
    whole = builds_all(evidence)
    for made in evidence.makefiles:
        asked: Strength = "declared" if made is whole else "used"
        for name in made.linked:
            yield Dependency(namespace="link", name=name, strength="used", file=made.file, line=1, role="build")
        for name in made.modules:
            yield Dependency(namespace="pkg-config", name=name, strength=asked, file=made.file, line=1, role="build")
        for name in filter(None, (qt_modules().get(each) for each in made.qt)):
            yield Dependency(namespace="cmake", name=name, strength="used", file=made.file, line=1, role="build")
        if made.qt:
            yield Dependency(namespace="apt", name=QMAKE, strength="used", file=made.file, line=1, role="make")
        for name in made.tools:
            yield Dependency(namespace="apt", name=name, strength=asked, file=made.file, line=1, role="make")
        if made.modules and "pkg-config" not in made.tools:
            yield Dependency(namespace="apt", name="pkg-config", strength="used", file=made.file, line=1, role="make")


def compiler_of_cuda(evidence: Evidence, packages: Packages, kind: Kind, ubuntu: str | None) -> Iterator[Dependency]:
    """Yield Ubuntu's own toolkit of CUDA where CMake stops without one, in what is built, and a compiler that it takes.

    https://packages.ubuntu.com/search?keywords=nvidia-cuda-toolkit
    """
    compiler = host_compilers().get(ubuntu or "")
    folders = frozenset(manifest.file.rpartition("/")[0] for manifest in packages.built)
    other = unreached(evidence, by_page=False)
    for project in evidence.cmake if kind in {"ros1", "ros2", "cpp"} else ():
        path = project.file
        aside = places.aside(path) or path in other
        if "cuda" in project.macros and not aside and (not folders or "" in folders or _inside(path, folders)):
            asked = project.line
            for name in (TOOLKIT, compiler) if compiler else (TOOLKIT,):
                sure: Strength = "declared" if project.cuda else "used"
                yield Dependency(namespace="apt", name=name, strength=sure, file=path, line=asked, role=ON_CUDA)


def host_options(apt: Iterable[str], ubuntu: str | None) -> tuple[str, ...]:
    """Return what tells CMake the compiler that Ubuntu's own toolkit of CUDA takes; nothing without that toolkit.

    FindCUDA has the first, CUDA as a language the second: https://cmake.org/cmake/help/v3.10/module/FindCUDA.html
    https://cmake.org/cmake/help/latest/variable/CMAKE_LANG_HOST_COMPILER.html
    """
    compiler = host_compilers().get(ubuntu or "")
    variables = ("CUDA_HOST_COMPILER", "CMAKE_CUDA_HOST_COMPILER") if compiler and TOOLKIT in apt else ()
    return tuple(f"-D{variable}=/usr/bin/{compiler}" for variable in variables)


def code_needs(evidence: Evidence, packages: Packages) -> Iterator[Dependency]:
    """Yield what CMake files look for, except in vendored code and in packages that are not built.

    What an option switches off with which a page configures the project is left out, too, and what no build comes to.
    Of vendored code that is always a part of the build, what it requires.
    """
    options = given(evidence)
    skipped = frozenset((*(m.file.rpartition("/")[0] for m in packages.left_out if m.ignored), *packages.doubles))
    folders = frozenset(m.file.rpartition("/")[0] for m in evidence.manifests) or frozenset({""})
    other = unreached(evidence)
    for project in evidence.cmake:
        vendored = places.vendored(project.file)
        # Nothing builds what has neither its code nor a package.xml, beside packages
        alone = project.top_level and project.lacks and not _inside(project.file, folders)
        if (vendored and not project.always) or alone or project.file in other or _inside(project.file, skipped):
            continue
        for dependency in project.dependencies:
            if vendored and dependency.strength != "declared":
                continue
            unasked = dependency.role == "test" or switched_off(dependency, options)
            if not unasked and dependency.name not in packages.names:
                yield dependency


def _cmake(evidence: Evidence, packages: Packages, *, compiled: bool) -> Iterator[tuple[Dependency, bool]]:
    folders = frozenset(manifest.file.rpartition("/")[0] for manifest in packages.built)
    for dependency in code_needs(evidence, packages):
        path = dependency.file
        below = _below(path, folders)  # a package in a folder of examples is built as the others
        aside = places.example(below) or places.test(below) or places.documentation(below)
        if compiled or not aside:
            yield dependency, compiled and not aside and (not folders or _inside(path, folders))


def _below(path: str, folders: frozenset[str]) -> str:
    """Return a path from the innermost of the folders that it lies in, the whole path where it lies in none."""
    folder = path
    while folder:
        folder = folder.rpartition("/")[0]
        if folder and folder in folders:
            return path[len(folder) + 1 :]
    return path


def _inside(path: str, folders: frozenset[str]) -> bool:
    """Tell whether a path lies in one of the folders; the cost grows with its depth, not with the number of folders."""
    folder = path
    while folders and folder:
        folder = folder.rpartition("/")[0]
        if folder in folders:
            return True
    return False


def started(evidence: Evidence, kind: Kind) -> Iterator[Dependency]:
    """Yield the ROS packages that launch and parameter files name, that Python imports, and that pages say to run."""
    if kind not in {"ros1", "ros2"}:
        return
    for launch in evidence.launch:
        if kind == f"ros{launch.ros}":  # a ported repository may keep launch files of the other version
            yield from (*launch.dependencies, *launch.reached)
    for dependency in evidence.code:
        if dependency.namespace == "ros":
            yield dependency
        elif dependency.namespace == "import" and _of_ros(dependency.name):
            yield replace(dependency, namespace="ros", role="exec")
    for mention in evidence.mentions:
        if mention.topic == "command" and (match := _STARTED.search(mention.text)):
            yield Dependency(
                namespace="ros", name=match[1], strength="prose", file=mention.file, line=mention.line, role="exec"
            )


def _of_ros(module: str) -> bool:
    """Tell whether a ROS package of a module's name may bring it: none does where Ubuntu has it by another name.

    ``serial`` is pyserial's, which apt has too, and ROS's serial is a library of C++. Of a name that PyPI has, like
    ``numpy``, and of one that CMake knows a library of C by, only one that was released is a package of ROS.
    """
    package, apt = imports().get(module, (None, None))
    if package and apt and canonicalize_name(package) != canonicalize_name(module):
        return False
    return not (package or library("cmake", module, None)) or ever_released(module)


def _lacking(asked: Dependency, ros_distro: str | None) -> bool:
    """Tell whether a page only links to a package that the distribution does not have."""
    there = released(ros_distro or "")
    name = asked.name.removeprefix("ros-{distro}-").replace("-", "_")
    return asked.role == "named" and written_for(asked.name) == "{distro}" and bool(there) and name not in there


def _installed(evidence: Evidence, ros_distro: str | None) -> Iterator[Dependency]:
    """Yield what pages, CI and the author's Dockerfiles install by apt.

    If a page has lines for this distribution, its lines for other distributions do not count; of the Dockerfiles for
    others, if one is for this, only the headers of libraries do that have no release in their names, and so it is with
    the files of CI.
    """
    written = [each for each in evidence.prose if each.namespace == "apt" and not _lacking(each, ros_distro)]
    ours = {d.file for d in written if ros_distro and written_for(d.name) == ros_distro}
    fits = {ros_distro, "{distro}", None}
    others = {d.file for d in written if ours and d.file.endswith(places.OF_CI) and written_for(d.name) not in fits}
    others -= {d.file for d in written if d.file in ours or written_for(d.name) == "{distro}"}
    written = [each for each in written if each.file not in others or _HEADERS.fullmatch(each.name)]
    used = {m.value.split(" ")[0] for m in evidence.mentions if m.topic in {"command", "session", "started"}}
    ros, asked = ros_distro is not None, (each for project in evidence.cmake for each in project.dependencies)
    latex = any(each.name == "LATEX" and each.strength == "declared" for each in asked)
    own = authors_own(ros=ros, page=True, latex=latex)
    for dependency in written:
        if own.match(dependency.name) and dependency.name not in used:
            continue
        if dependency.file not in ours or written_for(dependency.name) in fits:
            yield dependency
    own = authors_own(ros=ros, latex=latex)
    authors = [authored for authored in evidence.dockerfiles if authored.purpose in {"project", "ci"}]
    of = [distros_of(authored, evidence) if ros_distro else frozenset() for authored in authors]
    fitting = any(ros_distro in names for names in of)
    for authored, names in zip(authors, of, strict=True):
        whole = not fitting or ros_distro in names or not names
        for dependency in authored.dependencies:
            name = dependency.name
            meant = dependency.namespace == "apt" and (whole or _HEADERS.fullmatch(name))
            if meant and not (own.match(name) and name not in used):
                yield dependency
