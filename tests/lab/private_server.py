"""A server on this machine that asks for a password: an index of pip with one package, and a git repository."""

from __future__ import annotations

import os
import secrets
import subprocess
import threading
import zipfile
from base64 import b64encode
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from typing import Any
from urllib.parse import quote

USER = "robot"
PACKAGE = "roslab_private_probe"
"""Of the index: a module that prints where it is from."""
WHEEL = "Wheel-Version: 1.0\nGenerator: lab\nRoot-Is-Purelib: true\nTag: py3-none-any\n"
SISTER = {
    "CMakeLists.txt": "cmake_minimum_required(VERSION 3.10)\nproject(sister NONE)\n"
    "install(FILES told DESTINATION share)\n",
    "package.xml": "<package format='3'><name>sister</name><version>1.0.0</version><description>x</description>"
    "<maintainer email='a@example.org'>a</maintainer><license>MIT</license>"
    "<export><build_type>cmake</build_type></export></package>\n",
    "told": "the sister was cloned\n",
    "pyproject.toml": '[build-system]\nrequires = ["setuptools"]\nbuild-backend = "setuptools.build_meta"\n'
    '[project]\nname = "sister"\nversion = "1.0"\n[tool.setuptools]\npy-modules = ["sister"]\n',
    "sister.py": "print('the sister was cloned')\n",
}


@dataclass
class Server:
    """One that runs: what it was asked, and with which password."""

    address: str
    password: str
    version: str
    """Of the package: a new one in each run, as a secret is no part of what BuildKit's cache goes by."""
    refused: int = 0
    served: int = 0

    @property
    def index(self) -> str:
        """URL of the index, with user and password."""
        return f"http://{USER}:{quote(self.password, safe='')}@{self.address}/simple"

    @property
    def package(self) -> str:
        """The package of the index, as pip asks for it."""
        return f"{PACKAGE}=={self.version}"

    @property
    def netrc(self) -> str:
        """Text of a .netrc for it."""
        host = self.address.partition(":")[0]
        return f"machine {host}\n  login {USER}\n  password {self.password}"

    @property
    def repository(self) -> str:
        """Address of the git repository, without a password; its git tag is v1."""
        return f"http://{self.address}/git/sister.git"


@contextmanager
def private_server(place: Path, password: str) -> Iterator[Server]:
    """Serve an index and a git repository, whose files lie below ``place``, to who knows the password."""
    version = f"1.{secrets.randbelow(10**9)}"
    _index(place / "simple" / PACKAGE.replace("_", "-"), version)
    _repository(place)
    expected = "Basic " + b64encode(f"{USER}:{password}".encode()).decode()
    server = Server(address="", password=password, version=version)

    class Handler(SimpleHTTPRequestHandler):
        def __init__(self, *words: Any) -> None:
            super().__init__(*words, directory=str(place))

        def do_GET(self) -> None:
            if self.headers.get("Authorization") == expected:
                server.served += 1
                super().do_GET()
                return
            server.refused += 1
            self.send_response(401)
            self.send_header("WWW-Authenticate", 'Basic realm="private"')
            self.send_header("Content-Length", "0")
            self.end_headers()

        def log_message(self, *_: object) -> None:
            pass

    with ThreadingHTTPServer(("127.0.0.1", 0), Handler) as http:
        server.address = f"127.0.0.1:{http.server_port}"
        thread = threading.Thread(target=http.serve_forever, args=(0.05,))
        thread.start()
        try:
            yield server
        finally:
            http.shutdown()
            thread.join()


def _index(folder: Path, version: str) -> None:
    folder.mkdir(parents=True)
    name = f"{PACKAGE}-{version}-py3-none-any.whl"
    information = f"{PACKAGE}-{version}.dist-info"
    metadata = f"Metadata-Version: 2.1\nName: {PACKAGE}\nVersion: {version}\n"
    with zipfile.ZipFile(folder / name, "w") as wheel:
        wheel.writestr(f"{PACKAGE}.py", "print('from the private index')\n")
        wheel.writestr(f"{information}/METADATA", metadata)
        wheel.writestr(f"{information}/WHEEL", WHEEL)
        wheel.writestr(f"{information}/RECORD", "")
    (folder / "index.html").write_text(f'<!DOCTYPE html><html><body><a href="{name}">{name}</a></body></html>\n')


def _repository(place: Path) -> None:
    """Make a repository as git's plain http protocol reads it: files alone."""
    source, bare = place / "source", place / "git" / "sister.git"
    source.mkdir(parents=True)
    for name, text in SISTER.items():
        (source / name).write_text(text)
    when = {"GIT_AUTHOR_DATE": "2026-01-01T00:00:00Z", "GIT_COMMITTER_DATE": "2026-01-01T00:00:00Z"}
    who = ["-c", "user.name=a", "-c", "user.email=a@example.org", "-c", "commit.gpgsign=false"]
    for words in (
        ["init", "--quiet", "--initial-branch=main", str(source)],
        ["-C", str(source), "add", "--all"],
        ["-C", str(source), *who, "commit", "--quiet", "--message", "All"],
        ["-C", str(source), "tag", "v1"],
        ["clone", "--quiet", "--bare", str(source), str(bare)],
        ["-C", str(bare), "update-server-info"],
    ):
        subprocess.run(["git", *words], env={**os.environ, **when}, check=True, capture_output=True)
