"""Files of code that nothing compiles: a CMakeLists.txt lists its sources by name, and they are not among them."""

from __future__ import annotations

import re
from collections.abc import Iterable
from functools import cached_property

from roslab.repository.checkout import Repository
from roslab.values.dataclass import dataclass
from roslab.values.pattern import pattern

_SOURCES = (".cpp", ".cc", ".cxx", ".c", ".cu")
_LISTS = (
    "CMakeLists.txt",
    "Makefile",
    "makefile",
    "GNUmakefile",
    "setup.py",
    "meson.build",
    "SConstruct",
    "SConscript",
)
"""What may list the sources of a folder, of which CMake's tells that they are listed by name."""
_ALSO = (".cmake", ".pro", ".pri", ".bazel", ".gyp", ".gypi")
MOST = 3_000
"""Most lists that are read."""
_COMMENT = pattern(r"#[^\n]*")
_WORD = pattern(r"[^\s/\"'(){};,:=$]+")
_CODE = pattern(r"\w\.(?:cpp|cc|cxx|c|cu)\b")
_OUT = pattern(r"(?:\.\./|\$\{?\w*\}?/)[\w./-]*\.(?:cpp|cc|cxx|c|cu)\b")
"""A source in a folder that is not the list's own, or that a variable gives."""
_ANY = pattern(
    r"(?i:\bGLOB(?:_RECURSE)?\b|\baux_source_directory\b)|\bwildcard\b|\bglob\(|[*%}][\w-]*\.(?:cpp|cc|cxx|c|cu)\b|"
    r"\bament_auto_add_\w+\s*\([^)]*\bDIRECTORY\b"
)
"""What takes sources of any name."""
_NAMED = pattern(r"\$\{\w+\}[\w-]*\.(?:cpp|cc|cxx|c|cu)\b")
"""A source whose name a variable begins."""
_STEP = pattern(
    r"\bset\s*\(\s*(\w+)\b([^()]*)\)|\bproject\s*\(\s*([\w-]+)|\b(end)?(?:if|foreach|while|function|macro)\s*\(|"
    r"\$\{(\w+)\}",
    re.IGNORECASE,
)
"""What gives a variable a value, opens or closes a block, or takes the value."""
_PLAIN = pattern(r"[\w./+-]+")


@dataclass(frozen=True, kw_only=True)
class _Lists:
    """The lists of a folder and those above: whether they may take sources of any name, or CMake's name theirs."""

    texts: tuple[str, ...] = ()
    of_any: bool = False
    by_name: bool = False

    @cached_property
    def words(self) -> frozenset[str]:
        """Their words, with and without endings."""
        return _words_of(self.texts)


class Unlisted:
    """What the lists of a tree tell about its sources; they are read once something is asked."""

    def __init__(self, repository: Repository) -> None:
        self._repository = repository
        self._by_folder: dict[str, _Lists] = {}

    def has(self, path: str) -> bool:
        """Tell whether no list names a source, though the CMakeLists.txt of its folder, or of one above, names others.

        A name without its ending counts as well: a loop may give the ending. Of several files of one name, each is that
        of the list of its own folder or one above, unless a list leads out of its folder.
        """
        folder, _, name = path.rpartition("/")
        if not name.endswith(_SOURCES):
            return False
        lists = self._lists(folder)
        if lists.of_any or not lists.by_name:
            return False
        apart = len(self._repository.named(name)) > 1 and not self._leads_out
        return {name, name.rpartition(".")[0]}.isdisjoint(lists.words if apart else self._words)

    def _lists(self, folder: str) -> _Lists:
        """Return what the lists of a folder and those above tell."""
        if folder not in self._by_folder:
            own = {name: text for name in _LISTS if (text := self._text(folder, name))}
            above = self._lists(folder.rpartition("/")[0]) if folder else _Lists()
            self._by_folder[folder] = _Lists(
                texts=(*own.values(), *above.texts),
                of_any=above.of_any or any(map(_ANY.search, own.values())),
                by_name=above.by_name or bool(_CODE.search(own.get(_LISTS[0], ""))),
            )
        return self._by_folder[folder]

    def _text(self, folder: str, name: str) -> str:
        path = f"{folder}/{name}" if folder else name
        text = _COMMENT.sub("", self._repository.read(path)) if self._repository.has(path) else ""
        return _filled(text) if name == _LISTS[0] and _NAMED.search(text) else text

    @cached_property
    def _words(self) -> frozenset[str]:
        """The words of every list of the tree, with and without their endings."""
        return _words_of(self._texts)

    @cached_property
    def _texts(self) -> tuple[str, ...]:
        files = (*self._repository.named(*_LISTS, "BUILD"), *self._repository.suffixed(*_ALSO))[:MOST]
        return tuple(_COMMENT.sub("", self._repository.read(file)) for file in files)

    @cached_property
    def _leads_out(self) -> bool:
        return any(map(_OUT.search, self._texts))


def _filled(text: str) -> str:
    """Return the text of a CMakeLists.txt with the values of variables, each as it was last set above.

    Not in blocks, where what was set is left open, nor what a block or more than one plain word sets.
    """
    values: dict[str, str] = {}
    parts: list[str] = []
    depth = end = 0
    for match in _STEP.finditer(text):
        name, given, project, used = match[1], match[2], match[3], match[5]
        if name:
            values.pop(name, None)
            words = given.split()
            if depth == 0 and len(words) == 1 and _PLAIN.fullmatch(words[0]):
                values[name] = words[0]
        elif project:
            values["PROJECT_NAME"] = project
        elif used is None:
            depth += -1 if match[4] else 1
        elif depth == 0 and used in values:
            parts += (text[end : match.start()], values[used])
            end = match.end()
    return "".join((*parts, text[end:]))


def _words_of(texts: Iterable[str]) -> frozenset[str]:
    words = frozenset[str]().union(*(_WORD.findall(text) for text in texts))
    return words | {word.rpartition(".")[0] for word in words}
