"""What can be known of a build before it begins: whether its base and its package sources answer."""

from __future__ import annotations

import json
import urllib.error
import urllib.request
from collections.abc import Sequence

from roslab.engine.docker import last_line, output
from roslab.engine.registry import is_attestation, platform_name
from roslab.values.dataclass import dataclass

SECONDS = 20.0
QUICK = 5.0
"""Seconds that a package source has for its first answer."""
GONE = ("not found", "manifest unknown", "does not exist", "denied", "name unknown")
"""Words of a registry that does not have an image, or no longer gives it to everybody."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Finding:
    """What is wrong, with what is done about it."""

    text: str
    certain: bool = True
    """``False`` where something did not answer just now."""


def base(reference: str, platforms: Sequence[str]) -> tuple[Finding, ...]:
    """Return what is wrong with a base, and what to do about it; nothing of one that the engine has."""
    if output(["docker", "image", "inspect", "--format", "{{.Id}}", reference]).returncode == 0:
        return ()
    answer = output(["docker", "buildx", "imagetools", "inspect", "--raw", reference], timeout=SECONDS)
    if answer.returncode:
        said = last_line(answer.stderr)
        if any(word in said.lower() for word in GONE):
            text = f"{reference} cannot be pulled any more ({said}): name another by `base` in roslab.yaml"
            return (Finding(text=text),)
        text = f"the registry of {reference} does not answer ({said}): the build asks it again"
        return (Finding(text=text, certain=False),)
    return lacking(reference, answer.stdout, platforms)


def lacking(reference: str, manifest: str, platforms: Sequence[str]) -> tuple[Finding, ...]:
    """Return which of the platforms an image is not there for, by its manifest or index."""
    try:
        entries = json.loads(manifest).get("manifests")
    except (ValueError, AttributeError):
        return ()
    if not entries:
        return ()  # one image, which does not say its platform here
    there = sorted({platform_name(each.get("platform", {})) for each in entries if not is_attestation(each)})
    return tuple(
        Finding(
            text=f"{reference} is not there for {each}, but for {', '.join(there)}: "
            "leave it out of `platforms` in roslab.yaml"
        )
        for each in platforms
        if each not in there and not any(other.startswith(f"{each}/") for other in there)
    )


def source(url: str, suite: str, otherwise: str) -> tuple[Finding, ...]:
    """Return that a package source does not answer, and what is then done, ``otherwise``."""
    address = f"{url.rstrip('/')}/dists/{suite}/Release"
    request = urllib.request.Request(address, method="HEAD", headers={"User-Agent": "roslab"})  # noqa: S310 - our own table's
    try:
        with urllib.request.urlopen(request, timeout=QUICK):  # noqa: S310
            return ()
    except urllib.error.HTTPError as error:
        with error:
            return (Finding(text=f"{url} has no {suite} (HTTP {error.code}): {otherwise}"),)
    except (OSError, ValueError) as error:
        said = getattr(error, "reason", None) or error
        text = f"{url} does not answer ({said}): the build asks it again; if it stays silent, {otherwise}"
        return (Finding(text=text, certain=False),)


def key(name: str, expires: str, today: str) -> tuple[Finding, ...]:
    """Return that a key which the Dockerfile brings along has expired; days are ``YYYY-MM-DD``."""
    if not expires or today < expires:
        return ()
    return (Finding(text=f"the key {name} of ROS's packages expired on {expires}: take a newer release of roslab"),)
