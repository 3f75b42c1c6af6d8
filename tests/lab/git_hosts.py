"""Code hosts whose repositories come from a folder: a git server for builds, and stand-ins whose git asks it.

Nothing but $REPRO_LAB_GIT switches it on, for `up` and for whoever asks for the lab's environment; builds without it
have the usual stand-ins. A build with it has the same Dockerfile: BuildKit's source policy puts another image below
each `FROM` (https://docs.docker.com/build/building/variables/#experimental_buildkit_source_policy).
"""

from __future__ import annotations

import json
import os
import socket
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from . import facts, processes
from .command import LabError, run, succeeds
from .home import HERE, folder, recipe

VARIABLE = "REPRO_LAB_GIT"
NAME = "git-server"
RECIPE = HERE / "images" / "git"


def given() -> Path | None:
    """Return the folder of repositories, HOST/OWNER/NAME; ``None`` where the caller gave none.

    Raises LabError where there is no such folder.
    """
    named = os.environ.get(VARIABLE)
    if not named:
        return None
    place = Path(named).absolute()
    if not place.is_dir():
        raise LabError(f"{VARIABLE}={named} is no folder; it has to hold repositories as HOST/OWNER/NAME")
    return place


def up(env: dict[str, str]) -> str:
    """Make sure that the folder is served, another one no longer, where containers and this machine reach it."""
    place, address = given(), _address(env)
    told = folder("git") / "served"
    if processes.running(NAME) and answers(address) and told.exists() and told.read_text() == f"{place} {address}":
        return f"was there: http://{address}, {place}"
    processes.stop(NAME)
    host, _, port = address.partition(":")
    program = HERE / "git_server.py"
    processes.start(NAME, [sys.executable, program, str(place), host, port], ready=lambda: answers(address))
    _settings().write_text(settings(address))
    told.write_text(f"{place} {address}")
    return f"started: http://{address}, {place}"


def down() -> bool:
    """End the server if the lab started it."""
    return processes.stop(NAME)


def make(references: Sequence[tuple[str, tuple[str, ...]]], env: dict[str, str]) -> str:
    """Make a stand-in with the server's settings out of each, and the policy that puts it below the same names.

    ``references`` are the stand-ins, each with its real names.
    """
    rules = []
    for reference, names in references:
        if not names or not succeeds(["docker", "image", "inspect", reference], env=env):
            continue
        base = run(["docker", "image", "inspect", "--format", "{{.Id}}", reference], env=env).strip()
        tag = f"lab/git:{recipe(RECIPE, _settings(), base)}"
        if not succeeds(["docker", "image", "inspect", tag], env=env):
            command = ["docker", "buildx", "build", "--builder", "default", "--provenance=false", "--tag", tag]
            words = ["--build-arg", f"BASE={reference}", "--build-context", f"hosts={_settings().parent}"]
            run([*command, *words, RECIPE], log="image-git", env=env)
        rules += [_rule(name, tag) for name in names]
    kept = {str(rule["updates"]["identifier"]).rpartition("/lab/")[2] for rule in rules}
    listed = run(["docker", "image", "ls", "--format", "{{.Repository}}:{{.Tag}}", "lab/git"], env=env).split()
    for older in (name for name in listed if name.removeprefix("lab/") not in kept):
        succeeds(["docker", "rmi", older], env=env)
    _policy().write_text(json.dumps({"rules": rules}, indent=2))
    return f"{len(rules)} names"


def environment() -> dict[str, str]:
    """Return what makes builds, and git on this machine, use the server; nothing where the caller gave no folder."""
    if given() is None:
        return {}
    included = {"GIT_CONFIG_COUNT": "1", "GIT_CONFIG_KEY_0": "include.path", "GIT_CONFIG_VALUE_0": str(_settings())}
    return {"EXPERIMENTAL_BUILDKIT_SOURCE_POLICY": str(_policy()), **included}


def settings(address: str) -> str:
    """Return git's settings that send every way to write a code host's repository to the server at this address."""
    text = ""
    for host in facts.texts("git", "hosts"):
        ways = (f"https://{host}/", f"http://{host}/", f"git://{host}/", f"ssh://git@{host}/", f"git@{host}:")
        text += f'[url "http://{address}/{host}/"]\n' + "".join(f"\tinsteadOf = {way}\n" for way in ways)
    return text


def _rule(name: str, tag: str) -> dict[str, Any]:
    """Return the rule of a source policy: https://github.com/moby/buildkit/blob/master/docs/build-repro.md."""
    wanted = {"identifier": f"docker-image://docker.io/library/{name}"}
    return {"action": "CONVERT", "selector": wanted, "updates": {"identifier": f"docker-image://docker.io/{tag}"}}


def _settings() -> Path:
    return folder("git", "hosts") / "gitconfig"


def _policy() -> Path:
    return folder("git") / "policy.json"


def _address(env: dict[str, str]) -> str:
    return f"{bridge(env)}:{facts.number('git', 'port')}"


def bridge(env: dict[str, str]) -> str:
    """Return this machine's address on the engine's bridge, which it and its containers alone reach."""
    inspect = ["docker", "network", "inspect", "bridge", "--format", "{{(index .IPAM.Config 0).Gateway}}"]
    return run(inspect, env=env).strip()


def answers(address: str) -> bool:
    """Tell whether something listens at `ADDRESS:PORT`."""
    host, _, port = address.partition(":")
    try:
        socket.create_connection((host, int(port)), timeout=5).close()
    except OSError:
        return False
    return True
