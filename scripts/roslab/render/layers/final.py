"""Layer 7: the author's own commands, environment, entry point, default command."""

from __future__ import annotations

from roslab.plan.plan import Plan
from roslab.render import quote
from roslab.render.layers import locks, secrets, shell
from roslab.render.layers.base import python_folders
from roslab.render.layers.owners import own_home
from roslab.render.layers.workspace import HOME, setups, source_folder

ENTRY_POINT = "roslab-entrypoint"
ENVIRONMENT = "/usr/local/share/roslab/environment.bash"


def custom(plan: Plan) -> str:
    """Run the commands of ``custom`` as their format always did."""
    if not plan.custom or not plan.custom.commands:
        return ""
    workdir = {"root": "/", "home": HOME, "source": source_folder(plan)}[plan.custom.workdir]
    user = "root" if plan.custom.as_root else "${NB_USER}"
    # Its HOME is the user's, also as root
    given = secrets.everything(plan, home="user", user="root" if plan.custom.as_root else "user")
    # What only root may write a user cannot pin; its own commands may still call sudo
    around = locks.apt(plan, "custom", "rosdep") if plan.custom.as_root else shell.NOTHING
    if plan.custom.chained:
        # One shell for all, so that `cd` and variables carry over
        runs = [shell.run(*plan.custom.commands, secrets=given, around=around)]
    else:
        runs = [shell.run(command, secrets=given, around=around) for command in plan.custom.commands]
    set_home = "ENV HOME=/home/${NB_USER}\n" if plan.custom.as_root else ""
    lines = [f"# Commands of roslab.yaml\n{set_home}USER {user}", f"WORKDIR {quote.docker_path(workdir)}", *runs]
    if plan.custom.as_root:
        lines.append(own_home(plan))  # what they made in the source is the user's, who can make it again
    return "\n".join(lines)


def environment(plan: Plan) -> str:
    """Source ROS and the workspace in every shell and for every command."""
    # The setup scripts of ROS read the caller's arguments: hence the empty `--`
    lines = [f"source {setup} --" for setup in setups(plan)]
    if not lines:
        return ""
    return "\n".join(
        (
            "# ROS and the workspace, for every command and every shell in the container",
            "USER root",
            shell.copy_script(ENTRY_POINT) + shell.heredoc(ENVIRONMENT, "\n".join(lines)).rstrip(),
        )
    )


def start(plan: Plan) -> str:
    """Set what a container starts with: its variables, user and folder, the entry point and the default command."""
    return f"{_variables(plan)}\n{command(plan, entry_point=bool(setups(plan)))}"


def _variables(plan: Plan) -> str:
    """Set what every login has, the environment variables of roslab.yaml and those that a GPU needs.

    https://man7.org/linux/man-pages/man1/login.1.html (Environment), 2026-11-27: launch files and programs read USER.
    """
    home = "ENV HOME=/home/${NB_USER} USER=${NB_USER} LOGNAME=${NB_USER}"
    pairs: list[tuple[str, str, bool]] = []
    if plan.run.gpu:
        pairs += [("NVIDIA_VISIBLE_DEVICES", "all", True), ("NVIDIA_DRIVER_CAPABILITIES", "all", True)]
    path = "${PATH}"
    if plan.workspace.program and plan.workspace.program.on_path:
        folders = (plan.workspace.program.build, *plan.workspace.program.programs)
        path = "".join(f"{HOME}/{folder}:" for folder in folders) + path
    if plan.run.matlab:  # which is only there while docker_run.sh mounts it
        path += ":" + quote.docker(f"{plan.run.matlab.host_path}/bin").strip('"')
    if path != "${PATH}":
        pairs.append(("PATH", f'"{path}"', False))
    if plan.workspace.python_path:
        own = [f"{source_folder(plan)}/{folder}".removesuffix("/.") for folder in plan.workspace.python_path]
        own += python_folders(plan)
        pairs.append(("PYTHONPATH", f'"{quote.docker_path(":".join(own))}"', False))
    pairs += [(name, value, True) for name, value in plan.env]
    body = " \\\n    ".join(f"{name}={quote.docker(value) if literal else value}" for name, value, literal in pairs)
    return f"{home}\nENV {body}" if pairs else home


def command(plan: Plan, *, entry_point: bool) -> str:
    """Set the user, the folder it starts in, the entry point and the default command."""
    lines = ["USER ${NB_USER}", f"WORKDIR {quote.docker_path(source_folder(plan))}"]
    if entry_point:
        lines.append(f"ENTRYPOINT {quote.json_form([ENTRY_POINT])}")
    argv = ["bash", "-c", plan.run.command] if isinstance(plan.run.command, str) else list(plan.run.command)
    lines.append(f"CMD {quote.json_form(argv)}")
    return "\n".join(lines)
