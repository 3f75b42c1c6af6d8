"""An author's Dockerfile that upgrades pip without a bound, and then builds what today's pip builds otherwise."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator

from roslab.decide.python.manifests import with_includes
from roslab.evidence.facts import AuthorDockerfile, Evidence, RequirementFile
from roslab.evidence.python_project import PythonProject
from roslab.knowledge.frameworks import build_needs, imports
from roslab.knowledge.tools import ALWAYS_ISOLATED, ALWAYS_ISOLATED_SINCE, INSTALLERS
from roslab.values.name import canonicalize_name
from roslab.values.requirement import Requirement


def bounded_pips(authored: AuthorDockerfile, evidence: Evidence) -> dict[str, str]:
    """Return the bases whose pip must stay below ``ALWAYS_ISOLATED``, each with the reason.

    There the author's pip was an older one, which built a setup.py beside what is installed: the last commit is of
    before that release. Without a commit nothing is known.
    """
    last = next((each.value for each in evidence.worked_on if each.source == "commit"), None)
    if not authored.newest_pips or last is None or last >= ALWAYS_ISOLATED_SINCE:
        return {}
    found: dict[str, str] = {}
    for base, line in authored.newest_pips:
        if base in found:
            continue
        for what, needs in _built(authored, evidence, line):
            found[base] = (
                f"line {line} upgrades pip to the newest, and since {ALWAYS_ISOLATED} ({ALWAYS_ISOLATED_SINCE}) that"
                f" builds {what} without the {needs} that is installed"
            )
            break
    return found


def files_of(authored: AuthorDockerfile, evidence: Evidence) -> list[RequirementFile]:
    """Return the requirement files of the tree that a Dockerfile installs, with what they include."""
    named = [each.written for each in authored.requirements if each.role == "file"]
    return with_includes(evidence, (file for written in named for file in _file(written, evidence)))


def _built(authored: AuthorDockerfile, evidence: Evidence, line: int) -> Iterator[tuple[str, str]]:
    """Yield what pip builds from a setup.py from a line on, each with what its build must find."""
    for asked in authored.requirements:
        if asked.line < line or asked.beside:
            continue
        if asked.role == "file":
            files = with_includes(evidence, _file(asked.written, evidence))
            for each in (each for file in files for each in file.requirements):
                yield from _fetched(each)
        elif asked.role == "project":
            project = project_of(asked.written, authored, evidence)
            yield from _own(project) if project else ()
        else:
            yield from _fetched(asked)


def _fetched(asked: Requirement) -> Iterator[tuple[str, str]]:
    """Yield a package from git or an archive, by its name or that of its repository."""
    if not asked.url or asked.wheel:
        return
    from urllib.parse import urlsplit  # noqa: PLC0415 - few authors upgrade pip

    path = urlsplit(asked.url.removeprefix("git+")).path.strip("/").split("/")
    repository = canonicalize_name(path[1].partition("@")[0].removesuffix(".git")) if len(path) > 1 else ""
    for name in dict.fromkeys((asked.key, repository)):
        if needs := build_needs().get(name):
            yield name, needs[0]
            return


def _own(project: PythonProject) -> Iterator[tuple[str, str]]:
    """Yield a project of the tree whose setup.py imports what nothing tells pip to bring."""
    if project.build_requires:
        return
    for module in project.setup_imports:
        package = imports().get(module, (None, None))[0]
        if package and package not in INSTALLERS:
            yield project.folder or "the repository", package
            return


def _file(written: str, evidence: Evidence) -> list[RequirementFile]:
    """Return the requirements file of the tree that a step in the image names."""
    path = posixpath.normpath(written)
    inside = [file for file in evidence.requirements if f"/{path}".endswith(f"/{file.file}")]
    if inside:
        return [max(inside, key=lambda file: len(file.file))]
    copied = [file for file in evidence.requirements if file.file.endswith(f"/{posixpath.basename(path)}")]
    return copied if len(copied) == 1 else []


def project_of(written: str, authored: AuthorDockerfile, evidence: Evidence) -> PythonProject | None:
    """Return the project of the tree that a step in the image installs; not one of something that is cloned."""
    path = posixpath.normpath(written.partition("[")[0]).strip("/")
    if any(path.startswith(clone.name) for clone in authored.clones):
        return None
    below = [each for each in evidence.python if each.folder and f"/{path}".endswith(f"/{each.folder}")]
    if below:
        return max(below, key=lambda each: len(each.folder))
    return None if "/" in path else next((each for each in evidence.python if not each.folder), None)
