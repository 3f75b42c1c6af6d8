"""Secrets in the Dockerfile and in docker_build.sh: mounted for the steps that need them, in no instruction else."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from roslab.config.model import Config, Custom, Source
from roslab.decide.decision import Decision
from roslab.decide.python.image_python import Python
from roslab.plan.plan import Plan, make_plan
from roslab.render.build_script import build_script
from roslab.render.dockerfile import dockerfile
from roslab.values.requirement_line import stated

ALL = ("pip_index", "netrc", "ssh", "apt_auth", "map_key")
SISTER = Source(name="sister", repo="git@example.org:lab/sister.git", ref="v1", build="colcon")
LIBRARY = Source(name="core", zip="https://example.org/core.zip", depends=("libeigen3-dev",))
Plans = Callable[..., Plan]
Call = Callable[..., Any]


def made(*secrets: str, custom: Custom | None = None) -> str:
    """Return the Dockerfile of a workspace that has a step of every kind."""
    decision = Decision(
        kind="ros2",
        ros_distro="humble",
        ubuntu="jammy",
        base_image="ros:humble-ros-base",
        build_tool="colcon",
        apt=("libglew-dev",),
        apt_guessed=("libsdl2-dev",),
        python=Python(version="3.10", manager="system", pip=(stated("robot-core"),), projects=("driver",)),
        packages=("talker/package.xml",),
        package_names=("talker",),
        workspace="overlay",
        source=(LIBRARY, SISTER),
    )
    config = Config(secrets=secrets, custom=custom, notebook=True)
    return dockerfile(make_plan(decision, config, folder_name="robot"))


def steps(text: str) -> dict[str, set[str]]:
    """Return the secrets of every RUN by what it does."""
    found: dict[str, set[str]] = {}
    for run in re.findall(r"^RUN (?:.*\\\n)*.*$", text, re.MULTILINE):
        mounts = set(re.findall(r"--mount=type=secret,id=([\w-]+)", run)) | set(re.findall(r"type=(ssh)", run))
        found[re.sub(r"--mount=\S+|\\\n|\s+", " ", run).strip()] = mounts
    return found


def of(text: str, part: str) -> set[str]:
    (found,) = [mounts for run, mounts in steps(text).items() if part in run]
    return found


def test_each_step_gets_what_it_needs() -> None:
    custom = Custom(commands=("cp /run/secrets/map_key /dev/null",), as_root=True, chained=True, workdir="source")
    text = made(*ALL, custom=custom)
    assert of(text, "libglew-dev") == {"apt_auth"}
    assert of(text, "install-optional-apt") == {"apt_auth"}
    assert of(text, "libeigen3-dev") == {"apt_auth"}
    assert of(text, "core.zip") == {"netrc", "ssh"}
    assert of(text, "git clone") == {"netrc", "ssh"}
    assert of(text, "robot-core") == {"pip_index", "netrc", "ssh"}
    assert of(text, "--editable") == {"pip_index", "netrc", "ssh"}
    assert of(text, "cp /run/secrets/map_key") == set(ALL)
    for part in ("create-user", "/tmp/sources/core/build", "colcon build", "jupyterlab", "chown --no-dereference"):
        assert of(text, part) == set(), part
    assert "openssh-client" in text
    assert "git clone git@example.org:lab/sister.git" in text
    assert "curl --netrc --fail" in text


def test_rosdep_calls_apt_and_pip() -> None:
    assert of(made(*ALL), "install-rosdep-keys") == {"apt_auth", "pip_index", "netrc", "ssh"}


def test_every_mount_is_required_and_no_value_stays() -> None:
    text = made(*ALL, custom=Custom(commands=("true",), as_root=False, chained=False, workdir="home"))
    for mount in re.findall(r"--mount=(?!type=cache)\S+", text):
        assert re.search(r"type=(secret|ssh)\b.*required=true", mount), mount
    text = text[text.index("\n\n\nFROM ") :]  # without the scripts, which are the same in every image
    outside = re.sub(r"^RUN (?:.*\\\n)*.*$|^#.*$", "", text, flags=re.MULTILINE)
    for word in (*ALL, "PIP_EXTRA_INDEX_URL", "GIT_SSH_COMMAND"):
        assert word not in outside


def test_who_runs_a_step_can_read_its_secrets() -> None:
    """A step of the image's user has another home, and is not root."""
    text = made("netrc", "ssh", custom=Custom(commands=("true",), as_root=True, chained=True, workdir="source"))
    (clone,) = [run for run in re.findall(r"^RUN (?:.*\\\n)*.*$", text, re.MULTILINE) if "git clone" in run]
    assert "target=/home/${NB_USER}/.netrc,mode=0444" in clone
    assert "type=ssh,required=true,mode=0666" in clone
    (pip,) = [run for run in re.findall(r"^RUN (?:.*\\\n)*.*$", text, re.MULTILINE) if "robot-core" in run]
    assert "target=/root/.netrc \\" in pip
    (own,) = [run for run in re.findall(r"^RUN (?:.*\\\n)*.*$", text, re.MULTILINE) if run.endswith("&& true")]
    assert "target=/home/${NB_USER}/.netrc \\" in own


def test_without_secrets_none_is_mounted() -> None:
    text = made()
    assert set(re.findall(r"--mount=type=(\w+)", text)) == {"cache"}
    assert "--netrc" not in text
    assert "openssh" not in text


def test_the_first_lines_say_how_to_build() -> None:
    assert "docker build --secret id=pip_index,src=FILE --ssh default\n" in made("pip_index", "ssh")


SECRETS = {
    "PIP_INDEX": "https://user:hidden@example.org/simple",
    "SSH_AUTH_SOCK": "/run/agent",
}


def test_docker_build_hands_them_over(plan: Plans, call: Call, tmp_path: Path) -> None:
    (tmp_path / "a, b").write_text("machine example.org")
    (tmp_path / "key").write_text("hidden")
    env = {**SECRETS, "NETRC": str(tmp_path / "a, b"), "MAP_KEY_FILE": str(tmp_path / "key")}
    text = build_script(plan(secrets=("pip_index", "netrc", "ssh", "map-key")), context=".")
    called = call(text, "--no-cache", name="docker_build.sh", env=env)
    assert called.values("--secret") == [
        "id=pip_index,env=PIP_INDEX",
        f'id=netrc,"src={tmp_path}/a, b"',
        f'id=map-key,"src={tmp_path}/key"',
    ]
    assert called.values("--ssh") == ["default"]
    assert "hidden" not in "".join(called.arguments)
    assert called.arguments[-2] == "--no-cache"


def test_the_users_own_netrc_is_the_default(plan: Plans, call: Call, tmp_path: Path) -> None:
    (tmp_path / "home").mkdir()
    (tmp_path / "home/.netrc").touch()
    called = call(build_script(plan(secrets=("netrc",)), context="."), name="docker_build.sh")
    assert called.values("--secret") == [f'id=netrc,"src={tmp_path}/home/.netrc"']


@pytest.mark.parametrize("name", ["pip_index", "netrc", "ssh", "map_key"])
def test_a_missing_one_is_said_before_anything_is_built(plan: Plans, call: Call, name: str) -> None:
    called = call(build_script(plan(secrets=(name,)), context="."), name="docker_build.sh", env={"PIP_INDEX": ""})
    assert (called.status, called.argv) == (5, None)
    assert f"the secret {name} is not there" in called.err


def test_help_says_where_they_come_from(plan: Plans, call: Call) -> None:
    called = call(build_script(plan(secrets=("pip_index", "ssh")), context="."), "--help", name="docker_build.sh")
    assert "Secrets of roslab.yaml: pip_index ssh." in called.out
    without = call(build_script(plan(), context="."), "--help", name="docker_build.sh")
    assert "ecret" not in without.out


def test_nothing_is_kept_of_an_index_with_a_password() -> None:
    """Beside an answer pip may keep the words that it was asked with."""
    pip = "type=cache,id=pip-"
    assert pip in made()
    assert pip in made("ssh", "apt_auth")
    for secret in ("pip_index", "netrc"):
        text = made(secret)
        assert pip not in text
        assert "pip-cache" not in text
        assert "-m pip install --no-cache-dir robot-core" in text
