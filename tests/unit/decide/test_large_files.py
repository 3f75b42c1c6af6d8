"""Files of Git LFS in what is cloned, where a page has its reader get them."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.pipeline import plan_repository
from roslab.render.dockerfile import dockerfile

FILES = {
    "package.xml": "<package format='3'><name>demo</name><buildtool_depend>ament_cmake</buildtool_depend>"
    "<depend>arm_description</depend></package>",
    "CMakeLists.txt": "project(demo)\nfind_package(ament_cmake REQUIRED)\nament_package()\n",
}
LISTED = "repositories:\n  arm_description:\n    type: git\n    url: https://github.com/lab/arm_description.git\n"


@pytest.mark.parametrize(
    ("step", "listed", "fetched"),
    [
        ("```\ngit lfs install\nvcs import src < all.repos\n```", True, True),
        ("```\n$ git lfs pull\n```", True, True),
        ("```\ngit lfs install\n```", False, False),  # nothing is cloned
        ("```\nvcs import src < all.repos\n```", True, False),
        ("It has no git lfs install.", True, False),
    ],
)
def test_they_are_fetched_before_what_is_cloned(tmp_path: Path, step: str, listed: bool, fetched: bool) -> None:
    files = {**FILES, "README.md": f"# Demo\n\nROS 2 Humble\n\n{step}\n"} | ({"all.repos": LISTED} if listed else {})
    for path, text in files.items():
        (tmp_path / path).write_text(text)
    text = dockerfile(plan_repository(tmp_path).plan)
    assert ("git lfs install --system" in text) is fetched
    if fetched:
        assert text.index(" git-lfs") < text.index("git lfs install") < text.index("/lab/arm_description.git")
