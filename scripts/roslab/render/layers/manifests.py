"""Manifests ahead of the source: what is installed from them is installed again only when one of them changes."""

from __future__ import annotations

import posixpath
from collections.abc import Iterable, Mapping

from roslab.plan.plan import Plan
from roslab.render import quote
from roslab.render.layers import secrets, shell

FOLDER = "/tmp/manifests"  # noqa: S108 - a folder of the image while it is built
"""Not at the root: BuildKit reads the whole folder around what is copied out of a stage, to know whether it changed."""
MOST_FOLDERS = 4
"""Each takes a COPY, which is a layer. From more of them the manifests are set apart in a stage and copied at once."""
MOST_COPIES = 50
"""In that stage, too, whose layers no image has: what changed is known without the fifth of a second that a container
takes. Docker's own builder stacks at most 125 layers."""


def of_rosdep(plan: Plan) -> tuple[str, ...]:
    """Return the package.xml files whose keys are installed."""
    return plan.rosdep.manifests if plan.rosdep else ()


def of_pip(plan: Plan) -> tuple[str, ...]:
    """Return the requirement files and what they include."""
    return tuple(sorted({*plan.python.manifests, *plan.python.requirements}))


def of_conda(plan: Plan) -> tuple[str, ...]:
    """Return the conda environment's file, and the requirement files that its pip part may include."""
    return (
        tuple(sorted({plan.python.conda_file, *of_pip(plan)}))
        if plan.python.conda_file and not plan.python.conda_specs
        else ()
    )


def stage(plan: Plan) -> str:
    """Set the manifests apart out of the whole source, where they are too many to be copied by name."""
    files = _all(plan)
    folders = _folders(files)
    if len(folders) <= MOST_FOLDERS:
        return ""
    why = "# The manifests alone: what is installed from them is installed again only when one of them changes"
    if len(folders) <= MOST_COPIES:
        return f"{why}\nFROM scratch AS manifests\n{_copies(folders)}"
    mount = f"--mount=type=bind,{'from=source,' if plan.compiled_apart else ''}target=/repository"
    copy = f"cp --parents --target-directory={FOLDER}{shell.words(quote.path(name) for name in files)}"
    run = shell.run(f"mkdir {FOLDER}", "cd /repository", copy, secrets=secrets.Secrets(mounts=(mount,)))
    return f"{why}\nFROM base AS manifests\n{run}"


def copy(plan: Plan, files: Iterable[str]) -> str:
    """Return the lines that bring these manifests to ``FOLDER``, each at its path of the repository."""
    folders = _folders(files)
    if not folders:
        return ""
    if len(_folders(_all(plan))) > MOST_FOLDERS:
        return f"COPY --from=manifests {FOLDER}/ {FOLDER}/\n"
    return _copies(folders)


def _copies(folders: Mapping[str, list[str]]) -> str:
    return "".join(
        f"COPY {quote.copy(names, posixpath.normpath(posixpath.join(FOLDER, folder)) + '/')}\n"
        for folder, names in folders.items()
    )


def _all(plan: Plan) -> tuple[str, ...]:
    return tuple(sorted({*of_rosdep(plan), *of_pip(plan), *of_conda(plan)}))


def _folders(files: Iterable[str]) -> dict[str, list[str]]:
    found: dict[str, list[str]] = {}
    for name in sorted(files, key=posixpath.split):
        found.setdefault(posixpath.dirname(name), []).append(name)
    return found
