"""Rung 4 without a ``test`` in roslab.yaml: tests that the tree holds, which nobody promised to pass."""

from __future__ import annotations

from collections.abc import Sequence

from roslab.decide.decision import Decision
from roslab.plan.proof import Proof
from roslab.plan.ros_build import ROS_TOOLS
from roslab.plan.workspace import Workspace

ROSTEST_SCRIPT = 'failed=0; for file in "$@"; do rostest "$file" || failed=1; done; exit $failed'
MOST_LAUNCHES = 3
"""Most launch files with tests that are tried; each starts a ROS of its own."""
MOST_FILES = 40
"""Most files of tests in Python."""
TEST_SECONDS = 120
"""Seconds that the tests of one runner may take, which nobody asked for."""
PYTEST_SCRIPT = """\
if python3 -c 'import pytest' 2>/dev/null; then exec python3 -m pytest -p no:cacheprovider "$@"; fi
echo 'the image has no pytest'; exit 127
"""
UNITTEST_SCRIPT = """\
if python3 -c 'import pytest' 2>/dev/null; then exec python3 -m pytest -p no:cacheprovider "$@"; fi
failed=0
for file in "$@"; do
  python3 -m unittest discover --start-directory "$(dirname "$file")" --pattern "$(basename "$file")" || failed=1
done
exit $failed
"""
"""Without pytest the standard library's own runner, by the path of each file: a folder need not be a package."""
LAUNCH_SCRIPT = """\
command -v launch_test >/dev/null || { echo 'the image has no launch_test'; exit 127; }
failed=0; for file in "$@"; do launch_test "$file" || failed=1; done; exit $failed
"""


def found_tests(decision: Decision, place: Workspace) -> list[Proof]:
    """Return a proof for each runner that has something to run: each is tried, and told."""
    found = []
    if decision.workspace != "none" and decision.build_tool in ROS_TOOLS:
        found.append(_told("rostests", ROSTEST_SCRIPT, decision.rostests, MOST_LAUNCHES))
    launched = [test.file for test in decision.tests if test.runner == "launch_test"]
    found.append(_told("launch tests", LAUNCH_SCRIPT, launched, MOST_LAUNCHES))
    others = [test for test in decision.tests if test.runner != "launch_test"]
    script = UNITTEST_SCRIPT if all(test.runner == "unittest" for test in others) else PYTEST_SCRIPT
    found.append(_told("files of Python tests", script, [test.file for test in others], MOST_FILES))
    if decision.ctest and place.program and not decision.dockerfile:
        found.append(_told("tests of CMake", 'cd && cd "$1" && ctest --output-on-failure', [place.program.build], 1))
    return [proof for proof in found if proof]


def _told(name: str, script: str, files: Sequence[str], most: int) -> Proof | None:
    """Return the proof of some files, ``None`` where there is none; its name says whether these are all."""
    chosen, all_of = files[:most], len(files)
    if not chosen:
        return None
    named = f"the repository's {name}" if len(chosen) == all_of else f"{most} of the repository's {all_of} {name}"
    command = ("bash", "-c", script, "proof", *chosen)
    return Proof(name=named, command=command, required=False, rung=4, limit=TEST_SECONDS)
