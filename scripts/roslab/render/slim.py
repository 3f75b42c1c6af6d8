"""The slim image in the job's summary."""

from __future__ import annotations

from roslab.plan.ladder import title
from roslab.render.markdown import code, prose, text
from roslab.render.outcome import Report
from roslab.render.sizes import human


def section(report: Report) -> str:
    """Return what became of the slim image, with its size beside the whole one's; a failed one got no tag."""
    entries = [(entry, entry.slim) for entry in report.platforms if entry.slim]
    if not entries:
        return ""
    lines = []
    for entry, slim in entries:
        told = f"❌ {prose(slim.failure)}" if slim.failure else f"✅ {text(title(slim.ladder.reached))}"
        size = f"; {human(slim.size)} in the place of {human(entry.size)}" if slim.size and entry.size else ""
        lines.append(f"- {code(entry.platform)}: {told}{size}\n")
    whole = "the whole image is published without it" if report.published else "the whole image passed without it"
    if report.slim:
        tags = ", ".join(code(tag.rpartition(":")[2]) for tag in report.slim)
        said = f"Published too: {tags}."
    elif any(slim.failure for _, slim in entries):
        said = f"It got no tag: {whole}."
    else:
        said = "Built and proved, not published."
    return f"#### The slim image\n\n{said}\n\n{''.join(lines)}"
