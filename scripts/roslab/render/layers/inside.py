"""Libraries that lie in the repository and are compiled there before all else."""

from __future__ import annotations

import posixpath

from roslab.plan.plan import Plan
from roslab.render import quote
from roslab.render.layers import shell
from roslab.render.layers.workspace import TIDY, source_folder, words
from roslab.values.words import written

_INSTALL = "cmake -P cmake_install.cmake"
"""What ``make install`` does after it has made everything, which it would make again: the objects are gone."""


_TESTS = "BUILD_TESTING"
_NO_TESTS = f"-D{_TESTS}=OFF"


def compile_inside(plan: Plan) -> str:
    """Compile them where the build looks for them; those that a page installs are installed, too.

    In a submodule that could not be cloned there is nothing to compile; what fails there is told, and stops the build
    where something needs it. Its tests, which may ask for what nobody knew when the image was planned, are left out.
    """
    place = plan.workspace
    if not place.inside:
        return ""
    modules = tuple(f"{source.name}/" for source in place.submodules)
    lines = ["# Libraries inside the repository"]
    for folder, options in place.inside:
        source = quote.shell_with_user(posixpath.normpath(f"{source_folder(plan)}/{folder}"))
        build = quote.shell_with_user(posixpath.normpath(f"{source_folder(plan)}/{folder}/build"))
        unread = f"{folder}/".startswith(modules)
        given = ("-DCMAKE_BUILD_TYPE=Release", *([_NO_TESTS] if unread and _TESTS not in options else []))
        cmake = f"cmake{words((*given, *map(written, options.split())))} .."
        steps = [f"mkdir --parents {build}", f"cd {build}", cmake, f"make --jobs={shell.JOBS}", TIDY]
        installed = [f"cd {build}", _INSTALL, "ldconfig"]
        if unread:
            steps = [_tried(steps, f"{source}/CMakeLists.txt", folder)]
            installed = [_tried(installed, f"{build}/cmake_install.cmake", folder)]
        lines += ["USER ${NB_USER}", shell.run(*steps)]
        if folder in place.inside_installed:
            lines += ["USER root", shell.run(*installed)]
    return "\n".join(lines)


def _tried(steps: list[str], needed: str, folder: str) -> str:
    """Return the steps as one that does not fail, and does nothing without a file."""
    told = f"echo {quote.shell(f'roslab: left out: {folder} cannot be compiled')}"
    done = " \\\n   && ".join(steps)
    return f"{{ [ ! -e {needed} ] || {{ {done}; }} \\\n || {told}; }}"
