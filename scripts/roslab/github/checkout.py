"""Where the checkout is, the credentials that it leaves in ``.git``, and how a Dockerfile is kept from them."""

from __future__ import annotations

import os
import posixpath
import re
import shutil
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path

from roslab.errors import ConfigurationError, Problem, RefusedError, RoslabError
from roslab.render.ignore import keeps_out
from roslab.repository.checkout import printable
from roslab.values.dataclass import replace
from roslab.values.origin import Input, Place

FLAGS = re.IGNORECASE | re.MULTILINE
CREDENTIAL = re.compile(rb"^\s*extraheader\s*=.*authorization|^\s*url\s*=\s*\w+://[^/\s]*:[^/\s]*@", FLAGS)
"""Matches what actions/checkout up to version 5 writes with ``persist-credentials``, and a URL with a password.
https://github.com/actions/checkout/blob/main/CHANGELOG.md"""
MAX_CONFIG = 1_000_000
"""Number of bytes of a git configuration that are read."""


def workspace(environment: Mapping[str, str]) -> Path:
    """Return the checkout."""
    return Path(environment.get("GITHUB_WORKSPACE") or ".").resolve()


def part(workspace: Path, path: str) -> Path:
    """Return the folder of a checkout that is built as if it were the repository.

    ``path`` is relative to the checkout, ``""`` for all of it. Raises ``ConfigurationError`` if there is no such
    folder, ``RefusedError`` if it lies outside the checkout.
    """
    root = workspace.resolve()
    if not path:
        return root
    origin = Input(name="path")
    hint = "write a folder of the repository, relative to its root: robots/arm"
    folder = (root / path).resolve()
    if not folder.is_relative_to(root) or ".git" in folder.relative_to(root).parts:
        raise RefusedError(Problem(message=f"{printable(path)} leads out of the repository", hint=hint, origin=origin))
    if not folder.is_dir():
        raise ConfigurationError(Problem(message=f"there is no folder {printable(path)}", hint=hint, origin=origin))
    return folder


@contextmanager
def placed(path: str) -> Iterator[None]:
    """Make the problems raised inside name files by their path in the checkout instead of in the built folder."""
    try:
        yield
    except RoslabError as error:
        raise type(error)(*(_placed(problem, path) for problem in error.problems)) from None


def _placed(problem: Problem, path: str) -> Problem:
    place = problem.origin
    if not path or not isinstance(place, Place):
        return problem
    return replace(problem, origin=replace(place, file=posixpath.join(path, place.file)))


def shielded(dockerfile: Path, context: Path, folder: Path) -> Path | None:
    """Copy the Dockerfile to ``folder`` so that its build does not see ``.git``, if a credential is stored there.

    Return the copy, or ``None`` if the Dockerfile can be built where it is. The lines of the author's ignore file are
    kept.
    """
    left = [path for path in _configurations(context) if _has_credential(context / path)]
    lines = _ignored(dockerfile, context)
    if all(keeps_out(lines, path) for path in left):
        return None
    shutil.copyfile(dockerfile, copy := folder / "Dockerfile")
    (folder / "Dockerfile.dockerignore").write_text("\n".join([*lines, "**/.git", ""]), encoding="utf-8")
    return copy


def _configurations(context: Path) -> Iterator[str]:
    """Yield the relative path of every git configuration in a folder, also of submodules; links are not followed."""
    for place, folders, _ in os.walk(context):
        if ".git" in folders:
            git = Path(place) / ".git"
            folders.remove(".git")
            for inner, _, names in os.walk(git):
                yield from (os.path.relpath(Path(inner) / name, context) for name in names if name.startswith("config"))


def _has_credential(file: Path) -> bool:
    if file.is_symlink() or not file.is_file():
        return False
    with file.open("rb") as stream:
        return bool(CREDENTIAL.search(stream.read(MAX_CONFIG)))


def _ignored(dockerfile: Path, context: Path) -> list[str]:
    """Return the lines of the ignore file that docker reads: https://docs.docker.com/build/concepts/context/.

    A link that leads out of the context is read by neither.
    """
    candidates = (dockerfile.with_name(f"{dockerfile.name}.dockerignore"), context / ".dockerignore")
    found = next((file for file in candidates if _is_inside(file, context)), None)
    return found.read_text(encoding="utf-8", errors="replace").splitlines() if found else []


def _is_inside(file: Path, context: Path) -> bool:
    """Return whether a path is a file of the context, also where a link leads to it."""
    try:
        return file.resolve().is_relative_to(context.resolve()) and file.is_file()
    except (OSError, RuntimeError):  # a link to itself
        return False
