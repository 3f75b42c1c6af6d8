"""What a registry's answers mean."""

from __future__ import annotations

import subprocess

import pytest

from roslab.engine import registry


def answer(code: int, error: str = "") -> subprocess.CompletedProcess[str]:
    return subprocess.CompletedProcess([], code, "", error)


@pytest.mark.parametrize(
    "error",
    [
        "unexpected status from PUT request to https://x/v2/a/manifests/b: 503 Service Unavailable",
        "received unexpected HTTP status: 502 Bad Gateway",
        "toomanyrequests: rate exceeded",
        'Get "https://x/v2/": net/http: TLS handshake timeout',
        "read: connection reset by peer",
        "unexpected EOF",
        "context deadline exceeded",
    ],
)
def test_a_passing_fault(error: str) -> None:
    assert registry.is_transient(answer(1, error))


@pytest.mark.parametrize(
    "error", ["denied: permission_denied: write_package", "401 Unauthorized", "not found", "sha256:503abc"]
)
def test_a_lasting_fault(error: str) -> None:
    assert not registry.is_transient(answer(1, error))


def test_retries_are_bounded_grow_and_end_with_success() -> None:
    pauses: list[float] = []
    answers = [answer(1, "503"), answer(1, "503"), answer(0)]
    assert registry.with_retries(lambda: answers.pop(0), pause=pauses.append).returncode == 0
    assert 0.7 <= pauses[0] <= 1.3
    assert 1.4 <= pauses[1] <= 2.6
    calls: list[int] = []

    def never() -> subprocess.CompletedProcess[str]:
        calls.append(1)
        return answer(1, "503")

    assert registry.with_retries(never, pause=lambda _: None).returncode == 1
    assert len(calls) == registry.ATTEMPTS


def test_a_lasting_fault_is_not_tried_again() -> None:
    answers = [answer(1, "denied"), answer(0)]
    assert registry.with_retries(lambda: answers.pop(0), pause=lambda _: None).returncode == 1


@pytest.mark.parametrize(
    ("platform", "expected"),
    [
        ({"os": "linux", "architecture": "arm64", "variant": "v8"}, "linux/arm64"),
        ({"os": "linux", "architecture": "arm", "variant": "v7"}, "linux/arm/v7"),
        ({"os": "linux", "architecture": "amd64"}, "linux/amd64"),
    ],
)
def test_platform_name(platform: dict[str, str], expected: str) -> None:
    assert registry.platform_name(platform) == expected


def test_attestations_are_no_platform() -> None:
    assert registry.is_attestation({"platform": {"os": "unknown", "architecture": "unknown"}})
    assert registry.is_attestation({"annotations": {"vnd.docker.reference.type": "attestation-manifest"}})
    assert not registry.is_attestation({"platform": {"os": "linux", "architecture": "amd64"}})
