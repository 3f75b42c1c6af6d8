"""Patches that the repository holds, and that its author applies to what is cloned."""

from __future__ import annotations

import posixpath
import shlex
from collections.abc import Iterable, Iterator, Sequence
from fnmatch import fnmatchcase

from roslab.evidence import places
from roslab.evidence.facts import AuthorDockerfile, Mention
from roslab.evidence.lex.shell import UNKNOWN, Command
from roslab.evidence.patch import Patch
from roslab.repository.checkout import File, Repository
from roslab.values.pattern import pattern

MAX_SIZE = 1024 * 1024
MOST = 200
"""Most files of one patch that are looked at."""
_KEPT = pattern(r"-p\d+|--ignore-(?:whitespace|space-change)|--whitespace=\w+|-3|--3way|-l|-F\d+|-N|--forward")
"""Options that change how a patch is applied, and to no other place."""
_GIT_VALUED = frozenset({"--directory", "--exclude", "--include", "-C", "--build-fake-ancestor"})
_NO_CHANGE = frozenset({"--check", "--stat", "--numstat", "--summary", "--dry-run", "-R", "--reverse", "--abort", "-v"})
"""With these nothing is applied, or what was applied is taken back. ``-v`` is for ``patch --version``."""
_VALUED = {"-d": "-d", "--directory": "-d", "-i": "-i", "--input": "-i", "-p": "-p", "--strip": "-p"}
"""Options of ``patch`` with a value: the folder, the file, and how many folders of the paths are left out."""
_TOUCHED = pattern(r"(?m)^\+\+\+ (?:[ab]/)?([^\t\n]+)")


def called(command: Command, folder: str) -> Iterator[str]:
    """Yield what a command applies, as words: where, whether it must, the program with its options, ``--``, the files.

    ``folder`` is where the text is by then. https://git-scm.com/docs/git-apply, https://git-scm.com/docs/git-am and
    https://www.gnu.org/software/diffutils/manual/html_node/patch-Options.html, 2026-11-27.
    """
    words = command.words
    program = words[0].rpartition("/")[2]
    if _NO_CHANGE & {*words} or program not in {"git", "patch"}:
        return
    there, start, files = _of_git(words, folder) if program == "git" else _of_patch(words, folder)
    files = [file for file in files or [command.given] if file and UNKNOWN not in file]
    if start and files and UNKNOWN not in there:
        yield shlex.join((there or ".", "may" if command.may_fail else "must", *start, "--", *files))


def _of_git(words: Sequence[str], folder: str) -> tuple[str, list[str], list[str]]:
    """Return where a call of git applies a patch, the call without files, ``[]`` for another one, and the files."""
    if words[1:2] == ("-C",) and len(words) > 3:
        folder, words = _within(folder, words[2]), (words[0], *words[3:])
    if words[1:2] not in {("apply",), ("am",)} or _GIT_VALUED & {word.partition("=")[0] for word in words}:
        return folder, [], []
    kept = [word for word in words if _KEPT.fullmatch(word)]
    return folder, ["git", "apply", *kept], [word for word in words[2:] if not word.startswith("-")]


def _of_patch(words: Sequence[str], folder: str) -> tuple[str, list[str], list[str]]:
    """Return the same of a call of ``patch``; what is given a file to change is another one."""
    given: dict[str, str] = {}
    kept: list[str] = []
    rest = iter(words[1:])
    for word in rest:
        name, _, value = word.partition("=")
        if name in _VALUED:
            given[_VALUED[name]] = value or next(rest, "")
        elif word[:2] in _VALUED:
            given[word[:2]] = word[2:]
        elif not word.startswith("-"):
            return folder, [], []
        else:
            kept += [word] if _KEPT.fullmatch(word) else []
    strip = [f"-p{given['-p']}"] if given.get("-p", "").isdigit() else []
    there = _within(folder, given["-d"]) if given.get("-d") else folder
    return there, ["patch", *strip, *kept], [given["-i"]] if "-i" in given else []


def read(repository: Repository, said: Iterable[Mention], dockerfiles: Iterable[AuthorDockerfile]) -> tuple[Patch, ...]:
    """Return each patch of the tree that something else than the repository itself is changed by, once.

    Where the author's Dockerfile applies it, the build stops as that one's does; pages and scripts go on.
    """
    own = (each for docker in dockerfiles if docker.purpose == "project" for each in docker.patches)
    authored = [each for each in own if each.topic == "patched"]
    pages = (each for each in said if each.topic == "patched" and each.source in {"readme", "script"})
    found: dict[tuple[str, str], Patch] = {}
    for mention in (*authored, *pages):
        if not places.vendored(mention.file):
            for patch in _patches(mention, repository):
                found.setdefault((patch.path, patch.folder), patch)
    folders = {patch.path for patch in found.values() if patch.folder}
    return tuple(patch for patch in found.values() if patch.folder or patch.path not in folders)


def _patches(mention: Mention, repository: Repository) -> Iterator[Patch]:
    folder, must, *rest = shlex.split(mention.value)
    end = rest.index("--")
    for word in rest[end + 1 :]:
        for file in _of_tree(word, folder, mention, repository):
            touched = _TOUCHED.findall(repository.read(file, limit=MAX_SIZE))[:MOST]
            if not any(repository.has(path) for path in touched):
                yield Patch(
                    path=file.path,
                    folder="" if folder == "." else folder,
                    command=tuple(rest[:end]),
                    stops=must == "must" and mention.source == "dockerfile",
                    touches=tuple(touched),
                    file=mention.file,
                    line=mention.line,
                )


def _of_tree(word: str, folder: str, mention: Mention, repository: Repository) -> list[File]:
    """Return the files of the tree that a path means: by as much of its end as there is, else the one of its name."""
    parts = [part for part in posixpath.normpath(word).split("/") if part not in {"", "..", "~", "."}]
    ends = ["/".join(parts[start:]) for start in range(len(parts))]
    if "*" in word:
        near = [each for each in repository.files if fnmatchcase(posixpath.basename(each.path), parts[-1])]
        matches = ([each for each in near if fnmatchcase(each.path, end)] for end in ends)
        return next((sorted(each, key=lambda file: file.path) for each in matches if each), [])
    named = repository.named(parts[-1]) if parts else ()
    beside = posixpath.normpath(posixpath.join(posixpath.dirname(mention.file), word))
    for end in (beside, posixpath.normpath(posixpath.join(folder, word)), *ends):
        if found := [each for each in named if each.path == end]:
            return found
    return [*named] if len(named) == 1 else []


def _within(folder: str, target: str) -> str:
    return (
        target.strip("/") if target.startswith(("/", "~", "$")) else posixpath.normpath(posixpath.join(folder, target))
    )
