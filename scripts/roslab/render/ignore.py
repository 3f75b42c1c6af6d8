"""Dockerfile.dockerignore: files hidden from the build. BuildKit reads it instead of the author's .dockerignore."""

from __future__ import annotations

import fnmatch
import posixpath
import re
from collections.abc import Iterable, Sequence
from functools import lru_cache
from itertools import accumulate

from roslab.plan.packages import own_files
from roslab.plan.plan import Plan
from roslab.render import quote
from roslab.render.output import MARKER, Beside
from roslab.values.endings import SHELL_SCRIPTS
from roslab.values.pattern import pattern
from roslab.values.words import line_of

HEADER = f"# {MARKER}. docker reads this file for Dockerfile, instead of .dockerignore.\n"
ANY_DEPTH = "**"
ALL = f"!{ANY_DEPTH}"
ROOT = ""
"""The repository as a whole, where it stands for what the Dockerfile needs."""
_NO_NAME = "\x01"
"""It is no file's name: only a line that excludes everything matches it."""
MAX_JUDGED = 64 * 1024
"""Characters of an ignore file that are compared with paths; the rest is copied without comparing."""
MAX_COMPARED = 2_000_000
"""Limit for comparing parts of lines with parts of the paths that the Dockerfile needs: a hundred lines, as in the
longest real files, and a thousand deep paths take half of it."""
_PAGES = ("README.md", "README.rst", "README.txt", "LICENSE", "LICENSE.md", "LICENSE.txt")
"""What projects of Python name, or read in setup.py, for their description: no tool builds one without these.

https://packaging.python.org/en/latest/guides/writing-pyproject-toml/#readme, 2026-11-28.
"""
_FILE = pattern(r"(?![-./])[\w./-]{1,200}\.\w{1,10}")
"""A word of a command that may be a path from the root."""
_CODE = (".py", *SHELL_SCRIPTS, "CMakeLists.txt")
"""How the names of files end that are compiled or started, and are no data."""
Parts = tuple[str, ...]
"""A line's shell patterns, one for each part of a path; ``**`` stands for any number of folders."""


def text(plan: Plan, beside: Beside) -> str:
    """Return the ignore file of a plan; it hides files that nothing in the image reads."""
    return ignore(plan, beside.unread)


def ignore(plan: Plan, unread: tuple[str, ...]) -> str:
    """Return the text of the ignore file: the author's lines, exceptions for what the plan needs, what never goes in.

    ``unread`` is what ``create`` writes and no program in the image reads: changing it must not repeat the build.
    The last line that matches a path decides. The author's file was written for another Dockerfile, so a file that this
    Dockerfile installs from is included again right after the line that excluded it, and so is all where the repository
    itself is compiled or installed, a line excludes everything (``*``) and none below it lets in what is compiled or
    started; the lines below still apply.
    ``.git`` comes last, so that no ``!`` of the author's publishes the history and the runner's credentials.
    """
    lines = [*map(str.rstrip, plan.ignore)]
    parts = [HEADER]
    if lines:
        body = "\n".join(_with_needed(lines, _needed(plan)))
        parts.append(f"# The author's .dockerignore\n{body}\n")
    own = "\n".join(unread)
    parts.append(f"# What `roslab create` writes\n{own}\n")
    if hidden := plan.workspace.made_elsewhere:
        lines_of = "\n".join(map(_literal, hidden))
        parts.append(f"# What a build on another machine left, from which none goes on in another folder\n{lines_of}\n")
    parts.append("# The history, and the credentials that a checkout leaves in it, belong in no image\n**/.git\n")
    return "\n".join(parts)


def keeps_out(lines: Sequence[str], path: str) -> bool:
    """Return whether an ignore file of these lines certainly excludes a path from the build.

    A file longer than a person would write is not judged: it counts as excluding nothing.
    """
    patterns = _patterns(lines)
    decisive = _decisive(patterns, path)
    return len(patterns) == len(lines) and decisive is not None and not lines[decisive].lstrip().startswith("!")


def _needed(plan: Plan) -> tuple[str, ...]:
    """Return the files and folders that the Dockerfile names, with those that its command does."""
    python = plan.python
    manifests = plan.rosdep.manifests if plan.rosdep else ()
    conda = (python.conda_file,) if python.conda_file else ()
    projects = plan.workspace.python_projects
    folders = (folder for folder in projects if folder not in ("", "."))
    program = plan.workspace.program
    cmake = (posixpath.join(program.folder, "CMakeLists.txt"),) if program else ()
    sources = (*plan.libraries, *plan.workspace.sources, *plan.workspace.submodules)
    held = (path for path, _ in own_files(plan.own_packages))
    files = (*manifests, *cmake, *held, *(patch.path for each in sources for patch in each.patches))
    pages = (posixpath.normpath(posixpath.join(folder, page)) for folder in projects for page in _PAGES)
    command = line_of(plan.run.command).split()
    named = () if command[:1] in (["roslaunch"], ["rosrun"], ["ros2"]) else map(posixpath.normpath, command)
    started = [word for word in named if _FILE.fullmatch(word)]
    needed = {*python.manifests, *python.requirements, *conda, *folders, *files, *pages, *started}
    whole = plan.kind not in {"ros1", "ros2"} or any("/" not in path for path in manifests)
    return tuple(sorted(needed | {ROOT} if whole and not _lets_in(plan.ignore, (*cmake, *started)) else needed))


def _lets_in(lines: Sequence[str], files: Iterable[str]) -> bool:
    """Tell whether an ignore file itself leaves what is compiled or started in the build: it knows this program."""
    own = [path for path in files if path.endswith(_CODE)]
    return bool(own) and not any(keeps_out(lines, path) for path in own)


def _with_needed(lines: list[str], needed: tuple[str, ...]) -> list[str]:
    additions: dict[int, dict[str, None]] = {}
    patterns = _patterns(lines)
    total, compared = sum(map(len, patterns)), 0
    for path in needed:
        compared += total * len(path.split("/"))
        if compared > MAX_COMPARED:
            break
        folder = posixpath.dirname(path)
        # What lies beside a package.xml is needed, too, also where the author's list has that file alone
        beside = folder and posixpath.basename(path) == "package.xml"
        decisive = _excluding(patterns, lines, f"{folder}/{_NO_NAME}") if beside else None
        if decisive is None or _decisive([patterns[decisive]], folder) is None:
            decisive = _excluding(patterns, lines, path or _NO_NAME)
        if decisive is None or ALL in additions.get(decisive, ()):
            continue
        if path == ROOT:
            additions[decisive] = {ALL: None}
            continue
        # If a package's whole folder is excluded, include all of it again: its package.xml alone could not be built
        whole = folder and _decisive([patterns[decisive]], folder) is not None
        additions.setdefault(decisive, {})[f"!{_literal(folder if whole else path)}"] = None
    result = []
    for index, line in enumerate(lines):
        result.append(line)
        if index in additions:
            result += ["# roslab: the Dockerfile needs these", *additions[index]]
    return result


def _excluding(patterns: list[Parts], lines: Sequence[str], path: str) -> int | None:
    """Return the index of the line that excludes a path, ``None`` where none does or a later one includes it again."""
    decisive = _decisive(patterns, path)
    return None if decisive is None or lines[decisive].lstrip().startswith("!") else decisive


def _decisive(patterns: list[Parts], path: str) -> int | None:
    """Return the index of the last pattern that matches a path or a folder above it, ``None`` for none."""
    parts = path.split("/")
    return next((i for i in range(len(patterns) - 1, -1, -1) if _matches(patterns[i], parts)), None)


def _patterns(lines: Sequence[str]) -> list[Parts]:
    """Cut the lines into patterns, starting at the top and ending after ``MAX_JUDGED`` characters."""
    shorter = [re.sub(r"\*{3,}", "***", line) for line in lines]
    ends = accumulate(len(line) + 1 for line in shorter)
    return [_parts(line) for line, end in zip(shorter, ends, strict=True) if end <= MAX_JUDGED]


def _parts(line: str) -> Parts:
    """Split a line into patterns of path parts, as https://github.com/moby/patternmatcher does.

    No library does this: fnmatch has no ``**``, and pathspec follows git's rules, where a bare name matches anywhere.
    """
    text = line.strip()
    if not text or line.startswith("#"):
        return ()
    text = posixpath.normpath(text.removeprefix("!").strip()).lstrip("/")
    parts = [ANY_DEPTH if part == ANY_DEPTH else re.sub(r"\*+", "*", part) for part in text.split("/")]
    return tuple(part for index, part in enumerate(parts) if part != ANY_DEPTH or part not in parts[index - 1 : index])


@lru_cache(maxsize=MAX_JUDGED // 4)
def _part(pattern: str) -> re.Pattern[str]:
    # fnmatch has [!a] for Go's [^a] and [a] for its \\a; its expressions stay fast even for a malicious pattern
    pattern = re.sub(r"\\(.)", r"[\1]", pattern).replace("[^", "[!")
    return re.compile(fnmatch.translate(pattern))


def _matches(pattern: Parts, parts: list[str]) -> bool:
    reached = {0} if pattern else set()
    for part in pattern:
        if not reached:
            return False
        if part == ANY_DEPTH:
            reached = set(range(min(reached), len(parts) + 1))
        else:
            reached = {i + 1 for i in reached if i < len(parts) and _part(part).match(parts[i])}
    return any(reached)


def _literal(path: str) -> str:
    return re.sub(r"([\\*?\[])", r"\\\1", quote.checked(path))
