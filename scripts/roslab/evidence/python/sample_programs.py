"""Programs that a tool wrote into a new project, and that nobody made one of the project's."""

from __future__ import annotations

from roslab.knowledge.sample_programs import sample_call
from roslab.values.pattern import pattern

MAX_SIZE = 2_000
"""Most characters that such a program has, with its comments."""
_OF_SAMPLES = pattern(r"#|def \w+\(|if __name__\b|main\(|print\(|\"\"\"|'''|$")
"""How its lines begin: it says one thing by a function, and does nothing else."""


def is_sample(text: str) -> bool:
    """Tell whether a program is still as the tool wrote it."""
    found = sample_call().search(text) if len(text) <= MAX_SIZE else None
    if not found:
        return False
    lines = (line.strip() for line in text.replace(found[0], "main()").splitlines())
    return all(map(_OF_SAMPLES.match, lines)) and text.count("print(") <= 1
