"""Pages of tools that lie beside the packages of a repository for ROS: a trainer on another machine, a converter."""

from __future__ import annotations

import re
from collections.abc import Sequence

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
