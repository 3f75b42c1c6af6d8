"""What an argument of the command line must be; what it is not is said with what to give instead."""

from __future__ import annotations

import argparse

from roslab.values.pattern import pattern

MOST_ROUNDS = 20
"""It keeps a typing error from building all night."""
_TAG = pattern(r"[A-Za-z0-9_][A-Za-z0-9_.-]{0,127}")


def rounds(text: str) -> int:
    """Return how many repairs a build may have."""
    if not text.isdigit() or not 0 < int(text) <= MOST_ROUNDS:
        raise argparse.ArgumentTypeError(f"{text!r} is no number from 1 to {MOST_ROUNDS}")
    return int(text)


def folder(path: str) -> str:
    """Return a path that is given; an empty one is mostly a variable of the shell that is not set."""
    if not path:
        raise argparse.ArgumentTypeError("it is empty: give a folder, or leave it out for this one")
    return path


def log(path: str) -> str:
    """Return the path of a log that is given."""
    if not path:
        raise argparse.ArgumentTypeError("it is empty: give the file of the log, or - for standard input")
    return path


def tag(text: str) -> str:
    """Return the tag; https://github.com/opencontainers/distribution-spec/blob/main/spec.md#pulling-manifests."""
    if not _TAG.fullmatch(text):
        name, _, given = text.rpartition(":")
        instead = (
            f": the name of the image is roslab.yaml's, so give --tag {given}" if name and _TAG.fullmatch(given) else ""
        )
        raise argparse.ArgumentTypeError(
            f"{text!r} is no tag (letters, digits, '_', '.' and '-', at most 128, none of '.' and '-' first){instead}"
        )
    return text
