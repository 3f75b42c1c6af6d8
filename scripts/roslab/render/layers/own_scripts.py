"""Layer 6, what compiles something beside the program: scripts that the page runs, and folders of their own."""

from __future__ import annotations

from roslab.plan.plan import Plan
from roslab.render import quote
from roslab.render.layers import gpu_said, shell
from roslab.render.layers.workspace import own_home, source_folder


def own_scripts(plan: Plan) -> str:
    """Run what compiles something; what fails beside the program is told and stops nothing."""
    if not plan.workspace.scripts:
        return ""
    runs = []
    for script in plan.workspace.scripts:
        where = quote.shell_with_user(f"{source_folder(plan)}/{script.folder}".rstrip("/"))
        left_out = quote.shell(f"roslab: left out: {script.command} failed")
        run = f"{gpu_said.SCRIPT} {script.command}" if gpu_said.asked(plan, script.folder) else script.command
        command = run if script.required else f"{{ {run} || echo {left_out}; }}"
        runs.append(shell.run(f"cd {where}", command))
    head = "# What is compiled beside the program: by scripts that the README runs, and in other folders"
    if plan.workspace.scripts[0].required:
        head = "# What the script of the repository compiles"
    return "\n".join([head, "USER root", *gpu_said.script(runs), *runs, own_home(plan)])
