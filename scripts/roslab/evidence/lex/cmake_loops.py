"""Words of CMake with the values of variables filled in, once for all rounds of a ``foreach`` or once for each."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator, Mapping
from itertools import islice, product

from roslab.values.dataclass import dataclass, field
from roslab.values.pattern import pattern

MAX_EXPANSION = 200
"""Most words of one variable, and most rounds of loops."""
MAX_VALUE = 2_000
"""Most characters of one word; a longer one comes from variables that double themselves."""
MAX_BODY = 20
"""Most calls inside a loop that give variables their values and are repeated in each round."""
COMPONENT = "get_filename_component"
_VARIABLE = pattern(r"\$\{(\w+)\}")
_NUMBER = pattern(r"\d{1,9}")
_OF_RANGE = 3
_KEYWORDS = frozenset({"CACHE", "PARENT_SCOPE", "FORCE"})

Variables = Mapping[str, tuple[str, ...]]


@dataclass
class _Loop:
    variable: str
    values: tuple[str, ...]
    body: list[tuple[str, list[str]]] = field(default_factory=list)


@dataclass
class Loops:
    """The ``foreach`` blocks around a place, the outermost first."""

    around: list[_Loop] = field(default_factory=list)

    def enter(self, words: list[str], variables: Variables) -> tuple[str, ...]:
        """Enter a ``foreach``; return the values of its variable."""
        values = tuple(islice(_looped(words[1:], variables), MAX_EXPANSION))
        self.around.append(_Loop(words[0], () if "ZIP_LISTS" in words else values))
        return values

    def leave(self) -> None:
        """Leave the innermost one."""
        if self.around:
            self.around.pop()

    def note(self, name: str, words: list[str]) -> None:
        """Note a call of the innermost one that gives a variable its value."""
        if self.around and len(self.around[-1].body) < MAX_BODY:
            self.around[-1].body.append((name, words))

    def rounds(self, words: list[str], variables: Variables) -> Iterator[tuple[str, ...]]:
        """Yield the words of a call, in loops of whose variables they have some for each round."""
        named = {name for word in words for name in _VARIABLE.findall(word)}
        loops = [loop for loop in self.around if loop.values]
        ours = {name for loop in loops for name in (loop.variable, *(each[0] for _, each in loop.body))}
        if named.isdisjoint(ours):
            yield tuple(filled(words, variables))
            return
        for values in islice(product(*(loop.values for loop in loops)), MAX_EXPANSION):
            here = dict(variables)
            for loop, value in zip(loops, values, strict=True):
                here[loop.variable] = (value,)
                for name, assigned in loop.body:
                    here[assigned[0]] = tuple(_assigned(name, assigned, here))
            yield tuple(filled(words, here))


def _assigned(name: str, words: list[str], variables: Variables) -> Iterator[str]:
    """Yield the value that a call gives the variable which it names first."""
    given = [word for word in filled(words[1:], variables) if word not in _KEYWORDS]
    if name == COMPONENT:
        file = posixpath.basename(given[0]) if given else ""
        shorter = {"NAME_WE": file.split(".")[0], "NAME_WLE": posixpath.splitext(file)[0], "NAME": file}
        yield shorter.get(given[1] if len(given) > 1 else "", f"${{{words[0]}}}")
    else:
        yield from given[:MAX_EXPANSION]


def _looped(words: list[str], variables: Variables) -> Iterator[str]:
    """Yield what a ``foreach`` iterates over: ``IN LISTS`` names variables, everything else is a value."""
    if words[:1] == ["RANGE"]:
        yield from _numbers(tuple(filled(words[1:], variables)))
        return
    lists = False
    for word in words:
        if word in {"IN", "ITEMS", "LISTS"}:
            lists = word == "LISTS"
        elif lists:
            yield from variables.get(word, ())
        else:
            yield from filled([word], variables)


def _numbers(words: tuple[str, ...]) -> Iterator[str]:
    """Yield the numbers of ``RANGE [START] STOP [STEP]``, of which STOP is one."""
    given = [int(word) for word in words if _NUMBER.fullmatch(word)]
    if len(given) == len(words) and 0 < len(given) <= _OF_RANGE:
        start, stop, step = (*given, 1) if len(given) == 2 else (0, *given, 1) if len(given) == 1 else given
        yield from map(str, range(start, stop + 1, step or 1))


def filled(words: list[str], variables: Variables) -> Iterator[str]:
    """Fill in known variables; what is unknown or grows without end stays as written."""
    for word in words:
        if "${" not in word:
            if ";" in word and "/" not in word:
                yield from word.split(";")
            else:
                yield word
            continue
        whole = _VARIABLE.fullmatch(word)
        if whole:
            yield from variables.get(whole[1], (word,))
        else:
            yield _VARIABLE.sub(lambda match: " ".join(variables.get(match[1], (match[0],))), word)[:MAX_VALUE]
