"""docker_build.sh: one docker build, whatever the names are; a word of explanation where docker cannot."""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from roslab.plan.author_dockerfile import AuthorDockerfile
from roslab.plan.plan import Plan
from roslab.render.build_script import build_script

Plans = Callable[..., Plan]
Call = Callable[..., Any]
NAME = "docker_build.sh"


def test_it_builds_the_folder_it_lies_in(plan: Plans, call: Call, tmp_path: Path) -> None:
    called = call(build_script(plan(), context="."), name=NAME)
    assert called.arguments == ["build", "--file", f"{tmp_path}/Dockerfile", "--tag", "filter", f"{tmp_path}/."]


def test_it_builds_the_repository_from_elsewhere(plan: Plans, call: Call, tmp_path: Path) -> None:
    called = call(build_script(plan(), context="../my robot; x"), name=NAME)
    assert called.arguments[-1] == f"{tmp_path}/../my robot; x"


def test_arguments_are_passed_through(plan: Plans, call: Call) -> None:
    called = call(build_script(plan(), context="."), "--platform", "linux/arm64", "--build-arg", "A=b c", name=NAME)
    assert called.arguments[5:-1] == ["--platform", "linux/arm64", "--build-arg", "A=b c"]


def test_the_authors_dockerfile_is_built_in_its_own_context(plan: Plans, call: Call, tmp_path: Path) -> None:
    authored = AuthorDockerfile(dockerfile="docker/Dockerfile", context="docker")
    called = call(
        build_script(plan(author_dockerfile=authored), context=".."), name=NAME, env={"STAND_IN_VERSION": "19.03.1"}
    )
    assert called.arguments[2] == f"{tmp_path}/../docker/Dockerfile"
    assert called.arguments[-1] == f"{tmp_path}/../docker"


def test_the_authors_dockerfile_gets_its_arguments_and_its_target(plan: Plans, call: Call) -> None:
    authored = AuthorDockerfile(dockerfile="Dockerfile", context=".", args=(("CUDA", "12.4; x"),), target="runtime")
    called = call(build_script(plan(author_dockerfile=authored), context="."), "--build-arg", "CUDA=11", name=NAME)
    assert called.arguments[5:-1] == ["--build-arg", "CUDA=12.4; x", "--target", "runtime", "--build-arg", "CUDA=11"]


@pytest.mark.parametrize("name", ["a; rm -rf ~", "$(touch owned)", "`touch owned`", "a b", "'", '"'])
def test_a_hostile_name_is_one_word(plan: Plans, call: Call, tmp_path: Path, name: str) -> None:
    """The original wrote it into the script as it stood: `docker build -t a; rm -rf ~ .`."""
    keep = tmp_path / "home" / "keep"
    keep.parent.mkdir()
    keep.touch()
    called = call(build_script(plan(name=name), context="."), name=NAME)
    assert called.values("--tag") == [name]
    assert keep.exists()
    assert not Path("owned").exists()


def test_help_explains_itself(plan: Plans, call: Call) -> None:
    for option in ("--help", "-h"):
        called = call(build_script(plan(), context="."), option, name=NAME)
        assert (called.status, called.argv) == (0, None)
        for part in ("usage: docker_build.sh", "filter", "--platform", "docker_run.sh"):
            assert part in called.out


@pytest.mark.parametrize(
    ("env", "message"),
    [
        ({"STAND_IN_VERSION": "20.10.24"}, "docker 20.10.24 is too old, 23 or newer is needed"),
        ({"STAND_IN_DOWN": "1"}, "docker does not answer: Cannot connect to the Docker daemon"),
        ({"STAND_IN_NO_BUILDX": "1"}, "docker lacks its builder"),
    ],
)
def test_docker_that_cannot_build_is_named(plan: Plans, call: Call, env: dict[str, str], message: str) -> None:
    called = call(build_script(plan(), context="."), name=NAME, env=env)
    assert (called.status, called.argv) == (5, None)
    assert message in called.err


def test_no_docker_at_all(plan: Plans, call: Call, tmp_path: Path) -> None:
    programs = tmp_path / "none"
    programs.mkdir()
    for name in ("bash", "dirname", "basename"):
        (programs / name).symlink_to(_which(name))
    called = call(build_script(plan(), context="."), name=NAME, env={"PATH": str(programs)})
    assert called.status == 5
    assert "docker is not installed" in called.err


def _which(name: str) -> str:
    return next(f"{folder}/{name}" for folder in os.get_exec_path() if os.access(f"{folder}/{name}", os.X_OK))


def test_podman_is_told_and_tried(plan: Plans, call: Call) -> None:
    called = call(
        build_script(plan(), context="."),
        name=NAME,
        env={"STAND_IN_PRODUCT": "podman version 5.2.0", "STAND_IN_VERSION": "5.2.0"},
    )
    assert called.status == 0
    assert "Podman" in called.err
    assert called.arguments[0] == "build"
