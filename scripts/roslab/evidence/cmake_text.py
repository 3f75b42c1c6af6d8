"""CMake's language as far as a reader needs it: calls with their words, lines and the conditions around them.

Only the calls that a reader asks for are cut into words; the rest of a file is passed over by one pattern, so that a
CMakeLists.txt of a million lines costs no more than its bytes.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass

_BRACKET_COMMENT = re.compile(r"#\[(=*)\[.*?\]\1\]", re.DOTALL)
_TOKEN = re.compile(r"#[^\n]*|\"((?:[^\"\\]|\\.)*)\"|\[(=*)\[(.*?)\]\2\]|([()])|((?:[^\s()#\"\\]|\\.)+)", re.DOTALL)
_VARIABLE = re.compile(r"\$\{(\w+)\}")
_OPENERS = frozenset({"if", "while", "function", "macro", "foreach", "block"})
_CONTROL = ("if", "elseif", "else", "endif", "foreach", "endforeach", "function", "endfunction", "macro", "endmacro", "set", "list", "option")
MAX_WORDS = 400
"""Words of one call: a longer one is a list of source files."""
MAX_EXPANSION = 200


@dataclass(frozen=True, kw_only=True, slots=True)
class Call:
    """One call: its name in lower case, its words with known variables filled in, its line.

    ``conditions`` are the ``if`` texts around it, the outermost first; ``else`` of ``X`` is ``NOT (X)``.
    """

    name: str
    words: tuple[str, ...]
    line: int
    conditions: tuple[str, ...] = ()
    in_function: bool = False


def calls(text: str, names: frozenset[str]) -> Iterator[Call]:
    """Yield the calls of the given lower-cased names in order; ``names`` may end in ``*``."""
    if "#[" in text:
        text = _BRACKET_COMMENT.sub(lambda match: "\n" * match[0].count("\n"), text)
    variables: dict[str, tuple[str, ...]] = {}
    options: dict[str, bool] = {}
    conditions: list[str] = []
    stack: list[str] = []
    position, line = 0, 1
    for match in _opener(names).finditer(text):
        name = match[1].lower()
        line += text.count("\n", position, match.start(1))
        position = match.start(1)
        raw = _words(text, match.end())
        if name in _OPENERS:
            stack.append(name)
            if name == "if":
                conditions.append(_condition(raw, options))
            elif name == "foreach" and raw:
                variables[raw[0]] = tuple(_looped(raw[1:], variables))[:MAX_EXPANSION]
        elif name in {"elseif", "else"} and conditions:
            conditions[-1] = _condition(raw, options) if name == "elseif" else f"NOT ({conditions[-1]})"
        elif name.startswith("end") and name[3:] in _OPENERS:
            if stack:
                stack.pop()
            if name == "endif" and conditions:
                conditions.pop()
        elif name == "set" and raw:
            if len(raw) <= MAX_EXPANSION:
                variables[raw[0]] = tuple(word for word in _filled(raw[1:], variables) if word not in {"CACHE", "PARENT_SCOPE", "FORCE"})
        elif name == "list":
            if len(raw) > 2 and raw[0].upper() == "APPEND":
                variables[raw[1]] = (*variables.get(raw[1], ()), *_filled(raw[2:], variables))[:MAX_EXPANSION]
        elif name == "option" and raw:
            options[raw[0]] = len(raw) > 2 and raw[-1].upper() in {"ON", "TRUE", "1", "YES"}
        if not _asked(name, names):
            continue
        yield Call(
            name=name,
            words=tuple(_filled(raw, variables)),
            line=line,
            conditions=tuple(conditions),
            in_function=any(part in {"function", "macro"} for part in stack),
        )


def _looped(words: list[str], variables: dict[str, tuple[str, ...]]) -> Iterator[str]:
    """Return what a ``foreach`` runs over: ``IN LISTS`` names variables, everything else is a value."""
    lists = False
    for word in words:
        if word in {"IN", "ITEMS", "LISTS"}:
            lists = word == "LISTS"
        elif lists:
            yield from variables.get(word, ())
        else:
            yield from _filled([word], variables)


def _asked(name: str, names: frozenset[str]) -> bool:
    return name in names or any(pattern.endswith("*") and name.startswith(pattern[:-1]) for pattern in names)


_OPENER_CACHE: dict[frozenset[str], re.Pattern[str]] = {}


def _opener(names: frozenset[str]) -> re.Pattern[str]:
    if names not in _OPENER_CACHE:
        parts = "|".join(sorted((name.replace("*", r"\w*") for name in {*names, *_CONTROL}), key=len, reverse=True))
        _OPENER_CACHE[names] = re.compile(rf"^[ \t]*({parts})[ \t]*\(", re.MULTILINE | re.IGNORECASE)
    return _OPENER_CACHE[names]


def _words(text: str, start: int) -> list[str]:
    """Cut the words of a call from behind its parenthesis to the one that closes it."""
    words: list[str] = []
    depth = 1
    for match in _TOKEN.finditer(text, start, start + 65536):
        if match[4]:
            depth += 1 if match[4] == "(" else -1
            if not depth:
                break
        elif match[1] is not None:
            words.append(match[1])
        elif match[3] is not None:
            words.append(match[3])
        elif match[5]:
            words.append(match[5])
        if len(words) >= MAX_WORDS:
            break
    return words


def _filled(words: tuple[str, ...] | list[str], variables: dict[str, tuple[str, ...]]) -> Iterator[str]:
    """Fill in the variables that are known lists; what is unknown stays as written."""
    for word in words:
        if "${" not in word:
            yield from word.split(";") if ";" in word and "/" not in word else (word,)
            continue
        whole = _VARIABLE.fullmatch(word)
        if whole:
            yield from variables.get(whole[1], (word,))
        else:
            yield _VARIABLE.sub(lambda match: " ".join(variables.get(match[1], (match[0],))), word)


def _condition(words: list[str], options: dict[str, bool]) -> str:
    """Return a condition's text; an option that is off by default makes it ``OFF``."""
    if len(words) == 1 and options.get(words[0]) is False:
        return f"OFF {words[0]}"
    return " ".join(words)
