"""Pins that a bot raised past every Python of the rest of their list."""

from __future__ import annotations

import os
import subprocess
from pathlib import Path

import pytest

from roslab.decide.decision import Decision
from roslab.pipeline import plan_repository

OLD = "numpy==1.20.3\nscipy==1.3.3\ntqdm==4.61.1\n"
WHO = {f"GIT_{one}_{what}": "a@b" for one in ("AUTHOR", "COMMITTER") for what in ("NAME", "EMAIL")}
DOCKERFILE = "FROM python:3.8\nCOPY . /app\nWORKDIR /app\nRUN pip install -r requirements.txt\nCMD python main.py\n"


def decided(folder: Path, *steps: tuple[str, str], dockerfile: str = "") -> Decision:
    (folder / "main.py").write_text("import torch\n\nprint(torch.ones(1))\n", encoding="utf-8")
    if dockerfile:
        (folder / "Dockerfile").write_text(dockerfile, encoding="utf-8")
    subprocess.run(["git", "init", "-q"], cwd=folder, check=True)
    for subject, release in steps:
        (folder / "requirements.txt").write_text(f"{OLD}torch=={release}\n", encoding="utf-8")
        for words in (("add", "."), ("commit", "-qm", subject)):
            subprocess.run(["git", *words], cwd=folder, env={**os.environ, **WHO}, check=True)
    return plan_repository(folder).decision


def told(found: Decision) -> list[tuple[str, int | None]]:
    return [(each.message, each.line) for each in found.warnings if "a bot raised it" in each.message]


MEANT = (
    "torch==2.6.0: no Python has wheels for it and for all other pins of requirements.txt, and a bot raised it;"
    " torch=={} of before fits them with Python 3.8: pin that one again"
)


@pytest.mark.parametrize("dockerfile", ["", DOCKERFILE])
@pytest.mark.parametrize(
    ("subjects", "release"),
    [
        (("Bump torch from 1.8.0 to 2.2.0", "Bump torch from 2.2.0 to 2.6.0"), "2.2.0"),
        (("work", "build(deps): bump torch from 2.2.0 to 2.6.0 in /demo (#3)"), "2.2.0"),
        (("Update torch from 1.8.0 to 2.5.0", "Bump torch from 2.5.0 to 2.6.0"), "1.8.0"),
    ],
)
def test_the_newest_release_of_before_that_fits_is_named(
    tmp_path: Path, subjects: tuple[str, str], release: str, dockerfile: str
) -> None:
    found = decided(tmp_path, ("all", "1.8.0"), (subjects[0], "2.2.0"), (subjects[1], "2.6.0"), dockerfile=dockerfile)
    assert (found.dockerfile is not None) == bool(dockerfile)
    assert told(found) == [(MEANT.format(release), 4)]


@pytest.mark.parametrize(
    ("subject", "release"),
    [
        ("Take a newer torch", "2.6.0"),  # its author did
        ("Bump torchvision from 2.2.0 to 2.6.0", "2.6.0"),
        ("Bump torch from 2.5.0 to 2.6.0", "2.6.0"),  # the one of before fits no better
        ("Bump torch from 1.8.0 to 2.2.0", "2.2.0"),  # there is a Python for all
    ],
)
def test_nothing_is_told_of_a_pin_that_was_not_raised_or_fits(tmp_path: Path, subject: str, release: str) -> None:
    assert told(decided(tmp_path, ("all", "1.8.0"), (subject, release))) == []
