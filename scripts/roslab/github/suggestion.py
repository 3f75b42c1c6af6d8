"""A repair as a comment in the pull request whose build failed: a suggestion if the diff has its lines, else text.

Only a repository's own pull requests are commented, and only if the token has the right ``pull-requests: write``.
Nothing here fails the run. https://docs.github.com/en/rest/pulls/comments
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import Any

from roslab.errors import BuildError, Problem
from roslab.github import api, workflow
from roslab.github.event import Event
from roslab.github.run import short
from roslab.render.markdown import block, prose
from roslab.render.outcome import Repair
from roslab.render.summary import pasted
from roslab.repair.hunk import Hunk
from roslab.values.pattern import pattern

_HUNK = pattern(r"@@ -\d+(?:,\d+)? \+(\d+)(?:,\d+)? @@")


def suggest(
    event: Event,
    problems: Sequence[Problem],
    repairs: Sequence[Repair],
    hunk: Hunk | None,
    environment: Mapping[str, str],
) -> None:
    """Comment a repair in the event's pull request, once for each repair; say why if that is not possible."""
    if not event.pull or event.foreign or not environment.get("ROSLAB_GITHUB_TOKEN"):
        return
    try:
        _suggest(event, problems, repairs, hunk, environment)
    except (BuildError, OSError, ValueError, KeyError, TypeError) as error:
        workflow.say(f"no comment in the pull request: {getattr(error, 'reason', None) or error}")


def _suggest(
    event: Event,
    problems: Sequence[Problem],
    repairs: Sequence[Repair],
    hunk: Hunk | None,
    environment: Mapping[str, str],
) -> None:
    ask = api.asker(environment, pause=lambda _: None)
    pull, issue = (f"/repos/{event.repository}/{kind}/{event.pull}" for kind in ("pulls", "issues"))
    mark = f"<!-- roslab {short(*(f'{repair.file}:{repair.text}' for repair in repairs))} -->"
    earlier = [*(api.pages(ask, f"{pull}/comments") or ()), *(api.pages(ask, f"{issue}/comments") or ())]
    if any(mark in str(comment.get("body", "")) for comment in earlier):
        workflow.say("the pull request has this comment already")
        return
    shown = lines_of(api.pages(ask, f"{pull}/files") or (), hunk.file) if hunk else set()
    if hunk and event.head_commit and shown.issuperset(range(hunk.start, hunk.end + 1)):
        where: dict[str, Any] = {"commit_id": event.head_commit, "path": hunk.file, "side": "RIGHT", "line": hunk.end}
        where |= {"start_line": hunk.start, "start_side": "RIGHT"} if hunk.end > hunk.start else {}
        _post(f"{pull}/comments", {**where, "body": f"{mark}\n{_why(problems)}\n{_suggestion(hunk)}"}, environment)
        workflow.say(f"suggested lines {hunk.start} to {hunk.end} of {hunk.file}")
        return
    lines = "\n".join(pasted(repair) for repair in repairs)
    _post(f"{issue}/comments", {"body": f"{mark}\n{_why(problems)}\n{lines}"}, environment)
    workflow.say("commented the lines in the pull request")


def lines_of(files: Iterable[Mapping[str, Any]], file: str) -> set[int]:
    """Return the lines of a file that a pull request's diff shows, which are those that may be commented.

    https://docs.github.com/en/rest/pulls/pulls#list-pull-requests-files
    """
    patch = next((str(each.get("patch", "")) for each in files if each.get("filename") == file), "")
    found, line = set(), 0
    for text in patch.splitlines():
        if start := _HUNK.match(text):
            line = int(start[1])
        elif line and not text.startswith(("-", "\\")):
            found.add(line)
            line += 1
    return found


def _why(problems: Sequence[Problem]) -> str:
    return "The build of the image failed:\n\n" + "".join(f"- {prose(problem.message)}\n" for problem in problems[:5])


def _suggestion(hunk: Hunk) -> str:
    return block("\n".join(hunk.new), "suggestion")


def _post(path: str, body: Mapping[str, Any], environment: Mapping[str, str]) -> None:
    api.send("POST", path, body, environment, right="pull-requests: write")
