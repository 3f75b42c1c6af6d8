"""Lines of requirement files that pip refuses: it reads none of the others then."""

from __future__ import annotations

from roslab.decide.decision import Warning_
from roslab.decide.python.manifests import with_includes
from roslab.decide.reasons import warn
from roslab.evidence.facts import Evidence, RequirementFile
from roslab.values.dataclass import replace


def unread_lines(evidence: Evidence, file: RequirementFile) -> list[Warning_]:
    """Return a warning for the first line of a file, or of each that it includes, that nobody can read."""
    return [
        warn(
            "pip would refuse this line, and nothing tells what it asks for: it is left out, and the packages of "
            f"{each.file} are installed one by one",
            replace(each, line=each.unread[0]),
        )
        for each in with_includes(evidence, [file])
        if each.unread
    ]
