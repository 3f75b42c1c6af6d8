"""Scripts of the tree that a page runs to compile something: found in the tree, and read before they are believed."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator

from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import Mention
from roslab.evidence.prose.started_in import ends
from roslab.evidence.python.install_lines import builds_in_place
from roslab.knowledge.compiled import programs
from roslab.repository.checkout import Repository
from roslab.values.dataclass import replace
from roslab.values.endings import SHELL_SCRIPTS
from roslab.values.pattern import pattern
from roslab.values.python_options import program_of_python

MAX_SIZE = 64 * 1024
MAX_CALL = 500
"""Most characters of a call of Python that are read."""
_COMPILES = pattern(r"\b(?:c?make|ninja|gcc|clang|nvcc|cython|setup\.py|build_ext)\b|\bg\+\+(?!\w)")
_OF_PYTHON = pattern(
    r"^[^\n#\"']*\b(?:setup|Extension|\w+Extension|cythonize|FFI|build_ext)\(|"
    r"^[ \t]*(?:import|from)[ \t]+(?:torch\.utils\.cpp_extension|torch\.utils[ \t]+import[ \t]+cpp_extension)\b|"
    r"\b(?:os\.system|subprocess\.\w+|check_call|check_output|Popen|run)\(\s*(?:\[\s*)?[rf]{0,2}[\"'][^\"'\n]*?"
    r"(?<![\w./-])(?:c?make|ninja|gcc|g\+\+|clang(?:\+\+)?|nvcc|cython)(?=[ \"'])",
    re.MULTILINE,
)
"""What a script of Python compiles with; the word ``make`` is in every other one."""
_BY_NAME = frozenset({"build.py", "compile.py", "make.py"})
_COMPILER = pattern(r"(?:=|\s|/)(clang)(?:\+\+)?(?=[\s\"'}]|$)", re.MULTILINE)
_TERMINAL = pattern(r"^[ \t]*(x-terminal-emulator|xterm)[ \t]", re.MULTILINE)
_PYTHON = pattern(
    r"^[ \t]*(?:(?:exec|time|nohup|CUDA_VISIBLE_DEVICES=\S+|srun)[ \t]+)*python[\d.]*[ \t]+"
    r"(?!-c\b|(?:-m[ \t]+)?(?:pip|pytest|unittest|nose)\b|(?:\S*/)?setup\.py\b)[\w./$-]",
    re.MULTILINE,
)
"""A line that starts a program of Python, which is no test of the code and installs nothing."""
_ASKS = pattern(
    r"\b(?:sudo|apt|apt-get|yum|dnf|brew|docker|conda|mamba|catkin\w*|colcon|rosdep|roslaunch|wget|curl|gdown|scp|"
    r"xcodebuild|emcc|idf\.py)\b|\bread\s+-|\binput\(|rm\s+-rf?\s+[/~]"
)
"""What a script must not do: ask for privileges or for an answer, fetch, or build something else than a library."""
_APT = pattern(
    r"^[ \t]*(?:sudo[ \t]+)?apt(?:-get)?[ \t]+(?:-\S+[ \t]+){0,4}(?:update|upgrade|install)"
    r"(?:[ \t]+[\w.+:=~-]+)*[ \t]*$",
    re.MULTILINE,
)
"""A line that only installs packages, which are read elsewhere."""
BY_APT = "apt"
"""What such a script calls besides: the image has its packages."""


def checked(mention: Mention, repository: Repository) -> Iterator[Mention]:
    """Yield a script that a page runs, its folder and its words from the root; nothing for one that does more.

    One that is not in the tree may lie in a submodule: it is yielded without a file.
    """
    folder, script, *words = mention.value.split()
    for start in (*ends("" if folder == "." else folder), *_below(folder, script, words, repository)):
        path = posixpath.normpath(posixpath.join(start, script))
        if not repository.has(path):
            continue
        text = repository.read(path, limit=MAX_SIZE)
        rest = _APT.sub("", text) if script.endswith(SHELL_SCRIPTS) else text
        if (builds_in_place((script, *words)) or _compiles(path, text)) and not _ASKS.search(rest):
            inside = BY_APT if rest != text else ""
            yield replace(mention, value=" ".join((start or ".", script, *words)), files=(path,), inside=inside)
        return
    yield mention


def _compiles(path: str, text: str) -> bool:
    """Tell whether a script compiles something: one of Python, unless its whole name says so, shows it by its calls."""
    of_python = path.endswith(".py") and posixpath.basename(path) not in _BY_NAME
    return bool((_OF_PYTHON if of_python else _COMPILES).search(text))


def _below(folder: str, script: str, words: list[str], repository: Repository) -> Iterator[str]:
    """Yield the only folder of that name with this setup.py: a page may go there from a variable, ``$ROOT/nms``."""
    if folder == "." or not builds_in_place((script, *words)):
        return
    end = f"/{posixpath.normpath(posixpath.join(folder, script))}"
    found = [file.path for file in repository.named("setup.py") if f"/{file.path}".endswith(end)]
    if len(found) == 1:
        yield found[0].removesuffix(f"/{script}")


def called(mention: Mention, repository: Repository) -> Iterator[Dependency]:
    """Yield what a script calls that a page runs: a compiler that is not every image's, a terminal for a program."""
    wanted = {"build_script": _COMPILER, "command": _TERMINAL}.get(mention.topic)
    script = next((file for file in mention.files if wanted and file.endswith((".sh", ".py", ".bash"))), None)
    match = wanted.search(repository.read(script, limit=MAX_SIZE)) if wanted and script else None
    if match:
        name = programs().get(match[1], match[1])
        yield Dependency(
            namespace="apt", name=name, strength="used", file=mention.file, line=mention.line, role="script"
        )


def of_python(mention: Mention, repository: Repository) -> Iterator[Mention]:
    """Yield the shell script that a command of a page runs, if it starts a program of Python, with that program."""
    script = next((file for file in mention.files[:1] if file.endswith(SHELL_SCRIPTS)), None)
    text = repository.read(script, limit=MAX_SIZE) if script else ""
    if script and (match := _PYTHON.search(text)):
        yield replace(mention, topic="runs", value=script, files=(script, *_started(text, match, script, repository)))


def _started(text: str, call: re.Match[str], script: str, repository: Repository) -> Iterator[str]:
    """Yield the file of the tree that a call of Python starts: from the root, or from the folder of its script."""
    line = text[call.start() : call.end() + MAX_CALL].replace("\\\n", " ").partition("\n")[0]
    words = line[line.index("python") :].split()
    program = [word for word in program_of_python(words)[0] if word != "-m"]
    for word in program[:1]:
        name = word if word.endswith(".py") else f"{word.replace('.', '/')}.py"
        paths = (posixpath.normpath(posixpath.join(folder, name)) for folder in ("", posixpath.dirname(script)))
        yield from [path for path in paths if repository.has(path)][:1]
