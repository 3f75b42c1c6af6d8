"""``roslab verify``: climbs the ladder of a published image again on this machine, and compares."""

from __future__ import annotations

import argparse
import json
import os
import sys
from pathlib import Path

from roslab.engine import docker as engine
from roslab.engine import gpu, registry
from roslab.errors import BuildError, Problem
from roslab.plan.ladder import lines, to_data
from roslab.plan.record import KEY, Record, difference, from_json


def verify(options: argparse.Namespace) -> int:
    """Print how far an image got here, and the first difference from what it carries; exit code 5 if there is one."""
    from roslab.prove import containers  # noqa: PLC0415
    from roslab.prove.ladder import climb  # noqa: PLC0415

    engine.check()
    known = _record(options.like or options.image)
    platform = options.platform or engine.native_platform()
    recorded = known.of(platform)
    if recorded is None:
        proved = ", ".join(name for name, _ in known.platforms)
        raise BuildError(Problem(message=f"{options.image} was not proved on {platform}", hint=f"it was on {proved}"))
    if KEY not in engine.labels_of(options.image):  # else it was built here
        registry.pull(options.image, platform)
    cache = os.environ.get("XDG_CACHE_HOME") or "~/.cache"
    outcomes = containers.prove(
        options.image,
        platform,
        known.proofs,
        limits=known.limits,
        goals=known.goals,
        screenshots=Path(os.path.expanduser(cache), "roslab", "verify"),  # noqa: PTH111
        gpus=known.gpu and bool(gpu.usable()),
    )
    seen = climb(known.proofs, outcomes, known.goals, gpu=known.gpu)
    found = difference(recorded, seen)
    if options.format == "json":
        said = {"platform": platform, "recorded": to_data(recorded), "seen": to_data(seen), "difference": found}
        sys.stdout.write(json.dumps(said, indent=2) + "\n")
    else:
        sys.stdout.write("".join(f"{line}\n" for line in lines(seen)))
        sys.stdout.write(f"first difference: {found}\n" if found else "the same rungs as were recorded\n")
    return BuildError.exit_code if found else 0


def _record(reference: str) -> Record:
    """Return the record that an image carries: its label if the engine has it, else its index's annotation."""
    text = engine.labels_of(reference).get(KEY) or registry.annotations_of(reference).get(KEY)
    if text is None:
        message = f"{reference} carries no record of a proof"
        hint = "name a tag or the index's digest, not a platform's; `--like IMAGE` takes another image's record"
        raise BuildError(Problem(message=message, hint=hint))
    return from_json(text)
