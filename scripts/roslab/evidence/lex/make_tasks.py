"""Recipes of a Makefile, as a shell runs their lines: for targets that are tasks and no files.

https://www.gnu.org/software/make/manual/html_node/Recipes.html, read 2026-11-28.
"""

from __future__ import annotations

import re
from collections.abc import Mapping

from roslab.values.dataclass import dataclass
from roslab.values.pattern import pattern

NAMES = ("GNUmakefile", "makefile", "Makefile")
"""What make reads if it is given no file: the first of these."""
MAX_LINES = 3_000
MAX_LINE = 2_000
MOST = 30
"""Most lines that a call stands for, and most targets that these are of."""
_SET = pattern(r"(?:override[ \t]+|export[ \t]+)*([A-Za-z_][\w.-]{0,60})[ \t]*(::?:?|\?|\+|)=[ \t]*(.*)$")
_RULE = pattern(r"([\w./ -]{1,200}?)[ \t]*::?(?![:=])([^;#=]*)(?:;(.*))?")
_BRANCH = pattern(r"[ \t]*(ifn?eq|ifn?def|endif|define|endef)\b")
_CONTINUED = pattern(r"(?<![ \t])[ \t]*\\\n[ \t]*")
_FILLED = pattern(r"\$(?:\(([^()$\n]{0,200})\)|\{([^{}$\n]{0,200})\}|(\$)|([@<^]))")
_NAME = pattern(r"[\w.-]+")
_OWN = {"CURDIR": ".", "PWD": ".", "MAKE": "make", "SHELL": "bash"}
_OF_ENVIRONMENT = frozenset({"HOME", "USER", "PATH", "PYTHONPATH", "LD_LIBRARY_PATH", "ROS_DISTRO"})
_ONE_SHELL = ".ONESHELL"
"""A file with this target gives a shell all lines of a recipe at once, of which it goes to folders for those after."""
_CALLED = pattern(
    r"(?:make|gmake)[ \t]+((?:-s[ \t]+|--no-print-directory[ \t]+)*)([\w-]+)((?:[ \t]+\w+=[\w./:-]*)*)[ \t]*$"
)
_UNREAD = "\x00"
"""What stands in a line for a value that only make knows, and for a line that it may leave out."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Target:
    """One target with its own lines."""

    first: tuple[str, ...]
    """What it needs."""
    lines: tuple[str, ...]


@dataclass(frozen=True, kw_only=True, slots=True)
class MakeTasks:
    """What a file defines."""

    targets: Mapping[str, Target]
    variables: Mapping[str, str]

    def lines_of(self, name: str, given: Mapping[str, str]) -> tuple[str, ...]:
        """Return the lines of a target, none where one is not known; ``given``: variables of the call."""
        target = self.targets.get(name) if _ONE_SHELL not in self.targets else None
        found: list[str] = []
        for line in target.lines if target else ():
            if len(found) > MOST:
                break
            filled = self.filled(line, {**given, "@": name})
            called = _CALLED.match(filled)
            if called and called[2] in self.targets and called[2] != name and len(found) < MOST:
                words = dict(word.split("=", 1) for word in called[3].split())
                found += self._inside(called[2], {**given, **words})
            else:
                found.append(filled)
        return () if len(found) > MOST or any(_UNREAD in line for line in found) else tuple(filter(None, found))

    def needed_by(self, name: str) -> tuple[str, ...]:
        """Return the targets that a target needs, each after those that it needs itself."""
        found: dict[str, None] = {}
        self._needed(name, found, 0)
        return tuple(each for each in found if each != name)

    def _needed(self, name: str, found: dict[str, None], depth: int) -> None:
        if name in found or depth > MOST or len(found) > MOST or name not in self.targets:
            return
        for each in self.targets[name].first:
            self._needed(each, found, depth + 1)
        found[name] = None

    def _inside(self, name: str, given: Mapping[str, str]) -> list[str]:
        """Return the lines of a target that another one calls, without what those call in turn."""
        return [self.filled(line, {**given, "@": name}) for line in self.targets[name].lines[: MOST + 1]]

    def filled(self, line: str, given: Mapping[str, str]) -> str:
        """Return a line with the values of variables in it; what nothing sets is nothing to make, too."""
        return self._filled(line, {**self.variables, **given}, 0)

    def _filled(self, line: str, known: Mapping[str, str], depth: int) -> str:
        if depth > 8 or len(line) > MAX_LINE:
            return _UNREAD

        def value(match: re.Match[str]) -> str:
            if match[3]:
                return "\x01"
            name = (match[1] or match[2] or match[4] or "").strip()
            if name in _OF_ENVIRONMENT and name not in known:
                return f"\x01{name}"
            if not _NAME.fullmatch(name) and name != "@":
                return _UNREAD
            return known.get(name, _OWN.get(name, ""))

        filled = _FILLED.sub(value, line, count=MOST)
        if "$" in filled and filled != line:
            return self._filled(filled, known, depth + 1)
        return (_UNREAD if "$" in filled else filled.replace("\x01", "$")).strip()


def parsed(text: str) -> MakeTasks:
    """Return the targets that are written in full, and the variables."""
    first: dict[str, list[str]] = {}
    bodies: dict[str, list[str]] = {}
    variables: dict[str, str] = {}
    doubted: set[str] = set()
    current: list[str] = []
    depth = 0
    for line in _CONTINUED.sub(" ", text).split("\n", MAX_LINES)[:MAX_LINES]:
        if len(line) > MAX_LINE:
            current = []
        elif line.startswith("\t"):
            for name in current:
                bodies[name].append(_UNREAD if depth else line.strip().lstrip("@-+").strip())
        elif branch := _BRANCH.match(line):
            depth = max(0, depth + (-1 if branch[1].startswith("end") else 1))
            current = [] if branch[1] == "define" else current
        elif variable := _SET.match(line):
            _keep(variables, variable, doubted if depth else None)
            current = []
        elif rule := _RULE.match(line):
            current = [name for name in rule[1].split() if "%" not in name]
            for name in current:
                first.setdefault(name, []).extend(rule[2].replace("|", " ").split())
                bodies.setdefault(name, []).extend([rule[3].strip()] if rule[3] else [])
    targets = {name: Target(first=tuple(first[name]), lines=tuple(filter(None, bodies[name]))) for name in first}
    return MakeTasks(targets=targets, variables=variables)


def _keep(variables: dict[str, str], match: re.Match[str], doubted: set[str] | None) -> None:
    """Take what a line sets a variable to.

    ``doubted``: those that only branches set, in a branch. What stood before one holds, as what stood before ``?=``;
    of what several branches set, nobody knows which.
    """
    name, value = match[1], re.sub(r"(?:^|[ \t])#.*$", "", match[3]).strip()
    if match[2] == "+":
        grown = f"{variables.get(name, '')} {value}".strip()
        variables[name] = grown if len(grown) <= MAX_LINE else _UNREAD
    elif name not in variables:
        variables[name] = value
        if doubted is not None:
            doubted.add(name)
    elif doubted is None and match[2] != "?":
        variables[name] = value
    elif doubted is not None and name in doubted and value != variables[name]:
        variables[name] = _UNREAD
