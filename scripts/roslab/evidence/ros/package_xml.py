"""package.xml, formats 1 to 3. https://ros.org/reps/rep-0149.html, https://ros.org/reps/rep-0140.html, REP 127."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import product

from roslab.evidence.dependency import Dependency, GitSource
from roslab.evidence.facts import PackageManifest
from roslab.evidence.hidden import hidden
from roslab.evidence.lex import xml
from roslab.evidence.lex.xml import Element
from roslab.repository.checkout import File, Repository
from roslab.values.pattern import pattern

MAX_SIZE = 256 * 1024
"""Most bytes read; the longest package.xml of 73 real repositories has 20 kB."""
_VERSIONS = {"version_eq": "=", "version_gte": ">=", "version_gt": ">", "version_lte": "<=", "version_lt": "<"}
_NAME = pattern(r"[A-Za-z][\w.+-]*")
_ROLES: dict[str, tuple[str, ...]] = {
    "depend": ("build", "exec"),
    "build_depend": ("build",),
    "build_export_depend": ("build",),
    "buildtool_depend": ("buildtool",),
    "buildtool_export_depend": ("buildtool",),
    "run_depend": ("exec",),
    "exec_depend": ("exec",),
    "test_depend": ("test",),
    "doc_depend": ("doc",),
}


def read(repository: Repository) -> tuple[PackageManifest, ...]:
    """Return every package.xml, sorted by path; XML that is not well-formed is read as far as possible."""
    files = [file for file in repository.named("package.xml") if file.size <= MAX_SIZE]
    if not files:
        return ()
    found = (_manifest(repository, file) for file in files)
    return tuple(sorted((manifest for manifest in found if manifest), key=lambda manifest: manifest.file))


def _manifest(repository: Repository, file: File) -> PackageManifest | None:
    text = repository.read(file)
    root, problem = xml.parse(text)
    if root is None:
        malformed = problem or ("it is empty" if not text.strip() else "no XML element")
        return _empty(file, hidden(repository, file.folder), malformed)
    if root.tag != "package":
        return None  # another program's package.xml: Node, Symfony, Joomla
    return PackageManifest(
        file=file.path,
        line=root.line,
        name=next((_text(name) for name in root.below("name")), None),
        format=int(value) if (value := (root.get("format") or "1").strip()) in {"1", "2", "3"} else 1,
        build_types=_build_types(root),
        dependencies=tuple(_dependencies(root, file.path)),
        sources=tuple(_sources(root, file.path)),
        metapackage=any(root.below("export", "metapackage")),
        ignored=hidden(repository, file.folder),
        malformed=problem,
        together=next(_together(root), None),
        website=next((_text(url) for url in root.below("url") if url.get("type") != "bugtracker"), None),
    )


def _together(root: Element) -> Iterator[tuple[str, int]]:
    return ((e.tag, e.line) for e in root.children if e.tag in _ROLES and len(_names(e)) > 1)


def _empty(file: File, ignored: bool, malformed: str) -> PackageManifest:
    return PackageManifest(
        file=file.path,
        line=1,
        name=None,
        format=1,
        build_types=(),
        dependencies=(),
        ignored=ignored,
        malformed=malformed,
    )


def _text(element: Element) -> str | None:
    return element.text.strip() or None


def _names(element: Element) -> list[str]:
    """Return the packages that an element names: one, or several divided by blanks."""
    words = element.text.split()
    return words if all(map(_NAME.fullmatch, words)) else [element.text.strip()]


def _build_types(root: Element) -> tuple[tuple[str, str | None], ...]:
    found = tuple(
        (name, element.get("condition")) for element in root.below("export", "build_type") if (name := _text(element))
    )
    return found or (("catkin", None),)


def _dependencies(root: Element, path: str) -> Iterator[Dependency]:
    for element in root.children:
        if element.tag not in _ROLES:
            continue
        version = next((f"{sign}{value}" for key, sign in _VERSIONS.items() if (value := element.get(key))), None)
        for name, role in product(_names(element), _ROLES[element.tag]):
            yield Dependency(
                namespace="rosdep",
                name=name,
                strength="declared",
                file=path,
                line=element.line,
                version=version,
                role=role,
                condition=element.get("condition"),
            )


def _sources(root: Element, path: str) -> Iterator[GitSource]:
    """Read ``<git_url target="NAME" url="…" branch="…"/>``, catkin_tools_fetch's way to an unreleased package.

    https://github.com/niosus/catkin_tools_fetch
    """
    for element in root.all("git_url"):
        url = (element.get("url") or _text(element) or "").strip()
        name = (
            element.get("target") or url.rstrip("/").rpartition("/")[2].rpartition(":")[2].removesuffix(".git")
        ).strip()
        if url and name:
            yield GitSource(
                name=name,
                url=url,
                ref=element.get("branch") or element.get("tag") or element.get("commit"),
                strength="declared",
                file=path,
                line=element.line,
                kind="git_url",
            )
