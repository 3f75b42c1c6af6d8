"""What is compiled beside the program: by scripts of the author's, by make, and in other folders by CMake."""

from __future__ import annotations

from roslab.plan.plan import Plan
from roslab.plan.workspace import Script
from roslab.render import quote
from roslab.render.layers import cloned_heads, gpu_said, shell
from roslab.render.layers.owners import own_home
from roslab.render.layers.workspace import source_folder
from roslab.values.dataclass import replace


def before_program(plan: Plan) -> str:
    """Run what compiles something; what fails beside the program is told and stops nothing."""
    scripts = [script for script in plan.workspace.scripts if not script.after]
    head = "# What is compiled beside the program: by scripts that the README runs, and in other folders"
    if any(script.required for script in scripts):
        head = "# What the script of the repository compiles"
    if scripts and all(script.copies for script in scripts):
        head = "# What is copied or written before it is compiled or run, as a page, a script or CMake says"
    return _run(plan, scripts, head)


def after_program(plan: Plan) -> str:
    """Compile what links the program's library, which is installed now, and what a page makes after the workspace."""
    head = "# What is compiled once all above is built: it may need that"
    return _run(plan, [script for script in plan.workspace.scripts if script.after], head)


def _run(plan: Plan, scripts: list[Script], head: str) -> str:
    if not scripts:
        return ""
    runs, around = [], cloned_heads.of_day(plan)
    for script in scripts:
        where = quote.shell_with_user(f"{source_folder(plan)}/{script.folder}".rstrip("/"))
        left_out = quote.shell(f"roslab: left out: {script.command} failed")
        run = f"{gpu_said.SCRIPT} {script.command}" if gpu_said.asked(plan, script.folder) else script.command
        command = run if script.required else f"{{ {run} || echo {left_out}; }}"
        runs.append(shell.run(f"cd {where}", command, around=around))
        around = replace(around, before="")
    return "\n".join([head, "USER root", *gpu_said.script(runs), *runs, own_home(plan)])
