"""When an image is signed, and how anybody checks that it was."""

from __future__ import annotations

from dataclasses import replace

from roslab.github.event import Event
from roslab.github.signing import unsigned, verification

EVENT = Event(
    name="push", repository="Lab/Robot", ref="refs/heads/main", sha="1" * 40, default_branch="main", public=True,
    signing=True,
)  # fmt: skip


def test_what_is_signed() -> None:
    assert unsigned(EVENT) == ""
    assert unsigned(replace(EVENT, public=False, enterprise=True)) == ""
    assert "`id-token: write` and `attestations: write`" in unsigned(replace(EVENT, signing=False))
    assert "private" in unsigned(replace(EVENT, public=False))


def test_the_line_that_checks() -> None:
    """A workflow of another repository is the one that signed, and gh refuses it where it is not named."""
    own = ("gh attestation verify", "oci://ghcr.io/lab/robot@sha256:1", "--repo Lab/Robot")
    assert verification("ghcr.io/lab/robot", "sha256:1", EVENT, "") == own
    assert verification("ghcr.io/lab/robot", "sha256:1", EVENT, "lab/robot") == own
    called = verification("ghcr.io/lab/robot", "sha256:1", EVENT, "org/repro-action")
    assert called == (*own, "--signer-repo org/repro-action")
