"""Packages inside the folder of another package: no build tool finds them, so that they are no part of the workspace.

catkin looks no further below a package.xml, and colcon below a package that it knows:
https://github.com/ros-infrastructure/catkin_pkg (packages.py: find_package_paths) and
https://github.com/colcon/colcon-recursive-crawl (package_discovery/recursive_crawl.py), 2026-11-27.
"""

from __future__ import annotations

import posixpath
import re
from collections.abc import Container, Iterable, Iterator
from collections.abc import Set as AbstractSet

from roslab.evidence.facts import PackageManifest
from roslab.evidence.on_path import on_path
from roslab.evidence.ros.needed_inside import needed_inside
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

_BUILD_FILES = ("CMakeLists.txt", "setup.py", "setup.cfg", "Makefile")
_TOLD = (".md", ".rst", ".txt", ".sh", ".bash", ".yml", ".yaml")
_WORD = pattern(r"[\w.+${}/-]+")
_VARIABLE = pattern(r"^\$\{\w+\}")
_OF_EVERY_TREE = frozenset({"src", "include", "lib", "libs", "scripts", "python", "cpp", "c++", "ros", "ros1", "ros2"})
"""Folders whose names say nothing about what is in them."""
_WHOLE = "GLOB_RECURSE"
"""CMake takes all files below a folder."""
MAX_READ = 256 * 1024
MOST_NAMED = 4
"""Most folders that the warning names."""


def problems(
    found: Iterable[PackageManifest], kept: Iterable[PackageManifest]
) -> Iterator[tuple[str, str | None, int | None]]:
    """Yield what the author should know of such packages, those that were ``found`` and not ``kept``."""
    left_out = sorted({each.file for each in found} - {each.file for each in kept})
    if left_out:
        named = ", ".join(map(posixpath.dirname, left_out[:MOST_NAMED])) + (" …" if left_out[MOST_NAMED:] else "")
        message = f"no build tool looks for packages inside another package: not built, and not read, are {named}"
        yield message, left_out[0], None


def without(
    repository: Repository, manifests: tuple[PackageManifest, ...]
) -> tuple[Repository, tuple[PackageManifest, ...]]:
    """Return the repository and the manifests without such packages; the same objects where there are none.

    A package that the outer one's build files, its page, a script beside them or a line that adds to Python's path
    names stays: the outer one may compile or import it, or the reader does. So does what the others need.
    """
    outer = {posixpath.dirname(m.file): m for m in manifests if _stops(m, repository)}
    inner = {folder: above for folder in _folders(manifests) if (above := _above(folder, outer)) is not None}
    inside = [manifest for manifest in manifests if posixpath.dirname(manifest.file) in inner]
    others = [manifest for manifest in manifests if posixpath.dirname(manifest.file) not in inner]
    needed = {posixpath.dirname(each.file) for each in needed_inside(others, inside)}
    left_out = tuple(
        f"{folder}/"
        for folder, above in inner.items()
        if folder not in needed and not _named(folder, above, outer[above], repository)
    )
    if not left_out:
        return repository, manifests
    files = {file.path for file in repository.files if file.path.startswith(left_out)}
    return repository.leaving_out(files), tuple(m for m in manifests if not m.file.startswith(left_out))


def _stops(manifest: PackageManifest, repository: Repository) -> bool:
    """Tell whether a build tool takes a folder as a package, and looks no further."""
    if manifest.ignored or not manifest.name or posixpath.basename(manifest.file) != "package.xml":
        return False
    folder = posixpath.dirname(manifest.file)
    by_python = any(name == "ament_python" for name, _ in manifest.build_types)
    return manifest.metapackage or repository.has(posixpath.join(folder, "setup.py" if by_python else "CMakeLists.txt"))


def _folders(manifests: Iterable[PackageManifest]) -> Iterator[str]:
    yield from (posixpath.dirname(m.file) for m in manifests if not m.ignored)


def _above(folder: str, outer: Container[str]) -> str | None:
    """Return the outermost package around a folder."""
    found = None
    while folder:
        folder = folder.rpartition("/")[0]
        found = folder if folder in outer else found
    return found


def _named(folder: str, above: str, package: PackageManifest, repository: Repository) -> bool:
    """Tell whether something outside of a folder names it by a path, or a folder on the way to it."""
    way = posixpath.relpath(folder, above or ".")
    name = posixpath.basename(way)
    built = [posixpath.join(above, each) for each in _BUILD_FILES]
    built += [
        file.path for file in repository.suffixed(".cmake") if file.folder in {above, posixpath.join(above, "cmake")}
    ]
    texts = [repository.read(path, limit=MAX_READ) for path in built]
    plain = _OF_EVERY_TREE | {package.name, posixpath.basename(above)}
    if any(_WHOLE in text or any(_leads(path, way, plain) for path in _paths(text)) for text in texts):
        return True
    places = {"", above, *(posixpath.join(above, each) for each in ("scripts", "script")), "scripts", "script"}
    entered = re.compile(rf"(?:/|\bcd[ \t]+){re.escape(name)}(?![\w.-])")
    pages = (file for file in repository.suffixed(*_TOLD) if file.folder in places)
    told = any(entered.search(repository.read(file, limit=MAX_READ)) for file in pages)
    return told or name in repository.once(on_path)


def _paths(text: str) -> set[str]:
    """Return the words of a build file that may be paths, without comments."""
    return {word for line in text.splitlines() for word in _WORD.findall(line.partition("#")[0])}


def _leads(written: str, way: str, plain: AbstractSet[str | None]) -> bool:
    """Tell whether a word is the path to a folder, of something in it, or of one on the way that says what is there."""
    path = _VARIABLE.sub("", written).strip("/")
    if "/" in written and way.rpartition("/")[2] in path.split("/"):
        return True
    return bool(path) and f"{way}/".startswith(f"{path}/") and not plain >= {*path.split("/")}
