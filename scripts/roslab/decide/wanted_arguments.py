"""Nodes that pages start with arguments of the reader's alone: without these they are no default."""

from __future__ import annotations

from collections.abc import Iterable

from roslab.decide.candidate import Candidate, program_of

_NODES = ("rosrun", "ros2 run")


def without_wanting(candidates: Iterable[Candidate], found: Iterable[Candidate]) -> list[Candidate]:
    """Return the commands without those of a node that every call of a page gives ``<args>``.

    ``found``: all commands, also those of a program that is only compiled. A call with values of the page's own shows
    what the node takes, and is one of these.
    """
    calls: dict[tuple[str, ...], list[Candidate]] = {}
    for each in found:
        if each.strong and _is_node(each):
            calls.setdefault(program_of(each.argv), []).append(each)
    wanting = {program for program, all_of in calls.items() if all(each.demands == "given" for each in all_of)}
    given = {program for program, all_of in calls.items() if any(each.demands == "given" for each in all_of)} - wanting
    kept = (each for each in candidates if program_of(each.argv) not in wanting)
    return [each for each in kept if program_of(each.argv) not in given or (each.strong and each.demands != "given")]


def _is_node(candidate: Candidate) -> bool:
    return " ".join(candidate.argv[: 1 + (candidate.argv[0] == "ros2")]) in _NODES
