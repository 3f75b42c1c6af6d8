"""Lists of sister repositories: .repos, .rosinstall, vcs files of any name, .gitman.yml, .gitmodules.

https://github.com/dirk-thomas/vcstool (``repositories:``), https://docs.ros.org/en/independent/api/rosinstall/html/
https://gitman.readthedocs.io/ (``sources:``)
"""

from __future__ import annotations

import re
import shlex
from collections.abc import Iterator, Sequence
from functools import cache

from roslab.evidence import git_modules, places
from roslab.evidence.dependency import GitSource
from roslab.evidence.fixtures import of_tests
from roslab.evidence.ros import handed_lists
from roslab.evidence.ros.stale_modules import elsewhere, fate, named
from roslab.knowledge.compiled import public_hosts
from roslab.repository.checkout import File, Repository, nearest
from roslab.values.dataclass import replace
from roslab.values.pattern import pattern

MAX_SIZE = 256 * 1024
MAX_OTHERS = 300
"""Most YAML files with other names that are opened, those nearest to the root first."""
_SUFFIX = pattern(r"\.(?:repos|rosinstall)$|^\.rosinstall$|[._]rosinstall$|\.repos\.(?:ya?ml|public)$")
_SUFFIXES = (".repos", ".rosinstall", ".yaml", ".yml", ".public")
_LOOKS = pattern(r"^repositories:[ \t]*(?:#.*)?$|^-[ \t]*(?:git|hg|svn|tar):", re.MULTILINE)
_INLINE = pattern(r"\b(?:url|uri)[ \t]*:", re.MULTILINE)
_SSH = pattern(r"^(?:ssh://)?(?:[\w.-]+@)([\w.-]+)(?::(?:\d+/)?|/)(.+)$")
_BEHIND = pattern(r"^https?://([\w.-]+)/(?:https?:/{1,2})?([\w.-]+)/(.+)$")
_LOGIN = pattern(r"^(https?://)[^/\s]+@([\w.-]+)(?=/)")
"""An address with a user name, which asks for that one's password where it has none."""
_SWITCHED_OFF = pattern(r"^git://(?=(?:github|gitlab|bitbucket)\.(?:com|org)/)")
_PLAIN_URL = pattern(r"^(?:https?|git|ssh)://|^[\w.-]+@[\w.-]+:")
_GITMAN = frozenset({".gitman.yml", "gitman.yml"})
"""Its list, at the root: https://gitman.readthedocs.io/"""
MAX_TOLD = 3
SHORTEST = 2
"""Parts of an address at a public host: the owner and the name."""


def read(repository: Repository) -> tuple[GitSource, ...]:
    """Return every repository that a list names, with https URLs; ``decide`` leaves out the repository itself."""
    found = [source for file in _files(repository) for source in _listed(repository, file)]
    found += _with_commits(repository, repository.once(_submodules))
    return tuple(found)


def _with_commits(repository: Repository, modules: tuple[GitSource, ...]) -> Iterator[GitSource]:
    """Mark the submodules that are not checked out, and give them the commits that the repository records.

    Without those that it has no more and that nothing names, or of which it has the repository elsewhere.
    """
    missing = tuple(module.name for module in modules if not _checked_out(repository, module))
    commits = repository.recorded(missing)
    gone = {name for name in missing if repository.committed and name not in commits}
    there = [module for module in modules if module.name not in gone]
    for module in modules:
        if module.name in gone and (not named(repository, module.name) or elsewhere(repository, module, there)):
            continue
        if module.name in missing:
            yield replace(module, absent=True, ref=commits.get(module.name, module.ref))
        else:
            yield module


def _checked_out(repository: Repository, module: GitSource) -> bool:
    folders = repository.folders
    return module.name in folders or any(folder.startswith(f"{module.name}/") for folder in folders)


def absent(repository: Repository) -> tuple[tuple[str, str, int], ...]:
    """Return ``(message, file, line)`` for submodules that are not checked out, whose content was not read.

    What the commit does not have is none by now, and no command of git brings it.
    """
    found: list[tuple[str, str, int]] = []
    lacking = [source for source in repository.once(_submodules) if not _checked_out(repository, source)]
    recorded = repository.recorded(tuple(source.name for source in lacking)) if repository.committed else None
    there = [source for source in lacking if recorded is None or source.name in recorded]
    left = [source for source in lacking if source not in there]
    others = [source for source in repository.once(_submodules) if source not in left]
    gone = {source: fate(repository, source, others) for source in left}
    if there:
        names = ", ".join(source.name for source in there)
        what = "a submodule is" if len(there) == 1 else "submodules are"
        message = f"{what} not checked out and could not be read: {names}; {_fetched(repository, there)}"
        found.append((message, there[0].file, there[0].line))
    message = "no submodule in this commit, though .gitmodules names it, so that its content was not read"
    for then in dict.fromkeys(gone.values()):
        some = [source for source in gone if gone[source] == then]
        names = ", ".join(source.name for source in some)
        found.append((f"{message}: {names}; {then}", some[0].file, some[0].line))
    return tuple(found)


def _fetched(repository: Repository, there: Sequence[GitSource]) -> str:
    """Return the command that fetches submodules: by name where git stops at one without an address in .gitmodules.

    One that was moved without its entry has its path written there first: git refuses any other.
    """
    unknown = [path for path in repository.links if path not in submodules(repository)]
    moved = [(f"submodule.{source.moved}.path", source.name) for source in there if source.moved]
    first = "".join(f"git config -f .gitmodules {shlex.join(each)} && " for each in moved)
    if not unknown:
        return f"{first}git submodule update --init --recursive"
    paths = " ".join(shlex.quote(source.name) for source in there)
    why = f".gitmodules has no address for {', '.join(unknown[:MAX_TOLD])}, which stays empty"
    return f"{first}git submodule update --init --recursive {paths} ({why})"


def submodules(repository: Repository) -> tuple[str, ...]:
    """Return the paths of the submodules that .gitmodules names, whether they are checked out or not."""
    return tuple(module.name for module in repository.once(_submodules))


def missing(repository: Repository) -> tuple[str, ...]:
    """Return the paths of the submodules that are not checked out."""
    return tuple(each.name for each in repository.once(_submodules) if not _checked_out(repository, each))


@cache
def https(url: str, origin: str | None = None) -> str:
    """Return a URL that anybody can clone: https in place of ssh and git, relative ones resolved against ``origin``.

    At a public host without a login: for a user name alone it asks for a password, and a password is nobody else's.
    Of somebody's proxy, whose address ends in that of a public host (``https://proxy.org/https://github.com/a/b``), the
    public address: such proxies come and go.
    """
    url = url.strip()
    login = _LOGIN.match(url)
    if login and login[2] in public_hosts():
        url = login[1] + url[login.start(2) :]
    behind = _BEHIND.match(url)
    if behind and behind[1] not in public_hosts() and behind[2] in public_hosts():
        return f"https://{behind[2]}/{behind[3]}"
    if url.startswith(("./", "../")) and origin:
        base = https(origin).rstrip("/").split("/")
        least = 3 if base[1:2] == [""] else 1  # the host stays, however many folders an address goes up
        for part in url.rstrip("/").split("/"):
            if part == "..":
                del base[max(least, len(base) - 1) :]
            elif part != ".":
                base.append(part)
        return "/".join(base)
    if url.startswith("git://"):
        return "https://" + url[6:]
    match = None if url.startswith(("http://", "https://")) else _SSH.match(url)
    return f"https://{match[1]}/{match[2]}" if match else url


def served(url: str) -> str:
    """Return an address under which a public host still answers: GitHub's ``git://`` is switched off.

    https://github.blog/2021-09-01-improving-git-protocol-security-github/, read 2026-11-26.
    """
    return _SWITCHED_OFF.sub("https://", url)


def of_user(url: str) -> bool:
    """Tell whether an address has somebody's login, as a host gives it to who may see a private repository."""
    return bool(_LOGIN.match(url.strip()))


def _files(repository: Repository) -> list[File]:
    files = [f for f in repository.suffixed(*_SUFFIXES) if 0 < f.size <= MAX_SIZE]
    files += [f for f in repository.named(".rosinstall") if 0 < f.size <= MAX_SIZE]
    files = [f for f in files if not of_tests(repository, f.path)]
    named = (f for f in files if _SUFFIX.search(f.name.lower()) or f.path in _GITMAN)
    found = {f.path: f for f in named if not places.vendored(f.path)}
    others = [f for f in files if f.path not in found and f.path.count("/") <= 2 and f.size <= 64 * 1024]
    handed = [f for f in handed_lists.files(repository) if f.path not in found and 0 < f.size <= MAX_SIZE]
    for file in (*nearest(others)[:MAX_OTHERS], *handed):
        if not file.path.startswith(".github/") and not places.vendored(file.path) and _is_list(repository, file):
            found[file.path] = file
    return [found[path] for path in sorted(found)]


def _is_list(repository: Repository, file: File) -> bool:
    """Tell whether a file of any name lists repositories."""
    text = repository.read(file)
    named = _LOOKS.search(text) and _INLINE.search(text) and ("://" in text or "git@" in text)
    return bool(named) and any(word in text for word in ("version", "type", "local-name"))


def _listed(repository: Repository, file: File) -> Iterator[GitSource]:
    from roslab.evidence.lex.yaml import load  # noqa: PLC0415 - few trees have one
    from roslab.evidence.ros import gitman  # noqa: PLC0415 - as above

    text = repository.read(file)
    data = load(text)
    entries = (
        list(gitman.entries(data) if file.path in _GITMAN else _vcstool(data))
        if isinstance(data, dict)
        else list(_rosinstall(data))
        if isinstance(data, list)
        else []
    )
    if any("${" in str(part) for entry in entries for part in entry):
        return  # a template that a script of the author fills in
    lists = gitman.lists(data) if file.path in _GITMAN else frozenset[str]()
    for name, url, ref in entries:
        if not isinstance(url, str) or not _PLAIN_URL.match(url.strip()) or nobodys(url):
            continue
        yield GitSource(
            name=name,
            url=https(url, repository.origin),
            ref=str(ref) if ref not in (None, "") else None,
            strength="declared",
            file=file.path,
            line=_line(text, url),
            kind="vcs",
            private=of_user(url),
            lists=name in lists,
            by_ssh=url.strip() if _SSH.match(url.strip()) and not url.strip().startswith("http") else "",
        )


def nobodys(url: str) -> bool:
    """Tell whether an address at a public host lacks the owner or the name: a template that nobody has filled in."""
    host, _, path = https(url).partition("://")[2].partition("/")
    return host in public_hosts() and len([part for part in path.removesuffix(".git").split("/") if part]) < SHORTEST


def _vcstool(data: dict[object, object]) -> Iterator[tuple[str, object, object]]:
    listed = data.get("repositories")
    if isinstance(listed, dict):
        for name, entry in listed.items():
            if isinstance(entry, dict) and entry.get("type", "git") == "git":
                yield str(name), entry.get("url"), entry.get("version")


def _rosinstall(data: list[object]) -> Iterator[tuple[str, object, object]]:
    for entry in data:
        inner = entry.get("git") if isinstance(entry, dict) else None
        if isinstance(inner, dict):
            url = inner.get("uri")
            yield (
                str(inner.get("local-name") or str(url).rpartition("/")[2].removesuffix(".git")),
                url,
                inner.get("version"),
            )


def _line(text: str, needle: str) -> int:
    index = text.find(needle)
    return text.count("\n", 0, index) + 1 if index >= 0 else 1


def _submodules(repository: Repository) -> tuple[GitSource, ...]:
    """Return each at the path where it lies: one may have been moved without its entry.

    That is the only path of its name at which the commit records a commit, where it records none at that of the entry.
    An entry of a folder in which others lie is left over from before they were added: git keeps none inside another.
    """
    entries = {module: name for name, module in _of_gitmodules(repository)} if repository.has(git_modules.FILE) else {}
    above = {module.name[:at] for module in entries for at, sign in enumerate(module.name) if sign == "/"}
    modules = tuple(module for module in entries if module.name not in above)
    named = {module.name for module in modules}
    moved: dict[str, str] = {}
    for module in modules:
        name = f"/{module.name}".rpartition("/")[2]
        empty = [path for path in repository.listing.empty if f"/{path}".endswith(f"/{name}")]
        others = [path for path in empty if path not in named]
        if len(others) == 1 and module.name not in empty and not _checked_out(repository, module):
            moved[module.name] = others[0]
    recorded = repository.recorded((*moved, *moved.values())) if moved else {}
    there = {new: old for old, new in moved.items() if new in recorded and old not in recorded}
    there = {old: new for new, old in there.items()}
    return tuple(replace(m, name=there[m.name], moved=entries[m]) if m.name in there else m for m in modules)


def _of_gitmodules(repository: Repository) -> Iterator[tuple[str, GitSource]]:
    """Yield each after its entry's name; only the .gitmodules at the root counts: nested ones are of copied trees."""
    for each in git_modules.entries(repository.read(git_modules.FILE)):
        if each.url:
            module = GitSource(
                name=each.path,
                url=https(each.url, repository.origin),
                ref=each.branch or None,
                strength="declared",
                file=git_modules.FILE,
                line=each.line,
                kind="submodule",
                private=of_user(each.url),
            )
            yield each.name, module
