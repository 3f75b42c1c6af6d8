"""The repairs of ``roslab build``: from one failed build to the next, until one succeeds or nothing certain is left."""

from __future__ import annotations

import argparse
import io
from collections.abc import Sequence
from typing import NoReturn

from roslab.cli.asking import asking
from roslab.cli.planning import named, planned_of
from roslab.config import locate
from roslab.config.addition import Entry, added
from roslab.engine.docker import FailedBuild, say
from roslab.errors import ConfigurationError, Problem, RoslabError
from roslab.explain import words as words_of_log
from roslab.explain.answer import Answer, explain
from roslab.files import write_configuration
from roslab.pipeline import Planned
from roslab.plan.plan import Plan
from roslab.repair import dockerfile, leaving, words
from roslab.repair.absent import unknown_to_apt
from roslab.repair.chain import proposed
from roslab.repair.change import Change, Given, Repair
from roslab.repository import fetching
from roslab.values.dataclass import dataclass, field, replace


def given(planned: Planned, added: Sequence[Change] = ()) -> Given:
    """Return what a repair is made from, besides the log; ``added``: the changes of repairs before it."""
    return Given(
        plan=planned.plan,
        evidence=planned.evidence,
        config=planned.config,
        files=frozenset(file.path for file in planned.repository.files),
        read=planned.repository.read,
        added=frozenset(change.key for change in added),
    )


def _reasons(found: Repair, answer: Answer, *, again: bool) -> list[str]:
    """Return why a failure is not repaired."""
    kept = [*filter(None, [found.kept])]
    if again:
        return ["the same cause is back, so what was added does not repair it", *kept]
    said = {one.fix for one in answer.explanations}  # the build's own error says it
    maybe = [f"it may need {change.told}" for change in found.changes]
    return [*(maybe or (why for failure, why in found.refused if failure and why not in said)), *kept]


def configuration(planned: Planned, options: argparse.Namespace) -> tuple[str, str | None]:
    """Return the name of the roslab.yaml that is repaired, and its text, ``None`` if there is none yet."""
    file = locate.find(planned.repository, named(options))
    return (file, locate.text(planned.repository, file)) if file else (locate.NAMES[0], None)


def _explained(error: FailedBuild) -> Answer:
    return explain(io.BytesIO(error.log.encode("utf-8", errors="replace")))


def _causes(answer: Answer) -> set[tuple[str, tuple[tuple[str, str], ...]]]:
    return {(one.id, one.names) for one in answer.explanations if one.id}


def image(planned: Planned) -> Plan:
    """Return what a plan says of the image, without the reasons."""
    return replace(planned.plan, reasons=(), warnings=())


@dataclass(kw_only=True, slots=True)
class Repairing:
    """The rounds of one repaired build; roslab.yaml is changed in memory alone until ``finish``."""

    options: argparse.Namespace
    planned: Planned
    arguments: tuple[tuple[str, str], ...] = ()
    """Arguments of the build."""
    rounds: int = 0
    changes: list[Change] = field(default_factory=list)
    seen: set[tuple[str, tuple[tuple[str, str], ...]]] = field(default_factory=set)
    kept: tuple[Change, ...] | None = None
    """The changes of the image that has its name, ``None`` before there is one."""
    before: FailedBuild | None = None
    """The failure that the last round was to repair."""

    def repair(self, error: FailedBuild, *, start: bool = False) -> None:
        """Plan the next round from what the failed one says; ``start``: the image is good, its command does not start.

        Raises ``FailedBuild`` if the rounds are used up, the same cause is back, or nothing certain can be added; where
        apt does not have what was added, that of the round before, which says what is wrong.
        """
        if self.before and (absent := self._absent(error)):
            self._stop(self.before, f"it needs {', '.join(absent)}, which apt does not have here")
        answer, before = _explained(error), given(self.planned, self.changes)
        causes = _causes(answer)
        if self.rounds >= self.options.repair:
            self._stop(error, f"{self.rounds} rounds are used up: --repair=N takes more")
        again = bool(causes & self.seen)
        found = proposed(
            answer,
            before,
            asking=asking(self.planned, self.options, self.arguments),
            start=start,
            again=again,
            whole=self.kept is not None,  # what an image has that is named already is not given up for its command
        )
        if author := self.planned.plan.author_dockerfile:
            own = self._own(answer, author.dockerfile)
            why = f"the image is built from {author.dockerfile}{own or ', and no line is certain to repair it'}"
            self._generate(found.left or self._stop(error, why), error, own)
            return
        changes = found.certain.changes or found.left
        if not changes:
            self._stop(error, "; ".join(_reasons(found, answer, again=again)))
        self.seen |= causes
        self.before = error
        self.rounds += 1
        self.changes = leaving.without_useless(self.changes, answer, before) if again else self.changes
        self.planned = self._with(changes, error)
        self.changes += changes
        for line in leaving.told(changes):
            say(f"roslab: repair {self.rounds} {line}")

    def _generate(self, changes: tuple[Change, ...], error: FailedBuild, own: str) -> None:
        """Plan the next round with a generated Dockerfile; ``own`` tells what would repair the author's."""
        self.planned = self._with(changes, error)
        # What it is for is not seen yet: the cause may come back, and is repaired then
        self.rounds += 1
        self.changes += changes
        for line in leaving.told(changes):
            say(f"roslab: repair {self.rounds} {line}{own}".rstrip("\n"))

    def start(self, dead: FailedBuild) -> bool:
        """Plan a round with which the command of the named image starts; say why there is none, and return ``False``.

        ``dead`` is how the command died.
        """
        self.kept = tuple(self.changes)
        answer = _explained(dead)
        if not any(one.id for one in answer.explanations):
            return False
        why = words_of_log.problems(answer, lines=False)
        plan = self.planned.plan
        if not (plan.author_dockerfile or plan.lock):
            try:
                self.repair(dead, start=True)
            except FailedBuild as refused:
                why += refused.problems[1:]
            except RoslabError as refused:  # as of the network: the image is good enough all the same
                why += refused.problems
            else:
                return True
        for problem in why:
            say(f"roslab: {problem}")
        return False

    def is_back(self, dead: FailedBuild) -> bool:
        """Tell whether a command dies for a cause that was repaired."""
        return bool(_causes(_explained(dead)) & self.seen)

    def back(self, error: RoslabError, name: str) -> None:
        """Take back the rounds after the last image that was named: one of them failed, or made none that is better."""
        kept = self.kept or ()
        tried = ", ".join(str(change) for change in self.changes[len(kept) :])
        self.changes = list(kept)
        say(f"roslab: {name} stays as it was before {tried}: {error.problems[0].message}")

    def _with(self, changes: Sequence[Change], error: FailedBuild) -> Planned:
        """Return the plan with more changes. Raises ``FailedBuild`` if roslab.yaml, of an old format, takes none."""
        if any(change.key == "submodules" for change in changes):
            self._fetch(error)
        file, old = configuration(self.planned, self.options)
        entries = [*self._entries(), *(change.entry for change in changes)]
        try:
            planned = planned_of(self.options, config_text=added(old, entries, file=file))
        except ConfigurationError as refused:
            needed = "; ".join(f"{change}, for {change.asked}" for change in changes)
            self._stop(error, f"it needs {needed}, which cannot be added: {refused.problems[0]}")
        if image(planned) == image(self.planned) and not any(change.key == "submodules" for change in changes):
            self._stop(error, f"the image has {', '.join(map(str, changes))} already, and that did not help")
        return planned

    def _absent(self, error: FailedBuild) -> list[str]:
        """Return what was added and apt does not have, by the log of a build with it."""
        unknown = unknown_to_apt(error.log)
        return [change.value for change in self.changes if change.key == "apt" and change.value in unknown]

    def _entries(self) -> list[Entry]:
        return [change.entry for change in self.changes]

    def _own(self, answer: Answer, file: str) -> str:
        """Return the repair of the author's own Dockerfile, which is shown and never written, if one is certain."""
        text = self.planned.repository.read(file)
        changes = dockerfile.edits(answer, text)
        return f"; this repairs it:\n{dockerfile.diff(file, text, changes)}" if changes else ""

    def _fetch(self, error: FailedBuild) -> None:
        with fetching.git(fetching.Access()) as git:
            missing = fetching.submodules(git, self.planned.repository.root)
        if missing:
            first = missing[0]
            self._stop(error, f"the submodule {first.path} of {first.url} cannot be fetched: {first.reason}")
        say("roslab: fetched the submodules")

    def _stop(self, error: FailedBuild, why: str) -> NoReturn:
        """Raise the build's own error with the reason why it is not repaired further, if the log names a cause."""
        if self.changes and self.kept is None:
            self._tell("tried, and not enough; nothing is written")
        reason = (Problem(message=f"not repaired: {why}"),) if why else ()
        raise FailedBuild(*error.problems, *reason, log=error.log) from None

    def finish(self) -> None:
        """Say what was added, and write it where that was asked for."""
        if not self.changes:
            return
        file, old = configuration(self.planned, self.options)
        if self.options.write:
            self._tell(f"these lines are written to {file}")
            write_configuration(self.planned.repository.root / file, old, added(old, self._entries(), file=file))
        else:
            self._tell(f"{file} needs these lines; --write writes them")

    def _tell(self, head: str) -> None:
        file, old = configuration(self.planned, self.options)
        changed = words.diff(old, replace(Repair(), changes=tuple(self.changes)), file)
        say(f"roslab: {head}:\n{changed}".rstrip("\n"))
