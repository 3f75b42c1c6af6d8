"""Where an image's packages still come from: asked in a container of it that has the network."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from pathlib import Path

from roslab.engine.docker import last_line, output, say
from roslab.lock.inventory import Inventory
from roslab.values.dataclass import dataclass
from roslab.values.name import canonicalize_name

SECONDS = 3600.0
_SCRIPT = Path(__file__).with_name("online.sh")


@dataclass(frozen=True, kw_only=True, slots=True)
class Origins:
    """What the package sources said."""

    apt: Mapping[tuple[str, str], str]
    """``URL SUITE/COMPONENT`` by name and version."""
    hashes: Mapping[tuple[str, str], tuple[str, ...]]
    """By environment and name."""


def ask(
    image: Inventory,
    platform: str,
    *,
    pythons: Mapping[str, str],
    options: Sequence[str],
    seconds: float = SECONDS,
) -> Origins:
    """Ask apt's sources and pip's index for what the image has; what does not answer is left out.

    ``pythons`` names the interpreter of each environment, ``options`` are pip's. The private index of the secret
    ``pip_index`` is asked where the variable PIP_EXTRA_INDEX_URL of this process names it.
    """
    words: list[str] = []
    for environment, python in pythons.items():
        wanted = [
            f"{each.package.name}=={each.package.version}"
            for each in image.python
            if each.environment == environment and not each.package.url
        ]
        if wanted:
            words += [environment, python, "\n".join(options), "\n".join(wanted)]
    command = ["docker", "run", "--rm", "--user", "0", "--platform", platform, "--env", "PIP_EXTRA_INDEX_URL"]
    script = _SCRIPT.read_text(encoding="utf-8")
    answer = output(
        [*command, "--entrypoint", "/bin/sh", image.reference, "-c", script, "roslab", *words], timeout=seconds
    )
    if answer.returncode:
        say(f"roslab: where the packages come from is not known: {last_line(answer.stderr)}")
        return Origins(apt={}, hashes={})
    apt: dict[tuple[str, str], str] = {}
    hashes: dict[tuple[str, str], tuple[str, ...]] = {}
    for line in answer.stdout.splitlines():
        kind, *fields = line.split("\t")
        if kind == "origin" and len(fields) == 5:
            name, _, version, url, suite = fields
            apt[name, version] = f"{url} {suite}"
        elif kind == "report" and len(fields) == 2:
            hashes |= _reported(fields[0], fields[1])
        elif kind == "file" and len(fields) == 3:
            hashes[fields[0], canonicalize_name(fields[1])] = (f"sha256:{fields[2]}",)
    return Origins(apt=apt, hashes=hashes)


def _reported(environment: str, text: str) -> dict[tuple[str, str], tuple[str, ...]]:
    """Return the hashes of pip's report: https://pip.pypa.io/en/stable/reference/installation-report/."""
    found: dict[tuple[str, str], tuple[str, ...]] = {}
    for entry in json.loads(text).get("install", ()):
        digest = (entry.get("download_info", {}).get("archive_info", {}).get("hashes") or {}).get("sha256")
        if digest:
            found[environment, canonicalize_name(entry["metadata"]["name"])] = (f"sha256:{digest}",)
    return found
