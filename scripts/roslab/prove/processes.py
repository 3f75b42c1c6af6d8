"""The processes of a container, looked at from outside: which ended, and were started anew."""

from __future__ import annotations

from collections import Counter

from roslab.engine.docker import output
from roslab.knowledge.launches import launches
from roslab.values.dataclass import dataclass, field
from roslab.values.pattern import pattern

_NAME = pattern(r"\b(?:__name|__node):=(\S+)")
LONGEST = 80
"""Most characters of a command that are told."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Process:
    """One process."""

    number: int
    parent: int
    command: str


@dataclass(kw_only=True, slots=True)
class Census:
    """What was seen of a container's processes, at one look after another."""

    numbers: set[int] = field(default_factory=set, init=False)
    """Of all processes that were seen, as this machine counts them."""
    _last: dict[int, Process] = field(default_factory=dict, init=False)
    _gone: Counter[tuple[int, str]] = field(default_factory=Counter, init=False)
    _launched: Counter[str] = field(default_factory=Counter, init=False)
    _others: Counter[tuple[int, str]] = field(default_factory=Counter, init=False)

    def look(self, container: str) -> None:
        """Look at a container's processes; it is no error if it has ended."""
        answer = output(["docker", "top", container, "-eo", "pid,ppid,args"], timeout=20.0)
        if answer.returncode == 0:
            self.take(read(answer.stdout))

    def take(self, now: dict[int, Process]) -> None:
        """Compare the processes with those of earlier looks: the same command with another number was started anew.

        There may be none of it at a look between, because a launch may wait before it starts a node again. What a shell
        ran before it became another command, for example the setup files that an entry point sources, is forgotten.
        """
        for number, process in self._last.items():
            if number in now and now[number].command != process.command:
                self._forget_children(number)
        self.numbers.update(now)
        self._gone.update(_key(process) for number, process in self._last.items() if number not in now)
        for number, process in now.items():
            if number not in self._last and self._gone[_key(process)]:
                self._gone[_key(process)] -= 1
                parent = now.get(process.parent)
                if parent and launches(parent.command):
                    self._launched[_name(process.command)] += 1
                else:
                    self._others[process.parent, _name(process.command)] += 1
        self._last = now

    def _forget_children(self, number: int) -> None:
        for key in [key for key in self._gone if key[0] == number]:
            del self._gone[key]
        for key in [key for key in self._others if key[0] == number]:
            del self._others[key]

    @property
    def respawned(self) -> tuple[str, ...]:
        """What a launch started anew, because it had ended: ``/talker was started anew 3 times``."""
        return _told(self._launched)

    @property
    def restarted(self) -> tuple[str, ...]:
        """What others started anew, for example a loop of a shell; whether it had failed is not known."""
        return _told(Counter([name for _, name in self._others.elements()]))


def read(text: str) -> dict[int, Process]:
    """Read what ``docker top -eo pid,ppid,args`` prints; processes that do not belong to the container's are left out.

    The container's first process and what an engine started beside it have a parent outside.
    """
    found = {}
    for line in text.splitlines()[1:]:
        words = line.split(None, 2)
        if len(words) == 3 and words[0].isdigit() and words[1].isdigit():
            process = Process(number=int(words[0]), parent=int(words[1]), command=words[2])
            found[process.number] = process
    return {number: process for number, process in found.items() if process.parent in found}


def _key(process: Process) -> tuple[int, str]:
    return process.parent, process.command


def _name(command: str) -> str:
    named = _NAME.search(command)
    if named:
        return named[1]
    return command if len(command) <= LONGEST else command[: LONGEST - 1] + "…"


def _told(counted: Counter[str]) -> tuple[str, ...]:
    return tuple(f"{name} was started anew {times} time{'s' * (times > 1)}" for name, times in sorted(counted.items()))
