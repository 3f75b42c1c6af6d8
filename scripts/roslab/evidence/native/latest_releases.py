"""Archives that a file of CMake fetches of whichever release is the newest when the image is built.

https://docs.github.com/en/repositories/releasing-projects-on-github/linking-to-releases, read 2026-11-27
"""

from __future__ import annotations

from collections.abc import Iterator

from roslab.evidence.lex.cmake import Call, calls
from roslab.evidence.lex.truth import cmake_holds
from roslab.evidence.native.x86 import cmake_files
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

_LATEST = "/releases/latest/download/"
_FETCHING = frozenset({"file", "fetchcontent_declare", "externalproject_add", "cpmaddpackage"})
_URL = pattern(r"https://[^/\s]{1,100}/[^\s\"]{1,300}")


def read(repository: Repository) -> Iterator[tuple[str, str, int]]:
    """Yield what the author should know of each such address: the message, the file and the line."""
    told: set[str] = set()
    for file in cmake_files(repository):
        text = repository.read(file)
        for call in calls(text, _FETCHING) if _LATEST in text else ():
            if _passed_by(call):
                continue
            words = (word for word in call.words if _LATEST in word and _URL.fullmatch(word))
            url = next(words, None) if call.name != "file" or call.words[:1] == ("DOWNLOAD",) else None
            if url is not None and url not in told:
                told.add(url)
                repeated = url.replace(_LATEST, "/releases/download/TAG/")
                why = (
                    "is of the newest release on the day of each build, so that no image is the same as the one before"
                )
                yield f"{url} {why}; name a release: {repeated}", file.path, call.line


def _passed_by(call: Call) -> bool:
    """Tell whether a call waits for what is not so in an image, or for an option that is off.

    What is sought (``if(NOT viewer_FOUND)``) is fetched where it is not there.
    """
    known = (condition for condition in call.conditions if "_FOUND" not in condition)
    return any(cmake_holds(condition, lambda _: False) is False for condition in known)
