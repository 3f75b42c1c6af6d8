"""What a page starts before a script that only speaks to it: the script is no program by itself."""

from __future__ import annotations

from collections.abc import Iterable

from roslab.decide.candidate import LAUNCHERS, Candidate, program_of
from roslab.evidence.facts import Evidence
from roslab.values.dataclass import replace


def without_speaking(candidates: list[Candidate], found: Iterable[Candidate], evidence: Evidence) -> list[Candidate]:
    """Return the commands without such scripts where the same page starts something before, which they speak to.

    That may be of a package that the tree's own ask for: then it is one of the commands, too, if none else is left that
    pages run.
    """
    speaking = {(m.file, m.value) for m in evidence.mentions if m.topic == "speaks"}
    scripts = [c for c in candidates if c.strong and (c.file, program_of(c.argv)[-1]) in speaking]
    if not scripts:
        return candidates
    started = [c for c in found if c.strong and c.argv[0] in LAUNCHERS and not c.cut]
    answers = {c.file: c for c in reversed(started) if any(s.file == c.file and c.line < s.line for s in scripts)}
    left = [c for c in candidates if c not in scripts or c.file not in answers]
    if any(c.strong for c in left):
        return left
    asked = {d.name for manifest in evidence.manifests for d in manifest.dependencies}
    needed = (c for c in answers.values() if program_of(c.argv)[-2] in asked)
    return [*(replace(c, why=f"{c.why}, before what speaks to it") for c in needed), *left]
