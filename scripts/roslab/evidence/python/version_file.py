"""The Python that ``.python-version`` at the root names: uv and pyenv run the project with it.

https://docs.astral.sh/uv/concepts/python-versions/#python-version-files and
https://github.com/pyenv/pyenv/blob/master/README.md#understanding-python-version-selection, read 2026-11-26.
"""

from __future__ import annotations

from roslab.evidence.facts import Mention
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

NAME = ".python-version"
_VERSION = pattern(r"(?:c?python[-@]?)?([23]\.\d{1,2})(?:\.\d{1,2})?(?=[-/+]|$)")


def read(repository: Repository) -> tuple[Mention, ...]:
    """Return the version of its first line; the name of an environment or of another interpreter tells none."""
    lines = repository.read(NAME, limit=1000).splitlines() if repository.has(NAME) else []
    said = enumerate((line.strip() for line in lines), 1)
    number, text = next(((number, line) for number, line in said if line and not line.startswith("#")), (1, ""))
    found = _VERSION.match(text)
    if found is None:
        return ()
    return (Mention(topic="python", value=found[1], source="manifest", file=NAME, line=number, text=text[:80]),)
