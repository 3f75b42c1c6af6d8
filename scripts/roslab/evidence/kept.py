"""Evidence that is kept: where nothing of a tree has changed since it was read, it is not read again.

Changed is what git would take for changed, by each file's dates, size and number, or where git itself tells another
thing of the commit, the branches or the remote. A file that was written within the last two seconds is not trusted: the
same moment may have seen another write to it. https://git-scm.com/docs/racy-git

It is right because all that a reader knows of a tree it has from ``Repository``, and the rest from the program.
"""

from __future__ import annotations

import marshal
import os
import sys
from contextlib import suppress
from importlib import import_module
from typing import TYPE_CHECKING, Any

from roslab.knowledge.table import used
from roslab.values.kept_file import DAMAGED, Stamp, stamp
from roslab.values.kept_modules import unchanged
from roslab.values.kept_trees import KeptTree

if TYPE_CHECKING:
    from roslab.evidence.facts import Evidence
    from roslab.repository.checkout import Repository

MOST_FILES = 150_000
"""Of a larger tree nothing is kept."""
RACY = 2_000_000_000
"""Nanoseconds: some file systems know no shorter time."""
_FROM = frozenset({"roslab", "packaging", "datetime"})
"""The packages of which a kept value may be: those of evidence, of its requirements and of a commit's time."""
_PROTOCOL = 5
"""Of the form in which values are kept, which Python has had since 3.8. https://peps.python.org/pep-0574/"""
_OWN = f"{__name__.partition('.')[0]}."
_LENGTH = 8
"""Bytes at the beginning, which tell the length of the state after them; then comes what git told, and the evidence."""


def evidence_of(repository: Repository) -> Evidence:
    """Return everything that a repository says about itself, as ``gather`` does, or as it was kept."""
    if len(repository.files) > MOST_FILES:
        return _gather(repository)
    tree, state = KeptTree(__spec__, repository.path), _state(repository)
    kept = _kept(tree, state, repository)
    if kept is None:
        kept = _gather(repository)
        _keep(tree, state, repository, kept)
    return kept


def _gather(repository: Repository) -> Evidence:
    from roslab.evidence.gather import gather  # noqa: PLC0415 - it imports every reader

    return gather(repository)


def _state(repository: Repository) -> tuple[Any, ...]:
    """Return what the evidence of a tree depends on, but for the program and what git tells."""
    listing = repository.listing
    paths = [file.path for file in listing.files]
    listed = (sorted(listing.links), sorted(listing.folder_links), listing.outside, listing.empty, listing.unreadable)
    asked = (repository.path, repository.branch_hint, os.fspath(repository.top or ""), listing.truncated)
    return asked, paths, [listing.stamps[path] for path in paths], listed


def _kept(tree: KeptTree, state: tuple[Any, ...], repository: Repository) -> Evidence | None:
    content = tree.read()
    if content is None:
        return None
    end = _LENGTH + int.from_bytes(content[:_LENGTH], "little")
    if not _holds(content[_LENGTH:end], state):
        return None
    import io  # noqa: PLC0415 - of most trees nothing is kept

    pickle = _pickle()
    base: Any = pickle.Unpickler

    class Unpickler(base):  # type: ignore[misc]
        """Makes values of these classes alone, not of those that their modules import."""

        def find_class(self, module: str, name: str) -> Any:
            found = super().find_class(module, name) if module.partition(".")[0] in _FROM else None
            if not isinstance(found, type) or found.__module__.partition(".")[0] not in _FROM:
                raise pickle.UnpicklingError(f"{module}.{name}")
            return found

    # What pickle may raise for what is no longer there: https://docs.python.org/3/library/pickle.html#pickle.PickleError
    with suppress(pickle.UnpicklingError, AttributeError, ImportError, LookupError, *DAMAGED):
        told, evidence = Unpickler(io.BytesIO(content[end:])).load()
        return evidence if repository.tells(told) else None
    return None


def _holds(head: memoryview, state: tuple[Any, ...]) -> bool:
    """Tell whether what was kept is of such a tree, and of this program."""
    with suppress(*DAMAGED):  # written by another version
        before, libraries, program = marshal.loads(head)  # noqa: S302 - written by this user
        return bool(before == state and libraries == _libraries()) and all(
            unchanged.get(file) == stamped or stamp(file) == stamped for file, stamped in program
        )
    return False


def _keep(tree: KeptTree, state: tuple[Any, ...], repository: Repository, evidence: Evidence) -> None:
    """Keep evidence, if git answered and nothing that it comes from was changed so lately that it may change unseen."""
    if not repository.answered:
        return
    listing = repository.listing
    program = _program()
    newest = max((date for file in listing.files for date in listing.stamps[file.path][:2]), default=0)
    if max(newest, *(stamped[0] for _, stamped in program)) >= listing.begun - RACY:
        return
    pickle = _pickle()
    told = {("checkout",): repository.checkout, **repository.told}
    made = pickle.dumps((told, evidence), protocol=_PROTOCOL)
    head = marshal.dumps((state, _libraries(), program))
    tree.write(b"".join((len(head).to_bytes(_LENGTH, "little"), head, made)))


def _pickle() -> Any:
    """Return what ``pickle`` itself uses where it can: to import that alone takes half as long."""
    try:
        return import_module("_pickle")
    except ImportError:  # not of this Python
        return import_module("pickle")


def _program() -> list[tuple[str, Stamp]]:
    """Return the files of the program that were imported or read so far, each with its date and its size."""
    modules = {module.__file__ for name, module in sys.modules.items() if name.startswith(_OWN)}
    stamped = ((file, unchanged.get(file) or stamp(file)) for file in used.union(filter(None, modules)))
    return [(file, found) for file, found in stamped if found]


def _libraries() -> list[tuple[str, Stamp | None]]:
    """Return Python and the folders of its libraries: each has another date once something is installed in it."""
    return [(sys.version, None), *((folder, stamp(folder)) for folder in sys.path)]
