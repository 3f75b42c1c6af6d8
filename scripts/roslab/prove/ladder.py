"""From what the proofs of one platform showed to its ladder; nothing is said that was not seen."""

from __future__ import annotations

import re
from collections.abc import Sequence

from roslab.config.model import ProofGoals
from roslab.knowledge.test_counts import count_of_tests
from roslab.plan.ladder import Ladder, Rung
from roslab.plan.proof import Proof
from roslab.prove.containers import Outcome
from roslab.prove.graph import Graph
from roslab.values.dataclass import replace

_NO_PROGRAM = (126, 127)
"""Exit codes of ``docker run`` where there is no such program: https://docs.docker.com/engine/containers/run/"""
SHORT = 3.0
"""Seconds in which a process may use a GPU without being seen there: one looks every second."""
MOST = 12
"""Most topics, files or nodes that one line names."""


def climb(proofs: Sequence[Proof], outcomes: Sequence[Outcome], goals: ProofGoals, *, gpu: bool = False) -> Ladder:
    """Return the ladder of an image whose ``proofs`` had these ``outcomes``, in the same order.

    The outcomes may be fewer: after a failure nothing more is tried. ``gpu``: the image needs a GPU.
    """
    seen = {outcome.proof.name: outcome for outcome in outcomes}
    start = next((proof for proof in proofs if proof.rung == 1), None)
    outcome = seen.get(start.name) if start else None
    rungs = (
        _commands(0, [proof for proof in proofs if proof.rung == 0], seen),
        _starts(start, outcome),
        _talks(start, outcome, goals),
        _shows(start, outcome),
        _agrees([proof for proof in proofs if proof.rung == 4], seen),
        _computes(outcomes) if gpu else None,
    )
    return Ladder(rungs=tuple(rung for rung in rungs if rung))


def _commands(number: int, proofs: Sequence[Proof], seen: dict[str, Outcome]) -> Rung | None:
    """Return a rung that holds if all of its commands did what they should."""
    if not proofs:
        return None
    facts = tuple(proof.name for proof in proofs if proof.name in seen and seen[proof.name].held)
    short = next((proof for proof in proofs if proof.name not in facts), None)
    if short is None:
        told = (name + _looked_at(seen[name]) for name in facts)
        return Rung(number=number, state="held", said="; ".join(told), facts=facts)
    if short.name not in seen:
        return _untried(number)
    why = f"{short.name}: {_plain(seen[short.name])}"
    if seen[short.name].seen.code in _NO_PROGRAM and not short.required:
        said = re.search(r"^the image has no \w{1,40}$", seen[short.name].output, re.MULTILINE)
        lacking = said[0] if said else f"the image has no {short.command[0]}"
        return Rung(number=number, state="unseen", said=f"{why}: {lacking}", facts=facts)
    needed = f"that {short.name}" if number == 0 else f"{short.name} to pass"
    return Rung(number=number, state="missed", said=why, needed=needed, facts=facts)


def _looked_at(outcome: Outcome) -> str:
    """Return how much a proof looked at, or which packages are empty, where it says it: nothing is wrong with none."""
    told = r"^(?:[a-z ]{1,40} looked at: \d{1,9}|packages that were built and install nothing: [\w. -]{1,300})$"
    found = re.search(told, outcome.output, re.MULTILINE)
    return f" ({found[0]})" if found else ""


def _agrees(proofs: Sequence[Proof], seen: dict[str, Outcome]) -> Rung | None:
    """Return the rung of the tests: one that ended with 0 and ran nothing has agreed with nothing."""
    found = _commands(4, proofs, seen)
    if found is None or found.state != "held":
        return found
    counts = {proof.name: count_of_tests(seen[proof.name].output) for proof in proofs}
    if empty := [name for name, count in counts.items() if count == 0]:
        return replace(
            found,
            state="missed",
            said=f"{_listed(empty)} ended with 0, and ran no test",
            needed="a test that is found and not skipped",
        )
    told = [
        f"{name}: {_count(count, 'test')} ran" if count else f"{name} ended with 0" for name, count in counts.items()
    ]
    return replace(found, said=_listed(told), facts=tuple(told))


def _computes(outcomes: Sequence[Outcome]) -> Rung:
    """Return the rung of the GPU: a process of the image was seen to compute on it, in a proof that held."""
    given = [outcome for outcome in outcomes if outcome.seen.on_gpu is not None]
    if not given:
        said = "it was not tried: this machine gives containers no GPU"
        return Rung(number=5, state="unseen", said=said, needed="a machine whose engine gives a container its GPU")
    used = [outcome for outcome in given if outcome.seen.on_gpu and outcome.held]
    if used:
        facts = tuple(f"{outcome.proof.name}, on the GPU" for outcome in used)
        return Rung(number=5, state="held", said=_listed(facts), facts=facts)
    needed = "a process that is seen to compute on the device"
    if max(outcome.seconds for outcome in given) < SHORT:
        return Rung(number=5, state="unseen", said="nothing ran long enough to be seen on the device", needed=needed)
    return Rung(number=5, state="missed", said="no process of it was seen on the device", needed=needed)


def _starts(start: Proof | None, outcome: Outcome | None) -> Rung | None:
    if start is None or (outcome and outcome.seen.bare):
        return None
    if outcome is None:
        return _untried(1)
    facts = ("the command runs on" if outcome.seen.code is None else "the command ends",)
    also = "".join(f"; {each}" for each in outcome.seen.restarted[:MOST])
    if outcome.held and not outcome.seen.respawned:
        lived = (
            f"still ran after {outcome.seconds:.0f} s" if outcome.seen.code is None
            else f"ended with 0 after {outcome.seconds:.1f} s"
        )  # fmt: skip
        return Rung(number=1, state="held", said=f"the command {lived}{also}", facts=facts)
    died = ", ".join(outcome.seen.respawned[:MOST])
    why = f"{died}, because it had ended" if outcome.held else _plain(outcome) + (f"; {died}" if died else "")
    needed = "nodes that live" if outcome.held else "a command that lives, or ends with 0, with all of its nodes"
    return Rung(number=1, state="missed", said=why + also, needed=needed, facts=facts)


def _talks(start: Proof | None, outcome: Outcome | None, goals: ProofGoals) -> Rung | None:
    if start is None or start.graph is None:
        return None
    if outcome and outcome.seen.bare:
        return None
    graph = outcome.seen.graph if outcome else None
    if graph is None:
        return _untried(2)
    facts = (
        *(f"node {name}" for name in graph.nodes),
        *(f"topic {t.name} [{t.type}] {'talks' if t.messages else 'is silent'}" for t in graph.topics),
        *(f"service {name}" for name in graph.services),
    )
    needed = _missing(graph, goals)
    if not graph.nodes and not graph.topics:
        said = "no node was in the graph" + (f": {graph.problem}" if graph.problem else "")
        blind = graph.problem.startswith("the image has no")
        return Rung(number=2, state="unseen" if blind else "missed", said=said, needed=needed)
    return Rung(number=2, state="missed" if needed else "held", said=_told(graph), needed=needed, facts=facts)


def _missing(graph: Graph, goals: ProofGoals) -> str:
    """Return what a graph lacks to be one that talks, ``""`` if it lacks nothing.

    A node that only serves talks if it answers a question without effect and has a service of its own.
    """
    if not graph.nodes:
        return "a node in the graph that is not hidden"
    talking = {topic.name for topic in graph.topics if topic.messages}
    if silent := [name for name in goals.topics if name not in talking]:
        return f"a message on {', '.join(silent)}"
    if talking or (graph.services and graph.answered and not graph.topics):
        return ""
    if graph.topics:
        return "a message on " + " or ".join(topic.name for topic in graph.topics[:MOST])
    return "a node that publishes, or serves and answers"


def _told(graph: Graph) -> str:
    """Return what a graph showed, each topic with its type and its messages."""
    topics = [f"{t.name} [{t.type}] {_count(t.messages, 'message')}" for t in graph.topics]
    parts = [f"{_count(len(graph.nodes), 'node')} ({_listed(graph.nodes)})"]
    parts.append(f"in {graph.seconds:.0f} s {_listed(topics)}" if topics else "no topic")
    if graph.services:
        parts.append(f"{_count(len(graph.services), 'service')} ({_listed(graph.services)})")
    if graph.answered:
        parts.append(f"{_listed(graph.answered)} answered")
    return "; ".join(parts)


def _shows(start: Proof | None, outcome: Outcome | None) -> Rung | None:
    """Return the rung of a window with more than one colour, or of a file; without either it is left out."""
    if start is None or not (start.display or (outcome and outcome.seen.written)):
        return None
    if outcome is None:
        return _untried(3)
    facts = tuple(f"file {path}" for path in outcome.seen.written)
    said = [f"it wrote {_listed(outcome.seen.written)}"] if facts else []
    if outcome.drawn:
        said.insert(0, "a window showed more than one colour")
        facts = ("window", *facts)
    if facts:
        return Rung(number=3, state="held", said="; ".join(said), facts=facts)
    shot = outcome.screenshot
    if shot is None or shot.file is None:
        why = shot.remark if shot and shot.remark else "there was no display"
        return Rung(number=3, state="unseen", said=why, needed="a display and a picture of it")
    return Rung(number=3, state="missed", said="the screen had one colour", needed="a window that draws something")


def _plain(outcome: Outcome) -> str:
    """Return an outcome without the words that excuse one on which nothing depends."""
    return outcome.summary.removeprefix("not proved: ").removeprefix("it ")


def _untried(number: int) -> Rung:
    return Rung(number=number, state="unseen", said="it was not tried: an earlier proof failed")


def _listed(names: Sequence[str]) -> str:
    more = len(names) - MOST
    return ", ".join(names[:MOST]) + (f" and {more} more" if more > 0 else "")


def _count(number: int, what: str) -> str:
    return f"{number} {what}{'' if number == 1 else 's'}"
