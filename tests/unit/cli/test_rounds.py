"""The rounds after an image is good enough: its command dies of something that is certainly missing."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from roslab.cli import rounds as rounds_module
from roslab.cli.arguments import parser
from roslab.cli.planning import planned_of
from roslab.cli.repairing import Repairing
from roslab.cli.rounds import Check, Made, better, first
from roslab.engine.docker import FailedBuild
from roslab.errors import BuildError, Problem, RefusedError
from roslab.pipeline import Planned
from roslab.plan.ladder import Ladder, Rung
from roslab.values.dataclass import replace

MISSING = "Traceback (most recent call last):\n{}ModuleNotFoundError: No module named 'yaml'\n".format(
    '  File "/home/jovyan/robot/main.py", line 2, in <module>\n'
)
OTHER = MISSING.replace("yaml", "serial")
MISTAKE = "Traceback (most recent call last):\nKeyError: 'speed'\n"
LEFT = {
    "a GPU": "RuntimeError: Found no NVIDIA driver on your system. Please check that you have an NVIDIA GPU",
    "a camera": "cv2.error: can't open camera by index: /dev/video0: No such file or directory",
    "an argument": "usage: main.py [-h] --bag BAG\nmain.py: error: the following arguments are required: --bag",
    "data": "FileNotFoundError: [Errno 2] No such file or directory: 'data/kitti/00.bag'",
    "a roscore": "Unable to communicate with master!\nrospy.exceptions.ROSInitException: could not contact master",
    "memory": "c++: fatal error: Killed signal terminated program cc1plus",
}
HELD = Ladder(rungs=(Rung(number=0, state="held", said=""), Rung(number=1, state="missed", said="")))
LOST = Ladder(rungs=(Rung(number=0, state="missed", said="no package robot"), Rung(number=1, state="held", said="")))


def dead(log: str) -> FailedBuild:
    return FailedBuild(Problem(message="on linux/amd64, the default command does not start"), log=log)


def made(log: str = "", ladder: Ladder = HELD) -> Made:
    return Made(images=(("robot:main", ladder),), missed=dead(log) if log else None)


class Rounds:
    """A stand-in of the engine: what each round ends with, and what the plan of each asked pip for."""

    def __init__(self, *ends: Made | BuildError) -> None:
        self.ends = list(ends)
        self.named: list[Made] = []
        self.pip: list[list[str]] = []

    def __call__(self, planned: Planned, check: Check) -> Made:
        self.pip.append([reason.answer for reason in planned.plan.reasons if reason.answer in ("PyYAML", "pyserial")])
        end = self.ends.pop(0)
        if isinstance(end, BuildError):
            raise end
        check(end)
        self.named.append(end)
        return end


Make = Callable[..., Repairing]


@pytest.fixture
def make(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Make:
    """Return what makes the repairs of a small program, with a docker that does nothing."""
    robot = tmp_path / "robot"
    robot.mkdir()
    (robot / "main.py").write_text('import importlib\nimportlib.import_module("ya" + "ml")\n')
    (tmp_path / "docker").write_text('#!/bin/sh\necho "$*" >>"${0%/*}/called"\n')
    (tmp_path / "docker").chmod(0o755)
    monkeypatch.setenv("PATH", str(tmp_path), prepend=":")

    def repairing(*words: str) -> Repairing:
        options = parser("build").parse_args(["build", str(robot), *words])
        return Repairing(options=options, planned=planned_of(options))

    return repairing


def ran(rounds: Rounds, repairing: Repairing) -> tuple[Made, list[str]]:
    found = better(rounds, repairing, first(rounds, repairing))
    return found, [str(change) for change in repairing.changes]


def test_a_command_that_lacks_modules_gets_them_one_after_the_other(make: Make, tmp_path: Path) -> None:
    rounds = Rounds(made(MISSING), made(OTHER), made())
    found, changes = ran(rounds, make())
    assert changes == ["pip: [PyYAML]", "pip: [pyserial]"]
    assert found == rounds.named[-1]
    assert len(rounds.named) == 3
    assert "image rm robot:roslab-before-" in (tmp_path / "called").read_text()


def test_a_command_that_lacks_two_folders_gets_both(make: Make) -> None:
    repairing = make("--write")
    for module in ("grip", "walk"):
        (repairing.planned.repository.root / module).mkdir()
        (repairing.planned.repository.root / module / f"{module}s.py").write_text("print(1)\n")
    repairing.planned = planned_of(repairing.options)
    rounds = Rounds(*(made(MISSING.replace("yaml", module)) for module in ("grips", "walks")), made())
    ran(rounds, repairing)
    repairing.finish()
    written = (repairing.planned.repository.root / "roslab.yaml").read_text()
    assert '  PYTHONPATH: "/home/jovyan/robot/walk:/home/jovyan/robot/grip"' in written


def test_what_is_good_enough_is_built_once(make: Make) -> None:
    assert ran(Rounds(made()), make())[1] == []


@pytest.mark.parametrize(
    ("second", "why"),
    [
        (FailedBuild(Problem(message="the build failed"), log="nobody knows"), "the build failed"),
        (BuildError(Problem(message="no space left")), "no space left"),
        (made(MISSING), "its command does not start for the same cause"),
        (made(MISTAKE), "its command still ends with KeyError: 'speed'"),
        (made(f"{MISTAKE}[ros2run]: Process exited with failure 1\n"), "its command still ends with KeyError: 'speed'"),
        (made(ladder=LOST), "robot:main loses rung 0, installs: no package robot"),
    ],
)
def test_what_is_no_better_leaves_the_image_before_it(
    make: Make, capsys: pytest.CaptureFixture[str], second: Made | BuildError, why: str
) -> None:
    rounds = Rounds(made(f"{MISSING}{MISTAKE}" if "still" in why else MISSING), second)
    found, changes = ran(rounds, make())
    assert (found, changes) == (rounds.named[0], [])
    assert len(rounds.named) == 1
    said = capsys.readouterr().err
    assert f"roslab: robot:main stays as it was before pip: [PyYAML]: {why}\n" in said
    assert "not enough" not in said


def test_images_that_cannot_all_be_named_are_named_as_before(
    make: Make, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """Of an image and its slim one, the first has its name when the engine refuses the second."""
    held = {"robot:main": "first", "robot:main-slim": "first"}
    monkeypatch.setattr(rounds_module, "name_image", lambda image, name: held.update({name: held[image]}))
    monkeypatch.setattr(rounds_module, "remove_image", held.pop)
    both = replace(made(MISSING), images=(("robot:main", HELD), ("robot:main-slim", HELD)))

    def once(planned: Planned, check: Check) -> Made:
        if planned.plan.python.pip:
            held["robot:main"] = "second"
            raise BuildError(Problem(message="cannot name the image robot:main-slim: no space left"))
        return both

    repairing = make()
    assert better(once, repairing, first(once, repairing)) == both
    assert held == {"robot:main": "first", "robot:main-slim": "first"}
    assert "roslab: robot:main stays as it was before pip: [PyYAML]: cannot name the" in capsys.readouterr().err


def test_what_a_repair_cannot_fetch_fails_no_build(
    make: Make, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def planned_of(*_: object, **__: object) -> Planned:
        raise RefusedError(Problem(message="a link leads out of the tree"))

    repairing = make()
    monkeypatch.setattr("roslab.cli.repairing.planned_of", planned_of)
    rounds = Rounds(made(MISSING))
    assert ran(rounds, repairing) == (rounds.named[0], [])
    assert "roslab: a link leads out of the tree\n" in capsys.readouterr().err


def test_a_second_repair_that_fails_leaves_the_first(make: Make) -> None:
    rounds = Rounds(made(MISSING), made(OTHER), BuildError(Problem(message="no space left")))
    repairing = make("--write")
    found, changes = ran(rounds, repairing)
    assert (found, changes) == (rounds.named[1], ["pip: [PyYAML]"])
    repairing.finish()
    assert "PyYAML" in (repairing.planned.repository.root / "roslab.yaml").read_text()
    assert "pyserial" not in (repairing.planned.repository.root / "roslab.yaml").read_text()


def test_a_package_that_needs_another_one_to_be_built_gets_it(make: Make) -> None:
    header = "#6 [3/4] RUN pip install .\n#6 1.2 a.c:1:10: fatal error: glog/logging.h: No such file or directory\n"
    log = f'{header}#6 ERROR: process "/bin/sh -c pip install ." did not complete: exit code: 1\n'
    rounds = Rounds(made(MISSING), FailedBuild(Problem(message="the build failed"), log=log), made())
    assert ran(rounds, make())[1] == ["pip: [PyYAML]", "apt: [libgoogle-glog-dev]"]


def test_rounds_count_together(make: Make, capsys: pytest.CaptureFixture[str]) -> None:
    failed = FailedBuild(Problem(message="the build failed"), log=OTHER)
    rounds = Rounds(failed, made(MISSING))
    found, changes = ran(rounds, make("--repair=1"))
    assert (found, changes) == (rounds.named[0], ["pip: [pyserial]"])
    assert "not repaired: 1 rounds are used up" in capsys.readouterr().err


@pytest.mark.parametrize("log", [*LEFT.values(), MISTAKE], ids=[*LEFT, "a mistake"])
def test_what_an_image_cannot_bring_is_not_repaired(make: Make, log: str) -> None:
    rounds = Rounds(made(log))
    assert ran(rounds, make()) == (rounds.named[0], [])


def test_the_cause_is_told_where_nothing_repairs_it(make: Make, capsys: pytest.CaptureFixture[str]) -> None:
    ran(Rounds(made(LEFT["a GPU"])), make())
    said = capsys.readouterr().err
    assert "roslab: The program needs a device that is not there" in said
    assert "not repaired" not in said


def test_an_image_that_has_it_already_is_not_built_again(make: Make, capsys: pytest.CaptureFixture[str]) -> None:
    repairing = make()
    (repairing.planned.repository.root / "roslab.yaml").write_text("format: 3\ngui: true\n")
    repairing.planned = planned_of(repairing.options)
    rounds = Rounds(made("qt.qpa.xcb: could not connect to display\n"))
    assert ran(rounds, repairing)[1] == []
    assert "not repaired: roslab.yaml has true already, and that did not help" in capsys.readouterr().err


def test_what_the_plan_has_by_itself_is_not_built_again(make: Make, capsys: pytest.CaptureFixture[str]) -> None:
    repairing = make()
    code = "import tkinter\nwindow = tkinter.Tk()\nwindow.mainloop()\n"
    (repairing.planned.repository.root / "main.py").write_text(code)
    repairing.planned = planned_of(repairing.options)
    assert repairing.planned.plan.run.gui
    rounds = Rounds(made("_tkinter.TclError: no display name and no $DISPLAY environment variable\n"))
    assert ran(rounds, repairing)[1] == []
    assert "not repaired: the image has gui: true already, and that did not help" in capsys.readouterr().err
