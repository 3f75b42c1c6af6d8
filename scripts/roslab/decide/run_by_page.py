"""Why a command of a page is one of the repository's."""

from __future__ import annotations

from roslab.config.model import Kind
from roslab.decide.reasons import page_of
from roslab.evidence.facts import Mention

_SHELLS = ("bash", "sh")


def why_run(argv: tuple[str, ...], mention: Mention, kind: Kind) -> str:
    """Return the reason, with what the command says otherwise: a program of almost its name, or another ending."""
    program = next((word for word in argv if word not in _SHELLS), "").rpartition("/")[2]
    page = page_of(mention.file)
    if kind == "cpp" and program not in mention.value:
        return f"{page} runs one of almost this name, which nothing compiles"
    said = mention.text.split()
    other = next((file for file in mention.files if file in argv and _other_ending(file) in said), "")
    return f"{page} runs it with {_other_ending(other)}, which the tree lacks" if other else f"{page} runs it"


def _other_ending(file: str) -> str:
    """Return a file's path with the other ending of YAML, ``""`` for one that is none."""
    stem, _, ending = file.rpartition(".")
    return f"{stem}.{'yml' if ending == 'yaml' else 'yaml'}" if ending in {"yml", "yaml"} else ""
