"""``roslab explain``: why a build failed, from its log, and with the repository what to write where."""

from __future__ import annotations

import argparse
import io
import sys
from pathlib import Path
from typing import IO

from roslab.cli.asking import asking
from roslab.cli.planning import planned_of
from roslab.cli.repairing import configuration, given, image
from roslab.config.addition import added
from roslab.engine.docker import check
from roslab.errors import BuildError, ConfigurationError, Problem
from roslab.explain import words
from roslab.explain.answer import Answer
from roslab.explain.answer import explain as explained
from roslab.files import write_configuration
from roslab.pipeline import Planned
from roslab.repair import dockerfile
from roslab.repair import words as repair_words
from roslab.repair.chain import NOBODY, proposed, unasked
from roslab.repair.change import Change, Repair
from roslab.repository.checkout import printable
from roslab.values.dataclass import replace

_PACKED = {b"PK\3\4": "zip", b"\x1f\x8b": "gzip", b"BZh": "bzip2", b"\xfd7zXZ\0": "xz", b"\x28\xb5\x2f\xfd": "zstd"}
"""How a file of a packing format begins, and the format."""


def explain(options: argparse.Namespace) -> int:
    """Print why a build failed; with a repository also who asked for what was missing, and the lines to paste."""
    try:
        if options.log == "-":
            answer = _explained(sys.stdin.buffer, options.log)
        else:
            with Path(options.log).open("rb") as stream:
                answer = _explained(stream, options.log)
    except OSError as error:
        hint = "the log, a file, comes first, then the repository: save it by `docker build . > LOG 2>&1`"
        message = f"cannot read {printable(options.log)}: {error.strerror}"
        raise ConfigurationError(Problem(message=message, hint=hint)) from None
    planned = planned_of(options) if options.path or options.apply or options.ask else None
    found = _proposed(answer, planned, options) if planned else Repair()
    if options.format == "json":
        sys.stdout.write(words.as_json(answer, repair_words.data(found) if planned else None))
    else:
        sys.stdout.write(words.text(answer, lines=planned is None))
        sys.stdout.write(_lines(answer, planned, found, options) if planned else _alone(answer))
    if options.apply and planned:
        _apply(options, planned, found)
    return 0


def _explained(stream: IO[bytes], log: str) -> Answer:
    """Return why a build failed; raise ``ConfigurationError`` for a log in an archive, as GitHub's page gives it."""
    begin = stream.peek(8) if isinstance(stream, io.BufferedReader) else b""
    if kind := next((kind for mark, kind in _PACKED.items() if begin.startswith(mark)), None):
        raise ConfigurationError(
            Problem(message=f"{log} is packed ({kind}): it cannot be read so", hint="unpack it first")
        )
    return explained(stream)


def _proposed(answer: Answer, planned: Planned, options: argparse.Namespace) -> Repair:
    if options.ask:
        check()
    found = proposed(answer, given(planned), asking=asking(planned, options) if options.ask else NOBODY)
    there = [change for change in found.changes if _planned_already(change, planned, options)]
    new = tuple(change for change in found.changes if change not in there)
    why = "{} is in the planned image already: the log is of another one, or it does not help"
    return replace(found, changes=new, refused=(*found.refused, *((one.failure, why.format(one)) for one in there)))


def _planned_already(change: Change, planned: Planned, options: argparse.Namespace) -> bool:
    """Return whether the image is planned with what a change would add."""
    if planned.plan.author_dockerfile or change.key == "submodules":
        return False
    file, old = configuration(planned, options)
    try:
        changed = planned_of(options, config_text=added(old, [change.entry], file=file))
    except ConfigurationError:  # nothing is added to an old format
        return False
    return image(changed) == image(planned)


def _alone(answer: Answer) -> str:
    """Return what the log alone says to change in the author's own Dockerfile."""
    lines = dockerfile.suggested(answer).splitlines(keepends=True)
    return "".join(["in the Dockerfile:\n", *(f"  {line}" for line in lines)]) if lines else ""


def _lines(answer: Answer, planned: Planned, found: Repair, options: argparse.Namespace) -> str:
    """Return the lines to paste, or the diff of the author's own Dockerfile."""
    if author := planned.plan.author_dockerfile:
        text = planned.repository.read(author.dockerfile)
        changes = dockerfile.edits(answer, text)
        own = dockerfile.diff(author.dockerfile, text, changes) if changes else ""
        return own + repair_words.text(replace(found, changes=()), begin=configuration(planned, options)[1] is None)
    said = repair_words.text(found, begin=configuration(planned, options)[1] is None)
    fixes = {one.fix for one in answer.explanations}
    said += "".join(f"nothing to add: {why}\n" for _, why in found.refused if why not in fixes)
    if options.ask:
        return said
    return said + "".join(f"--ask asks {each}\n" for each in unasked(found, answer, given(planned)))


def _apply(options: argparse.Namespace, planned: Planned, found: Repair) -> None:
    """Show what the certain changes of a repair change in roslab.yaml, and write it."""
    changes = found.certain
    if author := planned.plan.author_dockerfile:
        raise BuildError(
            Problem(
                message=f"nothing is written: the image is built from {author.dockerfile}, not from lists",
                hint="make the repair there: what is certain stands above as a diff",
            )
        )
    if not changes.changes:
        maybe = [f"it may need {change.told}" for change in found.changes]
        refused = [reason for _, reason in found.refused]
        why = "; ".join([*maybe, *refused, *map(repair_words.without, found.left)])
        raise BuildError(
            Problem(
                message="nothing is written: no cause here has lines for roslab.yaml that are certain", hint=why or None
            )
        )
    file, old = configuration(planned, options)
    new = added(old, changes.entries, file=file)
    sys.stderr.write(repair_words.diff(old, changes, file))
    path = planned.repository.root / file
    write_configuration(path, old, new)
    kept = f"; the old one is {file}.old" if old is not None else ""
    sys.stderr.write(f"roslab: written to {printable(str(path))}{kept}\n")
