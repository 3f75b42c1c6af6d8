"""What is said of each rung, from what was seen; the cases are those that would deceive a careless look."""

from __future__ import annotations

from dataclasses import replace

import pytest

from roslab.config.model import ProofGoals
from roslab.plan.ladder import Ladder, Rung, below, lines
from roslab.plan.proof import Proof
from roslab.prove.containers import Outcome, Seen
from roslab.prove.graph import Graph, Topic
from roslab.prove.ladder import climb
from roslab.prove.screenshot import Screenshot

FOUND = Proof(name="the workspace's packages are found", command=("true",), rung=0)
START = Proof(name="the default command starts", command=("x",), may_run_on=True, rung=1, graph="ros1")
PLAIN = replace(START, graph=None)
WINDOW = replace(PLAIN, display=True)
SHELL = replace(PLAIN, rung=None)
TEST = Proof(name="the repository's test", command=("y",), rung=4)
CHATTER = Topic(name="/chatter", type="std_msgs/String", messages=7)
SILENT = replace(CHATTER, name="/scan", messages=0)
ODOM = replace(SILENT, name="/odom")
TALK = Graph(nodes=("/talker",), answered=("/talker",), topics=(CHATTER,), seconds=9.6)
NONE = ProofGoals()


def outcome(proof: Proof, summary: str = "passed", *, held: bool = True, seen: Seen | None = None) -> Outcome:
    return Outcome(
        proof=proof,
        platform="linux/amd64",
        passed=True,
        seconds=10.0,
        summary=summary,
        output="",
        held=held,
        seen=seen or Seen(code=None),
    )


def of(*outcomes: Outcome, goals: ProofGoals = NONE) -> Ladder:
    return climb([each.proof for each in outcomes], outcomes, goals)


def rung(ladder: Ladder, number: int) -> Rung:
    return next(each for each in ladder.rungs if each.number == number)


def graphed(graph: Graph, goals: ProofGoals = NONE) -> Rung:
    return rung(of(outcome(START, seen=Seen(code=None, graph=graph)), goals=goals), 2)


def test_all_that_a_talker_can_have() -> None:
    ladder = of(outcome(FOUND), outcome(START, seen=Seen(code=0, graph=TALK)), outcome(TEST))
    assert [(each.number, each.state) for each in ladder.rungs] == [(0, "held"), (1, "held"), (2, "held"), (4, "held")]
    assert ladder.reached == 4
    assert rung(ladder, 2).said == "1 node (/talker); in 10 s /chatter [std_msgs/String] 7 messages; /talker answered"
    assert lines(ladder)[-1] == "reached: rung 4, agrees"


def test_a_command_that_prints_success_and_sleeps() -> None:
    plain = of(outcome(PLAIN))
    assert [each.number for each in plain.rungs] == [1]
    assert rung(plain, 1).said == "the command still ran after 10 s"
    ros = of(outcome(START, seen=Seen(code=None, graph=Graph(problem="no ROS master answered", seconds=10))))
    assert ros.reached == 1
    assert rung(ros, 2).said == "no node was in the graph: no ROS master answered"
    assert rung(ros, 2).state == "missed"


def test_a_shell_is_no_program_of_the_repository() -> None:
    assert of(outcome(SHELL)).rungs == ()
    assert of(outcome(FOUND), outcome(SHELL), outcome(TEST)).reached == 4


def test_a_node_that_dies_and_is_respawned() -> None:
    seen = Seen(code=None, graph=TALK, respawned=("/talker was started anew 3 times",))
    found = rung(of(outcome(START, seen=seen)), 1)
    assert (found.state, found.said) == ("missed", "/talker was started anew 3 times, because it had ended")


def test_what_a_loop_starts_anew_is_told_and_is_no_failure() -> None:
    found = rung(of(outcome(PLAIN, seen=Seen(code=None, restarted=("python3 n.py was started anew 4 times",)))), 1)
    assert found.state == "held"
    assert found.said.endswith("; python3 n.py was started anew 4 times")


def test_a_launch_with_a_dead_node_says_which() -> None:
    summary = "not proved: it failed: b-3 died with exit code 1, though the launch itself still ran after 10.0 s"
    found = rung(of(outcome(START, summary, held=False, seen=Seen(code=None, graph=TALK))), 1)
    assert found.state == "missed"
    assert found.said.startswith("failed: b-3 died with exit code 1, though")


@pytest.mark.parametrize(
    ("graph", "goals", "needed"),
    [
        (TALK, NONE, ""),
        (replace(TALK, topics=(CHATTER, SILENT)), NONE, ""),
        (replace(TALK, topics=(SILENT,)), NONE, "a message on /scan"),
        (replace(TALK, topics=()), NONE, "a node that publishes, or serves and answers"),
        (replace(TALK, topics=(), services=("/add",)), NONE, ""),
        (
            replace(TALK, topics=(), services=("/add",), answered=()),
            NONE,
            "a node that publishes, or serves and answers",
        ),
        (replace(TALK, topics=(SILENT, ODOM), services=("/add",)), NONE, "a message on /scan or /odom"),
        (TALK, ProofGoals(topics=("/scan", "/chatter")), "a message on /scan"),
        (Graph(), NONE, "a node in the graph that is not hidden"),
    ],
)
def test_what_a_graph_needs_to_talk(graph: Graph, goals: ProofGoals, needed: str) -> None:
    found = graphed(graph, goals)
    assert (found.state, found.needed) == ("missed" if needed else "held", needed)


def test_a_silent_topic_is_told_with_its_nought() -> None:
    assert "/scan [std_msgs/String] 0 messages" in graphed(replace(TALK, topics=(CHATTER, SILENT))).said


def test_an_image_without_python_is_not_accused() -> None:
    assert graphed(Graph(problem="the image has no Python to look at the graph with")).state == "unseen"


@pytest.mark.parametrize(
    ("drawn", "shot", "written", "state"),
    [
        (True, Screenshot(file=None), (), "held"),
        (False, Screenshot(remark="Xvfb is not installed"), (), "unseen"),
        (False, Screenshot(remark="Xvfb is not installed"), ("/w/map.png",), "held"),
    ],
)
def test_what_shows(drawn: bool, shot: Screenshot, written: tuple[str, ...], state: str) -> None:
    found = replace(outcome(WINDOW, seen=Seen(code=None, written=written)), drawn=drawn, screenshot=shot)
    assert rung(of(found), 3).state == state


def test_a_window_of_one_colour(tmp_path_factory: pytest.TempPathFactory) -> None:
    shot = Screenshot(file=tmp_path_factory.mktemp("x") / "a.png", remark="nothing was drawn: it is wholly blank")
    found = rung(of(replace(outcome(WINDOW), screenshot=shot)), 3)
    assert (found.state, found.said) == ("missed", "the screen had one colour")


def test_after_a_failure_the_rest_was_not_tried() -> None:
    ladder = climb([FOUND, START, TEST], [outcome(FOUND, "failed with exit code 1", held=False)], NONE)
    assert [each.state for each in ladder.rungs] == ["missed", "unseen", "unseen", "unseen"]
    assert ladder.reached is None
    assert str(ladder) == "no rung; rung 0, installs, would need that the workspace's packages are found"


def test_a_test_that_fails() -> None:
    ladder = climb((FOUND, TEST), (outcome(FOUND), outcome(TEST, "failed with exit code 1", held=False)), NONE)
    assert str(ladder) == "rung 0, installs; rung 4, agrees, would need the repository's test to pass"


def test_a_shell_has_no_more_than_rung_0() -> None:
    ladder = of(outcome(FOUND))
    assert str(ladder).startswith("rung 0, installs; rung 1, starts, would need a program in the place of the shell")
    assert not of(outcome(FOUND), outcome(TEST)).beyond


def test_what_is_asked_for() -> None:
    ladder = of(outcome(FOUND), outcome(START, seen=Seen(code=None, graph=replace(TALK, topics=(SILENT,)))))
    assert below(ladder, None) == below(ladder, 0) == below(ladder, 1) == ""
    assert below(ladder, 2).endswith("and rung 2, talks, does not hold: a message on /scan")
    assert "which this image cannot have" in below(of(outcome(PLAIN)), 3)


def test_a_test_that_collects_nothing() -> None:
    found = rung(of(replace(outcome(TEST), output="Ran 0 tests in 0.000s\n\nOK\n")), 4)
    assert (found.state, found.said) == ("missed", "the repository's test ended with 0, and ran no test")
    assert rung(of(replace(outcome(TEST), output="Ran 2 tests in 0.1s\n")), 4).said.endswith("test: 2 tests ran")
    assert rung(of(outcome(TEST)), 4).said == "the repository's test ended with 0"


def test_an_image_whose_own_command_is_a_shell() -> None:
    assert of(outcome(START, seen=Seen(code=0, bare=True, graph=Graph(problem="x")))).rungs == ()


def test_rung_0_says_how_much_it_looked_at() -> None:
    """That all of no programs find their libraries is no praise."""
    ladder = of(replace(outcome(FOUND), output="programs looked at: 0\n"))
    assert rung(ladder, 0).said == "the workspace's packages are found (programs looked at: 0)"
    assert rung(ladder, 0).facts == ("the workspace's packages are found",)


def test_an_authors_image_without_the_program_that_looks() -> None:
    asked = replace(FOUND, command=("bash", "-c", "x"), required=False)
    found = rung(of(outcome(asked, "failed with exit code 127", held=False, seen=Seen(code=127))), 0)
    assert (found.state, found.said) == ("unseen", f"{FOUND.name}: failed with exit code 127: the image has no bash")


@pytest.mark.parametrize(
    ("on_gpu", "seconds", "state", "said"),
    [
        (None, 10.0, "unseen", "it was not tried: this machine gives containers no GPU"),
        (0, 10.0, "missed", "no process of it was seen on the device"),
        (0, 0.4, "unseen", "nothing ran long enough to be seen on the device"),
        (1, 10.0, "held", "the default command starts, on the GPU"),
    ],
)
def test_a_gpu(on_gpu: int | None, seconds: float, state: str, said: str) -> None:
    """That a container was given a device says nothing of what its program did with it."""
    found = replace(outcome(PLAIN, seen=Seen(code=None, on_gpu=on_gpu)), seconds=seconds)
    assert [each.number for each in of(found).rungs] == [1]
    rung_5 = rung(climb((PLAIN,), (found,), ProofGoals(), gpu=True), 5)
    assert (rung_5.state, rung_5.said) == (state, said)


def test_a_program_that_fails_on_a_gpu_has_not_run_on_it() -> None:
    found = outcome(PLAIN, "failed with exit code 1", held=False, seen=Seen(code=1, on_gpu=1))
    assert rung(climb((PLAIN,), (found,), ProofGoals(), gpu=True), 5).state == "missed"
