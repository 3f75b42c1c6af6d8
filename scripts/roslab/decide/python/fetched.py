"""Python projects in submodules that are not checked out: the image clones them, and pip installs them from there."""

from __future__ import annotations

import posixpath
from collections.abc import Iterable, Iterator

from roslab.decide.cuda.signs import sign_of_cuda
from roslab.decide.python.manifests import with_includes
from roslab.decide.python.pins import DEVELOPMENT
from roslab.evidence.facts import Evidence, RequirementFile
from roslab.evidence.python_project import PythonProject
from roslab.values.dataclass import replace
from roslab.values.requirement import Requirement


def with_fetched(evidence: Evidence) -> Evidence:
    """Return the evidence with a project for each folder of a missing submodule that a page or another file installs.

    What such a folder holds is unknown: it may compile, beside torch also for the GPU.
    """
    absent = _absent(evidence)
    known = {project.folder for project in evidence.python}
    extensions = ("c", "cuda") if sign_of_cuda(evidence) and _on_torch(evidence) else ("c",)
    added: dict[str, PythonProject] = {}
    for asked, folder in _folders(evidence) if absent else ():
        ends = [name for name in absent if name.endswith(f"/{folder}")]  # of `cd REPOSITORY/sub/a` only `a` is known
        path = _inside(absent, folder) or (ends[0] if len(ends) == 1 else "")
        if path and path not in known:
            added.setdefault(
                path,
                PythonProject(
                    file=asked.file,
                    line=asked.line,
                    folder=path,
                    name=None,
                    installable=True,
                    requires_python=None,
                    build_requires=(),
                    requirements=(),
                    extensions=extensions,
                ),
            )
    return replace(evidence, python=(*evidence.python, *added.values())) if added else evidence


def unseen(evidence: Evidence, projects: Iterable[PythonProject]) -> tuple[str, ...]:
    """Return the folders of those projects that lie in a missing submodule: whether pip finds one there is unknown."""
    absent = _absent(evidence)
    return tuple(project.folder for project in projects if _inside(absent, project.folder) == project.folder != "")


def cloned_files(evidence: Evidence, files: Iterable[RequirementFile] = ()) -> tuple[str, ...]:
    """Return the requirement files of missing submodules that the installed ``files`` include, or pages at the root.

    In the order in which they are named.
    """
    absent = _absent(evidence)
    named = [path for _, path in lacking(evidence, files)]
    asked_for = [each for each in evidence.prose_pip if each.role == "file" and _near(each)]
    named += [path for each in asked_for if not _of_tree(path := posixpath.normpath(each.written), evidence)]
    return tuple(dict.fromkeys(path for name in named if (path := _inside(absent, name))))


def _of_tree(path: str, evidence: Evidence) -> bool:
    """Tell whether a page means a file of the tree: it goes back to the root in words, and from there to a folder."""
    return any("/" in each.file and path.endswith(f"/{each.file}") for each in evidence.requirements)


def lacking(evidence: Evidence, files: Iterable[RequirementFile]) -> list[tuple[RequirementFile, str]]:
    """Return what the files, or those that they include, include and the tree does not have, each with its file."""
    known = {file.file for file in evidence.requirements}
    return [(file, path) for file in with_includes(evidence, files) for path in file.includes if path not in known]


def _near(asked: Requirement) -> bool:
    return asked.file.count("/") <= 1 and not DEVELOPMENT.search(asked.file)


def _absent(evidence: Evidence) -> tuple[str, ...]:
    return tuple(git.name for git in evidence.sources if git.kind == "submodule" and git.absent)


def _inside(absent: tuple[str, ...], path: str) -> str:
    """Return a path from the root if it lies in one of these folders, ``""`` for all others."""
    place = next((name for name in absent if f"/{name}/" in f"/{path}/"), None)
    return path[path.index(place) :] if place else ""


def _on_torch(evidence: Evidence) -> bool:
    """Tell whether anything imports or installs torch: its extensions are built with the torch that is there."""
    asked = [*evidence.prose_pip, *(each for file in evidence.requirements for each in file.requirements)]
    asked += [each for project in evidence.python for each in project.requirements]
    asked += [each for environment in evidence.conda for each in environment.requirements]
    packages = {package.name for environment in evidence.conda for package in environment.packages}
    used = any(each.namespace == "import" and each.name == "torch" for each in evidence.code)
    return used or bool({"torch", "pytorch"} & packages) or any(each.key == "torch" for each in asked)


def _folders(evidence: Evidence) -> Iterator[tuple[Requirement, str]]:
    """Yield every line that installs a folder, with its path."""
    for asked in evidence.prose_pip:
        if asked.role == "project":
            yield asked, posixpath.normpath(asked.written.partition("[")[0])
    for file in evidence.requirements:
        for asked in file.requirements if file.purpose == "run" else ():
            if asked.role == "project":
                yield asked, posixpath.normpath(asked.written.partition("[")[0])
    for environment in evidence.conda:
        for asked in environment.requirements:
            if asked.role == "project":
                yield asked, posixpath.normpath(posixpath.join(environment.file.rpartition("/")[0], asked.written))
