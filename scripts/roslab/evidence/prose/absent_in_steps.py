"""Steps of an author's Dockerfile that stop in a clean checkout: they need files of the context that the tree lacks."""

from __future__ import annotations

import posixpath
from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import pairwise

from roslab.evidence.lex.dockerfile import FROM, Instruction, argv, sources
from roslab.evidence.lex.shell import UNKNOWN, Command, commands, expand
from roslab.evidence.prose.stage import Start
from roslab.repository.checkout import Repository
from roslab.values.dataclass import dataclass, field, replace
from roslab.values.pattern import pattern

_BRANCHED = pattern(
    r"[;|]|(?:^|\s)\[{1,2}\s|\\\n\s*(?:if|for|while)\b|^\s*(?:if|for|while)\b|\btest\b|"
    r"--mount=(?!\S*\btype=(?:cache|secret|ssh|tmpfs)\b)"
)
"""A text in which a command that fails may stop nothing, or that has other files: only what ``&&`` joins is judged."""
_REMOVES = pattern(r"[ \t]*rm((?:[ \t]+-\S+)*)((?:[ \t]+[\w.][\w./-]*)+)[ \t]*(?:$|[;\n]|&&)")
_SHELLS = frozenset({"bash", "sh", "source", "."})
_PIP = pattern(r"^pip[\d.]*$")
_PYTHON = pattern(r"^python[\d.]*$")
_LISTS = {"pip": ("-r", "--requirement", "-c", "--constraint"), "vcs": ("--input",), "conda": ("-f", "--file")}
"""Options of a program that are followed by a file which it reads."""
_CONDA = frozenset({"conda", "mamba", "micromamba"})
_HARMLESS = frozenset(
    (
        *("apt", "apt-get", "apk", "yum", "dnf", "apt-key", "add-apt-repository", "pip", "conda", "rosdep", "cd"),
        *("mkdir", "rm", "chmod", "chown", "echo", "export", "set", "useradd", "adduser", "usermod", "groupadd", "ls"),
    )
)
"""Programs that make no file of the tree; what any other makes is not known."""
_FETCHES = frozenset({"download", "wheel", "export"})
"""What such a program is told to do where it writes files all the same."""
_ARCHIVE = pattern(r".*\.(?:tar|tar\.\w+|t[bgx]z\d?)")
_UNKNOWN = frozenset(f"*?[]{{}}~${UNKNOWN}")


@dataclass
class _Stage:
    """What is known of a stage so far."""

    workdir: str | None = "/"
    copies: list[tuple[str, str]] = field(default_factory=list)
    """Its folders that hold a folder of the context, and that one."""
    acted: list[tuple[str | None, tuple[str, ...]]] = field(default_factory=list)
    """The commands that may have made files, each with the folder in which it ran."""
    filled: list[str | None] = field(default_factory=list)
    """Its folders that get files of which nothing here tells the names, ``None`` where that may be any."""
    said: str = ""
    """All that its steps say."""


def stops_at_absent(
    repository: Repository,
    written: Sequence[Instruction],
    known: Mapping[str, str],
    context: str,
    *,
    copied: Sequence[tuple[str, int]],
    start: Start,
) -> str | None:
    """Return why a build of a clean checkout stops: a step reads or removes a file that this does not hold.

    ``written``: the instructions of the stages that are built, ``known``: the values of variables, ``context``: the
    build context, relative to the root, ``copied``: what it copies, with the lines, ``start``: its last stage.
    """
    last = copied[-1][1] if copied else 0
    in_copy = last and start.source and start.source == posixpath.normpath(start.workdir)
    removed = _removes_absent(repository, written, last) if in_copy else None
    return removed or _reads_absent(repository, written, known, context)


def _removes_absent(repository: Repository, written: Iterable[Instruction], copied: int) -> str | None:
    """Return why the first step after the copy of the whole repository, into the folder of the steps, stops.

    ``copied``: the line of the copy. ``rm -f`` takes what is not there as well.
    """
    step = next((each for each in written if each.name == "RUN" and each.line > copied), None)
    match = _REMOVES.match(step.text) if step else None
    if step is None or match is None or "f" in match[1]:
        return None
    names = (name.rstrip("/") for name in match[2].split())
    gone = next((name for name in names if not repository.may_have(name)), None)
    return f"line {step.line} removes {gone}, which the repository does not hold, and stops there" if gone else None


def _reads_absent(
    repository: Repository, written: Iterable[Instruction], known: Mapping[str, str], context: str
) -> str | None:
    """Return why a step stops that reads a file in a copied folder which this has not.

    Only where no step before it can have made the file.
    """
    stages: dict[str, _Stage] = {}
    now = _Stage()
    for each in written:
        if each.name == "FROM" and (match := FROM.match(expand(each.text.strip(), known))):
            before = stages.get(match[1].lower(), _Stage())
            now = replace(before, copies=[*before.copies], acted=[*before.acted], filled=[*before.filled])
            if match[2]:
                stages[match[2].lower()] = now
        elif each.name == "WORKDIR":
            now.workdir = _joined(now.workdir, expand(each.text.strip().strip("\"'"), known))
        elif each.name in {"COPY", "ADD"}:
            body = expand(each.text, known)
            now.copies += _copies(body, now.workdir, repository, context)
            now.filled += _filled(body, now.workdir, extracts=each.name == "ADD")
        elif each.name == "RUN":
            found = _stops(repository, each, known, now)
            if found:
                return f"line {found[1]} reads {found[0]}, which the repository does not hold, and stops there"
        now.said += f"{each.text}\n"
    return None


def _joined(folder: str | None, path: str) -> str | None:
    """Return a path from a folder on, ``None`` where a shell alone knows it."""
    if not _UNKNOWN.isdisjoint(path) or (folder is None and not path.startswith("/")):
        return None
    return posixpath.normpath(posixpath.join(folder or "/", path))


def _copies(body: str, workdir: str | None, repository: Repository, context: str) -> Iterator[tuple[str, str]]:
    folder = _into(body, workdir)
    for source in sources(body):
        where = _below(context, source)
        if folder is not None and where in repository.folders:
            yield folder, where


def _into(body: str, workdir: str | None) -> str | None:
    words = _words(body)
    return _joined(workdir, words[-1]) if words else None


def _words(body: str) -> tuple[str, ...]:
    return argv(body[body.index("[") :]) if "[" in body else tuple(w for w in body.split() if not w.startswith("--"))


def _filled(body: str, workdir: str | None, *, extracts: bool) -> Iterator[str | None]:
    """Yield the folder that gets files of another stage or image, of an address, or of an archive.

    https://docs.docker.com/reference/dockerfile/#adding-local-tar-archives, read 2026-11-28.
    """
    taken = sources(body)
    if len(taken) < len(_words(body)) - 1 or (extracts and any(map(_ARCHIVE.fullmatch, taken))):
        yield _into(body, workdir)


def _below(context: str, path: str) -> str:
    where = posixpath.normpath(f"{context}/{path}".strip("/"))
    return "" if where == "." else where


def _stops(
    repository: Repository, step: Instruction, known: Mapping[str, str], stage: _Stage
) -> tuple[str, int] | None:
    """Return the first absent file that a step reads, as it is written, with its line; add what the step does."""
    text = step.text
    if step.script or text.lstrip().startswith("["):
        stage.acted.append((None, ()))  # what several lines do, or a list of words, is not followed
        return None
    judged = bool(stage.copies) and not _BRANCHED.search(text)
    folder = stage.workdir
    for command in commands(step.steps, step.line, known):
        program = _program(command)
        for path in _read(program, command) if judged and not command.may_fail else ():
            name = posixpath.basename(path)
            if name in stage.said or text.count(name) > 1:
                continue
            if (at := _joined(folder, path)) and _lacks(repository, at, stage):
                return path, command.line
        if program in {"cd", "pushd"}:
            folder = _joined(folder, command.words[1]) if len(command.words) > 1 else None
        elif not _harmless(program, command) and (program not in _SHELLS or _of_tree(command, folder, stage)):
            stage.acted.append((folder, command.words))
    return None


def _harmless(program: str, command: Command) -> bool:
    return program in _HARMLESS and _FETCHES.isdisjoint(command.words)


def _program(command: Command) -> str:
    name = command.words[0].rpartition("/")[2] or command.words[0]
    if _PYTHON.match(name) and command.words[1:3] == ("-m", "pip"):
        return "pip"
    return "pip" if _PIP.match(name) else "conda" if name in _CONDA else name


def _read(program: str, command: Command) -> Iterator[str]:
    """Yield the files that a command must read, as they are written."""
    words = command.words
    plain = [word for word in words[1:] if not word.startswith("-")]
    if command.given:
        yield command.given
    if words[0].startswith("./"):
        yield words[0]
    if program in _SHELLS or (_PYTHON.match(program) and words[1:2] and words[1].endswith(".py")):
        yield from plain[:1]
    elif program == "chmod":
        yield from plain[1:]
    elif program in {"cp", "mv"}:
        yield from plain[:-1]
    options = () if "export" in words else _LISTS.get(program, ())
    for option, value in pairwise(words):
        if option in options:
            yield value
    for word in words:
        option, sign, value = word.partition("=")
        if sign and option in options:
            yield value


def _of_tree(command: Command, folder: str | None, stage: _Stage) -> bool:
    """Tell whether a shell may read a script in a copied folder: it may do anything."""
    script = next((word for word in command.words[1:] if not word.startswith("-")), "")
    return not script or (at := _joined(folder, script)) is None or any(_inside(at, copy) for copy, _ in stage.copies)


def _inside(path: str, folder: str) -> bool:
    return f"{path}/".startswith(f"{folder.rstrip('/')}/")


def _lacks(repository: Repository, path: str, stage: _Stage) -> bool:
    """Tell whether a copied folder has no file of this path, and no command can have made one there."""
    copies = [(folder, where) for folder, where in stage.copies if _inside(path, folder)]
    if any(each is None or _inside(path, each) for each in stage.filled):
        return False
    if not copies or any(_may_act(acted, folder) for acted in stage.acted for folder, _ in copies):
        return False
    held = [_below(where, posixpath.relpath(path, folder)) for folder, where in copies]
    above = any(posixpath.dirname(where) in repository.folders for where in held)
    return above and not any(repository.may_have(where) for where in held)


def _may_act(acted: tuple[str | None, Sequence[str]], folder: str) -> bool:
    """Tell whether a command may have made files in a folder: it ran there, or not known where, or names it."""
    ran, words = acted
    return ran is None or _inside(ran, folder) or any(folder in word for word in words)
