"""Calls of docker and buildx, as a person would type them; nothing is decided here."""

from __future__ import annotations

import io
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
from collections import deque
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path

from roslab.engine.secrets import Secret
from roslab.errors import BuildError, Problem
from roslab.explain import words
from roslab.explain.answer import explain
from roslab.repository import git as commits
from roslab.values.dataclass import dataclass, replace

MINIMUM = 23
"""First engine whose built-in Dockerfile frontend knows here-documents: https://docs.docker.com/engine/release-notes/23.0/"""
KEPT = 20_000
"""Lines of a build's log that are kept to explain a failure: the first error can be far above the end."""
Say = Callable[[str], None]


class FailedBuild(BuildError):  # noqa: N818 - its base says that it is an error
    """A build or a proof that failed, with the end of its log."""

    def __init__(self, *problems: Problem, log: str) -> None:
        super().__init__(*problems)
        self.log = log


def say(text: str) -> None:
    """Print progress; the default wherever progress is reported here."""
    print(text, file=sys.stderr, flush=True)


@dataclass(frozen=True, kw_only=True, slots=True)
class Build:
    """One call of ``docker buildx build``."""

    context: Path
    dockerfile: Path
    platforms: tuple[str, ...] = ()
    tags: tuple[str, ...] = ()
    labels: tuple[tuple[str, str], ...] = ()
    arguments: tuple[tuple[str, str], ...] = ()
    contexts: tuple[tuple[str, str], ...] = ()
    """Named contexts: images that a FROM names, and what stands for each."""
    target: str | None = None
    """Stage to build; ``None`` for the last one."""
    output: str = ""
    """Value of ``--output``; ``""`` loads the image into the engine."""
    secrets: tuple[Secret, ...] = ()
    extra: tuple[str, ...] = ()


def check() -> str:
    """Return the engine's version. Raises ``BuildError`` if it is absent, does not answer or is too old."""
    if not shutil.which("docker"):
        raise BuildError(
            Problem(
                message="docker is not installed",
                hint="install Docker Engine 23 or newer: https://docs.docker.com/engine/install/",
            )
        )
    answer = output(["docker", "version", "--format", "{{.Server.Version}}"])
    if answer.returncode:
        error = last_line(answer.stderr)
        raise BuildError(
            Problem(
                message=f"the Docker engine does not answer: {error}",
                hint="start it, or set DOCKER_HOST to one that runs",
            )
        )
    version = answer.stdout.strip()
    major = re.match(r"\d+", version)
    if not major or int(major[0]) < MINIMUM:
        raise BuildError(
            Problem(message=f"Docker engine {version} is too old", hint=f"version {MINIMUM} or newer is needed")
        )
    if output(["docker", "buildx", "version"]).returncode:
        raise BuildError(Problem(message="docker has no buildx", hint="install the docker-buildx-plugin package"))
    return version


def build(job: Build, *, environment: Mapping[str, str] | None = None) -> tuple[str, str]:
    """Build an image, its progress on standard error as docker prints it; return its digest and the end of the log.

    The digest is that of the index if several platforms were pushed, that of the image if it was loaded.
    Raises ``FailedBuild`` with the step that failed.
    """
    with tempfile.TemporaryDirectory() as folder:
        metadata = Path(folder) / "metadata.json"
        command = [
            "docker",
            "buildx",
            "build",
            "--file",
            str(job.dockerfile),
            "--metadata-file",
            str(metadata),
        ]
        command += ["--platform", ",".join(job.platforms)] if job.platforms else []
        for tag in job.tags:
            command += ["--tag", tag]
        given = (("--label", job.labels), ("--build-arg", job.arguments), ("--build-context", job.contexts))
        for flag, pairs in given:
            for name, value in pairs:
                command += [flag, f"{name}={value}"]
        command += ["--target", job.target] if job.target else []
        command += [word for secret in job.secrets for word in secret.words()]
        command += ["--output", job.output] if job.output else ["--load"]
        command += [*job.extra, str(job.context)]
        log = _stream(command, environment)
        record = json.loads(metadata.read_text(encoding="utf-8")) if metadata.exists() else {}
    return str(record.get("containerimage.digest", "")), log


def materials(job: Build) -> list[dict[str, object]]:
    """Build once more without a result and return what was taken from elsewhere, as BuildKit's provenance lists it.

    Steps that the cache has are not repeated. Raises ``FailedBuild``.
    """
    with tempfile.TemporaryDirectory() as folder:
        metadata = Path(folder) / "metadata.json"
        extra = (*job.extra, "--provenance=mode=min", "--metadata-file", str(metadata))
        build(replace(job, output="type=cacheonly", tags=(), extra=extra))
        return materials_of(metadata.read_text(encoding="utf-8")) if metadata.exists() else []


def materials_of(metadata: str) -> list[dict[str, object]]:
    """Return what the builds of a metadata file took from elsewhere; of several platforms each has its provenance.

    https://docs.docker.com/reference/cli/docker/buildx/build/#metadata-file
    """
    found: list[dict[str, object]] = []
    for name, said in json.loads(metadata).items():
        if name.partition("/")[0] == "buildx.build.provenance" and isinstance(said, dict):
            listed = said.get("buildDefinition", {}).get("resolvedDependencies") or said.get("materials")
            found += [each for each in listed or () if isinstance(each, dict)]
    return found


def _stream(command: Sequence[str], environment: Mapping[str, str] | None) -> str:
    """Run a command, pass its output on line by line, and return the end of it."""
    lines: deque[str] = deque(maxlen=KEPT)
    settings = {**os.environ, **(environment or {})}
    with subprocess.Popen(
        command,
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        env=settings,
        text=True,
        errors="replace",
    ) as process:
        try:
            for line in process.stdout or ():
                sys.stderr.write(line)
                sys.stderr.flush()
                lines.append(line)
        except BaseException:
            process.terminate()
            raise
    log = "".join(lines)
    if process.returncode:
        raise FailedBuild(*why(log), log=log)
    return log


def why(log: str) -> tuple[Problem, ...]:
    """Return why a build failed, from its log: a problem for each step that failed."""
    found = words.problems(explain(io.BytesIO(log.encode("utf-8", errors="replace"))))
    return found or (Problem(message="the build failed", hint="the lines above say why"),)


def native_platform() -> str:
    """Return the engine's own platform, ``linux/amd64``."""
    answer = output(["docker", "version", "--format", "{{.Server.Os}}/{{.Server.Arch}}"])
    return answer.stdout.strip() or "linux/amd64"


def machine_memory() -> int:
    """Return the bytes of memory of the engine's machine, 0 where it does not say."""
    said = output(["docker", "info", "--format", "{{.MemTotal}}"]).stdout.strip()
    return int(said) if said.isdigit() else 0


def commit_labels(root: Path) -> tuple[tuple[str, str], ...]:
    """Return the labels that name the commit of a checkout, none if there is no git or no commit.

    https://github.com/opencontainers/image-spec/blob/main/annotations.md
    """
    revision = commits.head(root)[0] if (root / ".git").exists() else ""
    return (("org.opencontainers.image.revision", revision),) if revision else ()


def labels_of(reference: str) -> dict[str, str]:
    """Return the labels of an image in the engine, none if it is not there."""
    answer = output(["docker", "image", "inspect", "--format", "{{json .Config.Labels}}", reference])
    return dict(json.loads(answer.stdout) or {}) if answer.returncode == 0 else {}


def starts_shell(reference: str) -> bool:
    """Tell whether a loaded image starts a bare shell, as base images do."""
    answer = output(["docker", "image", "inspect", "--format", "{{json .Config.Cmd}}", reference])
    words = json.loads(answer.stdout) if answer.returncode == 0 else None
    return isinstance(words, list) and [Path(word).name for word in words] in (["bash"], ["sh"])


def name_image(candidate: str, name: str, label: tuple[str, str] | None = None) -> None:
    """Give an image that passed its proofs its name, and perhaps a label that could not be known before.

    Its layers stay the same. Raises ``BuildError`` if the engine refuses.
    """
    command = ["docker", "tag", candidate, name]
    if label:
        # The engine's own builder, which has the context's name, is the one that sees its images
        engine = output(["docker", "context", "show"]).stdout.strip() or "default"
        platform = output(["docker", "image", "inspect", "--format", "{{.Os}}/{{.Architecture}}", candidate]).stdout
        words = ["--builder", engine, "--platform", platform.strip(), "--provenance=false", "--load"]
        command = ["docker", "buildx", "build", *words, "--label", "=".join(label), "--tag", name, "-"]
    answer = output(command, stdin=f"FROM {candidate}\n" if label else "")
    if answer.returncode:
        raise BuildError(Problem(message=f"cannot name the image {name}: {last_line(answer.stderr)}"))


def remove_image(reference: str) -> None:
    """Remove a loaded image; it is no error if it is gone or in use."""
    output(["docker", "image", "rm", reference])


def output(command: Sequence[str], timeout: float = 120.0, stdin: str = "") -> subprocess.CompletedProcess[str]:
    """Run a short command and return what it printed; exit code 124: no answer within ``timeout`` seconds."""
    try:
        return subprocess.run(
            command,
            capture_output=True,
            input=stdin,
            text=True,
            errors="replace",
            timeout=timeout,
            check=False,
        )
    except subprocess.TimeoutExpired:
        return subprocess.CompletedProcess(command, 124, "", f"no answer within {timeout:.0f} s")


def last_line(text: str) -> str:
    """Return the last line that is not blank."""
    return next((line.strip() for line in reversed(text.splitlines()) if line.strip()), "no message")
