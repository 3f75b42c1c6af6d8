"""The short fields of a plan that other jobs read: a few kilobytes, however large the repository is."""

from __future__ import annotations

from typing import Any

from roslab.plan.plan import Plan

LONGEST = 4_000
"""Characters of a command; a longer one is cut."""


def answers(plan: Plan) -> dict[str, Any]:
    """Return the plan's short fields under their own names, and the lengths of its lists.

    Lists that grow with the repository (manifests, packages, reasons) are counted only: all outputs of a job together
    may have 1 MiB as UTF-16, and the job fails above it.
    https://docs.github.com/en/actions/reference/workflows-and-actions/workflow-syntax#jobsjob_idoutputs
    """
    command = plan.run.command
    long = len(command if isinstance(command, str) else " ".join(command)) > LONGEST
    author = plan.author_dockerfile
    return {
        "version": plan.version,
        "name": plan.name,
        "kind": plan.kind,
        "ros_distro": plan.ros_distro,
        "ubuntu": plan.ubuntu,
        "base_image": plan.base_image,
        "build_tool": plan.build_tool,
        "dockerfile": author.dockerfile if author else None,
        "command": None if long else command,
        "platforms": plan.platforms,
        "platforms_refused": dict(plan.platforms_refused),
        "counts": {
            "packages": len(plan.rosdep.manifests) if plan.rosdep else 0,
            "rosdep": len(plan.rosdep_keys),
            "apt": len(plan.apt) + len(plan.apt_guessed),
            "pip": len(plan.python.pip) + len(plan.python.pip_guessed),
            "source": len(plan.libraries) + len(plan.workspace.sources),
            "warnings": len(plan.warnings),
        },
    }
