"""The compilation in a stage of its own: its tree stays out of the image, and what it does not read repeats nothing."""

from __future__ import annotations

from roslab.plan.plan import Plan
from roslab.plan.ros_build import WORKSPACE
from roslab.render import quote
from roslab.render.layers import compiler_cache, git_folder, program, workspace
from roslab.render.layers.workspace import HOME, WS

SOURCE = "source"
COMPILED = "compiled"
DEPENDENCIES = "dependencies"


def source_stage(plan: Plan) -> str:
    """Set the source apart as the compilation reads it: what no build file names is blank in it.

    BuildKit compares what is copied by content, so that an edit of such a file repeats no step. With ``--link`` the
    blank file takes the place of a folder, too.
    """
    lines = [f"FROM scratch AS {SOURCE}", "COPY . /"]
    if names := plan.workspace.unread:
        lines.insert(0, "# The source without what no build file names: an edit of that compiles nothing again")
        lines += [f"COPY --link {' '.join(f'<<{name}' for name in names)} /", *names]
    return "\n".join(lines)


def compiled(plan: Plan) -> str:
    """Compile what the source holds."""
    before, run = workspace.compile_again(plan)
    target = quote.docker_path(workspace.source_folder(plan))
    copy = f"COPY --from={SOURCE} --chown=${{NB_UID}}:${{NB_UID}} / {target}/"
    parts = (
        compiler_cache.install(plan),
        before,
        copy,
        workspace.any_processor(plan),
        git_folder.made(plan),
        run,
        program.compile_program(plan),
    )
    return "\n".join(part for part in parts if part)


def results(plan: Plan) -> str:
    """Bring what runs into the image, below the source, which changes more often.

    A repository that is a workspace itself may hold folders of these names: then what was compiled comes last.
    """
    program = plan.workspace.program
    pairs = [(f"{HOME}/built", WS)] if plan.workspace.ros else []
    pairs += [(f"{HOME}/{program.build}",) * 2] if program else []
    copies = [
        f"COPY --from={COMPILED} --chown=${{NB_UID}}:${{NB_UID}} {quote.docker_path(old)}/ {quote.docker_path(new)}/"
        for old, new in pairs
    ]
    source = ["COPY --chown=${NB_UID}:${NB_UID} . ."]
    whole = plan.workspace.folder == WORKSPACE
    lines = source + copies if whole else copies + source
    return "\n".join(("# What was compiled, and the source", workspace.enter_source(plan), *lines))
