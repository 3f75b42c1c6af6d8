"""Folders that the script of an author's ENTRYPOINT changes to, and that its image cannot have made."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from roslab.evidence.lex.dockerfile import Instruction
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

_CHANGES = pattern(
    r"(?:^|[;&|(\s])(?:cd|pushd)[ \t]+[\"']?((?:~|\$HOME|\$\{HOME\})?/[\w./-]{2,200})[\"']?[ \t]*(?=[;&\\\"']|$)"
)
_GUARDED = pattern(r"\|\||(?:^|\s)(?:-[de]|test|if|elif)[ \t]|(?:\]|\)\))[ \t]*&&")
"""A line that goes on where the folder is not there, or that may not change to it."""
_OPENS = pattern(
    r"(?:^|[;&|]|\b(?:then|do|else)[ \t])[ \t]*(?:if|case|while|until|for|select)(?=[ \t]|$)"
    r"|(?:^|[;&|]|\(\)|\bfunction[ \t]+[\w-]{1,80})[ \t]*\{(?=\s|$)"
)
_CLOSES = pattern(r"(?:^|[;&|])[ \t]*(?:fi|esac|done|\})(?=[\s;&|)<>]|$)")
"""The begin and the end of what runs under a condition, and of functions."""
_USUAL = frozenset(
    (
        *("app", "code", "data", "src", "work", "workspace", "workspaces", "ws", "build", "devel", "install", "share"),
        *("bin", "dev", "etc", "home", "lib", "media", "mnt", "opt", "root", "run", "srv", "tmp", "usr", "var"),
    )
)
"""Names of folders that a base image may have, or that any step may make."""
_OF_BASES = ("/opt/ros/", "/opt/conda", "/opt/nvidia/", "/usr/", "/etc/", "/var/", "/proc/", "/sys/")


def absent(
    repository: Repository, lines: Iterable[tuple[int, str]], written: Iterable[Instruction]
) -> Iterator[tuple[str, str, int]]:
    """Yield each such folder with the part of its path that neither the tree nor a step of the Dockerfile names.

    ``lines`` are those of the script with their numbers; what another line of it names it may make itself.
    """
    lines = tuple(lines)
    others = (text for _, text in lines if not _CHANGES.search(text))
    said = "\n".join((*(each.text for each in written), *others))
    names = {part for folder in repository.folders for part in folder.split("/")}
    told: set[str] = set()
    for number, line in _sure(lines):
        for match in _CHANGES.finditer(line) if "cd" in line or "pushd" in line else ():
            if match[1] in told or match[1].startswith(_OF_BASES):
                continue
            parts = [part for part in match[1].split("/")[1:] if part.strip(".") and part not in _USUAL | names]
            lost = next((part for part in parts if part not in said), None)
            if lost:
                told.add(match[1])
                yield match[1], lost, number


def _sure(lines: Iterable[tuple[int, str]]) -> Iterator[tuple[int, str]]:
    """Yield the lines that run in any case: of no condition, loop or function."""
    depth, goes_on = 0, False
    for number, line in lines:
        opened, guarded = len(_OPENS.findall(line)), goes_on or bool(_GUARDED.search(line))
        if not (depth or opened or guarded):
            yield number, line
        goes_on = guarded and line.rstrip().endswith(("\\", "&&", "||"))
        depth = max(0, depth + opened - len(_CLOSES.findall(line)))
