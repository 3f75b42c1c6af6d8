"""Two images compared: equal ones are equal, and of others each file that differs is named."""

from __future__ import annotations

import gzip
import hashlib
import io
import json
import tarfile
from pathlib import Path

from roslab.engine.twice import differences

Files = dict[str, tuple[str, int]]
"""Contents and time of each file of a layer."""


def packed(files: Files) -> bytes:
    raw = io.BytesIO()
    with tarfile.open(fileobj=raw, mode="w") as archive:
        for name, (text, time) in files.items():
            entry = tarfile.TarInfo(name)
            entry.size, entry.mtime = len(text), time
            archive.addfile(entry, io.BytesIO(text.encode()))
    return gzip.compress(raw.getvalue(), mtime=0)


def image(file: Path, *layers: Files, created: str = "1970") -> Path:
    blobs: dict[str, bytes] = {}

    def keep(data: bytes) -> dict[str, object]:
        digest = hashlib.sha256(data).hexdigest()
        blobs[f"blobs/sha256/{digest}"] = data
        return {"digest": f"sha256:{digest}", "size": len(data)}

    config = keep(json.dumps({"created": created}).encode())
    manifest = keep(json.dumps({"config": config, "layers": [keep(packed(layer)) for layer in layers]}).encode())
    inner = keep(json.dumps({"manifests": [manifest]}).encode())
    blobs["index.json"] = json.dumps({"manifests": [inner]}).encode()
    with tarfile.open(file, "w") as archive:
        for name, data in blobs.items():
            entry = tarfile.TarInfo(name)
            entry.size = len(data)
            archive.addfile(entry, io.BytesIO(data))
    return file


BASE: Files = {"etc/os-release": ("debian", 1)}
BUILT: Files = {"home/node": ("program", 2), "var/log/dpkg.log": ("at nine", 2)}


def test_the_same_bits(tmp_path: Path) -> None:
    assert differences(image(tmp_path / "a.tar", BASE, BUILT), image(tmp_path / "b.tar", BASE, BUILT)) == ()


def test_each_file_that_differs_is_named_with_its_layer(tmp_path: Path) -> None:
    again: Files = {"home/node": ("program", 3), "var/log/dpkg.log": ("at ten!", 2), "home/more": ("", 2)}
    assert differences(image(tmp_path / "a.tar", BASE, BUILT), image(tmp_path / "b.tar", BASE, again)) == (
        "layer 2: home/more: only in the second",
        "layer 2: home/node: time",
        "layer 2: var/log/dpkg.log: contents",
    )


def test_order_layers_and_configuration(tmp_path: Path) -> None:
    first = image(tmp_path / "a.tar", BUILT)
    turned = image(tmp_path / "b.tar", dict(reversed(BUILT.items())))
    assert differences(first, turned) == ("layer 1: the same files in another order",)
    assert differences(first, image(tmp_path / "c.tar", BUILT, BASE)) == ("1 layers, then 2",)
    later = image(tmp_path / "d.tar", BUILT, created="1971")
    assert differences(first, later) == ("the configuration: its variables, labels or times",)
