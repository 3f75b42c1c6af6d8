"""Bring ``roslab/knowledge/pins.csv`` up to date: the newest release of each part of the builder, and its digest.

A maintainer runs ``python3 scripts/pins.py`` and reads the difference; ``--check`` writes nothing, and ends with 1
where there is something newer. It asks GitHub for the releases, and by ``docker buildx`` the registry for the digests.
``--complete`` asks nobody, and ends with 1 where an image has no digest: a release must not have one of those.
"""

from __future__ import annotations

import argparse
import csv
import datetime as dt
import io
import json
import subprocess
import sys
import urllib.request
from collections.abc import Callable, Sequence
from pathlib import Path

FILE = Path(__file__).resolve().parent / "roslab" / "knowledge" / "pins.csv"
API = "https://api.github.com/repos/{}/releases/latest"
"""https://docs.github.com/en/rest/releases/releases#get-the-latest-release"""
Row = dict[str, str]


def renewed(rows: Sequence[Row], newest: Callable[[str], str], digest: Callable[[str], str], day: str) -> list[Row]:
    """Return the rows with their newest versions; a row of which nothing is new keeps its source and date.

    ``newest`` gives the git tag of a repository's newest release, ``digest`` that of an image with a tag.
    Raises ``ValueError`` for a release that is tagged otherwise than the row says.
    """
    found = []
    for row in rows:
        tag = newest(row["releases"])
        if not tag.startswith(row["release_prefix"]):
            raise ValueError(f"{row['releases']}: {row['release_prefix']}… was expected for a release, not {tag}")
        version = row["version_prefix"] + tag.removeprefix(row["release_prefix"])  # deploy/v10 there is qemu-v10 here
        known = {**row, "version": version, "digest": digest(f"{row['image']}:{version}") if row["image"] else ""}
        changed = known != row
        source = f"https://github.com/{row['releases']}/releases/tag/{tag}"
        found.append({**known, "source": source, "date": day} if changed else row)
    return found


def newest(repository: str) -> str:
    """Ask GitHub for a repository's newest release. Raises ``OSError`` or ``ValueError`` where it does not say."""
    headers = {"Accept": "application/vnd.github+json"}
    request = urllib.request.Request(API.format(repository), headers=headers)  # noqa: S310 - a constant address
    with urllib.request.urlopen(request, timeout=30) as reply:  # noqa: S310 - a constant address
        return str(json.load(reply)["tag_name"])


def digest(image: str) -> str:
    """Ask the registry for the digest of an image. Raises ``OSError`` or ``ValueError`` where it does not say."""
    command = ["docker", "buildx", "imagetools", "inspect", image, "--format", "{{json .Manifest}}"]
    try:
        answer = subprocess.run(command, capture_output=True, text=True, timeout=120, check=True)
    except subprocess.SubprocessError as error:
        raise OSError(f"{image}: {error}") from None
    return str(json.loads(answer.stdout)["digest"])


def written(rows: Sequence[Row]) -> str:
    """Return the rows as the file has them."""
    stream = io.StringIO()
    writer = csv.DictWriter(stream, fieldnames=list(rows[0]), lineterminator="\n")
    writer.writeheader()
    writer.writerows(rows)
    return stream.getvalue()


def loose(rows: Sequence[Row]) -> list[str]:
    """Return the names of the images without a digest, whose tag could be moved to another image."""
    return [row["name"] for row in rows if row["image"] and not row["digest"]]


def main(arguments: Sequence[str]) -> int:
    """Return the exit code: 0 done, 5 GitHub or the registry does not answer.

    It is 1 where something is newer (``--check``) or has no digest (``--complete``).
    """
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0] if __doc__ else "")
    parser.add_argument("--check", action="store_true", help="write nothing; end with 1 where something is newer")
    parser.add_argument("--complete", action="store_true", help="ask nobody; end with 1 where a digest is missing")
    options = parser.parse_args(arguments)
    before = FILE.read_text(encoding="utf-8")
    if options.complete:
        if names := loose(list(csv.DictReader(io.StringIO(before)))):
            print(f"error: no digest of {', '.join(names)}: run python3 scripts/pins.py, and commit", file=sys.stderr)
        return int(bool(names))
    try:
        day = dt.datetime.now(tz=dt.timezone.utc).date().isoformat()
        after = written(renewed(list(csv.DictReader(io.StringIO(before))), newest, digest, day))
    except (OSError, ValueError, KeyError) as error:
        print(f"error: {error}", file=sys.stderr)
        return 5
    if options.check:
        return int(after != before)
    FILE.write_text(after, encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
