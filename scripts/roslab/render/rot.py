"""What the watch found: as the job's summary, as an issue, and as a badge."""

from __future__ import annotations

import json
import shlex
from collections.abc import Sequence

from roslab.lock.rot import MEANINGS, Finding, Side, State, counted
from roslab.render.markdown import block, code, folded, prose, table
from roslab.render.moved import line
from roslab.render.outcome import Repair
from roslab.render.summary import pasted

MOST = 200
"""Most packages that are listed."""
TAIL = 40
"""Lines of a failed output that are shown."""
COLOURS: dict[State, str] = {
    "built": "green",
    "proved": "brightgreen",
    "drifted": "yellow",
    "archived only": "orange",
    "broken": "red",
    "unknown": "lightgrey",
}


def badge(state: State) -> str:
    """Return the badge as shields.io reads it: https://shields.io/badges/endpoint-badge."""
    data = {"schemaVersion": 1, "label": "image", "message": state, "color": COLOURS[state]}
    return json.dumps(data, indent=2) + "\n"


def summary(finding: Finding, *, archived: str) -> str:
    """Return the summary; ``archived`` is the archived image's reference."""
    mark = {"archived only": "⚠️", "broken": "❌", "unknown": "❔"}.get(finding.state, "✅")
    parts = [f"### {mark} {finding.state.capitalize()}\n", f"{MEANINGS[finding.state]}\n", _body(finding, archived)]
    return "\n".join(parts)


def title(name: str) -> str:
    """Return the issue's title."""
    return f"The image of {name} can no longer be made from its source"


def issue(
    finding: Finding, *, archived: str, problems: Sequence[str], repairs: Sequence[Repair], page: str, commit: str
) -> str:
    """Return the issue's text: what happened, why, the lines to paste, what moved, and how the archive is run.

    ``problems`` explain the failure; ``page`` is the run's.
    """
    reasons = "".join(f"- {prose(problem)}\n" for problem in problems)
    run = shlex.join(["docker", "run", "--rm", "-it", archived])
    begin = f"Commit {code(commit[:12])} was made anew from nothing, without a lock and a cache, and that failed."
    end = "The next run writes this text anew, and closes the issue once the image is built and proved again."
    parts = [
        f"{begin} {MEANINGS[finding.state]}\n",
        reasons,
        *(pasted(repair) for repair in repairs),
        _body(finding, archived),
        f"Until then the archived image is what runs:\n\n{block(run, 'bash')}",
        f"[The run]({page}) has the whole log. {end}\n",
    ]
    return "\n".join(part for part in parts if part)


def repaired(commit: str, page: str) -> str:
    """Return the comment that closes the issue."""
    return f"Built from nothing and proved again at commit {code(commit[:12])}: [the run]({page}).\n"


def _body(finding: Finding, archived: str) -> str:
    rows = [("from the source, today", _side(finding.today))]
    name = f"archived, {code(archived)}" if archived else "archived"
    rows.append((name, _side(finding.archived) if finding.archived else "nothing was published yet"))
    parts = [table(("image", "outcome"), rows), f"{prose(counted(finding))}\n" if finding.archived else ""]
    if finding.moved and finding.moved.moved:
        lines = [f"{change.kind}: {line(change)}" for change in finding.moved.moved]
        more = [f"and {len(lines) - MOST} more"] if len(lines) > MOST else []
        parts.append(folded("What moved", block("\n".join((*lines[:MOST], *more)))))
    if finding.today.output and not finding.today.proved:
        tail = "\n".join(finding.today.output.splitlines()[-TAIL:])
        parts.append(folded("What it printed", block(tail)))
    return "\n".join(part for part in parts if part)


def _side(side: Side) -> str:
    return "proved" if side.proved else prose(side.failure or "failed")
