"""What an index of Python packages still has: https://packaging.python.org/en/latest/specifications/simple-repository-api/."""

from __future__ import annotations

import base64
import json
import shutil
import subprocess
import sys
import urllib.error
import urllib.request
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from html.parser import HTMLParser
from typing import TYPE_CHECKING
from urllib.parse import unquote, urlsplit, urlunsplit

from roslab.plan.locked import Distribution, Missing

if TYPE_CHECKING:
    from roslab.values.version import Standard

DEFAULT = "from pip._internal.models.index import PyPI; print(PyPI.simple_url)"
"""Prints the index that pip asks where nothing else is said: pip's own value."""
ACCEPT = "application/vnd.pypi.simple.v1+json, text/html;q=0.5"
SECONDS = 30.0
LONGEST = 64 * 1024 * 1024
AT_ONCE = 8
File = tuple[str, str]
"""Name of a file and its SHA-256 sum, ``""`` where the index does not say it."""


def default() -> str:
    """Return the index that pip asks where nothing else is said, ``""`` if this machine has no pip to tell it."""
    for python in filter(None, dict.fromkeys((sys.executable, shutil.which("python3")))):
        ran = subprocess.run([python, "-I", "-c", DEFAULT], capture_output=True, text=True, check=False)
        if ran.returncode == 0:
            return ran.stdout.strip()
    return ""


class Silent(Exception):  # noqa: N818 - its callers say why it is no error
    """An index did not answer."""


def missing(packages: Sequence[Distribution], indexes: Sequence[str]) -> tuple[tuple[Missing, ...], str]:
    """Return the packages that no index has any more, and why an index was not asked, ``""`` if all were."""
    if not indexes:
        return (), "no pip on this machine tells which index to ask"
    wanted = list({(package.name, package.version): package for package in packages if package.hashes}.values())

    def look(package: Distribution) -> Missing | None:
        return _missing(package, [file for index in indexes for file in files(index, package.name)])

    with ThreadPoolExecutor(AT_ONCE) as pool:
        try:
            return tuple(each for each in pool.map(look, wanted) if each), ""
        except Silent as error:
            return (), str(error)


def _missing(package: Distribution, found: Sequence[File]) -> Missing | None:
    from roslab.values.version import Version  # noqa: PLC0415 - slow to import

    wanted = {each.removeprefix("sha256:") for each in package.hashes}
    if any(digest in wanted for _, digest in found):
        return None
    listed = {version: digest for name, digest in found if (version := _version(name)) is not None}
    own = Version(package.version)
    if own in listed and not listed[own]:
        return None  # this index tells no sums: pip will compare them
    newer, older = sorted(v for v in listed if v >= own), sorted(v for v in listed if v < own)
    nearest = str(newer[0]) if newer else str(older[-1]) if older else None
    if nearest == str(own):
        nearest += ", as another file"
    return Missing(kind="pip", name=package.name, wanted=package.version, nearest=nearest)


def _version(name: str) -> Standard | None:
    from packaging.utils import parse_sdist_filename, parse_wheel_filename  # noqa: PLC0415

    try:
        return parse_wheel_filename(name)[1] if name.endswith(".whl") else parse_sdist_filename(name)[1]
    except ValueError:
        return None


def files(index: str, name: str) -> list[File]:
    """Return the files that an index lists for a name, none where it does not know it. Raises ``Silent``."""
    parts = urlsplit(f"{index.rstrip('/')}/{name}/")
    host = parts.netloc.rpartition("@")[2]
    headers = {"Accept": ACCEPT, "User-Agent": "roslab"}
    if parts.username:
        secret = f"{unquote(parts.username)}:{unquote(parts.password or '')}"
        headers["Authorization"] = "Basic " + base64.b64encode(secret.encode()).decode()
    url = urlunsplit((parts.scheme, host, parts.path, "", ""))
    try:
        with urllib.request.urlopen(urllib.request.Request(url, headers=headers), timeout=SECONDS) as reply:  # noqa: S310
            kind, body = reply.headers.get_content_type(), reply.read(LONGEST)
    except urllib.error.HTTPError as error:
        with error:
            if error.code in (404, 410):
                return []
        raise Silent(f"the index {host} answers HTTP {error.code}") from None
    except (OSError, ValueError) as error:
        raise Silent(f"the index {host} does not answer: {getattr(error, 'reason', None) or error}") from None
    if kind.endswith("json"):
        return [(file["filename"], file.get("hashes", {}).get("sha256", "")) for file in json.loads(body)["files"]]
    page = _Links()
    page.feed(body.decode(errors="replace"))
    return page.found


class _Links(HTMLParser):
    def __init__(self) -> None:
        super().__init__()
        self.found: list[File] = []

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        href = dict(attrs).get("href") if tag == "a" else None
        if href:
            parts = urlsplit(href)
            name = unquote(parts.path.rpartition("/")[2])
            self.found.append((name, parts.fragment.partition("sha256=")[2].partition("&")[0]))
