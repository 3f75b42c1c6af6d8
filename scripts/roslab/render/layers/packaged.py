"""Libraries that a page installs by apt from a source of its own: they are compiled where that source is no more."""

from __future__ import annotations

from roslab.config.model import Source
from roslab.plan.plan import Plan
from roslab.render import quote
from roslab.render.layers import secrets, shell


def unless_packaged(library: Source, commands: list[str]) -> list[str]:
    """Return the commands that build a library as one that asks apt first whether it would install the packages."""
    if not library.instead or not commands:
        return commands
    names = shell.words(library.instead)
    said = quote.shell(f"roslab: {library.name} is not compiled: apt has{names} of a source that the page adds")
    built = " \\\n && ".join(commands)
    asked = f"apt-get install --simulate --yes --no-install-recommends{names} >/dev/null"
    return ["apt-get update", f"if {asked}; then echo {said}; else {built}; fi"]


def asking_apt(library: Source, plan: Plan, others: secrets.Secrets) -> secrets.Secrets:
    """Return what the step of these commands mounts: what they need themselves, and apt's lists and login."""
    if not library.instead:
        return others
    apt = secrets.for_apt(plan)
    mounts = dict.fromkeys((*apt.mounts, *others.mounts))
    return secrets.Secrets(mounts=tuple(mounts), commands=(*apt.commands, *others.commands))
