"""Commands that a sentence of a page names: ``run `demo` ``, ``go into `lib/arm` ``, ``clone https://…``."""

from __future__ import annotations

import re
from collections.abc import Iterator

from roslab.evidence.prose.telling import Signs
from roslab.values.pattern import pattern

_NAMED = pattern(r"\b(?:run|start|launch|execute)\b(?:\s+the)?(?:\s+\w+)?\s+`([A-Za-z][\w+-]*)`", re.IGNORECASE)
"""A sentence that runs a program by its name."""
_GO_INTO = pattern(
    r"\b(?:go|change|move|navigate|enter|cd)\b(?:\s+(?:in|to|into|inside|the|folder|directory)){0,4}\s+"
    r"`([\w.-]+/[\w./-]*)`",
    re.IGNORECASE,
)
"""A sentence that goes into a folder of the tree before a block of commands."""
_CLONED = pattern(
    r"\bclone\b(?:\s+(?:the|from|repo|repository|package|library|official)){0,4}[\s:]+(?:\[[^\]\n]{1,80}\]\()?<?"
    r"(https://(?:github|gitlab)\.com/[\w-]+/[\w.-]*\w)(?=[\s)>.,;]|$)(?![^`]*`)",
    re.IGNORECASE,
)
"""A sentence that has the reader clone a repository by its address."""
_NAMED_PYTHON = pattern(
    r"(?<!\bnot )(?<!n't )(?<!\bnever )\b(?:run|runn?ing|start|launch|execute|use)\b"
    r"(?:\s+(?:the|a|script|file|program|our)){0,3}\s+"
    r"`{1,3}([\w./-]+\.py(?: [^`\n]{0,200})?)`{1,3}(?!`|\s+as\b)",
    re.IGNORECASE,
)
"""A sentence that runs a file of Python; what is used *as* something is read by another program."""
_NAMED_SHELL = pattern(
    r"\b(?:run|runn?ing|start|launch|execute)\b(?:\s+(?:the|a|script|file|program|our)){0,3}\s+"
    r"`(?:(?:\./)?~/[\w.-]+/|\./)((?:[\w.-]+/)+[\w.-]+\.sh(?: [^`<\n]{0,200})?)`",
    re.IGNORECASE,
)
"""A sentence that runs a script below a folder of the tree, which may lie in the reader's home."""
IN_SENTENCES: Signs = (("`", _NAMED), (".py", _NAMED_PYTHON), (".sh", _NAMED_SHELL), ("`", _GO_INTO), ("://", _CLONED))
"""What a sentence tells to do, each after a part of it."""
_SAID_LAUNCH = pattern(
    r"(?<![`\w/-])(?:roslaunch|ros2 launch) +(?:[a-z]\w+ +[\w./-]+|(?:~/)?[\w.-]+/[\w./-]+)"
    r"(?:\.launch(?:\.(?:py|xml|ya?ml))?|_launch\.py)"
    r"(?: +\w+:=[^\s\"'\u201d`,;)]+)*(?![\w`])"
)
"""A launch in a sentence, by a package or a path: ``Run "roslaunch demo map.launch" to start``."""


def in_sentence(line: str, *, title: bool = False) -> Iterator[str]:
    """Yield what a line of prose tells to do, as the shell's commands.

    ``title``: it is that of a block of commands below, which say how its program is started.
    """
    yield from (said[0] for said in (_SAID_LAUNCH.finditer(line) if "launch " in line else ()))
    yield from (f"git clone {named[1]}" for named in (_CLONED.finditer(line) if "://" in line else ()))
    quoted = "`" in line
    yield from (f"cd {named[1]}" for named in (_GO_INTO.finditer(line) if quoted else ()))
    yield from (f"./{named[1]}" for named in (_NAMED.finditer(line) if quoted and not title else ()))
    yield from (f"python {named[1]}" for named in _NAMED_PYTHON.finditer(line))
    yield from (f"./{named[1]}" for named in (_NAMED_SHELL.finditer(line) if ".sh" in line else ()))
