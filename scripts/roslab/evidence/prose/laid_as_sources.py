"""Signs that the repository itself is the ``src`` of its author's workspace: ``docker run -v "$(pwd)":/ws/src``."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator

from roslab.evidence import places
from roslab.evidence.facts import Mention
from roslab.evidence.prose.pages import pages, text_of
from roslab.evidence.ros.own_setup import of_root
from roslab.repository.checkout import File, Repository, nearest
from roslab.values.endings import SHELL_SCRIPTS
from roslab.values.pattern import pattern

MAX_SIZE = 64 * 1024
MOST = 60
"""Files that are read."""
MOST_NAMED = 40
"""Most paths below the mounted folder that are kept."""
_COMPOSED = ("compose.yaml", "compose.yml", "docker-compose.yaml", "docker-compose.yml")
_MOUNTED = pattern(
    r"(?:(?:-v|--volume)[ \t=]+|^[ \t]*-[ \t]+)[\"']?"
    r"(\.{0,2}(?:\$\{?\w+\}?|\$\([^()\n]{1,60}\)|`pwd`|[\w.-]+)?(?:/[\w.-]+|/)*)[\"']?:(/[\w./-]{1,80}?)/src/?(?::\w+)?"
    r"(?=[\"'\s\\]|$)",
    re.MULTILINE,
)
"""A folder of the host, and the folder whose ``src`` it becomes in a container."""
_HERE = pattern(r"\$\(pwd\)|\$\{?PWD\}?|`pwd`|\.")
_VARIABLE = pattern(r"\$\{?(\w+)\}?((?:/\.\.)*)/?")
_ABOVE = pattern(r"/\.\.(?![\w.])")
_BUILDS = (
    r"(?:\bcd|\bWORKDIR|-w|--workdir)[ \t=]+{}/?(?![\w/.-])[\s\S]{{0,400}}?"
    r"\b(?:catkin_make|catkin[ \t]+build|colcon[ \t]+build)\b"
)
_CALLED = r"\b(?:catkin_make|colcon[ \t]+build)\b[^\n]{{0,80}}?(?:-C|--directory|--base-paths)[ \t=]+{}/?(?![\w/.-])"
_TOOL = pattern(r"\bcatkin_make\b|\bcatkin[ \t]+build\b|\bcolcon[ \t]+build\b")
_CLONED = r"\bgit[ \t]+clone\b[^\n]{{0,120}}?/{}(?:\.git)?[\"']?[ \t]+(?:[\w./~$-]*/)?src/?[ \t]*$"
_INITIALISED = pattern(r"^/CMakeLists\.txt[ \t]*$", re.MULTILINE)
"""``catkin_make`` links this file into the ``src`` of a workspace, which git shall not keep."""


def read(repository: Repository) -> Iterator[Mention]:
    """Yield the first sign of each kind; the value is the author's workspace, ``""`` where only its ``src`` is known.

    The files of a sign are those that pages name below the workspace's ``src``, as in a container.
    """
    if repository.has("package.xml"):
        return
    texts = [(page, text_of(repository, page)) for page in pages(repository)]
    scripts = (*repository.suffixed(*SHELL_SCRIPTS), *repository.named(*_COMPOSED))
    near = nearest(file for file in scripts if file.size <= MAX_SIZE and not places.vendored(file.path))[:MOST]
    texts += [(file, repository.read(file)) for file in near if file not in {page for page, _ in texts}]
    if found := _mounted(repository, texts):
        yield found
    if repository.has(".gitignore") and (match := _INITIALISED.search(text := repository.read(".gitignore"))):
        yield _sign("", ".gitignore", text, match)
    cloned = re.compile(_CLONED.format(re.escape(repository.name)), re.MULTILINE | re.IGNORECASE)
    for page, text in texts:
        match = cloned.search(text) if page.path.endswith(".md") and "clone" in text else None
        if match and _TOOL.search(text, match.end()):
            yield _sign("", page.path, text, match)
            return


def _mounted(repository: Repository, texts: list[tuple[File, str]]) -> Mention | None:
    """Return where the root is mounted as the ``src`` of a folder in which something builds a workspace."""
    for file, text in texts:
        for match in _MOUNTED.finditer(text) if "/src" in text else ():
            above = posixpath.normpath(match[2])
            if _is_root(file, text, match[1]) and any(_builds(above, other) for _, other in texts):
                named = _named(repository, f"{above}/src/", (other for _, other in texts))
                return _sign(above, file.path, text, match, files=tuple(named))
    return None


def _is_root(file: File, text: str, host: str) -> bool:
    """Tell whether a folder of the host is the root of the repository."""
    depth = file.path.count("/")
    if file.name in _COMPOSED:
        return host.startswith(".") and posixpath.normpath(posixpath.join(file.folder, host)) == "."
    if _HERE.fullmatch(host.rstrip("/")):
        return not depth
    found = _VARIABLE.fullmatch(host)
    return found is not None and of_root(text, found[1], depth - len(_ABOVE.findall(found[2])))


def _builds(folder: str, text: str) -> bool:
    ways = (each.format(re.escape(folder)) for each in (_BUILDS, _CALLED))
    return folder in text and any(re.search(way, text) for way in ways)


def _named(repository: Repository, below: str, texts: Iterator[str]) -> Iterator[str]:
    """Yield the files of the tree that pages name below the mounted folder."""
    path = re.compile(rf"(?<![\w.~-]){re.escape(below)}([\w./-]*\w)")
    found = dict.fromkeys(match[1] for text in texts for match in path.finditer(text))
    yield from [each for each in found if repository.has(each) or each in repository.folders][:MOST_NAMED]


def _sign(value: str, file: str, text: str, match: re.Match[str], files: tuple[str, ...] = ()) -> Mention:
    line = text.count("\n", 0, match.start() + len(match[0]) - len(match[0].lstrip())) + 1
    said = match[0].strip()[:120]
    return Mention(topic="as_sources", value=value, source="script", file=file, line=line, text=said, files=files)
