"""Two builds of one commit compared: layer by layer, and in a layer file by file."""

from __future__ import annotations

import hashlib
import json
import tarfile
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path
from typing import IO, Any

MOST = 200
"""Files that are named; a layer that differs in more is of no use to anybody as a list."""
CHUNK = 1024 * 1024


def differences(first: Path, second: Path) -> tuple[str, ...]:
    """Return how the images in two OCI archives differ, a line for each file; ``()`` if their digests are equal.

    https://github.com/opencontainers/image-spec/blob/main/image-layout.md
    """
    with tarfile.open(first) as one, tarfile.open(second) as other:
        before, after = _manifest(one), _manifest(other)
        if before == after:
            return ()
        lines = [] if before["config"] == after["config"] else ["the configuration: its variables, labels or times"]
        layers, others = before["layers"], after["layers"]
        if len(layers) != len(others):
            return (*lines, f"{len(layers)} layers, then {len(others)}")
        for number, (old, new) in enumerate(zip(layers, others, strict=True), 1):
            if old["digest"] != new["digest"]:
                found = list(_of_layer(_blob(one, old["digest"]), _blob(other, new["digest"])))
                lines += [f"layer {number}: {line}" for line in found or ["the same files in another order"]]
    return tuple(lines[:MOST])


def _manifest(archive: tarfile.TarFile) -> dict[str, Any]:
    found: dict[str, Any] = json.load(_file(archive, "index.json"))
    while "manifests" in found:
        found = json.load(_blob(archive, found["manifests"][0]["digest"]))
    return found


def _blob(archive: tarfile.TarFile, digest: str) -> IO[bytes]:
    return _file(archive, f"blobs/{digest.replace(':', '/', 1)}")


def _file(archive: tarfile.TarFile, name: str) -> IO[bytes]:
    found = archive.extractfile(name)
    if found is None:
        raise KeyError(name)
    return found


def _of_layer(before: IO[bytes], after: IO[bytes]) -> Iterator[str]:
    old, new = _members(before), _members(after)
    for name in sorted(old.keys() | new.keys()):
        if name not in new or name not in old:
            yield f"{name}: only in the {'first' if name in old else 'second'}"
        elif changed := [what for what in old[name] if old[name][what] != new[name][what]]:
            yield f"{name}: {', '.join(changed)}"


def _members(layer: IO[bytes]) -> dict[str, dict[str, object]]:
    found: dict[str, dict[str, object]] = {}
    with tarfile.open(fileobj=layer) as files:
        for member in files:
            digest = ""
            with suppress(KeyError):  # a hard link to a file of a layer below
                content = files.extractfile(member) if member.isfile() else None
                digest = _digest(content) if content else ""
            found[member.name] = {
                "contents": digest,
                "kind": (member.type, member.linkname),
                "mode": member.mode,
                "owner": (member.uid, member.gid),
                "time": member.mtime,
            }
    return found


def _digest(content: IO[bytes]) -> str:
    digest = hashlib.sha256()
    while chunk := content.read(CHUNK):
        digest.update(chunk)
    return digest.hexdigest()
