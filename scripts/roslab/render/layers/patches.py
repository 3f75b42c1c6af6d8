"""Patches of the repository that are applied to what is cloned."""

from __future__ import annotations

from roslab.config.model import Patch, Source
from roslab.render import quote
from roslab.render.layers import shell
from roslab.render.layers.secrets import NONE, Secrets

MOUNTED = "/tmp/patches"  # noqa: S108 - a folder of the image while it is built


def mounted(source: Source, others: Secrets = NONE) -> Secrets:
    """Return what a step mounts that applies a source's patches."""
    mounts = (f"--mount=type=bind,source={quote.checked(each.path)},target={_target(each)}" for each in source.patches)
    return Secrets(mounts=(*others.mounts, *mounts), commands=others.commands)


def applied(source: Source, folder: str) -> list[str]:
    """Return the commands that apply a source's patches in its already quoted folder."""
    commands = []
    for patch in source.patches:
        stops = " --stops" if patch.stops else ""
        below = quote.shell(f"/{patch.below}") if patch.below else ""
        commands.append(
            f"{shell.PATCH}{stops} {folder}{below} {_target(patch)} {' '.join(map(quote.shell, patch.command))}"
        )
    return commands


def _target(patch: Patch) -> str:
    return f"{MOUNTED}/{quote.checked(patch.path)}"
