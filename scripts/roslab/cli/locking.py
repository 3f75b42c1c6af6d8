"""``roslab lock`` and ``diff``: keep the versions of an image that was proved, and say what moved since."""

from __future__ import annotations

import argparse
import sys
import tempfile
from pathlib import Path

from roslab.cli.building import prove
from roslab.cli.planning import planned_of
from roslab.engine import docker as engine
from roslab.engine import registry
from roslab.errors import BuildError
from roslab.files import write_configuration
from roslab.lock import inventory, making
from roslab.pipeline import Planned, lock_file
from roslab.plan.lock import to_text


def lock(options: argparse.Namespace) -> int:
    """Prove the image of every platform again, and write what they are made of beside roslab.yaml."""
    options.no_lock = True  # an older lock says nothing of what this image holds
    planned = planned_of(options)
    engine.check()
    images = []
    for platform, name in _names(options, planned):
        inventory.inspect(name)
        with tempfile.TemporaryDirectory(prefix="roslab-") as folder:
            prove(planned, name, platform, "nothing is locked", Path(folder))
        engine.say(f"roslab: reading what {name} holds")
        images.append((platform, inventory.read(name, platform)))
    made = making.make(planned.plan, images)
    path = planned.repository.root / lock_file(planned.config)
    write_configuration(path, None, to_text(made))
    for machine in made.machines:
        pip = sum(len(environment.packages) for environment in machine.python)
        sys.stdout.write(f"{path.name}: {machine.platform}: {len(machine.apt)} packages of apt, {pip} of pip\n")
    return 0


def _names(options: argparse.Namespace, planned: Planned) -> list[tuple[str, str]]:
    """Return the platforms and the names that `roslab build` gave their images."""
    platforms = planned.plan.platforms if options.platforms else (engine.native_platform(),)
    name = f"{planned.plan.name}:{options.tag}"
    several = len(platforms) > 1
    return [(each, f"{name}-{each.rpartition('/')[2]}" if several else name) for each in platforms]


def diff(options: argparse.Namespace) -> int:
    """Print what moved from one image to another."""
    from roslab.lock import comparison  # noqa: PLC0415
    from roslab.render import moved  # noqa: PLC0415

    engine.check()
    platform = options.platform or engine.native_platform()
    old, new = (_read(reference, platform) for reference in (options.old, options.new))
    found = comparison.compare(comparison.contents(old), comparison.contents(new), sizes=(old.size, new.size))
    sys.stdout.write(moved.to_json(found) if options.format == "json" else moved.text(found))
    return 0


def _read(reference: str, platform: str) -> inventory.Inventory:
    """Read what an image holds; one that the engine has not is pulled."""
    try:
        inventory.inspect(reference)
    except BuildError:
        registry.pull(reference, platform)
    return inventory.read(reference, platform)
