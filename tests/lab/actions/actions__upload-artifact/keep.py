"""Keep files as actions/upload-artifact does, which this stands in for: below their nearest common folder."""

from __future__ import annotations

import os
import shutil
import sys
from collections.abc import Mapping
from pathlib import Path


def expand(pattern: str) -> list[Path]:
    """Return what a path or a pattern names, absolute."""
    path = Path(pattern).absolute()
    if path.exists():
        return [path]
    return sorted(Path(path.anchor).glob(str(path.relative_to(path.anchor))))


def files(patterns: list[str], *, hidden: bool) -> list[Path]:
    """Return the files of all patterns; one that begins with `!` takes files out again.

    Hidden are files and folders whose name begins with a dot, below what a pattern names; above it no name matters.
    """
    found: dict[Path, None] = {}
    for pattern in patterns:
        for path in expand(pattern.lstrip("!")):
            for file in [path] if path.is_file() else sorted(inner for inner in path.rglob("*") if inner.is_file()):
                names = (file.name,) if file == path else file.relative_to(path).parts
                if pattern.startswith("!"):
                    found.pop(file, None)
                elif hidden or not any(name.startswith(".") for name in names):
                    found[file] = None
    return list(found)


def main(environment: Mapping[str, str]) -> int:
    """Copy the files and write the outputs; return 1 when there are none and that is an error."""
    name = environment["ARTIFACT_NAME"]
    patterns = [line.strip() for line in environment["ARTIFACT_PATH"].splitlines() if line.strip()]
    kept = files(patterns, hidden=environment["ARTIFACT_HIDDEN"] == "true")
    if not kept:
        level = environment["ARTIFACT_MISSING"]
        if level != "ignore":
            kind = "error" if level == "error" else "warning"
            print(f"::{kind}::No files were found with the provided path: {patterns}")
        return 1 if level == "error" else 0
    store = Path(environment["REPRO_LAB_ARTIFACTS"])
    target, mark = store / name, store / f".attempt-of-{name}"
    attempt = environment.get("GITHUB_RUN_ATTEMPT", "1")
    if target.exists() and mark.read_text() != attempt:
        # GitHub keeps both attempts' and gives out the one of the higher id, which need not be the newer
        if environment.get("REPRO_LAB_IDS") == "descending":
            print(f"kept as {name}, below an older one of a higher id")
            return 0
        shutil.rmtree(target)
    elif target.exists():
        if environment["ARTIFACT_OVERWRITE"] != "true":
            print(f"::error::an artifact with the name {name} exists already (409 Conflict)")
            return 1
        shutil.rmtree(target)
    folder = len(patterns) == 1 and Path(patterns[0]).is_dir()
    root = Path(patterns[0]).absolute() if folder else Path(os.path.commonpath([path.parent for path in kept]))
    for path in kept:
        place = target / path.relative_to(root)
        place.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(path, place)
    mark.write_text(attempt)
    number = len(list(target.parent.iterdir()))
    with Path(environment["GITHUB_OUTPUT"]).open("a", encoding="utf-8") as handle:
        handle.write(f"artifact-id={number}\nartifact-url=file://{target}\n")
    print(f"kept {len(kept)} files as {name}")
    return 0


if __name__ == "__main__":
    sys.exit(main(os.environ))
