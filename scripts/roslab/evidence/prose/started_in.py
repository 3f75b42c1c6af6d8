"""The folder in which a program has to be started: the one a page goes to, for Python where its code needs that."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator, Sequence

from roslab.evidence import places
from roslab.evidence.facts import Mention
from roslab.evidence.prose.paths_in_code import paths_in
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

INSTALLED = "install"
"""Where a page has CMake install to, and a workspace of ROS."""
MAX_FILES = 30
MAX_SIZE = 128 * 1024
_ABOVE = pattern(r"(?:^|[\s=:,;(\"'])\.\./([\w-][\w./-]*)", re.MULTILINE)
"""A path from the folder above, in a file of settings."""
_RELATIVE = pattern(r"(?:\.{1,2}/)*(?:(?:[\w-]+/)+[\w.-]*|[\w-]+\.[\w.-]+)")
"""An argument that is a file's path, or a folder's."""
_PLACES = {"bash": 1, "sh": 1, "roslaunch": 1, "ros2": 2}
"""Where the words of a command name a script or a launch file, if not in the first."""


def started_in(mention: Mention, words: Sequence[str], repository: Repository, *, went: bool = True) -> str:
    """Return the folder that a page's command has to be run in, ``""`` if any folder will do.

    ``words``: the command with the paths of the tree from its root; ``mention.inside`` is the folder as written, which
    may begin with the repository's own name. Where a page goes nowhere, or to a folder that has no such program, its
    command can only be meant where the program lies by the path that it gives. An argument, or the code beside it,
    names what is there from that folder only. Where the page does not go there itself (``went``), what the program has
    from the root alone comes before what the code beside it has.
    """
    said = mention.value.split()
    for word, path in zip(said, words, strict=True):
        if not path.endswith(".py"):
            continue
        name = posixpath.normpath(word)
        folder = path.removesuffix(name).rstrip("/")
        there = bool(folder) and posixpath.join(folder, name) == path
        gone = any(repository.has(posixpath.join(end, name)) for end in ends(mention.inside) if end)
        goes = f"/{mention.inside}".endswith(f"/{folder}") if gone else not repository.has(name)
        if not (there and goes):
            break
        rooted = not (went and mention.inside) and _of_root(path, folder, repository)
        if _given(said, folder, repository) or (not rooted and _needs(mention, path, folder, repository)):
            return folder
        break
    return ""


def beside_build(mention: Mention, words: Sequence[str], repository: Repository) -> str:
    """Return a folder at the root for a program that a page starts in its build folder (``./align ../cfg/a.cfg``).

    Only where all that is above is of the tree, and such a file names more of it from there: from any folder right
    below the root these paths hold, from the root itself they do not.
    """
    said = mention.value.split()
    above = [path for word, path in zip(said, words, strict=True) if word.startswith("../")]
    outside = any("../" in word and not word.startswith("../") for word in said)
    if not said[0].startswith("./") or outside or not all(_has(path, repository) for path in above):
        return ""
    for path in above:
        folder = path.partition("/")[0] if "/" in path else ""
        if folder and repository.has(path) and _names_above(path, repository):
            return folder
    return ""


def _names_above(path: str, repository: Repository) -> bool:
    """Tell whether a file names a file or folder of the tree from a folder right below the root."""
    text = repository.read(path, limit=MAX_SIZE)
    return any(_has(posixpath.normpath(match[1]), repository) for match in _ABOVE.finditer(text))


def script_in(mention: Mention, repository: Repository) -> tuple[int, str, str] | None:
    """Return which word of a command is a script or launch file below where the page went, its path, that folder.

    A page may begin above the root, and may go to a folder again without having left it: the longest end of where it is
    that has the script is meant, else the folder of a package that ``roscd`` goes to. ``None`` where there is none: the
    script is at the root, or nowhere. One of a folder right below ``install`` is what CMake installed, beside programs
    that the source does not have.
    """
    words = mention.value.split()
    position = min(_PLACES.get(words[0], 0), len(words) - 1)
    word = words[position]
    bare = word.startswith("./") and "." not in posixpath.basename(word)
    if not (bare or word.endswith((".sh", ".bash", ".launch", ".launch.py"))) or word.startswith(("/", "~")):
        return None
    for folder in (*ends(mention.inside), *package_folders(mention.inside, repository)):
        path = posixpath.normpath(posixpath.join(folder, word))
        if repository.has(path):
            installed = f"/{mention.inside}".endswith(f"/{INSTALLED}/{folder}") and INSTALLED not in repository.folders
            return (position, path, folder) if folder and not installed else None
    return None


def package_folders(inside: str, repository: Repository) -> Iterator[str]:
    """Yield the folders of the tree that ``roscd PACKAGE/DIR`` may mean, ``inside`` being where the page went with it.

    A package is known by its folder's name, else by that in its package.xml.
    """
    manifests = repository.named("package.xml") if inside else []
    for end in ends(inside):
        package, _, below = end.partition("/")
        named = [each for each in manifests if package and posixpath.basename(each.folder) == package]
        named = named or [each for each in manifests if package and f"<name>{package}</name>" in repository.read(each)]
        if len(named) == 1:
            yield posixpath.normpath(posixpath.join(named[0].folder, below))


def ends(folder: str) -> Iterator[str]:
    """Yield a folder, then its ends, the last of them ``""``: a page may begin above the root."""
    parts = [part for part in folder.split("/") if part]
    for first in range(len(parts) + 1):
        yield "/".join(parts[first:])


def _given(words: Sequence[str], folder: str, repository: Repository) -> bool:
    """Tell whether an argument names a path that is in the tree from this folder alone: ``--cfg cfgs/a.yaml``."""
    for word in words[1:]:
        value = word.rpartition("=")[2]
        if word.endswith(".py") or not _RELATIVE.fullmatch(value):
            continue
        here, root = (posixpath.normpath(posixpath.join(base, value)) for base in (folder, ""))
        if _has(here, repository) and not _has(root, repository):
            return True
    return False


def _needs(mention: Mention, program: str, folder: str, repository: Repository) -> bool:
    """Tell whether a file of Python beside the program names a path that is in the tree from this folder alone.

    Where the page goes to the folder, what the program has in folders beside it counts too.
    """
    beside = posixpath.dirname(program)
    files = [file for file in repository.suffixed(".py") if file.folder == beside and file.size <= MAX_SIZE]
    if mention.inside and len(files) < MAX_FILES:
        below = [file for file in repository.suffixed(".py") if file.folder.startswith(f"{beside}/")]
        below = [file for file in below if file.size <= MAX_SIZE and not _of_others(file.path)]
        files += sorted(below, key=lambda file: file.path.count("/"))
    for file in files[:MAX_FILES]:
        if any(_only_here(written, folder, repository) for written in paths_in(repository.read(file))):
            return True
    return False


def _of_root(program: str, folder: str, repository: Repository) -> bool:
    """Tell whether a program names a path that is in the tree from the root alone, and none from its folder alone."""
    paths = paths_in(repository.read(program, limit=MAX_SIZE))
    if any(_only_here(written, folder, repository) for written in paths):
        return False
    there = (path for path in map(posixpath.normpath, paths) if not _has(posixpath.join(folder, path), repository))
    return any(_has(path, repository) for path in there)


def _only_here(written: str, folder: str, repository: Repository) -> bool:
    """Tell whether a path is in the tree from a folder and not from the root, or leads above that into the tree."""
    here, root = (posixpath.normpath(posixpath.join(base, written)) for base in (folder, ""))
    above = written.startswith("../") and posixpath.dirname(here) in repository.folders
    return (_has(here, repository) or above) and not _has(root, repository)


def _of_others(path: str) -> bool:
    return places.vendored(path) or places.test(path) or places.example(path)


def _has(path: str, repository: Repository) -> bool:
    return repository.has(path) or path in repository.folders
