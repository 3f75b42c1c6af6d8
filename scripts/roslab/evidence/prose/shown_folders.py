"""The programs and notebooks of a folder of examples that a page at the root names: "see `examples/`"."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator

from roslab.evidence import places
from roslab.evidence.facts import Mention
from roslab.evidence.prose.headings import MAX_LINE, Line, lines_of
from roslab.evidence.prose.pages import LINK, pages, path_of, text_of
from roslab.evidence.python.modules import Module
from roslab.evidence.python.options import demands
from roslab.evidence.python.own_folder import own_folder
from roslab.evidence.python.own_tests import only_tests
from roslab.evidence.python.sample_programs import is_sample
from roslab.evidence.python.top_level import first_statement
from roslab.repository.checkout import File, Repository
from roslab.values.pattern import pattern

MOST = 40
"""Most files of one folder."""
MAX_SIZE = 128 * 1024
_KINDS = ("example", "demo", "sample", "tutorial", "notebook")
_NAME = rf"(?:[\w-]+_)?(?:{'|'.join(_KINDS)})s?"
_NAMED = pattern(
    rf"(?<![\w./-])(?:\./)?(?P<path>(?:[\w-]+/){{0,2}}{_NAME})(?:/(?!\w|\.\w)|(?=[`*\"')]{{1,3}})|"
    r"(?=[`*\"']{0,3}[ ](?:sub-?)?(?:folder|director(?:y|ies))\b))",
    re.IGNORECASE,
)
"""A folder by its path: ``examples/``, in quotes, or before the word."""
_BEHIND = pattern(
    rf"\b(?:folder|directory)[ ][`*\"']{{0,3}}(?P<path>(?:[\w-]+/){{0,2}}{_NAME})\b(?![./])", re.IGNORECASE
)
_FOLDER = pattern(rf"(?:.*/)?{_NAME}", re.IGNORECASE)
_GUARD = "__main__"
_READS = pattern(
    r"(?:\b(?:open|imread|load\w*|read_\w+|genfromtxt|VideoCapture)\(|\b(?:path|file|dir|folder)\w*[ ]?=)\s{0,20}"
    r"[\"']((?:[\w.~-]*/)*[\w.-]*\.(?:npy|npz|pkl|pickle|csv|h5|hdf5|bag|pt|pth|ckpt|onnx|pcd|ply|png|jpe?g|mp4|avi|"
    r"ya?ml|json|txt|urdf|xml|obj|stl|g2o|mat))[\"'](?!\s*,\s*[\"'][wax])"
)
"""A file that a program reads, by its place in the tree or in the program's folder."""
_ABOVE = pattern(r"^[^#\n]*?[\"'](\.\./[\w./-]{1,200})[\"']", re.MULTILINE)
"""What it names above its own folder."""
_ARGUMENTS = pattern(r"\bsys\.argv\s*\[\s*[1-9]|(?<![\w.])(?:raw_)?input\(|\bargv\s*\[\s*[1-9]")
_RELATIVE = pattern(r"^from[ \t]+\.", re.MULTILINE)
_NUMBER = pattern(r"(\d+)")


def read(repository: Repository) -> tuple[Mention, ...]:
    """Return what the folder has that a page names first so, each with itself in ``files`` if it can be started.

    That is what does something when it is started, asks for no argument, and names no file of data that the tree lacks.
    What the page names comes first, in its order, then the others by their names, numbers as numbers.
    """
    empty = set[str]()
    for page in pages(repository):
        text = text_of(repository, page) if "/" not in page.path else ""
        for line in lines_of(text) if any(kind in text.lower() for kind in _KINDS) else ():
            if line.fenced or line.elsewhere or len(line.text) > MAX_LINE:
                continue
            for folder in _folders(line, page, repository):
                if folder not in empty and (found := tuple(_shown(folder, line, page, text, repository))):
                    return found
                empty.add(folder)
    return ()


def _folders(line: Line, page: File, repository: Repository) -> Iterator[str]:
    """Yield the folders of the tree that a line names so; one may lack or have the last letter: ``example/``."""
    linked = [path_of(link, page) for link in LINK.finditer(line.text)] if "](" in line.text else []
    named = [match["path"] for form in (_NAMED, _BEHIND) for match in form.finditer(line.text)]
    for path in (*(path for path in linked if _FOLDER.fullmatch(path)), *named):
        other = path[:-1] if path.endswith("s") else f"{path}s"
        yield from (each for each in (path, other) if each in repository.folders and not places.vendored(f"{each}/a"))


def _shown(folder: str, line: Line, page: File, text: str, repository: Repository) -> Iterator[Mention]:
    files = [file for file in repository.suffixed(".py", ".ipynb") if _in(file, folder)]
    near = [file for file in files if file.folder == folder] or files
    programs = [file for file in sorted(near, key=lambda file: _order(file, text))[:MOST] if _does(file, repository)]
    for file in programs:
        yield Mention(
            topic="shown",
            value=file.path,
            source="readme",
            file=page.path,
            line=line.number,
            text=line.text.strip()[:200],
            heading=" / ".join(line.titles.values()),
            files=(file.path,) if file.name.endswith(".ipynb") or _starts(file, repository) else (),
            inside=_inside(file, repository),
        )


def _in(file: File, folder: str) -> bool:
    """Tell whether a file lies in a folder, or right in one below, and belongs to no tests."""
    below = file.path.removeprefix(f"{folder}/")
    return below != file.path and below.count("/") <= 1 and not (places.test(below) or places.vendored(below))


def _order(file: File, text: str) -> tuple[bool, int, bool, list[tuple[int, str]]]:
    at = text.find(file.name)
    words = _NUMBER.split(file.path.lower())
    parts = [(int(word), "") if word.isdigit() else (-1, word) for word in words]
    return at < 0, at, file.name.endswith(".ipynb"), parts


def _does(file: File, repository: Repository) -> bool:
    """Tell whether a file does something when it is started, and is neither a test nor what a tool wrote."""
    if file.name.endswith(".ipynb"):
        return True
    if file.name.startswith(("_", "test_")) or file.name in {"setup.py", "conftest.py"} or file.size > MAX_SIZE:
        return False
    text = repository.read(file)
    at = text.find(_GUARD)
    if is_sample(text) or (at >= 0 and only_tests(text[at:])):
        return False
    return at >= 0 or first_statement(text) is not None


def _starts(file: File, repository: Repository) -> bool:
    """Tell whether a program needs no argument, no answer of the reader's and no data, as far as its text tells."""
    text = repository.read(file)
    if _ARGUMENTS.search(text) or _RELATIVE.search(text) or demands(text):
        return False
    above = (posixpath.normpath(posixpath.join(file.folder, match[1])) for match in _ABOVE.finditer(text))
    return all(_lies(path, repository) for path in above) and all(
        _there(match[1], file, repository) for match in _READS.finditer(text)
    )


def _inside(file: File, repository: Repository) -> str:
    """Return the folder that a program has to be started in: its own, where it names what lies above that."""
    if file.name.endswith(".ipynb"):
        return ""
    named = (match[1] for match in _ABOVE.finditer(repository.read(file)))
    found = any(_lies(posixpath.normpath(posixpath.join(file.folder, path)), repository) for path in named)
    return file.folder if found else own_folder(repository, Module(file=file, repository=repository))


def _lies(path: str, repository: Repository) -> bool:
    return repository.has(path) or path in repository.folders


def _there(path: str, file: File, repository: Repository) -> bool:
    if path.startswith(("/", "~")):
        return False
    tried = (posixpath.normpath(posixpath.join(folder, path)) for folder in ("", file.folder))
    return any(map(repository.has, tried))
