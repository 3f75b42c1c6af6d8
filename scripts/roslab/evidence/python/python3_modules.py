"""Code of ROS that imports what Python's own library has since a release of Python 3, and that names no Python 3."""

from __future__ import annotations

import sys
from collections.abc import Iterator

from roslab.evidence import places
from roslab.evidence.facts import Mention
from roslab.evidence.python.modules import modules
from roslab.evidence.python.of_python3 import asks_python3
from roslab.knowledge.backports import backports
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern


def read(repository: Repository) -> Iterator[Mention]:
    """Yield the first such import that nothing catches; a first line that asks for Python 3 tells enough by itself."""
    own = (name for name, since in backports().items() if since.major > 2)
    names = [name for name in own if name in sys.stdlib_module_names]  # functools32 is only the package for Python 2
    imported = pattern(rf"(?m)^(?:from|import)[ \t]+({'|'.join(sorted(names))})\b[^\n]*")
    for module in modules(repository):
        if not module.names_ros or asks_python3(module) or places.aside(module.file.path):
            continue
        if match := imported.search(module.text):
            line = module.text.count("\n", 0, match.start()) + 1
            said, file = match[0].strip()[:60], module.file.path
            yield Mention(topic="python3_module", value=match[1], source="code", file=file, line=line, text=said)
            return
