"""Submodules one by one over a real server, large files and tags: what is missing is named and stops nothing."""

from __future__ import annotations

import gzip
import os
import subprocess
import threading
from collections.abc import Iterator
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path

import pytest

from roslab.errors import ConfigurationError
from roslab.pipeline import plan_repository
from roslab.repository import fetching
from roslab.repository.git import describe, is_tag


class Quiet(SimpleHTTPRequestHandler):
    """Serves files and asks for a password where the path says private."""

    def do_GET(self) -> None:
        given = self.headers.get("Authorization", "")
        if "/private" in self.path and given != "basic eC1hY2Nlc3MtdG9rZW46c2VjcmV0":  # x-access-token:secret
            self.send_response(401)
            self.send_header("WWW-Authenticate", 'Basic realm="x"')
            self.end_headers()
            return
        super().do_GET()

    def log_message(self, format: str, *args: object) -> None:  # noqa: A002 - its name in the base class
        """Say nothing."""


class Smart(Quiet):
    """Serves repositories by git's own program, which knows depths and filters."""

    def do_GET(self) -> None:
        self.answer(b"")

    def do_POST(self) -> None:
        data = self.rfile.read(int(self.headers.get("Content-Length", 0)))
        self.answer(gzip.decompress(data) if self.headers.get("Content-Encoding") == "gzip" else data)

    def answer(self, data: bytes) -> None:
        path, _, query = self.path.partition("?")
        environment = {
            "PATH": os.environ["PATH"],
            "GIT_PROJECT_ROOT": self.directory,
            "GIT_HTTP_EXPORT_ALL": "1",
            "GIT_CONFIG_GLOBAL": f"{self.directory}/gitconfig",
            "GIT_PROTOCOL": self.headers.get("Git-Protocol", ""),
            "PATH_INFO": path,
            "QUERY_STRING": query,
            "REQUEST_METHOD": self.command,
            "CONTENT_TYPE": self.headers.get("Content-Type", ""),
            "CONTENT_LENGTH": str(len(data)),
        }
        said = subprocess.run(["git", "http-backend"], env=environment, input=data, capture_output=True, check=True)
        head, _, body = said.stdout.partition(b"\r\n\r\n")
        self.send_response(200)
        for line in head.decode().split("\r\n"):
            name, _, value = line.partition(": ")
            self.send_header(name, value)
        self.end_headers()
        self.wfile.write(body)


@pytest.fixture(params=[Quiet])
def server(tmp_path: Path, request: pytest.FixtureRequest) -> Iterator[str]:
    """Serve ``tmp_path/served`` and return its address."""
    folder = tmp_path / "served"
    folder.mkdir()
    with ThreadingHTTPServer(("127.0.0.1", 0), partial(request.param, directory=str(folder))) as running:
        threading.Thread(target=running.serve_forever, args=(0.05,), daemon=True).start()
        yield f"http://127.0.0.1:{running.server_port}"
        running.shutdown()


def git(folder: Path, *arguments: str) -> str:
    who = ["-c", "user.name=a", "-c", "user.email=a@example.org", "-c", "protocol.file.allow=always"]
    environment = {"PATH": os.environ["PATH"], "HOME": "/nonexistent"}
    command = ["git", "-C", str(folder), *who, *arguments]
    return subprocess.run(command, env=environment, check=True, capture_output=True, text=True).stdout


def repository(folder: Path, files: dict[str, str], links: dict[str, tuple[str, str]] | None = None) -> str:
    """Make a repository that a plain server can serve; ``links`` are submodules: path to address and commit."""
    folder.mkdir(parents=True)
    git(folder, "init", "--quiet", "--initial-branch=main")
    for path, text in files.items():
        (folder / path).write_text(text)
    for path, (url, commit) in (links or {}).items():
        git(folder, "config", "--file", ".gitmodules", f"submodule.{path}.path", path)
        git(folder, "config", "--file", ".gitmodules", f"submodule.{path}.url", url)
        git(folder, "update-index", "--add", "--cacheinfo", f"160000,{commit},{path}")
    git(folder, "add", "--all", ":!gone", ":!private", ":!inner", ":!library") if not links else git(
        folder, "add", ".gitmodules"
    )
    git(folder, "commit", "--quiet", "--message", "x")
    git(folder, "update-server-info")
    return git(folder, "rev-parse", "HEAD").strip()


def served(tmp_path: Path, server: str) -> Path:
    """Return a checkout with a good submodule, which has one of its own, a private one and one that is gone."""
    place = tmp_path / "served"
    inner = repository(place / "inner", {"deep.txt": "deep"})
    library = repository(place / "library", {"library.txt": "here"}, {"inner": (f"{server}/inner/.git", inner)})
    private = repository(place / "private", {"private.txt": "here"})
    links = {
        "gone": (f"{server}/gone/.git", "1" * 40),
        "library": (f"{server}/library/.git", library),
        "private": (f"{server}/private/.git", private),
    }
    repository(place / "robot", {}, links)
    git(tmp_path, "clone", "--quiet", str(place / "robot"), "checkout")
    return tmp_path / "checkout"


def test_each_submodule_stands_for_itself(tmp_path: Path, server: str) -> None:
    root = served(tmp_path, server)
    with fetching.git(fetching.Access()) as tool:
        missing = {entry.path: entry.reason for entry in fetching.submodules(tool, root)}
        assert set(missing) == {"gone", "private"}
        assert "not found" in missing["gone"]
        assert "could not read Username" in missing["private"]
        assert (root / "library/inner/deep.txt").read_text() == "deep"
        assert list((root / "private").iterdir()) == []
        again = fetching.submodules(tool, root)
    assert {entry.path for entry in again} == {"gone", "private"}


def test_a_token_fetches_a_private_one_and_stays_nowhere(tmp_path: Path, server: str) -> None:
    root = served(tmp_path, server)
    with fetching.git(fetching.Access(server=server, token="secret")) as tool:
        assert {entry.path for entry in fetching.submodules(tool, root)} == {"gone"}
    assert (root / "private/private.txt").read_text() == "here"
    kept = [file.read_bytes() for file in (root / ".git").rglob("*") if file.is_file()]
    assert not [data for data in kept if b"secret" in data or b"eC1hY2Nlc3MtdG9rZW46" in data]


def test_gitmodules_can_run_nothing(tmp_path: Path, server: str) -> None:
    root = served(tmp_path, server)
    trap = tmp_path / "ran"
    for name, value in (
        ("submodule.gone.url", f"ext::touch {trap}"),
        ("submodule.private.url", "file:///etc"),
        ("submodule.library.update", f"!touch {trap}"),
    ):
        git(root, "config", "--file", ".gitmodules", name, value)
    with fetching.git(fetching.Access()) as tool:
        missing = {entry.path for entry in fetching.submodules(tool, root)}
    assert {"gone", "private"} <= missing
    assert not trap.exists()


def test_a_folder_that_looks_like_a_bare_repository_configures_nothing(tmp_path: Path, server: str) -> None:
    """A tree can hold all files of one, and ``path`` may name its folder; git would ask its helper for a password."""
    (tmp_path / "served/private").mkdir()
    root, trap = tmp_path / "checkout", tmp_path / "ran"
    root.mkdir()
    git(root, "init", "--quiet", "--bare", "arm")
    git(root / "arm", "config", "credential.helper", f"!touch {trap}")
    git(root / "arm", "config", "remote.origin.url", f"{server}/private")
    subprocess.run(["git", "-C", root / "arm", "fetch", "--quiet"], check=False, capture_output=True,
                   env={**os.environ, "GIT_TERMINAL_PROMPT": "0"})  # fmt: skip
    assert trap.exists(), "without care it runs, so the check below means something"
    trap.unlink()
    with fetching.git(fetching.Access()) as tool:
        assert fetching.tags(tool, root / "arm") != ""
        assert fetching.submodules(tool, root / "arm") == ()
    assert not trap.exists()
    assert describe(root / "arm") is None


@pytest.mark.parametrize("name", ["", ".", "./", ".."])
def test_a_submodule_without_a_name_removes_no_other(tmp_path: Path, server: str, name: str) -> None:
    root = served(tmp_path, server)
    (root / ".gitmodules").write_text(
        (root / ".gitmodules").read_text().replace('[submodule "private"]', f'[submodule "{name}"]')
    )
    with fetching.git(fetching.Access()) as tool:
        assert fetching.submodules(tool, root)
    assert (root / ".git/modules/library/HEAD").is_file()
    assert (root / "library/inner/deep.txt").read_text() == "deep"


@pytest.mark.parametrize(
    ("url", "expected"),
    [
        ("git@github.com:lab/robot.git", "https://github.com/lab/robot.git"),
        ("ssh://git@gitlab.com/lab/robot.git", "https://gitlab.com/lab/robot.git"),
        ("ssh://git@example.org:2222/lab/robot", "https://example.org/lab/robot"),
        ("git://github.com/lab/robot", "https://github.com/lab/robot"),
        ("https://github.com/lab/robot.git", "https://github.com/lab/robot.git"),
        ("../robot.git", "../robot.git"),
        ("/srv/robot.git", "/srv/robot.git"),
    ],
)
def test_ssh_by_https(url: str, expected: str) -> None:
    assert fetching.by_https(url) == expected


def test_pointers_are_known_and_told(tmp_path: Path) -> None:
    root = tmp_path / "checkout"
    text = "version https://git-lfs.github.com/spec/v1\noid sha256:" + "0" * 64 + "\nsize 12345\n"
    repository(root, {"weights.bin": text, "small.txt": "version"})
    assert fetching.pointers(root) == ("weights.bin",)
    with fetching.git(fetching.Access()) as tool:
        left, why = fetching.large_files(tool, root)
    assert left == ("weights.bin",)
    assert why  # no git-lfs here, or nowhere to fetch from


@pytest.mark.parametrize("server", [Smart], indirect=True)
def test_tags_of_a_shallow_checkout(tmp_path: Path, server: str) -> None:
    origin = tmp_path / "served/origin"
    (tmp_path / "served/gitconfig").write_text("[safe]\n\tdirectory = *\n[uploadpack]\n\tallowFilter = true\n")
    repository(origin, {"old.txt": "only in history"})
    old = git(origin, "rev-parse", "HEAD:old.txt").strip()
    git(origin, "tag", "v1.2.0")
    git(origin, "rm", "--quiet", "old.txt")
    git(origin, "commit", "--quiet", "--allow-empty", "--message", "later")
    git(tmp_path, "clone", "--quiet", "--depth", "1", "--no-tags", f"{server}/origin/.git", "checkout")
    root = tmp_path / "checkout"
    assert describe(root) is None
    with fetching.git(fetching.Access()) as tool:
        assert fetching.tags(tool, root) == ""
    assert describe(root) == ("v1.2.0", 1)
    objects = git(root, "cat-file", "--batch-all-objects", "--batch-check")
    assert old not in objects, "the history's files are not fetched"


def test_required_submodules_stop_the_plan(tmp_path: Path) -> None:
    for name, text in {
        ".gitmodules": '[submodule "lib"]\n\tpath = lib\n\turl = https://example.org/lib.git\n',
        "main.py": "print(1)\n",
        "requirements.txt": "numpy\n",
        "roslab.yaml": "format: 3\nsubmodules: required\n",
    }.items():
        (tmp_path / name).write_text(text)
    with pytest.raises(ConfigurationError, match=r"\.gitmodules:\d: `submodules: required`: .*lib"):
        plan_repository(tmp_path)
    (tmp_path / "lib").mkdir()
    (tmp_path / "lib/lib.py").write_text("")
    assert plan_repository(tmp_path).plan.kind == "python"


@pytest.mark.parametrize("server", [Smart], indirect=True)
@pytest.mark.parametrize(
    ("ref", "text", "tag"),
    [("v1.2.0", "old", True), ("side", "side", False), ("COMMIT", "old", False), ("main", "new", False)],
)
def test_an_old_commit_is_checked_out(tmp_path: Path, server: str, ref: str, text: str, tag: bool) -> None:
    origin = tmp_path / "served/origin"
    (tmp_path / "served/gitconfig").write_text("[safe]\n\tdirectory = *\n[uploadpack]\n\tallowAnySHA1InWant = true\n")
    old = repository(origin, {"a.txt": "old"})
    git(origin, "tag", "v1.2.0")
    git(origin, "checkout", "--quiet", "-b", "side")
    (origin / "a.txt").write_text("side")
    git(origin, "commit", "--quiet", "--all", "--message", "side")
    git(origin, "checkout", "--quiet", "main")
    (origin / "a.txt").write_text("new")
    git(origin, "commit", "--quiet", "--all", "--message", "new")
    git(tmp_path, "clone", "--quiet", "--depth", "1", "--no-tags", f"{server}/origin/.git", "checkout")
    root = tmp_path / "checkout"
    with fetching.git(fetching.Access()) as tool:
        assert fetching.checkout(tool, root, old if ref == "COMMIT" else ref) == ""
        assert (root / "a.txt").read_text() == text
        assert is_tag(root, ref) == tag
        assert fetching.checkout(tool, root, "v9") != ""
        for hostile in ("--upload-pack=touch /tmp/x", "refs/pull/7/head", "pull/7/head", "a..b", "a b"):
            assert fetching.checkout(tool, root, hostile) == "it is not a commit, git tag or branch"
    assert (root / "a.txt").read_text() == text
