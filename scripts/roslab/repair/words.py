"""A repair as text: the lines to paste, and who asked for what was missing."""

from __future__ import annotations

import difflib
from collections.abc import Iterable
from typing import Any

from roslab.config.addition import added
from roslab.errors import ConfigurationError
from roslab.knowledge.repairs import SKIP
from roslab.repair import generated
from roslab.repair.change import Change, Repair


def lines(changes: Iterable[Change], *, begin: bool) -> str:
    """Return the lines to paste into a roslab.yaml; ``begin`` says that the repository has none yet."""
    new = added(None, [change.entry for change in changes])
    return new if begin else new.removeprefix("format: 3\n")


def diff(old: str | None, repair: Repair, file: str) -> str:
    """Return what a repair changes in roslab.yaml as a unified diff, ``""`` if nothing or if it cannot be edited.

    ``old`` is the text of the file, ``None`` if there is none yet.
    """
    try:
        new = added(old, repair.entries, file=file)
    except ConfigurationError:
        return ""
    changed = difflib.unified_diff((old or "").splitlines(True), new.splitlines(True), f"a/{file}", f"b/{file}")
    return "".join(line if line.endswith("\n") else f"{line}\n" for line in changed)


def data(repair: Repair) -> dict[str, Any]:
    """Return a repair for JSON: ``{"changes": [{key, value, …}], "left": […], "refused": {failure: reason}}``.

    ``left`` are changes that leave something out of the image, where nothing that is added is certain.
    """
    return {
        "changes": [_change(change) for change in repair.changes],
        "left": [{**_change(change), "why": change.why} for change in repair.left],
        "refused": dict(repair.refused),
    }


def _change(change: Change) -> dict[str, Any]:
    return {
        "key": change.key,
        "value": change.value,
        "instead": change.instead or None,
        "failure": change.failure,
        "certain": change.certain,
        "what": change.asked.what,
        "file": change.asked.place.file if change.asked.place else None,
        "line": change.asked.place.line if change.asked.place else None,
    }


def text(repair: Repair, *, begin: bool) -> str:
    """Return a repair for a person: each change with who asked for it, then the lines to paste.

    What would be left out comes with its price: ``roslab build`` tries it and looks at the image, nobody else can.
    """
    out = [f"{'adds' if change.certain else 'may need'} {change.told}" for change in repair.changes]
    if repair.changes:
        out += ["In roslab.yaml:", *(f"  {line}" for line in lines(repair.changes, begin=begin).splitlines())]
    out += [f"could be built {without(change)}" for change in repair.left]
    if repair.left:
        instead = any(change.key == generated.KEY for change in repair.left)
        out += ["In roslab.yaml:" if instead else "In roslab.yaml, if nothing that you start needs what is left out:"]
        out += [f"  {line}" for line in lines(repair.left, begin=begin).splitlines()]
    out += [f"nothing is left out: {repair.kept}"] if repair.kept else []
    return "".join(f"{line}\n" for line in out)


def without(change: Change) -> str:
    """Return what the image lacks with a change that leaves something out, and why it may."""
    if change.key == generated.KEY:
        return "from a Dockerfile that is generated"
    left = f"without {change.value}, which" if change.key == SKIP else f"with nothing but {change.value},"
    return f"{left} {change.why}"
