"""Folders that are other repositories, as GitHub packs them: ``driver-main``, ``driver-v1.2.0`` beside packages.

It names what it packs by the repository and the branch or tag:
https://docs.github.com/en/repositories/working-with-files/using-files/downloading-source-code-archives, 2026-11-27.
"""

from __future__ import annotations

import posixpath

from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

_PACKED = pattern(r"([\w.-]*\w)-(?:main|master|v?\d+(?:\.\d+)+|[0-9a-f]{40})")
_DEEPEST = 2
"""Most folders in the path of one: ``src/driver-main``."""
FEWEST = 2
"""Fewest packages of a repository without a licence."""


def packed(repository: Repository) -> tuple[str, ...]:
    """Return these folders, with a page, and a licence or several packages, beside a package of the tree's own."""
    return repository.once(_packed)


def _packed(repository: Repository) -> tuple[str, ...]:
    packages = [file.folder for file in repository.named("package.xml")]
    if not packages:
        return ()
    own = repository.name.lower()
    licensed, paged = set[str](), set[str]()
    for file in repository.files:
        match = _PACKED.fullmatch(posixpath.basename(file.folder))
        if match and match[1].lower() != own and file.folder.count("/") < _DEEPEST:
            stem = file.name.lower().partition(".")[0]
            licensed |= {file.folder} if stem in {"license", "licence", "copying"} else set()
            paged |= {file.folder} if stem == "readme" else set()
    found = sorted(
        folder for folder in paged if folder in licensed or sum(_below(each, folder) for each in packages) >= FEWEST
    )
    beside = [each for each in packages if not any(_below(each, folder) for folder in found)]
    return tuple(folder for folder in found if any(_below(each, posixpath.dirname(folder)) for each in beside))


def _below(folder: str, other: str) -> bool:
    return not other or folder == other or folder.startswith(f"{other}/")
