"""Lists of repositories that pages and scripts hand to wstool, rosinstall or vcs, whatever these files are called.

https://docs.ros.org/en/independent/api/rosinstall/html/ and https://github.com/dirk-thomas/vcstool, 2026-11-27
"""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator, Mapping
from typing import Literal

from roslab.evidence import places
from roslab.evidence.facts import Mention
from roslab.evidence.lex.lines import matching_lines
from roslab.repository.checkout import File, Repository, nearest
from roslab.values.pattern import pattern

MAX_SIZE = 128 * 1024
MAX_READ = 200
"""Most pages and scripts that are opened, those nearest to the root first."""
_Source = Literal["readme", "dockerfile", "script", "ci"]
_SOURCES: dict[str, _Source] = {
    ".md": "readme",
    ".markdown": "readme",
    ".rst": "readme",
    ".sh": "script",
    ".bash": "script",
    ".dockerfile": "dockerfile",
}
_HANDED = pattern(
    r"(?P<before>[^\n]*?)(?<![\w-])(?:(?:wstool|rosws)\s+(?:init|merge)|rosinstall|vcs\s+import)\s(?P<rest>[^\n;&|#`]*)"
)
_WORD = pattern(r"(?:[^\s\"'<>=]*/)?(?P<name>\.?[\w][\w.+-]*)/?(?=[\s\"'<>)]|$)")
_SET = pattern(
    r"(?:^|[ \t])(?:ARG[ \t]+|ENV[ \t]+|export[ \t]+)?([A-Za-z_]\w*)=[\"']?([\w./-]+)[\"']?[ \t]*$", re.MULTILINE
)
"""What a script or a Dockerfile sets."""
_EITHER = pattern(r"([^\s\[\]]*)\[([\w.-]{1,40})\]([^\s\[\]]*)")
"""What stands for two names: ``robot[-sim].rosinstall``."""
_VARIABLE = pattern(r"\$\{?([A-Za-z_]\w*)(?:\}|(?![\w}]))")
_USUAL = (".repos", ".rosinstall")
"""Lists of these names are known without a command."""
_SET_IN_CI = pattern(r"^[ \t-]*([A-Z_]\w*):[ \t]*[\"']?([\w./-]+)[\"']?[ \t]*$", re.MULTILINE)
_FETCHED = pattern(r"https?://[^\s\"'`<>()|;&]{1,200}")
_TREEP = pattern(r"(?:^|[\s`$;&])treep\s+--clone(?:-https|-ssh)?\s+\w")
_OF_TREEP = pattern(r"\bgit\s+clone\s[^\n]{0,200}?[/:](treep_[\w-]{1,60})(?:\.git)?(?=[\s`;&]|$)")
"""A repository with treep's lists, which are called ``repositories*.yaml``: PyPI: treep, 2026-11-29."""


def files(repository: Repository) -> tuple[File, ...]:
    """Return the files of the tree to which such a command points: the path that it gives ends like theirs."""
    return tuple(dict.fromkeys(file for file, _ in repository.once(_handed)))


def read(repository: Repository) -> tuple[Mention, ...]:
    """Return a mention for each command with a list of a name by which no list is known, or that the tree has not."""
    ours = (mention for file, mention in repository.once(_handed) if not file.name.lower().endswith(_USUAL))
    return (*ours, *_elsewhere(repository))


def _elsewhere(repository: Repository) -> tuple[Mention, ...]:
    """Return a mention for each path or address that such a command names and the tree does not have, filled in.

    What a script, a Dockerfile or a file of CI sets itself is filled in: ``$HOME/lists/$FILE`` with ``ARG
    FILE=a.rosinstall``. A name alone is that of the first that the same text fetches: ``wget https://…/a.repos``.
    """
    dockerfiles = (name for name in repository.by_name if name.startswith("dockerfile"))
    ci = (*repository.suffixed(".yml", ".yaml"), *repository.named("Jenkinsfile"))
    ci = tuple(file for file in ci if places.ci(file.path))
    found = (*repository.suffixed(*_SOURCES), *repository.named(*dockerfiles), *ci)
    kept = (file for file in found if file.size <= MAX_SIZE and not places.vendored(file.path))
    return tuple(each for file in nearest(kept)[:MAX_READ] for each in _named_elsewhere(repository, file))


def _named_elsewhere(repository: Repository, file: File) -> Iterator[Mention]:
    text = repository.read(file)
    source: _Source = (
        "ci" if places.ci(file.path) else _SOURCES.get(posixpath.splitext(file.name.lower())[1], "dockerfile")
    )
    yield from _of_treep(text, file.path, source)
    values: dict[str, str] | None = None
    fetched: dict[str, str] = {}
    for match in matching_lines(_HANDED, text, "wstool", "rosws", "rosinstall", "vcs"):
        if "#" in match["before"] and source != "readme":
            continue
        if values is None:
            fetched = {posixpath.basename(url): url for url in reversed(_FETCHED.findall(text))}
            values = dict(reversed((*_SET.findall(text), *(_SET_IN_CI.findall(text) if source == "ci" else ()))))
        for word in _lists_of(_filled(match["before"], values), _filled(match["rest"], values), fetched):
            if not repository.named(posixpath.basename(word)):
                line = text.count("\n", 0, match.start("rest")) + 1
                yield Mention(
                    topic="handed", value=word, source=source, file=file.path, line=line, text=match[0].strip()
                )


def _of_treep(text: str, file: str, source: _Source) -> Iterator[Mention]:
    """Yield a mention for each repository of lists that a text clones for treep, which fills a workspace from them."""
    if "treep" not in text or not _TREEP.search(text):
        return
    for match in _OF_TREEP.finditer(text):
        line, value = text.count("\n", 0, match.start(1)) + 1, f"{match[1]}/repositories.yaml"
        yield Mention(topic="handed", value=value, source=source, file=file, line=line, text=match[0].strip())


def _lists_of(before: str, after: str, fetched: Mapping[str, str]) -> Iterator[str]:
    """Yield the lists that a command names, or has from what its text fetches, or pipes to it."""
    words = [word.strip("\"'") for word in _EITHER.sub(r"\1\3 \1\2\3", after).split()]
    if before.rstrip().endswith("|"):
        words += _FETCHED.findall(before)
    for word in (each for each in words if each.endswith(_USUAL)):
        if "/" in word or word in fetched:
            yield word if "/" in word else fetched[word]


def _filled(command: str, values: Mapping[str, str]) -> str:
    """Return a command with the values that its text gives to variables, of several the first."""
    return _VARIABLE.sub(lambda found: values.get(found[1], found[0]), command)


def _handed(repository: Repository) -> tuple[tuple[File, Mention], ...]:
    return tuple(_found(repository))


def _found(repository: Repository) -> Iterator[tuple[File, Mention]]:
    found = (*repository.suffixed(*_SOURCES), *repository.named("Dockerfile"))
    kept = (file for file in found if file.size <= MAX_SIZE and not places.vendored(file.path))
    for file in nearest(kept)[:MAX_READ]:
        yield from _named(repository, file, _SOURCES.get(posixpath.splitext(file.name.lower())[1], "dockerfile"))


def _named(repository: Repository, file: File, source: _Source) -> Iterator[tuple[File, Mention]]:
    text = repository.read(file)
    for match in matching_lines(_HANDED, text, "wstool", "rosws", "rosinstall", "vcs"):
        if "#" in match["before"] and source != "readme":
            continue
        for word in _WORD.finditer(match["rest"]):
            if listed := _in_tree(repository, file, word[0].rstrip("/"), word["name"]):
                line = text.count("\n", 0, match.start("rest")) + 1
                said = Mention(
                    topic="vcs_file",
                    value=listed.name.lower(),
                    source=source,
                    file=file.path,
                    line=line,
                    text=match[0].strip(),
                )
                yield listed, said


def _in_tree(repository: Repository, file: File, path: str, name: str) -> File | None:
    """Return the file of that name whose path has most of the given one's last folders, beside the page before others.

    What stands before these is the folder of a workspace, a variable or an address.
    """
    parts = path.split("/")

    def likeness(found: File) -> tuple[int, bool, int]:
        own = found.path.split("/")
        shared = 0
        while shared < min(len(own), len(parts)) and own[-1 - shared] == parts[-1 - shared]:
            shared += 1
        return shared, found.folder == file.folder, -len(own)

    return max(repository.named(name), key=likeness, default=None)
