"""Files of tests in Python, and which runner knows how to start them."""

from __future__ import annotations

import re

from roslab.evidence import places
from roslab.evidence.facts import Runner, TestFile
from roslab.repository.checkout import Repository, nearest
from roslab.values.pattern import pattern

_NAMED = pattern(r"^test_.*\.py$|_test\.py$|\.test\.py$")
"""https://docs.pytest.org/en/stable/explanation/goodpractices.html#conventions-for-python-test-discovery, and those of
https://github.com/ros2/launch/tree/rolling/launch_testing"""
_STYLE = pattern(r"^\s*(?:from|import)\s+ament_\w+", re.MULTILINE)
"""Checkers of style that `ros2 pkg create` writes into every package: they say nothing of what the code does.
https://github.com/ament/ament_lint"""
_REGISTERED = pattern(r"\badd_(?:launch|ros|ros_isolated_launch)_test\s{0,20}\(\s{0,80}\"?[\w./-]{1,200}\.py\b")
"""https://github.com/ros2/launch/tree/rolling/launch_testing_ament_cmake and https://github.com/ros2/ros_testing"""
_COMMENT = pattern(r"#[^\n]*")
MAX_FILES = 200
"""Most files that are read."""


def read(repository: Repository) -> tuple[TestFile, ...]:
    """Return the files whose tests start by themselves, sorted by path; those that a rostest starts are left out.

    Where the CMakeLists.txt of a package registers launch tests, one that it does not name is left out.
    """
    files = [file for file in repository.suffixed(".py") if _NAMED.search(file.name) and not places.vendored(file.path)]
    found = ((file.path, _runner(repository.read(file))) for file in nearest(files)[:MAX_FILES])
    tests = tuple(TestFile(file=path, line=1, runner=runner) for path, runner in sorted(found) if runner)
    lists = _registering(repository) if any(test.runner == "launch_test" for test in tests) else {}
    return tuple(test for test in tests if test.runner != "launch_test" or _registered(test.file, lists))


def _registering(repository: Repository) -> dict[str, str]:
    """Return each CMakeLists.txt that registers launch tests by their files, without its comments, by its folder."""
    lists = ((file, repository.read(file)) for file in repository.named("CMakeLists.txt"))
    texts = {file.path.rpartition("/")[0]: _COMMENT.sub("", text) for file, text in lists if "_test" in text}
    return {folder: text for folder, text in texts.items() if _REGISTERED.search(text)}


def _registered(path: str, lists: dict[str, str]) -> bool:
    """Tell whether the nearest of these lists above a file names it; true where there is none."""
    folder, _, name = path.rpartition("/")
    parts = folder.split("/") if folder else []
    above = ("/".join(parts[:count]) for count in range(len(parts), -1, -1))
    closest = next((each for each in above if each in lists), None)
    return closest is None or name in lists[closest]


def _runner(text: str) -> Runner | None:
    if "rostest" in text or ("ament_" in text and _STYLE.search(text)):
        return None
    if "generate_test_description" in text:
        return "launch_test"
    if "TestCase" in text:
        return "unittest"
    return "pytest" if "def test" in text else None
