"""Whether a program draws an environment of gym in a window: by ``render()`` without a mode, or by the mode of it."""

from __future__ import annotations

import re

from roslab.evidence.lex.lines import matching_lines
from roslab.evidence.python.modules import Module
from roslab.values.pattern import pattern

_DRAWN = ".render("
_WORDS = frozenset({"render", "render_mode"})
_CALL = pattern(
    r"^(?P<indent>[ \t]*)(?:self\.)?(?:\w*_)?envs?(?:\.unwrapped)?"
    r"\.render\(\s*(?:(?:mode\s*=\s*)?[\"']human[\"']\s*)?\)",
    re.MULTILINE,
)
_MADE = pattern(r"make\((?<=\bmake\()[^()\n]*\brender_mode\s*=\s*[\"']human[\"']")
"""Since gym 0.26 it is the environment that is told: https://gymnasium.farama.org/api/env/#gymnasium.Env.render."""
_TOLD = pattern(r"\brender_mode\b|^[ \t]*(?:import|from)[ \t]+gymnasium\b", re.MULTILINE)
_BRANCH = pattern(r"(?:if|elif|else|except|match|case)\b(?!\s+__name__)")
_OWN = pattern(r"(?:async\s+)?(?:def\s+\w*render\w*\b|class\b.*(?:Wrapper|Env\w*)\b)")
"""An environment that hands the call on to the one inside it."""


def rendered(module: Module) -> int | None:
    """Return the place of the first call by which a module opens the window of an environment, whatever it is given.

    gym before 0.26 does so by default (https://github.com/openai/gym/blob/0.21.0/gym/core.py, ``Env.render``, read
    2026-11-26); a call below a condition may wait for an option.
    """
    if _WORDS.isdisjoint(module.words):
        return None
    text = module.text
    if made := _MADE.search(text) if "render_mode" in module.words else None:
        return made.start()
    if _DRAWN not in text or (any(word in text for word in ("render_mode", "gymnasium")) and _TOLD.search(text)):
        return None
    calls = (match for match in matching_lines(_CALL, text, _DRAWN))
    return next((match.start() for match in calls if _always(text, match)), None)


def _always(text: str, call: re.Match[str]) -> bool:
    """Tell whether no block around a call is a branch, or an environment's own."""
    depth = len(call["indent"].expandtabs())
    for line in reversed(text[: call.start()].splitlines()):
        start = line.lstrip()
        indent = len(line.expandtabs()) - len(start.expandtabs())
        if not start or start.startswith("#") or indent >= depth:
            continue
        if _BRANCH.match(start) or _OWN.match(start):
            return False
        depth = indent
        if not depth:
            break
    return True
