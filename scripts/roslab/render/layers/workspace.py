"""Layers 4 to 6, the workspace's part: manifests, rosdep, the source, the compilation."""

from __future__ import annotations

import shlex

from roslab.config.model import Source
from roslab.plan.packages import ROS_TOOLS
from roslab.plan.plan import Plan
from roslab.render import quote
from roslab.render.layers import manifests, shell
from roslab.render.layers.system import fetch

WS = "/home/${NB_USER}/ws"
ROS_SETUP = 'source "/opt/ros/${ROS_DISTRO}/setup.bash"'


def source_folder(plan: Plan) -> str:
    """Folder of the repository inside the image, with ``${NB_USER}`` for the user's name."""
    if plan.workspace.layout == "overlay":
        return f"{WS}/src/{plan.name}"
    return WS if plan.workspace.layout == "root" else f"/home/${{NB_USER}}/{plan.name}"


def sister_sources(plan: Plan) -> str:
    """Clone the sister packages into the workspace, each at its ref."""
    sources = plan.workspace.sources
    if not sources:
        return ""
    blocks = (
        [shell.apt_install(depends)] if (depends := tuple(dict.fromkeys(d for s in sources for d in s.depends))) else []
    )
    runs = [shell.run(*_fetched(s)) for s in sources]
    head = "# Sister packages, from their source"
    return "\n".join([head, *blocks, "USER ${NB_USER}", f"RUN mkdir --parents {WS}/src", *runs, "USER root"])


def _fetched(source: Source) -> list[str]:
    folder = quote.shell_with_user(f"{WS}/src/{source.name}")
    return fetch(source, folder) + ([f"(cd {folder} && {source.prepare})"] if source.prepare else [])


def rosdep(plan: Plan) -> str:
    """Install what the package.xml files name, by rosdep inside the image; name the keys that it does not know."""
    if plan.rosdep is None:
        return ""
    files = manifests.of_rosdep(plan)
    tag, skip = plan.rosdep.rosdistro_tag, " ".join(plan.rosdep.skip_keys)
    folders = [manifests.FOLDER] if files else []
    folders += [f"{WS}/src"] if plan.workspace.sources else []
    return shell.call(
        "install-rosdep-keys",
        (f" --tables {quote.shell(tag)}" if tag else "")
        + (f" --skip {quote.shell(skip)}" if skip else "")
        + "".join(f" {folder}" for folder in folders),
        comment="What the package.xml files name; keys that rosdep does not know stop nothing and are told",
        before=manifests.copy(plan, files),
    )


def copy_source(plan: Plan) -> str:
    """Copy the repository; the user owns it, and the folders on the way to it, which WORKDIR makes."""
    target = quote.docker_path(source_folder(plan))
    return f"# The source\nUSER ${{NB_USER}}\nWORKDIR {target}\nCOPY --chown=${{NB_UID}}:${{NB_UID}} . ."


def old_paths(plan: Plan) -> str:
    """Keep the paths of an old image, which its commands and its README name."""
    if not plan.compatible:
        return ""
    links = {}
    if plan.workspace.layout == "overlay" or plan.workspace.sources:
        links["catkin_ws"] = "ws"
    if plan.workspace.layout == "overlay" and plan.name not in ("ws", "catkin_ws"):
        links[plan.name] = f"ws/src/{plan.name}"
    if not links:
        return ""
    commands = (
        f"ln --symbolic {quote.shell(target)} {quote.shell_with_user(f'/home/{quote.USER}/{name}')}"
        for name, target in links.items()
    )
    return f"# The paths of old\nUSER root\n{shell.run(*commands)}"


def own_home(plan: Plan) -> str:
    """Give the user what root made in its home; files that are its own already are not written to the layer again."""
    if not plan.compatible and not plan.workspace.python_projects:
        return ""
    return give_home(plan)


def give_home(_: Plan) -> str:
    """Return the RUN that makes the user the owner of everything in its home."""
    why = "# What root made in the user's home\n"
    return (
        why + 'RUN find "/home/${NB_USER}" ! -user "${NB_UID}" -exec chown --no-dereference "${NB_UID}:${NB_UID}" {} +'
    )


def compile_workspace(plan: Plan) -> str:
    """Compile the workspace and the CMake project as the user, who can then compile them again."""
    blocks = []
    if compiles_workspace(plan):
        run = shell.run(ROS_SETUP, *_commands(plan))
        blocks.append(f"# The workspace\nUSER ${{NB_USER}}\nWORKDIR {WS}\n{run}")
    if plan.workspace.tool == "cmake":
        blocks.append(_plain_cmake(plan))
    return "\n\n".join(blocks)


def compiles_workspace(plan: Plan) -> bool:
    """Tell whether there is a ROS workspace to compile: of the repository's packages, or of sisters alone."""
    workspace = plan.workspace
    return plan.kind in ("ros1", "ros2") and (workspace.layout in ("overlay", "root") or bool(workspace.sources))


def workspace_tool(plan: Plan) -> str:
    """Return the tool of the ROS workspace: where the repository is no package of it, that of its sisters."""
    tools = (plan.workspace.tool, *(source.build for source in plan.workspace.sources))
    return next((tool for tool in tools if tool in ROS_TOOLS), "catkin_make" if plan.kind == "ros1" else "colcon")


def overlay(plan: Plan) -> str:
    """Name of the workspace's folder whose ``setup.bash`` makes it known."""
    return "install" if workspace_tool(plan) == "colcon" else "devel"


def _commands(plan: Plan) -> list[str]:
    # Options and arguments are the repository's: where it is no package of the workspace, they are its cmake's
    own = plan.workspace.tool in ROS_TOOLS
    options = (_cmake_options(plan) if own else "") + _sisters_options(plan)
    cmake = f" \\\n      --cmake-args{options}" if options else ""
    arguments = "".join(f" {quote.shell(word)}" for word in plan.workspace.arguments) if own else ""
    match workspace_tool(plan):
        case "catkin_make":
            return [f"catkin_make -j{shell.JOBS}{options}{arguments}"]
        case "catkin_tools":
            catkin = 'catkin build --no-status --jobs "${jobs}" --parallel-packages "${jobs}"'
            return [shell.SET_JOBS, f"{catkin}{cmake}{arguments}"]
        case _:
            colcon = 'colcon build --event-handlers console_direct+ --parallel-workers "${jobs}"'
            return [shell.SET_JOBS, f'MAKEFLAGS="-j${{jobs}} -l${{jobs}}" \\\n    {colcon}{cmake}{arguments}']


def _cmake_options(plan: Plan) -> str:
    words = shlex.split(plan.workspace.cmake_options)
    if not plan.compatible and not any("CMAKE_BUILD_TYPE" in word for word in words):
        words.insert(0, "-DCMAKE_BUILD_TYPE=Release")  # the old formats gave none: there it stays as it was
    return "".join(f" {quote.shell(word)}" for word in words)


def _sisters_options(plan: Plan) -> str:
    """Return the options that sister packages need: a workspace has one set for all its packages."""
    words = [word for source in plan.workspace.sources for word in shlex.split(source.cmake_options)]
    return "".join(f" {quote.shell(word)}" for word in dict.fromkeys(words))


def build_folder(plan: Plan) -> str:
    """Folder in which a plain CMake project is compiled; the old formats did it inside the source."""
    folder = source_folder(plan)
    inside = f"{folder}/{plan.workspace.cmake_folder}".rstrip("/")
    return f"{inside}/build" if plan.compatible else f"{folder}-build"


def _plain_cmake(plan: Plan) -> str:
    """Compile beside the source: a ``build`` folder that the repository ships is its own, not ours to fill."""
    folder = source_folder(plan)
    source = f"{folder}/{plan.workspace.cmake_folder}".rstrip("/")
    build = build_folder(plan)
    arguments = "".join(f" {quote.shell(word)}" for word in plan.workspace.arguments)
    run = shell.run(
        *([ROS_SETUP] if plan.kind in ("ros1", "ros2") else []),
        *([f'source "{WS}/{overlay(plan)}/setup.bash"'] if compiles_workspace(plan) else []),
        f"mkdir --parents {quote.shell_with_user(build)}",
        f"cd {quote.shell_with_user(build)}",
        f"cmake{_cmake_options(plan)} {quote.shell_with_user(source)}",
        f"make --jobs={shell.JOBS}{arguments}",
    )
    return f"# The program\nUSER ${{NB_USER}}\n{run}"
