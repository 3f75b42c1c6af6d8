"""``inspect --format json`` keeps its contract on every example, and decides what the example is there to show."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from subprocess import CompletedProcess
from typing import Any

import jsonschema  # type: ignore[import-untyped]
import pytest

HERE = Path(__file__).resolve().parent
EXAMPLES = HERE.parent.parent / "examples"
NAMES = sorted(path.name for path in EXAMPLES.iterdir() if path.is_dir())
SCHEMA = json.loads((HERE / "inspect.schema.json").read_text())

BOTH = ["linux/amd64", "linux/arm64"]
EXPECTED: dict[str, dict[str, Any]] = {
    "ros1_talker": {
        "kind": "ros1", "ros_distro": "noetic", "ubuntu": "focal", "base_image": "ros:noetic-ros-base",
        "build_tool": "catkin_make", "dockerfile": None, "platforms": BOTH,
        "command": ["bash", "-c", "roslaunch ros1_talker chatter.launch"],
    },
    "ros2_talker": {
        "kind": "ros2", "ros_distro": "jazzy", "ubuntu": "noble", "base_image": "ros:jazzy-ros-base",
        "build_tool": "colcon", "dockerfile": None, "platforms": BOTH,
        "command": ["ros2", "launch", "ros2_talker", "chatter.launch.py"],
    },
    "ros2_filter": {
        "kind": "ros2", "ros_distro": "jazzy", "ubuntu": "noble", "base_image": "ros:jazzy-ros-base",
        "build_tool": "colcon", "dockerfile": None, "platforms": BOTH, "command": ["bash", "-c", "filter_report"],
    },
    "python_filter": {
        "kind": "python", "ros_distro": None, "build_tool": "pip", "dockerfile": None, "platforms": BOTH,
        "command": ["python3", "demo.py"],
    },
    "cuda_saxpy": {
        "kind": "cuda", "ros_distro": None, "ubuntu": "jammy", "base_image": "nvidia/cuda:12.4.1-devel-ubuntu22.04",
        "build_tool": "cmake", "dockerfile": None, "platforms": BOTH, "command": ["bash", "-c", "saxpy"],
    },
    "own_dockerfile": {
        "kind": "python", "ros_distro": None, "dockerfile": "docker/Dockerfile", "base_image": "ubuntu:24.04",
        "ubuntu": "noble", "platforms": BOTH, "command": ["python3", "pose_chain.py"],
    },
    "monorepo": {
        "kind": "ros1", "ros_distro": "noetic", "ubuntu": "focal", "base_image": "ros:noetic-ros-base",
        "build_tool": "catkin_make", "dockerfile": None, "platforms": BOTH,
        "command": ["roslaunch", "odometry_node", "drive.launch"],
    },
    "no_config": {
        "kind": "cpp", "ros_distro": None, "build_tool": "cmake", "dockerfile": None, "platforms": BOTH,
        "command": ["align"],
    },
}  # fmt: skip


def inspect(roslab: Callable[..., CompletedProcess[str]], name: str) -> dict[str, Any]:
    answer = roslab("inspect", EXAMPLES / name, "--format", "json")
    assert answer.returncode == 0, answer.stderr
    found: dict[str, Any] = json.loads(answer.stdout)
    return found


def test_every_example_is_expected() -> None:
    assert sorted(EXPECTED) == NAMES


@pytest.mark.parametrize("name", NAMES)
def test_contract(roslab: Callable[..., CompletedProcess[str]], name: str) -> None:
    found = inspect(roslab, name)
    jsonschema.Draft202012Validator(SCHEMA).validate(found)
    assert list(found) == SCHEMA["required"]  # programs may not care for the order, people who read it do


@pytest.mark.parametrize("name", NAMES)
def test_decisions(roslab: Callable[..., CompletedProcess[str]], name: str) -> None:
    found = inspect(roslab, name)
    assert {key: found[key] for key in EXPECTED[name]} == EXPECTED[name]
    assert found["warnings"] == []


@pytest.mark.parametrize("name", NAMES)
def test_every_answer_has_its_evidence(roslab: Callable[..., CompletedProcess[str]], name: str) -> None:
    found = inspect(roslab, name)
    questions = {entry["question"]: entry for entry in found["evidence"]}
    assert {"kind", "base_image", "command"} <= set(questions)
    assert questions["kind"]["answer"] == found["kind"]
    for entry in found["evidence"]:
        if entry["file"] and entry["line"]:
            lines = (EXAMPLES / name / entry["file"]).read_text().splitlines()
            assert entry["line"] <= len(lines), entry
