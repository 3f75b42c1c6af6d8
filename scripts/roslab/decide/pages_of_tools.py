"""Pages of tools that lie beside the packages of a repository for ROS: a trainer on another machine, a converter."""

from __future__ import annotations

import re
from collections.abc import Collection, Sequence

from roslab.decide.candidate import Candidate
from roslab.evidence import places
from roslab.evidence.facts import Evidence
from roslab.values.pattern import pattern

_SCRIPT = ("python", "bash")
_WIKI = pattern(r"(?:^|/)(?:[\w-]+\.)?wiki/", re.IGNORECASE)


def of_a_tool(candidate: Candidate, packages: Sequence[str], evidence: Evidence) -> bool:
    """Tell whether the page of a folder without packages runs a script, in a tree whose packages have launch files.

    ``packages``: their folders, ``a/b/``. Documentation is about the whole, and of a package at the root all is a part.
    """
    folder = f"{candidate.file.rpartition('/')[0]}/"
    if folder == "/" or not candidate.argv[0].startswith(_SCRIPT) or not any(each.package for each in evidence.launch):
        return False
    of_all = any("/" not in manifest.file for manifest in evidence.manifests)
    of_all = of_all or places.documentation(candidate.file) or bool(_WIKI.search(candidate.file))
    return not of_all and not any(folder.startswith(each) or each.startswith(folder) for each in packages)


def starting_packages(evidence: Evidence, names: Collection[str | None]) -> frozenset[str]:
    """Return the files of Python and scripts that start something of the tree's packages, by these names."""
    return frozenset(each.file for each in evidence.mentions if each.topic == "calls" and each.value in names)


def outside(candidate: Candidate, folders: tuple[str, ...], starting: Collection[str], *, many: bool) -> bool:
    """Tell whether a command starts a file of Python that no package has: not what starts the packages, at the root.

    ``folders``: those of the packages, ``a/b/``; of ``many``, what a page of one of them runs is no part of the whole.
    """
    if not candidate.argv[0].startswith("python") or ("/" not in candidate.file and candidate.argv[1] in starting):
        return False
    return not candidate.argv[1].startswith(folders) or (many and candidate.file.startswith(folders))
