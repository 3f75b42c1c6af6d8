"""What a call of ``cmake`` in a text tells: its options, and the folder whose CMakeLists.txt it means."""

from __future__ import annotations

import posixpath
from collections.abc import Sequence
from itertools import pairwise

from roslab.evidence.dependency import GitSource
from roslab.evidence.facts import Mention
from roslab.evidence.lex.shell import UNKNOWN
from roslab.repository.checkout import Repository
from roslab.values.dataclass import replace
from roslab.values.pattern import pattern
from roslab.values.words import BLANK, joined, written

_OPTION = pattern(r"-D(?!CMAKE_INSTALL_PREFIX=/usr/local/stow/)[A-Za-z_]\w*(?::[A-Z]*)?=[\w./+-]+")
"""Not the folder from which stow links all to /usr/local. https://www.gnu.org/software/stow/manual/stow.html"""
_FLAGS = pattern(
    r"(-DCMAKE_(?:C|CXX|EXE_LINKER|SHARED_LINKER)_FLAGS(?:_RELEASE)?)(?::[A-Z]*)?=(-[\w./+=,-]+(?: +-[\w./+=,-]+)*) *"
)
_OF_MACHINE = pattern(r"-m.+|-Werror\b.*")
"""What is about the machine, or the release of the compiler, that its author has."""
_SEPARATE = pattern(r" -D +(?=[A-Za-z_])")
_BUILD_FOLDER = pattern(r"(?:^|/)build[\w-]*(?:/.*)?$")


_NAME = pattern(r"-D(?!CMAKE_|BUILD_SHARED_LIBS|BUILD_TESTING)([A-Za-z_]\w*)")
"""The name of an option that a project declares itself, not CMake or a module of it."""
_WORD = pattern(r"\w+")
MAX_SIZE = 256 * 1024
PRESET = "--preset="
_PREPARES = pattern(r"\.{1,2}/|(?:.*/)?(?:configure|qmake|python|ba?sh)\b")
_SOURCE = frozenset({"-S", "-H"})
_VALUED = frozenset({"-A", "-B", "-C", "-D", "-G", "-P", "-T", "-U", "--preset", "--toolchain", "--install-prefix"})


def of_another(said: Mention, repository: Repository) -> bool:
    """Tell whether a call without a folder of its own configures another project: no option of it stands in the tree.

    A page may say in a sentence alone what its options are for. Submodules that are not there may declare any option.
    """
    names = _NAME.findall(said.text)
    if said.value != "." or not names or repository.has(".gitmodules"):
        return False
    return repository.once(_words).isdisjoint(names)


def _words(repository: Repository) -> frozenset[str]:
    """Return the words of the files of CMake, once for all calls of a page."""
    files = (*repository.named("CMakeLists.txt"), *repository.suffixed(".cmake"))
    texts = (repository.read(file) for file in files if file.size <= MAX_SIZE)
    return frozenset(word for text in texts for word in _WORD.findall(text))


def options_of(words: Sequence[str]) -> str:
    """Return the options of a call, ``-D GUI=ON`` written as one word, and ``-DGUI:=ON`` as ``-DGUI=ON``.

    Of flags of the compiler, those stay that do not ask for the author's machine; a sign stands for each blank in them.
    """
    apart = _SEPARATE.sub(" -D", joined(words)).split()
    return " ".join(filter(None, map(_option, apart)))


def _option(word: str) -> str:
    """Return an option as it is kept, ``""`` for another word."""
    if flags := _FLAGS.fullmatch(written(word)):
        kept = BLANK.join(flag for flag in flags[2].split() if not _OF_MACHINE.fullmatch(flag))
        return f"{flags[1]}={kept}" if kept else ""
    return word.replace(":=", "=", 1) if _OPTION.fullmatch(word) else ""


def preset_of(words: Sequence[str]) -> str:
    """Return `` --preset=NAME`` of a call of CMake, however it is written; ``""`` without one."""
    names = [word.removeprefix(PRESET) for word in words if word.startswith(PRESET)]
    names += [word for before, word in pairwise(words) if before == PRESET.rstrip("=")]
    return f" {PRESET}{names[0]}" if names else ""


def folder_of(words: Sequence[str], here: str) -> str:
    """Return the folder that a call of CMake names by a path, ``""`` for ``..`` and for none.

    ``here``: the folder that the text is in, from which ``../src`` is one beside it.
    """
    source = _source(words)
    if source.startswith(".."):
        return _beside(source, here)
    return source.replace(UNKNOWN, "").strip("/")


def _beside(source: str, here: str) -> str:
    """Return the folder that ``../src`` means from ``here``, ``""`` for ``..`` alone and for what is not known."""
    path = posixpath.normpath(source)
    if path.replace("../", "").strip(".") == "":
        return ""
    there = posixpath.normpath(posixpath.join(here, path))
    return "" if there.startswith("..") or UNKNOWN in there else there


def _source(words: Sequence[str]) -> str:
    """Return the source that a call of CMake is given: by its option, or as a word of its own.

    https://cmake.org/cmake/help/latest/manual/cmake.1.html#generate-a-project-buildsystem, 2026-11-26.
    """
    source = ""
    for before, word in pairwise(words):
        if before in _SOURCE or (word[:2] in _SOURCE and word not in _SOURCE):
            return word if before in _SOURCE else word[2:]
        if not word.startswith("-") and before not in _VALUED:
            source = word
    return source


def below(folder: str, path: str) -> str:
    """Return what stands in a path behind a folder of that name, ``""`` without one."""
    parts = path.split("/")
    return "/".join(parts[parts.index(folder) + 1 :]) if folder in parts else ""


def installs(program: str, words: Sequence[str], *, configured: bool) -> bool:
    """Tell whether a command installs what is compiled, ``dpkg -i`` where CMake was called: what CPack made."""
    if program == "dpkg":
        return configured and bool({"-i", "--install"} & {*words})
    return bool({"install", "--install"} & {*words})


def by_hand(
    said: GitSource, program: str, options: str, folder: str, here: str, *, configured: bool, prepared: bool
) -> GitSource:
    """Return a clone as a text compiles and installs it: with which options, by CMake or make.

    ``folder`` is the one that CMake is told, ``here`` the one that the text is in, where make finds its Makefile.
    """
    by_cmake = said.configured or configured
    by_make = program == "make" and not (by_cmake or prepared)
    inside = below(said.folder, here if by_make else folder)
    return replace(said, installed=True, options=options, below=inside, configured=by_cmake, by_make=by_make)


def prepares(program: str) -> bool:
    """Tell whether a command may write the Makefile that is called after it: ``qmake``, ``./configure``, a script."""
    return bool(_PREPARES.match(program))


def source_of(folder: str, words: Sequence[str]) -> str:
    """Return the folder that is configured from this one, ``.`` where the text begins.

    A folder whose name begins with ``build`` is one to build in, and so is any other from which ``cmake ..`` is called.
    """
    if named := _beside(_source(words), folder) if folder else "":
        return named
    source = _BUILD_FOLDER.sub("", folder)
    if source == folder and {"..", "../"} & {*words}:
        source = posixpath.dirname(folder)
    return source or "."
