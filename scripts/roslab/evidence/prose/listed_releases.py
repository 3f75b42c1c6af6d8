"""Releases of libraries in the lists of what a page requires: ``OpenCV3``, ``PCL 1.8``."""

from __future__ import annotations

import re

from roslab.evidence.code_limit import CodeLimit
from roslab.evidence.prose import page_lists
from roslab.evidence.prose.pages import pages, text_of
from roslab.knowledge.code_limits import bounds_of
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern
from roslab.values.version import Version

_LIBRARIES = {
    "opencv": "OpenCV",
    "pcl": "PCL",
    "boost": "Boost",
    "eigen": "Eigen3",
    "ceres": "Ceres",
    "gtsam": "GTSAM",
    "pangolin": "Pangolin",
}
"""What pages call those of which the versions of each Ubuntu are known, and those that are built from their source."""
_NAMED = pattern(
    rf"^({'|'.join(_LIBRARIES)})(?:[ -]solver)?[\s-]{{0,9}}(?:version\s{{0,9}}|v\.?\s{{0,9}})?"
    r"(>=|≥|>|==?)?\s{0,9}v?(\d{1,2}(?:\.\d{1,3}){0,2}(?:a\d{1,2})?)"
    r"(?:\.x)?(\+|\s*\(?(?:or|and)\s+(?:newer|later|above|higher|greater|up)\w*\)?)?(?=$|[\s),.;:])",
    re.IGNORECASE,
)
_URL = pattern(r"https?://\S+")
_RECOMMENDED = pattern(r"\([^()]{0,200}\brecommended\b[^()]{0,50}\)", re.IGNORECASE)
"""A newer release that fits as well: ``PCL 1.7+ (1.10.0 recommended)``."""
_OTHER = pattern(r"\d|\b(?:optional(?:ly)?|not|only (?:for|if))\b")
"""What follows a release that is not the only one, or not needed."""


def _behind(text: str) -> str:
    """Return what stands behind a release, without addresses and what is only recommended."""
    return _RECOMMENDED.sub("", _URL.sub("", text)).lower()


def read(repository: Repository) -> tuple[CodeLimit, ...]:
    """Return the bounds that lists on the pages at the root give, each library's at its first place.

    A release of a library that changes with its first number is any of that number: of ``OpenCV 3.4`` an Ubuntu with
    3.2 has enough more often than one with 4.5.
    """
    found: dict[str, CodeLimit] = {}
    for file in (page for page in pages(repository) if "/" not in page.path):
        for line, item in page_lists.items(text_of(repository, file)):
            match = _NAMED.match(item.strip())
            if match is None or _OTHER.search(_behind(item.strip()[match.end() :])):
                continue
            library = _LIBRARIES[match[1].lower()]
            number, below = bounds_of(library, match[3])
            least = bool(match[4]) or match[2] in {">=", "≥", ">"}
            limit = CodeLimit(
                library=library,
                at_least=str(Version(number).major) if below and not least else number,
                below=None if least else below,
                what=match[0].strip(),
                file=file.path,
                line=line,
            )
            found.setdefault(library, limit)
    return tuple(found.values())
