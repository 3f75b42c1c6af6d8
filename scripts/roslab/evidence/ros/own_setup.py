"""Scripts of the tree that take the repository's folder for the workspace: ``source "$here/install/setup.bash"``."""

from __future__ import annotations

import re
from collections.abc import Iterator

from roslab.evidence import places
from roslab.evidence.facts import Mention
from roslab.repository.checkout import Repository, nearest
from roslab.values.pattern import pattern

MAX_SIZE = 64 * 1024
MOST = 40
"""Scripts that are read."""
_SOURCED = pattern(
    r"^[ \t]*(?:source|\.)[ \t]+[\"']?\$\{?(\w+)\}?[\"']?/(install|devel)/(?:local_)?setup\.(?:ba|z)?sh\b", re.MULTILINE
)
_ITSELF = r"^[ \t]*(?:readonly[ \t]+|export[ \t]+)?{}=[^\n]*(?:BASH_SOURCE|\$\{{?0\b)[^\n]*$"
"""A variable that is set to the folder of the script, or one above it."""
_ABOVE = pattern(r"/\.\.(?![\w.])")


def read(repository: Repository) -> Iterator[Mention]:
    """Yield the first such script for each of the folders that a build tool writes, if the repository has none."""
    told = {name for name in ("install", "devel") if any(f.path.startswith(f"{name}/") for f in repository.files)}
    scripts = (file for file in repository.suffixed(".sh", ".bash") if not places.vendored(file.path))
    for file in nearest(scripts)[:MOST]:
        text = repository.read(file, limit=MAX_SIZE)
        for match in _SOURCED.finditer(text) if "/setup." in text else ():
            if match[2] not in told and _of_root(text, match[1], file.path.count("/")):
                told.add(match[2])
                line = text.count("\n", 0, match.start(1)) + 1
                said = match[0].strip()
                yield Mention(topic="own_setup", value=match[2], source="script", file=file.path, line=line, text=said)


def _of_root(text: str, name: str, depth: int) -> bool:
    """Tell whether a variable names the repository's folder, in a script that lies so many folders below it."""
    found = re.search(_ITSELF.format(re.escape(name)), text, re.MULTILINE)
    return found is not None and len(_ABOVE.findall(found[0])) == depth
