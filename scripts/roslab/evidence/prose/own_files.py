"""The files of the tree that a command of a page names."""

from __future__ import annotations

import posixpath
from collections.abc import Mapping

from roslab.evidence import places
from roslab.evidence.facts import Mention
from roslab.evidence.prose.authors_words import of_author
from roslab.evidence.prose.in_workspace import from_above, given_from_workspace, in_checkout, in_workspace
from roslab.evidence.prose.runners import SIMULATORS
from roslab.evidence.prose.script_folders import started_above, started_beside
from roslab.evidence.prose.started_in import beside_build, ends, script_in, started_in
from roslab.evidence.ros import vcs
from roslab.repository.checkout import Repository
from roslab.values.dataclass import replace
from roslab.values.endings import SHELL_SCRIPTS
from roslab.values.numbered import numbered
from roslab.values.pattern import pattern
from roslab.values.words import joined, written

_PROGRAMS = (".py", ".sh", ".bash")
_NUMBERED = (".py", ".sh", ".bash", ".yaml", ".yml")
_SHEBANG = pattern(r"#![^\n]*?\b(python[23]?|bash|sh)\b")
_BEFORE = pattern(r"^(?:\.{1,2}/)+")


def with_files(mention: Mention, repository: Repository) -> Mention:
    """Return a command of a page with the files of the tree that it names, by their paths from the root."""
    mention = _by_its_shell(mention, repository)
    words, found = given_from_workspace(of_author(mention.value.split(), repository), mention.inside, repository)
    folder = posixpath.dirname(mention.file)
    unseen = ""
    if script := script_in(mention, repository) if mention.inside else None:
        words[script[0]] = script[1]
    for index, word in enumerate(words):
        if index == 0 and not (script or word.endswith(SHELL_SCRIPTS)):
            continue
        named = any(sign in word for sign in "/._")
        path = posixpath.normpath(_BEFORE.sub("", written(word))) if named else ""
        path = in_checkout(path, repository) or from_above(path, repository) or path
        path = in_workspace(path, words, repository) or path
        below = words[0].startswith("python") and path.endswith(".py") and "/" not in mention.file
        if below and not (found or repository.has(path)):  # the page is in another folder by then
            path = only(path, repository) or _where_it_went(path, mention.inside, repository) or path
        path = _by_its_program(words[0], _with_ending(path, repository) if index else path, repository)
        path = _as_spelt(_with_number(path, repository), repository)
        beside = folder and path.endswith(_PROGRAMS) and (index == 0 or words[0].startswith(("python", "bash", "sh")))
        if beside and not repository.has(path) and repository.has(f"{folder}/{path}"):
            path = f"{folder}/{path}"  # a page below the root starts what lies beside it
        if path not in {"", "."} and not path.startswith("/") and (repository.has(path) or path in repository.folders):
            words[index] = path
            run = index == 1 and words[0].startswith("python") and not repository.has(path)
            found += [path] if not run or repository.has(f"{path}/__main__.py") else []
        elif _of_package(word, repository):
            found.append(word)
        elif words[0].startswith("python") and not found and (place := _unseen(path, mention.inside, repository)):
            words[index], unseen = place
            found.append(words[index])
    inside = script[2] if script else unseen or _folder_of(mention, words, repository)
    if words[0].startswith("python") and words[1:2] == ["-m"] and len(words) > 2:
        file, inside = _module(words[2], mention.inside, repository)
        found += [file] if file else []
    return replace(mention, value=joined(words), files=tuple(found), inside=inside)


def with_files_below(mention: Mention, folders: Mapping[str, str], repository: Repository) -> Mention:
    """Return the call of a program with the files in the folder of its project, by their paths from the root."""
    program, *words = mention.value.split()
    folder = folders.get(program, "")
    found: list[str] = []
    for index, word in enumerate(words) if folder else ():
        option, sign, path = word.rpartition("=")
        below = posixpath.normpath(posixpath.join(folder, written(path)))
        if "/" in path and not repository.has(posixpath.normpath(written(path))) and repository.has(below):
            words[index] = f"{option}{sign}{below}"
            found.append(below)
    if not found:
        return mention
    return replace(mention, value=joined((program, *map(written, words))), files=(*mention.files, *found))


def _with_ending(path: str, repository: Repository) -> str:
    """Return the path of the tree's file that differs in how YAML's ending is written, else the path as it is."""
    stem, dot, ending = path.rpartition(".")
    other = {"yml": "yaml", "yaml": "yml"}.get(ending, "")
    return f"{stem}{dot}{other}" if other and not repository.has(path) and repository.has(f"{stem}.{other}") else path


def _as_spelt(path: str, repository: Repository) -> str:
    """Return a program's path as the tree spells it, where that differs in capitals alone: not every system cares."""
    ending = posixpath.splitext(path)[1]
    if ending not in _PROGRAMS or repository.has(path):
        return path
    same = [file.path for file in repository.suffixed(ending) if file.path.lower() == path.lower()]
    return same[0] if len(same) == 1 else path


def _with_number(path: str, repository: Repository) -> str:
    """Return the path of the tree's first file where one letter stands for a number: ``config/robotN.yaml``."""
    ending = path[path.rfind(".") :] if "." in path else ""
    if ending not in _NUMBERED or repository.has(path):
        return path
    return numbered(path, (file.path for file in repository.suffixed(ending))) or path


def _folder_of(mention: Mention, words: list[str], repository: Repository) -> str:
    """Return the folder that a program has to be started in, ``""`` if any will do; of a launch where the page is."""
    if words[0] == "roslaunch" or words[:2] == ["ros2", "launch"]:
        return next((folder for folder in ends(mention.inside) if folder in repository.folders), "")
    found = started_in(mention, words, repository) or beside_build(mention, words, repository)
    return found or started_above(words, repository) or started_beside(words, repository)


def _unseen(path: str, folder: str, repository: Repository) -> tuple[str, str] | None:
    """Return the path of a program in a submodule that is not checked out, and the folder that the page went to.

    The image clones it, so that its programs are there as those of one that is checked out.
    """
    if not path.endswith(".py") or path.startswith(("/", "..")):
        return None
    for start in reversed(tuple(ends(folder))):  # a page may go to a folder again without having left it
        whole = posixpath.join(start, path)
        if any(whole.startswith(f"{name}/") for name in repository.once(vcs.missing)):
            return whole, start
    return None


def _by_its_program(program: str, path: str, repository: Repository) -> str:
    """Return the path of the tree's file that Jupyter opens, or that a simulator finds below a folder of its path."""
    if path.endswith(".ipynb") and program.startswith("jupyter"):
        return _below(path, repository)
    if program in SIMULATORS and "/" in path and not repository.has(path):
        return only(path, repository) or path
    return path


def _module(name: str, folder: str, repository: Repository) -> tuple[str, str]:
    """Return the file of a module that ``python -m`` starts, and the folder that the page went to if it lies there.

    Else it is at the root, or the only one of the tree that a dotted name may mean: a package may lie in any folder.
    """
    paths = [f"{name.replace('.', '/')}{end}" for end in (".py", "/__main__.py")]
    for start in ends(folder):
        if file := next((path for path in paths if repository.has(posixpath.join(start, path))), None):
            return posixpath.join(start, file), start
    alone = (only(path, repository) for path in paths) if "." in name else ()
    return next((file for file in alone if file), ""), ""


def _by_its_shell(mention: Mention, repository: Repository) -> Mention:
    """Return the call of a script whose name has no ending (``./bin/tool -a``) as that of what its first line names."""
    first, *rest = mention.value.split()
    path = posixpath.normpath(written(first))
    if "/" not in first or "." in posixpath.basename(path) or not repository.has(path):
        return mention
    named = _SHEBANG.match(repository.read(path, limit=200))
    return replace(mention, value=" ".join((named[1], joined((path,)), *rest))) if named else mention


def _of_package(word: str, repository: Repository) -> bool:
    """Tell whether a launch file is given a path that its node puts behind its package's: ``map:=/maps/hall.yaml``."""
    path = word.partition(":=")[2]
    below = path.startswith("/") and path.count("/") > 1
    return below and any(f"/{file.path}".endswith(path) for file in repository.named(posixpath.basename(path)))


def only(path: str, repository: Repository) -> str | None:
    """Return the one file of the tree whose path ends in this one, ``None`` if there are several or none."""
    ends = [file.path for file in repository.named(posixpath.basename(path)) if file.path.endswith(f"/{path}")]
    own = [each for each in ends if not places.vendored(each)]
    return own[0] if len(own) == 1 else None


def _where_it_went(path: str, inside: str, repository: Repository) -> str | None:
    """Return the file of that path below the folder that a page went to, which tells which of several is meant."""
    there = (posixpath.normpath(posixpath.join(end, path)) for end in ends(inside) if end)
    return next((each for each in there if repository.has(each)), None)


def _below(path: str, repository: Repository) -> str:
    """Return the path from the root of what a page names with the folders above it (``$HOME/demo/nb/a.ipynb``)."""
    parts = path.split("/")
    ends = ("/".join(parts[start:]) for start in range(len(parts)))
    return next((end for end in ends if repository.has(end)), path)
