"""What a job of GitLab's CI installs to bring something out is none of what the repository needs."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.evidence.prose import ci
from roslab.repository.checkout import Repository

JOBS = """\
stages: [test, STAGE]

tests:
  stage: test
  image: python:3.9-bullseye
  script: apt-get install -y libeigen3-dev

catalogue:  # of the laboratory
  image: ubuntu:18.04
  stage: STAGE
  script:
  # not indented
  - apt-get install -y wget

more:
  script:
    - apt-get install -y libusb-1.0-0-dev
"""


@pytest.mark.parametrize(
    ("stage", "file", "aside"),
    [
        ("deploy", ".gitlab-ci.yml", True),
        ("'Publish'", ".gitlab/ci.yml", True),
        ("upload-release", ".gitlab-ci.yml", True),
        ("redeployable", ".gitlab-ci.yml", False),
        ("build", ".gitlab-ci.yml", False),
        ("deploy", ".travis.yml", False),
    ],
)
def test_what_a_job_installs(tmp_path: Path, stage: str, file: str, *, aside: bool) -> None:
    (tmp_path / file).parent.mkdir(exist_ok=True)
    (tmp_path / file).write_text(JOBS.replace("STAGE", stage), encoding="utf-8")
    said = ci.read(Repository.open(tmp_path))
    names = [each.name for each in said.dependencies]
    assert names == ["libeigen3-dev", *(["wget"] if not aside else []), "libusb-1.0-0-dev"]
    assert [each.value for each in said.mentions if each.topic == "base"] == [
        "python:3.9-bullseye",
        *(["ubuntu:18.04"] if not aside else []),
    ]
