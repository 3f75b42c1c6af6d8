"""A throw-away caller, a repository that uses ours as a stranger's would, and the mappings act needs for the rest."""

from __future__ import annotations

import atexit
import compileall
import os
import py_compile
import re
import shutil
import subprocess
import tempfile
from collections.abc import Iterable
from functools import cache
from pathlib import Path
from typing import Any

from .command import LabError, run
from .home import CHECKOUT, HERE, memory

OURS = "org/repro-action"
ACTIONS = HERE / "actions"
STEP = r"^\s*(?:-\s+)?uses:\s*['\"]?"
USES = re.compile(STEP + r"(?P<name>[\w.-]+/[\w.-]+)(?:/[^@\s'\"]+)?@(?P<ref>[^\s'\"#]+)", re.MULTILINE)
UNREAD = ("tests/", "benchmarks/", "examples/")
"""Folders that no step of an action or a workflow reads; act copies an action twice in each job."""
NESTED = re.compile(STEP + r"\./(?P<path>\.github/workflows/[\w.-]+\.ya?ml)", re.MULTILINE)


def prepare(
    source: Path,
    place: Path,
    payload: dict[str, Any],
    *,
    subject: str = "Everything",
    staged: Iterable[tuple[str, ...]] = (),
) -> Path:
    """Copy a caller to `place` and make it the git repository that act wants, on the branch or tag of the event.

    Our workflows that call a sibling by `./` are right on GitHub, but act looks in the caller: it gets copies of those,
    and a workflow of the caller's own that has such a name is put aside under `moved` of it. `subject` is the commit's,
    and `staged` are git's commands that change the index before it, for what no folder shows.
    """
    shutil.copytree(source, place, symlinks=True, ignore=shutil.ignore_patterns(".git"))
    for path in nested_workflows():
        target = place / path
        target.parent.mkdir(parents=True, exist_ok=True)
        if target.exists():
            target.rename(place / moved(path))
        shutil.copy(CHECKOUT / path, target)
    ref = str(payload.get("ref") or "refs/heads/main")
    branch = ref.removeprefix("refs/heads/") if ref.startswith("refs/heads/") else "main"
    name = str(payload.get("repository", {}).get("full_name") or "someone/something")
    identity = ("-c", "user.name=someone", "-c", "user.email=someone@example.org", "-c", "commit.gpgsign=false")
    # A fixed time: the commit's id is the same in every run.
    when = {"GIT_AUTHOR_DATE": "2026-01-01T00:00:00Z", "GIT_COMMITTER_DATE": "2026-01-01T00:00:00Z"}
    commands: list[tuple[str, ...]] = [
        ("init", "--quiet", f"--initial-branch={branch}"),
        ("remote", "add", "origin", f"https://github.com/{name}"),
        ("add", "--all", "--force"),
        *staged,
        ("commit", "--quiet", "--allow-empty", "--message", subject),
    ]
    if ref.startswith("refs/tags/"):
        commands.append(("tag", ref.removeprefix("refs/tags/")))
    for command in commands:
        run(["git", "-C", place, *identity, *command], env=when)
    return place


def commit(place: Path) -> str:
    """Return the commit of a prepared caller."""
    return run(["git", "-C", place, "rev-parse", "HEAD"]).strip()


def moved(path: str) -> str:
    """Return the path below the throw-away caller under which a workflow of the caller's is found."""
    if path not in nested_workflows():
        return path
    folder, _, name = path.rpartition("/")
    return f"{folder}/caller-{name}"


def nested_workflows() -> tuple[str, ...]:
    """Return the paths of our workflows that another of ours calls by `./`."""
    found: set[str] = set()
    for path in _workflows(CHECKOUT):
        if not path.name.startswith("."):
            found |= {match["path"] for match in NESTED.finditer(path.read_text())}
    return tuple(sorted(path for path in found if (CHECKOUT / path).is_file()))


def mappings(caller: Path, actions: Path | None = None) -> dict[str, Path]:
    """Return `OWNER/NAME@REF` -> folder for everything that the caller, our files and the actions themselves use.

    `actions`, else $REPRO_LAB_ACTIONS, is a folder of real actions in sub-folders OWNER__NAME, which replace the
    stand-ins. Raises LabError, naming them, when something is used that is in neither place.
    """
    chosen = actions or (Path(os.environ["REPRO_LAB_ACTIONS"]) if os.environ.get("REPRO_LAB_ACTIONS") else None)
    found: dict[str, Path] = {}
    missing: set[str] = set()
    seen: set[Path] = set()
    files = [CHECKOUT / "action.yml", *_workflows(CHECKOUT, own=False), *_workflows(caller)]
    while files:
        file = files.pop()
        if file in seen or not file.is_file():
            continue
        seen.add(file)
        for name, ref in _used(file):
            folder = program(CHECKOUT) if name == OURS else _action(name, chosen)
            if folder is None:
                missing.add(f"{name}@{ref} (in {file.name})")
                continue
            found[f"{name}@{ref}"] = folder
            files += [folder / "action.yml", folder / "action.yaml"]
    if missing:
        names = ", ".join(sorted(missing))
        raise LabError(f"no stand-in and no copy of: {names}; put one under tests/lab/actions/OWNER__NAME")
    return found


@cache
def program(checkout: Path) -> Path:
    """Return a copy of what a commit of the checkout would have but `UNREAD`, made once by each process.

    For every run act reads an action's whole folder into memory, where it may not change: a virtual environment in it
    costs more than the run does. Its modules are compiled here once: each run, or job of a workflow, would compile them
    anew in a folder of its own. A folder that is no checkout of git is returned as it is.
    """
    command = ["git", "-C", str(checkout), "ls-files", "-z", "--cached", "--others", "--exclude-standard"]
    answer = subprocess.run(command, capture_output=True, text=True, check=False)
    if answer.returncode:
        return checkout
    place = Path(tempfile.mkdtemp(prefix="repro-action-", dir=memory()))
    atexit.register(shutil.rmtree, place, ignore_errors=True)
    for name in filter(None, answer.stdout.split("\0")):
        if os.path.lexists(checkout / name) and not name.startswith(UNREAD):
            (place / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(checkout / name, place / name, follow_symlinks=False)
    # Valid without their sources' times, which act does not keep
    mode = py_compile.PycInvalidationMode.UNCHECKED_HASH
    compileall.compile_dir(place / "scripts", quiet=1, invalidation_mode=mode)
    return place


def _used(file: Path) -> Iterable[tuple[str, str]]:
    return ((match["name"], match["ref"]) for match in USES.finditer(file.read_text()))


def _action(name: str, chosen: Path | None) -> Path | None:
    folder = name.replace("/", "__")
    # act's own checkout copies the caller; only our self-checkout comes to the shim, which the real one cannot replace.
    places = (ACTIONS,) if chosen is None or name == "actions/checkout" else (chosen, ACTIONS)
    return next((place / folder for place in places if (place / folder).is_dir()), None)


def _workflows(place: Path, *, own: bool = True) -> list[Path]:
    """Return the workflow files of a checkout; without `own`, not those of its own CI, which begin with a dot."""
    return [
        path
        for path in sorted((place / ".github" / "workflows").glob("*.y*ml"))
        if own or not path.name.startswith(".")
    ]
