"""A git server of repositories in a folder, HOST/OWNER/NAME: `python3 git_server.py FOLDER ADDRESS PORT`.

It serves what git itself serves, `git http-backend`, to whoever reaches the address, and lets nobody push.
"""

from __future__ import annotations

import os
import subprocess
import sys
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from urllib.parse import unquote, urlsplit

SETTINGS = {
    # Whoever starts the lab owns none of the folders perhaps
    "safe.directory": "*",
    # As code hosts do: a clone may ask for any commit, and for a part of the history
    "uploadpack.allowAnySHA1InWant": "true",
    "uploadpack.allowFilter": "true",
    "http.receivepack": "false",
}


def repository(folder: Path, host: str, owner: str, name: str) -> Path | None:
    """Return the git directory of a repository, bare or of a work tree; case and `.git` do not matter, as on hosts."""
    wanted = name.lower().removesuffix(".git")
    for place in folder.glob("*/*/*"):
        near, below, last = (word.lower() for word in place.parts[-3:])
        if (near, below, last.removesuffix(".git")) == (host.lower(), owner.lower(), wanted):
            found = next((each for each in (place / ".git", place) if (each / "HEAD").exists()), None)
            return found.resolve() if found else None
    return None


def environment(place: Path, rest: str, query: str) -> dict[str, str]:
    """Return what `git http-backend` reads for one request: https://git-scm.com/docs/git-http-backend."""
    given = {"GIT_CONFIG_COUNT": str(len(SETTINGS))}
    for number, (key, value) in enumerate(SETTINGS.items()):
        given |= {f"GIT_CONFIG_KEY_{number}": key, f"GIT_CONFIG_VALUE_{number}": value}
    project = {"GIT_PROJECT_ROOT": str(place), "PATH_INFO": rest, "QUERY_STRING": query, "GIT_HTTP_EXPORT_ALL": "1"}
    return {**os.environ, **given, **project}


class Handler(BaseHTTPRequestHandler):
    """Answers one request: /HOST/OWNER/NAME/…"""

    folder = Path()

    def do_GET(self) -> None:
        self._answer(b"")

    def do_POST(self) -> None:
        self._answer(self._chunks() if "chunked" in self.headers.get("Transfer-Encoding", "") else self._body())

    def _body(self) -> bytes:
        return self.rfile.read(int(self.headers.get("Content-Length") or 0))

    def _chunks(self) -> bytes:
        parts = []
        while size := int(self.rfile.readline().split(b";")[0], 16):
            parts.append(self.rfile.read(size))
            self.rfile.readline()
        self.rfile.readline()
        return b"".join(parts)

    def _answer(self, body: bytes) -> None:
        asked = urlsplit(self.path)
        host, owner, name, *rest = [*unquote(asked.path).lstrip("/").split("/"), "", "", ""]
        place = repository(self.folder, host, owner, name)
        if place is None:
            self.send_error(404, f"the lab was not given {host}/{owner}/{name}")
            return
        given = environment(place, "/" + "/".join(rest).rstrip("/"), asked.query)
        given |= {"REQUEST_METHOD": self.command, "CONTENT_TYPE": self.headers.get("Content-Type", "")}
        given |= {"HTTP_CONTENT_ENCODING": self.headers.get("Content-Encoding", ""), "CONTENT_LENGTH": str(len(body))}
        given |= {"GIT_PROTOCOL": self.headers.get("Git-Protocol", ""), "REMOTE_ADDR": self.client_address[0]}
        done = subprocess.run(["git", "http-backend"], input=body, env=given, stdout=subprocess.PIPE, check=False)
        head, _, content = done.stdout.partition(b"\r\n\r\n")
        fields = dict(line.split(": ", 1) for line in head.decode().splitlines() if ": " in line)
        self.send_response(int(fields.pop("Status", "200").split()[0]))
        for field, value in {**fields, "Content-Length": str(len(content))}.items():
            self.send_header(field, value)
        self.end_headers()
        self.wfile.write(content)


def main(folder: str, address: str, port: str) -> None:
    """Serve until the end."""
    Handler.folder = Path(folder)
    with ThreadingHTTPServer((address, int(port)), Handler) as server:
        server.serve_forever()


if __name__ == "__main__":
    main(*sys.argv[1:])
