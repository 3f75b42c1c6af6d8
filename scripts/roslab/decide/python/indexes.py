"""Where pip looks for packages beyond its own index: pages of wheels, and what the project's lists add."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from roslab.decide.python.manifests import with_includes
from roslab.decide.python.packages import Chosen
from roslab.decide.python.refused import Repaired
from roslab.decide.python.torch_build import OLDEST_PAGE, ON_INDEX, ONE_PAGE_BEFORE
from roslab.evidence.facts import Evidence, RequirementFile
from roslab.values.pattern import pattern
from roslab.values.requirement import Requirement
from roslab.values.version import Version

_WITH_LOCAL_VERSIONS = frozenset({"torch", "torchvision", "torchaudio"})
_PLACES = pattern(r"--(?:extra-index-url|find-links) https?://")
"""An option that adds a place to look for packages; a folder is found from the file alone."""


_BUILDS = pattern(r"(?:cu|rocm)\d[\d.]*|cpu|xpu|" + re.escape(OLDEST_PAGE))
"""Local versions that have a page of wheels; others are an author's own builds."""


def indexes_of(asked: Sequence[Requirement], files: Sequence[RequirementFile]) -> Iterator[str]:
    """Yield the index or page with the wheels of a torch that pip's index lacks and whose page no file names.

    That is one with a local version (``+cu113``), and each release before 1.0
    (https://github.com/beholdergan/Beholder-GAN/issues/7, read 2026-11-24).
    """
    in_files = " ".join(option for file in files for option in file.options if _PLACES.match(option))
    for each in asked:
        release = Version(each.release) if each.release and each.key in _WITH_LOCAL_VERSIONS and not each.url else None
        build = release.local or (OLDEST_PAGE if each.key == "torch" and release < ON_INDEX else "") if release else ""
        if release is not None and build and _BUILDS.fullmatch(build) and f"/whl/{build}" not in in_files:
            page = f"https://download.pytorch.org/whl/{build}"
            old = each.key == "torch" and release < ONE_PAGE_BEFORE
            yield f"--find-links {page}/torch_stable.html" if old else f"--extra-index-url {page}"


def file_options(evidence: Evidence, chosen: Chosen, repaired: Repaired, *, by_name: bool) -> list[str]:
    """Return the pip options in files whose lines are installed one by one, and the further indexes of the others.

    ``by_name``: something is installed in a step of its own. It may be a package of such a file, which only they have.
    """
    broken = [file for file in chosen.files if file.file in repaired.files]
    whole = [file for file in chosen.files if file not in broken] if by_name else []
    further = [each for file in with_includes(evidence, whole) for each in file.options if _PLACES.match(each)]
    return [*(option for file in with_includes(evidence, broken) for option in file.options), *further]
