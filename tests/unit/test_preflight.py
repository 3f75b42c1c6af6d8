"""What is told of a build before it begins."""

from __future__ import annotations

import http.server
import json
import threading
from collections.abc import Iterator

import pytest

from roslab.engine.preflight import key, lacking, source

INDEX = json.dumps(
    {
        "manifests": [
            {"platform": {"os": "linux", "architecture": "amd64"}},
            {"platform": {"os": "linux", "architecture": "arm", "variant": "v7"}},
            {
                "platform": {"os": "unknown", "architecture": "unknown"},
                "annotations": {"vnd.docker.reference.type": "attestation-manifest"},
            },
        ]
    }
)


def test_a_platform_that_the_base_lacks_is_named_with_those_it_has() -> None:
    (told,) = lacking("ros:kinetic", INDEX, ("linux/amd64", "linux/arm64", "linux/arm"))
    assert told.text.startswith("ros:kinetic is not there for linux/arm64, but for linux/amd64, linux/arm/v7:")
    assert "`platforms`" in told.text


@pytest.mark.parametrize("manifest", ["", "[]", json.dumps({"layers": []})])
def test_what_says_no_platform_is_believed(manifest: str) -> None:
    assert lacking("ros:kinetic", manifest, ("linux/arm64",)) == ()


@pytest.fixture
def address() -> Iterator[str]:
    class Handler(http.server.BaseHTTPRequestHandler):
        def do_HEAD(self) -> None:
            self.send_response(200 if self.path == "/ubuntu/dists/focal/Release" else 404)
            self.end_headers()

        def log_message(self, *_: object) -> None:
            pass

    with http.server.ThreadingHTTPServer(("127.0.0.1", 0), Handler) as server:
        thread = threading.Thread(target=server.serve_forever, args=(0.05,))
        thread.start()
        yield f"http://127.0.0.1:{server.server_port}/ubuntu"
        server.shutdown()
        thread.join()


def test_a_package_source_that_lacks_a_release_is_told_with_what_is_done(address: str) -> None:
    assert source(address, "focal", "it is left out") == ()
    (told,) = source(f"{address}/", "xenial", "it is left out")
    assert "has no xenial (HTTP 404): it is left out" in told.text


def test_one_that_is_silent_is_asked_again_by_the_build() -> None:
    (told,) = source("http://127.0.0.1:9/ubuntu", "focal", "it is left out")
    assert "does not answer" in told.text
    assert not told.certain
    assert told.text.endswith("the build asks it again; if it stays silent, it is left out")


def test_a_key_that_expired_is_told() -> None:
    assert key("ros", "2030-06-01", "2030-05-31") == key("ros", "", "2031-01-01") == ()
    (told,) = key("ros", "2030-06-01", "2030-06-01")
    assert "expired on 2030-06-01" in told.text
