"""What libraries and submodules require that could not be read when the image was planned: their CMake tells it.

Of a library it is installed where that is built, and in the image, for what is linked with it needs the same.
"""

from __future__ import annotations

import posixpath
import shlex

from roslab.config.model import Source
from roslab.plan.plan import Plan
from roslab.render import quote
from roslab.render.layers import locks, secrets, shell

INSTALL = "install-required"
"""The script that installs what a library's CMakeLists.txt requires, and notes it beside the library."""
_SCRIPTS = "".join(map(shell.copy_script, (INSTALL, "install-optional-apt")))


def of_library(plan: Plan, library: Source, folder: str) -> str:
    """Return the instructions that install in a library's stage what it requires, once it lies in ``folder``."""
    below = posixpath.normpath(posixpath.join(folder, "build", library.cmake_folder or ".."))
    options = [word for word in shlex.split(library.cmake_options) if word.startswith("-D")]
    arguments = "".join(f" {quote.shell(word)}" for word in (library.name, below, *options))
    return f"{_tools(plan)}{shell.run(f'{INSTALL}{arguments}', secrets=secrets.for_apt(plan))}"


def in_tree(plan: Plan, folder: str) -> str:
    """Return the instructions that install what submodules require that the image clones into the source's ``folder``.

    ``""`` where CMake does not compile the tree itself; what of it is no project of CMake's requires nothing.
    """
    if plan.workspace.program is None or plan.compatible:
        return ""
    named = (source.name for source in plan.workspace.submodules if not source.unasked)
    calls = [
        f"{INSTALL} {quote.shell(name.removeprefix('../').replace('/', '-'))} "
        f"{quote.shell_with_user(posixpath.normpath(f'{folder}/{name}'))}"
        for name in named
    ]
    around = locks.apt(plan, "libraries", "rosdep", "custom")
    return f"{_tools(plan)}{shell.run(*calls, secrets=secrets.for_apt(plan), around=around)}" if calls else ""


def _tools(plan: Plan) -> str:
    """Return the instructions that bring the scripts that read a CMakeLists.txt, and what they know of its names."""
    ubuntu = plan.ubuntu or "other"
    tables = shell.copy_data((f"cmake-{ubuntu}.txt", f"libraries-{ubuntu}.txt"))
    return f"{tables}{shell.copy_script('required-by-cmake')}{shell.copy_script(shell.SUBMODULES)}{_SCRIPTS}"


def in_image(plan: Plan) -> str:
    """Return the instructions that install in the image what the libraries required, ``""`` where all were read."""
    if not any(map(reads, plan.libraries)):
        return ""
    around = locks.apt(plan, "libraries", "rosdep", "custom")  # roslab.lock may tell them from those by no name
    return f"\n{_SCRIPTS}{shell.run(INSTALL, secrets=secrets.for_apt(plan), around=around)}"


def reads(library: Source) -> bool:
    """Tell whether the image reads what a library requires: CMake builds it, and nobody has read its files."""
    return library.unread and library.build == "cmake" and not library.by_make
