"""What GitHub says of a branch and of releases; its stand-in answers as the documentation does."""

from __future__ import annotations

import json
import threading
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import replace
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer

import pytest

from roslab.errors import BuildError
from roslab.github import api
from roslab.github.event import Event

COMMIT = "a" * 40
ANSWERS = {
    "/repos/lab/robot/git/ref/heads/fix/it": {"ref": "refs/heads/fix/it", "object": {"sha": COMMIT}},
    "/repos/lab/robot/git/matching-refs/tags/v1.2.": [{"ref": "refs/tags/v1.2.3"}, {"ref": "refs/tags/v1.2.10"}],
}


@contextmanager
def github(*, status: int | None = None) -> Iterator[tuple[dict[str, str], list[str]]]:
    """Serve the answers, or one status alone; yield the environment of a step, and the tokens that were shown."""
    shown: list[str] = []

    class Handler(BaseHTTPRequestHandler):
        def do_GET(self) -> None:
            shown.append(self.headers.get("Authorization", ""))
            found = ANSWERS.get(self.path)
            body = json.dumps(found or {}).encode()
            self.send_response(status or (200 if found else 404))
            self.send_header("Content-Length", str(len(body)))
            self.end_headers()
            self.wfile.write(body)

        def log_message(self, *_: object) -> None:
            pass

    server = ThreadingHTTPServer(("127.0.0.1", 0), Handler)
    thread = threading.Thread(target=server.serve_forever, args=(0.01,))
    thread.start()
    try:
        yield {"GITHUB_API_URL": f"http://127.0.0.1:{server.server_port}", "ROSLAB_GITHUB_TOKEN": "t"}, shown
    finally:
        server.shutdown()
        server.server_close()
        thread.join()


def event(ref: str) -> Event:
    return Event(name="push", repository="lab/robot", ref=ref, sha=COMMIT, default_branch="main")


def asker(environment: Mapping[str, str]) -> api.Ask:
    return api.asker(environment, pause=lambda _: None)


def test_where_a_branch_stands() -> None:
    with github() as (environment, shown):
        assert api.branch_head(event("refs/heads/fix/it"), asker(environment)) == COMMIT
        assert api.branch_head(event("refs/heads/gone"), asker(environment)) is None
        assert api.branch_head(event("refs/tags/v1.2.3"), asker(environment)) is None
        pull = replace(event("refs/pull/7/merge"), proposed=True, head_branch="fix/it")
        assert api.branch_head(pull, asker(environment)) == COMMIT
    assert shown == ["Bearer t", "Bearer t", "Bearer t"]


def test_which_releases_there_are() -> None:
    with github() as (environment, _):
        assert api.releases(event("refs/tags/v1.2.3"), asker(environment)) == ("v1.2.3", "v1.2.10")
        assert api.releases(event("refs/tags/v2.0.0"), asker(environment)) == ()
        assert api.releases(event("refs/tags/paper"), asker(environment)) == ()


@pytest.mark.parametrize(("status", "asked"), [(503, api.ATTEMPTS), (429, api.ATTEMPTS), (403, 1)])
def test_no_answer_moves_no_tag(status: int, asked: int) -> None:
    with github(status=status) as (environment, shown), pytest.raises(BuildError, match=f"HTTP {status}"):
        api.branch_head(event("refs/heads/main"), asker(environment))
    assert len(shown) == asked
