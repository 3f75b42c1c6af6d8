"""Which Python each pip list of roslab.yaml is for."""

from __future__ import annotations

from roslab.config.model import Config
from roslab.decide.decision import Warning_
from roslab.decide.reasons import warn
from roslab.knowledge.on_request import packages
from roslab.values.dataclass import dataclass, replace
from roslab.values.requirement import Requirement
from roslab.values.requirement_line import stated


@dataclass(frozen=True, kw_only=True, slots=True)
class PipLists:
    """Requirements and options for the image's Python, and for a Python 2 beside it."""

    requirements: tuple[Requirement, ...]
    options: tuple[str, ...]
    python2: tuple[Requirement, ...] = ()
    python2_options: tuple[str, ...] = ()
    warnings: tuple[Warning_, ...] = ()


def pip_lists(config: Config, ubuntu: str | None, number: str | None) -> PipLists:
    """Return both lists; ``number`` is the version of the image's own Python, if it has one.

    Without Python 2 its packages go to the image's Python, with a warning.
    """
    pip, pip3 = _read(config, "pip", config.pip), _read(config, "pip3", config.pip3)
    together = PipLists(requirements=(*pip3, *pip), options=(*config.pip3_options, *config.pip_options))
    if config.pip_python != "2" or not config.pip or (number or "").startswith("2"):
        return together
    if packages("python2", ubuntu):
        return PipLists(
            requirements=pip3,
            options=config.pip3_options,
            python2=pip,
            python2_options=config.pip_options,
        )
    where = f"Ubuntu {ubuntu}" if ubuntu else "the base"
    warning = warn(
        f"{where} has no Python 2: these packages go to its Python 3 ({', '.join(config.pip[:3])} …); "
        "use `pip3`, or set `base.ubuntu` to jammy or older",
        config.origin("pip.0"),
    )
    return replace(together, warnings=(warning,))


def _read(config: Config, key: str, lines: tuple[str, ...]) -> tuple[Requirement, ...]:
    """Return the lines of one list, each with its place."""
    origins = [config.origin(f"{key}.{index}") for index in range(len(lines))]
    places = [(at.file if at else None, at.line if at else None) for at in origins]
    return tuple(
        stated(line, "configuration", file or config.file or "", number or 1)
        for line, (file, number) in zip(lines, places, strict=True)
    )
