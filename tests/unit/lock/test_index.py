"""What an index of Python packages still has, asked over HTTP."""

from __future__ import annotations

import http.server
import json
import threading
from collections.abc import Iterator

import pytest

from roslab.lock.index import missing
from roslab.plan.locked import Distribution

SUM, OTHER = "a" * 64, "b" * 64
PAGES = {
    "/html/numpy/": ("text/html", f'<a href="../numpy-1.0-py3-none-any.whl#sha256={SUM}">x</a>'),
    "/html/gone/": ("text/html", f'<a href="gone-2.0.tar.gz#sha256={OTHER}">x</a><a href="gone-3.0.tar.gz">x</a>'),
    "/html/older/": ("text/html", '<a href="older-0.1.tar.gz">x</a><a href="older-0.9.tar.gz">x</a>'),
    "/html/other/": ("text/html", f'<a href="other-1.0.tar.gz#sha256={OTHER}">x</a>'),
    "/html/unsaid/": ("text/html", '<a href="unsaid-1.0.tar.gz">x</a>'),
    "/json/numpy/": (
        "application/vnd.pypi.simple.v1+json",
        json.dumps({"files": [{"filename": "numpy-1.0-py3-none-any.whl", "hashes": {"sha256": SUM}}]}),
    ),
}


@pytest.fixture
def address() -> Iterator[str]:
    class Handler(http.server.BaseHTTPRequestHandler):
        def do_GET(self) -> None:
            kind, text = PAGES.get(self.path, ("text/plain", ""))
            self.send_response(200 if text else 503 if self.path.startswith("/broken") else 404)
            self.send_header("Content-Type", kind)
            self.end_headers()
            self.wfile.write(text.encode())

        def log_message(self, *_: object) -> None:
            pass

    with http.server.ThreadingHTTPServer(("127.0.0.1", 0), Handler) as server:
        thread = threading.Thread(target=server.serve_forever, args=(0.05,))
        thread.start()
        yield f"http://127.0.0.1:{server.server_port}"
        server.shutdown()
        thread.join()


def package(name: str, digest: str = SUM) -> Distribution:
    return Distribution(name=name, version="1.0", hashes=(f"sha256:{digest}",) if digest else (), url="")


@pytest.mark.parametrize(
    ("name", "nearest"),
    [("gone", "2.0"), ("older", "0.9"), ("never", None), ("other", "1.0, as another file")],
)
def test_what_is_gone_is_told_with_the_nearest_that_is_left(address: str, name: str, nearest: str | None) -> None:
    (found,), silent = missing([package(name)], [f"{address}/html"])
    assert (found.name, found.wanted, found.nearest, silent) == (name, "1.0", nearest, "")


@pytest.mark.parametrize("kind", ["html", "json"])
def test_what_is_there_is_not_told(address: str, kind: str) -> None:
    assert missing([package("numpy")], [f"{address}/{kind}"]) == ((), "")


def test_it_may_be_on_another_index_or_have_no_sum(address: str) -> None:
    assert missing([package("numpy"), package("unsaid")], [f"{address}/json", f"{address}/html/"]) == ((), "")
    assert missing([package("never", "")], [f"{address}/html"]) == ((), "")


def test_an_index_that_does_not_answer_has_lost_nothing(address: str) -> None:
    found, silent = missing([package("numpy")], [f"{address}/broken"])
    assert found == ()
    assert "503" in silent
