"""Variables that a workflow, a job or a step of CI sets by ``env`` and a ``run`` uses: ``git checkout ${TAG}``.

https://docs.github.com/en/actions/learn-github-actions/variables, read 2026-11-27
"""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from roslab.values.pattern import pattern

if TYPE_CHECKING:
    from roslab.evidence.lex.yaml import Scalar

_USED = pattern(r"\$(?:\{\{[ ]{0,9}env\.([A-Za-z_]\w*)[ ]{0,9}\}\}|\{([A-Za-z_]\w*)\}|([A-Za-z_]\w*))")
_SET = pattern(r"(?:^|[\s;&])([A-Za-z_]\w*)=")
_PLAIN = pattern(r"[\w./:@+=,~-]+(?: [\w./:@+=,~-]+)*")
"""A value without quotes, and without another variable or expression."""


def filled(value: Scalar) -> str:
    """Return the text of a value with the variables that ``env`` sets around it, where their values are plain.

    Not the distribution's, which its readers know, nor one that the text sets itself.
    """
    text = value.text
    if value.key != "run" or not value.variables or "$" not in text:
        return text

    own = {*_SET.findall(text)}

    def written(match: re.Match[str]) -> str:
        name = match[1] or match[2] or match[3]
        meant = value.variables.get(name, "")
        set_here = match[1] is None and name in own
        return match[0] if set_here or "DISTRO" in name.upper() or not _PLAIN.fullmatch(meant) else meant

    return _USED.sub(written, text)
