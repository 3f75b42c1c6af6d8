"""Links in the places of folders of the author's machine that files name."""

from __future__ import annotations

import posixpath

from roslab.plan.plan import Plan
from roslab.render import quote
from roslab.render.layers import shell


def author_folders(plan: Plan) -> str:
    """Put links to the source where files name folders of the author's machine, but where the image has those."""
    linked = []
    for path, target in plan.author_folders:
        name = _at_home(path) if path.startswith("~/") else quote.shell(path)
        above = _made(posixpath.dirname(path))
        to = quote.shell(target) if target.startswith("/") else _at_home(f"~/{target}")
        linked.append(f"if [ ! -e {name} ]; then {above}ln --symbolic {to} {name}; fi")
    return shell.run(*linked, comment="Files name these folders of the author's machine") if linked else ""


def _at_home(path: str) -> str:
    return quote.shell_with_user(f"/home/{quote.USER}/{path.removeprefix('~/')}")


def _made(folder: str) -> str:
    """Return the command that makes a folder and those above it, which belong to the user: programs write there.

    What the image has stays whose it is.
    """
    names = folder.split("/")
    above = ["/".join(names[: number + 1]) for number in range(1, len(names)) if names[number]]
    folders = [_at_home(each) if each.startswith("~/") else quote.shell(each) for each in above]
    if not folders:
        return ""
    make = 'install --directory --owner="${NB_UID}" --group="${NB_UID}" "${folder}"'
    return f'for folder in {" ".join(folders)}; do [ -d "${{folder}}" ] \\\n      || {make}; done \\\n      && '
