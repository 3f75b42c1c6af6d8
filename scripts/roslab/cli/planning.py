"""The plan that the options of a command ask for, and its warnings."""

from __future__ import annotations

import argparse

from roslab.cli.arguments import OVERRIDING
from roslab.config import Override, locate
from roslab.pipeline import Planned, plan_repository
from roslab.values.origin import Option, Place


def planned_of(options: argparse.Namespace, *, config_text: str | None = None) -> Planned:
    """Plan the repository that the options name; ``config_text`` is read in place of its roslab.yaml.

    Raises ``ConfigurationError``, ``NothingToBuildError`` or ``RefusedError``.
    """
    said = {option: getattr(options, key, None) for option, key in OVERRIDING.items()}
    overrides = tuple(
        Override(key=OVERRIDING[option], text=text, origin=Option(name=option))
        for option, text in said.items()
        if text is not None
    )
    if getattr(options, "slim", False):
        overrides += (Override(key="slim", text="true", origin=Option(name="--slim")),)
    return plan_repository(
        options.path or ".",
        branch=options.branch,
        config_file=named(options),
        overrides=overrides,
        config_text=config_text,
        locked=not getattr(options, "no_lock", False),
    )


def named(options: argparse.Namespace) -> locate.Named | None:
    """Return the roslab.yaml that the options name."""
    return locate.Named(path=options.config, origin=Option(name="--config")) if options.config else None


def warnings_of(planned: Planned) -> str:
    """Return the warnings, one per line, each with its place."""
    lines = []
    for warning in planned.decision.warnings:
        place = f"{Place(file=warning.file, line=warning.line)}: " if warning.file else ""
        lines.append(f"{place}warning: {warning.message}\n")
    return "".join(lines)
