"""Projects with which pip stops: a setup.py that reads what is not there, a pyproject.toml that is no valid TOML."""

from __future__ import annotations

import posixpath
from collections.abc import Iterable, Iterator, Mapping
from typing import TYPE_CHECKING, Any

from roslab.evidence.facts import Mention
from roslab.evidence.python_project import PythonProject
from roslab.knowledge.frameworks import released_on
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern
from roslab.values.requirement import Requirement

if TYPE_CHECKING:
    from roslab.evidence.python.setup_py import SetupScript  # it imports Python's own parser

MAX_SIZE = 64 * 1024
_LINKS = pattern(r"[\"']-l([A-Za-z]\w+)[\"']")
_MADE = pattern(r"(?im)^[ \t]*add_library[ \t]*\([ \t]*([A-Za-z]\w*)(?=\s)")
_TOLD = frozenset({"packages", "py_modules", "ext_modules", "package_dir", "pbr", "**"})
"""Arguments of ``setup`` beside which setuptools looks for no packages.

https://setuptools.pypa.io/en/latest/history.html#v61-0-0, read 2026-11-26.
"""


def why_stopped(repository: Repository, folder: str, script: SetupScript, *, setuptools: bool) -> str:
    """Return what stops setuptools, ``""`` for nothing.

    What lies in a submodule may only not be checked out, and what installs programs is left as it is. Where the last
    commit is older than the setuptools that looks for packages, pip's are of that day.
    """
    from roslab.evidence.python.without_module import several  # noqa: PLC0415 - few trees need it

    for name in script.opened:
        path = posixpath.normpath(posixpath.join(folder, name))
        outside = path.startswith(("/", "../"))
        if not outside and not repository.may_have(path) and not _in_submodule(repository, path):
            return f"setup.py reads {path}, which is not there"
    if script.history:
        return f"setup.py stops where `{script.history}` finds no commit, and an image has no history"
    if "ext_modules" in script.arguments and not script.commands and (made := _linked(repository, folder)):
        return f"setup.py links {made}, which CMakeLists.txt beside it compiles, and pip does not"
    beside = any(repository.has(posixpath.join(folder, name)) for name in ("setup.cfg", "pyproject.toml"))
    programs = {"entry_points", "scripts"} & script.arguments
    looks = setuptools and not (
        repository.committed and f"{repository.committed:%Y-%m-%d}" < released_on("setuptools", "61")
    )
    if looks and not beside and not programs and not _TOLD & script.arguments and several(repository, folder):
        return "setup.py names no packages, and setuptools takes none where several folders could be one"
    return ""


def why_refused(data: Mapping[str, Any], wrong: tuple[str, int] | None) -> str:
    """Return why pip refuses a pyproject.toml, ``""`` for nothing; ``wrong``: what its parser says, with the line.

    hatchling takes folders alone: https://hatch.pypa.io/latest/config/build/#packages, read 2026-11-27.
    """
    if wrong:
        return f"pyproject.toml is no valid TOML ({wrong[0]}, line {wrong[1]}), and pip refuses it"
    system = data.get("build-system")
    backend = system.get("build-backend") if isinstance(system, dict) else None
    found: Any = data if str(backend).startswith("hatchling") else None
    for key in ("tool", "hatch", "build", "targets", "wheel", "packages"):
        found = found.get(key) if isinstance(found, dict) else None
    if isinstance(found, list) and any(not isinstance(each, str) for each in found):
        return (
            "tool.hatch.build.targets.wheel.packages of pyproject.toml is no list of folders, and hatchling refuses it"
        )
    return ""


def _linked(repository: Repository, folder: str) -> str:
    """Return the first library that a setup.py hands the linker (``-lplanner``) and that CMake makes beside it."""
    lists = posixpath.join(folder, "CMakeLists.txt")
    text = repository.read(posixpath.join(folder, "setup.py"), limit=MAX_SIZE)
    named = dict.fromkeys(_LINKS.findall(text)) if _LINKS.search(text) and repository.has(lists) else ()
    made = {*_MADE.findall(repository.read(lists, limit=MAX_SIZE))} if named else set()
    return next((name for name in named if name in made), "")


def _in_submodule(repository: Repository, path: str) -> bool:
    return any(path.startswith(f"{each}/") for each in repository.links)


def chosen(projects: Iterable[PythonProject], asked: Iterable[Requirement]) -> list[PythonProject]:
    """Return such a project at the root, and those below that a page has its reader install."""
    pages = [each for each in asked if each.role == "project"]
    named = {posixpath.normpath(each.written.partition("[")[0].strip("\"'")) for each in pages}
    named |= {posixpath.normpath(posixpath.join(posixpath.dirname(each.file), each.written)) for each in pages}
    return [project for project in projects if project.stopped and (not project.folder or project.folder in named)]


def problems(stopped: Iterable[PythonProject]) -> Iterator[tuple[str, str, int]]:
    """Yield a warning for each such project: what it needs is installed, and it is not."""
    for project in stopped:
        message = (
            f"{project.stopped}: what can be read of its needs is installed, and its folder is on PYTHONPATH instead"
        )
        yield message, project.file, project.line


def folders(stopped: Iterable[PythonProject]) -> Iterator[Mention]:
    """Yield the folder of each such project, from which Python imports what was not installed."""
    for project in stopped:
        yield Mention(
            topic="python_path",
            value=project.folder or ".",
            source="manifest",
            file=project.file,
            line=project.line,
            text=project.stopped,
        )
