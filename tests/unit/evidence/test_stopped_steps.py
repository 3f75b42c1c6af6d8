"""An author's Dockerfile with a step that stops on the release of its base."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.evidence.prose import author_dockerfile
from roslab.repository.checkout import Repository

EDGE = "echo http://dl-4.alpinelinux.org/alpine/edge/testing >> /etc/apk/repositories && apk add --no-cache eigen-dev"
OLD = "echo http://dl-4.alpinelinux.org/alpine/v3.{}/main > /etc/apk/repositories"
WHY = "line {} takes packages of Alpine's edge, whose keys of 2021 Alpine 3.10 and older never got"


def problem(tmp_path: Path, text: str) -> str | None:
    (tmp_path / "Dockerfile").write_text(f"{text}\nCOPY . /opt/demo\nRUN make -C /opt/demo\n")
    (tmp_path / "Makefile").write_text("demo: demo.c\n")
    return author_dockerfile.read(Repository.open(tmp_path))[0].problem


@pytest.mark.parametrize(
    ("text", "line"),
    [
        (f"FROM alpine:3.8\nRUN {EDGE}", 2),
        (f"FROM alpine:3.10.2\nRUN apk update\nRUN {EDGE}", 3),
        (f"FROM lab/cluon:latest AS builder\nRUN {OLD.format(7)} && {EDGE}", 2),
        (f"FROM lab/cluon:latest\nRUN {OLD.format(9)}\nRUN {EDGE}", 3),
    ],
)
def test_old_alpine_cannot_take_packages_of_edge(tmp_path: Path, text: str, line: int) -> None:
    assert problem(tmp_path, text) == WHY.format(line)


@pytest.mark.parametrize(
    "text",
    [
        f"FROM alpine:3.19\nRUN {EDGE}",
        f"FROM alpine:edge\nRUN {EDGE}",
        f"FROM lab/cluon:latest\nRUN {EDGE}",
        f"FROM alpine:3.8\nRUN ({EDGE}) || true",
        f"FROM lab/cluon:latest\nRUN {OLD.format(18)} && {EDGE}",
        f"FROM alpine:3.8\nRUN {OLD.format(8)} && apk add --no-cache eigen-dev",
    ],
)
def test_a_newer_one_or_none_may(tmp_path: Path, text: str) -> None:
    assert problem(tmp_path, text) is None
