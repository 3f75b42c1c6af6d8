"""What is run inside an image before it gets a tag: the repository's own test, else a default one for its kind."""

from __future__ import annotations

from dataclasses import replace

from roslab.decide.decision import Decision
from roslab.plan.installed import installed
from roslab.plan.proof import Proof
from roslab.plan.workspace import ROS_TOOLS, Workspace

ROSTEST_SCRIPT = 'failed=0; for file in "$@"; do rostest "$file" || failed=1; done; exit $failed'
MOST_TESTS = 3
"""Most launch files with tests that are tried; each starts a ROS of its own."""
TEST_SECONDS = 120
"""Seconds that tests of the tree may take together, which nobody asked for."""


def proofs(decision: Decision, place: Workspace) -> tuple[Proof, ...]:
    """Return the proofs of an image, in the order in which they are run: that of the ladder.

    The repository's own test decides alone: whoever writes one says what has to work. The rest is then only told.
    """
    below, start = installed(decision, place), _start(decision)
    if not decision.test:
        return (*below, start, *_found_tests(decision))
    command = ("bash", "-c", decision.test) if isinstance(decision.test, str) else decision.test
    test = Proof(name="the repository's test", command=command, display=decision.gui, rung=4)
    told = (replace(proof, required=False) for proof in (*below, *([start] if start.rung else [])))
    return (*told, test)


def _found_tests(decision: Decision) -> list[Proof]:
    """Return tests of the tree, which nobody promised to pass: they are tried and told."""
    files = decision.rostests[:MOST_TESTS]
    if not files or decision.workspace == "none" or decision.build_tool not in ROS_TOOLS:
        return []
    all_of = len(decision.rostests)
    name = (
        "the repository's rostests" if len(files) == all_of else f"{len(files)} of the repository's {all_of} rostests"
    )
    command = ("bash", "-c", ROSTEST_SCRIPT, "proof", *files)
    return [Proof(name=name, command=command, required=False, rung=4, limit=TEST_SECONDS)]


def _start(decision: Decision) -> Proof:
    # The author's Dockerfile has a CMD of its own, which an empty command runs.
    start: tuple[str, ...] | str = () if decision.dockerfile else decision.command
    argv = ("bash", "-c", start) if isinstance(start, str) else start
    said = bool(decision.dockerfile or decision.command_named) or argv[:1] == ("bash",)
    name = "the default command starts"
    shell = argv == ("bash",)  # without a terminal it ends at once: no program of the repository has started
    return Proof(
        name=name,
        command=argv,
        required=said,
        guessed=not said,
        may_run_on=True,
        display=decision.gui and not shell,
        rung=None if shell else 1,
        graph=None if shell or decision.kind not in ("ros1", "ros2") else decision.kind,
    )
