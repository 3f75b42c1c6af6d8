"""Workflow commands, step outputs and the job summary: how a step communicates with the runner.

https://docs.github.com/en/actions/reference/workflows-and-actions/workflow-commands
"""

from __future__ import annotations

import os
import re
import secrets
import sys
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path

from roslab.errors import Problem, RoslabError
from roslab.repository.checkout import printable
from roslab.values.dataclass import replace

SUMMARY_LIMIT = 1024 * 1024
"""Most bytes of one step's summary; the runner drops a longer one completely."""


def command(name: str, text: str, properties: Mapping[str, object] | None = None) -> str:
    """Return one workflow command, escaped so that no value can start another command."""
    said = [f"{key}={_property(str(value))}" for key, value in (properties or {}).items() if value is not None]
    return f"::{name}{' ' if said else ''}{','.join(said)}::{_data(text)}"


def _data(text: str) -> str:
    return text.replace("%", "%25").replace("\r", "%0D").replace("\n", "%0A")


def _property(text: str) -> str:
    return _data(text).replace(":", "%3A").replace(",", "%2C")


def annotation(level: str, problem: Problem) -> str:
    """Return a problem as an annotation (``error``, ``warning`` or ``notice``) at its place in the repository."""
    if problem.file is None:
        return command(level, str(problem))
    text = str(replace(problem, origin=None))
    return command(level, text, {"file": problem.file, "line": problem.line, "col": problem.column})


def error_commands(error: RoslabError) -> str:
    """Return an error as one ``::error`` line for each of its problems."""
    return "".join(annotation("error", problem) + "\n" for problem in error.problems)


def say(text: str) -> None:
    """Print one line of progress, in which nothing that a repository wrote is a command.

    The runner also knows ``##[command]``, anywhere in a line:
    https://github.com/actions/runner/blob/main/src/Runner.Common/ActionCommand.cs
    """
    line = printable(text).replace("##[", "# #[")
    _print(re.sub(r"^(\s*):(?=:)", r"\1: ", line))


def warn(problem: Problem) -> None:
    """Show a warning at its place."""
    _print(annotation("warning", problem))


def mask(word: str) -> None:
    """Have the runner hide a word in everything that the job prints from now on."""
    _print(command("add-mask", word))


def notice(text: str) -> None:
    """Show a line on the run's page."""
    _print(command("notice", text))


@contextmanager
def group(title: str) -> Iterator[None]:
    """Fold what is printed inside; even text that looks like a command is safe there."""
    token = secrets.token_hex(16)
    _print(command("group", title))
    _print(command("stop-commands", token))
    try:
        yield
    finally:
        sys.stderr.flush()
        _print(f"::{token}::")
        _print(command("endgroup", ""))


def outputs(values: Mapping[str, str], environment: Mapping[str, str] | None = None) -> None:
    """Set the step's outputs; a random delimiter prevents a value from ending its own block.

    Outside a workflow, without GITHUB_OUTPUT, they are printed.
    """
    text = "".join(_assignment(name, value) for name, value in values.items())
    _append((environment or os.environ).get("GITHUB_OUTPUT"), text)


def flag(value: bool) -> str:
    """Return a truth as an output, which a workflow compares with a text."""
    return "true" if value else "false"


def _assignment(name: str, value: str) -> str:
    delimiter = f"end-{secrets.token_hex(16)}"
    return f"{name}<<{delimiter}\n{value}\n{delimiter}\n"


def summary(text: str, environment: Mapping[str, str] | None = None) -> None:
    """Add Markdown to the job's summary; text over the runner's limit is cut at the end of a line, with a note."""
    data = text.encode()
    if len(data) > SUMMARY_LIMIT:
        kept = data[: SUMMARY_LIMIT - 200].rpartition(b"\n")[0].decode(errors="ignore")
        text = f"{kept}\n\n_The rest was longer than a summary may be._\n"
    _append((environment or os.environ).get("GITHUB_STEP_SUMMARY"), text)


def _append(file: str | None, text: str) -> None:
    if not file:
        sys.stdout.write(text)
        return
    with Path(file).open("a", encoding="utf-8", newline="\n") as stream:
        stream.write(text)


def _print(line: str) -> None:
    # The runner reads commands from stdout and stderr; using one of them keeps commands and text in order.
    sys.stdout.flush()
    sys.stderr.write(line + "\n")
    sys.stderr.flush()
