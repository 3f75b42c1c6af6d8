"""Inputs become settings, or one clear error each."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from roslab.config import configure
from roslab.errors import ConfigurationError
from roslab.github import inputs
from roslab.pipeline import plan_repository
from roslab.values.origin import Input


def read(**said: str) -> inputs.Inputs:
    return inputs.read({f"INPUT_{name.upper()}": value for name, value in said.items()})


def test_nothing_said() -> None:
    found = read(config="", image="", platforms="", push="", registry="")
    assert (found.push, found.cache, found.registry) == ("auto", "auto", "ghcr.io")
    assert found.overrides == ()


def test_what_roslab_yaml_could_say() -> None:
    found = read(
        platforms="linux/amd64, linux/arm64\n", command="ros2 run a b", test="true", kind="ros2", build_tool="colcon"
    )
    config = configure(None, found.overrides)
    assert config.platforms == ("linux/amd64", "linux/arm64")
    assert (config.command, config.test) == ("ros2 run a b", "true")
    assert (config.kind, config.build) == ("ros2", "colcon")
    assert config.origin("build") == Input(name="build-tool")
    assert configure(None, read(distro="humble").overrides).base.ros == "humble"


def test_every_mistake_at_once() -> None:
    with pytest.raises(ConfigurationError) as caught:
        read(
            push="yes",
            cache="gha",
            registry="https://ghcr.io",
            platforms="amd64",
            distro="jazzi",
            runners="arm64",
            image="a b",
        )
    said = [str(problem) for problem in caught.value.problems]
    assert len(said) == 7
    for name in ("push", "cache", "registry", "platforms", "distro", "runners", "image"):
        assert sum(f"input {name}: " in line for line in said) == 1, said
    assert any("did you mean `jazzy`" in line for line in said)


def test_a_hostile_value_is_shown_and_not_obeyed() -> None:
    with pytest.raises(ConfigurationError) as caught:
        read(registry="ghcr.io\n::set-output name=x::y")
    assert "\n" not in str(caught.value.problems[0])


@pytest.mark.parametrize(
    ("said", "expected"),
    [
        ("", "ghcr.io/my-lab/plan-name"),
        ("Other", "ghcr.io/my-lab/other"),
        ("Someone/Other", "ghcr.io/someone/other"),
        ("a/b/c", "ghcr.io/a/b/c"),
        ("ghcr.io/a/b", "ghcr.io/a/b"),
    ],
)
def test_image(said: str, expected: str) -> None:
    assert inputs.image(read(image=said), owner="My-Lab", name="plan-name") == expected


@pytest.mark.parametrize("said", ["a:latest", "a@sha256:0", "a b", "-a", "a//b", "quay.io/a/b", "$(id)", "a\n-t x"])
def test_no_image(said: str) -> None:
    with pytest.raises(ConfigurationError, match="input image"):
        inputs.image(read(image=said), owner="lab", name="x")


def test_runner_of_the_most_specific_platform() -> None:
    runners = read(runners='{"linux": "self-hosted", "linux/arm": "small", "linux/arm/v7": "special"}').runners
    assert [inputs.runner(p, runners) for p in ("linux/amd64", "linux/arm/v6", "linux/arm/v7", "linux/arm64")] == [
        "self-hosted", "small", "special", "self-hosted",
    ]  # fmt: skip
    assert inputs.runner("linux/arm64", read().runners) == "ubuntu-24.04-arm"
    assert inputs.runner("linux/riscv64", read().runners) == "ubuntu-24.04"


def test_a_configuration_that_is_not_there_is_told_by_its_input(examples: Path) -> None:
    with pytest.raises(ConfigurationError) as caught:
        plan_repository(examples / "python_filter", config_file=read(config="paper.yaml").config)
    assert str(caught.value) == "input config: no file paper.yaml in the repository (give a path relative to its root)"


@pytest.mark.parametrize(
    "value",
    ["big", ["self-hosted", "gpu"], {"group": "arm runners"}, {"group": "a", "labels": ["b", "c"]}, {"labels": "b"}],
)
def test_a_runner_is_what_runs_on_takes(value: object) -> None:
    found = read(runners=json.dumps({"plan": "small", "linux/arm64": value})).runners
    assert inputs.runner("linux/arm64", found) == value
    assert inputs.runner("linux/amd64", found) == "ubuntu-24.04"


@pytest.mark.parametrize(
    "text", ["ubuntu-24.04", "[]", '{"linux/amd64": ""}', '{"linux/amd64": [1]}', '{"windows": "a"}', '{"tag": {}}',
             '{"plan": {"name": "a"}}', '{"linux/amd64": "${{ x }}"}'],
)  # fmt: skip
def test_anything_else_is_no_runner(text: str) -> None:
    with pytest.raises(ConfigurationError, match=r"input runners: .*write JSON, for example"):
        read(runners=text)
