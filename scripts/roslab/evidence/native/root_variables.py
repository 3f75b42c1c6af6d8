"""Variables below which files of the tree are named: ``$ENV{DEMO}/engine/maps``, ``environ["DEMO"] + "/engine/maps"``.

They are the repository's own folder, which its page has the reader export, often as a blank (``path_to_demo``).
"""

from __future__ import annotations

import posixpath
from collections.abc import Iterator

from roslab.evidence import places
from roslab.evidence.facts import Mention
from roslab.evidence.native.asked_variables import HERE
from roslab.knowledge.machine_variables import of_every_image, of_one_machine
from roslab.repository.checkout import File, Repository, nearest
from roslab.values.pattern import pattern

MAX_FILES = 400
"""Most files that are searched, those nearest to the root first."""
_SUFFIXES = (".py", ".cpp", ".cc", ".cxx", ".cmake", ".launch")
_CODE = frozenset({".py", ".cpp", ".cc", ".cxx"})
_PATH = r"([\w+-][\w.+-]*(?:/[\w.+-]+)*)"
_OF_CMAKE = pattern(r"\$(?:ENV\{|\((?:opt)?env )([A-Z][A-Z0-9_]{2,40})[})]/" + _PATH)
_OF_CODE = pattern(
    r"(?:getenv|environ(?:\.get)?)[(\[]\s?[\"']([A-Z][A-Z0-9_]{2,40})[\"']\s?[)\]]\)?"
    r"[\s\\]{0,40}([+/,]|\.joinpath\()[\s\\]{0,40}(?:(?:std::)?string\(\s{0,40})?[\"']/?" + _PATH + r"/?[\"']"
    r"((?:\s?[,/]\s?[\"'][\w.+/-]+[\"']){0,6})"
)
"""What is read, and the text behind it: added to it or joined to it."""
_JOINED = pattern(r"\bjoin\(\s*(?:str\()?(?:os\.)?$")
"""What stands before a variable with a comma behind it: else both are arguments of a function that does not join."""
_FURTHER = pattern(r"[\"']([\w.+/-]+)[\"']")
_SET = pattern(
    r"\benviron(?:\.setdefault\(|\[)\s?[\"']([A-Z][A-Z0-9_]{2,40})[\"'](?:\s?\]\s?=(?!=)|\s?,)|\bsetenv\(\s?\"(\w+)\""
)
_OF_OTHERS = pattern(
    r"(?:ROS|RMW|AMENT|COLCON|CATKIN|LD|CUDA|CMAKE|CONDA|PIP|GITHUB|CI)_\w+|PATH|PYTHONPATH|HOME|PWD|WORKSPACE"
)
_OF_EVERYONE = frozenset({"bin", "etc", "include", "lib", "lib64", "libs", "opt", "share", "usr"})
"""Folders that installed libraries have as well."""
_USUAL = frozenset(
    {"build", "cmake", "config", "configs", "data", "devel", "doc", "docs", "examples", "install", "launch", "models"}
    | {"msg", "output", "results", "scripts", "src", "test", "tests", "tools", "urdf", "worlds"}
)
"""Folders that many repositories have: alone they tell nothing."""


def read(repository: Repository) -> Iterator[Mention]:
    """Yield ``NAME=./`` for each variable below which the tree's own files name what lies in the tree."""
    found: dict[str, Mention] = {}
    files = [*repository.named("CMakeLists.txt"), *repository.suffixed(*_SUFFIXES)]
    files = nearest([file for file in files if not places.aside(file.path)])[:MAX_FILES]
    texts = [(file, text) for file in files if _reads(file, text := repository.read(file))]
    for file, text in texts:
        for name, below, at in _named(file, text):
            if name not in found and not _of_others(name) and _in_tree(below, repository):
                line, said = text.count("\n", 0, at) + 1, f"{name}={HERE}"
                found[name] = Mention(
                    topic="variable", value=said, source="code", file=file.path, line=line, text=below, inside=file.path
                )
    set_here = {match[1] or match[2] for _, text in (texts if found else ()) for match in _SET.finditer(text)}
    yield from (mention for name, mention in found.items() if name not in set_here)


def _reads(file: File, text: str) -> bool:
    return any(sign in text for sign in (("environ", "getenv") if file.suffix in _CODE else ("ENV{", "env ")))


def _named(file: File, text: str) -> Iterator[tuple[str, str, int]]:
    """Yield each variable with the path below it, and where it is read."""
    if file.suffix in _CODE:
        for match in _OF_CODE.finditer(text):
            if match[2] != "," or _JOINED.search(text, max(0, match.start() - 60), match.start()):
                further = (part.strip("/") for part in _FURTHER.findall(match[4]))
                yield match[1], "/".join([match[3], *further]), match.start()
    else:
        yield from ((match[1], match[2], match.start()) for match in _OF_CMAKE.finditer(text))


def _of_others(name: str) -> bool:
    return bool(_OF_OTHERS.fullmatch(name)) or of_every_image(name) or of_one_machine(name)


def _in_tree(below: str, repository: Repository) -> bool:
    """Tell whether a path is one of the tree, and of no other: deep, or with a name that is not usual."""
    path = posixpath.normpath(below)
    first, _, rest = path.partition("/")
    if first in {".", "..", *_OF_EVERYONE}:
        return False
    return path in repository.folders if not rest and first not in _USUAL else bool(rest) and _there(path, repository)


def _there(path: str, repository: Repository) -> bool:
    return repository.has(path) or path in repository.folders
