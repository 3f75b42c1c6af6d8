"""Libraries that lie in the tree and that a page, or a script that it runs, compiles there before all else."""

from __future__ import annotations

from collections.abc import Collection

from roslab.config.model import Config, Kind
from roslab.decide.decision import Choice
from roslab.decide.reasons import because
from roslab.evidence import places
from roslab.evidence.facts import Evidence, Mention

WEIGHT = 300
"""Sources do not compete, so it only orders the report."""


def compiled_inside(evidence: Evidence, config: Config, kind: Kind) -> Choice[tuple[tuple[str, str], ...]]:
    """Return the folders to compile with CMake where they lie, each with its options, in the order of the page.

    Only copied libraries and submodules: examples and the project itself are no need of it.
    """
    if config.compatible or config.build or kind == "python":
        return Choice(answer=())
    absent = [git.name for git in evidence.sources if git.kind == "submodule"]
    folders = {project.file.rpartition("/")[0] for project in evidence.cmake if places.vendored(project.file)}
    folders = {folder for folder in {*folders, *absent} if folder}
    folders -= {manifest.file.rpartition("/")[0] for manifest in evidence.manifests}
    run = {file for m in evidence.mentions if m.topic == "command" for file in m.files}
    found: dict[str, Mention] = {}
    for mention in evidence.mentions:
        if mention.topic == "compiled" and (mention.source == "readme" or mention.file in run):
            folder = _meant(mention.value, folders)
            if folder and not places.vendored(mention.file):
                found.setdefault(folder, mention)
    why = "it is compiled where it lies"
    return Choice(
        answer=tuple((folder, mention.text) for folder, mention in found.items()),
        reasons=tuple(because("source", folder, why, mention, weight=WEIGHT) for folder, mention in found.items()),
    )


def _meant(path: str, folders: Collection[str]) -> str | None:
    """Return the folder that a path ends with, or the only one that ends with it: a page may begin anywhere."""
    whole = [folder for folder in folders if f"/{path}".endswith(f"/{folder}")]
    part = [folder for folder in folders if f"/{folder}".endswith(f"/{path}")]
    return max(whole, key=len) if whole else part[0] if len(part) == 1 else None
