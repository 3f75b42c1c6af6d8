"""What an entry script that starts what it is given does when it is given nothing: some start a program then."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import islice

from roslab.values.pattern import pattern

MOST = 8
"""Most tests of a script that are looked at."""
PROGRAM = pattern(
    r"(?:^|[;&|(\s'\"])"
    r"(?:python[\d.]*[ \t]+(?!\S*setup\.py|-m[ \t]+(?:pip|venv)\b|-(?:V|-version)\b)(?:-\S+[ \t]+)*\S+|"
    r"roslaunch|rosrun|ros2[ \t]+(?:launch|run))\b"
)
_SAID = pattern(r"\b(?:echo|printf)\b(?:\"[^\"\n]*\"|'[^'\n]*'|[^;&|\"'\n])*")
"""What a script only prints: ``echo "Usage: python main.py"``."""
_COUNT = r"(?:\$#|\$\{#\}|\$\{#@\})"
_WORDS = r"(?:\$[1@*]|\$\{[1@*](?::?-)?\})"
_NONE = pattern(
    rf"\[\[?[ \t]+[\"']?{_COUNT}[\"']?[ \t]+(?:-eq[ \t]+0|-lt[ \t]+1|==?[ \t]+[\"']?0)|"
    rf"\[\[?[ \t]+-z[ \t]+[\"']?{_WORDS}|\(\([ \t]*{_COUNT}[ \t]*(?:==[ \t]*0|<[ \t]*1)\b"
)
"""A test that holds where no word is given."""
_SOME = pattern(
    rf"\[\[?[ \t]+[\"']?{_COUNT}[\"']?[ \t]+(?:-gt[ \t]+0|-ge[ \t]+1|-ne[ \t]+0|!=[ \t]+[\"']?0)|"
    rf"\[\[?[ \t]+(?:-n[ \t]+)?[\"']?{_WORDS}[\"']?[ \t]+\]|\(\([ \t]*{_COUNT}[ \t]*(?:(?:>|!=)[ \t]*0[ \t]*)?\)\)"
)
"""A test that holds where one is."""
_DEFAULT = pattern(r"\$\{[@*1]:?-([^}\n]{1,300})\}")
_IF = pattern(r"\s*(?:if|elif)\b(?![ \t]*!)")
_NEXT = pattern(r";[ \t]*(?=(?:then|else|elif|fi)\b)")
"""Where an ``if`` that is written on one line goes on."""
_OPENS = pattern(r"\s*if\b")
_CLOSES = pattern(r"\s*fi\b")
_OTHERWISE = pattern(r"\s*el(?:se|if)\b")
_AND = pattern(r"\]{1,2}[\"']?[ \t]*&&|\)\)[ \t]*&&")
_LEAVES = pattern(r"\s*(?:then[ \t]+)?(?:exec|exit)\b")


def starts_alone(lines: Sequence[str]) -> bool:
    """Tell whether a script starts a program of Python or ROS where it is given no words."""
    if any(PROGRAM.search(found[1]) for line in lines for found in _DEFAULT.finditer(line)):
        return True
    lines = [part for line in lines for part in _NEXT.split(_SAID.sub("", line))]
    tests = (at for at, line in enumerate(lines) if _NONE.search(line) or _SOME.search(line))
    for at in islice(tests, MOST):
        line, none = lines[at], _NONE.search(lines[at])
        if not _IF.match(line):
            if none and _AND.search(line) and PROGRAM.search(line):
                return True
            continue
        holds, other, rest = _branches(lines[at + 1 :])
        if not none and not other and any(map(_LEAVES.match, holds)):
            other = rest
        if any(map(PROGRAM.search, holds if none else other)):
            return True
    return False


def _branches(lines: Sequence[str]) -> tuple[list[str], list[str], list[str]]:
    """Return the lines where a test holds, those where it does not, and those behind its end."""
    holds: list[str] = []
    other: list[str] = []
    taken, depth = holds, 0
    for at, line in enumerate(lines):
        if _CLOSES.match(line):
            if not depth:
                return holds, other, list(lines[at + 1 :])
            depth -= 1
        elif _OPENS.match(line):
            depth += 1
        elif not depth and _OTHERWISE.match(line):
            taken = other
        taken.append(line)
    return holds, other, []
