"""BuildKit's provenance becomes the policy that takes the same images and files again."""

from __future__ import annotations

import json

import pytest

from roslab.errors import BuildError
from roslab.lock.materials import _material, of_metadata, policy
from roslab.plan.locked import Material

SUM = "1" * 64


@pytest.mark.parametrize(
    ("uri", "source"),
    [
        ("pkg:docker/ubuntu@24.04?platform=linux%2Famd64", "docker-image://docker.io/library/ubuntu:24.04"),
        ("pkg:docker/osrf/ros@noetic?platform=linux%2Famd64", "docker-image://docker.io/osrf/ros:noetic"),
        ("pkg:docker/ghcr.io/a/b@v1", "docker-image://ghcr.io/a/b:v1"),
        ("pkg:docker/127.0.0.1:5000/a@v1", "docker-image://127.0.0.1:5000/a:v1"),
        ("https://example.org/a.tar.gz", "https://example.org/a.tar.gz"),
        ("pkg:docker/ubuntu@24.04?digest=sha256:1&platform=linux%2Famd64", None),
        ("https://github.com/a/b.git#main", None),
    ],
)
def test_a_material_as_the_policy_names_it(uri: str, source: str | None) -> None:
    digest = {"sha1": "2" * 40} if ".git" in uri else {"sha256": SUM}
    found = _material({"uri": uri, "digest": digest})
    assert (found.source if found else None) == source


def test_the_policy_names_every_image_by_its_digest_and_every_file_by_its_sum() -> None:
    image, file = "docker-image://docker.io/library/ubuntu:24.04", "https://example.org/a.tar.gz"
    digest = f"sha256:{SUM}"
    rules = json.loads(policy([Material(source=image, digest=digest), Material(source=file, digest=digest)]))["rules"]
    assert [rule["selector"]["identifier"] for rule in rules] == [image, file]
    assert rules[0]["updates"] == {"identifier": f"{image}@{digest}"}
    assert rules[1]["updates"] == {"identifier": file, "attrs": {"http.checksum": digest}}


def test_what_buildx_says_of_a_build_of_several_platforms_is_read() -> None:
    def taken(*names: str) -> dict[str, object]:
        return {"materials": [{"uri": f"pkg:docker/{name}", "digest": {"sha256": SUM}} for name in names]}

    said = {
        "buildx.build.provenance/linux/amd64": taken("ubuntu@24.04", "alpine@3"),
        "buildx.build.provenance/linux/arm64": taken("ubuntu@24.04"),
        "containerimage.digest": "sha256:1",
    }
    assert [each.source for each in of_metadata(json.dumps(said))] == [
        "docker-image://docker.io/library/alpine:3",
        "docker-image://docker.io/library/ubuntu:24.04",
    ]


@pytest.mark.parametrize("text", ["", "[]", "{}", "null", '{"buildx.build.provenance": {"buildDefinition": 1}}'])
def test_a_build_that_says_nothing_is_named(text: str) -> None:
    with pytest.raises(BuildError, match="does not say which images"):
        of_metadata(text)


def test_what_the_policy_took_again_is_known_by_its_digest() -> None:
    known = Material(source="docker-image://docker.io/library/ubuntu:24.04", digest=f"sha256:{SUM}")
    other = Material(source="docker-image://docker.io/library/alpine:3", digest="sha256:" + "2" * 64)
    uri = f"pkg:docker/ubuntu@24.04?digest=sha256:{SUM}&platform=linux%2Famd64"
    said = json.dumps({"buildx.build.provenance": {"materials": [{"uri": uri, "digest": {"sha256": SUM}}]}})
    assert of_metadata(said, [known, other]) == (known,)
    assert of_metadata(said) == ()
