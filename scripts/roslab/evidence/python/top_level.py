"""Files of Python that do something when they are started, without a ``__main__`` guard."""

from __future__ import annotations

import re

from roslab.values.pattern import pattern

_STATEMENT = pattern(
    r"^(?:(?:for|while|with)\b.*:|print[ \t]+[\"'\w]|(?P<call>[A-Za-z_](?:\w*\.)*\w*)\()", re.MULTILINE
)
_SETS = pattern(
    r"(?:.*\.)?(?:append|insert|extend|update|use|set\w*|seed|manual_seed|basicConfig|filterwarnings|simplefilter|"
    r"register\w*|rc|enable\w*|disable\w*|init|reload|setup|exec|__import__)"
)
"""A call that only sets something for what comes after it: ``sys.path.append``, ``matplotlib.use``."""
_STRING = pattern(r"\"\"\"(?:[^\\]|\\.)*?\"\"\"|'''(?:[^\\]|\\.)*?'''", re.DOTALL)
_PROGRAM = pattern(r"(?:main|run|demo)(?![a-z])\w*\.py", re.IGNORECASE)
"""The name of a file that is meant to be started: ``main_plan.py``; no ``runtime.py``."""


def called_like_one(name: str) -> bool:
    """Tell whether a file at the root is called like what is meant to be started."""
    return bool(_PROGRAM.fullmatch(name))


def first_statement(text: str) -> int | None:
    """Return the line of the first statement that is more than an import, a definition, or a setting."""
    code = _STRING.sub(lambda found: "\n" * found[0].count("\n"), text)
    for match in _STATEMENT.finditer(code):
        if not (match["call"] and _SETS.fullmatch(match["call"])):
            return code.count("\n", 0, match.start()) + 1
    return None
