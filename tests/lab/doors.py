"""Throw-away repositories that use the action or a workflow, and the events of GitHub that start them."""

from __future__ import annotations

import gzip
import hashlib
import json
import re
import urllib.request
from base64 import b64encode
from collections.abc import Callable, Iterator, Mapping
from functools import partial
from pathlib import Path
from typing import Any

from . import registry
from .act import Result
from .laboratory import Laboratory

OWNER = "lab"
"""Of every throw-away repository: the registry's user has that name, as on GitHub."""
CHECKOUT = "actions/checkout@3d3c42e5aac5ba805825da76410c181273ba90b1"
RECIPE = "format: 3\nkind: cpp\ndockerfile: Dockerfile\ntest: cat /machine\n"
FILES = {
    "Dockerfile": 'FROM ubuntu:24.04\nCOPY . /source\nRUN uname -m > /machine\nCMD ["cat", "/machine"]\n',
    "roslab.yaml": RECIPE,
    "CMakeLists.txt": "cmake_minimum_required(VERSION 3.10)\nproject(robot CXX)\n",
    # A caller's modules must not shadow the program's
    "yaml.py": "raise SystemExit('the caller shadows yaml')\n",
    "roslab/__init__.py": "raise SystemExit('the caller shadows roslab')\n",
}
"""The smallest repository whose image shows on which machine it was built, and holds all of its build context."""


def write(folder: Path, files: Mapping[str, str]) -> Path:
    """Write files by their paths and return the folder."""
    for path, text in files.items():
        (folder / path).parent.mkdir(parents=True, exist_ok=True)
        (folder / path).write_text(text)
    return folder


def settings(values: Mapping[str, str]) -> str:
    """Return the lines below ``with:``."""
    return "".join(f"          {name}: {json.dumps(value)}\n" for name, value in values.items())


SECRET = "REGISTRY_PASSWORD"
"""Of the repository, with the password of the registry: the run's own token is for ghcr.io alone."""


def through_action(
    folder: Path,
    inputs: Mapping[str, str],
    files: Mapping[str, str] | None = None,
    *,
    base: Mapping[str, str] = FILES,
    secret: str | None = SECRET,
) -> Path:
    """Write a repository, ``base`` and ``files`` over it, whose one job uses the action.

    ``secret`` is the name of the one that the action gets as its token, ``None`` for none.
    """
    inputs = {**({"token": f"${{{{ secrets.{secret} }}}}"} if secret else {}), **inputs}
    workflow = f"""
on: [push, pull_request, pull_request_target, schedule, workflow_dispatch]
jobs:
  image:
    runs-on: ubuntu-24.04
    steps:
      - uses: {CHECKOUT}
      - id: image
        uses: org/repro-action@v1
        with:
{settings(inputs)}
"""
    return write(folder, {**base, **(files or {}), ".github/workflows/image.yml": workflow})


def through_workflow(
    folder: Path,
    inputs: Mapping[str, str],
    files: Mapping[str, str] | None = None,
    *,
    base: Mapping[str, str] = FILES,
    door: str = "image",
    secret: str | None = SECRET,
) -> Path:
    """Write a repository whose one job calls a workflow, as a researcher would; the rest as for the action."""
    lines = settings(inputs).replace("          ", "      ")
    if secret:
        lines += f"    secrets:\n      registry-token: ${{{{ secrets.{secret} }}}}\n"
    workflow = f"""
on: [push, pull_request, schedule, workflow_dispatch]
jobs:
  image:
    uses: org/repro-action/.github/workflows/{door}.yml@v1
    permissions: {{contents: read, packages: write}}
    with:
{lines}
"""
    return write(folder, {**base, **(files or {}), ".github/workflows/caller.yml": workflow})


def payload(name: str, *, ref: str = "refs/heads/main", head: str | None = None) -> dict[str, Any]:
    """Return an event of a repository, ``OWNER/name``; ``head`` is the repository that a pull request comes from.

    The workspace in the image has that name: tests that build the same compile it once where it is the same, and the
    input ``image`` keeps what they publish apart.
    """
    repository = {"full_name": f"{OWNER}/{name}", "default_branch": "main", "private": False}
    found: dict[str, Any] = {"ref": ref, "repository": repository}
    if head:
        found["number"] = 7
        found["pull_request"] = {
            "number": 7,
            "head": {"ref": "change", "sha": "0" * 40, "repo": {"full_name": head, "fork": head != f"{OWNER}/{name}"}},
            "base": {"ref": "main"},
        }
        found["ref"] = "refs/pull/7/merge"
    return found


def builder(lab: Laboratory) -> dict[str, str]:
    """Return what tells the action to use the lab's own BuildKit."""
    return {"ROSLAB_BUILDX_DRIVER": "remote", "ROSLAB_BUILDX_ENDPOINT": lab.buildkit}


def errors(result: Result) -> list[str]:
    """Return the error annotations of a run."""
    return [found[1] for line in result.log.splitlines() if (found := re.search(r"::error[^:]*::(.*)", line))]


def seconds(result: Result, step: str) -> float:
    """Return how long a step took, as act says it."""
    units = {"ms": 0.001, "µs": 0.000001, "ns": 0.0, "s": 1.0, "m": 60.0}
    match = re.search(rf"Success - Main {re.escape(step)} \[([^\]]+)\]", result.log)
    assert match, f"no step {step!r} in the log"
    return sum(float(number) * units[unit] for number, unit in re.findall(r"([\d.]+)(ms|µs|ns|s|m)", match[1]))


def blobs(lab: Laboratory, reference: str) -> Iterator[bytes]:
    """Yield everything that the registry holds for an image: manifests, configurations, layers, attestations."""
    for _, read in _parts(lab, reference):
        yield read()


def showing(lab: Laboratory, reference: str, text: str) -> list[str]:
    """Return the digests of what the registry holds for an image and has a text in it.

    Images of one base share its layers: what has the same digest is fetched once by each process.
    """
    found = []
    for digest, read in _parts(lab, reference):
        if (digest, text) not in _SHOWN:
            _SHOWN[digest, text] = text.encode() in read()
        found += [digest] if _SHOWN[digest, text] else []
    return found


_SHOWN: dict[tuple[str, str], bool] = {}
"""Whether what has a digest has a text in it."""


def _parts(lab: Laboratory, reference: str) -> Iterator[tuple[str, Callable[[], bytes]]]:
    """Yield the digest of everything that the registry holds for an image, with what reads and unpacks it."""
    repository, _, name = reference.partition("/")[2].rpartition("@" if "@" in reference else ":")
    manifest, _ = _get(lab, f"{repository}/manifests/{name}")
    yield f"sha256:{hashlib.sha256(manifest).hexdigest()}", lambda: manifest
    found = json.loads(manifest)
    for child in found.get("manifests", []):
        yield from _parts(lab, f"{lab.registry}/{repository}@{child['digest']}")
    for entry in [*([found["config"]] if "config" in found else []), *found.get("layers", [])]:
        yield entry["digest"], partial(_blob, lab, repository, entry["digest"])


def _blob(lab: Laboratory, repository: str, digest: str) -> bytes:
    data, _ = _get(lab, f"{repository}/blobs/{digest}")
    return gzip.decompress(data) if data[:2] == b"\x1f\x8b" else data


def _get(lab: Laboratory, path: str) -> tuple[bytes, str]:
    accept = ("application/vnd.oci.image.index.v1+json", "application/vnd.oci.image.manifest.v1+json",
              "application/vnd.docker.distribution.manifest.v2+json", "*/*")  # fmt: skip
    password = b64encode(f"{lab.username}:{lab.password}".encode()).decode()
    headers = {"Authorization": f"Basic {password}", "Accept": ", ".join(accept)}
    request = urllib.request.Request(f"http://{lab.registry}/v2/{path}", headers=headers)
    with urllib.request.urlopen(request, timeout=60) as reply:  # noqa: S310 - the lab's own registry
        return reply.read(), reply.headers.get("Content-Type", "")


def tags(repository: str) -> dict[str, str]:
    """Return the tags of a repository in the registry, without those of the layer cache, and their digests."""
    names = [tag for tag in registry.tags(repository) if not tag.startswith("buildcache-")]
    return {name: registry.digest(f"{repository}:{name}") for name in names}
