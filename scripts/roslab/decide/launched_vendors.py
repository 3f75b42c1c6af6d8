"""Packages that the default command starts and that only a vendor's own package source and hardware bring."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.config.model import Config
from roslab.decide.decision import Warning_
from roslab.decide.reasons import warn
from roslab.evidence.facts import Evidence
from roslab.evidence.launch_file import LaunchFile
from roslab.knowledge.released import released
from roslab.knowledge.table import rows

MOST = 4
"""Most packages that are named."""


def lacking_vendors(
    evidence: Evidence, config: Config, launch: LaunchFile, ros_distro: str | None
) -> Iterator[Warning_]:
    """Yield a warning for each vendor whose packages the launch file starts, those that what it starts needs included.

    Not where the author chose the image, and not for packages of the tree or of the distribution. A clone that holds
    them is compiled with the vendor's other packages, which the image lacks as well.
    """
    if config.base.image:
        return
    there = {manifest.name for manifest in evidence.manifests} | released(ros_distro or "")
    asked = [each for each in (*launch.dependencies, *launch.reached) if each.namespace == "ros"]
    always = [each for each in asked if each.strength != "optional" and each.name not in there]
    told: dict[tuple[str, str], list[str]] = {}
    for row in rows("vendor_packages"):
        found = [each.name for each in always if each.name.startswith(row["begins"])]
        if found:
            told.setdefault((row["needs"], row["address"]), []).extend(found)
    for (needs, address), names in told.items():
        named = tuple(dict.fromkeys(names))
        listed = ", ".join(named[:MOST]) + (", …" if named[MOST:] else "")
        place = next(each for each in always if each.name == named[0])
        message = (
            f"the default command starts {listed}, which needs {needs}: the image has neither, and the command cannot "
            f"start without them; give an image that has them as `base.image` in roslab.yaml ({address})"
        )
        yield warn(message, place)
