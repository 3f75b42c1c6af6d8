"""Secrets on a runner: one text for all, private files for the build, and nothing of them in a message or a log."""

from __future__ import annotations

import dataclasses
import stat
from pathlib import Path
from typing import Any

import pytest

from roslab.config.model import Config
from roslab.decide.decision import Decision
from roslab.decide.python.image_python import Python
from roslab.errors import ConfigurationError, RefusedError
from roslab.github import secrets
from roslab.github.event import Event
from roslab.github.run import Folder, Run
from roslab.plan.plan import make_plan

KEY = """-----BEGIN OPENSSH PRIVATE KEY-----
b3BlbnNzaC1rZXktdjE=
netrc-like=abc
-----END OPENSSH PRIVATE KEY-----"""
TEXT = f"""
PIP_INDEX=https://robot:hidden-1@pypi.example.org/simple
ssh={KEY}
netrc=machine example.org
  login robot password hidden-2

registry:docker.io=robot:hidden-3
registry:localhost:5000=robot:hidden-4
"""
NAMES = ("pip_index", "netrc", "ssh", "map-key")
PUSH = Event(name="push", repository="lab/robot", ref="refs/heads/main", sha="0" * 40, default_branch="main")
FORK = dataclasses.replace(PUSH, name="pull_request", proposed=True, head="stranger/robot")


def run(*names: str, push: bool = True) -> Run:
    decision = Decision(
        kind="python",
        ros_distro=None,
        ubuntu="noble",
        base_image="ubuntu:24.04",
        build_tool="pip",
        python=Python(version="3.12", manager="venv"),
        command=("python3", "demo.py"),
    )
    plan = make_plan(decision, Config(secrets=names), folder_name="robot")
    return Run(plan=plan, image="ghcr.io/lab/robot", username="lab", push=push, reason="", cache="auto")


@pytest.fixture
def logins(monkeypatch: pytest.MonkeyPatch) -> list[tuple[str, str, str]]:
    """Record the logins in place of docker's client."""
    made: list[tuple[str, str, str]] = []
    monkeypatch.setattr(secrets, "login", lambda _, host, user, password: made.append((host, user, password)))
    return made


def prepare(folder: Path, names: tuple[str, ...], text: str, event: Event = PUSH, **environment: str) -> Folder:
    place = Folder(path=folder)
    secrets.prepare(place, run(*names), event, {"ROSLAB_SECRETS": text, **environment}, folder / "client")
    return place


def test_a_value_goes_on_until_the_next_name() -> None:
    given = secrets.read(TEXT, NAMES)
    assert given.values == {
        "pip_index": "https://robot:hidden-1@pypi.example.org/simple",
        "ssh": KEY,
        "netrc": "machine example.org\n  login robot password hidden-2",
    }
    assert [(each.host, each.username, each.password) for each in given.logins] == [
        ("docker.io", "robot", "hidden-3"),
        ("localhost:5000", "robot", "hidden-4"),
    ]
    assert "hidden" not in repr(given)


def test_only_names_of_roslab_yaml_begin_a_value() -> None:
    """A file of settings may have lines that look alike, and a dot in a name makes no registry of it."""
    text = "settings=[index]\nurl=https://example.org\nrepo.password=a:b\n"
    given = secrets.read(text, ("settings",))
    assert given.values == {"settings": text.partition("=")[2].strip()}
    assert given.logins == ()


def test_nothing_given_is_nothing() -> None:
    assert secrets.read("pip_index=\n\n", NAMES).values == {}
    assert secrets.read("", ()).values == {}


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("hidden\npip_index=a", "line 1 of the secrets belongs to no secret"),
        ("pip-indx=hidden", "roslab.yaml names pip_index, netrc, ssh, map-key"),
        ("registry:docker.io:hidden", "line 1 of the secrets is no login"),
        ("registry:https://docker.io=hidden:hidden", "line 1 of the secrets is no login"),
        ("pip_index=a\nhidden", "the secret pip_index has several lines"),
    ],
)
def test_a_wrong_line_is_named_by_its_number_alone(text: str, said: str) -> None:
    with pytest.raises(ConfigurationError) as caught:
        secrets.read(text, NAMES)
    assert said in str(caught.value)
    assert "hidden" not in str(caught.value)


def test_private_files_for_the_build(
    tmp_path: Path, logins: list[tuple[str, str, str]], capsys: pytest.CaptureFixture[str]
) -> None:
    folder = prepare(tmp_path, ("pip_index", "netrc", "ssh"), TEXT)
    place = tmp_path / "secrets"
    assert stat.S_IMODE(place.stat().st_mode) == 0o700
    assert {stat.S_IMODE(file.stat().st_mode) for file in place.iterdir()} == {0o600}
    assert (place / "pip_index").read_text() == "https://robot:hidden-1@pypi.example.org/simple"
    assert (place / "ssh").read_text() == f"{KEY}\n"
    held = secrets.held(folder, run("pip_index", "netrc", "ssh"), {})
    assert secrets.outputs(held) == {
        "secret-files": f"pip_index={place}/pip_index\nnetrc={place}/netrc",
        "ssh": f"default={place}/ssh",
    }
    assert logins == [("docker.io", "robot", "hidden-3"), ("localhost:5000", "robot", "hidden-4")]
    said = capsys.readouterr()
    shown = [line for line in (said.out + said.err).splitlines() if not line.startswith("::add-mask::")]
    assert "hidden" not in "".join(shown)
    masked = {line.removeprefix("::add-mask::") for line in said.err.splitlines()}
    assert {"hidden-1", "hidden-2", "hidden-3", "b3BlbnNzaC1rZXktdjE="} <= masked


def test_an_agent_of_an_earlier_step(tmp_path: Path, logins: list[Any]) -> None:
    folder = prepare(tmp_path, ("ssh",), "", SSH_AUTH_SOCK="/run/agent")
    held = secrets.held(folder, run("ssh"), {"SSH_AUTH_SOCK": "/run/agent"})
    assert secrets.outputs(held) == {"secret-files": "", "ssh": "default"}
    assert secrets.held(folder, run("ssh"), {}) == ()
    assert secrets.held(folder, run(), {"SSH_AUTH_SOCK": "/run/agent"}) == ()


def test_what_is_missing_stops_the_run_and_says_how_to_give_it(tmp_path: Path, logins: list[Any]) -> None:
    with pytest.raises(ConfigurationError) as caught:
        prepare(tmp_path, ("pip_index", "ssh"), "pip_index=\nregistry:docker.io=robot:\n")
    said = str(caught.value).splitlines()
    assert len(said) == 3
    assert "pip_index=${{ secrets.PIP_INDEX }}" in said[0]
    assert "secret ssh" in said[1]
    assert "registry:docker.io has no user or no password" in said[2]
    assert logins == []


@pytest.mark.parametrize("event", [FORK, dataclasses.replace(PUSH, actor="dependabot[bot]")], ids=["fork", "bot"])
def test_a_run_that_gets_no_secrets_goes_on_with_a_warning(
    tmp_path: Path, logins: list[Any], capsys: pytest.CaptureFixture[str], event: Event
) -> None:
    folder = prepare(tmp_path, ("pip_index",), "pip_index=\nregistry:docker.io=:\n", event)
    (warning,) = [line for line in capsys.readouterr().err.splitlines() if line.startswith("::warning::")]
    assert "gets no secrets, so pip_index, registry:docker.io is missing" in warning
    assert secrets.held(folder, run("pip_index"), {}) == ()
    assert logins == []


def test_a_pull_request_of_the_repository_itself_has_secrets(tmp_path: Path, logins: list[Any]) -> None:
    with pytest.raises(ConfigurationError):
        prepare(tmp_path, ("pip_index",), "", dataclasses.replace(FORK, head="lab/robot"))


def test_the_runs_own_token_goes_to_ghcr_alone(tmp_path: Path, logins: list[Any]) -> None:
    text = "registry:ghcr.io=lab:own-token\nregistry:ghrc.io=lab:own-token\n"
    with pytest.raises(RefusedError, match=r"sent to ghcr\.io alone, not to ghrc\.io"):
        prepare(tmp_path, (), text, ROSLAB_GITHUB_TOKEN="own-token")
    assert logins == []


def test_the_registry_that_is_pushed_to_keeps_its_login(
    tmp_path: Path, logins: list[Any], capsys: pytest.CaptureFixture[str]
) -> None:
    prepare(tmp_path, (), "registry:ghcr.io=reader:another-one\n")
    assert logins == []
    assert "registry:ghcr.io is not used" in capsys.readouterr().err
