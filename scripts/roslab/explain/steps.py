"""The steps in the log of a build by BuildKit or the classic builder, and which of them failed."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator

from roslab.explain import progress
from roslab.explain.reading import Line
from roslab.explain.skim import is_marked
from roslab.values.dataclass import dataclass, field
from roslab.values.pattern import pattern

MOST = 16_000
"""Lines of one step that are kept until unimportant lines in its middle are dropped."""
_new = tuple.__new__
"""Makes a ``Line`` in a third of the time, for logs of a million lines."""
_HEAD, _TAIL, _SAID = 400, 4000, 4000
_OWN = "roslab: "
"""What the scripts of a generated image say of themselves."""

_SMALL = pattern(r"^(?i:run|copy|add|from|env|arg|user|workdir|label|cmd|entrypoint|shell|volume|expose)\b(?= )")
"""The first word of an instruction, which a Dockerfile may write in small letters."""


_NUMBER = pattern(r"^(?:(?:\[\d{1,4}/\d{1,4}\] )?(?:Step|STEP) \d+(?:/\d+)? ?:|INFO\[\d{4,6}\]|\[[^\]]{0,200}\]) ?")
"""What a builder writes before an instruction."""


@dataclass(kw_only=True, slots=True, eq=False)
class Step:
    """One instruction of a Dockerfile that a build ran, or the whole of a log without steps."""

    name: str = ""
    """The builder's name for it: ``[stage 2/5] RUN make``, ``Step 3/9 : RUN make``."""
    lines: list[Line] = field(default_factory=list)
    error: str = ""
    """The builder's own message about its failure."""
    done: bool = False
    place: tuple[str, int] | None = None
    """The Dockerfile and its line, if the builder names them."""

    @property
    def command(self) -> str:
        """The instruction alone, its first word in capitals: ``RUN make``."""
        text = _NUMBER.sub("", self.name).strip()
        return _SMALL.sub(lambda word: word[0].upper(), text)

    @property
    def platform(self) -> str:
        """``linux/arm64`` if the build was for several platforms, else ``""``."""
        found = re.match(r"\[(?:\S{1,100} )?((?:linux|windows|darwin)/[\w/]{1,30})[ \]>-]", self.name)
        return found[1] if found else ""

    def add(self, line: Line) -> None:
        """Keep a line; of a very long step keep the beginning, the end, and lines that could say why it failed."""
        self.lines.append(line)
        if len(self.lines) > MOST:
            self.drop()

    def close(self) -> None:
        """Reduce a successful step to the few lines that may explain a later failure."""
        self.done = True
        if len(self.lines) > 3 * _HEAD:
            self.drop(_HEAD)

    def drop(self, tail: int = _TAIL) -> None:
        """Drop unimportant lines between the beginning and the last lines."""
        middle = [line for line in self.lines[_HEAD:-tail] if line.text.startswith(_OWN) or is_marked(line.text)]
        self.lines = [*self.lines[:_HEAD], *middle[:_SAID], *self.lines[-tail:]]


@dataclass(kw_only=True, slots=True)
class Log:
    """The steps in a log."""

    steps: list[Step]
    failed: list[Step]
    """The steps that failed, in their order; empty if everything succeeded, or if the log names no failed step."""
    rest: Step
    """Lines outside any step, before, between or after them; in a log without steps all lines."""
    lines: int = 0
    succeeded: bool = False

    def before(self, step: Step) -> Iterator[Step]:
        """Yield the steps before a step, the nearest first."""
        if step in self.steps:
            yield from reversed(self.steps[: self.steps.index(step)])


_VERTEX = pattern(r"#(\d{1,6}) (\d{1,7}\.\d{1,3} ?)?")
_NAMED = pattern(r"(?:\[|importing cache|exporting |resolve image|sha256:|pushing|merging|copy |local:)")
_CLASSIC = pattern(
    r"(?:\[\d{1,4}/\d{1,4}\] )?(?:Step|STEP) \d{1,4}(?:/\d{1,4})? ?: ?"
    r"|INFO\[\d{4,6}\] (?=(?:FROM|RUN|COPY|ADD|ENV|ARG|USER|WORKDIR|LABEL) )"
)
"""The beginning of a step: of the classic builder, of buildah, which numbers the stages too, and of kaniko."""
_REPEATED = pattern(r" > (.{1,2000}?):?$")
_COPIED = pattern(r"^\s{0,8}\d{1,7}\.\d{1,3}(?: |$)")
_SECONDS = pattern(r"^\d{1,7}\.\d{1,3}(?: |$)")
_PLACE = pattern(r"([^\s:]{1,200}):(\d{1,6})$")
_FINAL = pattern(
    r"(?:ERROR: |error: |target \S{1,100}: |buildx failed with: |#\d+ ERROR: |Error: ){0,3}failed to (?:solve|build)\b"
    r"|The command '.{1,5000} returned a non-zero code: \d"
    r"|[Ee]rror(?: building at STEP|: error building at STEP)"
    r"|executor failed running "
    r"|error building image: "
)
_COMMAND = pattern(
    r"(?:process \"|executor failed running \[)/bin/(?:ba|da|z)?sh (?:-[a-z]{1,6} (?:pipefail )?){0,3}-c "
    r"(.{1,5000}?)(?:\" did not complete|\]: exit code)",
    re.DOTALL,
)
_GOOD = pattern(r"Successfully (?:built [0-9a-f]{12}|tagged \S{1,200})$")


def read(lines: Iterable[Line]) -> Log:
    """Sort a log's lines into its steps and find out which failed."""
    return _Reader().read(lines)


class _Reader:
    """Keeps track of the step that the next line belongs to."""

    def __init__(self) -> None:
        self.rest = Step()
        self.vertices: dict[str, Step] = {}
        self.classic: list[Step] = []
        self.repeated: list[Step] = []
        """The parts of failed steps that BuildKit prints again at the end."""
        self.errors: list[tuple[Line, Step | None]] = []
        self.open: Step | None = None
        self.quoting = False
        self.good = False
        self.last = 0
        self.last_step: Step | None = None
        """The step of the last line of BuildKit's progress; ``last`` is the number of that line."""
        self.numbers: dict[str, int] = {}

    def read(self, lines: Iterable[Line]) -> Log:
        number = 0
        for line in lines:
            number, text = line
            if text[:1] == "#" and (found := _VERTEX.match(text)):
                self._vertex(number, text, found)
            elif text[:1] == "{" and (told := progress.plain(text, self.numbers)) is not None:
                for one in told:
                    if found := _VERTEX.match(one):
                        self._vertex(number, one, found)
            else:
                self._other(line)
        return self._log(number)

    def _other(self, line: Line) -> None:
        """Process a line without a step's number."""
        number, text = line
        first = text[:1]
        if self.last_step is not None and self.last == number:
            self.last_step.add(line)  # the same line after a carriage return
        elif first and first in "S-> [I" and self._frame(line):
            pass
        elif first not in " \t" and _FINAL.match(text):
            self.errors.append((line, self.open))
        else:
            self.good = self.good or (first == "S" and bool(_GOOD.match(text)))
            self._loose(line)

    def _loose(self, line: Line) -> None:
        """Add a line without a step's number to the open step; in a repeated line the seconds are still present."""
        if self.open is not None and self.open in self.repeated:
            line = Line(line.number, _SECONDS.sub("", line.text))
        (self.open or self.rest).add(line)

    def _vertex(self, number: int, line: str, found: re.Match[str]) -> None:
        """Process one line of BuildKit's plain progress: ``#12 3.45 text``, or a step's new state."""
        key, timed = found.groups()
        text = line[found.end() :]
        step = self.vertices.get(key)
        again = self.open if self.open is not None and self.open in self.repeated else None
        if step is None:  # an old BuildKit writes the numbers in its repetition too, often there alone
            step = self.vertices[key] = again or Step()
        self.open, self.last, self.last_step = again, number, step
        if timed:
            step.lines.append(_new(Line, (number, text)))
            if len(step.lines) > MOST:
                step.drop()
        elif text.startswith("ERROR: "):
            step.error = text[7:]
        elif text.startswith(("DONE ", "CACHED")):
            step.close()
        elif text in {"...", "CANCELED"} or text == step.name:
            pass
        elif not step.name and (_NAMED.match(text) or not step.lines):
            step.name = text
        else:
            step.add(Line(number, text))

    def _frame(self, line: Line) -> bool:
        """Process a line that structures the log: a classic step, BuildKit's repetition or its Dockerfile excerpt."""
        text = line.text
        if _CLASSIC.match(text):
            if self.open is not None and self.open in self.classic:
                self.open.close()
            self.open = Step(name=text)
            self.classic.append(self.open)
        elif self.open is not None and self.open in self.classic:
            return False
        elif text == "------":
            self.open = None
        elif text == "-" * 20:
            self.open, self.quoting = None, not self.quoting
        elif text.startswith(" > ") and not self.quoting and (found := _REPEATED.match(text)):
            self.open = Step(name=found[1])
            self.repeated.append(self.open)
        else:
            return self.quoting
        return True

    def _log(self, number: int) -> Log:
        """Return the log with its failed steps, which are found by the most reliable sign available."""
        _without_seconds(self.rest)
        steps = [*self.vertices.values(), *self.classic]
        failed = [step for step in self.vertices.values() if step.error and not _is_optional(step)]
        self._join_repetitions(failed, steps)
        if self.classic and not failed and not self.good:
            failed = [self.classic[-1]]
        if not failed and not self.errors:  # the end of the log is missing: take the step that was still running
            failed = [step for step in self.vertices.values() if step.lines and not step.done][-1:]
        if not failed and self.errors:
            failed = self._unfinished()
        for line, at in self.errors:
            owner = at if at in failed else (failed[-1] if failed else None)
            if owner is not None and not owner.error:
                owner.error = line.text
        place = self._place()
        if not failed and self.errors:
            self.rest.error = self.errors[-1][0].text
            self.rest.lines += [line for line, _ in self.errors]
            self.rest.name = _named(self.rest.error)
            self.rest.place = place
        if place and len(failed) == 1:
            failed[0].place = place
        return Log(steps=steps, failed=failed, rest=self.rest, lines=number, succeeded=self.good)

    def _join_repetitions(self, failed: list[Step], steps: list[Step]) -> None:
        """Add what BuildKit repeats to the steps it belongs to, or as failed steps where the log has no others."""
        for again in self.repeated:
            # If the beginning of the log is missing, a step has a number, no name, and only some of its lines
            step = next((s for s in failed if s.name in {again.name, ""}), None)
            if step is None:
                failed.append(again)
                steps += [] if again in steps else [again]
            elif step is not again:
                step.name = again.name
                own = {line.text for line in step.lines}
                step.lines[:0] = [line for line in again.lines if line.text not in own]

    def _unfinished(self) -> list[Step]:
        """Return the step that was still running at the builder's last words, of a log whose lines about it are cut."""
        named = Step(name=_named(self.errors[-1][0].text)).command
        running = [step for step in self.vertices.values() if step.lines and not step.done]
        fitting = [
            step for step in running if not step.name or " ".join(step.command.split()) == " ".join(named.split())
        ]
        for step in fitting[-1:]:
            step.name = step.name or f"[failed] {named}".strip()
        return fitting[-1:]

    def _place(self) -> tuple[str, int] | None:
        """Return the Dockerfile and the line that BuildKit names after the repetition."""
        found = [match for line in self.rest.lines[-200:] if (match := _PLACE.match(line.text))]
        return (found[-1][1], int(found[-1][2])) if found else None


def _named(error: str) -> str:
    """Return the name of the step that the builder's last words repeat, of a log that lacks all before them."""
    found = _COMMAND.search(error)
    return f"[failed] RUN {found[1]}".replace('\\"', '"') if found else ""


def _without_seconds(step: Step) -> None:
    """Take the seconds off the lines of a part of BuildKit's repetition that was copied without its first line."""
    timed = sum(1 for line in step.lines if _COPIED.match(line.text))
    if 2 * timed > len(step.lines):
        step.lines = [Line(line.number, _COPIED.sub("", line.text)) for line in step.lines]


def _is_optional(step: Step) -> bool:
    """Return whether a step may fail without failing the build, such as reading a cache that does not exist yet."""
    return step.name.startswith(("importing cache", "exporting cache"))
