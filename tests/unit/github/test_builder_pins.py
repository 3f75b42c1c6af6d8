"""What the builder itself runs is one version, the same through both doors, until a maintainer renews it."""

from __future__ import annotations

import csv
import re
import sys
from pathlib import Path

import pytest

from roslab.github import builder
from roslab.knowledge.pins import pin
from roslab.knowledge.table import rows

ROOT = Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "scripts"))

import pins  # noqa: E402 - a maintainer's script, beside the package

DIGEST = "sha256:" + "a" * 64
VERSION = re.compile(r"(?:qemu-)?v?\d+\.\d+\.\d+(?:-\d+)?")
"""A tag that its makers do not move."""


def test_a_runners_builder_is_pinned() -> None:
    found = builder.settings({})
    assert found["buildx"] == pin("buildx").version
    assert found["driver-opts"] == f"image={pin('buildkit').reference}"
    assert found["binfmt"] == pin("binfmt").reference


def test_a_machines_own_builder_is_left_as_it_is() -> None:
    found = builder.settings({"ROSLAB_BUILDX_DRIVER": "remote", "ROSLAB_BUILDX_ENDPOINT": "unix:///x"})
    assert (found["driver"], found["endpoint"]) == ("remote", "unix:///x")
    assert found["buildx"] == found["driver-opts"] == ""


@pytest.mark.parametrize(
    ("said", "wanted", "act", "expected"),
    [
        ("", True, False, f"generator={pin('scanner').reference}"),
        ("", False, False, "false"),
        ("", True, True, "false"),
        ("true", True, True, f"generator={pin('scanner').reference}"),
        ("true", False, False, "false"),
        ("false", True, False, "false"),
        ("here/scanner:1", True, True, "generator=here/scanner:1"),
    ],
)
def test_the_scanner(said: str, expected: str, *, wanted: bool, act: bool) -> None:
    assert builder.scanner({"ROSLAB_SBOM": said}, wanted=wanted, act=act) == expected


def test_nothing_in_the_table_floats() -> None:
    for row in rows("pins"):
        assert VERSION.fullmatch(row["version"]), row["name"]
        assert re.fullmatch(r"(?:sha256:[0-9a-f]{64})?", row["digest"]), row["name"]


def renewed(tags: dict[str, str]) -> dict[str, dict[str, str]]:
    before = [dict(row) for row in rows("pins")]
    return {row["name"]: row for row in pins.renewed(before, tags.__getitem__, lambda _: DIGEST, "2030-01-01")}


def test_renewing() -> None:
    tags = {
        "docker/buildx": pin("buildx").version,
        "moby/buildkit": "v9.8.7",
        "tonistiigi/binfmt": "deploy/v11.0.0-70",
        "docker/buildkit-syft-scanner": "v2.0.0",
    }
    found = renewed(tags)
    assert found["buildx"] == next(row for row in rows("pins") if row["name"] == "buildx")  # nothing is new
    assert [found[name]["version"] for name in ("buildkit", "binfmt", "scanner")] == [
        "v9.8.7",
        "qemu-v11.0.0-70",
        "2.0.0",
    ]
    assert {found[name]["digest"] for name in ("buildkit", "binfmt", "scanner")} == {DIGEST}
    assert found["binfmt"]["source"] == "https://github.com/tonistiigi/binfmt/releases/tag/deploy/v11.0.0-70"
    assert found["binfmt"]["date"] == "2030-01-01"
    with pytest.raises(ValueError, match="deploy/… was expected for a release, not buildkit/v9"):
        renewed({**tags, "tonistiigi/binfmt": "buildkit/v9"})


def test_a_release_needs_every_digest(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    table = [dict(row) for row in rows("pins")]
    full = [{**row, "digest": DIGEST if row["image"] else ""} for row in table]
    assert pins.loose(full) == []  # buildx is a program, which its version names
    assert pins.loose([{**row, "digest": ""} for row in full]) == ["buildkit", "binfmt", "scanner"]
    monkeypatch.setattr(pins, "FILE", tmp_path / "pins.csv")
    for found, code in ((full, 0), ([full[0], {**full[1], "digest": ""}], 1)):
        (tmp_path / "pins.csv").write_text(pins.written(found))
        assert pins.main(["--complete"]) == code
    assert capsys.readouterr().err == "error: no digest of buildkit: run python3 scripts/pins.py, and commit\n"


@pytest.mark.parametrize("version", ["latest", "v1", "buildx-stable-1", "v1.2", ""])
def test_a_version_that_floats_is_found(version: str) -> None:
    assert not VERSION.fullmatch(version)


def test_what_is_written_is_read_again() -> None:
    text = pins.written([dict(row) for row in rows("pins")])
    assert text == pins.FILE.read_text(encoding="utf-8")
    assert list(csv.DictReader(text.splitlines())) == [dict(row) for row in rows("pins")]
