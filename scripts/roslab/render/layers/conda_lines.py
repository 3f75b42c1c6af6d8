"""Lines of a conda file that are changed in the image before it is read."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Sequence

from roslab.plan.plan import Plan
from roslab.plan.python import PythonPlan
from roslab.render import quote
from roslab.render.layers import building, caches, manifests, shell
from roslab.values.pattern import pattern

UNFOLD = "unfold-lists"
"""The script that they need where ``conda_flow`` is set."""
TAKE = "take-pip-part"
"""The script that moves what a conda file has for pip to a file of its own."""
_NAMES_PYTHON = pattern(r"(?:[\w.-]+::)?python(?![\w.-])")
"""A package of conda that is Python itself, perhaps of a channel that the line names."""


def changed(python: PythonPlan, file: str) -> tuple[str, ...]:
    """Return the commands that take out of a conda file what it cannot install, and correct its pip.

    Lists in brackets are unfolded before. None where the image has no such file: its packages are given by name.
    Of the part for pip, lines are taken out once it is a file of its own: conda's may have the same names. Where all of
    its lines are taken out, that file is not used.
    """
    if python.conda_specs or not python.conda_file:
        return ()
    commands = [f"{UNFOLD} {quote.shell(file)}"] if python.conda_flow else []
    if python.conda_pip or python.conda_local:
        commands.append(f"{TAKE} {quote.shell(file)}")
    if python.conda_pip and python.conda_local:
        commands.append(_without(python.conda_local, f"{file}.pip"))
    if python.conda_no_channels:
        commands.append(_fewer_channels(python.conda_no_channels, file))
    if python.conda_old_pip:
        commands.append(_newer_pip(file))
    if python.conda_pip_below:
        commands.append(_older_pip(file, python.conda_pip_below))
    return tuple(commands)


def specs(python: PythonPlan) -> tuple[str, ...]:
    """Return the packages that are given by name, without an old pip, in whose place another is asked for.

    Where none is Python, the one that was decided comes first: conda would take its newest.
    """
    old = python.conda_old_pip
    kept = tuple(spec for spec in python.conda_specs if not (old and spec.partition("=")[0].strip() == "pip"))
    named = any(_NAMES_PYTHON.match(spec) for spec in kept)
    return kept if named or not python.version else (f"python={python.version}", *kept)


def pip_part(plan: Plan, python: str, options: str) -> tuple[str, ...]:
    """Return the commands that install what take-pip-part left beside a conda file, as conda would; none without it.

    Before it comes what its packages are compiled with, and with it what stands for lines that were taken out.

    ``python`` is the environment's own, ``options`` are pip's: the file may pin a torch of which another index has the
    build for the image's CUDA.
    """
    file = plan.python.conda_file
    if not file or plan.python.conda_specs or not plan.python.conda_pip:
        return ()
    folder, name = posixpath.split(posixpath.join(manifests.FOLDER, file))
    pip = f"{python} -m pip install {caches.pip_option(plan)}{options}"
    words = f" --upgrade --requirement {quote.shell(f'{name}.pip')}{shell.words(plan.python.conda_instead)}"
    install = building.also_with_what_is_there(plan, pip, words)
    before = (f"{pip}{shell.words(plan.python.first)}",) if plan.python.first else ()
    return (*before, f"(cd {quote.shell(folder)} && {install})")


def _fewer_channels(addresses: Sequence[str], file: str) -> str:
    """Return the command that takes addresses that are no channels out of a conda file."""
    script = f"\\%^ *- *[\"']?({'|'.join(map(re.escape, addresses))})[\"']? *(#.*)?$%d"
    return f"sed --in-place --regexp-extended {quote.shell(script)} {quote.shell(file)}"


def _without(entries: Sequence[str], file: str) -> str:
    """Return the command that takes folders of the tree, lists and packages out of what a conda file has for pip.

    Folders are installed once they are there, lists by what is in them, the packages cannot be.
    """
    names = "|".join(re.escape(entry) for entry in entries)
    script = f"\\%^((-e|--editable|-r|--requirement) +)?([.]/)?({names})/?( *\\[[^]]*\\])?( *[(<>=!~;@].*)?$%d"
    return f"sed --in-place --regexp-extended {quote.shell(script)} {quote.shell(file)}"


def _newer_pip(file: str) -> str:
    """Return the command that takes the version off the pip of a conda file."""
    script = "s/^( *- *[\"']?)pip *= *[^ \"'#]*/\\1pip/"
    return f"sed --in-place --regexp-extended {quote.shell(script)} {quote.shell(file)}"


def _older_pip(file: str, below: str) -> str:
    """Return the command that limits a pip that a conda file names in any version."""
    script = f's/^( *- *)(["\']?)pip\\2( *#.*)?$/\\1"pip<{below}"\\3/'
    return f"sed --in-place --regexp-extended {quote.shell(script)} {quote.shell(file)}"
