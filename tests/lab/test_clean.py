"""The cleaner through its workflow against a real registry: what it shows, what it removes, what stays pullable."""

from __future__ import annotations

import base64
import hashlib
import json
import urllib.error
import urllib.request
from collections.abc import Mapping
from pathlib import Path

import pytest

from lab import doors, registry
from lab.act import Result, run_workflow
from lab.laboratory import Laboratory

IMAGE = "application/vnd.oci.image.manifest.v1+json"
INDEX = "application/vnd.oci.image.index.v1+json"
CONFIG = "application/vnd.oci.image.config.v1+json"


@pytest.fixture
def name(lab: Laboratory) -> str:
    """Return the name of a repository that nothing was pushed to yet, without its owner."""
    return lab.fresh_repository(f"{doors.OWNER}/robot").rpartition("/")[2]


def send(lab: Laboratory, method: str, path: str, content: bytes = b"", kind: str = "application/octet-stream") -> str:
    """Ask the registry for a path of it and return where it sends to."""
    headers = {"Content-Type": kind}
    request = urllib.request.Request(f"http://{lab.registry}/v2/{path}", method=method, data=content, headers=headers)
    secret = base64.b64encode(f"{lab.username}:{lab.password}".encode()).decode()
    request.add_header("Authorization", f"Basic {secret}")
    with urllib.request.build_opener(urllib.request.ProxyHandler({})).open(request, timeout=30) as answer:
        return str(answer.headers["Location"]).partition("/v2/")[2]


def push(lab: Laboratory, repository: str, architecture: str, note: str) -> dict[str, object]:
    """Push the smallest image, without a tag, and return its entry in an index."""
    config = json.dumps({"architecture": architecture, "os": "linux", "config": {"Labels": {"note": note}}}).encode()
    digest = "sha256:" + hashlib.sha256(config).hexdigest()
    place = send(lab, "POST", f"{repository}/blobs/uploads/")
    send(lab, "PUT", f"{place}{'&' if '?' in place else '?'}digest={digest}", config)
    described = {"mediaType": CONFIG, "digest": digest, "size": len(config)}
    manifest = json.dumps({"schemaVersion": 2, "mediaType": IMAGE, "config": described, "layers": []}).encode()
    own = "sha256:" + hashlib.sha256(manifest).hexdigest()
    send(lab, "PUT", f"{repository}/manifests/{own}", manifest, IMAGE)
    platform = {"architecture": architecture, "os": "linux"}
    return {"mediaType": IMAGE, "digest": own, "size": len(manifest), "platform": platform}


def index(lab: Laboratory, repository: str, entries: list[dict[str, object]], *tags: str) -> str:
    content = json.dumps({"schemaVersion": 2, "mediaType": INDEX, "manifests": entries}).encode()
    for tag in tags:
        send(lab, "PUT", f"{repository}/manifests/{tag}", content, INDEX)
    return "sha256:" + hashlib.sha256(content).hexdigest()


def cleaned(
    lab: Laboratory,
    folder: Path,
    name: str,
    files: Mapping[str, str] | None = None,
    *,
    pull: bool = False,
    **inputs: bool | str,
) -> Result:
    """Run the cleaner; ``pull`` is a run that the closing of the pull request 7 starts."""
    settings = {"registry": lab.registry, "username": lab.username, **inputs}
    lines = "".join(f"      {key.replace('_', '-')}: {json.dumps(value)}\n" for key, value in settings.items())
    workflow = f"""
on:
  workflow_dispatch:
  pull_request: {{types: [closed]}}
jobs:
  image:
    uses: org/repro-action/.github/workflows/clean.yml@v1
    permissions: {{contents: read, packages: write, pull-requests: read}}
    with:
{lines}
    secrets:
      registry-token: ${{{{ secrets.REGISTRY_PASSWORD }}}}
"""
    caller = doors.write(folder, {**(files or {}), ".github/workflows/caller.yml": workflow})
    github = {"heads": {"main": "0" * 40}, "closed": {7: "fix/it"}}
    payload = doors.payload(name, head=f"{doors.OWNER}/{name}" if pull else None)
    payload |= {"action": "closed"} if pull else {}
    return run_workflow(lab, caller, "pull_request" if pull else "workflow_dispatch", payload, github=github)


def test_a_closed_branch_goes_and_what_it_shares_stays(lab: Laboratory, tmp_path: Path, name: str) -> None:
    repository = f"{doors.OWNER}/{name}"
    shared, own = push(lab, repository, "amd64", "shared"), push(lab, repository, "arm64", "closed")
    other = push(lab, repository, "arm64", "main")
    closed = index(lab, repository, [shared, own], "fix-it", "sha-0123456")
    main = index(lab, repository, [shared, other], "main", "latest", "paper")
    tags = registry.tags(repository)

    shown = cleaned(lab, tmp_path / "shown", name)
    assert shown.exit_code == 0, shown.log
    assert "2 versions would go, 1 stay" in shown.summary
    assert "is closed |" in shown.summary
    assert f"{closed} fix-it sha-0123456: the branch fix-it is closed" in shown.log
    assert "Nothing was removed" in shown.summary
    assert registry.tags(repository) == tags

    done = cleaned(lab, tmp_path / "done", name, dry_run=False)
    assert done.exit_code == 0, done.log
    assert done.output("found").split() == [closed, own["digest"]]
    assert registry.tags(repository) == ("latest", "main", "paper")
    assert registry.digest(f"{repository}:main") == main
    for gone in (closed, own["digest"]):
        with pytest.raises(urllib.error.HTTPError, match="404"):
            registry.manifest(f"{repository}@{gone}")
    for kept in (shared, other):
        registry.manifest(f"{repository}@{kept['digest']}")

    again = cleaned(lab, tmp_path / "again", name, dry_run=False)
    assert "Nothing has to go" in again.summary


def test_a_tag_that_is_kept_stays(lab: Laboratory, tmp_path: Path, name: str) -> None:
    repository = f"{doors.OWNER}/{name}"
    index(lab, repository, [push(lab, repository, "amd64", "closed")], "fix-it")
    done = cleaned(lab, tmp_path / "done", name, dry_run=False, keep="fix-*")
    assert done.exit_code == 0, done.log
    assert registry.tags(repository) == ("fix-it",)


def test_a_closed_pull_request_takes_its_image_along(lab: Laboratory, tmp_path: Path, name: str) -> None:
    """Its tags have the suffix that roslab.yaml says; a closed branch's are left to a run of the whole."""
    repository = f"{doors.OWNER}/{name}"
    own = push(lab, repository, "amd64", "pull")
    pull = index(lab, repository, [own], "pr-7-humble")
    index(lab, repository, [push(lab, repository, "amd64", "other")], "pr-7", "fix-it-humble")
    files = {"roslab.yaml": "format: 3\ntags: {suffix: -humble}\n"}
    done = cleaned(lab, tmp_path / "done", name, files, pull=True, dry_run=False, runners='{"tag": "ubuntu-24.04"}')
    assert done.exit_code == 0, done.log
    assert done.output("found").split() == [pull, own["digest"]]
    assert registry.tags(repository) == ("fix-it-humble", "pr-7")
