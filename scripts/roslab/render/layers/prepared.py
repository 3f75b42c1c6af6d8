"""What is made and hidden in a workspace before its build tool looks into it."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.plan.plan import Plan
from roslab.plan.ros_build import WORKSPACE, RosBuild
from roslab.plan.workspace import Workspace
from roslab.render import quote

WITHOUT_LACKING = "leave-out-lacking"
"""The script that hides packages where nothing brings what they require."""

MAKES_FOLDERS = "make-installed-folders"
"""The script that makes what packages install and git does not keep."""
_IN_LIB = r"\n[develop]\nscript_dir=$base/lib/%s\n[install]\ninstall_scripts=$base/lib/%s\n"
"""What setup.cfg says for a package of ROS 2; the first line end is for a file without its last one."""
RAISED = "raise-standard"
"""The script that compiles cloned packages with the standard of C++ that libraries ask for."""


def of_clones(plan: Plan, build: RosBuild) -> Iterator[str]:
    """Yield the command that makes the folders which cloned packages install and do not have.

    Only where the tool installs what it builds; those of the repository itself are known.
    """
    installs = build.tool == "colcon" or not {"install", "--install"}.isdisjoint(build.arguments)
    if installs and not plan.compatible and (plan.workspace.sources or plan.workspace.submodules):
        yield f"{MAKES_FOLDERS} src"


def not_there(source: str, build: RosBuild) -> Iterator[str]:
    """Yield the commands that make what packages install and the repository, in ``source``, does not have."""
    files = [_within(source, path) for path in build.not_there if not path.endswith("/")]
    if build.not_there:
        folders = dict.fromkeys(_within(source, path.rpartition("/")[0]) for path in build.not_there)
        yield f"mkdir --parents {' '.join(folders)}"
    if files:
        yield f"touch {' '.join(files)}"


def in_bin(source: str, build: RosBuild) -> Iterator[str]:
    """Yield the commands by which packages of Python install their programs where ROS 2 looks for them."""
    for folder, name in build.in_bin:
        into = _within(source, f"{folder}/setup.cfg".lstrip("/"))
        yield f"printf '{_IN_LIB}' {quote.shell(name)} {quote.shell(name)} >>{into}"


def lacking(source: str, build: RosBuild) -> Iterator[str]:
    """Yield the commands that hide packages where no clone brings what they require."""
    for name, folders in build.lacking:
        hidden = " ".join(_within(source, folder) for folder in folders)
        yield f"{WITHOUT_LACKING} {quote.shell(name)} {hidden}"


def raised(place: Workspace, build: RosBuild) -> Iterator[str]:
    """Yield the commands that raise the standard of C++ of packages that are cloned into the workspace."""
    if place.folder == WORKSPACE:  # its own packages lie among those that are cloned
        folders = " ".join(quote.shell(f"src/{source.name}") for source in place.sources)
    else:
        folders = f"src --but {quote.shell(place.folder.removeprefix(f'{WORKSPACE}/'))}"
    for standard, names in build.raised:
        yield f"{RAISED} {standard} {quote.shell(names)} {folders}"


def ignoring(source: str, build: RosBuild) -> Iterator[str]:
    """Yield the command that puts the marker of a build tool into the folders that it must not look into."""
    marker = "COLCON_IGNORE" if build.tool == "colcon" else "CATKIN_IGNORE"
    if build.ignored:
        yield f"touch {' '.join(_within(source, f'{folder}/{marker}'.lstrip('/')) for folder in build.ignored)}"


def executable(build: RosBuild, *, moved: bool) -> Iterator[str]:
    """Yield the command that gives scripts the right to be executed where CMake installed them without it.

    Where colcon installs links, the source's file gets it. ``moved``: what was compiled in a stage of its own is in the
    folder ``built`` of the home by then.
    """
    if build.executable:
        names = " -o ".join(f"-name {quote.shell(name)}" for name in build.executable)
        folder = "../built/install" if moved else "install"
        yield rf"find {folder} -path '*/lib/*' -xtype f \( {names} \) -exec chmod +x {{}} +"


def _within(source: str, path: str) -> str:
    return quote.shell_with_user(f"{source}/{path}".rstrip("/"))
