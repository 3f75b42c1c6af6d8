"""A GPU is given to a proof where the machine has one and its engine can."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.engine import gpu


@pytest.fixture
def machine(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Return the one folder of the PATH, for stand-ins of the programs that a machine with a GPU has."""
    monkeypatch.setenv("PATH", str(tmp_path))
    return tmp_path


def stand_in(folder: Path, name: str, said: str, code: int = 0) -> None:
    (folder / name).write_text(f"#!/bin/sh\necho '{said}'\nexit {code}\n")
    (folder / name).chmod(0o755)


@pytest.mark.parametrize(
    ("driver", "code", "engine", "expected"),
    [
        ("NVIDIA A10", 0, '{"Runtimes":{"nvidia":{},"runc":{}}}', ("NVIDIA A10",)),
        ("NVIDIA A10", 0, '{"DiscoveredDevices":[{"ID":"nvidia.com/gpu=0"}]}', ("NVIDIA A10",)),
        ("NVIDIA A10", 0, '{"Runtimes":{"runc":{}}}', ()),
        ("NVIDIA-SMI has failed", 9, '{"Runtimes":{"nvidia":{}}}', ()),
    ],
)
def test_what_a_machine_can_give(
    machine: Path, driver: str, code: int, engine: str, expected: tuple[str, ...]
) -> None:  # fmt: skip
    assert gpu.usable() == ()
    stand_in(machine, "nvidia-smi", driver, code)
    stand_in(machine, "docker", engine)
    assert gpu.usable() == expected
