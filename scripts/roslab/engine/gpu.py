"""The GPUs that a container on this machine can be given."""

from __future__ import annotations

import shutil

from roslab.engine.docker import output


def users() -> frozenset[int]:
    """Return the processes of this machine that compute on a GPU, by their numbers outside of containers.

    https://docs.nvidia.com/deploy/nvidia-smi/index.html
    """
    answer = output(["nvidia-smi", "--query-compute-apps=pid", "--format=csv,noheader"], timeout=20.0)
    said = answer.stdout.split() if answer.returncode == 0 else ()
    return frozenset(int(word) for word in said if word.isdigit())


def usable() -> tuple[str, ...]:
    """Return the names of NVIDIA's GPUs, none if the engine cannot give them to a container."""
    if not shutil.which("nvidia-smi"):
        return ()
    answer = output(["nvidia-smi", "--query-gpu=name", "--format=csv,noheader"])
    names = tuple(line.strip() for line in answer.stdout.splitlines() if line.strip())
    if answer.returncode or not names:
        return ()
    # The older way registers a runtime, the newer one (CDI) lists devices
    engine = output(["docker", "info", "--format", "{{json .}}"]).stdout
    given = '"nvidia"' in engine or "nvidia.com/gpu" in engine or shutil.which("nvidia-container-runtime-hook")
    return names if given else ()
