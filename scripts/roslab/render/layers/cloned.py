"""What is cloned: sister packages into the workspace, submodules into the repository."""

from __future__ import annotations

from roslab.config.model import Source
from roslab.plan.plan import Plan
from roslab.render import quote
from roslab.render.layers import locks, secrets, shell
from roslab.render.layers.system import fetch, prepared
from roslab.render.layers.workspace import HOLDING, WS, source_folder, words


def sister_sources(plan: Plan) -> str:
    """Clone the sister packages into the workspace, each at its ref."""
    sources = plan.workspace.sources
    if not sources:
        return ""
    depends = tuple(dict.fromkeys(d for s in sources for d in s.depends))
    blocks = [shell.apt_install(depends, secrets.for_apt(plan), locks.apt(plan, "sisters"))] if depends else []
    sure = [shell.run(*_fetched(plan, s), secrets=secrets.for_git(plan, "user")) for s in sources if not s.holding]
    runs = ["# Sister packages, from their source", *sure] if sure else []
    tried = [shell.run(_tried(s), secrets=secrets.for_git(plan, "user")) for s in sources if s.holding]
    if tried:
        why = "# Packages that nothing known brings: what is not there is told and stops nothing"
        runs += [why, shell.copy_script(HOLDING) + shell.copy_script(shell.PACKAGES).rstrip(), *tried]
    return "\n".join([*blocks, "USER ${NB_USER}", f"RUN mkdir --parents {WS}/src", *runs, "USER root"])


def _tried(source: Source) -> str:
    """Return the call of the script that keeps a repository where it holds what the workspace lacks."""
    at = f" --ref {quote.shell(source.ref)}" if source.ref else ""
    at += f" --before {quote.shell(source.before)}" if source.before else ""
    folder = quote.shell_with_user(f"{WS}/src/{source.name}")
    return f"{HOLDING}{at} {quote.shell(source.repo or '')} {folder}{words(source.holding)}"


def submodules(plan: Plan) -> str:
    """Clone what lies in the tree and is not checked out into the folder that the source is copied to afterwards.

    What is private or gone is told and left out, as where the workflows fetch submodules.
    """
    if not plan.workspace.submodules:
        return ""
    runs = []
    for source in plan.workspace.submodules:
        folder = quote.shell_with_user(f"{source_folder(plan)}/{source.name}")
        commands = (f"mkdir --parents {folder}", _or_left_out(fetch(plan, source, folder), source))
        runs.append(shell.run(*commands, secrets=secrets.for_git(plan, "user")))
    head = "# What belongs in the tree and is not checked out: submodules at the commits that the repository records"
    return "\n".join([head, "USER ${NB_USER}", *runs, "USER root"])


def _fetched(plan: Plan, source: Source) -> list[str]:
    folder = quote.shell_with_user(f"{WS}/src/{source.name}")
    commands = prepared(plan, source, folder)
    return [_or_left_out(commands, source)] if source.unasked else commands


def _or_left_out(commands: list[str], source: Source) -> str:
    """Return the commands as one that does not fail: what is private or gone is told."""
    cloned = " \\\n   && ".join(commands)
    return f"{{ {cloned}; }} \\\n || echo {quote.shell(f'roslab: left out: {source.name} cannot be cloned')}"
