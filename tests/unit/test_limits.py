"""What a proof's container may do and use: from roslab.yaml to the options of ``docker run``."""

from __future__ import annotations

import pytest

from roslab import config
from roslab.config.model import ProofLimits
from roslab.errors import ConfigurationError
from roslab.prove import containers


def read(text: str) -> ProofLimits:
    return config.read(f"format: 3\nproof: {text}\n").proof


def test_by_default_a_proof_is_fenced_in(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(containers, "machine_memory", lambda: 16_000_000_000)
    words = " ".join(containers.options(config.read("format: 3\nname: x\n").proof))
    fences = (
        "--network bridge --hostname roslab --pids-limit 8192 --memory 14400000000 --security-opt no-new-privileges"
    )
    assert words.partition(" --env ")[0] == fences


def test_proofs_at_the_same_time_do_not_hear_each_other() -> None:
    """ROS 2's discovery stays in the container; a distribution that does not know how has a domain of its own."""
    several = [containers.options(ProofLimits()) for _ in range(40)]
    assert all("ROS_AUTOMATIC_DISCOVERY_RANGE=LOCALHOST" in words for words in several)
    domains = {word.removeprefix("ROS_DOMAIN_ID=") for words in several for word in words if "DOMAIN_ID" in word}
    assert len(domains) > 1
    assert all(1 <= int(domain) <= 101 for domain in domains)


def test_what_roslab_yaml_says() -> None:
    limits = read("{network: none, memory: 8g, pids: 500, new_privileges: true}")
    words = " ".join(containers.options(limits))
    assert words.partition(" --env ")[0] == "--network none --hostname roslab --pids-limit 500 --memory 8g"


def test_a_machine_that_does_not_say_its_memory(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(containers, "machine_memory", lambda: 0)
    assert "--memory" not in containers.options(ProofLimits())


@pytest.mark.parametrize(
    "text", ["{network: host}", "{memory: all}", "{pids: -1}", "{pids: many}", "{privileged: true}"]
)
def test_anything_else_is_refused(text: str) -> None:
    with pytest.raises(ConfigurationError, match="proof"):
        read(text)
