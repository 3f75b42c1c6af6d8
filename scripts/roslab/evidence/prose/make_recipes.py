"""What a shell runs for ``make run``: the recipe of a target that starts something, with what it needs before.

What compiles, tests, cleans or makes images is left to make. Of a recipe that starts containers all lines count:
what is run in them is the program, and the image has no engine.
"""

from __future__ import annotations

from functools import cache

from roslab.evidence.lex.make_tasks import NAMES, MakeTasks, parsed
from roslab.evidence.prose.task_calls import TaskCalls, joined
from roslab.repository.checkout import Repository, nearest
from roslab.values.pattern import pattern

MAX_SIZE = 64 * 1024
MOST_FILES = 60
"""Most Makefiles, those nearest to the root first."""
WORDS = r"make[ \t]+([A-Za-z_][\w-]*(?:[ \t]+[A-Za-z_]\w*=[^\s#;&|`<>$]+){0,8})"
_CHORE = pattern(
    r"(?:.*[-_.])?(?:all|build|built|compile|clean\w*|test\w*|unittest\w*|pytest|lint\w*|format|fmt|docker\w*|image|"
    r"install|uninstall|check\w*|docs?|help|dist|release|publish|coverage|push|pull|stop|kill|down|up|ci|deploy|"
    r"package|upload|flash|shell|bash|logs?|typecheck|mypy|style)(?:[-_.].*)?"
)
"""A target that serves those who work on the code, or that makes what the image makes in its own way."""
_NOT_FIRST = pattern(
    r"(?:.*[-_.])?(?:all|build|built|compile|clean\w*|test\w*|lint\w*|format|docker\w*|image|check\w*|stop|kill|help)"
    r"(?:[-_.].*)?"
)
"""What such a target may need, which the image does otherwise or not at all."""
_NO_PROGRAMS = (
    r"setup\.py|-c\b|-m[ \t]+(?:pip|venv|pytest|unittest|build|black|ruff|flake8|mypy|isort|coverage|twine|sphinx\w*|"
    r"http\.server|pylint|pre_commit|virtualenv)\b"
)
"""What Python is given by those who work on the code."""
_STARTS = pattern(
    rf"(?:^|[\s;&(\"'])(?:(?:[\w.-]*/)*python[\d.]*[ \t]+(?!{_NO_PROGRAMS})\S|roslaunch[ \t]|rosrun[ \t]|"
    r"ros2[ \t]+(?:run|launch)[ \t]|(?:gz|ign)[ \t]+(?:sim|gazebo|launch)[ \t]|(?:torchrun|streamlit|accelerate)[ \t]|"
    r"(?:uv|poetry|pipenv|pdm|pixi|rye|conda)[ \t]+run[ \t]+(?!pytest|ruff|black|mypy|pre-commit|flake8)\S|"
    r"(?:bash|sh)[ \t]+(?!-)\S+\.(?:ba)?sh|\./[\w./-]+|(?:build|bin)/[\w./-]+)"
)
"""A line that starts a program."""
_DOCKER = pattern(r"(?:^|[\s;&(])(?:docker|docker-compose|podman|singularity|apptainer)[ \t]")
_OTHERWISE = pattern(
    rf"{_DOCKER.pattern}|(?:^|[\s;&(])(?:[\w-]*g\+\+|[\w-]*gcc|clang(?:\+\+)?|cc|nvcc|c?make|ninja)(?:-\d+)?[ \t]"
)
_TASK = pattern(r"[A-Za-z_][\w-]*")
"""A target that is no file."""
_OF_VENV = pattern(r"(?<![\w./-])(?:\./)?\.?\w*env\w*/bin/(?=python|pip)")
"""A virtual environment of the reader's: the image has its own."""


def of_makefile(text: str) -> TaskCalls:
    """Return the targets of a Makefile that start something; it is parsed for the first call."""
    tasks = cache(lambda: parsed(text))
    return TaskCalls(lambda call: _run(call, tasks()))


def calls(repository: Repository) -> dict[str, TaskCalls]:
    """Return what the Makefiles in the folders of a tree define."""
    return repository.once(_makefiles)


def _makefiles(repository: Repository) -> dict[str, TaskCalls]:
    by_folder = {file.folder: file for name in reversed(NAMES) for file in repository.named(name)}
    files = [file for file in nearest(by_folder.values())[:MOST_FILES] if file.size <= MAX_SIZE]
    return {file.folder: of_makefile(repository.read(file)) for file in files}


def _run(call: str, tasks: MakeTasks) -> str | None:
    name, *words = call.split()
    given = dict(word.split("=", 1) for word in words)
    lines = tasks.lines_of(name, given)
    if any(map(_DOCKER.search, lines)):
        return joined(lines)
    if _CHORE.fullmatch(name) or not any(map(_STARTS.search, lines)):
        return None
    before = (each for each in tasks.needed_by(name) if _TASK.fullmatch(each) and not _NOT_FIRST.fullmatch(each))
    made = [line for each in before for line in tasks.lines_of(each, given) if not _OTHERWISE.search(line)]
    return joined([_OF_VENV.sub("", line) for line in (*made, *lines)])
