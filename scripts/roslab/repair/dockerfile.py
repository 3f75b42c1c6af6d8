"""The repair of an author's own Dockerfile, as text: nothing is ever written to it."""

from __future__ import annotations

import difflib
import re

from roslab.evidence.lex.dockerfile import Instruction, instructions
from roslab.explain.answer import Answer, Explanation
from roslab.explain.signatures import filled
from roslab.explain.words import dockerfile_lines
from roslab.knowledge.repairs import repairs
from roslab.values.dataclass import dataclass


@dataclass(frozen=True, kw_only=True, slots=True)
class Edit:
    """One instruction of a Dockerfile, from ``line`` to ``end``, and the lines that repair it."""

    line: int
    end: int
    new: tuple[str, ...]


def edits(answer: Answer, text: str) -> tuple[Edit, ...]:
    """Return what repairs the failed steps of a log, for the text of the Dockerfile that was built.

    A step that failed on several platforms is repaired once; causes that are only likely are left out.
    """
    found: dict[int, Edit] = {}
    for explanation in answer.explanations:
        instruction = _failed(explanation, text)
        if instruction is None or explanation.certainty != "certain":
            continue
        edit = _edit(explanation, instruction, text)
        if edit is not None:
            found.setdefault(edit.line, edit)
    return tuple(found[line] for line in sorted(found))


def diff(file: str, text: str, changes: tuple[Edit, ...]) -> str:
    """Return the edits of a Dockerfile as a unified diff that ``patch -p1`` and ``git apply`` take."""
    old, new = text.splitlines(keepends=True), edited(text, changes).splitlines(keepends=True)
    lines = difflib.unified_diff(old, new, f"a/{file}", f"b/{file}")
    return "".join(line if line.endswith("\n") else f"{line}\n\\ No newline at end of file\n" for line in lines)


def edited(text: str, changes: tuple[Edit, ...]) -> str:
    """Return the text of a Dockerfile with its edits."""
    lines = text.splitlines(keepends=True)
    for change in reversed(changes):
        lines[change.line - 1 : change.end] = [f"{line}\n" for line in change.new]
    return "".join(lines)


def _failed(found: Explanation, text: str) -> Instruction | None:
    """Return the instruction that failed: by the line that the builder names, else by its words."""
    known = list(instructions(text))
    if found.line is not None:
        at_or_before = [one for one in known if one.line <= found.line]
        return at_or_before[-1] if at_or_before else None
    wanted = _flat(found.step)
    return next((one for one in known if wanted and _flat(f"{one.name} {one.text}").startswith(wanted[:200])), None)


def _flat(text: str) -> str:
    return " ".join(text.replace("\\\n", " ").split())


def _edit(found: Explanation, failed: Instruction, text: str) -> Edit | None:
    lines = text.splitlines()
    end = _end(failed, text)
    old = lines[failed.line - 1 : end]
    names = dict(found.names)
    known = repairs().get(found.id or "")
    before, new = dockerfile_lines(found), old
    if known is not None:
        before = before or [filled(line, names) for line in known.dockerfile if _complete(line, names)]
        if known.find and _complete(known.find, names) and _complete(known.replace, names):
            pattern = _pattern(known.find, names)
            new = pattern.sub(lambda _: filled(known.replace, names), "\n".join(old)).split("\n")
    if not before and new == old:
        return None
    return Edit(line=failed.line, end=end, new=(*_as_root(before, failed, text), *new))


def _pattern(find: str, names: dict[str, str]) -> re.Pattern[str]:
    for name, value in names.items():
        find = find.replace(f"{{{name}}}", re.escape(value))
    return re.compile(find)


def _complete(template: str, names: dict[str, str]) -> bool:
    """Return whether every name that a template uses was captured; regular expressions have braces of their own."""
    wanted = re.findall(r"\{([a-z_]+)\}", template)
    return all(names.get(name) for name in wanted)


def _end(failed: Instruction, text: str) -> int:
    """Return the last line of an instruction: what is above the next one, without comments and blank lines."""
    lines = text.splitlines()
    later = [one.line for one in instructions(text) if one.line > failed.line]
    end = later[0] - 1 if later else len(lines)
    while end > failed.line and (not lines[end - 1].strip() or lines[end - 1].lstrip().startswith("#")):
        end -= 1
    return end


def _as_root(before: list[str], failed: Instruction, text: str) -> list[str]:
    """Let root install packages, if a USER line above has given the step to another user."""
    user = "root"
    for one in instructions(text):
        if one.line >= failed.line:
            break
        user = "root" if one.name == "FROM" else one.text.strip() if one.name == "USER" else user
    commands = any(line.startswith(("RUN apt", "RUN sed", "RUN rm", "RUN for")) for line in before)
    return ["USER root", *before, f"USER {user}"] if commands and user not in ("root", "0") else before
