"""Packages that roslab.yaml leaves out of the build: ``skip_packages``."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from typing import TYPE_CHECKING

from roslab.config.model import BuildTool, Config
from roslab.decide.decision import Warning_
from roslab.decide.reasons import warn
from roslab.decide.ros.skipped import Skipped
from roslab.decide.ros.workspace import Packages
from roslab.decide.system.left_out import SKIP, needing
from roslab.values.origin import Place

if TYPE_CHECKING:
    from roslab.values.origin import Origin

KEY = "skip_packages"


def skip_packages(
    config: Config, packages: Packages, build_tool: BuildTool, started: Collection[str]
) -> tuple[Mapping[str, Skipped], tuple[Warning_, ...]]:
    """Return the packages that are not built, with those that cannot be built without them, and warnings.

    ``started``: the words of the default command.
    """
    if not config.skip_packages:
        return {}, ()
    if build_tool not in SKIP:
        hint = f"it is for {', '.join(SKIP)}; leave it out"
        return {}, (warn(f"`{KEY}` does nothing with {build_tool}: {hint}", config.origin(KEY)),)
    built = {manifest.name for manifest in packages.built}
    found: dict[str, Skipped] = {}
    warnings = []
    for index, name in enumerate(config.skip_packages):
        origin = config.origin(f"{KEY}.{index}") or config.origin(KEY)
        place = origin if isinstance(origin, Place) else Place(file=config.file or "roslab.yaml")
        found[name] = Skipped(place, f"`{KEY}` in {place.file} leaves it out")
        if name not in built:
            warnings.append(_unknown(name, build_tool, origin))
            continue
        for other in needing(name, packages)[1:]:
            found.setdefault(other, Skipped(place, f"it cannot be built without {name}, which `{KEY}` leaves out"))
    warnings += _started(found, {*started})
    if built and not {m.name for m in packages.built if not m.metapackage} - found.keys():
        warnings.append(warn(f"`{KEY}` leaves out every package of the repository", config.origin(KEY)))
    return found, tuple(warnings)


def _unknown(name: str, build_tool: BuildTool, origin: Origin | None) -> Warning_:
    by_name = f"{build_tool} leaves it out where a clone has it"
    by_marker = f"{build_tool} is told by markers in folders, and builds it where a clone has it"
    then = by_name if SKIP[build_tool] else by_marker
    return warn(f"`{KEY}` names {name}, which is no package of the repository that is built: {then}", origin)


def _started(found: Mapping[str, Skipped], started: Collection[str]) -> Iterator[Warning_]:
    for name in sorted(found.keys() & {*started}):
        yield warn(f"the default command starts {name}, which is not built: {found[name].why}", found[name].place)
