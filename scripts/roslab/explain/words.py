"""An answer as text for a person, and as JSON for a program."""

from __future__ import annotations

import json
import shlex
from typing import Any

from roslab.errors import Problem
from roslab.explain.answer import Answer, Explanation
from roslab.knowledge.repairs import LISTS
from roslab.values.dataclass import asdict
from roslab.values.pattern import pattern

_CONTROL = pattern(r"[\x00-\x08\x0b-\x1f\x7f-\x9f]")
"""What a terminal would obey: a log may hold anything, and a reader of it wants its own terminal back."""


def text(answer: Answer, *, lines: bool = True) -> str:
    """Return an answer as text: for each failed step its place, line, cause and fix.

    ``lines`` adds what the log alone says about roslab.yaml.
    """
    if not answer.explanations:
        what = "The build in this log went well." if answer.succeeded else "This log holds nothing that failed."
        return f"{what}\n"
    said = "\n".join(_one(found, lines=lines) for found in answer.explanations)
    return _CONTROL.sub(lambda found: found[0].encode("unicode_escape").decode(), said)


def _one(found: Explanation, *, lines: bool) -> str:
    out: list[str] = []
    if found.step:
        place = f" ({found.file}:{found.line})" if found.file else ""
        platform = f" on {found.platform}" if found.platform else ""
        out.append(f"step{platform}: {_flat(found.step, 200)}{place}")
    if found.packages:
        out.append(f"package: {', '.join(found.packages)}")
    if found.id is not None:
        number = f" (line {found.error_line} of the log)" if found.error_line else ""
        out.append(f"error: {found.error}{number}")
        likely = "" if found.certainty == "certain" else " (likely)"
        out += [f"cause{likely}: {found.cause}", f"fix:   {found.fix}"]
        out += [f"roslab.yaml: {_line(key, values)}" for key, values in found.repair if lines]
    else:
        out.append("no known cause. The lines that matter:")
        out += [f"  {line}" for line in found.lines] or ["  (none: the log is empty or cut off)"]
        if found.reproduce:
            out.append(f"To try this step in a shell: {found.reproduce}")
    return "\n".join(out) + "\n"


def _line(key: str, values: tuple[str, ...]) -> str:
    return f"{key}: [{', '.join(values)}]" if key in LISTS else f"{key}: {' '.join(values)}"


def dockerfile_lines(found: Explanation) -> list[str]:
    """Return the instructions that repair an author's own Dockerfile; none if the repair is not a package."""
    install = {
        "apt": "RUN apt-get update && apt-get install -y --no-install-recommends {}",
        "pip": "RUN pip install {}",
    }
    return [install[key].format(" ".join(map(shlex.quote, values))) for key, values in found.repair if key in install]


def problems(answer: Answer, *, lines: bool = True) -> tuple[Problem, ...]:
    """Return an answer as problems, one for each step that failed.

    ``lines`` adds what the log alone says about roslab.yaml.
    """
    return tuple(_problem(found, lines=lines) for found in answer.explanations)


def _problem(found: Explanation, *, lines: bool) -> Problem:
    platform = f" on {found.platform}" if found.platform else ""
    packages = ", ".join(found.packages)
    if found.id is not None:
        package = f" (package {packages})" if packages else ""
        hint = f"{found.fix}{_lines(found)}" if lines else found.fix
        said = found.error.replace("`", "'")
        return Problem(message=f"{found.cause.rstrip('.')}{package}{platform}: `{said}`", hint=hint)
    step = f" in `{_flat(found.step, 120)}`" if found.step else ""
    package = f" in the package {packages}" if packages else ""
    return Problem(
        message=f"the build failed{package}{platform}{step}: {found.error or 'its log does not say why'}",
        hint="no known cause: the lines before it in the log say more",
    )


def _lines(found: Explanation) -> str:
    """Return the lines for roslab.yaml, as a sentence."""
    lines = "; ".join(_line(key, values) for key, values in found.repair)
    return f" In roslab.yaml: `{lines}`." if lines else ""


def as_json(answer: Answer, repair: dict[str, Any] | None = None) -> str:
    """Return an answer as JSON: ``{"succeeded", "lines", "explanations": [{"id", "cause", "fix", …}]}``.

    ``repair`` is what the repository and the log together say about roslab.yaml; the key is missing without it.
    """
    explanations = []
    for found in answer.explanations:
        said = {**asdict(found), "names": dict(found.names)}
        said |= {"repair": {key: list(values) for key, values in found.repair}}
        explanations.append({key: value for key, value in said.items() if key != "log"})
    whole: dict[str, Any] = {"succeeded": answer.succeeded, "lines": answer.lines, "explanations": explanations}
    whole |= {"repair": repair} if repair is not None else {}
    return json.dumps(whole, indent=2, ensure_ascii=False) + "\n"


def _flat(command: str, most: int) -> str:
    flat = " ".join(command.split())
    return flat if len(flat) <= most else f"{flat[: most - 1]}…"
