"""Recipes of a justfile, as far as a shell runs their lines as they stand.

https://just.systems/man/en/, read 2026-11-27.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from itertools import chain

from roslab.values.dataclass import dataclass
from roslab.values.pattern import pattern

MAX_LINES = 3_000
MAX_LINE = 2_000
MOST = 30
"""Most lines that a command stands for, and most recipes that these are of."""
_TEXT = r"(?:\"[^\"\n]*\"|'[^'\n]*')"
_RECIPE = pattern(rf"@?([A-Za-z_][\w-]*)((?:[ \t](?:[^:'\"\n#=]|{_TEXT}|=)*)?):(?!=)(.*)$")
_VARIABLE = pattern(r"(?:export[ \t]+)?([A-Za-z_][\w-]*)[ \t]*:=(.*)$")
_DEFAULT = pattern(rf"(?:env_var_or_default|env)\([ \t]*{_TEXT}[ \t]*,[ \t]*({_TEXT})[ \t]*\)")
_ALIAS = pattern(r"alias[ \t]+([\w-]+)[ \t]*:=[ \t]*([\w-]+)")
_SHELL = pattern(r"set[ \t]+(?:windows-)?shell[ \t]*:=[ \t]*\[[ \t]*[\"'](?:[\w./]*/)?([\w-]+)[\"']")
_OTHERS = pattern(r"\[[^\]\n]*\b(?:windows|macos)\b[^\]\n]*\]")
"""What a recipe is marked with that is for other systems."""
_PARAMETER = pattern(rf"([*+]?)\$?([A-Za-z_][\w-]*)(?:=({_TEXT}|[\w./-]+))?")
_NEEDED = pattern(r"\([ \t]*([\w-]+)([^()\n]*)\)|([\w-]+)|(&&)")
_FILLED = pattern(r"\{\{([^{}\n]*)\}\}")
_HERE = frozenset({"justfile_directory()", "invocation_directory()", "source_directory()"})
_COMMENT = pattern(r"(?:^|\s)#(?![^\n]*['\"]).*$")
_JUST = pattern(r"just[ \t]+([\w-]+)((?:[ \t]+[\w./:=-]+)*)[ \t]*$")


@dataclass(frozen=True, kw_only=True, slots=True)
class Recipe:
    """One recipe."""

    parameters: tuple[tuple[str, str, str | None], ...]
    """Sign (``*``, ``+`` or none), name and default of each; ``None`` where it has none."""
    first: tuple[tuple[str, tuple[str, ...]], ...]
    """The recipes that run before it, with their arguments."""
    after: tuple[tuple[str, tuple[str, ...]], ...]
    lines: tuple[str, ...] | None
    """``None`` for one in another language than the shell's."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Justfile:
    """What a file defines."""

    recipes: Mapping[str, Recipe]
    variables: Mapping[str, str]

    def lines_of(self, name: str, given: Sequence[str] = ()) -> tuple[str, ...] | None:
        """Return what a shell runs for ``just NAME``; ``None`` where that is not known, or is no short command."""
        try:
            found = self._lines(name, tuple(given), set())
        except _TooLongError:
            return None
        return tuple(found) if found else None

    def _lines(self, name: str, given: tuple[str, ...], done: set[tuple[str, tuple[str, ...]]]) -> list[str] | None:
        """Return the lines of a recipe and of those that it needs, none of what is ``done``: each runs once."""
        recipe = self.recipes.get(name)
        values = _values(recipe, given) if recipe else None
        if recipe is None or recipe.lines is None or values is None or len(done) > MOST:
            return None
        if (name, given) in done:
            return []
        done.add((name, given))
        known = {**self.variables, **values}
        parts = chain(
            (self._lines(*other, done) for other in recipe.first),
            (self._line(line, known, done) for line in recipe.lines),
            (self._lines(*other, done) for other in recipe.after),
        )
        found: list[str] = []
        for part in parts:
            if part is None:
                return None
            found += part
            if len(found) > MOST:
                raise _TooLongError
        return found

    def _line(self, line: str, known: Mapping[str, str], done: set[tuple[str, tuple[str, ...]]]) -> list[str] | None:
        """Return what a line of a recipe stands for, those of another one if it calls that."""
        filled = _filled(line, known)
        if filled is None:
            return None
        called = _JUST.match(filled)
        inside = self._lines(called[1], tuple(called[2].split()), done) if called else None
        return [filled] if inside is None else inside


class _TooLongError(Exception):
    """A command stands for more lines than are taken."""


def parsed(text: str) -> Justfile:
    """Return the recipes and the plain variables of a file."""
    recipes: dict[str, Recipe] = {}
    variables: dict[str, str] = {}
    aliases: dict[str, str] = {}
    lines = text.split("\n", MAX_LINES)[:MAX_LINES]
    plain = all(match[1] in {"sh", "bash", "dash", "zsh"} for match in _SHELL.finditer(text))
    marked, at = False, 0
    while at < len(lines):
        line = lines[at][:MAX_LINE].rstrip()
        at += 1
        if alias := _ALIAS.match(line):
            aliases[alias[1]] = alias[2]
        elif variable := _VARIABLE.match(line):
            if (value := _text(variable[2])) is not None:
                variables[variable[1]] = value
        elif recipe := _RECIPE.match(line):
            start = at
            while at < len(lines) and (not lines[at].strip() or lines[at][0] in " \t"):
                at += 1
            if not marked:
                recipes[recipe[1]] = _recipe(recipe[2], recipe[3], lines[start:at] if plain else ["#!"])
        marked = bool(_OTHERS.match(line)) or (marked and line.startswith("["))
    recipes |= {name: recipes[of] for name, of in aliases.items() if of in recipes}
    return Justfile(recipes=recipes, variables=variables)


def _recipe(parameters: str, needed: str, body: Sequence[str]) -> Recipe:
    first: list[tuple[str, tuple[str, ...]]] = []
    after: list[tuple[str, tuple[str, ...]]] = []
    into = first
    for match in _NEEDED.finditer(needed.partition("#")[0]):
        into = after if match[4] else into
        if not match[4]:
            into.append((match[1] or match[3], tuple(_text(word) or word for word in (match[2] or "").split())))
    return Recipe(
        parameters=tuple(
            (match[1], match[2], _text(match[3]) if match[3] else None) for match in _PARAMETER.finditer(parameters)
        ),
        first=tuple(first),
        after=tuple(after),
        lines=_lines(body),
    )


def _lines(body: Sequence[str]) -> tuple[str, ...] | None:
    """Return the lines of a recipe without the signs that only tell just how to print and to stop."""
    written = re.sub(r"\\\n[ \t]*", "", "\n".join(line.strip() for line in body))
    if written.lstrip().startswith("#!") or any(len(line) > MAX_LINE for line in written.split("\n")):
        return None
    lines = (_COMMENT.sub("", line).strip().lstrip("@-").strip() for line in written.split("\n"))
    return tuple(line for line in lines if line)


def _values(recipe: Recipe, given: Sequence[str]) -> dict[str, str] | None:
    """Return the parameters with their values, ``None`` where one that has to be given is not."""
    values: dict[str, str] = {}
    rest = list(given)
    for sign, name, default in recipe.parameters:
        if sign and rest:
            values[name], rest = " ".join(rest), []
        elif rest:
            values[name] = rest.pop(0)
        elif default is None and sign != "*":
            return None
        else:
            values[name] = default or ""
    return None if rest else values


def _filled(line: str, values: Mapping[str, str]) -> str | None:
    """Return a line with the values in it, ``None`` if one is not known."""
    unknown = False

    def value(match: re.Match[str]) -> str:
        nonlocal unknown
        name = match[1].strip()
        found = "." if name in _HERE else values.get(name, _text(name))
        unknown = unknown or found is None
        return found or ""

    filled = _FILLED.sub(value, line)
    return None if unknown or len(filled) > MAX_LINE else filled.strip()


def _text(written: str | None) -> str | None:
    """Return a text without its quotation marks, or the default of a variable; ``None`` for any other expression."""
    written = (written or "").strip()
    if default := _DEFAULT.fullmatch(written):
        written = default[1]
    quoted = len(written) > 1 and written[0] == written[-1] and written[0] in "'\"" and written[0] not in written[1:-1]
    if quoted:
        return written[1:-1]
    return written if re.fullmatch(r"[\w./-]+", written) and not written.isidentifier() else None
