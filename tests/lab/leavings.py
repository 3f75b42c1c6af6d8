"""Everything that a run leaves: in the registry, in the engine, in the builder, on the runner, and what it said."""

from __future__ import annotations

import json
import subprocess
import tempfile
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

from . import records, registry
from .act import Result
from .canary import Place
from .home import folder
from .laboratory import Laboratory

PREDICATES = {"https://slsa.dev/provenance": "provenance", "https://spdx.dev/Document": "bill of materials"}


def said(ran: Result) -> Iterator[Place]:
    """Yield what a run said: its whole log, its summary, every output of every step."""
    yield "log", ran.log.encode()
    yield "summary", ran.summary.encode()
    for job, outputs in ran.outputs.items():
        for name, text in outputs.items():
            yield f"output {name} of {job}", text.encode()


def kept(place: Path) -> Iterator[Place]:
    """Yield the files of every artifact that was uploaded, and of the action's own folder where a step kept it."""
    for name in ("artifacts", "act-artifacts"):
        for file in sorted((place / name).rglob("*")):
            if file.is_file():
                yield f"artifact {file.relative_to(place)}", file.read_bytes()


def stored(repository: str) -> Iterator[Place]:
    """Yield everything that was ever pushed to a repository of the lab's registry, also what no tag names."""
    store = folder("registries", registry.PROTECTED) / "docker" / "registry" / "v2"
    own = store / "repositories" / repository
    digests = {link.read_text().strip() for link in own.rglob("link")}
    contents = {digest: _blob(store, digest) for digest in sorted(digests)}
    kinds = _kinds({digest: data for digest, data in contents.items() if data[:1] == b"{"})
    for digest, data in contents.items():
        yield f"{kinds.get(digest, 'blob')} {digest}", data
    for tag in registry.tags(repository):
        yield f"tag {tag}", tag.encode()
    for file in own.rglob("_uploads/*/data"):
        yield f"unfinished upload {file.parent.name}", file.read_bytes()


def _blob(store: Path, digest: str) -> bytes:
    algorithm, _, name = digest.partition(":")
    return (store / "blobs" / algorithm / name[:2] / name / "data").read_bytes()


def _kinds(texts: dict[str, bytes]) -> dict[str, str]:
    """Return what each blob is, from the manifests that name it; a layer of the image may be one of the cache too."""
    found: dict[str, set[str]] = {}
    for data in texts.values():
        manifest = json.loads(data)
        entries = [*([manifest["config"]] if "config" in manifest else []), *manifest.get("layers", [])]
        if "manifests" in manifest or not all(isinstance(entry, dict) and "digest" in entry for entry in entries):
            continue
        cache = any("cacheconfig" in str(entry.get("mediaType")) for entry in entries)
        for entry in entries:
            found.setdefault(entry["digest"], set()).add(("cached " if cache else "") + _kind(entry))
    return {digest: ", ".join(sorted(names)) for digest, names in found.items()}


def _kind(entry: dict[str, Any]) -> str:
    predicate = str(entry.get("annotations", {}).get("in-toto.io/predicate-type", ""))
    for address, name in PREDICATES.items():
        if predicate.startswith(address):
            return name
    return "configuration" if "config" in str(entry.get("mediaType")) else "layer"


def pulled(lab: Laboratory, reference: str, username: str, password: str) -> Iterator[Place]:
    """Yield what ``docker history`` and ``docker image inspect`` say of an image on each of its platforms."""
    index, _ = registry.manifest(reference.partition("/")[2])
    platforms = [f"{x['platform']['os']}/{x['platform']['architecture']}" for x in index["manifests"]]
    with lab.logged_in(username, password) as client:
        for platform in [name for name in platforms if not name.startswith("unknown")]:
            _docker(client, "pull", "--quiet", "--platform", platform, reference)
            for words in (("history", "--no-trunc", "--format", "json"), ("image", "inspect")):
                told = _docker(client, *words, "--platform", platform, reference)
                yield f"docker {words[0]} on {platform}", told.encode()
        _docker(client, "image", "rm", reference)


def _docker(environment: Mapping[str, str], *words: str) -> str:
    done = subprocess.run(["docker", *words], env=environment, capture_output=True, text=True, timeout=300, check=False)
    assert done.returncode == 0, done.stderr
    return done.stdout


def recorded(lab: Laboratory, repository: str) -> Iterator[Place]:
    """Yield the builder's records of a repository's builds: as buildx tells them, their logs, and whole as files."""
    with records.records(lab.buildkit, lab.docker_host) as history, tempfile.TemporaryDirectory() as place:
        for build in history.builds():
            if not str(build["name"]).endswith(f"/{repository}"):
                continue
            name = str(build["ref"]).rpartition("/")[2]
            yield f"record {name}", json.dumps(build).encode() + history.inspect(build).encode()
            yield f"log of record {name}", history.log(build).encode()
            yield f"export of record {name}", history.export(build, Path(place) / f"{name}.dockerbuild").read_bytes()
