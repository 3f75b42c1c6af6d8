"""What the build of an author's own Dockerfile took from elsewhere, and the policy by which BuildKit takes it again.

https://docs.docker.com/build/building/variables/#experimental_buildkit_source_policy
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Sequence
from urllib.parse import unquote

from roslab.engine.docker import Build, materials, materials_of
from roslab.errors import BuildError, Problem
from roslab.plan.locked import Material

DOCKER_HUB = "docker.io"


def of_build(job: Build) -> tuple[Material, ...]:
    """Return the images and files that a build took, by building again what the cache has. Raises ``FailedBuild``."""
    return _named(materials(job))


def of_metadata(text: str, known: Iterable[Material] = ()) -> tuple[Material, ...]:
    """Return the images and files that a build took, from the metadata that buildx wrote of it.

    ``known`` are those that its policy named: BuildKit tells of these by their digest alone. Raises ``BuildError``
    where nothing is said of them.
    """
    try:
        listed = _listed(text)
        digests = {f"sha256:{(each.get('digest') or {}).get('sha256')}" for each in listed}  # type: ignore[attr-defined]
        found = {each.source: each for each in (*(k for k in known if k.digest in digests), *_named(listed))}
        return tuple(found[source] for source in sorted(found))
    except (ValueError, AttributeError, TypeError):
        message = "the build does not say which images it took"
        hint = "docker/build-push-action puts it out as `metadata`, unless BUILDX_METADATA_PROVENANCE is disabled"
        raise BuildError(Problem(message=message, hint=hint)) from None


def _listed(text: str) -> list[dict[str, object]]:
    if not any(name.startswith("buildx.build.provenance") for name in json.loads(text)):
        raise ValueError
    return materials_of(text)


def _named(listed: Iterable[dict[str, object]]) -> tuple[Material, ...]:
    found = {material for each in listed if (material := _material(each))}
    return tuple(sorted(found, key=lambda material: material.source))


def _material(found: dict[str, object]) -> Material | None:
    """Return a material of BuildKit's provenance as its source policy names it; clones by git are named by no digest.

    https://github.com/moby/buildkit/blob/master/docs/attestations/slsa-definitions.md
    """
    uri, digests = str(found.get("uri", "")), found.get("digest")
    digest = digests.get("sha256", "") if isinstance(digests, dict) else ""
    if not digest:
        return None
    if uri.startswith(("http://", "https://")):
        return Material(source=uri, digest=f"sha256:{digest}")
    kind, _, rest = uri.partition("/")
    if kind != "pkg:docker":
        return None
    name, _, tag = unquote(rest.partition("?")[0]).rpartition("@")
    if not name or "digest=" in rest:  # named by its digest already
        return None
    host = name.partition("/")[0]
    if "/" not in name:
        name = f"{DOCKER_HUB}/library/{name}"
    elif not any(sign in host for sign in ".:") and host != "localhost":
        name = f"{DOCKER_HUB}/{name}"
    return Material(source=f"docker-image://{name}:{tag}", digest=f"sha256:{digest}")


def policy(found: Iterable[Material]) -> str:
    """Return BuildKit's source policy that takes these again, and nothing else in their place."""
    rules: Sequence[dict[str, object]] = [
        {
            "action": "CONVERT",
            "selector": {"identifier": each.source},
            "updates": (
                {"identifier": f"{each.source}@{each.digest}"}
                if each.source.startswith("docker-image:")
                else {"identifier": each.source, "attrs": {"http.checksum": each.digest}}
            ),
        }
        for each in found
    ]
    return json.dumps({"rules": rules}, indent=2) + "\n"
