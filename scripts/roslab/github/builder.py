"""The builder of a job: its driver, and the platforms that need an emulator on this machine."""

from __future__ import annotations

import json
import re
from collections.abc import Mapping, Sequence
from pathlib import Path

from roslab.engine.docker import native_platform, output
from roslab.knowledge.pins import pin


def settings(environment: Mapping[str, str], *, direct: bool = False) -> dict[str, str]:
    """Return the inputs of docker/setup-buildx-action and docker/setup-qemu-action, each part at its pinned version.

    ``direct`` asks for the engine's own BuildKit. It is enough for one platform that is not pushed, and it saves disk:
    any other builder would copy the image to the engine. Otherwise a runner gets its own BuildKit in a container.
    A machine that already has a BuildKit, and a buildx that fits it, names it with ROSLAB_BUILDX_DRIVER (``remote``)
    and ROSLAB_BUILDX_ENDPOINT (``unix:///…``): https://docs.docker.com/build/builders/drivers/
    """
    driver = environment.get("ROSLAB_BUILDX_DRIVER", "")
    return {
        "driver": driver or ("docker" if direct else "docker-container"),
        "endpoint": environment.get("ROSLAB_BUILDX_ENDPOINT", ""),
        "buildx": "" if driver else pin("buildx").version,
        "driver-opts": "" if driver or direct else f"image={pin('buildkit').reference}",
        "binfmt": pin("binfmt").reference,
    }


def scanner(environment: Mapping[str, str], *, wanted: bool, act: bool) -> str:
    """Return the input ``sbom`` of docker/build-push-action: the scanner that writes an image's bill of materials.

    Under act there is none by default, because the machine may be offline. ROSLAB_SBOM (``true``, ``false`` or the
    reference of another scanner) overrides this. https://docs.docker.com/build/metadata/attestations/sbom/
    """
    said = environment.get("ROSLAB_SBOM") or ("false" if act else "true")
    if not wanted or said == "false":
        return "false"
    return f"generator={pin('scanner').reference if said == 'true' else said}"


def emulated(platforms: Sequence[str]) -> tuple[str, ...]:
    """Return the architectures that the machine cannot run yet, in the names of docker/setup-qemu-action."""
    known = listed(output(["docker", "buildx", "inspect", "default"]).stdout) or (native_platform(),)
    lacking = [platform for platform in platforms if platform not in known]
    return tuple(dict.fromkeys(platform.split("/")[1] for platform in lacking))


def listed(inspection: str) -> tuple[str, ...]:
    """Return the platforms that ``docker buildx inspect`` lists; a star there marks preferred ones."""
    lines = re.findall(r"^\s*Platforms:\s*(.+)$", inspection, flags=re.MULTILINE)
    return tuple(part.strip().rstrip("*") for line in lines for part in line.split(",") if part.strip())


def failed_log(environment: Mapping[str, str]) -> str:
    """Return the log of the newest failed build that was started here, ``""`` if the builder keeps none.

    https://docs.docker.com/reference/cli/docker/buildx/history/
    """
    listing = output(["docker", "buildx", "history", "ls", "--format", "json"]).stdout
    newest = newest_failure(listing, _started(environment))
    if not newest:
        return ""
    answer = output(["docker", "buildx", "history", "logs", "--progress", "plain", newest])
    return answer.stdout + answer.stderr if answer.returncode == 0 else ""


def newest_failure(listing: str, started: Path) -> str | None:
    """Return the newest failed build of ``docker buildx history ls --format json``, which lists the newest first.

    ``started`` is the folder in which buildx notes the builds that it started, each as ``BUILDER/NODE/BUILD``. A
    BuildKit that several jobs share lists the builds of all of them: only those that are noted count, if any
    build of the builder is noted at all.
    """
    failed: list[str] = []
    for line in listing.splitlines():
        try:
            record = json.loads(line)
        except ValueError:
            continue
        if isinstance(record, dict) and str(record.get("status", "")).lower() == "error":
            failed.append(str(record.get("ref", "")))
    own = [ref for ref in failed if not (started / ref).parent.is_dir() or (started / ref).is_file()]
    return (own[0].rpartition("/")[2] or None) if own else None


def _started(environment: Mapping[str, str]) -> Path:
    """Return the folder of buildx's notes: https://docs.docker.com/build/building/variables/#buildx_config."""
    docker = environment.get("DOCKER_CONFIG") or Path(environment.get("HOME") or Path.home(), ".docker")
    return Path(environment.get("BUILDX_CONFIG") or Path(docker, "buildx"), "refs")
