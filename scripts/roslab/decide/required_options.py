"""Commands that stop at once, for their program requires arguments that they do not give."""

from __future__ import annotations

import itertools
from collections.abc import Iterable, Sequence

from roslab.decide.candidate import Candidate, launched_by, program_of
from roslab.decide.ros.workspace import packages_of
from roslab.evidence.facts import Evidence, Mention
from roslab.values.dataclass import replace


def behind_whole(candidates: Iterable[Candidate], evidence: Evidence) -> list[Candidate]:
    """Return the commands, those that lack what their program requires as the weakest, where another one does not.

    One that lost what its page leaves to the reader is known as such already.
    """
    found = list(candidates)
    lacking = [not each.cut and bool(lacks(each.argv, evidence)) for each in found]
    if all(lacking):
        return found
    return [
        replace(each, strong=False, cut=True, demands="required") if stops else each
        for each, stops in zip(found, lacking, strict=True)
    ]


def lacks(argv: Sequence[str], evidence: Evidence) -> tuple[str, ...]:
    """Return what the program of a command requires and the command does not give.

    By the calls of argparse or click, or by ``main`` of C++.
    """
    if counted := too_few(argv, evidence):
        return (counted.text,)
    file = _file(tuple(argv), evidence)
    words = argv[len(program_of(tuple(argv))) :]
    given = {word.partition("=")[0] for word in words}
    told = [m for m in evidence.mentions if m.file == file and file]
    options = [m.value for m in told if m.topic == "required" and given.isdisjoint(m.value.split())]
    positional = [m.value for m in told if m.topic == "positional"] if not words else []
    return tuple(dict.fromkeys((*positional, *options)))


def too_few(argv: Sequence[str], evidence: Evidence) -> Mention | None:
    """Return what tells that a compiled program needs more arguments than a command gives it, without those of ROS."""
    words = program_of(tuple(argv))
    if words[0] in {"bash", "sh", "make"} or words[0].startswith("python") or launched_by(words):
        return None
    name = words[-1].rpartition("/")[2]
    told = [m for m in evidence.mentions if m.topic == "argument_count" and _stem(m.file) == name]
    given = sum(":=" not in word for word in itertools.takewhile("--ros-args".__ne__, argv[len(words) :]))
    return told[0] if told and given < int(told[0].value) else None


def _stem(path: str) -> str:
    return path.rpartition("/")[2].rpartition(".")[0]


def _file(argv: tuple[str, ...], evidence: Evidence) -> str:
    """Return the file of Python that a command starts, ``""`` where nothing tells."""
    words = program_of(argv)
    if argv[0].startswith("python"):
        return words[-1] if words[-1].endswith(".py") else ""
    if argv[0] != "rosrun" and argv[:2] != ("ros2", "run"):
        return ""
    folders = (m.file.rpartition("/")[0] for m in packages_of(evidence).built if m.name == words[-2])
    folder = next(folders, None)
    below = [each.file for each in evidence.programs if folder is not None and _inside(each.file, folder)]
    return next((file for file in below if file.rpartition("/")[2] == words[-1]), "")


def _inside(file: str, folder: str) -> bool:
    return not folder or file.startswith(f"{folder}/")
