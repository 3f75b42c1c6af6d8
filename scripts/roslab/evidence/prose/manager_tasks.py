"""What a shell runs for the tasks that projects of Python define: ``hatch run sim``, ``pdm run sim``, ``poe sim``.

https://hatch.pypa.io/latest/config/environment/overview/#scripts, https://pdm-project.org/latest/usage/scripts/,
https://rye.astral.sh/guide/pyproject/#toolryescripts, https://poethepoet.natn.io/tasks/index.html,
https://github.com/taskipy/taskipy, https://pipenv.pypa.io/en/latest/scripts.html and https://taskfile.dev/usage/,
read 2026-11-28.
"""

from __future__ import annotations

import re
import shlex
from collections.abc import Iterator, Mapping
from functools import partial
from itertools import islice
from typing import Any

from roslab.evidence.prose.task_calls import TaskCalls, joined
from roslab.repository.checkout import Repository, nearest
from roslab.values.pattern import pattern

MAX_SIZE = 128 * 1024
MOST_FILES = 60
"""Most files that define tasks, those nearest to the root first."""
MOST_LINES = 30
DEEPEST = 10
"""Most tasks that call each other."""
NESTED = 5
"""Most tables and lists of one task in each other: an alias of YAML may hold itself many times over."""
_FOLDERS = ("cwd", "dir", "working_dir", "chdir")
"""What taskipy and poe, Taskfile, pdm and rye call the folder in which a task is run."""
_FILES = ("pyproject.toml", "hatch.toml", "Pipfile", "Taskfile.yml", "Taskfile.yaml")
_NAME = r"[A-Za-z_][\w.:-]*"
_REST = r"(?:[ \t]+[^\s#;&|`<>$]+){0,12}"
WORDS = (
    *((f"{each} run ", rf"({each}[ \t]+run[ \t]+{_NAME}{_REST})") for each in ("hatch", "pdm", "rye", "pipenv")),
    ("poe ", rf"((?:(?:uv|poetry|pdm)[ \t]+run[ \t]+)?poe[ \t]+{_NAME}{_REST})"),
    ("task ", rf"((?:(?:uv|poetry|pdm)[ \t]+run[ \t]+)?task[ \t]+{_NAME}{_REST})"),
)
"""The calls of each, after a part of them."""
_DEFINES = pattern(r"^\[tool\.(?:hatch\.envs|pdm\.scripts|rye\.scripts|poe\.tasks|taskipy\.tasks)\b", re.MULTILINE)
_ARGUMENTS = pattern(r"\{args(?::([^{}\n]*))?\}|\{\{\s*\.CLI_ARGS\s*\}\}")
_UNFILLED = pattern(r"\{\{|\$\{\w+\}|\{[\w-]+:")


def of_managers(tasks: Mapping[str, Mapping[str, Any]]) -> TaskCalls:
    """Return the tasks of one folder: ``tasks`` has those of each runner by their names."""
    return TaskCalls(partial(_run, tasks))


def _run(by_runner: Mapping[str, Mapping[str, Any]], call: str) -> str | None:
    words = call.split()
    runner = next((word for word in words[:3] if word in {"poe", "task"}), words[0])
    named = words[words.index(runner) + (1 if runner in {"poe", "task"} else 2) :]
    tasks = by_runner.get(runner, {})
    lines = list(islice(_lines(tasks, named[0], 0), MOST_LINES + 1)) if named else []
    rest = [word for word in named[1:] if word != "--"]
    if not lines or len(lines) > MOST_LINES:
        return None
    filled = [_given(line, rest, last=number == len(lines)) for number, line in enumerate(lines, 1)]
    return None if any(_UNFILLED.search(line) for line in filled) else joined(filled)


def _given(line: str, rest: list[str], *, last: bool) -> str:
    """Return a line with the arguments of the call: where it has a place for them, else behind it."""
    if _ARGUMENTS.search(line):
        return _ARGUMENTS.sub(lambda match: " ".join(rest) or match[1] or "", line).strip()
    return " ".join((line, *rest)) if last else line


def _lines(tasks: Mapping[str, Any], name: str, depth: int, done: set[str] | None = None) -> Iterator[str]:
    """Yield the lines of a task; a line that begins with the name of another one stands for that one's.

    Before them come those of the tasks that it needs, each once in a run (``done``).
    """
    done = {name} if done is None else done
    said = tasks.get(name)
    for needed in _needed(said) if depth <= DEEPEST else ():
        if needed in tasks and needed not in done:
            done.add(needed)
            yield from _lines(tasks, needed, depth + 1, done)
    for line in _said(said) if depth <= DEEPEST else ():
        first, _, rest = line.partition(" ")
        if first in tasks and first != name:
            *before, end = list(islice(_lines(tasks, first, depth + 1, done), MOST_LINES + 1)) or [""]
            yield from (*before, f"{end} {rest}".strip())
        elif line:
            yield line


def _needed(said: Any) -> Iterator[str]:
    """Yield the names of the tasks that Taskfile and poe start before one: ``deps: [build]``."""
    asked = said.get("deps") if isinstance(said, dict) else None
    for each in asked[:MOST_LINES] if isinstance(asked, list) else ():
        name = each.get("task") if isinstance(each, dict) else each
        if isinstance(name, str):
            yield name.partition(" ")[0]


def _said(said: Any, depth: int = 0) -> Iterator[str]:
    """Yield the lines of a task as the runners write them: a text, a list of lines, or a table with one of these."""
    if depth > NESTED:
        return
    if isinstance(said, str):
        yield from (line.strip().removeprefix("-").strip() for line in said.split("\n")[: MOST_LINES + 1])
    elif isinstance(said, list):
        for each in said[: MOST_LINES + 1]:
            yield from _said(each, depth + 1) if isinstance(each, (str, dict)) else ()
    elif isinstance(said, dict):
        folder = next((said[key] for key in _FOLDERS if isinstance(said.get(key), str)), "")
        for line in _of_table(said, depth):
            yield f"cd {shlex.quote(folder)} && {line}" if folder and line else line


def _of_table(said: Mapping[str, Any], depth: int) -> Iterator[str]:
    for key in ("cmd", "shell", "task"):
        value = said.get(key)
        if isinstance(value, list) and all(isinstance(word, str) for word in value):
            yield shlex.join(value)
        elif isinstance(value, str):
            yield from _said(value, depth + 1)
    for key in ("cmds", "sequence", "composite", "chain"):
        yield from _said(said[key], depth + 1) if isinstance(said.get(key), list) else ()


def calls(repository: Repository) -> dict[str, TaskCalls]:
    """Return what the files in the folders of a tree define."""
    return repository.once(_by_folder)


def _by_folder(repository: Repository) -> dict[str, TaskCalls]:
    found: dict[str, dict[str, dict[str, Any]]] = {}
    for file in nearest(repository.named(*_FILES))[:MOST_FILES]:
        if file.size <= MAX_SIZE:
            for runner, tasks in _defined(file.name, repository.read(file)):
                found.setdefault(file.folder, {}).setdefault(runner, {}).update(tasks)
    return {folder: of_managers(tasks) for folder, tasks in found.items()}


def _defined(name: str, text: str) -> Iterator[tuple[str, dict[str, Any]]]:
    """Yield each runner with the tasks that a file defines for it; nothing for one that cannot be read."""
    if name.startswith("Taskfile"):
        from roslab.evidence.lex import yaml  # noqa: PLC0415 - few trees have one

        data = yaml.load(text)
        yield "task", _table(data, "tasks")
        return
    if name == "pyproject.toml" and not _DEFINES.search(text):
        return
    from roslab.values import toml  # noqa: PLC0415 - many trees have no task

    try:
        data = toml.parsed(text)
    except ValueError:
        return
    if name == "Pipfile":
        yield "pipenv", _table(data, "scripts")
        return
    tool = data if name == "hatch.toml" else _table(data, "tool")
    yield "hatch", _of_hatch(_table(data, "envs") if name == "hatch.toml" else _table(tool, "hatch", "envs"))
    for runner, keys in (
        ("pdm", ("pdm", "scripts")),
        ("rye", ("rye", "scripts")),
        ("poe", ("poe", "tasks")),
        ("task", ("taskipy", "tasks")),
    ):
        yield runner, _table(tool, *keys)


def _of_hatch(environments: Mapping[str, Any]) -> dict[str, Any]:
    """Return the scripts of all environments: those of ``default`` by their names, the others behind their own."""
    found: dict[str, Any] = {}
    for name, environment in environments.items():
        scripts = _table(environment, "scripts")
        found |= {f"{name}:{each}": said for each, said in scripts.items()}
        found |= scripts if name == "default" else {}
    return found


def _table(data: Any, *keys: str) -> dict[str, Any]:
    for key in keys:
        data = data.get(key) if isinstance(data, dict) else None
    return data if isinstance(data, dict) else {}
