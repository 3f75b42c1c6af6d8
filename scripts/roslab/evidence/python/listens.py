"""Where a program of Python serves pages to other machines: the port in the call that starts its server."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from roslab.evidence.facts import Mention
from roslab.evidence.lex.lines import places_of
from roslab.evidence.program import Program
from roslab.evidence.python.modules import modules, run_by_pages
from roslab.knowledge.other_servers import usual_ports
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

_EVERYWHERE = "0.0.0.0"  # noqa: S104 - what is looked for
_CALL = pattern(
    r"[^#\n\"']{0,200}?\b(?P<by>\w+)\.(?:run|launch)\((?P<before>[^()]{0,400}?)[\"']0\.0\.0\.0[\"'](?P<after>[^()]{0,400})\)",
)
_PORT = pattern(r"\b(?:server_)?port\s*=\s*(\d{2,5})\b")
_OTHER = pattern(r"\b(?:server_)?port\s*=")


def read(repository: Repository, mentions: Iterable[Mention], programs: Iterable[Program]) -> Iterator[Mention]:
    """Yield the port of each program that a page runs, or that is made to be run, where the code has its number."""
    run = run_by_pages(mentions) | {program.file for program in programs if program.kind == "main"}
    for module in modules(repository) if run else ():
        if module.file.path not in run or _EVERYWHERE not in module.text:
            continue
        for number, line in _calls(module.text):
            yield Mention(
                topic="listens", value=number, source="code", file=module.file.path, line=line, text=_EVERYWHERE
            )


def _calls(text: str) -> Iterator[tuple[str, int]]:
    for at in places_of(text, _EVERYWHERE):
        start = text.rfind("(", 0, at)
        start = text.rfind("\n", 0, max(start, 0)) + 1
        if match := _CALL.match(text, start):
            given = match["before"] + match["after"]
            usual = usual_ports().get(match["by"], "") if match["by"] != "app" or "flask" in text.lower() else ""
            port = found[1] if (found := _PORT.search(given)) else "" if _OTHER.search(given) else usual
            if port:
                yield port, text.count("\n", 0, match.start("by")) + 1
