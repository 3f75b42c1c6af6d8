"""Which packages of ROS the steps of an author's Dockerfile build, also by way of scripts of the tree."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Sequence

from roslab.evidence.lex.dockerfile import Instruction
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

MAX_SIZE = 64 * 1024
MAX_SCRIPTS = 40
_TOOLS = pattern(
    r"\bcolcon[ \t][^;&|\n]{0,300}\bbuild\b|\bcatkin_make\w*|\bcatkin[ \t](?:[^;&|\n]{0,300}[ \t])?(?:build|b|bt)\b"
    r"|\brosmake\b|\bament[ \t]+build\b"
)
_CALL = pattern(r"[^;&|\n]*")
UNREAD = pattern(
    r"\b(?:just|bazel|ansible\w*|nix\w*|pixi|bloom\w*|dpkg-buildpackage|debuild|rosinstall_generator|tox|nox|scons|waf)\b"
    r"|\|[ \t]*(?:sudo[ \t]+)?(?:ba|z|da)?sh\b|<\(",
)
"""What may build anything by files that are not read here, or runs what it fetches."""
_SELECTED = pattern(r"--packages-select((?:[ \t]+[^-\s;&|]\S*)+)")
_SCRIPT = pattern(r"(?<![^\s\"'=;&|()<>,\[\]])[^\s\"'=;&|()<>,\[\]]+\.(?:sh|bash|zsh|py)\b|(?<![\w.])\./[\w./-]+")
_SETUP = pattern(r"(?:^|/)(?:local_)?setup\.(?:ba|z)?sh$")
"""What only makes a workspace known that is there."""
_COMPILES = pattern(r"\b(?:cmake|pip[\d.]*|setup\.py)\b")
_MAKE = pattern(r"\bmake\b")
_COMMENT = pattern(r"(?m)^[ \t]*#.*$")
_CONTINUED = pattern(r"\\[ \t]*\n")
_RUNS = frozenset({"RUN", "CMD", "ENTRYPOINT"})


def built(repository: Repository, written: Sequence[Instruction]) -> tuple[str, ...] | None:
    """Return the names and the folders of the packages that may be built, ``None`` where it may be any of them.

    Without a tool that builds workspaces it is a package whose folder a step names, and the one at the root, beside
    CMake or pip.
    """
    if not (manifests := repository.named("package.xml")):
        return None
    texts = texts_of(repository, written)
    if texts is None or any(map(UNREAD.search, texts)):
        return None
    calls = [call for text in texts for call in tools(text)]
    if any(map(_MAKE.search, texts)):
        calls += [call for file in repository.named("Makefile", "makefile") for call in tools(repository.read(file))]
    selected = [match[1].split() if (match := _SELECTED.search(call)) else None for call in calls]
    if None in selected or any("$" in name for names in selected for name in names or ()):
        return None
    everything = "\n".join((*texts, *(each.text for each in written if each.name not in {*_RUNS, "FROM", "LABEL"})))
    folders = [file.folder for file in manifests] if any(map(_COMPILES.search, texts)) else []
    named = (folder for folder in folders if not folder or _names(everything, posixpath.basename(folder)))
    return tuple(dict.fromkeys((*(name for names in selected for name in names or ()), *named)))


def texts_of(repository: Repository, written: Sequence[Instruction]) -> list[str] | None:
    """Return what steps run with the texts of scripts of the tree that they run, ``None`` where one is not there."""
    found, seen = [step(each) for each in written if each.name in _RUNS], set[str]()
    for text in found:
        for name in _SCRIPT.findall(text):
            base = posixpath.basename(name)
            if _SETUP.search(name) or base in seen:
                continue
            seen.add(base)
            scripts = [file for file in repository.named(base) if file.size <= MAX_SIZE]
            if not scripts or len(seen) > MAX_SCRIPTS:
                return None
            if base != "setup.py":
                found += [_plain(repository.read(file)) for file in scripts]
    return found


def step(instruction: Instruction) -> str:
    """Return what a step runs, each command on a line, without comments."""
    text = _plain(instruction.text)
    return text if instruction.script else text.replace("\n", " ")


def _plain(text: str) -> str:
    return _COMMENT.sub("", _CONTINUED.sub(" ", text))


def tools(text: str) -> list[str]:
    """Return the calls of tools that build a workspace, each to its end."""
    found: list[str] = []
    end = 0
    for match in _TOOLS.finditer(text):
        if match.start() >= end and (call := _CALL.match(text, match.start())):
            end = call.end()
            found.append(call[0])
    return found


def _names(text: str, word: str) -> bool:
    return bool(re.search(rf"(?<![\w-]){re.escape(word)}(?![\w-])", text))
