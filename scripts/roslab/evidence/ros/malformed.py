"""What is wrong with a package.xml, as it is told: it is not well-formed, or a line names several packages."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator

from roslab.evidence.facts import PackageManifest


def problems(manifests: Iterable[PackageManifest]) -> Iterator[tuple[str, str, int]]:
    """Yield what is wrong, with the file and its line."""
    manifests = tuple(manifests)
    yield from (_malformed(each) for each in manifests if each.malformed)
    yield from (_several(each, *each.together) for each in manifests if each.together)


def _malformed(manifest: PackageManifest) -> tuple[str, str, int]:
    """Return the parser's message with the line where it stopped, if it gives one."""
    match = re.match(r"line (\d+): (.+)", manifest.malformed or "")
    line, message = (int(match[1]), match[2]) if match else (manifest.line, manifest.malformed)
    return f"not well-formed: {message}", manifest.file, line


def _several(manifest: PackageManifest, tag: str, line: int) -> tuple[str, str, int]:
    return f"<{tag}> names several packages, and each needs one of its own", manifest.file, line
