"""Libraries that a page installs by apt from a source of its own: they are compiled where that source is no more."""

from __future__ import annotations

from roslab.config.model import Source
from roslab.plan.plan import Plan
from roslab.render import quote
from roslab.render.layers import secrets, shell


def run(plan: Plan, library: Source, commands: list[str], others: secrets.Secrets, *last: str) -> str:
    """Return one RUN of the commands that build a library, and of the ``last`` ones in any case.

    Of a library with packages it asks apt first whether it would install them, with apt's lists and login beside
    ``others``, which the commands themselves need.
    """
    if not library.instead:
        return shell.run(*commands, *last, secrets=others)
    apt = secrets.for_apt(plan)
    mounts = tuple(dict.fromkeys((*apt.mounts, *others.mounts)))
    both = secrets.Secrets(mounts=mounts, commands=(*apt.commands, *others.commands))
    return shell.run(*(_unless_packaged(library, commands) if commands else ()), *last, secrets=both)


def _unless_packaged(library: Source, commands: list[str]) -> tuple[str, str]:
    names = shell.words(library.instead)
    said = quote.shell(
        f"roslab: {library.name} is not compiled: apt has {' '.join(library.instead)} of a source that the page adds"
    )
    built = " \\\n && ".join(commands)
    asked = f"apt-get install --simulate --yes --no-install-recommends{names} >/dev/null"
    return "apt-get update", f"if {asked}; then echo {said}; else {built}; fi"
