"""The figures as a table, as JSON and as a picture."""

from __future__ import annotations

from benchmarks.rebuild.builds import Figures
from benchmarks.rebuild.ways import CASES, FRESH, WAYS

Results = dict[str, dict[str, dict[str, Figures]]]
"""By repository, case and way."""
COLOURS = {
    "paper": "#b04a4a",
    "docker-ros": "#c9973a",
    "ours": "#2f6f9f",
    "paper-fresh-runner": "#d99a9a",
    "ours-fresh-runner": "#7fb2d6",
    "warm-container": "#8a8a8a",
}
WIDTH, LEFT, BAR = 720, 130, 11


def table(results: Results) -> str:
    """Return a table for each repository: seconds, beside them how often as long as the paper's way."""
    lines = []
    for repository, cases in results.items():
        lines += [
            "",
            f"**{repository}**",
            "",
            "| case | way | seconds | of the paper's | RUN steps | installing | MB to push | MB |",
        ]
        lines.append("| --- | --- | ---: | ---: | ---: | ---: | ---: | ---: |")
        for case in CASES:
            for way in WAYS:
                found = cases.get(case, {}).get(way)
                if not found:
                    continue
                base = cases[case].get(f"paper{FRESH}" if way.endswith(FRESH) else "paper")
                ratio = f"{found.seconds / base.seconds:.2f}" if base and base.seconds else ""
                cells = (case, way, f"{found.seconds:.1f}", ratio, found.steps, found.dependency_steps,
                         f"{found.bytes / 1e6:.1f}", f"{found.size / 1e6:.0f}")  # fmt: skip
                lines.append(f"| {' | '.join(map(str, cells))} |")
    return "\n".join(lines).lstrip("\n") + "\n"


def picture(cases: dict[str, dict[str, Figures]], title: str) -> str:
    """Return an SVG of the seconds of one repository, a group of bars for each case."""
    present = [case for case in CASES if case in cases]
    longest = max((f.seconds for ways in cases.values() for f in ways.values()), default=1.0)
    parts, top = [], 50
    for case in present:
        parts.append(f'<text x="{LEFT - 8}" y="{top + 2 * BAR}" text-anchor="end">{case}</text>')
        for way in WAYS:
            if way in cases[case]:
                seconds = cases[case][way].seconds
                width = max(1.0, (WIDTH - LEFT - 60) * seconds / longest)
                parts.append(
                    f'<rect x="{LEFT}" y="{top}" width="{width:.1f}" height="{BAR - 1}" fill="{COLOURS[way]}"/>'
                )
                parts.append(
                    f'<text x="{LEFT + width + 4:.1f}" y="{top + BAR - 2}" font-size="9">{_short(seconds)} s</text>'
                )
            top += BAR
        top += 10
    for index, way in enumerate(WAYS):
        x = 8 + 118 * index
        parts.append(f'<rect x="{x}" y="28" width="10" height="10" fill="{COLOURS[way]}"/>')
        parts.append(f'<text x="{x + 14}" y="37" font-size="10">{way}</text>')
    head = (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {top}" font-family="sans-serif" font-size="11">'
        f'<title>{title}</title><rect width="{WIDTH}" height="{top}" fill="white"/>'
        f'<text x="8" y="16" font-size="13">{title}</text>'
    )
    return "\n".join((head, *parts, "</svg>")) + "\n"


def _short(seconds: float) -> str:
    return f"{seconds:.1f}" if seconds < 10 else f"{seconds:.0f}"
