"""What a published image says of itself: its signature, its annotations, the digest of each platform."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path

import pytest

from lab import doors, registry
from lab.act import run_workflow
from lab.laboratory import Laboratory

DOORS = pytest.mark.parametrize("door", [doors.through_action, doors.through_workflow], ids=["action", "image"])
OCI = "org.opencontainers.image"


@pytest.fixture
def name(lab: Laboratory) -> str:
    """Return the name of a repository that nothing was pushed to yet, without its owner."""
    return lab.fresh_repository(f"{doors.OWNER}/robot").rpartition("/")[2]


@DOORS
@pytest.mark.parametrize("signed", [True, False])
def test_an_image_is_signed_before_its_tags_or_a_warning_says_why_not(
    lab: Laboratory, tmp_path: Path, name: str, door: Callable[..., Path], *, signed: bool
) -> None:
    caller = door(tmp_path / "caller", {"registry": lab.registry, "platforms": "linux/amd64"})
    environment = {**doors.builder(lab), "ACTIONS_ID_TOKEN_REQUEST_URL": "http://127.0.0.1:9/"}
    environment |= {} if signed else {"REPRO_LAB_ATTEST": "fail"}
    ran = run_workflow(lab, caller, "push", doors.payload(name), env=environment)
    assert ran.exit_code == 0, ran.log
    assert {"main", "latest"} < set(registry.tags(f"{doors.OWNER}/{name}"))
    assert ran.log.index("Main Sign the image") < ran.log.index("Main Move the tags")
    assert ("Main Sign how far it got" in ran.log) == signed
    assert ("the image is not signed (grant the calling job `attestations: write`" in ran.log) != signed
    assert ("It is not signed" in ran.summary) != signed
    subject = f"oci://{lab.registry}/{doors.OWNER}/{name}@{ran.output('digest')}"
    line = f"gh attestation verify \\\n  {subject} \\\n  --repo {doors.OWNER}/{name}\n"
    assert (line in ran.summary) == signed


@DOORS
def test_an_image_says_where_it_comes_from(
    lab: Laboratory, tmp_path: Path, name: str, door: Callable[..., Path]
) -> None:
    """On its index and on each platform's manifest, whose digests are put out; without the rights nothing is signed."""
    caller = door(tmp_path / "caller", {"registry": lab.registry})
    payload = doors.payload(name)
    payload["repository"] |= {"description": 'An arm, "soft"', "license": {"spdx_id": "BSD-3-Clause"}}
    ran = run_workflow(lab, caller, "push", payload, env=doors.builder(lab))
    assert ran.exit_code == 0, ran.log
    assert "Main Sign the image" not in ran.log
    assert "::warning::the image is not signed" not in ran.log
    assert "It is not signed" in ran.summary
    repository = f"{doors.OWNER}/{name}"
    index, digest = registry.manifest(f"{repository}:main")
    assert digest == ran.output("digest")
    images = {
        f"linux/{entry['platform']['architecture']}": entry["digest"]
        for entry in index["manifests"]
        if entry["platform"]["architecture"] != "unknown"
    }
    assert json.loads(ran.output("digests")) == images
    assert set(images) == {"linux/amd64", "linux/arm64"}
    manifests = [index, *(registry.manifest(f"{repository}@{image}")[0] for image in images.values())]
    for found in (manifest["annotations"] for manifest in manifests):
        assert found[f"{OCI}.title"] == name
        assert found[f"{OCI}.description"] == "An arm, soft"
        assert found[f"{OCI}.licenses"] == "BSD-3-Clause"
        assert found[f"{OCI}.source"] == f"https://github.com/{repository}"
        assert found[f"{OCI}.created"] == "2026-01-01T00:00:00Z"
        assert len(found[f"{OCI}.revision"]) == 40
