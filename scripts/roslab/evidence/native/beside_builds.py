"""Files that are beside a build: those that it does not read, those of another build, and those that it writes."""

from __future__ import annotations

from roslab.evidence.native import made_elsewhere, unread, written_beside
from roslab.evidence.workspace_files import WorkspaceFiles
from roslab.repository.checkout import Repository


def read(repository: Repository) -> WorkspaceFiles:
    """Return what each of these readers finds."""
    return WorkspaceFiles(
        unread=unread.names(repository),
        made_elsewhere=made_elsewhere.names(repository),
        written_beside=written_beside.found(repository),
    )
