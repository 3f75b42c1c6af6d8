"""The repair of an author's own Dockerfile, as text: nothing is ever written to it."""

from __future__ import annotations

import difflib
import re
from collections.abc import Callable, Iterator

from roslab.evidence.lex.dockerfile import Instruction, instructions
from roslab.explain.answer import Answer, Explanation
from roslab.explain.signatures import filled
from roslab.explain.words import dockerfile_lines
from roslab.knowledge.repairs import complete, repairs
from roslab.repair import base_image
from roslab.repair.installing import for_base
from roslab.values.dataclass import dataclass, replace
from roslab.values.pattern import pattern

_FIRST_AND = pattern(r"^RUN\s*(?:\\\n\s*)?&&\s*(?:\\\n\s*)?")
"""What is left of `RUN a && b` without its first command."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Edit:
    """One instruction of a Dockerfile, from ``line`` to ``end``, and the lines that repair it."""

    line: int
    end: int
    new: tuple[str, ...]


def edits(answer: Answer, text: str, *, likely: bool = False) -> tuple[Edit, ...]:
    """Return what repairs the failed steps of a log, for the text of the Dockerfile that was built.

    A step that failed on several platforms is repaired once; causes that are only likely are left out without
    ``likely``.
    """
    found: dict[int, Edit] = {}
    for explanation in answer.explanations:
        instruction = _failed(explanation, text)
        if instruction is None or (explanation.certainty != "certain" and not likely):
            continue
        edit = _edit(explanation, instruction, text) or _other_base(explanation, instruction, text)
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


def suggested(answer: Answer) -> str:
    """Return the edits as far as a log alone shows the instructions, ``""`` if none: lines with ``-`` and ``+``.

    Their spaces are guessed, because a log has each instruction on one line.
    """
    out: list[str] = []
    for found in answer.explanations:
        image = dict(found.names).get("image", "")
        step = (
            " ".join(found.step.split(None, 1)) if found.step.startswith("RUN ") else f"FROM {image}" if image else ""
        )
        if not step:
            names = {**dict(found.names), "pip_program": _pip("")}
            out += [f"+{line}" for line in for_base(_before(found, "", names), found.base, "")]
            continue
        text = re.sub(r"[ \t]{3,}", " \\\n    ", step) + "\n"
        if step.startswith("RUN "):
            text = "".join(f"{above}\n" for above in (found.base, found.user) if above) + text
        changes = edits(replace(answer, explanations=(replace(found, line=None, step=step),)), text, likely=True)
        new = edited(text, changes)
        lines = difflib.unified_diff(text.splitlines(), new.splitlines(), n=1, lineterm="")
        out += [line for line in lines if not line.startswith(("---", "+++", "@@"))]
    return "".join(f"{line}\n" for line in dict.fromkeys(out))


def _failed(found: Explanation, text: str) -> Instruction | None:
    """Return the instruction that failed: by the line that the builder names, else by its words or its image."""
    known = list(instructions(text))
    if image := dict(found.names).get("image", ""):
        named = re.compile(rf"(?<![\w./-]){re.escape(image)}(?![\w./-])")
        return next((one for one in known if one.name == "FROM" and named.search(one.text)), None)
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
    names = {**dict(found.names), "pip_program": _pip(failed.text)}
    known = repairs().get(found.id or "")
    before, new = for_base(_before(found, failed.text, names), found.base, failed.text), old
    if known is not None:
        for each in _each(names) if known.find else ():
            if complete(known.find, each) and complete(known.replace, {**each, **names}):
                new = _pattern(known.find, each).sub(_literal(known.replace, each), "\n".join(new)).split("\n")
    new = _FIRST_AND.sub("RUN ", "\n".join(line for line in new if line.strip() != "\\" or line in old)).split("\n")
    new = [] if "".join(new).strip() == "RUN" else new
    if not before and new == old:
        return None
    user = _user(failed, text)
    before = _as_root(before, user)
    after = [f"USER {user}"] if before == ["USER root"] and user != "root" else []
    return Edit(line=failed.line, end=end, new=(*before, *new, *after))


def _other_base(found: Explanation, failed: Instruction, text: str) -> Edit | None:
    """Return the edit that takes another tag in the FROM that failed, or that the failed instruction builds on."""
    above = [one for one in instructions(text) if one.name == "FROM" and one.line <= failed.line]
    if not above:
        return None
    end = _end(above[-1], text)
    old = text.splitlines()[above[-1].line - 1 : end]
    image = next((word for word in above[-1].text.split() if not word.startswith("--")), "")
    other = base_image.fitting(found, image)
    if not other:
        return None
    return Edit(line=above[-1].line, end=end, new=tuple(line.replace(image, other, 1) for line in old))


def _before(found: Explanation, command: str, names: dict[str, str]) -> list[str]:
    """Return the instructions to insert before the failed one, whose text is ``command``."""
    known = repairs().get(found.id or "")
    if known is not None and known.dockerfile:
        fits = not known.only or re.search(known.only, command)
        return [filled(line, names) for line in known.dockerfile if fits and complete(line, names)]
    return dockerfile_lines(found)


def _pip(command: str) -> str:
    """Return pip as an instruction calls it, or the pip of the Python that it starts."""
    if found := re.search(r"(?:\bpython[\d.]* -m )?\bpip[\d.]*(?= install)", command):
        return found[0]
    python = re.search(r"\bpython[\d.]*(?= )", command)
    return f"{python[0]} -m pip" if python else "pip"


def _each(names: dict[str, str]) -> Iterator[dict[str, str]]:
    """Yield the names for each of several packages; a list of fewer values gives nothing for the last packages.

    ``packages`` holds names with their versions.
    """
    pinned = [re.split(r"(?=[=<>])", one, maxsplit=1) for one in names.get("packages", "").split(", ") if "=" in one]
    packages = names["name"].split(", ") if "name" in names else [one[0] for one in pinned] or [""]
    if len(packages) == 1 and "name" in names:
        yield names
        return
    lists = {key: names[key].split(", ") for key in ("package", "version") if key in names}
    lists |= {"version": [one[1] for one in pinned]} if "name" not in names and pinned else {}
    for at, package in enumerate(packages):
        yield {**names, "name": package, **{key: (each[at : at + 1] or [""])[0] for key, each in lists.items()}}


def _literal(template: str, names: dict[str, str]) -> Callable[[re.Match[str]], str]:
    r"""Return what replaces a match: the template with its names, and with ``\1`` for a group of the match."""
    new = re.sub(r"\{([a-z_]+)\}", lambda name: names.get(name[1], ""), template)
    return lambda found: re.sub(r"\\(\d)", lambda group: found[int(group[1])] or "", new)


def _pattern(find: str, names: dict[str, str]) -> re.Pattern[str]:
    for name, value in names.items():
        find = find.replace(f"{{{name}}}", re.escape(value))
    return re.compile(find)


def _end(failed: Instruction, text: str) -> int:
    """Return the last line of an instruction: what is above the next one, without comments and blank lines."""
    lines = text.splitlines()
    later = [one.line for one in instructions(text) if one.line > failed.line]
    end = later[0] - 1 if later else len(lines)
    while end > failed.line and (not lines[end - 1].strip() or lines[end - 1].lstrip().startswith("#")):
        end -= 1
    return end


def _user(failed: Instruction, text: str) -> str:
    """Return the user that a USER line above gives an instruction to; an image's own user is not known."""
    user = "root"
    for one in instructions(text):
        if one.line >= failed.line:
            break
        user = "root" if one.name == "FROM" else one.text.strip() if one.name == "USER" else user
    return user


def _as_root(before: list[str], user: str) -> list[str]:
    """Let root install packages, if a USER line above has given the step to another user."""
    commands = any(line.startswith(("RUN (", "RUN apk", "RUN apt", "RUN sed", "RUN rm", "RUN for")) for line in before)
    return ["USER root", *before, f"USER {user}"] if commands and user not in ("root", "0") else before
