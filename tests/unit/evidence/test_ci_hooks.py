"""The commands that industrial_ci runs before and after its own steps."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.evidence.prose import ci
from roslab.repository.checkout import Repository

FETCHED = "wget http://example.org/sdk_amd64.deb -O /tmp/a.deb\ndpkg -i /tmp/a.deb\n"
SCRIPT = f"#!/bin/sh\n{FETCHED}apt-get install -y libsdk-dev\n"


@pytest.mark.parametrize(
    ("lines", "apt", "steps"),
    [
        ("env:\n  global:\n    - BEFORE_SCRIPT=./.sdk.sh\n", {"libsdk-dev"}, 2),
        ("env:\n  BEFORE_BUILD_TARGET_WORKSPACE: bash .sdk.sh\n", {"libsdk-dev"}, 2),
        ("env:\n  - ROS_DISTRO=noetic AFTER_INIT='apt-get install -y libusb-dev'\n", {"libusb-dev"}, 0),
        ("env:\n  - BEFORE_SCRIPT=./absent.sh\n", set(), 0),
        ("env:\n  - SCRIPT=./.sdk.sh\n", set(), 0),
    ],
)
def test_hooks(tmp_path: Path, lines: str, apt: set[str], steps: int) -> None:
    (tmp_path / ".travis.yml").write_text(lines)
    (tmp_path / ".sdk.sh").write_text(SCRIPT)
    found = ci.read(Repository.open(tmp_path))
    assert {each.name for each in found.dependencies if each.namespace == "apt"} == apt
    assert len([each for each in found.mentions if each.topic == "step"]) == steps
