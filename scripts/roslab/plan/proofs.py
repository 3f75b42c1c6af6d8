"""What is run inside an image before it gets a tag: the repository's own test, else a default one for its kind."""

from __future__ import annotations

from roslab.decide.decision import Decision
from roslab.plan.found_tests import found_tests
from roslab.plan.installed import installed
from roslab.plan.proof import Proof
from roslab.plan.run import given
from roslab.plan.workspace import Workspace
from roslab.values.dataclass import replace


def proofs(decision: Decision, place: Workspace) -> tuple[Proof, ...]:
    """Return the proofs of an image, in the order in which they are run: that of the ladder.

    The repository's own test decides alone: whoever writes one says what has to work. The rest is then only told.
    """
    below, start = installed(decision, place), _start(decision)
    if not decision.test:
        return (*below, start, *found_tests(decision, place))
    command = ("bash", "-c", decision.test) if isinstance(decision.test, str) else decision.test
    through = decision.entrypoint_takes == "commands"  # else it would be arguments of the program, or nothing
    test = Proof(name="the repository's test", command=command, display=decision.gui, rung=4, entrypoint=through)
    told = (replace(proof, required=False) for proof in (*below, *([start] if start.rung else [])))
    return (*told, test)


def _start(decision: Decision) -> Proof:
    told = given(decision)
    # The author's Dockerfile has a CMD of its own, which an empty command runs.
    start: tuple[str, ...] | str = told.command if told else () if decision.dockerfile else decision.command
    argv = ("bash", "-c", start) if isinstance(start, str) else start
    its_own = not told and (decision.dockerfile or argv == ("bash",))
    said = bool(its_own or decision.command_named)
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
        entrypoint=told is None or told.entrypoint,
        graph=None if shell or decision.kind not in ("ros1", "ros2") else decision.kind,
    )
