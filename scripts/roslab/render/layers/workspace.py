"""Layers 4 to 6, the workspace's part: manifests, rosdep, the source, the compilation."""

from __future__ import annotations

import shlex

from roslab.config.model import Source
from roslab.plan.packages import ROS_TOOLS
from roslab.plan.plan import Plan
from roslab.render import quote
from roslab.render.layers import shell
from roslab.render.layers.python import MANIFESTS
from roslab.render.layers.system import fetch

WS = "/home/${NB_USER}/ws"
ROS_SETUP = 'source "/opt/ros/${ROS_DISTRO}/setup.bash"'
ROSDISTRO = "https://raw.githubusercontent.com/ros/rosdistro"


def source_folder(plan: Plan) -> str:
    """Folder of the repository inside the image, with ``${NB_USER}`` for the user's name."""
    if plan.workspace.layout == "overlay":
        return f"{WS}/src/{plan.name}"
    return WS if plan.workspace.layout == "root" else f"/home/${{NB_USER}}/{plan.name}"


def manifest_stage(plan: Plan) -> str:
    """Set the manifests apart: what is installed from them is reused until one of them changes, whatever else does."""
    names = _manifests(plan)
    if not names:
        return ""
    copy = f"cp --parents --target-directory=/manifests{shell.words(quote.path(name) for name in names)}"
    why = "# The manifests alone: what is installed from them is installed again only when one of them changes"
    return "\n".join(
        (why, "FROM base AS manifests", "WORKDIR /repository", "COPY . .", shell.run("mkdir /manifests", copy))
    )


def _manifests(plan: Plan) -> tuple[str, ...]:
    python = plan.python
    rosdep = plan.rosdep.manifests if plan.rosdep else ()
    conda = (python.conda_file,) if python.conda_file else ()
    return tuple(sorted({*rosdep, *python.manifests, *python.requirements, *conda}))


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
    """Install what the package.xml files name, by rosdep inside the image; name the keys that it does not know.

    rosdep tells of one unknown key a package at a time: hence the loop, which ends when none is new.
    """
    if plan.rosdep is None:
        return ""
    folders = [MANIFESTS] if plan.rosdep.manifests else []
    folders += [f"{WS}/src"] if plan.workspace.sources else []
    copy = f"COPY --from=manifests /manifests/ {MANIFESTS}/\n" if plan.rosdep.manifests else ""
    arguments = f'--ignore-src --rosdistro "${{ROS_DISTRO}}" --from-paths {" ".join(folders)} --skip-keys "${{skip}}"'
    return f"""\
# What the package.xml files name; keys that rosdep does not know are named and left out
{copy}{_pin(plan.rosdep.rosdistro_tag)}RUN apt-get update; \\
    {_update(plan.rosdep.rosdistro_tag)}; \\
    skip={quote.shell(" ".join(plan.rosdep.skip_keys))}; \\
    before=''; \\
    while :; do \\
      unknown="$({{ rosdep install --simulate --reinstall {arguments} 2>&1 || true; }} \\
        | sed --quiet --regexp-extended 's/.*definition (for|of) \\[([^]]+)\\].*/\\2/p' | sort --unique)"; \\
      [ "${{unknown}}" != "${{before}}" ] || break; \\
      before="${{unknown}}"; \\
      for key in ${{unknown}}; do echo "rosdep ${{key}}" >>{shell.REPORT}; skip="${{skip}} ${{key}}"; done; \\
    done; \\
    if [ -s {shell.REPORT} ]; then sed 's/^/roslab: left out: /' {shell.REPORT}; fi; \\
    rosdep install --default-yes {arguments}; \\
    rm -rf /var/lib/apt/lists/*"""


def _pin(tag: str | None) -> str:
    return f"ARG ROSDISTRO_TAG={tag}\n" if tag else ""


def _update(tag: str | None) -> str:
    """Return the commands that fetch rosdep's tables: the last ones that know this Ubuntu, else the base's own.

    The newest tables forget a release some years after its end: https://github.com/ros/rosdistro/pull/36755
    """
    folder = "/etc/ros/rosdep/sources.list.d"
    update = 'rosdep update --rosdistro "${ROS_DISTRO}"'
    if tag is None:
        return f"{{ ls {folder}/*.list >/dev/null 2>&1 || rosdep init; }}; \\\n    {update}"
    lines = (
        "mkdir --parents /etc/ros/rosdep/sources.list.d /tmp/own-tables",
        f"find {folder} -name '*.list' -exec mv --target-directory=/tmp/own-tables {{}} +",
        'own_index="${ROSDISTRO_INDEX_URL:-}"',
        f'tables="{ROSDISTRO}/${{ROSDISTRO_TAG}}"',
        f"printf 'yaml %s\\n' \"${{tables}}/rosdep/\"{{base,python,ruby}}.yaml >{folder}/20-default.list",
        'export ROSDISTRO_INDEX_URL="${tables}/index-v4.yaml"',
        f"if ! {update}; then",
        '  echo "roslab: the tables of rosdistro ${ROSDISTRO_TAG} do not answer: the base\'s own are used"',
        f"  rm {folder}/20-default.list",
        "  find /tmp/own-tables -name '*.list' -exec mv --target-directory=" + folder + " {} +",
        '  export ROSDISTRO_INDEX_URL="${own_index}"',
        '  [ -n "${own_index}" ] || unset ROSDISTRO_INDEX_URL',
        f"  {update}",
        "fi",
    )
    joined = ""
    for line in lines:
        joined += line + (" \\\n    " if line.endswith("then") else "; \\\n    ")
    return joined.removesuffix("; \\\n    ")


def copy_source(plan: Plan) -> str:
    """Copy the repository and make the user its owner."""
    folder = source_folder(plan)
    target = quote.docker_path(folder)
    return f"# The source\nCOPY --chown=${{NB_UID}}:${{NB_UID}} . {target}\nWORKDIR {target}"


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
    return shell.run(*commands, comment="The paths of old")


def own_home(_: Plan) -> str:
    """Give the user what root made in its home; files that are its own already are not written to the layer again."""
    why = "# Folders that COPY and WORKDIR made on the way are root's\n"
    return (
        why + 'RUN find "/home/${NB_USER}" ! -user "${NB_UID}" -exec chown --no-dereference "${NB_UID}:${NB_UID}" {} +'
    )


def compile_workspace(plan: Plan) -> str:
    """Compile the workspace and the CMake project as the user, who can then compile them again."""
    blocks = []
    if compiles_workspace(plan):
        run = shell.run(ROS_SETUP, shell.JOBS, _command(plan))
        blocks.append(f"# The workspace, with as many jobs as there are cores and memory for\nWORKDIR {WS}\n{run}")
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


def _command(plan: Plan) -> str:
    # Options and arguments are the repository's: where it is no package of the workspace, they are its cmake's
    own = plan.workspace.tool in ROS_TOOLS
    options = (_cmake_options(plan) if own else "") + _sisters_options(plan)
    cmake = f" --cmake-args{options}" if options else ""
    arguments = "".join(f" {quote.shell(word)}" for word in plan.workspace.arguments) if own else ""
    match workspace_tool(plan):
        case "catkin_make":
            return f'catkin_make -j"${{jobs}}"{options}{arguments}'
        case "catkin_tools":
            return f'catkin build --no-status --jobs "${{jobs}}" --parallel-packages "${{jobs}}"{cmake}{arguments}'
        case _:
            colcon = 'colcon build --event-handlers console_direct+ --parallel-workers "${jobs}"'
            return f'MAKEFLAGS="-j${{jobs}} -l${{jobs}}" {colcon}{cmake}{arguments}'


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
    return shell.run(
        *([ROS_SETUP] if plan.kind in ("ros1", "ros2") else []),
        *([f'source "{WS}/{overlay(plan)}/setup.bash"'] if compiles_workspace(plan) else []),
        f"mkdir --parents {quote.shell_with_user(build)}",
        f"cd {quote.shell_with_user(build)}",
        shell.JOBS,
        f"cmake{_cmake_options(plan)} {quote.shell_with_user(source)}",
        f'make --jobs="${{jobs}}"{arguments}',
        comment="The program",
    )
