"""What CMake fetches of the newest release is another thing on another day, and told."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.evidence.native import latest_releases
from trees import tree_of

LATEST = "https://github.com/lab/viewer/releases/latest/download/viewer_sdk.zip"
TAGGED = "https://github.com/lab/viewer/releases/download/0.9.0/viewer_sdk.zip"


@pytest.mark.parametrize(
    ("line", "told"),
    [
        (f"FetchContent_Declare(viewer URL {LATEST})", True),
        (f"file(DOWNLOAD {LATEST} viewer.zip)", True),
        (f"ExternalProject_Add(viewer\n  URL {LATEST})", True),
        (f"FetchContent_Declare(viewer URL {TAGGED})", False),
        (f"if(WIN32) # windows\nFetchContent_Declare(viewer URL {LATEST})\nendif()", False),
        (f'option(VIEWER "draw" OFF)\nif(VIEWER)\nFetchContent_Declare(viewer URL {LATEST})\nendif()', False),
        (f"# FetchContent_Declare(viewer URL {LATEST})", False),
        (f'message(STATUS "get it at {LATEST}")', False),
    ],
)
def test_an_archive_of_the_newest_release(tmp_path: Path, line: str, *, told: bool) -> None:
    found = list(latest_releases.read(tree_of(tmp_path, {"CMakeLists.txt": f"project(a)\n{line}\n{line}\n"})))
    assert len(found) == told
    for message, file, at in found:
        assert message.startswith(f"{LATEST} is of the newest release on the day of each build")
        assert message.endswith("/lab/viewer/releases/download/TAG/viewer_sdk.zip")
        assert (file, at) == ("CMakeLists.txt", 2)


@pytest.mark.parametrize(
    "before", ["if(NOT WIN32)", "if(NOT viewer_FOUND)", "if(NOT EXISTS viewer.zip)", "option(VIEWER x ON)\nif(VIEWER)"]
)
def test_one_that_may_be_fetched_below_a_condition(tmp_path: Path, before: str) -> None:
    cmake = f"project(a)\n{before}\nfile(DOWNLOAD {LATEST} viewer.zip)\nendif()\n"
    assert len(list(latest_releases.read(tree_of(tmp_path, {"CMakeLists.txt": cmake})))) == 1
