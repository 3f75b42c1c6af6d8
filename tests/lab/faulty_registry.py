"""A stand-in for a bad day of a registry: the lab's own behind a proxy that answers 503 where it is told to."""

from __future__ import annotations

import http.client
import threading
from collections.abc import Callable, Iterator
from contextlib import closing, contextmanager, suppress
from dataclasses import dataclass, field
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer

HOP = {"connection", "keep-alive", "transfer-encoding", "te", "trailer", "upgrade"}
Fault = Callable[[str, str], bool]
"""Given a request's method and path: whether it fails."""


@dataclass
class Faults:
    """Which requests fail, how often, and how many did."""

    matches: Fault
    times: int
    """How many requests fail before the registry recovers; a huge number is never."""
    seen: int = 0
    lock: threading.Lock = field(default_factory=threading.Lock)

    def strikes(self, method: str, path: str) -> bool:
        """Tell whether this request fails, and count it."""
        with self.lock:
            if self.seen < self.times and self.matches(method, path):
                self.seen += 1
                return True
        return False


@contextmanager
def faulty_registry(address: str, faults: Faults) -> Iterator[str]:  # noqa: C901 - one small server
    """Serve the registry at ``address`` with faults, and yield HOST:PORT of the proxy."""

    class Handler(BaseHTTPRequestHandler):
        protocol_version = "HTTP/1.1"
        # The engine tries TLS first, and falls back where the answer begins as HTTP does
        default_request_version = "HTTP/1.0"

        def _pass_on(self) -> None:
            body = self._body()
            if faults.strikes(self.command, self.path):
                self._answer(503, {}, b"")
                return
            with closing(http.client.HTTPConnection(address, timeout=600)) as upstream:
                headers = {name: value for name, value in self.headers.items() if name.lower() not in HOP}
                headers["Content-Length"] = str(len(body))
                upstream.request(self.command, self.path, body=body, headers=headers)
                reply = upstream.getresponse()
                self._answer(reply.status, dict(reply.getheaders()), reply.read())

        def _body(self) -> bytes:
            if self.headers.get("Transfer-Encoding", "").lower() != "chunked":
                return self.rfile.read(int(self.headers.get("Content-Length") or 0))
            parts = []
            while size := int(self.rfile.readline().split(b";")[0], 16):
                parts.append(self.rfile.read(size))
                self.rfile.readline()
            self.rfile.readline()
            return b"".join(parts)

        def _answer(self, status: int, headers: dict[str, str], body: bytes) -> None:
            self.send_response(status)
            length = headers.get("Content-Length") if self.command == "HEAD" else str(len(body))
            for name, value in headers.items():
                if name.lower() not in {*HOP, "content-length"}:
                    self.send_header(name, value)
            self.send_header("Content-Length", length or "0")
            with suppress(BrokenPipeError, ConnectionResetError):  # the client heard enough
                self.end_headers()
                if self.command != "HEAD":
                    self.wfile.write(body)

        do_GET = do_HEAD = do_POST = do_PUT = do_PATCH = do_DELETE = _pass_on  # noqa: N815 - http.server's names

        def log_message(self, *_: object) -> None:
            pass

    server = ThreadingHTTPServer(("127.0.0.1", 0), Handler)
    thread = threading.Thread(target=server.serve_forever, args=(0.05,))
    thread.start()
    try:
        yield f"127.0.0.1:{server.server_port}"
    finally:
        server.shutdown()
        server.server_close()
        thread.join()
