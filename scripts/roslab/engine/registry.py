"""Images in a registry: their platforms, layers and tags; calls are repeated after transient faults."""

from __future__ import annotations

import hashlib
import json
import random
import re
import subprocess
import time
from collections.abc import Callable, Mapping, Sequence
from typing import Any

from roslab.engine.docker import last_line, output
from roslab.errors import BuildError, Problem
from roslab.values.dataclass import dataclass
from roslab.values.image import without_tag
from roslab.values.pattern import pattern

TRANSIENT = pattern(
    r"\b(429|50[0234])\b|too ?many ?requests|service unavailable|bad gateway|gateway time-?out|timed? ?out"
    r"|deadline exceeded|connection (reset|refused|closed)|broken pipe|\bEOF\b|TLS handshake"
    r"|temporary failure|try again",
    re.IGNORECASE,
)
"""Messages of transient faults, from a registry or the network."""
ATTEMPTS = 5
PAUSE = 1.0
"""Seconds before the second attempt; doubled each time and jittered, so that many jobs do not come back at once."""
ATTESTATION = "vnd.docker.reference.type"
"""Annotation of an attestation in an index.
https://docs.docker.com/build/metadata/attestations/attestation-storage/"""


@dataclass(frozen=True, kw_only=True, slots=True)
class Layer:
    """One compressed layer."""

    digest: str
    size: int
    """Compressed bytes, as they are transferred."""
    created_by: str = ""
    """The instruction that made it, from the image's history."""


@dataclass(frozen=True, kw_only=True, slots=True)
class PlatformImage:
    """The image of one platform."""

    platform: str
    digest: str
    """Of its manifest."""
    layers: tuple[Layer, ...]


def with_retries(
    call: Callable[[], subprocess.CompletedProcess[str]],
    *,
    attempts: int = ATTEMPTS,
    pause: Callable[[float], None] = time.sleep,
) -> subprocess.CompletedProcess[str]:
    """Run a command, again after transient faults; return the last answer."""
    for attempt in range(1, attempts + 1):
        answer = call()
        if answer.returncode == 0 or attempt == attempts or not is_transient(answer):
            break
        pause(PAUSE * 2 ** (attempt - 1) * random.uniform(0.7, 1.3))  # noqa: S311 - a jitter keeps no secret
    return answer


def is_transient(answer: subprocess.CompletedProcess[str]) -> bool:
    """Tell whether a failed command may succeed a moment later."""
    return answer.returncode == 124 or bool(TRANSIENT.search(answer.stderr))


def platforms(image: str, digest: str, *, platform: str | None = None) -> tuple[PlatformImage, ...]:
    """Return the images that an index or a manifest holds, attestations left out, in the index's order.

    ``platform`` names the platform of a single manifest, which does not say it itself.
    Raises ``BuildError`` if the registry does not return them.
    """
    found = _inspect(f"{image}@{digest}")
    if "manifests" not in found:
        return (_image(digest, platform or "", found, _histories(image, digest, platform or "")),)
    children = [
        (entry["digest"], platform_name(entry.get("platform", {})))
        for entry in found["manifests"]
        if not is_attestation(entry)
    ]
    histories = _histories(image, digest, children[0][1] if len(children) == 1 else "")
    return tuple(_image(child, name, _inspect(f"{image}@{child}"), histories) for child, name in children)


def is_attestation(descriptor: dict[str, Any]) -> bool:
    """Tell whether an entry of an index is an attestation, not an image."""
    os = descriptor.get("platform", {}).get("os")
    return ATTESTATION in descriptor.get("annotations", {}) or os == "unknown"


def platform_name(platform: dict[str, Any]) -> str:
    """Return ``linux/arm/v7`` for a descriptor's platform; arm64's only variant is left out, as docker does."""
    parts = [platform.get("os", ""), platform.get("architecture", ""), platform.get("variant", "")]
    if parts[1:] == ["arm64", "v8"]:
        parts.pop()
    return "/".join(filter(None, parts))


def _image(
    digest: str, platform: str, manifest: Mapping[str, Any], histories: Mapping[str, list[str]]
) -> PlatformImage:
    layers = [(entry["digest"], int(entry["size"])) for entry in manifest.get("layers", [])]
    history = histories.get(platform, [])
    # If the history has another length, the layers have no names, but their sizes are right
    names = history if len(history) == len(layers) else [""] * len(layers)
    return PlatformImage(
        platform=platform,
        digest=digest,
        layers=tuple(Layer(digest=d, size=s, created_by=n) for (d, s), n in zip(layers, names, strict=True)),
    )


def _histories(image: str, digest: str, platform: str) -> dict[str, list[str]]:
    """Return the instructions that made the layers, by platform; instructions without a layer are left out.

    ``platform`` is that of a single image, whose configuration may spell it differently from its index.
    """
    try:
        found = configurations(image, digest)
    except BuildError:
        return {}
    if platform and len(found) == 1:
        found = {platform: next(iter(found.values()))}
    return {
        name: [str(e.get("created_by", "")) for e in entry.get("history", []) if not e.get("empty_layer")]
        for name, entry in found.items()
    }


def configurations(image: str, digest: str) -> dict[str, dict[str, Any]]:
    """Return the configuration of each image that an index or a manifest holds, by its platform.

    https://github.com/opencontainers/image-spec/blob/main/config.md. Raises ``BuildError`` where the registry does not
    give them.
    """
    command = ["docker", "buildx", "imagetools", "inspect", f"{image}@{digest}", "--format", "{{json .Image}}"]
    answer = with_retries(lambda: output(command))
    try:
        data: Any = json.loads(answer.stdout) if answer.returncode == 0 else None
    except ValueError:
        data = None
    if not isinstance(data, dict):
        said = last_line(answer.stderr)
        raise BuildError(Problem(message=f"the registry does not give the configuration of {image}@{digest}: {said}"))
    # buildx returns an object by platform for an index, and the bare configuration for a single image
    entries = [data] if "architecture" in data else [entry for entry in data.values() if isinstance(entry, dict)]
    return {platform_name(entry): entry for entry in entries}


def base_layers(reference: str, platform: str) -> frozenset[str]:
    """Return the digests of a base image's layers, none if its registry does not return them."""
    return frozenset(entry["digest"] for entry in _base(reference, platform))


def base_size(reference: str, platform: str) -> int:
    """Return the compressed bytes of a base image's layers, 0 if its registry does not return them."""
    return sum(int(entry["size"]) for entry in _base(reference, platform))


def _base(reference: str, platform: str) -> list[dict[str, Any]]:
    try:
        found = _inspect(reference, attempts=1)
        if "manifests" in found:
            fitting = [e for e in found["manifests"] if platform_name(e.get("platform", {})) == platform]
            found = _inspect(f"{without_tag(reference)}@{fitting[0]['digest']}", attempts=1) if fitting else {}
    except BuildError:
        return []
    layers: list[dict[str, Any]] = found.get("layers", [])
    return layers


def digest_of(reference: str, *, attempts: int = ATTEMPTS) -> str:
    """Return the digest that a tag names. Raises ``BuildError`` if the registry does not say."""
    command = ["docker", "buildx", "imagetools", "inspect", "--format", "{{json .Manifest}}", reference]
    answer = with_retries(lambda: output(command), attempts=attempts)
    if answer.returncode:
        raise BuildError(Problem(message=f"the registry does not give {reference}: {last_line(answer.stderr)}"))
    try:
        return str(json.loads(answer.stdout)["digest"])
    except (ValueError, KeyError, TypeError):
        raise BuildError(Problem(message=f"the registry does not say the digest of {reference}")) from None


def _inspect(reference: str, *, attempts: int = ATTEMPTS) -> dict[str, Any]:
    command = ["docker", "buildx", "imagetools", "inspect", "--raw", reference]
    answer = with_retries(lambda: output(command), attempts=attempts)
    if answer.returncode:
        raise BuildError(Problem(message=f"the registry does not give {reference}: {last_line(answer.stderr)}"))
    try:
        data = json.loads(answer.stdout)
    except ValueError:
        data = None
    if not isinstance(data, dict):
        raise BuildError(Problem(message=f"the registry gives no manifest for {reference}"))
    return data


def pull(reference: str, platform: str) -> None:
    """Pull one platform's image into the engine. Raises ``BuildError`` if that fails."""
    command = ["docker", "pull", "--quiet", "--platform", platform, reference]
    answer = with_retries(lambda: output(command, timeout=3600.0))
    if answer.returncode:
        raise BuildError(Problem(message=f"cannot pull {reference} for {platform}: {last_line(answer.stderr)}"))


def annotations_of(reference: str) -> dict[str, str]:
    """Return the annotations of a manifest or index. Raises ``BuildError`` if the registry does not return it."""
    found = _inspect(reference).get("annotations")
    return {str(name): str(value) for name, value in found.items()} if isinstance(found, dict) else {}


def held(image: str, digest: str) -> frozenset[str]:
    """Return a digest with those that its index names. Raises ``BuildError`` if the registry does not return it."""
    entries = _inspect(f"{image}@{digest}").get("manifests") or ()
    return frozenset({digest, *(str(entry["digest"]) for entry in entries)})


def create_index(image: str, sources: Sequence[str], tag: str, annotated: Mapping[str, str]) -> str:
    """Create an index of the given images under a tag and return its digest.

    ``sources`` are digests of indexes or manifests of ``image``; ``tag`` is a complete reference; ``annotated`` are the
    index's annotations. The digest is that of the index written here, not of what the tag names a moment later: another
    run may write the same tag. Raises ``BuildError`` if the registry refuses, with its message.
    """
    flags = [word for name, value in annotated.items() for word in ("--annotation", f"index:{name}={value}")]
    words = [*flags, *(f"{image}@{source}" for source in sources)]
    command = ["docker", "buildx", "imagetools", "create", "--dry-run", "--tag", tag, *words]
    answer = with_retries(lambda: output(command, timeout=600.0))
    if answer.returncode:
        raise BuildError(Problem(message=f"no index can be made of {', '.join(sources)}: {last_line(answer.stderr)}"))
    digest = "sha256:" + hashlib.sha256(answer.stdout.removesuffix("\n").encode()).hexdigest()
    _create([tag], words)
    _inspect(f"{image}@{digest}")
    return digest


def put_tags(image: str, digest: str, tags: Sequence[str]) -> None:
    """Put tags, complete references, on an existing index. Raises ``BuildError`` if the registry refuses."""
    if tags:
        _create(tags, [f"{image}@{digest}"])


def _create(tags: Sequence[str], words: Sequence[str]) -> None:
    flags = [word for tag in tags for word in ("--tag", tag)]
    command = ["docker", "buildx", "imagetools", "create", *flags, *words]
    answer = with_retries(lambda: output(command, timeout=600.0))
    if answer.returncode:
        names = ", ".join(tag.rpartition(":")[2] for tag in tags)
        raise BuildError(Problem(message=f"the tags {names} were not made: {last_line(answer.stderr)}"))
