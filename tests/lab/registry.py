"""Two registries on the loopback: a protected one that plays ghcr.io, an open one that mirrors docker.io."""

from __future__ import annotations

import base64
import json
import shutil
import sys
import urllib.error
import urllib.request
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from email.message import Message
from pathlib import Path
from typing import Any

from . import facts, packages, processes
from .command import LabError, run
from .home import folder, lock

PROTECTED = "registry"
MIRROR = "mirror"
MANIFESTS = (
    "application/vnd.oci.image.index.v1+json",
    "application/vnd.oci.image.manifest.v1+json",
    "application/vnd.docker.distribution.manifest.list.v2+json",
    "application/vnd.docker.distribution.manifest.v2+json",
)


def address(name: str) -> str:
    """Return `127.0.0.1:PORT` of one of the two registries."""
    return f"127.0.0.1:{facts.number('registry', 'port' if name == PROTECTED else 'mirror_port')}"


def up(name: str) -> str:
    """Make sure that one registry answers; the protected one starts with an empty store, the mirror keeps its own."""
    if processes.running(name) and answers(name):
        return f"was there: {address(name)}"
    packages.install(facts.texts("registry", "packages"))
    if answers(name):
        raise LabError(f"something that the lab did not start listens on {address(name)}; end it, or change facts.toml")
    if name == PROTECTED:
        shutil.rmtree(folder("registries", name))
    configuration = folder("registries") / f"{name}.json"
    # The registry reads YAML, of which JSON is a part.
    configuration.write_text(json.dumps(_configuration(name), indent=2))
    program = shutil.which("docker-registry") or "/usr/bin/docker-registry"
    processes.start(name, [program, "serve", configuration], ready=lambda: answers(name))
    return f"started: {address(name)}"


def down(name: str) -> bool:
    """End one registry if the lab started it."""
    return processes.stop(name)


def credentials() -> tuple[str, str]:
    """Return the user name and the password of the protected registry."""
    return facts.text("registry", "username"), facts.text("registry", "password")


@contextmanager
def account(username: str, password: str) -> Iterator[None]:
    """Let one more user in, for a while: the registry reads its passwords again whenever their file changes."""
    passwords = folder("registries") / "htpasswd"
    line = _entry(username, password)
    with lock(sys.stderr):
        _replace(passwords, [*passwords.read_text().split(), line])
    try:
        yield
    finally:
        with lock(sys.stderr):
            _replace(passwords, [known for known in passwords.read_text().split() if known != line])


def _entry(username: str, password: str) -> str:
    """Return the line of a password file, as cheap to check as bcrypt can be: the registry does so at each request."""
    return run(["htpasswd", "-Bbn", "-C", "4", username, password]).strip()


def _replace(file: Path, lines: Sequence[str]) -> None:
    """Write a file at once: the registry may read it at any moment."""
    part = file.with_suffix(".part")
    part.write_text("\n".join(lines) + "\n")
    part.rename(file)


def answers(name: str) -> bool:
    """Tell whether a registry answers at the address; one that asks for a password answers too."""
    try:
        _ask(name, "/v2/", login=False)
    except urllib.error.HTTPError as error:
        return error.code == 401
    except OSError:
        return False
    return True


def tags(repository: str, *, name: str = PROTECTED) -> tuple[str, ...]:
    """Return the tags of a repository, none when nothing was ever pushed there."""
    try:
        listed = json.loads(_ask(name, f"/v2/{repository}/tags/list")[0])["tags"]
    except urllib.error.HTTPError as error:
        if error.code == 404:
            return ()
        raise
    return tuple(sorted(listed or ()))


def repositories(*, name: str = PROTECTED) -> tuple[str, ...]:
    """Return the names of all repositories in a registry."""
    return tuple(json.loads(_ask(name, "/v2/_catalog?n=1000")[0])["repositories"])


def manifest(reference: str, *, name: str = PROTECTED) -> tuple[dict[str, Any], str]:
    """Return the manifest or index behind `repository:tag` or `repository@digest`, and its digest.

    Raises urllib.error.HTTPError with code 404 when there is none.
    """
    content, headers = _ask(name, _manifest_path(reference))
    return json.loads(content), str(headers["Docker-Content-Digest"])


def digest(reference: str, *, name: str = PROTECTED) -> str:
    """Return the digest behind `repository:tag`, "" when there is none."""
    try:
        return str(_ask(name, _manifest_path(reference), method="HEAD")[1]["Docker-Content-Digest"])
    except urllib.error.HTTPError as error:
        if error.code == 404:
            return ""
        raise


def alias(reference: str, tag: str, *, name: str = PROTECTED) -> None:
    """Give what `repository:tag` names another tag in the same repository, without moving any layer."""
    content, headers = _ask(name, _manifest_path(reference))
    path = _manifest_path(f"{_split(reference)[0]}:{tag}")
    _ask(name, path, method="PUT", content=content, kind=str(headers["Content-Type"]))


def _split(reference: str) -> tuple[str, str]:
    separator = "@" if "@" in reference else ":"
    repository, _, version = reference.partition(separator)
    return repository, version


def _manifest_path(reference: str) -> str:
    return "/v2/{}/manifests/{}".format(*_split(reference))


def _ask(
    name: str, path: str, *, method: str = "GET", login: bool = True, content: bytes | None = None, kind: str = ""
) -> tuple[bytes, Message]:
    request = urllib.request.Request(f"http://{address(name)}{path}", method=method, data=content)
    request.add_header("Accept", ", ".join(MANIFESTS))
    if kind:
        request.add_header("Content-Type", kind)
    if login and name == PROTECTED:
        request.add_header("Authorization", "Basic " + base64.b64encode(":".join(credentials()).encode()).decode())
    # A proxy of the machine must not be asked for the loopback.
    with urllib.request.build_opener(urllib.request.ProxyHandler({})).open(request, timeout=5) as answer:
        said: bytes = answer.read()
        return said, answer.headers


def _configuration(name: str) -> dict[str, object]:
    configuration: dict[str, object] = {
        "version": "0.1",
        "log": {"level": "warn", "accesslog": {"disabled": True}},
        "storage": {
            "filesystem": {"rootdirectory": str(folder("registries", name))},
            "delete": {"enabled": True},
            # Version 2.8 does not write at once the file that links a layer to a repository: without this a manifest is
            # refused whose layer something else uploads at that moment, as an image's export and its cache's do
            "cache": {"blobdescriptor": "inmemory"},
        },
        "http": {"addr": address(name)},
    }
    if name == PROTECTED:
        username, password = credentials()
        passwords = folder("registries") / "htpasswd"
        passwords.write_text(_entry(username, password) + "\n")
        configuration["auth"] = {"htpasswd": {"realm": "lab", "path": str(passwords)}}
    return configuration
