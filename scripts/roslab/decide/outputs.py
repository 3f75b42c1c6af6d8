"""What a program of a page writes, and where."""

from __future__ import annotations

import re

from roslab.values.pattern import pattern

_OUTPUT = pattern(
    r"-{0,2}(?:[\w.]*[._-])?(?:log|out|output|save|saving|result|record|run)s?(?:[._-]?(?:root|base))?"
    r"(?:[._-]?(?:dir|directory|path|folder|root))?",
    re.IGNORECASE,
)
"""The name of an option for it: ``--logdir``, ``--save_path``."""
_NAMES = pattern(
    r"--?(?:name|tag|(?:exp|expt|experiment)(?:[._-]?(?:name|tag))?|"
    r"(?:run|job|session|log|save|output|out|wandb)[._-]?(?:name|tag))",
    re.IGNORECASE,
)
"""An option that names what the program writes: ``--exp_name``."""
_LEFT = pattern(r"[A-Z]{2,}[0-9]?(?:_[A-Z0-9]+){0,4}")
_THERE = frozenset(
    {
        "CHECKPOINT",
        "CKPT",
        "CONFIG",
        "DATA",
        "DATASET",
        "DIR",
        "DIRECTORY",
        "ENV",
        "FILE",
        "FOLDER",
        "ID",
        "MAP",
        "MODEL",
    }
    | {"PATH", "POLICY", "ROBOT", "SCENE", "SEQUENCE", "TASK", "URL", "USER"}
)
"""Words of a name for what must be there."""
_BELOW_HOME = pattern(r"~/(?=[\w.])")


def writes(option: str) -> bool:
    """Tell whether an option is named like one for what the program writes."""
    return bool(_OUTPUT.fullmatch(option))


def names_output(option: str, word: str) -> bool:
    """Tell whether a placeholder in capitals can stay as it is: it names what the program writes, not what it reads.

    ``option`` is the word before it, ``""`` where it is given with an equals sign: ``--exp_name=EXP_NAME``.
    """
    name, _, value = word.partition("=") if word.startswith("-") else (option, "", word)
    return bool(_NAMES.fullmatch(name) and _LEFT.fullmatch(value)) and _THERE.isdisjoint(value.split("_"))


def written_below(option: str, word: str) -> str:
    """Return an output folder in the reader's home, which the program makes, as one where the program is started.

    ``option`` is the word before it; other words stay as they are.
    """
    name, equals, value = word.rpartition("=")
    named = name if equals else option if option.startswith("-") else ""
    home = _BELOW_HOME.match(value)
    return f"{name}{equals}{value[home.end() :]}" if home and _OUTPUT.fullmatch(named) else word
