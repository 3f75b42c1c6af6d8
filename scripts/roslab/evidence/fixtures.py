"""Files that the tests of a package read: copies of scripts and lists that say nothing about the repository."""

from __future__ import annotations

from roslab.repository.checkout import Repository

_TESTS = frozenset({"test", "tests", "testing"})
_PACKAGE = ("package.xml", "manifest.xml", "stack.xml", "setup.py", "pyproject.toml")


def of_tests(repository: Repository, path: str) -> bool:
    """Tell whether a path lies in the test folder of a package below the root.

    The root's own is no such folder: there lies also what continuous integration runs.
    """
    parts = path.split("/")[:-1]
    places = (number for number, part in enumerate(parts) if number and part.lower() in _TESTS)
    return any("/".join(parts[:number]) in repository.once(_packages) for number in places)


def _packages(repository: Repository) -> frozenset[str]:
    return frozenset(file.folder for file in repository.named(*_PACKAGE))
