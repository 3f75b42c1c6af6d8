"""The way to act's artifact server, which newer clients do not find by themselves: see [act] in facts.toml."""

from __future__ import annotations

import http.client
import json
import threading
from collections.abc import Callable, Iterator
from contextlib import closing, contextmanager, suppress
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from typing import Any
from urllib.parse import parse_qsl, quote, urlencode, urlsplit, urlunsplit

from . import facts


def understood(body: bytes) -> bytes:
    """Return a request without the fields that act's server would refuse; what is no JSON object stays as it is."""
    unknown = facts.texts("act", "unknown_artifact_fields")
    return _changed(body, lambda said: {key: value for key, value in said.items() if key not in unknown})


def escaped(body: bytes) -> bytes:
    """Return an answer with the query of its addresses fully escaped: a client cuts a value at a bare ``=``."""
    return _changed(body, lambda said: {key: _address(value) for key, value in said.items()})


def _address(value: object) -> object:
    if not isinstance(value, str) or not value.startswith("http://"):
        return value
    parts = urlsplit(value)
    return urlunsplit(parts._replace(query=urlencode(parse_qsl(parts.query), quote_via=quote)))


def _changed(body: bytes, change: Callable[[dict[str, Any]], dict[str, Any]]) -> bytes:
    try:
        said = json.loads(body)
    except ValueError:
        return body
    return json.dumps(change(said)).encode() if isinstance(said, dict) else body


@contextmanager
def artifact_door(server: str) -> Iterator[str]:
    """Pass the calls of the artifact service on to act's server at ``server`` (HOST:PORT) and yield the door's address.

    Files do not come through here: act's answers name its own address for them.
    """

    class Handler(BaseHTTPRequestHandler):
        def do_POST(self) -> None:
            body = understood(self.rfile.read(int(self.headers.get("Content-Length") or 0)))
            names = ("Authorization", "Content-Type", "Accept", "User-Agent")
            headers = {name: self.headers[name] for name in names if name in self.headers}
            with closing(http.client.HTTPConnection(server, timeout=60)) as upstream:
                upstream.request("POST", self.path, body=body, headers=headers)
                reply = upstream.getresponse()
                answer = escaped(reply.read())
            self.send_response(reply.status)
            self.send_header("Content-Type", reply.getheader("Content-Type") or "application/json")
            self.send_header("Content-Length", str(len(answer)))
            with suppress(BrokenPipeError, ConnectionResetError):
                self.end_headers()
                self.wfile.write(answer)

        def log_message(self, *_: object) -> None:
            """Say nothing: act's log is what a test reads."""

    door = ThreadingHTTPServer(("127.0.0.1", 0), Handler)
    thread = threading.Thread(target=door.serve_forever, args=(0.05,), daemon=True)
    thread.start()
    try:
        yield f"http://127.0.0.1:{door.server_port}/"
    finally:
        door.shutdown()
        door.server_close()
        thread.join()
