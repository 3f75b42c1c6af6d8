"""Which of roslab.yaml's pip lists goes to which Python."""

from __future__ import annotations

from dataclasses import dataclass

from roslab.config.model import Config
from roslab.decide.decision import Warning_
from roslab.decide.reasons import warn
from roslab.knowledge.on_request import packages


@dataclass(frozen=True, kw_only=True, slots=True)
class PipLists:
    """Requirement lines and options for the image's Python, and for a Python 2 beside it."""

    lines: tuple[str, ...]
    options: tuple[str, ...]
    python2: tuple[str, ...] = ()
    python2_options: tuple[str, ...] = ()
    warnings: tuple[Warning_, ...] = ()


def pip_lists(config: Config, ubuntu: str | None, number: str | None) -> PipLists:
    """Return both lists; ``number`` is the version of the image's Python where it has one of its own.

    Where there is no Python 2, its packages go to the image's Python, with a warning.
    """
    together = PipLists(lines=(*config.pip3, *config.pip), options=(*config.pip3_options, *config.pip_options))
    if config.pip_python != "2" or not config.pip or (number or "").startswith("2"):
        return together
    if packages("python2", ubuntu):
        return PipLists(
            lines=config.pip3,
            options=config.pip3_options,
            python2=config.pip,
            python2_options=config.pip_options,
        )
    where = f"Ubuntu {ubuntu}" if ubuntu else "the base"
    warning = warn(
        f"{where} has no Python 2: these packages go to its Python 3 ({', '.join(config.pip[:3])} …); "
        "write `pip3`, or a `base.ubuntu` up to jammy",
        config.origin("pip.0"),
    )
    return PipLists(lines=together.lines, options=together.options, warnings=(warning,))
