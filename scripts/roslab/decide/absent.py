"""Files that a command of a page names and that neither the tree nor a download of the page has."""

from __future__ import annotations

import itertools
import posixpath
from collections.abc import Collection, Iterable

from roslab.decide.candidate import Candidate, program_of
from roslab.decide.outputs import writes
from roslab.evidence.facts import Evidence
from roslab.values.pattern import pattern

_FILE = pattern(
    r"[\w./-]+\.(?:pth?|ckpt|pkl|onnx|h5|hdf5|np[yz]|tar|bin|safetensors|bag|db3|mcap|pcap|mp4|avi|mov|png|jpe?g|pcd|ply|"
    r"obj|stl|csv|json|txt|ya?ml|xml|zip|gz)",
)
"""A file of data, of weights or of settings; not what a shell fills in, ``data/*.png``."""


def absent(argv: tuple[str, ...], files: Collection[str], fetched: Iterable[str]) -> tuple[str, ...]:
    """Return the arguments that name such a file, with the option of each; ``fetched``: files and folders.

    What the program is told to write is none.
    """
    there = [posixpath.normpath(path) for path in fetched]
    found: list[str] = []
    for before, word in itertools.pairwise(argv):
        option, _, value = word.rpartition("=")
        named = option or (before if before.startswith("-") else "")
        path = posixpath.normpath(value)
        if not _FILE.fullmatch(value) or {value, path} & {*files} or writes(named) or word in program_of(argv):
            continue
        if not any(path == each or path.startswith(f"{each}/") for each in there):
            found += [word] if option or not named else [before, word]
    return tuple(found)


def brought_files(evidence: Evidence) -> set[str]:
    """Return the files and folders of the tree that pages download, and what they copy from other files."""
    fetched = {file for m in evidence.mentions if m.topic in {"fetched", "unpacked"} for file in m.files} - {"", "."}
    return fetched | {m.value for m in evidence.mentions if m.topic == "copied"}


def variant(first: Candidate, candidates: Iterable[Candidate]) -> Candidate:
    """Return the next command of a section that differs only in not naming an absent file, else the first itself.

    Or the next of the page that names one of the tree in its place.
    """
    if not first.absent or not (first.argv[0].startswith("python") or first.installed):
        return first
    others = {word for word in first.argv if word not in first.absent}
    for each in sorted(candidates, key=lambda c: c.line):
        same = (each.file, program_of(each.argv)) == (first.file, program_of(first.argv))
        if not same or each.line <= first.line or each.absent or each.cut:
            continue
        if (each.heading == first.heading and others <= {*each.argv}) or _in_its_place(first, each):
            return each
    return first


def _in_its_place(first: Candidate, other: Candidate) -> bool:
    """Tell whether a command has files of the tree in the places of the absent ones, and is the same otherwise."""
    pairs = tuple(itertools.zip_longest(first.argv, other.argv, fillvalue=""))
    return all(word == each or (word in first.absent and each in other.files) for word, each in pairs)
