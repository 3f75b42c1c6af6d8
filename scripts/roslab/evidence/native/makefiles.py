"""Makefiles that authors write by hand: what they compile and link. They are searched by patterns, not run.

So are the scripts that a page runs where no Makefile compiles the tree.
"""

from __future__ import annotations

import posixpath
import re
from collections.abc import Collection, Iterable

from roslab.evidence import places
from roslab.evidence.facts import Mention
from roslab.evidence.makefile import Makefile
from roslab.repository.checkout import File, Repository
from roslab.values.dataclass import replace
from roslab.values.pattern import pattern

MAX_SIZE = 64 * 1024
MOST = 4
"""Most folders below the root whose Makefiles count."""
_NAMES = ("GNUmakefile", "makefile", "Makefile")
_COMPILES = pattern(
    r"\$[({](?:CXX|CC|NVCC|LINK\.\w+|MAKE)[)}]|^\s[^#\n]{0,200}\b(?:g\+\+|gcc|clang(?:\+\+)?|nvcc)(?:-[\d.]+)?\s",
    re.MULTILINE,
)
_SET = pattern(r"\w+\s*[:?+]?=\s*([\w./ -]{1,300})$")
_STARTS = pattern(r"(?:^|&&|;)\s{0,9}[@-]?\./", re.MULTILINE)
"""What a recipe has that starts a program of the folder."""
_OTHERS = pattern(
    r"\b(?:cmake|catkin\w*|colcon|rospack|rosmake|qmake|docker|sphinx-build|SPHINXBUILD|latex|pdflatex|"
    r"arm-none-eabi-\w+|avr-\w+|obj-m|platformio|\w+-mingw32-\w+)\b"
)
"""What a Makefile for something else calls: for another build tool, documents, firmware, the kernel, Windows."""
NEAR, FAR = 1, 3
"""How many folders down a Makefile may lie, and where no other does."""
_OF_WINDOWS = ".exe"
"""How authors end the names of programs who write for both systems: g++ on Linux makes one of that name."""
_OUTPUT = pattern(r"(?<!\w)-o\s+(?:[\w.-]+/){0,4}([A-Za-z][\w-]{0,60}(?:\.exe)?)(?=\s|$)", re.MULTILINE)
_TARGET = pattern(
    r"^(?:(?:\w+_)?(?:TARGETS?|EXEC\w*|BIN(?:ARY|ARIES)?|PROG\w*|OUTPUT|APP\w*|EXE))\s*[:?]?=\s*([\w./ -]{1,300})$",
    re.MULTILINE,
)
_RULE = pattern(r"^([\w./-]{1,80}(?: [\w./-]{1,80}){0,7}) ?:(?!=)", re.MULTILINE)
_LINKS = pattern(r"^([\w./-]{1,80}) ?:(?!=)[^\n]{0,400}\n\t[^\n]{0,400}-o \$@", re.MULTILINE)
"""The rule that makes one file by its name."""
_OF_ANY = pattern(r"^[^\s#][^\n:=]{0,100}%[^\n:=]{0,100}:(?!=)|\$[({]wildcard\s", re.MULTILINE)
"""A rule for files of any name, or a list of the files that are there."""
_PROGRAM = pattern(r"(?:[\w.-]+/){0,4}[\w.-]+")
_NO_PROGRAMS = (".a", ".so", ".o", ".dll", ".cpp", ".cc", ".c")
_INCLUDE = pattern(r"^-?s?include[ \t]+([\w./ -]{1,200})$", re.MULTILINE)
DEEPEST = 20
"""Most files that include each other."""
_MAIN = pattern(r"^[ \t]*(?:int|auto)\s+main\s*\(", re.MULTILINE)
_SOURCES = (".c", ".cc", ".cpp", ".cxx", ".cu")
MOST_SOURCES = 200
"""Most files of code that are looked at for a function ``main``."""
_TASKS = frozenset(
    (
        *("all", "clean", "distclean", "install", "uninstall", "test", "tests", "check", "run", "help", "format"),
        *("lint", "doc", "docs", "debug", "release", "default", "depend"),
    )
)
"""Targets that are no files."""


def read(repository: Repository, mentions: Iterable[Mention] = ()) -> tuple[Makefile, ...]:
    """Return the Makefile at the root, else those of the nearest folders, else the scripts that a page compiles with.

    Else the projects of qmake. In the place of all these the project of Autotools.
    None where CMake or ROS builds the tree, or where it has more Python than C and C++.
    """
    if not all(
        places.vendored(file.path) for file in repository.named("CMakeLists.txt", "package.xml", "manifest.xml")
    ):
        return ()
    if _number(repository, ".py") > _number(repository, *_SOURCES):
        return ()
    from roslab.evidence.native import autotools, compile_scripts, qmake  # noqa: PLC0415 - CMake or ROS builds most

    if not all(places.vendored(file.path) for file in repository.named("configure", "configure.ac", "configure.in")):
        return tuple(autotools.read(repository))
    found = [each for file in _files(repository) if (each := _makefile(file, repository))]
    called = {folder for each in found for folder in each.parts if each.folder not in each.parts}
    found = [each for each in found if each.folder not in called] or found
    own = _as_told(repository, [each for each in found if not each.folder] or found[:MOST], mentions)
    return tuple(own) or compile_scripts.read(repository, mentions) or tuple(qmake.read(repository))


def _as_told(repository: Repository, found: list[Makefile], mentions: Iterable[Mention]) -> list[Makefile]:
    """Return the Makefiles with the targets that a page names, after those of other folders where it calls make."""
    said = [mention for mention in mentions if mention.topic == "make"]
    if not said:
        return found
    files = (file for name in _NAMES for file in repository.named(name) if file.path.count("/") <= FAR + 1)
    near = {file.folder: file for file in files if file.size <= MAX_SIZE and not places.vendored(file.path)}
    from roslab.evidence.native import recursive_make  # noqa: PLC0415 - few pages call make

    targets = dict(recursive_make.told(said, near))
    there = {each.folder for each in found}
    part = {below for each in found for below in each.parts}
    further = [near[folder] for folder in targets if folder not in there | part]
    found = [*(each for file in further if (each := _makefile(file, repository))), *found] if further else found
    return [replace(each, target=targets.get(each.folder, each.target)) for each in found[:MOST]]


def _number(repository: Repository, *suffixes: str) -> int:
    return sum(not places.vendored(file.path) for file in repository.suffixed(*suffixes))


def _files(repository: Repository) -> list[File]:
    """Return one Makefile of each folder near the root, of those further down where there is none."""
    kept: dict[str, File] = {}
    further: dict[str, File] = {}
    for name in _NAMES:
        for file in repository.named(name):
            path = file.path
            aside = places.vendored(path) or places.test(path) or places.documentation(path) or places.example(path)
            if path.count("/") <= FAR and file.size <= MAX_SIZE and not aside:
                (kept if path.count("/") <= NEAR else further).setdefault(file.folder, file)
    found = kept or further
    return [found[folder] for folder in sorted(found)]


def compiles(text: str) -> bool:
    """Tell whether a Makefile calls compilers, or make in other folders, and no other build tool or system."""
    return _COMPILES.search(text) is not None and not _OTHERS.search(text)


def compiles_targets(text: str, targets: Iterable[str]) -> bool:
    """Tell whether a Makefile only compiles for each target: its recipe calls compilers or make, and starts nothing.

    One without a recipe stands for others; one that a variable names is a file. ``all`` is what make does unasked.
    """
    from roslab.evidence.native import make_goals  # noqa: PLC0415 - few pages call make in a folder

    known = make_goals.recipes(text)
    named = {word for line in text.splitlines() if (found := _SET.match(line)) for word in found[1].split()}
    return all(
        each == "all" or (_only_compiles("\n".join(known[each])) if each in known else each in named)
        for each in targets
    )


def _only_compiles(recipe: str) -> bool:
    return not recipe or (_COMPILES.search(recipe) is not None and not _STARTS.search(recipe))


def _makefile(file: File, repository: Repository) -> Makefile | None:
    from roslab.evidence.native import compile_scripts, make_goals, recursive_make  # noqa: PLC0415 - as above
    from roslab.evidence.native.make_names import with_names  # noqa: PLC0415 - as above

    text = repository.read(file)
    if _OTHERS.search(text):
        return None
    text = with_included(text, file.folder, repository)
    parts = recursive_make.below(text, file.folder, repository, _is_other)
    if parts:
        text = "\n".join((text, *(with_included(part, folder, repository) for folder, part in parts)))
    if not _COMPILES.search(text):
        return None
    text = with_names(text)
    names = [*_OUTPUT.findall(text)]
    names += [posixpath.basename(word) for written in _TARGET.findall(text) for word in written.split()]
    names += [posixpath.basename(word) for written in _RULE.findall(text) for word in written.split()]
    if _OF_ANY.search(text):
        for folder in (file.folder, *(folder for folder, _ in parts)):
            names += _mains(repository, folder)
    linked = make_goals.linking(text)
    names += [posixpath.basename(program) for _, program in linked]
    sure = {posixpath.basename(program) for _, program in linked}  # also one that is called test
    return Makefile(
        file=file.path,
        line=1,
        programs=(
            programs := tuple(dict.fromkeys(name for name in names if name in sure or _may_be_made(name, names)))
        ),
        only=linked[0][1] if len(linked) == 1 else _only(text),
        target=" ".join(target for target, _ in linked),
        alone=not parts and make_goals.alone(text),
        stale=any(repository.has(posixpath.join(file.folder, name)) for name in programs),
        linked=compile_scripts.linked(text),
        cuda=compile_scripts.for_cuda(text),
        modules=compile_scripts.modules(text),
        parts=tuple(folder for folder, _ in parts),
    )


def _is_other(path: str, text: str) -> bool:
    """Tell whether a Makefile below another is none of the project's own: copied, a test's, or for something else."""
    return places.vendored(path) or places.documentation(path) or bool(_OTHERS.search(text))


def _may_be_made(name: str, names: Collection[str]) -> bool:
    """Tell whether a name is one of a program; that for Windows is none where there is another without its ending."""
    plain = name.removesuffix(_OF_WINDOWS)
    return bool(plain) and "." not in plain and name not in _TASKS and (plain == name or plain not in names)


def with_included(text: str, folder: str, repository: Repository) -> str:
    """Return a Makefile with the text of each file of the tree that it includes by its name in the place of that line.

    What these include in turn is taken too, by its path from the ``folder`` in which make is run.
    """
    taken: set[str] = set()

    def inside(text: str, depth: int) -> str:
        return _INCLUDE.sub(lambda match: put(match, depth), text) if depth < DEEPEST and "include" in text else text

    def put(match: re.Match[str], depth: int) -> str:
        paths = [posixpath.normpath(posixpath.join(folder, word)) for word in match[1].split()]
        new = [path for path in paths if path not in taken and repository.has(path)]
        taken.update(new)
        return "".join(f"\n{inside(repository.read(path, limit=MAX_SIZE), depth + 1)}\n" for path in new) or match[0]

    return inside(text, 0)


def _only(text: str) -> str | None:
    """Return the one program that a Makefile's variables name, else its rules, ``None`` where it may make another."""
    named = {posixpath.normpath(word) for written in _TARGET.findall(text) for word in written.split()}
    named = named or {posixpath.normpath(name) for name in _LINKS.findall(text) if not name.endswith(_NO_PROGRAMS)}
    others = {*_OUTPUT.findall(text)} - {posixpath.basename(name) for name in named}
    program = next(iter(named)) if len(named) == 1 and not others else ""
    plain = _PROGRAM.fullmatch(program) and not program.endswith(_NO_PROGRAMS)
    return program if plain else None


def _mains(repository: Repository, folder: str) -> list[str]:
    """Return the names, without their endings, of the files of code below a folder that have a function ``main``."""
    below = f"{folder}/" if folder else ""
    files = [file for file in repository.suffixed(*_SOURCES) if file.path.startswith(below)]
    files = [file for file in files if file.size <= MAX_SIZE and not places.vendored(file.path)]
    return [file.name.rpartition(".")[0] for file in files[:MOST_SOURCES] if _MAIN.search(repository.read(file))]
