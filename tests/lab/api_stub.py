"""A stand-in for GitHub's API on the loopback: what docker/metadata-action and the step that moves tags ask for."""

from __future__ import annotations

import json
import re
import threading
from base64 import b64decode, b64encode
from collections.abc import Iterator
from contextlib import contextmanager
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from typing import Any
from urllib.parse import unquote

REPOSITORY = re.compile(r"/repos/([^/]+/[^/]+)$")
HEAD = re.compile(r"/repos/[^/]+/[^/]+/git/ref/heads/(.+)$")
TAGS = re.compile(r"/repos/[^/]+/[^/]+/git/matching-refs/tags/(.*)$")
LISTS = re.compile(r"/repos/([^/]+/[^/]+)/(branches|tags|pulls)$")
OF_PULL = re.compile(r"/repos/[^/]+/[^/]+/(?:pulls|issues)/\d+/(files|comments)$")
ISSUES = re.compile(r"/repos/[^/]+/[^/]+/issues$")
ISSUE = re.compile(r"/repos/[^/]+/[^/]+/issues/(\d+)$")
BOT = "github-actions[bot]"
REFS = re.compile(r"/repos/[^/]+/[^/]+/git/refs(?:/heads/(.+))?$")
CONTENTS = re.compile(r"/repos/[^/]+/[^/]+/contents/(.+)$")
PULL = re.compile(r"/repos/[^/]+/[^/]+/pulls(?:/(\d+))?$")
COMMIT = re.compile(r"/repos/([^/]+/[^/]+)/commits/([0-9a-f]{7,40})$")


def answer(path: str, repository: dict[str, Any]) -> Any:  # noqa: PLR0911 - a table of answers
    """Return what the API would say to a GET of this path, None for what the stand-in does not know.

    ``heads`` and ``tags`` of the repository are the commits of its branches and the names of its git tags, ``closed``
    the branches of its closed pull requests by their numbers, ``files`` those of an open one.
    """
    if found := REPOSITORY.match(path):
        name = found[1]
        facts = {
            "name": name.partition("/")[2],
            "full_name": name,
            "description": "a repository of the lab",
            "private": False,
            "html_url": f"https://github.com/{name}",
            "default_branch": "main",
            "license": {"spdx_id": "MIT"},
        }
        return {**facts, **repository}
    if found := HEAD.match(path):
        sha = repository.get("heads", {}).get(unquote(found[1]))
        return {"ref": f"refs/heads/{found[1]}", "object": {"type": "commit", "sha": sha}} if sha else None
    if found := TAGS.match(path):
        return [{"ref": f"refs/tags/{name}"} for name in repository.get("tags", ()) if name.startswith(found[1])]
    if found := LISTS.match(path):
        names = {"branches": repository.get("heads", {}), "tags": repository.get("tags", ())}
        if found[2] in names:
            return [{"name": name} for name in names[found[2]]]
        if opened := repository.get("proposed"):
            return opened
        own = {"full_name": found[1]}
        return [
            {"number": number, "head": {"ref": ref, "repo": own}}
            for number, ref in repository.get("closed", {}).items()
        ]
    if found := OF_PULL.match(path):
        return repository.get("files", []) if found[1] == "files" else []
    if ISSUES.match(path):
        return [issue for issue in repository.get("issues", ()) if issue["state"] == "open"]
    if found := COMMIT.match(path):
        return {
            "sha": found[2],
            "commit": {"committer": {"date": "2026-01-01T00:00:00Z"}},
            "author": {"login": repository.get("authors", {}).get(found[2], BOT)},
        }
    return _content(CONTENTS.match(path), repository)


def _content(found: re.Match[str] | None, repository: dict[str, Any]) -> Any:
    text = repository.get("contents", {}).get(unquote(found[1])) if found else None
    return {"sha": str(hash(text)), "content": b64encode(text.encode()).decode()} if text is not None else None


def created(path: str, body: dict[str, Any], known: dict[str, Any]) -> tuple[int, Any]:
    """Return the status and the answer to a POST, and keep what it makes."""
    if REFS.match(path) or PULL.match(path):
        if "proposed" not in known:
            return 403, {"message": "Resource not accessible by integration"}
        if REFS.match(path):
            known["heads"][body["ref"].removeprefix("refs/heads/")] = body["sha"]
        else:
            body |= {"number": len(known["proposed"]) + 1, "state": "open", "head": {"ref": body["head"]}}
            known["proposed"].append(body)
    elif ISSUES.match(path):
        body |= {"number": len(known["issues"]) + 1, "state": "open", "user": {"login": BOT}, "changes": 0}
        known["issues"].append(body)
    else:
        known.get("posted", []).append((path, body))
    return 201, body


def changed(path: str, body: dict[str, Any], known: dict[str, Any]) -> tuple[int, Any]:
    """Return the status and the answer to a PATCH, and keep what it changes."""
    if found := REFS.match(path):
        known["heads"][found[1]] = body["sha"]
        return 200, body
    kind, found = ("proposed", PULL.match(path)) if PULL.match(path) else ("issues", ISSUE.match(path))
    if not found:
        return 404, {}
    thing = known[kind][int(found[1]) - 1]
    thing |= {**body, "changes": thing.get("changes", 0) + 1}
    return 200, thing


@contextmanager
def api_stub(repository: dict[str, Any] | None = None) -> Iterator[str]:
    """Serve the stand-in on a free port of the loopback and yield its address; `repository` overrides what it says.

    Its list ``posted`` gets the path and the body of each comment that is posted, ``issues`` holds the issues,
    which the job's own token opens and changes. ``heads`` gets the branches that it makes, ``contents`` the files that
    it writes on them, ``proposed`` the pull requests that it opens; without ``proposed`` it has no right to.
    """

    known = repository or {}

    class Handler(BaseHTTPRequestHandler):
        def do_GET(self) -> None:
            said = answer(self.path.partition("?")[0], known)
            unknown = {"message": "the lab's stand-in does not know this"}
            self._say(404 if said is None else 200, unknown if said is None else said)

        def do_POST(self) -> None:
            self._say(*created(self.path, self._body(), known))

        def do_PATCH(self) -> None:
            self._say(*changed(self.path, self._body(), known))

        def do_PUT(self) -> None:
            body, found = self._body(), CONTENTS.match(self.path)
            if found:
                known.setdefault("contents", {})[unquote(found[1])] = b64decode(body["content"]).decode()
            self._say(201 if found else 404, {})

        def _body(self) -> dict[str, Any]:
            found: dict[str, Any] = json.loads(self.rfile.read(int(self.headers["Content-Length"])))
            return found

        def _say(self, status: int, body: Any) -> None:
            data = json.dumps(body).encode()
            self.send_response(status)
            self.send_header("Content-Type", "application/json")
            self.send_header("Content-Length", str(len(data)))
            self.end_headers()
            self.wfile.write(data)

        def log_message(self, *args: object) -> None:
            """Say nothing: act's log is what a test reads."""

    server = ThreadingHTTPServer(("127.0.0.1", 0), Handler)
    thread = threading.Thread(target=server.serve_forever, args=(0.05,), daemon=True)
    thread.start()
    try:
        yield f"http://127.0.0.1:{server.server_address[1]}"
    finally:
        server.shutdown()
        server.server_close()
        thread.join()
