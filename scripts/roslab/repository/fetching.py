"""Fetching what a checkout lacks: submodules, large files, tags; what cannot be fetched is reported.

Git runs with a configuration of its own: it fetches by https, by http (safe, because a commit's hash proves its
content) and, with a key, by ssh; it runs no hooks and no program but ssh. .gitmodules can only give addresses.
"""

from __future__ import annotations

import base64
import os
import re
import shutil
import subprocess
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from roslab.repository.lfs import LARGEST_POINTER, POINTER
from roslab.values.dataclass import dataclass
from roslab.values.pattern import pattern

SECONDS = 900.0
"""How long one submodule may take."""
MOST = 300
"""Most submodules, nested ones included."""
DEEPEST = 8
REF = pattern(r"[A-Za-z0-9_][\w./+-]{0,199}")
SSH = (
    re.compile(r"ssh://(?:[\w.-]+@)?(?P<host>[\w.-]+)(?::\d+)?/"),
    re.compile(r"[\w.-]+@(?P<host>[\w.-]+):(?!/)"),
)
"""Addresses of ssh up to their path."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Access:
    """Credentials for private addresses."""

    server: str = "https://github.com"
    """Address of the server that gets the token; it is sent to no other."""
    token: str = ""
    key: str = ""
    """A private key for ssh; without one, https is used instead."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Missing:
    """A submodule that could not be fetched."""

    path: str
    url: str
    reason: str


@dataclass(frozen=True, kw_only=True, slots=True)
class Git:
    """Git with a configuration file of its own."""

    configuration: Path
    by_ssh: bool

    def run(self, root: Path, *words: str, seconds: float = SECONDS) -> subprocess.CompletedProcess[str]:
        """Run a git command in a folder; exit code 124 if it took too long."""
        environment = {
            **os.environ,
            "GIT_CONFIG_GLOBAL": str(self.configuration),
            "GIT_ALLOW_PROTOCOL": "https:http:ssh" if self.by_ssh else "https:http",
            "GIT_TERMINAL_PROMPT": "0",
            "GIT_LITERAL_PATHSPECS": "1",
            "GIT_LFS_SKIP_SMUDGE": "1",
        }
        # A folder of the tree can hold the files of a bare repository, whose configuration names programs
        settings = (f"core.hooksPath={os.devnull}", "core.fsmonitor=false", "safe.bareRepository=explicit")
        quiet = [word for setting in settings for word in ("-c", setting)]
        command = ["git", "--no-pager", "-C", str(root), *quiet, *words]
        try:
            return subprocess.run(
                command, capture_output=True, stdin=subprocess.DEVNULL, env=environment, text=True, errors="replace",
                timeout=seconds, check=False,
            )  # fmt: skip
        except subprocess.TimeoutExpired:
            return subprocess.CompletedProcess(command, 124, "", f"no end after {seconds:.0f} s")


@contextmanager
def git(access: Access) -> Iterator[Git]:
    """Yield a git that may fetch; its credentials are in a private folder that is removed afterwards."""
    with tempfile.TemporaryDirectory(prefix="roslab-git-") as name:
        folder = Path(name)
        lines = [f"[include]\n\tpath = {Path.home()}/.gitconfig"] if (Path.home() / ".gitconfig").is_file() else []
        lines += ["[safe]\n\tdirectory = *", "[fetch]\n\trecurseSubmodules = false", "[submodule]\n\trecurse = false"]
        lines += [f"[core]\n\thooksPath = {os.devnull}\n\tfsmonitor = false"]
        if access.token:
            word = base64.b64encode(f"x-access-token:{access.token}".encode()).decode()
            lines.append(f'[http "{access.server}/"]\n\textraheader = AUTHORIZATION: basic {word}')
        if access.key:
            key = folder / "key"
            key.touch(mode=0o600)
            key.write_text(access.key.strip() + "\n", encoding="utf-8")
            options = "-o IdentitiesOnly=yes -o BatchMode=yes -o StrictHostKeyChecking=accept-new"
            command = f"ssh -F /dev/null -i '{key}' {options} -o UserKnownHostsFile='{folder}/hosts'"
            lines.append(f'[core]\n\tsshCommand = "{command}"')
        file = folder / "config"
        file.touch(mode=0o600)
        file.write_text("\n".join(lines) + "\n", encoding="utf-8")
        yield Git(configuration=file, by_ssh=bool(access.key))


def checkout(git: Git, root: Path, ref: str) -> str:
    """Check out a commit, a git tag or a branch of the origin; return why that failed, ``""`` on success.

    A git tag also exists in the checkout afterwards. LFS files stay pointers.
    """
    if not REF.fullmatch(ref) or ref.startswith(("-", "refs/", "pull/")) or ".." in ref:
        return "it is not a commit, git tag or branch"
    tag = f"refs/tags/{ref}"
    commit, why = "", ""
    for asked in (f"+{tag}:{tag}", ref):
        answer = git.run(root, "fetch", "--quiet", "--depth", "1", "--no-tags", "origin", asked)
        if answer.returncode == 0:
            commit = tag if asked != ref else "FETCH_HEAD"
            break
        why = _bare(_why(answer.stderr))
    for name in (commit, tag, f"refs/remotes/origin/{ref}", ref):
        if name and git.run(root, "rev-parse", "--quiet", "--verify", f"{name}^{{commit}}").returncode == 0:
            answer = git.run(root, "checkout", "--quiet", "--force", "--detach", f"{name}^{{commit}}")
            return _bare(_why(answer.stderr)) if answer.returncode else ""
    return why or "the origin has none of that name"


def submodules(git: Git, root: Path, *, part: str = "", above: str = "", depth: int = 0) -> tuple[Missing, ...]:
    """Fetch the submodules of a checkout one by one, nested ones too; return those that are still missing.

    ``part`` is the folder of the checkout to fetch for, ``""`` for all of it.
    """
    missing: list[Missing] = []
    for path, name in _entries(git, root)[:MOST]:
        if part and not f"{path}/".startswith(f"{part}/"):
            continue
        place = root / path
        shown = f"{above}{path}"
        if place.resolve() != root.resolve() / path:
            missing.append(Missing(path=shown, url="", reason="a link is in its way"))
            continue
        if not (place / ".git").exists():
            url = git.run(root, "config", "--file", ".gitmodules", "--get", f"submodule.{name}.url").stdout.strip()
            if reason := _fetch(git, root, path, name, url):
                missing.append(Missing(path=shown, url=_bare(url), reason=_bare(reason)))
                continue
        if depth < DEEPEST and (place / ".git").exists():
            missing += submodules(git, place, above=f"{shown}/", depth=depth + 1)
    return tuple(missing)


def _entries(git: Git, root: Path) -> list[tuple[str, str]]:
    """Return path and name of each submodule that the commit has and .gitmodules names."""
    file = root / ".gitmodules"
    if file.is_symlink() or not file.is_file():
        return []
    said = git.run(root, "config", "--file", ".gitmodules", "--null", "--get-regexp", r"^submodule\..*\.path$").stdout
    pairs = [entry.partition("\n") for entry in said.split("\0") if entry]
    names = {path: key.removeprefix("submodule.").removesuffix(".path") for key, _, path in pairs}
    listed = git.run(root, "ls-files", "--stage", "-z").stdout.split("\0")
    links = [line.partition("\t")[2] for line in listed if line.startswith("160000 ")]
    return [(path, names[path]) for path in links if path in names]


def _fetch(git: Git, root: Path, path: str, name: str, url: str) -> str:
    """Fetch one submodule; return why it failed, ``""`` on success. A failed fetch leaves nothing behind."""
    reason = ""
    for address in dict.fromkeys([url, by_https(url)] if git.by_ssh else [by_https(url)]):
        # Some servers give single commits, others only whole histories
        for shallow in (["--depth", "1"], []):
            git.run(root, "submodule", "init", "--", path)
            if address != url:
                git.run(root, "config", f"submodule.{name}.url", address)
            answer = git.run(root, "submodule", "update", "--checkout", *shallow, "--", path)
            if answer.returncode == 0:
                return ""
            reason = reason or _why(answer.stderr)
            git.run(root, "submodule", "deinit", "--force", "--", path)
            folder = git.run(root, "rev-parse", "--git-path", f"modules/{name}").stdout.strip()
            if name.strip("./") and folder and ".." not in folder.split("/"):  # else it is the folder of all of them
                shutil.rmtree(root / folder, ignore_errors=True)
    return reason or "git does not say why"


def by_https(url: str) -> str:
    """Return an address that needs no key: https for ssh and for git's own protocol, which hosts have dropped."""
    if match := SSH[0].match(url) or SSH[1].match(url):
        return f"https://{match['host']}/{url[match.end() :]}"
    return re.sub(r"^git://", "https://", url)


def _why(text: str) -> str:
    """Return the line of git's output that says why: the first that a remote or git calls fatal."""
    lines = [line.strip() for line in text.splitlines() if line.strip()]
    said = next((line for line in lines if line.startswith(("fatal: ", "remote: ", "error: "))), "")
    return said or (lines[-1] if lines else "")


def _bare(text: str) -> str:
    """Return a text without the passwords in its addresses."""
    return re.sub(r"//[^/@\s]*@", "//", text)


def pointers(root: Path) -> tuple[str, ...]:
    """Return the files whose LFS content was not fetched, sorted, relative to the checkout."""
    found = []
    for place, folders, names in os.walk(root):
        folders[:] = [name for name in folders if name != ".git"]
        for name in names:
            path = Path(place) / name
            try:
                if path.is_symlink() or not 0 < path.stat().st_size <= LARGEST_POINTER:
                    continue
                with path.open("rb") as stream:
                    if stream.read(len(POINTER)) == POINTER:
                        found.append(str(path.relative_to(root)))
            except OSError:
                continue
    return tuple(sorted(found))


def large_files(git: Git, root: Path) -> tuple[tuple[str, ...], str]:
    """Fetch the content of LFS pointers, also in submodules; return the pointers that remain, and why."""
    before = pointers(root)
    if not before:
        return (), ""
    if git.run(root, "lfs", "version").returncode:
        return before, "git-lfs is not on this runner"
    reason = ""
    for folder in sorted({_top(root, path) for path in before}):
        answer = git.run(folder, "lfs", "pull")
        if answer.returncode:
            reason = reason or _bare(_why(answer.stderr))
    return pointers(root), reason


def _top(root: Path, path: str) -> Path:
    """Return the checkout that a file belongs to: its submodule, or the repository itself."""
    folders = (folder for folder in (root / path).parents if folder == root or (folder / ".git").exists())
    return next(folders, root)


def tags(git: Git, root: Path) -> str:
    """Fetch the tags and the commits since them, without their files; return why that failed, ``""`` on success."""
    if git.run(root, "describe", "--tags", "--match", "*[0-9]*").returncode == 0:
        return ""
    shallow = git.run(root, "rev-parse", "--is-shallow-repository").stdout.strip() == "true"
    deeper = ["--unshallow"] if shallow else []
    words = ["fetch", "--quiet", "--filter=tree:0", "--tags", *deeper, "origin"]
    answer = git.run(root, *words)
    return _bare(_why(answer.stderr)) if answer.returncode else ""
