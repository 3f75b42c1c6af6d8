"""What make makes of a Makefile without being told: its first target, which in some is an object file alone.

https://www.gnu.org/software/make/manual/html_node/Goals.html, read 2026-11-27
"""

from __future__ import annotations

import posixpath

from roslab.values.pattern import pattern

_GOAL = pattern(r"^\.DEFAULT_GOAL\s*[:?]?=")
_RULE = pattern(r"^([^\s#:=][^#:=]{0,400}?)\s*::?(?!=)")
_PLAIN = pattern(r"[A-Za-z_][\w./-]{0,80}")
_LINKED = pattern(r"(?<!\S)-o\s*(\$@|[\w./-]{1,80})(?=\s|$|#)")
_ONLY_COMPILES = pattern(r"(?<!\S)-(?:c|S|E|MM?|fsyntax-only)(?!\S)")
_NO_PROGRAMS = (".a", ".so", ".o", ".d", ".dll")
_OTHERS = pattern(
    r"\$[({]MAKE[)}]|\b(?:c?make|ninja|scons|bazel|meson|python[\d.]*|bash|sh)\b|\.(?:sh|py|mk)\b|/configure\b"
)
"""What a recipe calls beside compilers that may call CMake in turn."""


def linking(text: str) -> tuple[tuple[str, str], ...]:
    """Return the targets of a Makefile that link a program, each with its path, where the first target is an object.

    None where make makes a program by itself, or its first target is not written in full.
    """
    goals = _goals(text)
    if not goals or not goals[0][0].endswith(".o") or any(_GOAL.match(line) for line in text.splitlines()):
        return ()
    found: dict[str, str] = {}
    for target, recipe in goals:
        for line in recipe:
            linked = None if _ONLY_COMPILES.search(line) else _LINKED.search(line)
            program = (target if linked[1] == "$@" else linked[1]) if linked else ""
            if program and not program.endswith(_NO_PROGRAMS) and _PLAIN.fullmatch(target):
                found.setdefault(target, posixpath.normpath(program))
    return tuple(found.items())


def recipes(text: str) -> dict[str, list[str]]:
    """Return the recipe of each target that is written in full, with all its rules' lines."""
    found: dict[str, list[str]] = {}
    for targets, recipe in _rules(text):
        for target in targets:
            found.setdefault(target, []).extend(recipe)
    return found


def alone(text: str) -> bool:
    """Tell whether the recipes and variables of a Makefile call no script, no other Makefile and no build tool."""
    return not any(_OTHERS.search(line) for line in text.splitlines() if not line.lstrip().startswith("#"))


def _goals(text: str) -> list[tuple[str, list[str]]]:
    """Return the first target of each rule with its recipe, without those that make never takes for its goal."""
    return [
        (targets[0], recipe)
        for targets, recipe in _rules(text)
        if not any("%" in target for target in targets) and (not targets[0].startswith(".") or "/" in targets[0])
    ]


def _rules(text: str) -> list[tuple[list[str], list[str]]]:
    """Return the targets of each rule with its recipe."""
    rules: list[tuple[list[str], list[str]]] = []
    recipe: list[str] = []
    for line in text.replace("\\\n", " ").splitlines():
        if line.startswith("\t"):
            recipe.append(line)
        elif match := _RULE.match(line):
            recipe = []
            rules.append((match[1].split(), recipe))
    return rules
