"""The ``slim`` image: what runs, out of the whole image, and nothing that only building needs."""

from __future__ import annotations

import re
from collections.abc import Sequence

from roslab.plan.plan import SLIM, Plan
from roslab.render import quote
from roslab.render.layers import final, shell, workspace
from roslab.values.pattern import pattern

IMAGE = "image"
"""Name of the stage of the whole image."""
_ENV = pattern(r"^ENV (?:.*\\\n)*.*$", re.MULTILINE)


def stages(plan: Plan, chain: Sequence[str]) -> list[str]:
    """Return the stages of the slim image and, last, the whole image, which a build without a target makes.

    ``chain`` are the stages that the whole image consists of. A layer cannot take out what one below it brought, so
    that the slim image starts from nothing, with the variables of these stages.
    """
    skip = " ".join(plan.rosdep.skip_keys) if plan.rosdep else ""
    folders = workspace.rosdep_folders(plan) if plan.rosdep else []
    pruned = [
        f"# Without what only building needs\nFROM {IMAGE} AS pruned\nUSER root",
        shell.copy_script(final.ENTRY_POINT)
        + shell.call(
            "keep-what-runs",
            (f" --skip {quote.shell(skip)}" if skip else "") + "".join(f" {folder}" for folder in folders),
            comment="",
        ),
    ]
    variables = dict.fromkeys(line for stage in chain for line in _ENV.findall(stage))
    if plan.ros_distro and not any("ENV ROS_DISTRO=" in line for line in variables):
        variables[f"ENV ROS_DISTRO={quote.docker(plan.ros_distro)}"] = None
    slim = [
        f"FROM scratch AS {SLIM}\nCOPY --from=pruned / /",
        "ARG NB_USER=jovyan\nARG NB_UID=1000",
        *variables,
        final.command(plan, entry_point=True),
    ]
    return ["\n".join(pruned), "\n".join(slim), f"# What a build without --target makes\nFROM {IMAGE}"]
