"""How far an image got, in the job's summary."""

from __future__ import annotations

from collections.abc import Sequence

from roslab.plan.ladder import Ladder, Rung, State, title
from roslab.render.markdown import folded, prose, text
from roslab.render.outcome import PlatformReport

MARKS: dict[State, str] = {"held": "✅", "missed": "❌", "unseen": "❔"}


def cell(ladder: Ladder) -> str:
    """Return how far it got as the cell of a table, ``""`` for a report without a ladder."""
    return text(title(ladder.reached)) if ladder.rungs else ""


def sections(platforms: Sequence[PlatformReport]) -> str:
    """Return each platform's ladder, folded: what was seen of each rung, and what the next would have needed."""
    parts = []
    for entry in platforms:
        if entry.ladder.rungs:
            body = "".join(_rung(rung) for rung in entry.ladder.rungs)
            if beyond := entry.ladder.beyond:
                body += f"\nThe next: {prose(beyond)}.\n"
            parts.append(
                folded(f"How far it got on {_html(entry.platform)}: {_html(title(entry.ladder.reached))}", body)
            )
    return "\n".join(parts)


def badge(platforms: Sequence[PlatformReport], revision: str) -> str:
    """Return a badge in Markdown: how far a commit's image got on every platform; ``""`` if that is not known."""
    reached = [entry.ladder.reached for entry in platforms if entry.ladder.rungs]
    lowest = [rung for rung in reached if rung is not None]
    if not reached or len(lowest) < len(reached):
        return ""
    told = f"{title(min(lowest))} ({revision[:7]})" if revision else title(min(lowest))
    words = told.replace("-", "--").replace("_", "__").replace(" ", "_").replace(",", "%2C")
    return f"![proof: {told}](https://img.shields.io/badge/proof-{words}-blue)"


def _rung(rung: Rung) -> str:
    return f"- {MARKS[rung.state]} **{rung.number} {text(rung.name)}**: {prose(rung.said)}\n"


def _html(value: str) -> str:
    """Escape only HTML, because Markdown is not interpreted inside a summary element."""
    return text(value).replace("\\", "")
