"""Compiled files that are kept from one build to the next, in the stage that compiles alone."""

from __future__ import annotations

from roslab.plan.plan import Plan
from roslab.render.layers import secrets, shell

WITH_CACHE = "with-ccache"
"""The script that compiles one file, or takes what an earlier build made of it."""
FOLDER = "/var/cache/roslab-build"
"""Where a cache holds the build tree of a workspace, and what ccache keeps."""
_LAUNCHERS = " ".join(f"-DCMAKE_{language}_COMPILER_LAUNCHER={WITH_CACHE}" for language in ("C", "CXX"))
_BRIEF = "-DCMAKE_TARGET_MESSAGES=OFF"
"""CMake's make would start a program for each target to say that it is built, also where it was before.

https://cmake.org/cmake/help/latest/prop_gbl/TARGET_MESSAGES.html (CMake 3.4), 2026-11-28
"""


def tree_mount(plan: Plan) -> str:
    """Return the mount in which what was compiled outlives a build; BuildKit knows it by all of these words."""
    cache = f"--mount=type=cache,id=build-{plan.name}-${{TARGETARCH}},target={FOLDER}"
    return f"{cache},uid=${{NB_UID}},sharing=locked"


def launchers(plan: Plan) -> str:
    """Return CMake's options by which compiled files are kept, on a line of their own, ``""`` where none are."""
    return f" \\\n      {_LAUNCHERS} {_BRIEF}" if plan.compiled_apart and plan.workspace.compiler_cache else ""


def install(plan: Plan) -> str:
    """Install ccache, which the image itself does not get."""
    if not launchers(plan):
        return ""
    comment = "Files that are the same as in an earlier build are not compiled again"
    return f"USER root\n{shell.call('install-ccache', comment=comment, secrets=secrets.for_apt(plan))}"
