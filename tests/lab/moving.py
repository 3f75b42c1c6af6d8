"""An apt repository and a package index of the lab's own that move on: new versions come, old ones may vanish."""

from __future__ import annotations

import hashlib
import subprocess
import sys
import threading
import zipfile
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from io import BytesIO
from pathlib import Path

WHEEL = "Wheel-Version: 1.0\nGenerator: lab\nRoot-Is-Purelib: true\nTag: py3-none-any\n"


@dataclass
class World:
    """What is served now: whole packages by name and version."""

    address: str
    folder: Path
    debs: dict[tuple[str, str], bytes] = field(default_factory=dict)
    wheels: dict[tuple[str, str], bytes] = field(default_factory=dict)
    asked: list[str] = field(default_factory=list)
    """Each path that was asked for."""

    def add_deb(self, name: str, version: str, depends: str = "") -> None:
        """Add a version of a package that installs one file, /usr/share/NAME, with its version."""
        tree = self.folder / f"{name}_{version}"
        (tree / "DEBIAN").mkdir(parents=True)
        (tree / "usr/share").mkdir(parents=True)
        (tree / "usr/share" / name).write_text(version)
        (tree / "DEBIAN/control").write_text(_control(name, version, depends))
        built = self.folder / f"{name}_{version}.deb"
        command = ["dpkg-deb", "--root-owner-group", "--build", str(tree), str(built)]
        subprocess.run(command, check=True, capture_output=True)
        self.debs[name, version] = built.read_bytes()

    def add_wheel(self, name: str, version: str, requires: str = "") -> None:
        """Add a version of a package with one module that knows its version."""
        data, module = BytesIO(), name.replace("-", "_")
        information = f"{module}-{version}.dist-info"
        metadata = f"Metadata-Version: 2.1\nName: {name}\nVersion: {version}\n"
        with zipfile.ZipFile(data, "w") as wheel:
            wheel.writestr(f"{module}.py", f"VERSION = {version!r}\n")
            wheel.writestr(f"{information}/METADATA", metadata + (f"Requires-Dist: {requires}\n" if requires else ""))
            wheel.writestr(f"{information}/WHEEL", WHEEL)
            wheel.writestr(f"{information}/RECORD", "")
        self.wheels[name, version] = data.getvalue()

    def answer(self, path: str) -> bytes | None:
        """Return what is served at a path, ``None`` for what is not there."""
        if path == "/apt/Packages":
            return "\n".join(_entry(*key, data, self.folder) for key, data in sorted(self.debs.items())).encode()
        if path.startswith("/apt/"):
            return next((d for (n, v), d in self.debs.items() if path == f"/apt/{n}_{v}.deb"), None)
        if path.startswith("/files/"):
            return next((d for key, d in self.wheels.items() if path == f"/files/{_file(*key)}"), None)
        if path.startswith("/simple/"):
            asked = path.split("/")[2]
            links = [
                f'<a href="/files/{_file(*key)}#sha256={hashlib.sha256(data).hexdigest()}">{_file(*key)}</a>'
                for key, data in self.wheels.items()
                if key[0] == asked
            ]
            return f"<!DOCTYPE html><html><body>{''.join(links)}</body></html>".encode() if links else None
        return None

    def add_real(self, *names: str) -> None:
        """Add the wheels of real packages as the machine's own index has them: a new environment upgrades its pip."""
        place = self.folder / "real"
        words = ["download", "--quiet", "--no-deps", "--only-binary=:all:", "--python-version", "3.11"]
        subprocess.run([sys.executable, "-m", "pip", *words, "--dest", str(place), *names], check=True)
        for file in place.iterdir():
            name, version, *_ = file.name.split("-")
            self.wheels[name.replace("_", "-"), version] = file.read_bytes()

    @property
    def sources(self) -> str:
        """Return apt's list of sources for a base that takes its packages from here."""
        return f"deb [trusted=yes] {self.address}/apt ./\n"

    @property
    def index(self) -> str:
        """URL of pip's index."""
        return f"{self.address}/simple"


@contextmanager
def moving_world(host: str, folder: Path) -> Iterator[World]:
    """Serve a world at an address that containers of the engine reach too."""
    world = World(address="", folder=folder)

    class Handler(BaseHTTPRequestHandler):
        def do_GET(self) -> None:
            path = self.path.replace("/./", "/")  # apt names a flat repository so
            world.asked.append(path)
            data = world.answer(path)
            self.send_response(404 if data is None else 200)
            self.send_header("Content-Type", "text/html" if self.path.startswith("/simple/") else "application/x")
            self.send_header("Content-Length", str(len(data or b"")))
            if path.startswith("/files/"):
                self.send_header("Cache-Control", "max-age=365000000, immutable, public")  # as PyPI's do
            self.end_headers()
            self.wfile.write(data or b"")

        def log_message(self, *_: object) -> None:
            """Keep the tests' output as it is."""

    with ThreadingHTTPServer((host, 0), Handler) as server:
        world.address = f"http://{host}:{server.server_port}"
        thread = threading.Thread(target=server.serve_forever, args=(0.05,))
        thread.start()
        try:
            yield world
        finally:
            server.shutdown()
            thread.join()


def _control(name: str, version: str, depends: str) -> str:
    text = f"Package: {name}\nVersion: {version}\nArchitecture: all\nMaintainer: lab\nDescription: lab\n"
    return text + (f"Depends: {depends}\n" if depends else "")


def _entry(name: str, version: str, data: bytes, folder: Path) -> str:
    control = (folder / f"{name}_{version}" / "DEBIAN/control").read_text()
    return f"{control}Filename: ./{name}_{version}.deb\nSize: {len(data)}\nSHA256: {hashlib.sha256(data).hexdigest()}\n"


def _file(name: str, version: str) -> str:
    return f"{name.replace('-', '_')}-{version}-py3-none-any.whl"
