"""One build on a BuildKit of its own, pushed to a registry of its own, and what can be counted of it."""

from __future__ import annotations

import json
import os
import re
import shutil
import socket
import subprocess
import tempfile
import time
import urllib.error
import urllib.request
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from lab import buildkit

RUN = re.compile(r"\[[^\]]*\] RUN ")
"""Beginning of the name that BuildKit gives a RUN."""
INSTALLS = re.compile(r"apt-get |\brosdep |pip3? install|\binstall-|package-sources|git clone|create-user")
"""What a RUN that prepares dependencies calls, in any of the ways; the others compile or write a line of a file."""
MANIFESTS = (
    "application/vnd.oci.image.index.v1+json, application/vnd.oci.image.manifest.v1+json, "
    "application/vnd.docker.distribution.manifest.list.v2+json, application/vnd.docker.distribution.manifest.v2+json"
)


class FailedBuildError(RuntimeError):
    """A build that failed, with its log."""


@dataclass(frozen=True)
class Figures:
    """What one build took and made."""

    seconds: float
    steps: int
    """RUN steps that were executed."""
    dependency_steps: int
    """Those of them that install."""
    bytes: int
    """What the registry did not have yet."""
    size: int
    """Of the image as it is downloaded: its compressed layers."""


@dataclass
class Registry:
    """A registry on the loopback that nobody else uses."""

    address: str
    known: set[str] = field(default_factory=set)
    """Digests of what it was given before."""

    def received(self, reference: str) -> tuple[int, int]:
        """Return the bytes of an image that are new here, and its whole size; from now on it is known."""
        manifest = self._manifest(reference)
        parts = [manifest["config"], *manifest["layers"]]
        new = {part["digest"]: part["size"] for part in parts if part["digest"] not in self.known}
        self.known |= set(new)
        return sum(new.values()), sum(part["size"] for part in manifest["layers"])

    def _manifest(self, reference: str) -> dict[str, Any]:
        repository, _, name = reference.rpartition("@" if "@" in reference else ":")
        address = f"http://{self.address}/v2/{repository}/manifests/{name}"
        request = urllib.request.Request(address, headers={"Accept": MANIFESTS})
        with urllib.request.urlopen(request, timeout=60) as reply:
            found: dict[str, Any] = json.load(reply)
        if "manifests" in found:
            return self._manifest(f"{repository}@{found['manifests'][0]['digest']}")
        return found


@contextmanager
def registry() -> Iterator[Registry]:
    """Run a registry with an empty store. Raises ``FailedBuildError`` if it does not answer."""
    program = shutil.which("docker-registry") or "/usr/bin/docker-registry"
    with tempfile.TemporaryDirectory(prefix="roslab-registry-") as folder, socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        port = probe.getsockname()[1]
        probe.close()
        storage = {"filesystem": {"rootdirectory": folder}, "delete": {"enabled": True}}
        settings = {"version": 0.1, "storage": storage, "http": {"addr": f"127.0.0.1:{port}"}}
        configuration = Path(folder, "registry.json")
        configuration.write_text(json.dumps(settings))
        quiet = subprocess.DEVNULL
        with subprocess.Popen([program, "serve", configuration], stdin=quiet, stdout=quiet, stderr=quiet) as server:
            try:
                found = Registry(f"127.0.0.1:{port}")
                _wait_for(found)
                yield found
            finally:
                server.terminate()


def _wait_for(found: Registry) -> None:
    for _ in range(100):
        if _answers(found):
            return
        time.sleep(0.1)
    raise FailedBuildError("the registry does not answer")


def _answers(found: Registry) -> bool:
    try:
        urllib.request.urlopen(f"http://{found.address}/v2/", timeout=5).close()
    except (urllib.error.URLError, OSError):
        return False
    return True


@dataclass(frozen=True)
class Builder:
    """A BuildKit with a store of its own, and a client's folder of its own."""

    environment: dict[str, str]

    def build(self, words: Sequence[str | Path], context: Path) -> str:
        """Run ``docker buildx build`` and return its log, one JSON object a line. Raises ``FailedBuildError``."""
        command = ["docker", "buildx", "build", "--builder", "bench", "--progress", "rawjson", "--provenance=false"]
        command += [*map(str, words), str(context)]
        done = subprocess.run(
            command, env=self.environment, capture_output=True, text=True, errors="replace", timeout=3600, check=False
        )
        if done.returncode:
            raise FailedBuildError(f"{' '.join(command)}\n{done.stderr[-6000:]}")
        return done.stderr


@contextmanager
def builder() -> Iterator[Builder]:
    """Run a BuildKit with an empty store, as a fresh runner has it."""
    with tempfile.TemporaryDirectory(prefix="roslab-builder-") as folder:
        place = Path(folder)
        with buildkit.fresh(place / "buildkit") as address:
            client = place / "client"
            client.mkdir()
            environment = {**os.environ, "DOCKER_CONFIG": str(client), "BUILDX_CONFIG": str(client)}
            create = ["docker", "buildx", "create", "--name", "bench", "--driver", "remote", address]
            subprocess.run(create, env=environment, capture_output=True, timeout=60, check=True)
            yield Builder(environment)


def executed(log: str) -> list[str]:
    """Return the names of the RUN steps that a build executed, from its log."""
    found: dict[str, dict[str, Any]] = {}
    for line in log.splitlines():
        for vertex in json.loads(line).get("vertexes") or () if line.startswith("{") else ():
            found.setdefault(vertex["digest"], {}).update(vertex)
    return [
        v["name"] for v in found.values() if RUN.match(v.get("name", "")) and not v.get("cached") and "started" in v
    ]


def figures(log: str, seconds: float, received: int, size: int) -> Figures:
    """Return the figures of a build."""
    steps = executed(log)
    installing = [name for name in steps if INSTALLS.search(name)]
    return Figures(round(seconds, 2), len(steps), len(installing), received, size)
