"""A GPU is given to a proof where the machine has one and its engine can."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from roslab.engine import gpu
from roslab.github import proving
from roslab.github.run import Folder, Run, to_line
from roslab.pipeline import plan_repository


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


def test_who_computes_on_it(machine: Path) -> None:
    stand_in(machine, "nvidia-smi", "4711\n12")
    assert gpu.users() == {4711, 12}
    stand_in(machine, "nvidia-smi", "[N/A]")
    assert gpu.users() == frozenset()
    stand_in(machine, "nvidia-smi", "9", code=9)
    assert gpu.users() == frozenset()


@pytest.mark.parametrize(("example", "given"), [("cuda_saxpy", True), ("own_dockerfile", False)])
def test_a_proof_gets_what_its_image_needs_and_the_report_says_so(
    machine: Path, examples: Path, tmp_path: Path, example: str, *, given: bool
) -> None:
    stand_in(machine, "nvidia-smi", "NVIDIA A10")
    (machine / "docker").write_text(
        f'#!/bin/sh\n[ $1 != image ] || exit 1\n[ $1 != run ] || echo "$*" >>{tmp_path}/run\n'
        "[ $1 != info ] || echo '\"nvidia\"'\n"
    )
    (machine / "docker").chmod(0o755)
    plan = plan_repository(examples / example).plan
    folder = Folder.new({"RUNNER_TEMP": str(tmp_path)})
    run = Run(plan=plan, image="ghcr.io/lab/robot", username="lab", push=False, reason="why", cache="auto")
    folder.write("run", to_line(run))
    build = {"started": 0, "platforms": "linux/amd64", "labels": "", "context": ".", "dockerfile": "Dockerfile"}
    build |= {
        "exporter": "type=docker,name=x",
        "epoch": "",
        "tree": "",
        "mounts": "",
        "source": "",
        "source-policy": "",
    }
    folder.write("build.json", json.dumps(build))
    proving.prove({"ROSLAB_FOLDER": str(folder.path), "GITHUB_OUTPUT": str(tmp_path / "outputs")})
    # A script among the words of a command has lines of its own
    started = [line for line in (tmp_path / "run").read_text().splitlines() if line.startswith("run ")]
    assert [("--gpus all" in line) for line in started] == [given] * len(started)
    proofs = json.loads((folder.artifact / "report-linux-amd64.json").read_text())["proofs"]
    assert [proof["summary"].endswith(", on NVIDIA A10") for proof in proofs] == [given] * len(proofs)
    assert proofs
