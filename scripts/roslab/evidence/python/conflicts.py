"""Python files with the markers of a merge that nobody finished: no Python reads them."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.evidence.facts import Mention
from roslab.evidence.python.modules import modules
from roslab.repository.checkout import Repository


def read(repository: Repository) -> Iterator[Mention]:
    """Yield the first such place of each file."""
    for module in modules(repository):
        text = module.text
        at = text.find("\n<<<<<<< ") + 1 if "\n<<<<<<< " in text else 0
        if text.startswith("<<<<<<< ", at) and _has_rest(text[at:]):
            line = text.count("\n", 0, at) + 1
            said = text[at:].partition("\n")[0]
            yield Mention(
                topic="conflict", value=module.file.path, source="code", file=module.file.path, line=line, text=said
            )


def _has_rest(text: str) -> bool:
    """Tell whether what follows the first marker has the other two, in their order."""
    middle = text.find("\n=======")
    return 0 < middle < text.find("\n>>>>>>> ")
