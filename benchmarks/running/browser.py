"""The page for a browser: bars per outcome that filter the rows below them; styles and script are in it."""

from __future__ import annotations

import html
from collections import Counter
from collections.abc import Sequence
from pathlib import Path

from benchmarks.running.figures import INTRODUCTION, sums, title, when
from benchmarks.running.rows import OUTCOMES, WHOSE, Outcome, Row

TEMPLATE = Path(__file__).resolve().parent / "page.html"
HEAD = ("repository", "result", "command", "why", "base")
LIGHT = ("stand-in", "needs")
"""Whose failures say nothing of the program; their part of a bar is hatched."""


def page(readings: dict[str, tuple[Row, ...]]) -> str:
    """Return the page; the last reading comes first."""
    parts = [f"<p>{_code(paragraph)}</p>" for paragraph in INTRODUCTION.split("\n\n")]
    parts.append('<p class="legend">Hatched: the stand-in lacks it, or the program was given no device, data or '
                 "arguments. A bar shows its rows alone when it is pressed.</p>")  # fmt: skip
    parts += [_section(name, rows) for name, rows in reversed(readings.items())]
    return TEMPLATE.read_text(encoding="utf-8").replace("<!-- readings -->", "\n".join(parts))


def _section(name: str, rows: Sequence[Row]) -> str:
    kinds = sorted({row.kind for row in rows})
    options = "".join(f"<option>{html.escape(kind)}</option>" for kind in kinds)
    return "\n".join(
        (
            f"<section><h2>{html.escape(title(name))}</h2>",
            f'<p class="when">{html.escape(when(rows))}</p>',
            f'<ul class="sums">{"".join(f"<li>{html.escape(sentence)}</li>" for sentence in sums(rows))}</ul>',
            f'<div class="bars">{"".join(_bar(each, rows) for each in OUTCOMES)}</div>',
            f'<div class="filter"><label>kind <select><option value="">all</option>{options}</select></label>',
            '<label>words <input type="search" size="18"></label><button type="button" class="all">show all</button>',
            '<span class="shown legend" role="status"></span></div>',
            f"<table><thead><tr>{''.join(f'<th>{each}</th>' for each in HEAD)}</tr></thead>",
            f"<tbody>{''.join(_row(row) for row in rows)}</tbody></table></section>",
        )
    )


def _colour(outcome: Outcome) -> str:
    return f"--colour: var(--{outcome.replace(' ', '-')})"


def _bar(outcome: Outcome, rows: Sequence[Row]) -> str:
    found = Counter(row.whose in LIGHT for row in rows if row.outcome == outcome)
    count = found.total()
    if not count:
        return ""
    parts = "".join(
        f'<span class="part{" light" if light else ""}" style="width: {found[light] / len(rows):.1%}"></span>'
        for light in (False, True)
        if found[light]
    )
    return (
        f'<button type="button" class="bar" aria-pressed="false" data-outcome="{outcome}" style="{_colour(outcome)}">'
        f'<span>{OUTCOMES[outcome]}</span><span class="track">{parts}</span><span class="count">{count}</span></button>'
    )


def _row(row: Row) -> str:
    address = html.escape(f"https://github.com/{row.repository}/tree/{row.commit}")
    seen = (
        (row.imports, "imports", "imports fail"),
        (row.started, "started", "did not start"),
        (row.alive, "ran on", "ended with an error"),
        (row.drawn, "drew a window", "no window"),
    )
    marks = [yes if value else no for value, yes, no in seen if value is not None]
    marks += [f"rung {row.rung}"] if row.rung is not None else []
    base = f"<small>in truth {html.escape(row.stand_in)}</small>" if row.stand_in else ""
    why = f"{html.escape(row.why)}<small>{WHOSE[row.whose]}</small>" if row.why else ""
    texts = (
        ("command", f"<code>{html.escape(row.command)}</code>" if row.command else ""),
        ("why", why),
        ("base", f"<code>{html.escape(row.base)}</code>{base}" if row.base else ""),
    )
    return (
        f'<tr data-outcome="{row.outcome}" data-kind="{html.escape(row.kind)}">'
        f'<td class="name"><a href="{address}">{html.escape(row.repository)}</a>'
        f"<small>{html.escape(row.kind)}, {row.commit}</small></td>"
        f'<td class="result" style="{_colour(row.outcome)}"><span class="mark"></span>{row.outcome}'
        f"<small>{', '.join(marks)}</small></td>"
        + "".join(f'<td data-head="{head}">{text}</td>' if text else "<td></td>" for head, text in texts)
        + "</tr>"
    )


def _code(text: str) -> str:
    """Return a sentence of Markdown as HTML: only its code is marked."""
    parts = html.escape(text).split("`")
    return "".join(f"<code>{part}</code>" if number % 2 else part for number, part in enumerate(parts))
