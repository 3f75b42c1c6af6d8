"""What an image holds, as its own tools say; read in a container of it that has no network and is thrown away."""

from __future__ import annotations

import json
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

from roslab.engine.docker import last_line, output
from roslab.errors import BuildError, Problem
from roslab.plan.locked import Distribution, LockedSource, Package
from roslab.values.dataclass import dataclass
from roslab.values.name import canonicalize_name

SECONDS = 600.0
_SCRIPT = Path(__file__).with_name("inventory.sh")


@dataclass(frozen=True, kw_only=True, slots=True)
class Installed:
    """A package of Python as an image has it."""

    environment: str
    package: Distribution


@dataclass(frozen=True, kw_only=True, slots=True)
class Inventory:
    """What an image is made of."""

    reference: str
    layers: tuple[str, ...]
    """Digests of the layers' unpacked content, the base's first."""
    size: int
    """Bytes as the engine counts them."""
    variables: tuple[tuple[str, str], ...]
    apt: tuple[Package, ...]
    """Each with the step ``base`` if the base brought it, else with none."""
    python: tuple[Installed, ...]
    conda: tuple[str, ...]
    sources: tuple[LockedSource, ...]
    history: tuple[tuple[tuple[str, ...], tuple[str, ...]], ...]
    """What each call of apt was asked for, and the names that it installed."""


def read(reference: str, platform: str) -> Inventory:
    """Read what an image of the engine holds. Raises ``BuildError`` if there is none, or it has no shell."""
    about = inspect(reference)
    command = ["docker", "run", "--rm", "--interactive", "--user", "0", "--network", "none", "--platform", platform]
    script = _SCRIPT.read_text(encoding="utf-8")
    answer = output([*command, "--entrypoint", "/bin/sh", reference, "-c", script], timeout=SECONDS)
    if answer.returncode:
        message = f"what {reference} holds cannot be read: {last_line(answer.stderr)}"
        raise BuildError(Problem(message=message, hint="an image without a shell has no lock"))
    found = _lines(answer.stdout)
    base = {(name, version) for kind, name, version, *_ in found if kind == "base"}
    packages = sorted(tuple(fields[1:5]) for fields in found if fields[0] == "apt")
    return Inventory(
        reference=reference,
        layers=tuple(about.get("RootFS", {}).get("Layers") or ()),
        size=int(about.get("Size") or 0),
        variables=tuple(sorted(_pair(each) for each in about.get("Config", {}).get("Env") or ())),
        apt=tuple(
            Package(
                name=name,
                version=version,
                architecture=architecture,
                source=source,
                origin="",
                step="base" if (name, version) in base else "",
            )
            for name, version, architecture, source in packages
        ),
        python=tuple(_python(found)),
        conda=tuple(sorted({name for kind, name, *_ in found if kind == "conda"})),
        sources=tuple(
            sorted(
                {
                    LockedSource(name=name, url=url, commit=commit)
                    for kind, name, url, commit, *_ in found
                    if kind == "source"
                },
                key=lambda source: (source.name, source.url),
            )
        ),
        history=tuple(_history([name for kind, name, *_ in found if kind == "history"])),
    )


def inspect(reference: str) -> dict[str, Any]:
    """Return what the engine says of an image. Raises ``BuildError`` if it has none of that name."""
    answer = output(["docker", "image", "inspect", reference])
    try:
        (about,) = json.loads(answer.stdout)
    except ValueError:
        about = None
    if answer.returncode or not isinstance(about, dict):
        hint = "build it with `roslab build`, or pull it"
        raise BuildError(Problem(message=f"the engine has no image {reference}", hint=hint))
    return about


def _lines(text: str) -> list[tuple[str, ...]]:
    """Return the lines' fields, each line with as many as the longest has."""
    rows = [line.split("\t") for line in text.splitlines() if line]
    return [tuple((*row, "", "", "", "", "")[:6]) for row in rows]


def _python(found: Sequence[tuple[str, ...]]) -> Iterator[Installed]:
    seen = set()
    clones = [fields[1:5] for fields in found if fields[0] == "clone"]
    for kind, environment, name, version, installer, direct in found:
        key = (environment, canonicalize_name(name))
        if kind != "python" or not name or not version or installer == "conda" or key in seen:
            continue
        seen.add(key)  # the first on the path is the one that is imported
        url, hashes = _from(direct)
        if url.startswith("file:"):
            url = _cloned(url.removeprefix("file://"), clones)
            if not url:
                continue  # the repository's own, or a library of the image's
        package = Distribution(name=canonicalize_name(name), version=version, hashes=hashes, url=url)
        yield Installed(environment=environment, package=package)


def _cloned(folder: str, clones: Sequence[tuple[str, ...]]) -> str:
    """Return the URL of the clone that a folder belongs to, with its commit, ``""`` for none."""
    for project, url, commit, below in clones:
        if f"{folder}/".startswith(f"{project}/"):
            return f"git+{url}@{commit}" + (f"#subdirectory={below}" if below else "")
    return ""


def _from(text: str) -> tuple[str, tuple[str, ...]]:
    """Return the URL of a package that is from no index, and its hashes.

    https://packaging.python.org/en/latest/specifications/direct-url-data-structure/
    """
    try:
        data = json.loads(text) if text else {}
        url = str(data.get("url", ""))
        if version := data.get("vcs_info"):
            below = f"#subdirectory={data['subdirectory']}" if data.get("subdirectory") else ""
            return f"{version['vcs']}+{url}@{version['commit_id']}{below}", ()
        found = (data.get("archive_info") or {}).get("hashes") or {}
        return url, (f"sha256:{found['sha256']}",) if "sha256" in found else ()
    except (ValueError, KeyError, TypeError, AttributeError):
        return "", ()


def _history(lines: Sequence[str]) -> Iterator[tuple[tuple[str, ...], tuple[str, ...]]]:
    """Return the calls of apt: https://manpages.debian.org/apt.conf, ``Dir::Log::History``."""
    asked: tuple[str, ...] = ()
    for line in lines:
        key, _, rest = line.partition(": ")
        if key == "Commandline":
            words = rest.split()
            after = words[words.index("install") + 1 :] if "install" in words else []
            asked = tuple(word.partition("=")[0] for word in after if not word.startswith("-"))
        elif key == "Install":
            names = [entry.strip().partition(":")[0] for entry in rest.split("),")]
            yield asked, tuple(name for name in names if name)


def _pair(text: str) -> tuple[str, str]:
    name, _, value = text.partition("=")
    return name, value
