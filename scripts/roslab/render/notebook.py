"""README.ipynb: the README as a notebook whose shell blocks run in the image.

The kernel is bash, so every code cell is bash. A block of Python or C++ in a README is usually an excerpt and not a
program (its imports are in an earlier block, its data is missing), so it stays in the text, highlighted but not run.
"""

from __future__ import annotations

import hashlib
import re
from collections.abc import Iterator
from importlib import import_module
from typing import Any, Literal

from roslab.plan.plan import Plan
from roslab.render import quote
from roslab.render.output import MARKER, Beside
from roslab.render.shell_block import Step, steps
from roslab.values.pattern import pattern
from roslab.values.redacted import bare

Cell = tuple[Literal["markdown", "code"], str]
MARKDOWN = (".md", ".markdown", ".mkd", ".mdown")
_LABEL = pattern(r"\[((?:[^\[\]\\]|\\.){1,999})\]")


def text(plan: Plan, beside: Beside) -> str:
    """Return the notebook that shows the README."""
    return notebook(plan, readme=beside.readme, readme_name=beside.readme_name)


def notebook(plan: Plan, *, readme: str | None, readme_name: str = "README.md") -> str:
    """Return the notebook's JSON, the same for the same README.

    Markdown is split at its shell blocks and otherwise unchanged. A README in another markup becomes one text cell.
    Without a README, a few cells show how to start the program.
    """
    readme = bare(readme or "")
    if readme.strip():
        if readme_name.lower().endswith(MARKDOWN):
            cells = list(_cells(readme))
        else:
            cells = [("markdown", readme.strip("\n")), *_how_to_run(plan)]
        origin = readme_name
    else:
        cells = [("markdown", f"# {plan.name}\n\nThis repository has no README."), *_how_to_run(plan)]
        origin = "the plan"
    return _json(cells, origin)


def _how_to_run(plan: Plan) -> Iterator[Cell]:
    command = plan.run.command if isinstance(plan.run.command, str) else quote.words(plan.run.command)
    if command in ("", "bash"):  # a shell waits for input that a cell cannot give
        command = "ls"
        yield "markdown", "The files of the repository:"
    else:
        yield "markdown", "The image's default command:"
    yield "code", command
    if plan.run.candidates:
        others = "\n".join(f"- `{quote.words(argv)}`" for argv in plan.run.candidates)
        yield "markdown", f"Other programs that were found:\n\n{others}"


def _cells(text: str) -> Iterator[Cell]:
    from markdown_it import MarkdownIt  # noqa: PLC0415 - only `create` needs it: keep it off the fast path

    text = text.replace("\r\n", "\n").replace("\r", "\n").replace("\0", "\ufffd")
    lines = text.split("\n")
    environment: dict[str, Any] = {}
    position = 0
    for token in MarkdownIt("commonmark").parse(text, environment):
        if token.type not in ("fence", "code_block") or token.map is None:
            continue
        parts = steps(token.info, token.content)
        if not parts:
            continue
        yield from _text(lines, position, token.map[0], environment)
        yield from map(_cell, parts)
        position = token.map[1]
    yield from _text(lines, position, len(lines), environment)


def _cell(step: Step) -> Cell:
    if step.typed:
        return "code", step.text
    fence = "`" * max(3, *(len(run) + 1 for run in re.findall(r"`+", step.text)), 3)
    return "markdown", f"{fence}text\n{step.text}\n{fence}"


def _text(lines: list[str], start: int, end: int, environment: dict[str, Any]) -> Iterator[Cell]:
    """Yield the lines as a Markdown cell, with the definitions of its links that are in other cells."""
    while start < end and not lines[start].strip():
        start += 1
    while end > start and not lines[end - 1].strip():
        end -= 1
    if start == end:
        return
    text = "\n".join(_dedented(lines[start:end]))
    definitions = _definitions(text, start, end, lines, environment)
    yield "markdown", "\n".join((text, "", *definitions)) if definitions else text


def _dedented(lines: list[str]) -> list[str]:
    """Remove the indentation of text that continues a list, because without the list it would become a code block."""
    depth = len(lines[0]) - len(lines[0].lstrip(" "))
    if depth < 4:
        return lines
    result = list(lines)
    for index, line in enumerate(lines):
        if line.strip() and not line.startswith(" " * depth):
            break
        result[index] = line[depth:]
    return result


def _definitions(text: str, start: int, end: int, lines: list[str], environment: dict[str, Any]) -> list[str]:
    """Return the definitions that a cell's links and images need: each cell of a notebook is rendered separately."""
    references = environment.get("references", {})
    if not references:
        return []
    from markdown_it.common.utils import normalizeReference  # noqa: PLC0415

    found: dict[str, None] = {}
    for label in _LABEL.findall(text):
        first, last = references.get(normalizeReference(label), {}).get("map", (start, start))
        if not start <= first < end:
            found["\n".join(line.strip() for line in lines[first:last])] = None
    return list(found)


def _json(cells: list[Cell], origin: str) -> str:
    # Imported here because it takes longer to import than everything else together; Any because it has no types
    nbformat: Any = import_module("nbformat")
    seen: dict[Cell, int] = {}
    nodes = []
    for cell in cells:
        seen[cell] = seen.get(cell, 0) + 1
        kind, source = cell
        # The id is computed from the content, so that editing one paragraph changes only one cell
        identity = hashlib.sha256(f"{kind}\0{seen[cell]}\0{source}".encode()).hexdigest()[:12]
        new = nbformat.v4.new_code_cell if kind == "code" else nbformat.v4.new_markdown_cell
        nodes.append(new(source, id=identity))
    metadata = {
        "kernelspec": {"display_name": "Bash", "language": "bash", "name": "bash"},
        "language_info": {
            "codemirror_mode": "shell",
            "file_extension": ".sh",
            "mimetype": "text/x-sh",
            "name": "bash",
        },
        "roslab": {"generated": f"{MARKER} from {origin}"},
    }
    document = nbformat.v4.new_notebook(cells=nodes, metadata=metadata)
    nbformat.validate(document)
    return str(nbformat.writes(document)).rstrip("\n") + "\n"
