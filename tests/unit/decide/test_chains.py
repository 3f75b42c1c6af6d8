"""An author's Dockerfile on an image that a page builds first, from another Dockerfile of the tree."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from roslab.decide.decision import Decision
from roslab.pipeline import plan_repository, write_bases

Tree = Callable[[dict[str, str]], Decision]
BASE = "FROM ubuntu:22.04\nRUN apt-get update\n"
OWN = "FROM lab-base\nCOPY . /app\nCMD python3 /app/walk.py\n"
PAGE = "```\n{command}\ndocker build -t walk .\n```\n"
FIRST = "docker build -t lab-base docker/base"


def files(
    base: str = BASE, command: str = FIRST, own: str = OWN, path: str = "docker/base/Dockerfile"
) -> dict[str, str]:
    return {path: base, "Dockerfile": own, "walk.py": "print(1)\n", "README.md": PAGE.format(command=command)}


@pytest.mark.parametrize(
    ("command", "path"),
    [
        (FIRST, "docker/base/Dockerfile"),
        ("docker build -t lab-base:latest ./docker/base/", "docker/base/Dockerfile"),
        ("docker build -f docker/base.Dockerfile --tag lab-base .", "docker/base.Dockerfile"),
        ("docker build --file=docker/base.Dockerfile --tag=lab-base .", "docker/base.Dockerfile"),
        ("cd docker && docker build -t lab-base -f base.Dockerfile . && cd ..", "docker/base.Dockerfile"),
    ],
)
def test_the_base_is_built_first(tree: Tree, command: str, path: str) -> None:
    found = tree(files(command=command, path=path))
    assert found.dockerfile == "Dockerfile"
    assert [(base.name, base.image, base.recipe) for base in found.bases] == [("lab-base", "ubuntu:22.04", BASE)]
    assert found.base_image == "ubuntu:22.04"


@pytest.mark.parametrize(
    ("base", "command", "why"),
    [
        (f"{BASE}COPY walk.py /\n", FIRST, "which copies files of its own"),
        (f"{BASE}ADD . /src\n", FIRST, "which copies files of its own"),
        (f"{BASE}RUN --mount=type=bind,target=/src make\n", FIRST, "which copies files of its own"),
        (f"# escape=`\n{BASE}", FIRST, "which copies files of its own"),
        (f"{BASE}RUN --mount=type=secret,id=key cat /run/secrets/key\n", FIRST, "which mounts a secret"),
        (BASE, FIRST.replace("-t", "--build-arg A=1 -t"), "with arguments of its own"),
        ("FROM ubuntu:16.04\n", FIRST, "xenial ended on"),
        ("FROM ros:kinetic\n", FIRST, "ROS kinetic ended on"),
        ("FROM nvidia/cuda:10.0-devel-ubuntu18.04\n", FIRST, "CUDA 11.0 is the nearest that has images"),
        ("FROM other-base\n", FIRST, "whose base other-base is not known"),
        ("ARG A\nFROM $A\n", FIRST, "docker/base/Dockerfile"),
    ],
)
def test_a_base_that_cannot_be_built_first_is_refused_with_its_reason(
    tree: Tree, base: str, command: str, why: str
) -> None:
    found = tree(files(base=base, command=command))
    assert found.dockerfile is None
    against = [reason.reason for reason in found.reasons if reason.question == "dockerfile"]
    assert any(
        "line 2 of README.md builds first, from docker/base/Dockerfile" in each and why in each for each in against
    )


def test_two_files_that_the_command_may_mean_are_none(tree: Tree) -> None:
    command = "docker build -t lab-base -f base.Dockerfile ."
    found = tree({**files(command=command, path="a/base.Dockerfile"), "b/base.Dockerfile": BASE})
    assert found.dockerfile is None


def test_the_authors_steps_are_a_stage_under_the_name_of_the_base(tmp_path: Path) -> None:
    base = "# syntax=docker/dockerfile:1\nARG RELEASE=22.04\nFROM ubuntu:$RELEASE AS tools\nRUN true\n"
    base += "FROM ubuntu:${RELEASE} AS final\nCOPY --from=tools /bin/true /true\nADD https://example.org/a /a\n"
    for path, text in files(base=base).items():
        (tmp_path / path).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / path).write_text(text)
    plan = plan_repository(tmp_path).plan
    (tmp_path / "made").mkdir()
    file = write_bases(plan, tmp_path / "made")
    assert file
    lines = [line for line in file.read_text().splitlines() if line and not line.startswith("#")]
    assert lines == [
        "ARG RELEASE=22.04",
        "FROM ubuntu:$RELEASE AS tools",
        "RUN true",
        "FROM ubuntu:${RELEASE} AS base-1",
        "COPY --from=tools /bin/true /true",
        "ADD https://example.org/a /a",
    ]
