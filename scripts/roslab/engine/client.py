"""A folder of its own for docker's client: a password that a job needs is neither shared nor left behind."""

from __future__ import annotations

import os
import shutil
import subprocess
from collections.abc import Mapping
from contextlib import suppress
from pathlib import Path

from roslab.engine.docker import last_line
from roslab.engine.registry import with_retries
from roslab.errors import BuildError, Problem

KEPT = ("contexts", "cli-plugins")
"""Below the client's folder: where the engine is, and the plugins; https://docs.docker.com/reference/cli/docker/"""


def login(client: Path, host: str, username: str, password: str) -> None:
    """Log in at a registry, the login kept in ``client`` alone. Raises ``BuildError`` if it is refused.

    The password goes through standard input, so that no list of processes shows it.
    """
    command = ["docker", "login", host, "--username", username, "--password-stdin"]
    environment = {**os.environ, "DOCKER_CONFIG": str(client)}
    answer = with_retries(
        lambda: subprocess.run(
            command, input=password, env=environment, capture_output=True, text=True, errors="replace", check=False
        )
    )
    if answer.returncode:
        message = f"{host} refuses the login for base images: {last_line(answer.stderr)}"
        raise BuildError(Problem(message=message, hint=f"check the user and the password of registry:{host}"))


def private_client(home: Path, environment: Mapping[str, str]) -> Path:
    """Make a folder for docker's client, ``home``/.docker, which begins as a copy of the user's own; return it.

    A login of an earlier step goes on, for a base image that is not public. Which builder was in use does not: a job
    makes its own. Nobody but the user may enter.
    """
    own = Path(environment.get("DOCKER_CONFIG") or Path(environment.get("HOME") or os.devnull) / ".docker")
    target = home / ".docker"
    home.mkdir(mode=0o700)
    target.mkdir(mode=0o700)
    with suppress(OSError):
        shutil.copyfile(own / "config.json", target / "config.json")
        (target / "config.json").chmod(0o600)
    for name in KEPT:
        with suppress(OSError, shutil.Error):
            shutil.copytree(own / name, target / name, symlinks=True)
    return target
