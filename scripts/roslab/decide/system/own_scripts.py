"""Scripts of the tree that the README of Python or C++ runs to compile something: the image runs them too."""

from __future__ import annotations

import posixpath
import shlex
from collections.abc import Collection, Iterator

from roslab.config.model import Config, Kind
from roslab.decide.beside_cpp import of_cpp
from roslab.decide.decision import Choice, OwnScript
from roslab.decide.linked_projects import linked_projects
from roslab.decide.linking_projects import linking
from roslab.decide.programs import beside_top, found_by, names_of, top_of
from roslab.decide.reasons import because, page_of, warn
from roslab.decide.ros.linked_in_place import linked_in_place
from roslab.decide.ros.own_configs import required_of_tree
from roslab.decide.system.beside_python import compiled_beside
from roslab.decide.system.by_make import builds_all
from roslab.decide.system.copied_files import with_copied_files
from roslab.decide.system.generated_code import with_generated_code
from roslab.decide.system.inside import installed_inside, meant
from roslab.decide.system.made_by_pages import with_made_by_pages
from roslab.decide.system.names import Target
from roslab.decide.system.run_by_pages import ASIDE, MOST, by_author, by_make_alone, run_by_pages, script_of
from roslab.decide.system.system_libraries import with_system_libraries
from roslab.evidence.cmake_project import CMakeProject
from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import Evidence
from roslab.evidence.makefile import Makefile
from roslab.values.dataclass import replace
from roslab.values.origin import Place
from roslab.values.pattern import pattern
from roslab.values.words import written

WEIGHT = 300
"""Sources do not compete, so it only orders the report."""
_INSTALLS = pattern(r"(?:^|/)(?:build|make|compile|install)(?:[_-]\w+)*\.(?:ba)?sh$")
"""Such scripts of a submodule as a page calls before make: without what they compile, make has nothing to link."""
_ANEW = "make --always-make"
_QMAKE = "QT_SELECT=5 qmake"
"""qtchooser, which is ``qmake`` on Ubuntu, starts that of Qt 4 without it where no package says otherwise."""
_INSTALL = "its own `install` compiles, which an editable installation does not run"
_LATER = "it needs {}, which the project installs"
_LEFT = (
    "the page has CMake compile {folder}, which the image does not: it asks for {lacks}, which the image lacks; "
    "compile it under `custom` in roslab.yaml"
)
_PLAIN_OPTION = pattern(r"-D\w+(?::\w+)?=[\w.+-]+")


def decide_scripts(
    evidence: Evidence,
    config: Config,
    kind: Kind,
    inside: Choice[tuple[tuple[str, str], ...]],
    projects: Collection[str] = (),
    *,
    target: Target,
) -> Choice[tuple[OwnScript, ...]]:
    """Return the steps that compile beside the project, after the copies of headers and settings.

    ``projects``: folders that pip installs editable, which compiles what their setup.py does. None where the author
    builds by commands of his own.
    """
    if by_author(config):
        return Choice(answer=())
    compiled = frozenset((*(folder for folder, _ in inside.answer), *(reason.file for reason in inside.reasons)))
    choice = _compiling(evidence, config, kind, compiled, projects, target=target)
    if kind != "python":
        choice = with_generated_code(choice, evidence)
    choice = with_copied_files(choice, evidence)
    return choice if kind == "python" else with_system_libraries(choice, evidence)


def _compiling(
    evidence: Evidence,
    config: Config,
    kind: Kind,
    compiled: frozenset[str | None],
    projects: Collection[str],
    *,
    target: Target,
) -> Choice[tuple[OwnScript, ...]]:
    """Return the scripts that the pages nearest to the root run to compile, in their order; none where ROS does it.

    Catkin does not build what has no package.xml: a project that its packages find by its name is installed before.

    What has Makefiles in place of CMake is compiled by make.

    What has CMakeLists.txt in a folder beside Python's code, and a page that compiles it, is compiled there.

    Of a C++ project only those of copied libraries and submodules: CMake compiles the project itself, and the folders
    that are ``compiled`` inside of it too.
    """
    if kind not in {"python", "cuda", "cpp"}:
        return with_made_by_pages(_of_packages(evidence, target, compiled, kind), evidence)
    listed = evidence.python or evidence.requirements or evidence.conda
    if by_make_alone(evidence, kind):
        return _made(evidence, kind)
    chosen = [
        (script, mention)
        for script, mention in run_by_pages(evidence, config, kind)
        if not (_is_setup(script) and (script.folder or ".") in projects)
        and (kind != "cpp" or not {script.folder, script.path} & compiled)
    ][:MOST]
    wanted = frozenset[str]().union(*map(found_by, evidence.cmake))
    needing = linking(evidence, top_of(evidence)) if kind == "cpp" else ()
    later = [(replace(_part(project, found=False), after=True), asked) for project, asked in needing]
    others = [project for project in beside_top(evidence) if kind == "cpp" and project not in {p for p, _ in needing}]
    parts = [_part(project, found=bool(names_of(project) & wanted)) for project in others]
    parts = [part for part in parts if part.folder not in compiled]
    done = compiled | {part.folder for part in parts} | {script.folder for script, _ in chosen}
    linked = [(_first(_part(p, found=True)), a) for p, a in linked_projects(evidence) if kind in {"cpp", "cuda"}]
    linked = [(part, asked) for part, asked in linked if part.folder not in done]
    of_pages = compiled_beside(evidence, target) if kind == "python" or (kind == "cuda" and listed) else ()
    itself = kind == "cuda" and of_cpp(evidence)  # CMake compiles the one at the root
    said_so = [
        each for each in of_pages if not ASIDE.search(each[1].heading) and not (itself and "/" not in each[0].file)
    ]
    beside = [(_part(project, found=False, options=m.text), m) for project, m, lacks in said_so if not lacks]
    built = list(_by_install(evidence, projects))
    other = "a CMake project beside the one that is compiled"
    return Choice(
        answer=(
            *built,
            *(script for script, _ in chosen),
            *(part for part, _ in linked),
            *parts,
            *(part for part, _ in beside),
            *(part for part, _ in later),
        ),
        reasons=(
            *(because("source", s.path, _INSTALL, Place(file=s.path, line=1), weight=WEIGHT) for s in built),
            *(
                because("source", script.path, f"{page_of(mention.file)} runs it to compile", mention, weight=WEIGHT)
                for script, mention in chosen
            ),
            *(because("source", p.folder, f"what is built links {a.name}", a, weight=WEIGHT) for p, a in linked),
            *(because("source", part.folder, other, Place(file=part.path, line=1), weight=WEIGHT) for part in parts),
            *(because("source", part.folder, "the page has CMake compile it", m, weight=WEIGHT) for part, m in beside),
            *(because("source", part.folder, _LATER.format(a.name), a, weight=WEIGHT) for part, a in later),
        ),
        warnings=tuple(
            warn(_LEFT.format(folder=project.file.rpartition("/")[0] or "the root", lacks=lacks), m)
            for project, m, lacks in said_so
            if lacks
        ),
    )


def _is_setup(script: OwnScript) -> bool:
    return posixpath.basename(script.path) == "setup.py"


def _first(script: OwnScript) -> OwnScript:
    """Return how a library of the tree is installed for what links it, which cannot be built without it."""
    return replace(script, command=f"{script.command} && ldconfig", required=True)


def _of_packages(
    evidence: Evidence, target: Target, compiled: frozenset[str | None], kind: Kind
) -> Choice[tuple[OwnScript, ...]]:
    """Return how each project is made that a package of the workspace needs and that no tool of ROS builds.

    It is one that catkin finds once it is installed, or one whose library is linked where it is compiled. The build
    stops where it fails: the tool would stop later, with another cause.
    """
    found = [
        (_part(project, found=True, options=_said_of(project, evidence)), asked)
        for project, asked in (required_of_tree(evidence, target) if kind == "ros1" else ())
    ]
    done = compiled | {script.folder for script, _ in found}
    linked = [
        (_in_place(project, evidence), path, place)
        for project, path, place in linked_in_place(evidence)
        if project.file.rpartition("/")[0] not in done
    ]
    why, why_linked = "{} {} {}, which it installs", "{} links {}, which is compiled there"
    return Choice(
        answer=(
            *(replace(_first(script), required=asked.required) for script, asked in found),
            *(script for script, _, _ in linked),
        ),
        reasons=(
            *(
                because(
                    "source", s.folder or ".", why.format(asked.file, _how(asked), asked.name), asked, weight=WEIGHT
                )
                for s, asked in found
            ),
            *(
                because("source", s.folder, why_linked.format(place.file, path), place, weight=WEIGHT)
                for s, path, place in linked
            ),
        ),
    )


def _how(asked: Dependency) -> str:
    return "links" if asked.namespace == "link" else "requires"


def _in_place(project: CMakeProject, evidence: Evidence) -> OwnScript:
    """Return how a library is compiled where a package links it, and installed where a page does that, too."""
    installs = bool(installed_inside(evidence, ((project.file.rpartition("/")[0], ""),)))
    script = _part(project, found=installs, options=_said_of(project, evidence))
    return _first(script) if installs else replace(script, required=True)


def _said_of(project: CMakeProject, evidence: Evidence) -> str:
    """Return the options with which a page compiles a project, without where to install it."""
    folder = project.file.rpartition("/")[0]
    said = (m for m in evidence.mentions if m.topic == "compiled" and m.source == "readme")
    options = next((m.text for m in said if folder and meant(m.value, {folder})), "")
    return " ".join(word for word in options.split() if _PLAIN_OPTION.fullmatch(word) and "_PREFIX" not in word)


def _by_install(evidence: Evidence, projects: Collection[str]) -> Iterator[OwnScript]:
    """Yield the call of each setup.py whose ``install`` compiles, with pip's own options: its needs are there."""
    for project in evidence.python:
        how = next((each for each in project.extensions if each.startswith("by install")), None)
        if how and (project.folder or ".") in projects:
            options = " --single-version-externally-managed --record /dev/null" if how.endswith("setuptools") else ""
            yield OwnScript(folder=project.folder, path=project.file, command=f"python3 setup.py install{options}")


def _part(project: CMakeProject, *, found: bool, options: str = "") -> OwnScript:
    """Return how CMake compiles a project where it lies, and installs it where another one finds it by its name.

    ``options`` are those of a page, of which paths of its author's computer are left out.
    """
    folder = project.file.rpartition("/")[0]
    said = [
        shlex.quote(written(word)) for word in options.split() if "=/" not in word and "CMAKE_BUILD_TYPE" not in word
    ]
    cmake = " ".join(("cmake -DCMAKE_BUILD_TYPE=Release", *said, ".."))
    make = f'mkdir --parents build && cd build && {cmake} && make --jobs="$(compile-jobs)"'
    return OwnScript(folder=folder, path=project.file, command=f"{make} install" if found else make)


def _make(made: Makefile) -> str:
    """Return the call of make, with the target that a page names; what Autotools configured is installed."""
    if made.configured:
        return f'{made.configured} && make --jobs="$(compile-jobs)" && make install && ldconfig'
    call = f"{_QMAKE} && make" if made.qt else _ANEW if made.stale else "make"
    return f"{call} {made.target}" if made.target else call


def _made(evidence: Evidence, kind: Kind) -> Choice[tuple[OwnScript, ...]]:
    """Return the call of make in each folder whose Makefile builds the project, or the scripts that do in its place.

    Of scripts the first is the build, and so is the one Makefile at the root of a tree of C++: without what it makes,
    the image has nothing to run. Before it, the scripts of submodules that a page has the reader call.
    """
    made = evidence.makefiles
    why = "its Makefile compiles the project"
    absent = tuple(git.name for git in evidence.sources if git.kind == "submodule" and git.absent)
    said = (m for m in evidence.mentions if m.topic == "build_script" and m.source == "readme" and not m.files)
    first = {s.path: (s, m) for m in said if not ASIDE.search(m.heading) and (s := script_of(m, absent, _INSTALLS))}
    return Choice(
        answer=(
            *(script for script, _ in first.values()),
            *(
                OwnScript(
                    folder=each.folder,
                    path=each.file,
                    command=each.script or _make(each),
                    required=each is made[0] if each.script else kind == "cpp" and builds_all(evidence) is each,
                    by_compiler=each.alone,
                )
                for each in made
            ),
        ),
        reasons=(
            *(because("source", s.path, "a page runs it before make", m, weight=WEIGHT) for s, m in first.values()),
            *(
                because("source", each.file, "a page runs it to compile" if each.script else why, each, weight=WEIGHT)
                for each in made
            ),
        ),
    )
