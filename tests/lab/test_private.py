"""Private dependencies for real: what needs a secret is built with it, on a laptop and by both doors."""

from __future__ import annotations

import json
import os
import re
import signal
import subprocess
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from subprocess import CompletedProcess

import pytest

from lab import doors
from lab.act import Result, run_workflow
from lab.canary import value
from lab.faulty_registry import Faults, faulty_registry
from lab.laboratory import Laboratory
from lab.private_server import PACKAGE, Server, private_server
from lab.ssh_server import SshServer, ssh_server

Roslab = Callable[..., CompletedProcess[str]]
WORKSPACE = {
    "package.xml": "<package format='3'><name>talker</name><version>1.0.0</version><description>x</description>"
    "<maintainer email='a@example.org'>a</maintainer><license>MIT</license>"
    "<export><build_type>cmake</build_type></export></package>\n",
    "CMakeLists.txt": "cmake_minimum_required(VERSION 3.10)\nproject(talker NONE)\n",
}


@pytest.fixture
def server(tmp_path: Path) -> Iterator[Server]:
    """Run the server with a password and a version of this test's own: no layer of an earlier test fits."""
    with private_server(tmp_path / "server", value()) as running:
        yield running


@pytest.fixture
def builder(lab: Laboratory, tmp_path: Path) -> dict[str, str]:
    """Return an environment whose buildx uses the lab's BuildKit, which reaches this machine's servers."""
    environment = {**lab.environment, "BUILDX_CONFIG": str(tmp_path / "buildx"), "BUILDX_BUILDER": "lab-private"}
    create = ["docker", "buildx", "create", "--name", "lab-private", "--driver", "remote", lab.buildkit]
    subprocess.run(create, env=environment, check=True, capture_output=True)
    return environment


def test_a_workspace_on_a_laptop(roslab: Roslab, builder: dict[str, str], server: Server, tmp_path: Path) -> None:
    """A sister package by git, which the image's user clones, and a package of pip, which root installs."""
    config = (
        "format: 3\nname: lab-private\nkind: ros2\nbase: {ros: humble}\n"
        f"secrets: [netrc, pip_index]\npip: [{server.package}]\n"
        f"source: [{{name: sister, repo: '{server.repository}', ref: v1, build: colcon}}]\n"
        f"test: python3 -c 'import {PACKAGE}' && cat ~/ws/install/sister/share/told"
        " && ! ls -a ~ /run | grep -e netrc -e secrets\n"
    )
    tree = doors.write(tmp_path / "tree", {**WORKSPACE, "roslab.yaml": config})
    (tmp_path / "netrc").write_text(server.netrc)
    given = {**builder, "NETRC": str(tmp_path / "netrc"), "PIP_INDEX": server.index}

    without = roslab("build", tree, env={**given, "PIP_INDEX": ""})
    assert without.returncode == 2
    assert "set the variable PIP_INDEX" in without.stderr
    assert (server.served, server.refused) == (0, 0)

    (tmp_path / "wrong").write_text(server.netrc.replace(server.password, "wrong"))
    refused = roslab("build", tree, env={**given, "NETRC": str(tmp_path / "wrong")}, timeout=1800)
    assert refused.returncode == 5, refused.stderr[-8000:]
    assert server.served == 0

    built = roslab("build", tree, "--tag", "lab", env=given, timeout=1800)
    assert built.returncode == 0, built.stderr[-8000:]
    assert server.password not in built.stderr + built.stdout
    subprocess.run(["docker", "image", "rm", "lab-private:lab"], env=builder, check=True, capture_output=True)


@pytest.fixture
def keyed(server: Server, tmp_path: Path) -> Iterator[SshServer]:
    """Serve the private server's repository by ssh too, with a key of this test's own."""
    with ssh_server(tmp_path / "server/git") as running:
        yield running


def keyed_source(keyed: SshServer, tmp_path: Path) -> str:
    repository = tmp_path / "server/git/sister.git"
    return f"source: [{{name: sister, repo: '{keyed.url(repository)}', ref: v1, build: cmake}}]\n"


def test_a_repository_that_asks_for_a_key(
    roslab: Roslab, builder: dict[str, str], keyed: SshServer, tmp_path: Path
) -> None:
    """By the agent of the one who builds; the image holds the clone, and nothing of the key."""
    config = (
        f"format: 3\nname: lab-keyed\nkind: cpp\nsecrets: [ssh]\n{keyed_source(keyed, tmp_path)}"
        "test: cat /usr/local/share/told && ! ls -A ~/.ssh /root/.ssh /run/buildkit 2>/dev/null | grep .\n"
    )
    tree = doors.write(tmp_path / "tree", {"CMakeLists.txt": WORKSPACE["CMakeLists.txt"], "roslab.yaml": config})
    without = roslab("build", tree, env={**builder, "SSH_AUTH_SOCK": None})
    assert without.returncode == 2
    assert "ssh-add" in without.stderr
    assert keyed.served == 0

    key = tmp_path / "key"
    key.write_text(keyed.key)
    key.chmod(0o600)
    with agent(key) as socket:
        built = roslab("build", tree, "--tag", "lab", env={**builder, "SSH_AUTH_SOCK": socket}, timeout=1800)
    assert built.returncode == 0, built.stderr[-8000:]
    assert keyed.served == 1
    subprocess.run(["docker", "image", "rm", "lab-keyed:lab"], env=builder, check=True, capture_output=True)


def test_a_key_through_the_action(lab: Laboratory, keyed: SshServer, tmp_path: Path) -> None:
    config = (
        f"format: 3\nname: lab-keyed\nkind: cpp\nsecrets: [ssh]\n{keyed_source(keyed, tmp_path)}"
        "test: cat /usr/local/share/told\n"
    )
    image = lab.fresh_repository(f"{doors.OWNER}/keyed").partition("/")[2]
    files = {"CMakeLists.txt": WORKSPACE["CMakeLists.txt"], "roslab.yaml": config}
    caller = through("action", tmp_path / "caller", lab, files, "ssh=${{ secrets.SSH_KEY }}\n", image=image)
    (caller / "Dockerfile").unlink()
    ran = run_workflow(
        lab, caller, "push", doors.payload("keyed"), env=doors.builder(lab), secrets={"SSH_KEY": keyed.key},
    )  # fmt: skip
    assert ran.exit_code == 0, ran.log
    assert "the sister was cloned" in ran.log
    assert keyed.served == 1
    assert keyed.key.splitlines()[2] not in ran.log


@contextmanager
def agent(key: Path) -> Iterator[str]:
    """Run an agent of this test's own that holds a key, and yield its socket."""
    words = subprocess.run(["ssh-agent", "-s"], check=True, capture_output=True, text=True).stdout
    found = dict(re.findall(r"(SSH_\w+)=([^;]+);", words))
    try:
        subprocess.run(["ssh-add", "-q", key], env={**os.environ, **found}, check=True, capture_output=True)
        yield found["SSH_AUTH_SOCK"]
    finally:
        os.kill(int(found["SSH_AGENT_PID"]), signal.SIGTERM)


def test_docker_build_sh(roslab: Roslab, builder: dict[str, str], server: Server, tmp_path: Path) -> None:
    """The same on the machine of somebody who has only docker; without the secret docker itself stops."""
    files = {
        "roslab.yaml": "format: 3\nkind: cpp\nname: lab-private-own\nsecrets: [map_key]\ndockerfile: Dockerfile\n",
        "Dockerfile": "FROM ubuntu:24.04\nRUN --mount=type=secret,id=map_key,required=true "
        f"[ $(cat /run/secrets/map_key | wc -c) = {len(server.password)} ] && echo {server.version}\n",
    }
    tree = doors.write(tmp_path / "tree", files)
    assert roslab("create", tree, env=builder).returncode == 0

    def build(words: list[str], **environment: str) -> CompletedProcess[str]:
        return subprocess.run(
            words, cwd=tree, env={**builder, **environment}, capture_output=True, text=True, check=False
        )

    bare = build(["docker", "build", "."])
    assert bare.returncode != 0
    (tmp_path / "log").write_text(bare.stderr)
    assert "needs the secret map_key" in roslab("explain", tmp_path / "log").stdout
    assert build(["./docker_build.sh"]).returncode == 5
    built = build(["./docker_build.sh"], MAP_KEY=server.password)
    assert built.returncode == 0, built.stderr


def through(door: str, folder: Path, lab: Laboratory, files: dict[str, str], secrets: str, *, image: str = "") -> Path:
    """Write a repository whose job hands these secrets over, by the action or by the workflow."""
    given = {"registry": lab.registry, "image": image, "platforms": "linux/amd64", "cache": "none"}
    if door == "action":
        return doors.through_action(folder, {**given, "secrets": secrets}, files)
    caller = doors.through_workflow(folder, given, files)
    file = caller / ".github/workflows/caller.yml"
    line = f"    secrets:\n      build-secrets: {json.dumps(secrets)}\n"
    file.write_text(file.read_text().replace("    secrets:\n", line))
    return caller


@pytest.mark.parametrize("door", ["action", "image"])
def test_an_index_and_a_base_image_that_ask_for_a_password(
    lab: Laboratory, tmp_path: Path, server: Server, door: str
) -> None:
    """The base is on a registry of its own, which is not the one that is pushed to."""
    name = lab.fresh_repository(f"{doors.OWNER}/robot").rpartition("/")[2]
    copy = ["docker", "buildx", "imagetools", "create", "--tag", f"{lab.registry}/lab/python:3.12-slim",
            f"{lab.mirror}/library/python:3.12-slim"]  # fmt: skip
    subprocess.run(copy, env=dict(lab.environment), check=True, capture_output=True)
    with faulty_registry(lab.registry, Faults(matches=lambda *_: False, times=0)) as base:
        config = (
            f"format: 3\nname: robot\nkind: python\nbase: {{image: '{base}/lab/python:3.12-slim'}}\n"
            f"secrets: [pip_index]\npip: [{server.package}]\ntest: python3 -c 'import {PACKAGE}'\n"
        )
        files = {"roslab.yaml": config, "main.py": "print('hello')\n", "Dockerfile": "# none\n"}
        secrets = f"pip_index=${{{{ secrets.PIP_INDEX }}}}\nregistry:{base}={lab.username}:${{{{ secrets.BASE }}}}\n"

        def run(folder: str, secrets: str, **given: str) -> Result:
            caller = through(door, tmp_path / folder, lab, files, secrets, image=f"{doors.OWNER}/{name}")
            event = doors.payload(name)
            return run_workflow(lab, caller, "push", event, env=doors.builder(lab), secrets=given)

        known = {"PIP_INDEX": server.index, "BASE": lab.password}
        missing = run("missing", secrets, BASE=lab.password)
        assert missing.exit_code != 0
        assert [e for e in doors.errors(missing) if "names the secret pip_index, which is not there" in e]
        refused = run("refused", secrets, **known | {"BASE": "not-the-password"})
        assert refused.exit_code != 0
        assert [e for e in doors.errors(refused) if f"{base} refuses the login for base images" in e]
        unknown = run("unknown", secrets.partition("registry:")[0], **known)
        assert unknown.exit_code != 0
        assert re.search(r"no basic auth credentials|401 Unauthorized", unknown.log)
        assert server.served == 0
        ran = run("good", secrets, **known)
    assert ran.exit_code == 0, ran.log
    assert "from the private index" in ran.log
    assert server.served > 0
    assert server.password not in ran.log + ran.summary
    assert {"main", "latest"} < set(doors.tags(f"{doors.OWNER}/{name}"))


def test_a_strangers_pull_request_is_told_what_is_missing(lab: Laboratory, tmp_path: Path, server: Server) -> None:
    name = lab.fresh_repository(f"{doors.OWNER}/robot").rpartition("/")[2]
    config = f"format: 3\nkind: python\nbase: {{python: '3.12'}}\nsecrets: [pip_index]\npip: [{server.package}]\n"
    files = {"roslab.yaml": config, "main.py": "print('hello')\n", "Dockerfile": "# none\n"}
    caller = through("action", tmp_path / "fork", lab, files, "pip_index=${{ secrets.PIP_INDEX }}\n")
    event = doors.payload(name, head="stranger/robot")
    ran = run_workflow(lab, caller, "pull_request", event, env=doors.builder(lab))
    assert ran.exit_code != 0
    assert "a pull request from a fork gets no secrets, so pip_index is missing" in ran.log
    assert [error for error in doors.errors(ran) if "needs the secret pip_index" in error], doors.errors(ran)
    assert server.served == 0
