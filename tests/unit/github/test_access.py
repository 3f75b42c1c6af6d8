"""Asking a registry before building: the dialogue with stand-ins for registries, and what their answers mean."""

from __future__ import annotations

import base64
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer

import pytest

from roslab.engine.credentials import Access, is_public, may_push, same_host, trusted
from roslab.errors import BuildError, RefusedError
from roslab.github import access
from roslab.github.event import Event

EVENT = Event(name="push", repository="lab/robot", ref="refs/heads/main", sha="", default_branch="main")
RIGHT_WORD = "right"
RIGHT = "Basic " + base64.b64encode(f"lab:{RIGHT_WORD}".encode()).decode()


class StandInRegistry:
    """As much of a registry as a push asks first; ``bearer`` tells whether it has a token server, as ghcr.io does."""

    def __init__(self, *, bearer: bool = False, writable: bool = True, faults: int = 0, denial: int = 401) -> None:
        self.bearer, self.writable, self.faults, self.denial = bearer, writable, faults, denial
        self.asked: list[str] = []

    def answer(self, request: BaseHTTPRequestHandler) -> tuple[int, dict[str, str], str]:  # noqa: PLR0911 - a table of answers
        self.asked.append(f"{request.command} {request.path}")
        host = request.headers["Host"]
        if self.faults > 0:
            self.faults -= 1
            return 503, {}, ""
        said = request.headers.get("Authorization", "")
        if request.path.startswith("/token"):
            if said and said != RIGHT:
                return self.denial, {}, '{"errors": [{"code": "DENIED", "message": "denied"}]}'
            return 200, {}, '{"token": "' + ("full" if said else "anonymous") + '"}'
        if said not in ("Bearer full", "Bearer anonymous") if self.bearer else said != RIGHT:
            challenge = f'Bearer realm="http://{host}/token",service="here"' if self.bearer else 'Basic realm="here"'
            return 401, {"WWW-Authenticate": challenge}, "{}"
        if request.command == "POST":
            return (202, {"Location": "/v2/upload/1"}, "") if self.writable else (403, {}, "{}")
        if request.command == "HEAD":
            return (200 if said == "Bearer full" else 401), {}, ""
        return 200, {}, ""


@contextmanager
def served(registry: StandInRegistry) -> Iterator[str]:
    class Handler(BaseHTTPRequestHandler):
        def do_GET(self) -> None:
            status, headers, body = registry.answer(self)
            self.send_response(status)
            for name, value in {**headers, "Content-Length": str(len(body))}.items():
                self.send_header(name, value)
            self.end_headers()
            if self.command != "HEAD":
                self.wfile.write(body.encode())

        do_POST = do_DELETE = do_HEAD = do_GET  # noqa: N815 - the names that http.server looks for

        def log_message(self, *_: object) -> None:
            pass

    server = ThreadingHTTPServer(("127.0.0.1", 0), Handler)
    thread = threading.Thread(target=server.serve_forever, args=(0.01,))
    thread.start()
    try:
        yield f"127.0.0.1:{server.server_port}/lab/robot"
    finally:
        server.shutdown()
        server.server_close()
        thread.join()


def ask(
    registry: StandInRegistry, password: str = RIGHT_WORD, pause: Callable[[float], None] = lambda _: None
) -> Access:
    with served(registry) as image:
        return may_push(image, "lab", password, pause=pause)


@pytest.mark.parametrize("bearer", [False, True])
def test_a_right_password_is_granted_and_the_upload_given_up(*, bearer: bool) -> None:
    registry = StandInRegistry(bearer=bearer)
    assert ask(registry).verdict == "granted"
    assert registry.asked[-2:] == ["POST /v2/lab/robot/blobs/uploads/", "DELETE /v2/upload/1"]


@pytest.mark.parametrize(("bearer", "denial"), [(False, 401), (True, 401), (True, 403)])
def test_a_wrong_password(denial: int, *, bearer: bool) -> None:
    assert ask(StandInRegistry(bearer=bearer, denial=denial), "wrong").verdict == "wrong password"


@pytest.mark.parametrize("bearer", [False, True])
def test_a_right_password_that_may_not_write(*, bearer: bool) -> None:
    assert ask(StandInRegistry(bearer=bearer, writable=False)).verdict == "forbidden"


def test_a_passing_fault_is_survived_and_a_lasting_one_told() -> None:
    pauses: list[float] = []
    assert ask(StandInRegistry(faults=2), pause=pauses.append).verdict == "granted"
    assert pauses == [1.0, 2.0]
    assert ask(StandInRegistry(faults=99)) == Access(verdict="unreachable", detail="HTTP 503")


def test_nobody_there() -> None:
    assert may_push("127.0.0.1:9/lab/robot", "lab", "right", pause=lambda _: None).verdict == "unreachable"


def test_a_password_never_goes_to_a_token_server_in_the_clear() -> None:
    class Greedy(StandInRegistry):
        def answer(self, request: BaseHTTPRequestHandler) -> tuple[int, dict[str, str], str]:
            self.asked.append(request.path)
            return 401, {"WWW-Authenticate": 'Bearer realm="http://elsewhere.example/token",service="x"'}, ""

    registry = Greedy()
    assert ask(registry).verdict == "unknown"
    assert registry.asked == ["/v2/"]


@pytest.mark.parametrize(
    ("realm", "registry", "fine"),
    [
        ("https://auth.docker.io/token", "https://registry-1.docker.io/v2/a/b", True),
        ("http://quay.io/token", "https://quay.io/v2/a/b", False),  # the same host, in the clear
        ("http://127.0.0.1:5000/token", "http://127.0.0.1:5000/v2/a/b", True),
        ("http://127.0.0.1:6000/token", "http://127.0.0.1:5000/v2/a/b", False),
        ("http://127.0.0.1:5000@evil.example/token", "http://127.0.0.1:5000/v2/a/b", False),
        ("", "https://quay.io/v2/a/b", False),
    ],
)
def test_a_token_server_is_trusted_by_https(realm: str, registry: str, *, fine: bool) -> None:
    assert trusted(realm, registry) is fine


@pytest.mark.parametrize(
    "location", ["http://elsewhere.example/upload/1", "//elsewhere.example/upload/1", "https://127.0.0.1/upload/1", ""]
)
def test_what_a_registry_names_elsewhere_is_not_asked(location: str) -> None:
    """The header with the password would go along."""
    registry = StandInRegistry()
    answered = registry.answer

    def answer(request: BaseHTTPRequestHandler) -> tuple[int, dict[str, str], str]:
        status, headers, body = answered(request)
        return status, {**headers, **({"Location": location} if "Location" in headers else {})}, body

    registry.answer = answer  # type: ignore[method-assign]
    assert ask(registry).verdict == "granted"
    assert [line for line in registry.asked if not line.startswith(("GET", "POST"))] == []
    assert not same_host("https://a.example.evil/", "https://a.example/")


@pytest.mark.parametrize("registry", ["quay.io", "ghrc.io", "ghcr.io.evil.example", "ghcr.io:443", "docker.io"])
def test_the_runs_own_token_is_for_one_registry(registry: str) -> None:
    with pytest.raises(RefusedError, match=f"refused: {registry} needs a password of its own, and `registry-token`"):
        access.require_secret(registry, name="registry-token", given=False)
    access.require_secret(registry, name="registry-token", given=True)
    access.require_secret("ghcr.io", name="registry-token", given=False)


def test_public() -> None:
    with served(StandInRegistry(bearer=True)) as image:
        assert is_public(image, "sha256:0", pause=lambda _: None) is False
    with served(StandInRegistry()) as image:
        assert is_public(image, "sha256:0", pause=lambda _: None) is False


def test_what_to_do_about_it() -> None:
    def told(verdict: str, image: str) -> str:
        with pytest.raises(BuildError) as caught:
            access.require(Access(verdict=verdict), image=image, event=EVENT)  # type: ignore[arg-type]
        assert caught.value.exit_code == 5
        assert len(caught.value.problems) == 1
        return str(caught.value)

    assert "add `packages: write` to the `permissions:`" in told("forbidden", "ghcr.io/lab/robot")
    assert "packages: write" not in told("forbidden", "quay.io/lab/robot")
    assert "leave the secret registry-token (the action's input token) out" in told(
        "wrong password", "ghcr.io/lab/robot"
    )
    assert "a workflow's secret registry-token, the action's input token" in told("wrong password", "quay.io/lab/robot")
    assert "does not answer" in told("unreachable", "quay.io/lab/robot")
    access.require(Access(verdict="unknown"), image="quay.io/lab/robot", event=EVENT)


@pytest.mark.parametrize(
    ("line", "verdict"),
    [
        ("denied: permission_denied: write_package", "forbidden"),
        ("denied: installation not allowed to Create organization package", "forbidden"),
        ("unexpected status from HEAD request to http://a/b: 401 Unauthorized", "wrong password"),
        ("unexpected status from POST request to http://a/b: 403 Forbidden", "forbidden"),
        ("dial tcp 127.0.0.1:9: connect: connection refused", "unreachable"),
        ("unexpected status from PUT request to http://a/b?c=d: 503 Service Unavailable", "unreachable"),
    ],
)
def test_a_refused_push_in_a_log(line: str, verdict: str) -> None:
    found = access.refusal(f"#1 building\n#2 ERROR: failed to push ghcr.io/a/b: {line}\n")
    assert found
    assert found.verdict == verdict


def test_a_base_image_that_cannot_be_pulled_is_no_refusal() -> None:
    line = "failed to resolve source metadata for docker.io/a/b: 401 Unauthorized"
    assert access.refusal(f"#2 ERROR: {line}\n") is None


def test_a_build_that_failed_of_itself_is_no_refusal() -> None:
    assert access.refusal('#9 ERROR: process "/bin/sh -c make" did not complete successfully: exit code: 2') is None
