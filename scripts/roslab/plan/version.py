"""The version of projects that take it from git, which is not available in the image's build."""

from __future__ import annotations

import re
from collections.abc import Iterable

from roslab.evidence.python_project import PythonProject
from roslab.values.dataclass import dataclass
from roslab.values.name import canonicalize_name
from roslab.values.pattern import pattern
from roslab.values.version import InvalidVersion, Version

UNKNOWN = "0.1.dev0"
"""If no tag has a version: the first version of setuptools_scm."""
_FILES = frozenset({"PKG-INFO", "git_refnames"})
PLAIN = pattern(r"[A-Za-z0-9_./+-]+")


@dataclass(frozen=True, kw_only=True, slots=True)
class SourceVersion:
    """The version by the tags of the checkout, and the projects that ask for it."""

    version: str
    """As PEP 440 writes it."""
    tag: str
    """The nearest tag with a version, ``""`` if there is none."""
    distributions: tuple[tuple[str, str], ...] = ()
    """Folder and name of each project that reads a source distribution's PKG-INFO."""
    archives: tuple[str, ...] = ()
    """Folders of projects that read the keywords which ``git archive`` fills in."""
    variables: tuple[str, ...] = ()
    """Variables that tools read the version from where there is no git."""


def of_projects(projects: Iterable[PythonProject], folders: Iterable[str]) -> dict[PythonProject, str]:
    """Return the projects in ``folders`` (``.`` for the root) that take their version from git, and what they read."""
    wanted = {"" if folder == "." else folder for folder in folders}
    found = {}
    for project in projects:
        from roslab.knowledge.version_tools import version_tools  # noqa: PLC0415 - few trees compute their version

        reads = next((way for name in _tools(project) if (way := version_tools().get(name))), None)
        if reads and project.folder in wanted:
            found[project] = reads
    return found


def _tools(project: PythonProject) -> list[str]:
    """Return what its tables take a version by, and the canonical names of the packages that its build needs."""
    needed = [asked.key for asked in project.build_requires] + [canonicalize_name(n) for n in project.setup_imports]
    return [*project.version_by, *needed]


def source_version(asking: dict[PythonProject, str], description: tuple[str, int] | None) -> SourceVersion | None:
    """Return the version for the projects that ask, ``None`` where none does.

    ``description`` is the nearest tag and the number of commits since then.
    """
    if not asking:
        return None
    tag, distance = description or ("", 0)
    version = from_tag(tag, distance)
    return SourceVersion(
        version=version or UNKNOWN,
        tag=tag if version and PLAIN.fullmatch(tag) else "",
        distributions=tuple(
            (project.folder, project.name or project.folder.rpartition("/")[2] or "source")
            for project, reads in asking.items()
            if reads == "PKG-INFO"
        ),
        archives=tuple(project.folder for project, reads in asking.items() if reads == "git_refnames"),
        variables=tuple(dict.fromkeys(reads for reads in asking.values() if reads not in _FILES)),
    )


def from_tag(tag: str, distance: int) -> str | None:
    """Return the version of a tag, or the next development version after it; ``None`` if the tag has no version.

    The rule is setuptools_scm's default: https://setuptools-scm.readthedocs.io/en/latest/extending/#version-scheme
    """
    match = re.fullmatch(r"(?:.*?[-_/])?[vV]?(\d[^+]*)(?:\+.*)?", tag)
    try:
        version = Version(match[1]) if match else None
    except InvalidVersion:
        version = None
    if version is None or not distance:
        return str(version) if version else None
    epoch = f"{version.epoch}!" if version.epoch else ""
    if version.pre:
        release = ".".join(map(str, version.release)) + f"{version.pre[0]}{version.pre[1] + 1}"
    else:
        release = ".".join(map(str, (*version.release[:-1], version.release[-1] + 1)))
    return f"{epoch}{release}.dev{distance}"
