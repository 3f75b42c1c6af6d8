"""What the cleaner removes and what it leaves, decided on versions and done against stand-ins for both registries."""

from __future__ import annotations

import datetime as dt
import hashlib
import json
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from typing import Any

import pytest

from roslab.config.model import TagParts
from roslab.engine import credentials, versions
from roslab.engine.versions import Manifest, Version
from roslab.errors import BuildError, ConfigurationError, RefusedError
from roslab.github import api, packages
from roslab.github.clean import _versions, clean, manifests_of
from roslab.github.unneeded import Names, Rules, chosen

NAMES = Names(
    branches=frozenset({"main", "dev"}),
    git_tags=frozenset({"v1.2.3"}),
    closed=frozenset({"fix/it", "latest"}),
    closed_pulls=frozenset({"7"}),
)
RULES = Rules(days=30)


def digest(name: str) -> str:
    return "sha256:" + hashlib.sha256(name.encode()).hexdigest()


def version(name: str, *tags: str, days: float | None = 100.0) -> Version:
    return Version(digest=digest(name), tags=tags, days=days, name=name)


def going(found: list[Version], children: dict[str, list[str]] | None = None, rules: Rules = RULES) -> list[str]:
    """Return what goes, by name, or by the digest's beginning where it was not listed."""
    known = {each.digest: Manifest(digest=each.digest) for each in found}
    for name, parts in (children or {}).items():
        known[digest(name)] = Manifest(digest=digest(name), children=tuple(map(digest, parts)))
    return [each.version.name or each.version.digest for each in chosen(found, known, NAMES, rules)]


@pytest.mark.parametrize(
    "tags",
    [
        ("main",), ("dev", "sha-0123456"), ("sha-0123456",), ("v1.2.3", "1.2.3", "1.2"), ("latest",), ("nightly",),
        ("paper",), ("fix-it", "paper"), ("fix-it", "main"), ("pr-8",), ("sha-0123456-humble", "fix-it-humble"),
    ],
)  # fmt: skip
def test_what_stays(tags: tuple[str, ...]) -> None:
    """Also what only looks like a closed branch: a tag that somebody made, a branch called like a release."""
    assert going([version("a", *tags)]) == []


@pytest.mark.parametrize(
    "tags",
    [
        ("fix-it",),
        ("fix-it", "sha-0123456"),
        ("pr-7",),
        ("buildcache-fix-it-01234567-linux-arm64",),
        ("buildcache-fix-it-01234567-all-base-1",),
        ("buildcache-fix-it-01234567-linux-arm64.tree",),
        ("buildcache-fix-it-01234567-all.tree",),
    ],
)
def test_what_a_closed_branch_leaves(tags: tuple[str, ...]) -> None:
    assert going([version("a", *tags, days=0.1)]) == ["a"]
    kept = Rules(days=30, keep=(tags[0][:4] + "*",))
    assert going([version("a", *tags)], rules=kept) == []
    assert going([version("a", *tags)], rules=Rules(days=30, keep=(digest("a"),))) == []


def test_layers_go_when_no_build_wrote_them() -> None:
    tag = "buildcache-main-01234567-all"
    assert going([version("a", tag, days=29.9)]) == []
    assert going([version("a", tag, days=30.0)]) == ["a"]
    assert going([version("a", tag, days=None)]) == []


def test_a_branch_that_only_its_layers_tell_of() -> None:
    found = [version("a", "old-try"), version("b", "buildcache-old-try-01234567-all", days=0.0)]
    assert going(found) == ["a", "b"]
    assert going([found[0]]) == []


def test_a_suffix_tells_calls_apart() -> None:
    rules = Rules(days=30, parts=TagParts(suffix="-humble"))
    assert going([version("a", "fix-it-humble", "sha-0123456-humble")], rules=rules) == ["a"]
    assert going([version("a", "fix-it")], rules=rules) == []


def test_a_slim_image_goes_with_the_whole_one() -> None:
    tags = ("fix-it-slim", "sha-0123456-slim")
    assert going([version("a", *tags)]) == ["a"]
    assert going([version("a", "pr-7-slim")]) == ["a"]
    assert going([version("a", "main-slim", "sha-0123456-slim")]) == []
    suffixed = Rules(days=30, parts=TagParts(suffix="-humble"))
    assert going([version("a", "fix-it-humble-slim")], rules=suffixed) == ["a"]
    living = Names(branches=frozenset({"fix-it-slim"}), closed=frozenset({"fix-it"}))
    assert [each.version.name for each in chosen([version("a", "fix-it-slim")], {}, living, RULES)] == []


def test_digests_without_a_tag() -> None:
    """Those that an index names stay, those of a build that may run stay, the rest goes."""
    found = [
        version("index", "main"), version("amd64"), version("arm64"), version("failed"), version("failed part"),
        version("running", days=0.2), version("running part"),
    ]  # fmt: skip
    children = {"index": ["amd64", "arm64"], "failed": ["failed part", "amd64"], "running": ["running part"]}
    assert going(found, children) == ["failed", "failed part"]


def test_an_index_takes_its_own_parts_along_and_no_others() -> None:
    found = [version("index", "main"), version("closed", "fix-it", days=1.0), version("own", days=1.0)]
    found += [version("shared", days=1.0)]
    children = {"index": ["shared"], "closed": ["own", "shared"]}
    assert going(found, children) == ["closed", "own"]
    unlisted = [each for each in found if each.tags]
    assert going(unlisted, children) == ["closed", digest("own")]


def test_what_is_said_about_a_digest_stays_and_goes_with_it() -> None:
    def tag(name: str) -> str:
        return digest(name).replace(":", "-")

    found = [
        version("index", "main"), version("said", tag("index")), version("signature"),
        version("closed", "fix-it"), version("said of closed", tag("closed")), version("its signature"),
        version("replaced"), version("said of replaced", tag("replaced")), version("replaced part"),
    ]  # fmt: skip
    children = {"said": ["signature"], "said of closed": ["its signature"], "replaced": ["replaced part"]}
    assert sorted(going(found, children)) == ["closed", "its signature", "said of closed"]


class Registry:
    """As much of a registry, and of GitHub's API, as cleaning asks."""

    def __init__(self, *, bearer: bool = False) -> None:
        self.bearer, self.tokens, self.removed = bearer, 0, list[str]()
        self.manifests: dict[str, dict[str, Any]] = {}
        self.tags: dict[str, str] = {}
        self.branches = [{"name": "main"}]
        self.lost: set[str] = set()

    def push(self, *tags: str, parts: tuple[str, ...] = (), note: str = "") -> str:
        data = {"manifests": [{"digest": part} for part in parts], "annotations": {"note": note}}
        name = digest(json.dumps(data))
        self.manifests[name] = data
        self.tags |= dict.fromkeys(tags, name)
        return name

    def answer(self, request: BaseHTTPRequestHandler) -> tuple[int, dict[str, str], Any]:  # noqa: PLR0911 - a table of answers
        path, _, query = request.path.partition("?")
        host, last = request.headers["Host"], path.rpartition("/")[2]
        if path == "/token":
            self.tokens += 1
            return 200, {}, {"token": f"token {self.tokens}"}
        if path.startswith("/v2") and self.bearer and request.headers.get("Authorization") != "Bearer token 2":
            return 401, {"WWW-Authenticate": f'Bearer realm="http://{host}/token",service="x"'}, {}
        if path.endswith("/tags/list"):
            names = sorted(self.tags)
            more = {"Link": '</v2/lab/robot/tags/list?last=x&n=500>; rel="next"'} if "last" not in query else {}
            return 200, more, {"tags": names[1:] if "last" in query else names[:1]}
        if "/manifests/" in path:
            name = self.tags.get(last, last)
            if request.command == "DELETE":
                self.removed.append(last)
                return (202 if self.manifests.pop(last, None) else 404), {}, {}
            found = None if name in self.lost else self.manifests.get(name)
            return (200, {"Docker-Content-Digest": name}, found) if found else (404, {}, {})
        if "/packages/container/" in path:
            return self.package(request.command, path)
        if path.endswith(("/branches", "/tags")):
            return 200, {}, self.branches if path.endswith("/branches") else []
        if path.endswith("/pulls"):
            own = {"ref": "fix", "repo": {"full_name": "lab/robot"}}
            return 200, {}, [{"number": 7, "head": own}, {"number": 8, "head": {"ref": "stranger", "repo": None}}]
        return 200, {}, {}

    def package(self, command: str, path: str) -> tuple[int, dict[str, str], Any]:
        if path.startswith("/orgs/"):
            return 404, {}, {}
        if command == "DELETE":
            self.removed.append(list(self.manifests)[int(path.rpartition("/")[2])])
            return 204, {}, None
        listed = [
            {"id": number, "name": name, "updated_at": "2026-01-01T00:00:00Z",
             "metadata": {"container": {"tags": [tag for tag, what in self.tags.items() if what == name]}}}
            for number, name in enumerate(self.manifests)
        ]  # fmt: skip
        return 200, {}, listed


@contextmanager
def served(registry: Registry) -> Iterator[str]:
    class Handler(BaseHTTPRequestHandler):
        def do_GET(self) -> None:
            status, headers, data = registry.answer(self)
            body = b"" if data is None else json.dumps(data).encode()
            self.send_response(status)
            for name, value in {**headers, "Content-Length": str(len(body))}.items():
                self.send_header(name, value)
            self.end_headers()
            self.wfile.write(body)

        do_DELETE = do_GET  # noqa: N815 - the name that http.server looks for

        def log_message(self, *_: object) -> None:
            pass

    server = ThreadingHTTPServer(("127.0.0.1", 0), Handler)
    thread = threading.Thread(target=server.serve_forever, args=(0.01,))
    thread.start()
    try:
        yield f"127.0.0.1:{server.server_port}"
    finally:
        server.shutdown()
        server.server_close()
        thread.join()


def environment(host: str, folder: Path, **inputs: str) -> dict[str, str]:
    return {
        "GITHUB_EVENT_NAME": "schedule", "GITHUB_REPOSITORY": "lab/robot", "GITHUB_REF": "refs/heads/main",
        "GITHUB_ACTOR": "lab", "GITHUB_API_URL": f"http://{host}",
        "ROSLAB_TOKEN": "right", "ROSLAB_SECRET_GIVEN": "true",
        "GITHUB_STEP_SUMMARY": str(folder / "summary"), "GITHUB_OUTPUT": str(folder / "output"), "INPUT_REGISTRY": host,
        **inputs,
    }  # fmt: skip


def test_it_shows_first_and_removes_only_where_it_is_told_to(tmp_path: Path) -> None:
    registry = Registry()
    part, shared = registry.push(note="part"), registry.push(note="shared")
    closed = registry.push("fix", parts=(part, shared))
    registry.push("main", "latest", parts=(shared,), note="main")
    registry.push("stranger", note="a tag like the branch of a fork")
    with served(registry) as host:
        clean(environment(host, tmp_path))
        assert registry.removed == []
        assert "2 versions would go, 2 stay" in (tmp_path / "summary").read_text()
        assert "write `dry-run: false`" in (tmp_path / "summary").read_text()
        clean(environment(host, tmp_path, INPUT_DRY_RUN="false"))
    assert registry.removed == [closed, part]
    assert f"{closed}\n{part}\n" in (tmp_path / "output").read_text()


def test_the_image_is_called_as_the_build_calls_it(tmp_path: Path) -> None:
    """By roslab.yaml, of the folder that is built, and by the inputs over it."""
    (tmp_path / "robots/arm").mkdir(parents=True)
    (tmp_path / "robots/arm/roslab.yaml").write_text("format: 3\nname: arm\ntags: {suffix: -humble}\n")
    registry = Registry()
    closed, other = registry.push("fix-humble", note="humble"), registry.push("fix-jazzy", note="jazzy")
    with served(registry) as host:
        asked = environment(host, tmp_path, INPUT_PATH="robots/arm", GITHUB_WORKSPACE=str(tmp_path))
        clean({**asked, "INPUT_DRY_RUN": "false"})
        assert registry.removed == [closed]
        assert f"Of `{host}/lab/arm`" in (tmp_path / "summary").read_text()
        clean({**asked, "INPUT_DRY_RUN": "false", "INPUT_TAG_SUFFIX": "-jazzy"})
    assert registry.removed == [closed, other]


def closing(folder: Path, *, head: str = "lab/robot", action: str = "closed") -> dict[str, str]:
    """Return the event of a pull request, number 7."""
    event = {"action": action, "pull_request": {"number": 7, "head": {"repo": {"full_name": head}}}}
    (folder / "event.json").write_text(json.dumps(event))
    return {"GITHUB_EVENT_NAME": "pull_request", "GITHUB_EVENT_PATH": str(folder / "event.json")}


def test_a_pull_request_that_closes_takes_its_own_image_along_alone(tmp_path: Path) -> None:
    registry = Registry()
    part, shared = registry.push(note="part"), registry.push(note="shared")
    closed = registry.push("pr-7", parts=(part, shared))
    for tag in ("main", "pr-8", "fix", "buildcache-fix-01234567-all"):
        registry.push(tag, parts=(shared,), note=tag)
    registry.branches = []  # it needs no right to ask for them
    with served(registry) as host:
        clean({**environment(host, tmp_path, INPUT_DRY_RUN="false"), **closing(tmp_path)})
    assert registry.removed == [closed, part]
    assert "the pull request 7 is closed" in (tmp_path / "summary").read_text()


def test_what_is_no_closing_of_our_own_removes_nothing(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    registry = Registry()
    registry.push("pr-7")
    with served(registry) as host:
        asked = environment(host, tmp_path, INPUT_DRY_RUN="false")
        with pytest.raises(ConfigurationError, match="closes no pull request"):
            clean({**asked, **closing(tmp_path, action="opened")})
        clean({**asked, **closing(tmp_path, head="stranger/robot")})
        assert "is another repository's" in capsys.readouterr().err
        clean({**asked, **closing(tmp_path), "GITHUB_ACTOR": "dependabot[bot]"})
    assert registry.removed == []


def test_a_closed_pull_request_of_a_repository_without_a_package(monkeypatch: pytest.MonkeyPatch) -> None:
    registry = Registry()
    with served(registry) as host:
        monkeypatch.setattr(Registry, "package", lambda *_: (404, {}, {}))
        session = credentials.session(f"{host}/lab/robot", "lab", "right", "pull")
        ask = api.asker({"GITHUB_API_URL": f"http://{host}"})
        now = dt.datetime(2026, 2, 1, tzinfo=dt.timezone.utc)
        store = packages.store(f"{host}/lab/robot", ask, ask, session, now=now)
        assert _versions(store, Rules(days=30, pull="7")) == ()
        with pytest.raises(packages.NoPackageError, match="no package robot of lab"):
            _versions(store, RULES)


def test_a_package_of_github() -> None:
    registry = Registry(bearer=True)
    failed, index = registry.push(note="failed"), registry.push("main", note="index")
    with served(registry) as host:
        image = f"{host}/lab/robot"
        session = credentials.session(image, "lab", "right", "pull", pause=lambda _: None)
        theirs = {"GITHUB_API_URL": f"http://{host}"}
        remove = api.asker(theirs, method="DELETE")
        now = dt.datetime(2026, 2, 1, tzinfo=dt.timezone.utc)
        store = packages.store(image, api.asker(theirs), remove, session, now=now)
        found = store.versions()
        assert [(each.digest, each.tags, each.days) for each in found] == [(failed, (), 31.0), (index, ("main",), 31.0)]
        known = {each.digest: store.manifest(each.digest) for each in found}
        (only,) = chosen(found, {name: each for name, each in known.items() if each}, NAMES, RULES)
        store.remove(only.version)
    assert registry.removed == [failed]
    assert registry.tokens == 2, "a token that ran out is renewed"


def test_nothing_is_removed_by_half_of_the_truth(tmp_path: Path) -> None:
    registry = Registry()
    registry.push("fix")
    with served(registry) as host:
        asked = environment(host, tmp_path, INPUT_DRY_RUN="false")
        registry.branches = []
        with pytest.raises(BuildError, match="does not list the branches"):
            clean(asked)
        with pytest.raises(RefusedError, match="a password of its own"):
            clean({**asked, "ROSLAB_SECRET_GIVEN": "false"})
        with pytest.raises(ConfigurationError, match="no number of days") as wrong:
            clean({**asked, "INPUT_DAYS": "0", "INPUT_DRY_RUN": "perhaps"})
    assert len(wrong.value.problems) == 2
    assert registry.removed == []


def test_a_list_without_an_end() -> None:
    """An index that is not listed may name what is."""
    asked: list[str] = []

    def ask(path: str) -> list[dict[str, str]]:
        asked.append(path)
        return [{}] * 100

    with pytest.raises(BuildError, match=f"more than {100 * api.PAGES} entries"):
        api.pages(ask, "/a")
    assert asked[1] == "/a?per_page=100&page=2"
    assert len(api.pages(ask, "/a?b=c", whole=False) or ()) == 100 * api.PAGES


def test_a_manifest_that_is_listed_and_lost(tmp_path: Path) -> None:
    registry = Registry()
    tagged = registry.push("main")
    with served(registry) as host:
        session = credentials.session(f"{host}/lab/robot", "lab", "right", "pull,delete")
        store = versions.store(session)
        assert [each.tags for each in store.versions()] == [("main",)]
        registry.lost.add(tagged)
        with pytest.raises(BuildError, match=f"lists {tagged} and does not give it"):
            manifests_of(store, [Version(digest=tagged)])
        assert versions.tags(session) == ("main",)
