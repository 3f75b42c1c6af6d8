"""When the repository was last worked on: the date of its commit.

The dates in a changelog tell less: most repositories go on for years after its last entry.
"""

from __future__ import annotations

from roslab.evidence.facts import Mention
from roslab.repository.checkout import Repository


def read(repository: Repository) -> tuple[Mention, ...]:
    """Return the date of the checkout's commit in UTC, nothing if there is no git."""
    if repository.committed is None:
        return ()
    date = repository.committed.date().isoformat()
    return (Mention(topic="date", value=date, source="commit", file=".git/HEAD", line=1, text=f"commit of {date}"),)
