"""What BuildKit wrote down of a build: its steps, which of them ran, its log, and the whole record as a file."""

from __future__ import annotations

import json
import os
import re
import subprocess
import tempfile
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from .command import LabError

RUN = re.compile(r"\[(?:(?P<platform>[a-z]+/[\w/]+) )?[^\]]*\] RUN ")
"""Beginning of a step's name in a record: ``[linux/arm64 2/3] RUN …``; one platform alone is not named."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Step:
    """One step of a build: ``cached`` where BuildKit took its result from a cache and did not run it."""

    name: str
    cached: bool
    failed: bool

    @property
    def runs(self) -> bool:
        """It is a RUN of the Dockerfile."""
        return bool(RUN.match(self.name))


@dataclass(frozen=True, kw_only=True, slots=True)
class Records:
    """The build records of one buildkitd, read with buildx in a client's folder of its own."""

    environment: dict[str, str]

    def builds(self) -> list[dict[str, Any]]:
        """Return what ``docker buildx history ls`` lists, the newest first."""
        return [json.loads(line) for line in self._ask("ls", "--format", "json").splitlines() if line.strip()]

    def inspect(self, build: dict[str, Any]) -> str:
        """Return the record as ``docker buildx history inspect`` prints it: arguments, labels, outputs, materials."""
        return self._ask("inspect", "--format", "json", _id(build))

    def log(self, build: dict[str, Any]) -> str:
        """Return the whole log, one JSON object a line."""
        return self._ask("logs", "--progress", "rawjson", _id(build))

    def steps(self, build: dict[str, Any]) -> tuple[Step, ...]:
        """Return every step of a build, from its log."""
        found: dict[str, dict[str, Any]] = {}
        for line in self.log(build).splitlines():
            for vertex in json.loads(line).get("vertexes") or () if line.startswith("{") else ():
                found.setdefault(vertex["digest"], {}).update(vertex)
        return tuple(
            Step(name=str(v.get("name", "")), cached=bool(v.get("cached")), failed=bool(v.get("error")))
            for v in found.values()
        )

    def export(self, build: dict[str, Any], file: Path) -> Path:
        """Write the whole record, with its log and its provenance, to a file: a compressed OCI layout."""
        self._ask("export", "--output", str(file), _id(build))
        return file

    def _ask(self, *words: str) -> str:
        command: Sequence[str] = ["docker", "buildx", "history", words[0], "--builder", "records", *words[1:]]
        done = subprocess.run(command, env=self.environment, capture_output=True, text=True, timeout=60, check=False)
        if done.returncode:
            raise LabError(f"{' '.join(command)}: exit code {done.returncode}: {done.stderr}")
        # Where no terminal is, `logs` speaks on standard error
        return done.stdout or done.stderr


@contextmanager
def records(buildkit: str, docker_host: str) -> Iterator[Records]:
    """Yield the records of the buildkitd at an address, finished or not."""
    with tempfile.TemporaryDirectory() as place:
        environment = {**os.environ, "DOCKER_HOST": docker_host, "DOCKER_CONFIG": place, "BUILDX_CONFIG": place}
        create = ["docker", "buildx", "create", "--name", "records", "--driver", "remote", buildkit]
        subprocess.run(create, env=environment, capture_output=True, timeout=60, check=True)
        yield Records(environment=environment)


def _id(build: dict[str, Any]) -> str:
    return str(build["ref"]).rpartition("/")[2]
