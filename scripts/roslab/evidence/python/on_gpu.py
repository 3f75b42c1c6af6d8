"""Settings and code of nodes that compute on a GPU in any case: ``device: cuda``, where nothing asks for one first."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator

from roslab.evidence import places
from roslab.evidence.facts import Mention
from roslab.evidence.launch_file import LaunchFile
from roslab.evidence.python.modules import modules
from roslab.evidence.python.through_modules import of_tree
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

MAX_SIZE = 256 * 1024
MOST = 40
"""Most groups of programs of which the modules are followed."""
_SETTINGS = (".yaml", ".yml")
_SET = pattern(
    r"^[ \t]*[\"']?(?=\w*device)\w+[\"']?[ \t]*:[ \t]*[\"']?cuda(?::\d+)?[\"']?[ \t]*(?:#[^\n]*)?$", re.MULTILINE
)
_MOVES = pattern(
    r"^[^#\n]*(?:\.cuda\(\)|\.to\([ \t]*[\"']cuda|\btorch\.device\([ \t]*[\"']cuda|\bcuda\.synchronize\(\))",
    re.MULTILINE,
)
_BRANCH = pattern(r"\b(?:if|else|elif|try|except)\b")
_DEFAULT = pattern(r"\b(?:def|lambda)\b")
_ASKS = ("is_available", "device_count", "mem_get_info")
"""Calls by which code finds out whether there is a GPU."""
_NAME = pattern(r"(?<![\w.-])[\w.-]+\.ya?ml\b")


def read(repository: Repository, launched: Iterable[LaunchFile]) -> Iterator[Mention]:
    """Yield the first such line for each launch file that starts programs of Python; the value is the launch file."""
    nodes = [each for each in launched if any(path.endswith(".py") and path != each.file for path in each.loaded)]
    of_python = {module.file.path: module for module in modules(repository)} if nodes else {}
    settings = [file for file in repository.suffixed(*_SETTINGS) if nodes and file.size <= MAX_SIZE]
    texts = {file.path: repository.read(file) for file in settings}
    named = [path for path, text in texts.items() if "cuda" in text and _SET.search(text)]
    moving = [path for path, each in of_python.items() if "cuda" in each.text and not places.aside(path)]
    reached: dict[frozenset[str], frozenset[str]] = {}
    for each in nodes if named or moving else ():
        programs = frozenset(path for path in each.loaded if path in of_python and path != each.file)
        if programs not in reached and len(reached) < MOST:
            reached[programs] = programs | of_tree(repository).reached(programs)
        there = reached.get(programs, programs)
        if any(word in of_python[path].text for path in there for word in _ASKS):
            continue
        given = [path for path in named if path in each.loaded or _filled_in(path, each, repository)]
        at = next(_first(repository, [(path, _SET) for path in given]), None)
        at = at or next(_first(repository, [(path, _MOVES) for path in moving if path in there]), None)
        if programs and at:
            file, line, said = at
            yield Mention(topic="on_gpu", value=each.file, source="code", file=file, line=line, text=said)


def _filled_in(path: str, launch: LaunchFile, repository: Repository) -> bool:
    """Tell whether a launch file loads something of a folder, whose name it gives as an argument."""
    folder, _, name = path.rpartition("/")
    return folder in launch.loaded and name in _NAME.findall(repository.read(launch.file))


def _first(repository: Repository, files: Iterable[tuple[str, re.Pattern[str]]]) -> Iterator[tuple[str, int, str]]:
    for path, sought in files:
        text = repository.read(path)
        for match in sought.finditer(text):
            line = text.count("\n", 0, match.start()) + 1
            above = text.rfind("\n", 0, max(0, match.start() - 1)) + 1
            perhaps = _BRANCH.search(text[above : match.end()]) or _DEFAULT.search(match[0])
            if sought is _SET or not perhaps:
                yield path, line, match[0].strip()
