"""Jobs of GitHub's CI that build wheels by cibuildwheel: in containers, so that the runner's Ubuntu tells nothing.

https://cibuildwheel.pypa.io/en/stable/options/#build-skip, 2026-11-27
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from roslab.evidence.facts import Mention
from roslab.values.pattern import pattern

NAME = "cibuildwheel"
_JOBS = pattern(r"[\"']?jobs[\"']?[ \t]*:[ \t]*(?:#.*)?$")
_BUILD = pattern(r"[\"']?CIBW_BUILD[\"']?[ \t]*[:=][ \t]*(.*)")
_TAG = pattern(r"\bcp([23])(\d{1,2})-")
_OF_RUNNER = frozenset({"ubuntu", "python"})


def without_runners(found: Iterable[Mention], text: str, file: str) -> Iterator[Mention]:
    """Yield the mentions of a file but for those of the runners of such jobs, and the Pythons that these build for."""
    jobs = list(_wheel_jobs(text.split("\n"))) if NAME in text else []
    for each in found:
        if each.topic not in _OF_RUNNER or not any(each.line - 1 in job for job in jobs):
            yield each
    lines = text.split("\n") if jobs else []
    for at in (at for job in jobs for at in job):
        built = _BUILD.search(lines[at])
        for tag in _TAG.finditer(built[1]) if built else ():
            value, said = f"{tag[1]}.{tag[2]}", lines[at].strip()[:200]
            yield Mention(topic="python", value=value, source="ci", file=file, line=at + 1, text=said)


def _wheel_jobs(lines: list[str]) -> Iterator[range]:
    """Yield the lines of each such job, counted from 0."""
    first = next((at for at, line in enumerate(lines, 1) if _JOBS.match(line)), len(lines))
    filled = [at for at in range(first, len(lines)) if lines[at].strip()]
    end = next((at for at in filled if not lines[at].startswith((" ", "\t"))), len(lines))
    indent = _indent(lines[filled[0]]) if filled else 0
    starts = [at for at in filled if at < end and _indent(lines[at]) <= indent]
    for start, stop in zip(starts, (*starts[1:], end)[: len(starts)], strict=True):
        if any(NAME in line for line in lines[start + 1 : stop]):
            yield range(start, stop)


def _indent(line: str) -> int:
    return len(line) - len(line.lstrip())
