"""Submodules that nobody has seen and that are called like a module which the code imports: pip may install them.

A page clones such a repository, builds it and leaves the rest to its reader: the package lies at its top or in the
folder of the module's name. What has neither setup.py nor pyproject.toml, or what pip cannot install, is left out.
So is what has a package.xml beside packages of ROS; of plain Python their tools would install nothing that it needs.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator

from roslab.config.model import Kind
from roslab.decide.decision import Warning_
from roslab.decide.python.on_index import on_index
from roslab.decide.reasons import warn
from roslab.evidence import places
from roslab.evidence.dependency import Dependency, GitSource
from roslab.evidence.facts import Evidence
from roslab.evidence.python_project import PythonProject
from roslab.knowledge.frameworks import imports
from roslab.knowledge.released import ever_released
from roslab.values.dataclass import replace
from roslab.values.name import bare_name, canonicalize_name

_CODE = (".py", ".ipynb")
SEVERAL = 3
"""Fewest projects in submodules that a page installs for several purposes."""
SHORTEST = 4
"""Fewest letters of a module that a repository is called after by more than chance."""


def with_imported(evidence: Evidence, kind: Kind) -> Evidence:
    """Return the evidence with a project for each folder where such a module may lie, unless a page installs one.

    Beside packages of ROS none that a package.xml asks for, or that any distribution released: that is a package, too.
    """
    if kind == "cpp":
        return evidence
    ros = kind in {"ros1", "ros2"}
    packages = {each.name for m in evidence.manifests for each in m.dependencies} if ros else set()
    known = {project.folder for project in evidence.python}
    added: dict[str, PythonProject] = {}
    for git, used in _called_like(evidence):
        if ros and (used.name in packages or ever_released(used.name)):
            continue
        if not any(folder.rpartition("/")[0] == git.name or folder == git.name for folder in known):
            for folder in (git.name, f"{git.name}/{used.name}"):
                added.setdefault(folder, _project(folder, used))
    return replace(evidence, python=(*evidence.python, *added.values())) if added else evidence


def imported(projects: Iterable[PythonProject]) -> tuple[str, ...]:
    """Return the folders of those projects: what asks for them is a module of another folder."""
    return tuple(each.folder for each in projects if each.file.endswith(_CODE) and not _at(each.folder, each.file))


def may_fail(projects: Iterable[PythonProject], unseen: Iterable[str]) -> tuple[str, ...]:
    """Return the folders of the projects in submodules (``unseen``) that stop no image where pip cannot install them.

    Those that an import alone speaks for, and all of a page that installs several: each is for one of its methods, and
    nobody has seen whether they go together.
    """
    absent, projects = frozenset(unseen), tuple(projects)
    pages = Counter(each.file for each in projects if each.folder in absent)
    several = {each.folder for each in projects if each.folder in absent and pages[each.file] >= SEVERAL}
    folders = several.union(imported(projects))
    return tuple(dict.fromkeys(each.folder for each in projects if each.folder in folders))


def unread(projects: Iterable[PythonProject]) -> Iterator[Warning_]:
    """Yield a warning for each module that may come from such a submodule, at its first import."""
    found = {each.folder: each for each in projects}
    for folder in imported(projects):
        above, _, module = folder.rpartition("/")
        if above in found and above in imported(found.values()):
            message = f"{module} is imported, and {above}, which is not checked out, is called like it: pip installs it"
            advice = (
                "from there where it can, and what imports it may stop where it cannot; check it out to have it read"
            )
            yield warn(f"{message} {advice}", found[folder])


def _at(folder: str, file: str) -> bool:
    return file.rpartition("/")[0] == folder


def _called_like(evidence: Evidence) -> Iterator[tuple[GitSource, Dependency]]:
    """Yield each missing submodule with the first module that has its name or its first words, and is in no table.

    ``deoxys`` of ``deoxys_control``.
    """
    used = [each for each in evidence.code if _unknown(each, evidence)]
    asked = {each.key for each in evidence.prose_pip if each.name}
    for git in evidence.sources:
        if git.kind == "submodule" and git.absent:
            name = canonicalize_name(git.name.rpartition("/")[2])
            for each in used:
                module = canonicalize_name(each.name)
                same = bare_name(module) == bare_name(name) or f"{name}-".startswith(f"{module}-")
                if same and len(module) >= SHORTEST and module not in asked:
                    yield git, each
                    break


def _unknown(used: Dependency, evidence: Evidence) -> bool:
    counts = used.namespace == "import" and used.strength == "used" and not places.aside(used.file)
    return counts and used.name not in imports() and not on_index(evidence, used)


def _project(folder: str, used: Dependency) -> PythonProject:
    return PythonProject(
        file=used.file,
        line=used.line,
        folder=folder,
        name=None,
        installable=True,
        requires_python=None,
        build_requires=(),
        requirements=(),
    )
