"""Whether a Dockerfile may install more than its own lines and the files that it gives to pip say."""

from __future__ import annotations

from collections.abc import Iterable

from roslab.evidence.lex.dockerfile import Instruction
from roslab.values.pattern import pattern

_HIDDEN = pattern(
    r"[\w}]\.(?:sh|bash)\b|\b(?:conda|mamba|micromamba)[ \t]+env\b|\buv[ \t]+(?:sync|run)\b"
    r"|\b(?:poetry|pdm|pipenv|pixi|hatch|rye|just|make|tox|nox|invoke)[ \t]+[\w-]"
    r"|\bpython[\d.]*[ \t]+(?!setup\.py)[\w./-]+\.py\b|\bpip[\d.]*[ \t]+install\b[^&|;\n]*[$`<]"
)
"""A script, a manager with a file of its own, or a value that is not known."""
_SETTINGS = pattern(r"\S*/(?:setup|local_setup|activate|conda|profile)\.(?:ba|z)?sh\b")
"""What is only read into the shell."""


def hides(written: Iterable[Instruction]) -> bool:
    """Tell whether one of its steps may."""
    return any(bool(_HIDDEN.search(_SETTINGS.sub(" ", each.text))) for each in written if each.name == "RUN")
