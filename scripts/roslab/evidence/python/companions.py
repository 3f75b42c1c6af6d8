"""Uses of functions that need a further package, which pip does not install with theirs."""

from __future__ import annotations

from roslab.evidence import places
from roslab.evidence.facts import Mention
from roslab.evidence.python.in_comment import in_comment
from roslab.evidence.python.modules import modules
from roslab.knowledge.companions import companions
from roslab.repository.checkout import Repository


def read(repository: Repository) -> tuple[Mention, ...]:
    """Return for each package what it needs beside it (``text``), with the first place that needs it; no test's."""
    found: dict[tuple[str, str], Mention] = {}
    for module in modules(repository):
        possible = companions().possible(module.text, module.words)
        for row in possible if not places.test(module.file.path) else ():
            if (row.package, row.needs) in found:
                continue
            used = (m for m in row.pattern.finditer(module.text) if not in_comment(module.text, m.start()))
            if not (match := next(used, None)):
                continue
            line = module.text.count("\n", 0, match.start()) + 1
            found[row.package, row.needs] = Mention(
                topic="companion", value=row.package, source="code", file=module.file.path, line=line, text=row.needs
            )
    return tuple(found.values())
