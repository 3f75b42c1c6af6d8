"""What is run again, or late: the newest attempt of each platform is tagged, and no tag moves back."""

from __future__ import annotations

import threading
from collections.abc import Iterator
from contextlib import contextmanager
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path

import pytest

from lab import doors, registry
from lab.act import run_workflow
from lab.laboratory import Laboratory

DOORS = pytest.mark.parametrize("door", [doors.through_action, doors.through_workflow], ids=["action", "image"])


@pytest.fixture
def name(lab: Laboratory) -> str:
    """Return the name of a repository that nothing was pushed to yet, without its owner."""
    return lab.fresh_repository(f"{doors.OWNER}/robot").rpartition("/")[2]


@contextmanager
def weather() -> Iterator[tuple[str, list[str]]]:
    """Serve a file whose content changes between two attempts; yield its address and the content, to be replaced."""
    content = ["foul"]

    class Handler(BaseHTTPRequestHandler):
        def do_GET(self) -> None:
            body = content[0].encode()
            self.send_response(200)
            self.send_header("Content-Length", str(len(body)))
            self.end_headers()
            self.wfile.write(body)

        do_HEAD = do_GET  # noqa: N815 - the name that http.server looks for

        def log_message(self, *_: object) -> None:
            """Say nothing: act's log is what a test reads."""

    server = ThreadingHTTPServer(("127.0.0.1", 0), Handler)
    thread = threading.Thread(target=server.serve_forever, args=(0.05,), daemon=True)
    thread.start()
    try:
        yield f"http://127.0.0.1:{server.server_port}/weather", content
    finally:
        server.shutdown()
        server.server_close()
        thread.join()


@pytest.mark.parametrize("ids", ["ascending", "descending"])
def test_one_platform_that_is_run_again(lab: Laboratory, tmp_path: Path, name: str, ids: str) -> None:
    """The first attempt's report of it is still among the artifacts, and may have the higher id."""
    store = tmp_path / "store"
    environment = {**doors.builder(lab), "REPRO_LAB_IDS": ids}
    with weather() as (address, content):
        dockerfile = f"FROM ubuntu:24.04\nADD {address} /weather\nRUN uname -m > /machine\n"
        given = {"registry": lab.registry, "test": "cat /weather; grep fine /weather || grep x86_64 /machine"}
        caller = doors.through_workflow(tmp_path / "caller", given, {"Dockerfile": dockerfile})
        first = run_workflow(lab, caller, "push", doors.payload(name), env=environment, artifacts=store)
        assert first.exit_code != 0
        assert "| `linux/amd64` | ✅" in first.summary, first.log  # of the two, only the other one failed
        assert registry.tags(f"{doors.OWNER}/{name}") == ()
        content[0] = "fine"
        second = run_workflow(
            lab, caller, "push", doors.payload(name), env=environment, artifacts=store, attempt=2,
            matrix="platform:linux/arm64",
        )  # fmt: skip
    assert second.exit_code == 0, second.log
    assert "Published as" in second.summary
    assert {"main", "latest"} < set(registry.tags(f"{doors.OWNER}/{name}"))
    index, digest = registry.manifest(f"{doors.OWNER}/{name}:main")
    assert digest == second.output("digest")
    for entry in index["manifests"]:
        architecture = entry["platform"]["architecture"]
        if architecture in ("amd64", "arm64"):
            layers = list(doors.blobs(lab, f"{lab.registry}/{doors.OWNER}/{name}@{entry['digest']}"))
            expected = b"foul" if architecture == "amd64" else b"fine"
            assert [layer for layer in layers if b"weather" in layer and expected in layer], architecture


@DOORS
@pytest.mark.parametrize("head", ["f" * 40, None], ids=["moved on", "gone"])
def test_an_old_commit_moves_no_tag(lab: Laboratory, tmp_path: Path, name: str, door: type, head: str | None) -> None:
    caller = door(tmp_path / "caller", {"registry": lab.registry, "platforms": "linux/amd64"})
    heads = {"main": head} if head else {}
    ran = run_workflow(lab, caller, "push", doors.payload(name), env=doors.builder(lab), github={"heads": heads})
    assert ran.exit_code == 0, ran.log
    (only,) = registry.tags(f"{doors.OWNER}/{name}")
    assert only.startswith("sha-")
    assert ran.output("tags") == f"{lab.registry}/{doors.OWNER}/{name}:{only}"
    assert "latest: not moved to" in ran.log


@DOORS
@pytest.mark.parametrize(
    ("branch", "expected"),
    [("1.2.3", {"sha"}), ("latest", {"sha"}), ("gh-readonly-queue/main/pr-7-" + "0" * 40, set())],
    ids=["release", "latest", "merge queue"],
)
def test_a_branch_that_is_none(  # noqa: PLR0917 - fixtures
    lab: Laboratory, tmp_path: Path, name: str, door: type, branch: str, expected: set[str]
) -> None:
    """Called like a release, or a merge queue's: such a push takes no release's tag."""
    caller = door(tmp_path / "caller", {"registry": lab.registry, "platforms": "linux/amd64"})
    payload = doors.payload(name, ref=f"refs/heads/{branch}")
    ran = run_workflow(lab, caller, "push", payload, env=doors.builder(lab))
    assert ran.exit_code == 0, ran.log
    assert {tag.partition("-")[0] for tag in registry.tags(f"{doors.OWNER}/{name}")} == expected
    assert ("gets no tag of its name" in ran.log) == bool(expected)
