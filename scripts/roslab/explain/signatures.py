"""Finds the known failure in a step by matching the tables of ``knowledge.failures`` on its lines."""

from __future__ import annotations

import re
from bisect import bisect_right
from collections.abc import Iterator, Mapping
from itertools import groupby, islice
from string import Formatter

from roslab.explain import matter
from roslab.explain.names import LOOKUPS, Image, Names
from roslab.explain.reading import Line
from roslab.explain.steps import Log, Step
from roslab.knowledge.failures import Failure, compiled, failures
from roslab.values.dataclass import dataclass, field, replace
from roslab.values.pattern import pattern

_ERRORS = pattern(r"CMake Error|(?i:\berror\b)|\*\*\*|Configuring incomplete")
_GUESSED = 8
"""From this rank on, a failure only tells how a step ended, which outweighs nothing that is known."""
_ENDED = 9
"""This rank does not even outweigh what builds often survive."""
_WENT_ON = pattern(r"^(?:Complete!$|Successfully (?:installed|built) |OK: \d{1,6} MiB in )", re.MULTILINE)
"""What programs print when they did what they were asked: a failure before it did not stop them."""
_NEAR = 600
"""Number of characters before a match that are searched for the name that belongs to it."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Match:
    """One known failure in a step."""

    failure: Failure
    line: Line
    said: str
    """The matched lines, joined into one."""
    cause: str
    fix: str
    names: Names = field(default_factory=dict)
    known: bool = False
    """Whether the lookup found what the captured name belongs to."""


@dataclass(kw_only=True, slots=True)
class _Text:
    """A step's lines as one text to match on; it can return the line at a position."""

    lines: list[Line]
    text: str = ""
    starts: list[int] = field(default_factory=list)

    @classmethod
    def of(cls, lines: list[Line]) -> _Text:
        found = cls(lines=lines, text="\n".join(line.text for line in lines))
        at = 0
        for line in lines:
            found.starts.append(at)
            at += len(line.text) + 1
        return found

    def line(self, position: int) -> Line:
        return self.lines[bisect_right(self.starts, position) - 1] if self.lines else Line(0, "")

    def whole(self, start: int, end: int) -> str:
        """Return all lines that a match is part of, joined into one."""
        last = self.text.find("\n", max(start, end - 1))
        lines = self.text[self.text.rfind("\n", 0, start) + 1 : last if last >= 0 else None].split("\n")
        return " ".join(part for line in lines if (part := line.strip()))


@dataclass(frozen=True, kw_only=True, slots=True)
class _Case:
    """A failed step in the form in which failures are matched on it."""

    log: Log
    step: Step
    image: Image
    text: _Text
    raw: str
    """Its last lines, unchanged."""


def match(log: Log, step: Step, image: Image) -> Match | None:
    """Return the known failure that explains a step: the one with the best rank, and among these the earliest.

    A failure that builds often survive, or after which this one went on, gives way to any other that is known after its
    line; of several such failures the last is taken.
    """
    lines = matter.lines(step)
    raw = "\n".join(line.text for line in step.lines[-4000:])
    case = _Case(log=log, step=step, image=image, text=_Text.of(lines), raw=raw)
    found = _best(case)
    whole = matter.unwrapped(lines) if "CMake Error" in case.text.text else lines
    again = _best(replace(case, text=_Text.of(whole))) if len(whole) < len(lines) else None
    if again is not None and (found is None or again.failure.rank < found.failure.rank):
        return again
    return found


def _best(case: _Case) -> Match | None:
    """Return the known failure of the best rank that a step's lines tell of."""
    survived: tuple[int, Match] | None = None
    for number, rank in groupby(failures(), key=lambda failure: failure.rank):
        if survived is not None and number >= (_ENDED if _harmless(survived, case) else _GUESSED):
            break
        found = [one for failure in rank if (one := _one(failure, case)) is not None]
        stopped = [one for one in found if not _passed(one, case)]
        if survived is not None:
            later = case.text.text.find("\n", survived[0])
            found = [one for one in found if 0 <= later < one[0]]
            stopped = [one for one in stopped if 0 <= later < one[0]]
        if stopped:
            return min(stopped, key=_position)[1]
        if found:
            survived = max(found, key=_position)
    return survived[1] if survived else None


def _position(one: tuple[int, Match]) -> int:
    return one[0]


def _passed(one: tuple[int, Match], case: _Case) -> bool:
    """Return whether the build went on after a failure, as far as its kind or the lines after it tell."""
    return _harmless(one, case) or bool(_WENT_ON.search(case.text.text, one[0]))


def _harmless(one: tuple[int, Match], case: _Case) -> bool:
    """Return whether builds go on after a failure by its kind, or because CMake only warned of it."""
    return one[1].failure.passing or _is_warning(case.text.text, one[0])


def _is_warning(text: str, position: int) -> bool:
    """Return whether a position lies in a warning of CMake: a line that says so, and indented or blank lines."""
    end = text.find("\n", position)
    said = text[max(0, position - _NEAR) : end if end >= 0 else None].split("\n")
    head = next((line for line in reversed(said) if line[:1].strip()), "")
    return head.startswith(("CMake Warning", "CMake Deprecation Warning"))


def _one(failure: Failure, case: _Case) -> tuple[int, Match] | None:
    """Return a failure's position and match; names that a required lookup does not know are skipped."""
    if failure.command and not re.search(failure.command, case.step.command):
        return None
    text = case.text.text
    matches = _counted(list(islice(compiled(failure.pattern).finditer(text), 200)), text)
    whole = f"{text}\n{case.step.command}"
    if not matches or not _fits(failure, text, whole, case.raw):
        return None
    earlier = _before(failure, case) if failure.before else {}
    if earlier is None or (failure.not_before and not _never_before(failure, case)):
        return None
    also = compiled(failure.also).search(whole) if failure.also else None
    extra = None if failure.extra_before else _extra(failure, case, 0)  # the same for each match
    inside = list(enumerate(matches))
    for at, found in reversed(inside) if failure.passing else inside:  # a build goes on after all but the last of those
        if (failure.copied and not _copied(found["path"], case)) or _only_tried(found.groupdict(), case):
            continue
        names = {
            **(_groups([also]) if also else {}),
            **(_extra(failure, case, found.start()) if extra is None else extra),
            **_groups(matches[at:] if failure.every else [found]),
            **earlier,
        }
        looked = LOOKUPS[failure.lookup](names, case.image) if failure.lookup else {}
        if looked or not failure.required:
            return found.start(), _match(failure, case, found, {**names, **looked})
    return None


def _counted(matches: list[re.Match[str]], text: str) -> list[re.Match[str]]:
    """Return the matches that are no warnings of CMake, after which it goes on; all where there are no others."""
    return [each for each in matches if not _is_warning(text, each.start())] or matches if "CMake " in text else matches


def _match(failure: Failure, case: _Case, found: re.Match[str], names: Names) -> Match:
    known = bool(names.get("package"))
    return Match(
        failure=failure,
        line=case.text.line(found.start()),
        said=case.text.whole(found.start(), found.end()),
        cause=filled(failure.cause, names),
        fix=filled(failure.fix if known or not failure.otherwise else failure.otherwise, names),
        names={key: value for key, value in names.items() if value},
        known=known,
    )


def _fits(failure: Failure, text: str, whole: str, raw: str) -> bool:
    if failure.also and not compiled(failure.also).search(whole):
        return False
    if failure.unless and (compiled(failure.unless).search(text) or compiled(failure.unless).search(raw[-200_000:])):
        return False
    return not failure.errors or bool(_ERRORS.search(text))


def _groups(matches: list[re.Match[str]]) -> Names:
    """Return the named groups of matches; ``name2`` is an alternative for ``name``, several values become a list."""
    values: dict[str, dict[str, None]] = {}
    for found in matches:
        for key, value in found.groupdict().items():
            if value and value.strip():
                values.setdefault(key.rstrip("0123456789"), {}).setdefault(_flat(value))
    return {key: ", ".join(list(several)[:6]) for key, several in values.items()}


def _flat(value: str) -> str:
    """Return a captured name on one line: a list of packages over several lines is joined with commas."""
    parts = [re.sub(r"^\s*- ", "", part).strip() for part in value.split("\n")]
    return ", ".join(part for part in parts if part)[:200]


def _extra(failure: Failure, case: _Case, position: int) -> Names:
    """Return further names from the instruction, from the nearest line before the match, or from any line."""
    if not failure.extra:
        return {}
    pattern = compiled(failure.extra)
    instruction = list(pattern.finditer(case.step.command))
    if failure.where == "command":
        return _groups(instruction)
    if failure.extra_before:
        text = case.text.text
        end = text.find("\n", position)
        near = list(pattern.finditer(text[max(0, position - _NEAR) : end if end >= 0 else None]))
        return _groups(near[-1:] or _traced(pattern, case, position) or instruction[:1])
    merged: Names = {}
    for one in list(pattern.finditer(case.raw)) or instruction:
        merged = {**_groups([one]), **merged}
    return merged


def _traced(pattern: re.Pattern[str], case: _Case, position: int) -> list[re.Match[str]]:
    """Return what the last command that `set -x` printed before a position names."""
    number = case.text.line(position).number
    traced = (line.text for line in reversed(case.step.lines) if line.number <= number and line.text.startswith("+"))
    return next((found[-1:] for text in islice(traced, 8) if (found := list(pattern.finditer(text)))), [])


def _before(failure: Failure, case: _Case) -> Names | None:
    """Return the names found in an earlier step or its output, or in this instruction; ``None`` if nothing matches."""
    pattern = compiled(failure.before)
    if found := pattern.search(case.step.command):
        return {**_groups([found]), "before_step": _shortened(case.step.command)}
    for earlier in case.log.before(case.step):
        text = "\n".join((earlier.command, *(line.text for line in matter.lines(earlier))))
        if earlier.command.startswith("RUN") and (found := pattern.search(text)):
            return {**_groups([found]), "before_step": _shortened(earlier.command)}
    return None


def _never_before(failure: Failure, case: _Case) -> bool:
    """Return whether neither an earlier instruction nor this one matches; a log cut at its beginning tells nothing."""
    earlier = [step.command for step in case.log.before(case.step)]
    pattern = compiled(failure.not_before)
    whole = any(command.startswith("FROM ") for command in earlier)
    return whole and not any(pattern.search(command) for command in (case.step.command, *earlier))


def _copied(path: str, case: _Case) -> bool:
    """Return whether an earlier COPY or ADD names this file."""
    name = re.compile(rf"(?<![\w.-]){re.escape(path.rpartition('/')[2])}(?![\w.-])")
    earlier = (step.command for step in case.log.before(case.step))
    return any(command.startswith(("COPY", "ADD")) and name.search(command) for command in earlier)


def _only_tried(names: Mapping[str, str | None], case: _Case) -> bool:
    """Return whether the instruction only looks whether a missing program is there, and goes on without it."""
    program = re.escape(names.get("program") or "")
    looks = rf"(?:\$\( ?|`|\bif (?:! ?)?|(?<![\w-])(?:which|hash|type|command -v) ){program}(?![\w.-])"
    return bool(program) and re.search(looks, case.step.command) is not None


def _shortened(command: str) -> str:
    flat = " ".join(command.split())
    return flat if len(flat) <= 100 else f"{flat[:99]}…"


def filled(sentence: str, names: Names) -> str:
    """Put names into a sentence, and remove what a missing name leaves: empty brackets and double spaces."""
    parts: list[str] = []
    for literal, name, _, _ in Formatter().parse(sentence):
        parts.append(literal)
        if name is not None:
            parts.append(names.get(name, ""))
    text = "".join(parts)
    text = re.sub(r" \((?:Python|[,;:…\s])*\)", "", text)
    text = re.sub(r"[,:]\s*(?=\)|\.$)", "", text)
    text = re.sub(r"\(\s*,\s*", "(", text)
    text = re.sub(r"\s{2,}", " ", text)
    return re.sub(r"\s+([,;:)](?=\s|$)|\.(?=\s|$))", r"\1", text).strip()


def fields(sentence: str) -> Iterator[str]:
    """Yield the names that a sentence uses."""
    for _, name, _, _ in Formatter().parse(sentence):
        if name:
            yield name
