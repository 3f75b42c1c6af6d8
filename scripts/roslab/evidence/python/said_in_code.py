"""What the code of Python itself says for decisions, in mentions: each reader looks at every module alone."""

from __future__ import annotations

from roslab.evidence.facts import Mention
from roslab.evidence.python import (
    binaries,
    caught,
    companions,
    conflicts,
    environments,
    index_links,
    own_history,
    print_statement,
    told_ways,
    version_file,
)
from roslab.repository.checkout import Repository

_READERS = (
    print_statement.read,
    conflicts.read,
    environments.read,
    companions.read,
    own_history.read,
    version_file.read,
    binaries.read,
    index_links.read,
    told_ways.read,
    caught.read,
)


def read(repository: Repository) -> tuple[Mention, ...]:
    """Return what each of the readers found."""
    return tuple(mention for reader in _READERS for mention in reader(repository))
