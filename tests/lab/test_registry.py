"""The lab's registry bears what an image and its layer cache do: both upload the same layers at the same time."""

from __future__ import annotations

import hashlib
import json
import urllib.error
import urllib.request
from base64 import b64encode
from concurrent.futures import ThreadPoolExecutor
from threading import Event
from urllib.parse import urljoin

import pytest

from lab import mounts, registry
from lab.laboratory import ARCHITECTURES, Laboratory

LAYER = b"a layer" * 100
CONFIGURATION = b"{}"
MANIFEST = "application/vnd.oci.image.manifest.v1+json"
UPLOADERS = 4
TRIES = 80
"""Without a memory of its layers the registry refused 9 in 100 manifests."""


@pytest.mark.parametrize("owner", mounts.OWNERS)
def test_layers_of_the_usual_base_can_be_taken_from_a_repository_of_each_owner(lab: Laboratory, owner: str) -> None:
    """It is the last one by name, for which alone BuildKit asks."""
    there = f"{owner}/{mounts.NAME}"
    index, _ = registry.manifest(f"{there}:{'-'.join(ARCHITECTURES)}")
    assert [each["platform"]["architecture"] for each in index["manifests"]] == list(ARCHITECTURES)
    assert max(name for name in registry.repositories() if name.startswith(f"{owner}/")) == there


def test_a_manifest_is_taken_while_its_layer_is_uploaded_again(lab: Laboratory) -> None:
    repository = lab.fresh_repository("lab/race").partition("/")[2]
    manifest = {
        "schemaVersion": 2,
        "mediaType": MANIFEST,
        "config": upload(lab, repository, CONFIGURATION, "application/vnd.oci.image.config.v1+json"),
        "layers": [upload(lab, repository, LAYER, "application/vnd.oci.image.layer.v1.tar")],
    }
    ended = Event()

    def again() -> None:
        while not ended.is_set():
            upload(lab, repository, LAYER, "")

    with ThreadPoolExecutor(UPLOADERS) as pool:
        uploads = [pool.submit(again) for _ in range(UPLOADERS)]
        try:
            address = f"/v2/{repository}/manifests/main"
            said = [ask(lab, "PUT", address, json.dumps(manifest).encode(), MANIFEST)[0] for _ in range(TRIES)]
        finally:
            ended.set()
    assert said == [""] * TRIES
    assert [upload.exception() for upload in uploads] == [None] * UPLOADERS


def upload(lab: Laboratory, repository: str, blob: bytes, kind: str) -> dict[str, object]:
    """Upload a layer or a configuration, and return what a manifest says of it."""
    digest = f"sha256:{hashlib.sha256(blob).hexdigest()}"
    refused, where = ask(lab, "POST", f"/v2/{repository}/blobs/uploads/")
    assert not refused, refused
    refused, _ = ask(lab, "PUT", f"{where}&digest={digest}", blob, "application/octet-stream")
    assert not refused, refused
    return {"mediaType": kind, "digest": digest, "size": len(blob)}


def ask(lab: Laboratory, method: str, path: str, content: bytes = b"", kind: str = "") -> tuple[str, str]:
    """Return what the registry refused, "" if nothing, and the address that it answers with."""
    password = b64encode(f"{lab.username}:{lab.password}".encode()).decode()
    headers = {"Authorization": f"Basic {password}", **({"Content-Type": kind} if kind else {})}
    url = urljoin(f"http://{lab.registry}", path)
    request = urllib.request.Request(url, method=method, data=content, headers=headers)  # noqa: S310
    try:
        with urllib.request.urlopen(request, timeout=60) as reply:  # noqa: S310 - the lab's own registry
            return "", str(reply.headers.get("Location", ""))
    except urllib.error.HTTPError as error:
        return error.read().decode(), ""
