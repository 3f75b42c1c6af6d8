"""A repair in a pull request: a suggestion where the diff has the line, else a comment, once, and never an error."""

from __future__ import annotations

import json
import threading
from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from typing import Any

import pytest

from roslab.errors import Problem
from roslab.github.event import Event
from roslab.github.suggestion import lines_of, suggest
from roslab.render.outcome import Repair
from roslab.repair.hunk import Hunk

EVENT = Event(
    name="pull_request", repository="o/r", ref="refs/pull/7/merge", sha="m", default_branch="main", proposed=True,
    head="o/r", pull=7, head_commit="c" * 40,
)  # fmt: skip
PATCH = (
    "@@ -1,2 +1,3 @@\n format: 3\n-apt: [git]\n+apt:\n+  - git\n@@ -20,1 +21,1 @@ x\n y\n\\ No newline at end of file"
)
REPAIR = Repair(file="roslab.yaml", text="apt:\n  - libglog-dev\n")
PROBLEM = Problem(message="The header glog/logging.h is missing")
HUNK = Hunk(file="roslab.yaml", start=3, end=3, new=("  - git", "  - libglog-dev"))


@dataclass
class Api:
    """A stand-in for GitHub's API that keeps what it is told."""

    address: str = ""
    refuse: int = 0
    told: list[tuple[str, Any]] = field(default_factory=list)

    @property
    def environment(self) -> dict[str, str]:
        return {"GITHUB_API_URL": self.address, "ROSLAB_GITHUB_TOKEN": "t"}


@pytest.fixture
def api() -> Iterator[Api]:
    known = Api()

    class Handler(BaseHTTPRequestHandler):
        def do_GET(self) -> None:
            path = self.path.partition("?")[0]
            files = [{"filename": "roslab.yaml", "patch": PATCH}]
            comments = [{"body": body["body"]} for where, body in known.told if where == path]
            self.answer(200, files if path.endswith("/files") else comments)

        def do_POST(self) -> None:
            body = json.loads(self.rfile.read(int(self.headers["Content-Length"])))
            if not known.refuse:
                known.told.append((self.path, body))
            self.answer(known.refuse or 201, {})

        def answer(self, code: int, value: Any) -> None:
            data = json.dumps(value).encode()
            self.send_response(code)
            self.send_header("Content-Length", str(len(data)))
            self.end_headers()
            self.wfile.write(data)

        def log_message(self, *_: object) -> None:
            """Say nothing."""

    with ThreadingHTTPServer(("127.0.0.1", 0), Handler) as server:
        threading.Thread(target=server.serve_forever, args=(0.05,), daemon=True).start()
        known.address = f"http://127.0.0.1:{server.server_port}"
        yield known
        server.shutdown()


def test_a_line_of_the_diff_gets_a_suggestion_once(api: Api) -> None:
    for _ in range(2):
        suggest(EVENT, [PROBLEM], [REPAIR], HUNK, api.environment)
    ((path, body),) = api.told
    assert path == "/repos/o/r/pulls/7/comments"
    assert (body["path"], body["line"], body["side"], body["commit_id"]) == ("roslab.yaml", 3, "RIGHT", "c" * 40)
    assert "start_line" not in body
    assert "```suggestion\n  - git\n  - libglog-dev\n```" in body["body"]


@pytest.mark.parametrize("hunk", [None, replace(HUNK, start=10, end=10), replace(HUNK, file="Dockerfile")])
def test_any_other_line_gets_a_comment(api: Api, hunk: Hunk | None) -> None:
    suggest(EVENT, [PROBLEM], [REPAIR], hunk, api.environment)
    ((path, body),) = api.told
    assert path == "/repos/o/r/issues/7/comments"
    assert "```yaml\napt:\n  - libglog-dev\n```" in body["body"]
    assert "The header glog/logging.h is missing" in body["body"].replace("\\", "")


@pytest.mark.parametrize(
    "event", [replace(EVENT, pull=None), replace(EVENT, head="stranger/r"), replace(EVENT, head=None)]
)
def test_only_the_repository_s_own_pull_requests_are_commented(api: Api, event: Event) -> None:
    suggest(event, [PROBLEM], [REPAIR], HUNK, api.environment)
    assert api.told == []


@pytest.mark.parametrize("code", [403, 404, 422, 500])
def test_a_refusal_is_told_and_fails_nothing(api: Api, code: int, capsys: pytest.CaptureFixture[str]) -> None:
    api.refuse = code
    suggest(EVENT, [PROBLEM], [REPAIR], HUNK, api.environment)
    assert "no comment in the pull request" in capsys.readouterr().err
    suggest(EVENT, [PROBLEM], [REPAIR], HUNK, {"GITHUB_API_URL": "http://127.0.0.1:1", "ROSLAB_GITHUB_TOKEN": "t"})


def test_without_a_token_nothing_is_asked(api: Api) -> None:
    suggest(EVENT, [PROBLEM], [REPAIR], HUNK, {"GITHUB_API_URL": api.address})
    assert api.told == []


def test_text_of_a_log_is_no_markup(api: Api) -> None:
    suggest(
        EVENT, [Problem(message="@all <img src=x> ```")], [replace(REPAIR, text="a: '````'\n")], None, api.environment
    )
    body = api.told[0][1]["body"]
    assert "<img" not in body
    assert "@all" not in body
    assert "`````yaml\n" in body


def test_the_lines_that_a_diff_shows() -> None:
    assert lines_of([{"filename": "roslab.yaml", "patch": PATCH}], "roslab.yaml") == {1, 2, 3, 21}
    assert lines_of([{"filename": "large.bin"}], "large.bin") == set()
