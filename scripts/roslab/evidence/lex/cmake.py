"""The CMake language, as far as readers need it: calls with their words, lines and surrounding conditions.

Only the calls that a reader asks for are split into words; one pattern skips the rest of a file, so that the time is
linear in its size. No library is used: the condition around each call and bounds for hostile files are needed, and
the parsers of formatters give neither.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from types import MappingProxyType

from roslab.evidence.lex.cmake_loops import COMPONENT, MAX_EXPANSION, MAX_VALUE, Loops, filled
from roslab.evidence.lex.constants import FALSE, TRUE, set_once
from roslab.evidence.lex.truth import workspace_holds
from roslab.values.dataclass import dataclass, field
from roslab.values.pattern import pattern

_CALL = pattern(r"\n[ \t]*(\w+)[ \t]*\(")
"""It begins with the end of the line before, which is found many times faster than the beginning of a line."""
_BRACKET_COMMENT = pattern(r"#\[(=*)\[.*?\]\1\]", re.DOTALL)
_TOKEN = pattern(
    r"#[^\n]*|\"([^\"\\]*(?:\\.[^\"\\]*)*)\"|\[(=*)\[(.*?)\]\2\]|([()])|"
    r"((?:[^\s()#\"\\]|\\.)[^\s()#\"\\]*(?:\\.[^\s()#\"\\]*)*)",
    re.DOTALL,
)
_UNPLAIN = pattern(r"[\"#(\\\[]")
"""What the words of a call have that are more than words with blanks between them."""
_OPENERS = frozenset({"if", "while", "function", "macro", "foreach", "block"})
_FUNCTIONS = frozenset({"function", "macro"})
_CONTROL = _OPENERS - {"while", "block"} | {
    *("elseif", "else", "endif", "endforeach", "endfunction", "endmacro", "set", "list", "option", COMPONENT)
}
FROM_HERE = pattern(r"^(?:\$\{(?:CMAKE_CURRENT_SOURCE_DIR|CMAKE_CURRENT_LIST_DIR|PROJECT_SOURCE_DIR)\}/|\./)")
"""How a path below the folder of the CMakeLists.txt may begin."""
PROJECT, WHOLE = "PROJECT_NAME", "CMAKE_PROJECT_NAME"
_NEVER, _ALWAYS, _AFTER = "NEVER ", "ALWAYS ", "NEVER AFTER "
"""Conditions that variables which are set once decide; the last one is that of the other branches of the second."""
_ON = frozenset({("ON",), ("TRUE",), ("1",), ("YES",)})
_OFF = frozenset({("OFF",), ("FALSE",), ("0",), ("NO",)})
NOTHING: Mapping[str, tuple[str, ...]] = MappingProxyType({})
MAX_WORDS = 400
"""Most words of one call; a longer one is a list of source files."""
MAX_LENGTH = 64 * 1024
"""Most characters of one call."""
MAX_CONDITIONS = 20
"""Most nested ``if`` blocks whose conditions are kept; deeper ones are only counted."""
MAX_TOTAL = 300_000
"""Most words of one file; the words of an unclosed call count again for each call inside it."""


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
    written: tuple[str, ...] = ()
    """The words as they are written."""


EVERY = frozenset({"*"})
"""The names of all calls."""


def calls(
    text: str,
    names: frozenset[str],
    options: dict[str, bool] | None = None,
    repeated: frozenset[str] = frozenset(),
    variables: Mapping[str, tuple[str, ...]] = NOTHING,
) -> Iterator[Call]:
    """Yield the calls of the given lower-cased names in order; a name may end in ``*``.

    ``options``: those that are declared where the text begins, and whether each is on; its own are added on the way.
    So are ``variables`` of the file that adds the folder. ``repeated``: names whose calls in a ``foreach`` are yielded
    once for each round; of all others one stands for all.
    """
    if "#[" in text:
        text = _BRACKET_COMMENT.sub(lambda match: "\n" * match[0].count("\n"), text)
    scope = _Scope(options={} if options is None else options, variables=dict(variables))
    beginnings = tuple(name[:-1] for name in names if name.endswith("*"))
    text = f"\n{text}"
    scope.text = text
    position, line, total = 0, 0, 0
    for match in _CALL.finditer(text):
        name = match[1].lower()
        asked = name in names or name.startswith(beginnings)
        if not asked and name not in _CONTROL:
            continue
        line += text.count("\n", position, match.start(1))
        position = match.start(1)
        raw = _words(text, match.end())
        total += len(raw)
        if total > MAX_TOTAL:
            return
        scope.enter(name, raw)
        if not asked or scope.never:
            continue
        once = () if name in repeated and scope.loops.around else (tuple(filled(raw, scope.variables)),)
        for words in once or scope.loops.rounds(raw, scope.variables):
            yield Call(
                name=name,
                words=words,
                line=line,
                conditions=tuple(c for c in scope.conditions[:MAX_CONDITIONS] if not c.startswith(_ALWAYS)),
                in_function=not _FUNCTIONS.isdisjoint(scope.stack[:MAX_CONDITIONS]),
                written=tuple(raw),
            )


@dataclass
class _Scope:
    """The state at one point of a file: variables, options, enclosing blocks."""

    variables: dict[str, tuple[str, ...]] = field(default_factory=dict)
    options: dict[str, bool] = field(default_factory=dict)
    """Those that are declared, and whether each is on."""
    conditions: list[str] = field(default_factory=list)
    stack: list[str] = field(default_factory=list)
    text: str = ""
    """The whole file."""
    off: set[str] = field(default_factory=set)
    """Variables that are false from the beginning to the end."""
    on: set[str] = field(default_factory=set)
    """Those that are true."""
    loops: Loops = field(default_factory=Loops)
    decided: dict[str, str] = field(default_factory=dict)
    """Variables that are on where a condition of the build tool holds, each with that condition."""

    @property
    def never(self) -> bool:
        """The calls here are those of no build: they wait for a variable that is never set."""
        return bool(self.off or self.on) and any(condition.startswith(_NEVER) for condition in self.conditions)

    @property
    def waits(self) -> bool:
        """The calls here wait for an option that is off by default."""
        return any(condition.startswith("OFF ") for condition in self.conditions)

    def enter(self, name: str, words: list[str]) -> None:
        """Apply a call that changes the state (``set``, ``if`` …)."""
        if name in _OPENERS:
            self.stack.append(name)
            if name == "if":
                self.conditions.append(self._condition(words))
            elif name == "foreach" and words:
                values = self.loops.enter(words, self.variables)
                self.variables[words[0]] = (" ".join(values),)  # one word stands for all iterations
        elif name in {"elseif", "else"} and self.conditions:
            self.conditions[-1] = self._otherwise(self.conditions[-1], words if name == "elseif" else None)
        elif name.startswith("end") and name[3:] in _OPENERS:
            if self.stack:
                self.stack.pop()
            if name == "endif" and self.conditions:
                self.conditions.pop()
            elif name == "endforeach":
                self.loops.leave()
        elif words and not self.never:
            self._assign(name, words)

    def _assign(self, name: str, words: list[str]) -> None:
        if name in {"set", COMPONENT}:
            self.loops.note(name, words)
        if name == "project" and not self.waits:
            value = tuple(filled(words[:1], self.variables))
            self.variables[PROJECT] = value
            self.variables.setdefault(WHOLE, value)
        if name == "set" and len(words) <= MAX_EXPANSION:
            values = (w for w in filled(words[1:], self.variables) if w not in {"CACHE", "PARENT_SCOPE", "FORCE"})
            self.variables[words[0]] = tuple(values)[:MAX_EXPANSION]
            alone = len(words) == 2 and not self.stack and words[0] not in self.options
            written = words[1].upper() if alone else ""
            if written in FALSE | TRUE and set_once(self.text, words[0]):
                (self.on if written in TRUE else self.off).add(words[0])
            self._decide(words[0], self.variables[words[0]][:1])
            if words[0] in self.options and self.variables[words[0]][:1] in {("ON",), ("TRUE",), ("1",)}:
                self.options[words[0]] = True
        elif name == "list" and len(words) > 2 and words[0].upper() == "APPEND":
            more = (*self.variables.get(words[1], ()), *filled(words[2:], self.variables))
            self.variables[words[1]] = more[:MAX_EXPANSION]
        elif name == "option":
            on = len(words) > 2 and words[-1].upper() in {"ON", "TRUE", "1", "YES"}
            self.options.setdefault(words[0], on)

    def _decide(self, name: str, value: tuple[str, ...]) -> None:
        """Note a variable that the branches of a condition of the build tool set."""
        here = self.conditions[-1] if self.conditions else ""
        if workspace_holds(here, 1) is None or value not in _ON | _OFF:
            self.decided.pop(name, None)
            return
        on = here if value in _ON else negated(here)
        if self.decided.setdefault(name, on) != on:
            del self.decided[name]

    def _condition(self, words: list[str]) -> str:
        """Return a condition's text: ``OFF NAME`` of an option that is off by default, else ``ON NAME``.

        ``NEVER …`` and ``ALWAYS …`` are those that a variable which is set once decides; of a variable that a condition
        of the build tool decides, it is that condition.
        """
        name = words[0].removeprefix("${").removesuffix("}") if len(words) == 1 else ""
        if (last := words[-1].removeprefix("${").removesuffix("}") if words else "") in self.decided:
            if len(words) == 1:
                return self.decided[last]
            if len(words) == 2 and words[0] == "NOT":
                return negated(self.decided[last])
        if name in self.options:
            return f"{'ON' if self.options[name] else 'OFF'} {name}"
        if self.on and (decided := self._with_constants(words)):
            return decided
        joined = all(word == "AND" for word in words[1::2])
        if self.off and (name in self.off or (joined and not self.off.isdisjoint(words[::2]))):
            return _NEVER + " ".join(words)[:MAX_VALUE]
        return " ".join(words)[:MAX_VALUE]

    def _with_constants(self, words: list[str]) -> str:
        """Return a condition's text without variables that stay true; empty where it has none of them."""
        names = [word.removeprefix("${").removesuffix("}") for word in words]
        if len(words) == 2 and words[0] == "NOT" and names[1] in self.on:
            return _NEVER + " ".join(words)[:MAX_VALUE]
        if self.on.isdisjoint(names[::2]) or any(word != "AND" for word in words[1::2]):
            return ""
        left = [word for word, name in zip(words[::2], names[::2], strict=True) if name not in self.on]
        return self._condition(" AND ".join(left).split()) if left else _ALWAYS + " ".join(words)[:MAX_VALUE]

    def _otherwise(self, before: str, words: list[str] | None) -> str:
        """Return the condition of the next branch after one: of an ``elseif`` with its words, or of the ``else``."""
        if before.startswith((_ALWAYS, _AFTER)):
            return _AFTER + before.removeprefix(_ALWAYS).removeprefix(_AFTER)
        if words is None:
            return f"NOT ({before})"[:MAX_VALUE]
        condition = self._condition(words)
        return " ".join(words)[:MAX_VALUE] if condition.startswith(_ALWAYS) else condition


def negated(condition: str) -> str:
    """Return the text of a condition's opposite."""
    return condition[len("NOT (") : -1] if condition.startswith("NOT (") else f"NOT ({condition})"[:MAX_VALUE]


def _words(text: str, start: int) -> list[str]:
    """Split the words of a call, from after its parenthesis to the closing one."""
    end = text.find(")", start, start + MAX_LENGTH)
    if end >= 0 and not _UNPLAIN.search(text, start, end):  # as most are
        return text[start:end].split()[:MAX_WORDS]
    words: list[str] = []
    depth = 1
    for match in _TOKEN.finditer(text, start, start + MAX_LENGTH):
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
