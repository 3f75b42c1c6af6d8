"""Links that the image gets: for headers that contradict others, modules of CMake, and the author's Python."""

from __future__ import annotations

import posixpath

from roslab.plan.plan import Plan
from roslab.render import quote
from roslab.render.layers import shell


def header_links(plan: Plan) -> str:
    """Put links in the place of headers that contradict others, where both are there."""
    if not plan.header_links:
        return ""
    pairs = ((quote.shell(file), quote.shell(instead)) for file, instead in plan.header_links)
    linked = [f"if [ -e {file} ] && [ -e {instead} ]; then ln -sf {instead} {file}; fi" for file, instead in pairs]
    return shell.run(*linked, comment="Headers that contradict those of another package, which the code includes too")


def cmake_modules(plan: Plan) -> str:
    """Put links where CMake looks to modules that packages of the Ubuntu have elsewhere."""
    if not plan.cmake_modules:
        return ""
    files = " ".join(map(quote.shell, plan.cmake_modules))
    link = f'if [ -d "${{folder}}" ]; then ln -sf {files} "${{folder}}"; fi'
    made = f"for folder in /usr/{{,local/}}share/cmake-*/Modules; do {link}; done"
    return shell.run(made, comment="Modules of CMake that a package has in a folder where CMake does not look")


def interpreters(plan: Plan) -> str:
    """Put links to the image's Python where scripts or launch files name one of the author's machine."""
    if not plan.interpreters:
        return ""
    made = " ".join(dict.fromkeys(quote.shell(posixpath.dirname(path)) for path, _ in plan.interpreters))
    linked = [f'ln --symbolic --force "$(command -v {name})" {quote.shell(path)}' for path, name in plan.interpreters]
    comment = "Scripts or launch files name a Python of the author's machine"
    return shell.run(f"mkdir --parents {made}", *linked, comment=comment)
