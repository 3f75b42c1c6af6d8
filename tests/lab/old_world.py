"""Package sources of a distribution that has ended: a mirror that lacks it, its archive, a snapshot, expired keys."""

from __future__ import annotations

import hashlib
import http.server
import subprocess
import threading
import urllib.parse
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

LONG_AGO = "20180101T000000"
"""The time at which expired keys were made and used; they were good for a year."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Signer:
    """A key of its own, in a folder of its own."""

    home: Path
    ago: tuple[str, ...]

    @classmethod
    def make(cls, home: Path, *, expired: bool = False) -> Signer:
        """Make the key. ``expired`` makes one that was good for a year, long ago."""
        home.mkdir(mode=0o700)
        ago = ("--faked-system-time", LONG_AGO) if expired else ()
        made = cls(home=home, ago=ago)
        made._gpg("--passphrase", "", "--quick-gen-key", "lab <lab@example.org>", "rsa3072", "sign", "1y")
        return made

    def public(self, *, armour: bool) -> bytes:
        """Return the public key."""
        return self._gpg(*(["--armor"] if armour else []), "--export")

    def sign(self, text: str) -> bytes:
        """Return the text with its signature, as an InRelease file has it."""
        return self._gpg("--clearsign", data=text.encode())

    def _gpg(self, *arguments: str, data: bytes = b"") -> bytes:
        command = ["gpg", "--homedir", str(self.home), "--batch", "--quiet", "--pinentry-mode", "loopback", *self.ago]
        return subprocess.run([*command, *arguments], input=data, capture_output=True, check=True).stdout


def release(signer: Signer, suite: str, packages: Mapping[str, bytes], *, version: str = "1.0") -> dict[str, bytes]:
    """Return the files of a suite by their paths below the source's URL; packages are whole .deb files by name."""
    pool = {f"pool/{name}.deb": data for name, data in packages.items()}
    index = "\n".join(
        f"Package: {path[5:-4]}\nVersion: {version}\nArchitecture: all\nMaintainer: lab\nDescription: lab\n"
        f"Filename: {path}\nSize: {len(data)}\nSHA256: {hashlib.sha256(data).hexdigest()}\n"
        for path, data in pool.items()
    ).encode()
    listed = "main/binary-amd64/Packages"
    text = (
        f"Origin: lab\nSuite: {suite}\nCodename: {suite}\nArchitectures: amd64\nComponents: main\n"
        f"Date: Mon, 01 Jan 2018 00:00:00 UTC\nSHA256:\n {hashlib.sha256(index).hexdigest()} {len(index)} {listed}\n"
    )
    return {**pool, f"dists/{suite}/{listed}": index, f"dists/{suite}/InRelease": signer.sign(text)}


def deb(name: str, folder: Path, *, version: str = "1.0") -> bytes:
    """Return a package that installs one file, /usr/share/NAME, which holds its name and its version if it has one."""
    tree = folder / f"{name}-{version}"
    (tree / "DEBIAN").mkdir(parents=True)
    (tree / "usr/share").mkdir(parents=True)
    (tree / "usr/share" / name).write_text(name if version == "1.0" else f"{name} {version}")
    control = f"Package: {name}\nVersion: {version}\nArchitecture: all\nMaintainer: lab\nDescription: lab\n"
    (tree / "DEBIAN/control").write_text(control)
    built = folder / f"{name}-{version}.deb"
    subprocess.run(["dpkg-deb", "--root-owner-group", "--build", tree, built], check=True, capture_output=True)
    return built.read_bytes()


@contextmanager
def serving(files: Mapping[str, bytes]) -> Iterator[str]:
    """Answer as an HTTP proxy for whole URLs, 404 for every other; yield the proxy's address on this machine."""

    class Handler(http.server.BaseHTTPRequestHandler):
        def do_GET(self) -> None:
            data = files.get(urllib.parse.unquote(self.path))
            self.send_response(404 if data is None else 200)
            self.send_header("Content-Length", str(len(data or b"")))
            if data and data.startswith(b"{"):
                self.send_header("Content-Type", "application/vnd.pypi.simple.v1+json")
            self.end_headers()
            self.wfile.write(data or b"")

        def log_message(self, *_: object) -> None:
            """Keep the tests' output as it is."""

    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), Handler)
    threading.Thread(target=server.serve_forever, args=(0.05,), daemon=True).start()
    try:
        yield f"http://127.0.0.1:{server.server_address[1]}"
    finally:
        server.shutdown()
        server.server_close()
