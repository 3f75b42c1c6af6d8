"""Calls of a task on pages (``just run``, ``make run``, ``./run.sh``), with what it runs in their place.

The image then needs none of these runners.
"""

from __future__ import annotations

import posixpath
import re
from collections.abc import Callable, Mapping

from roslab.evidence.prose import just_recipes, make_recipes, manager_tasks, venv_scripts
from roslab.evidence.prose.headings import MAX_LINE, fence
from roslab.evidence.prose.task_calls import TaskCalls
from roslab.repository.checkout import File, Repository
from roslab.values.dataclass import dataclass
from roslab.values.pattern import pattern

_INDENTED = ("    ", "\t")
"""How a line of code begins without a fence."""
MAX_ADDED = 64 * 1024
"""Most characters by which a page grows: the calls after that stay as they are written."""
_CD = pattern(r"[ \t]*(?:[$>%][ \t]+)?cd[ \t]+[\"']?([\w./-]{1,200})")


@dataclass(frozen=True, kw_only=True, slots=True)
class _Runner:
    """A program that runs tasks which a file of the tree defines."""

    word: str
    """A page that calls it has this."""
    line: re.Pattern[str]
    """A line that is nothing but a call."""
    span: re.Pattern[str]
    """A call in a sentence."""
    calls: Callable[[Repository], Mapping[str, TaskCalls]]
    """The tasks that it knows, by the folder in which it is called."""


def _runner(word: str, calls: Callable[[Repository], Mapping[str, TaskCalls]], words: str) -> _Runner:
    return _Runner(
        word=word,
        line=pattern(rf"^([ \t]*(?:[$>%][ \t]+)?){words}[ \t]*(?:[ \t]#[^\n]*)?()$"),
        span=pattern(rf"(?<!`)(`){words}[ \t]*(`)(?!`)"),
        calls=calls,
    )


_RUNNERS = (
    _runner("just ", just_recipes.calls, just_recipes.WORDS),
    _runner("make ", make_recipes.calls, make_recipes.WORDS),
    *(_runner(word, manager_tasks.calls, words) for word, words in manager_tasks.WORDS),
    _runner("sh", venv_scripts.calls, venv_scripts.WORDS),
)


def with_tasks(text: str, repository: Repository, page: File) -> str:
    """Return a page with what a shell runs, on one line, in place of each call whose task is plain lines of it.

    The tasks are those of the file in the folder that the page goes to before, in the page's, else at the root.
    """
    for runner in _RUNNERS:
        if runner.word in text and (by_folder := runner.calls(repository)):
            text = _with_tasks(text, runner, by_folder, page)
    return text


def _with_tasks(text: str, runner: _Runner, by_folder: Mapping[str, TaskCalls], page: File) -> str:
    lines, fenced, left = text.split("\n"), False, MAX_ADDED
    own = by_folder.get(page.folder) or by_folder.get("")
    calls = own
    for number, line in enumerate(lines):
        if fence(line):
            fenced, calls = not fenced, own
        elif "cd " in line and (entered := _CD.match(line)):
            calls = by_folder.get(posixpath.normpath(posixpath.join(page.folder, entered[1])), own)
        elif runner.word in line and calls and len(line) <= MAX_LINE:
            form = runner.line if fenced or line.startswith(_INDENTED) else runner.span
            written = _run(line, form, calls)
            if len(written) - len(line) <= left:
                left -= max(0, len(written) - len(line))
                lines[number] = written
    return "\n".join(lines)


def _run(line: str, form: re.Pattern[str], calls: TaskCalls) -> str:
    """Return a line with what its calls run; as it is written where that is not known."""

    def run(match: re.Match[str]) -> str:
        whole = calls.line_of(match[2])
        return match[0] if whole is None else f"{match[1]}{whole}{match[3]}"

    return form.sub(run, line)
