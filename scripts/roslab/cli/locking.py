"""``roslab lock`` and ``diff``: keep the versions of an image that was proved, and say what moved since."""

from __future__ import annotations

import argparse
import os
import sys
import tempfile
from collections.abc import Sequence
from pathlib import Path

from roslab.cli.building import prove
from roslab.cli.planning import planned_of
from roslab.engine import docker as engine
from roslab.engine import registry
from roslab.engine.secrets import of_environment
from roslab.errors import BuildError, ConfigurationError, Problem
from roslab.files import write_configuration
from roslab.lock import check as checking
from roslab.lock import comparison, inventory, making
from roslab.lock.materials import of_build
from roslab.pipeline import Planned, lock_file
from roslab.plan.lock import to_text, without
from roslab.plan.locked import Material
from roslab.plan.plan import Plan
from roslab.render import moved
from roslab.render.dockerfile import question
from roslab.values.dataclass import replace
from roslab.values.secret import APT_AUTH

NEAREST = "a build takes what is left; build, look whether it still proves, and run `roslab lock`"


def lock(options: argparse.Namespace) -> int:
    """Prove the image of every platform again, and write what they are made of beside roslab.yaml."""
    if options.check:
        return _check(options)
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
    made = making.make(planned.plan, images, _materials(planned, images[0][0]))
    path = planned.repository.root / lock_file(planned.config)
    write_configuration(path, None, to_text(made))
    for machine in made.machines:
        pip = sum(len(environment.packages) for environment in machine.python)
        sys.stdout.write(f"{path.name}: {machine.platform}: {len(machine.apt)} packages of apt, {pip} of pip\n")
    return 0


def _materials(planned: Planned, platform: str) -> tuple[Material, ...]:
    """Return what the build of the author's own Dockerfile took from elsewhere."""
    authored, root = planned.plan.author_dockerfile, planned.repository.root
    if authored is None:
        return ()
    job = engine.Build(
        context=root / authored.context,
        dockerfile=root / authored.dockerfile,
        platforms=(platform,),
        arguments=authored.args,
        target=authored.target,
        secrets=of_environment(planned.plan.secrets, os.environ),
    )
    return of_build(job)


def _check(options: argparse.Namespace) -> int:
    """Say what of roslab.lock could no longer be had."""
    planned = planned_of(options)
    if planned.plan.lock is None:
        hint = "build with `roslab build`, then run `roslab lock`"
        raise ConfigurationError(Problem(message=f"there is no {lock_file(planned.config)}", hint=hint))
    engine.check()
    problems = []
    for platform, _ in _names(options, planned):
        answer = _asked(planned.plan, platform)
        for said in answer.silent:
            engine.say(f"roslab: warning: {said}")
        problems += [Problem(message=f"{platform}: {each}", hint=NEAREST) for each in answer.missing]
    if problems:
        raise BuildError(*problems)
    sys.stdout.write(f"{lock_file(planned.config)}: everything it names can still be had\n")
    return 0


def available(planned: Planned, platforms: Sequence[str]) -> Planned:
    """Return what is planned without what its lock names and nobody has any more; each is told before the build."""
    plan = planned.plan
    if plan.lock is None or plan.author_dockerfile:
        return planned
    for platform in platforms:
        answer = _asked(plan, platform)
        for said in answer.silent:
            engine.say(f"roslab: warning: {said}")
        for each in answer.missing:
            engine.say(f"{lock_file(planned.config)}: warning: {each}")
        plan = without(plan, answer.missing)
    return replace(planned, plan=plan)


def _asked(plan: Plan, platform: str) -> checking.Answer:
    secrets = of_environment([name for name in plan.secrets if name == APT_AUTH], os.environ)
    return checking.check(plan, question(plan), platform, secrets)


def compared(planned: Planned, image: str, platform: str) -> None:
    """Say how much of an image is not as its lock has it."""
    machine = planned.plan.lock.machine(platform) if planned.plan.lock else None
    if machine is None:
        return
    found = comparison.compare(comparison.locked(machine), comparison.contents(inventory.read(image, platform)))
    engine.say(
        f"roslab: {len(found.moved)} of {found.packages} packages are not as {lock_file(planned.config)} has them"
    )
    for change in found.moved:
        engine.say(f"    {change.kind}: {moved.line(change)}")


def _names(options: argparse.Namespace, planned: Planned) -> list[tuple[str, str]]:
    """Return the platforms and the names that `roslab build` gave their images."""
    platforms = planned.plan.platforms if options.platforms else (engine.native_platform(),)
    name = f"{planned.plan.name}:{options.tag}"
    several = len(platforms) > 1
    return [(each, f"{name}-{each.rpartition('/')[2]}" if several else name) for each in platforms]


def diff(options: argparse.Namespace) -> int:
    """Print what moved from one image to another."""
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
