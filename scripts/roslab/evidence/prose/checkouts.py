"""What ``git clone`` fetches, and what ``git checkout``, ``git switch`` and ``git reset --hard`` take of it.

https://git-scm.com/docs/git-checkout, https://git-scm.com/docs/git-switch, https://git-scm.com/docs/git-reset
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence

from roslab.evidence.dependency import GitSource
from roslab.evidence.lex.shell import UNKNOWN, Command
from roslab.evidence.prose import workspaces
from roslab.evidence.ros.vcs import of_user, served
from roslab.knowledge.compiled import public_hosts
from roslab.values.pattern import pattern

_TAKES = frozenset({"checkout", "switch"})
_NEW = frozenset({"-b", "-B", "-c", "-C", "--orphan", "--create"})
"""Options that are followed by the name of a branch that is made here: the repository has none of that name."""
COMMIT = pattern(r"[0-9a-f]{7,40}")
_URL = pattern(r"^(?:https?://|git://|ssh://|git@)[^\s/]+[/:]\S+$")
_OWN_TOKEN = pattern(rf"^(https?://)[^/\s@{UNKNOWN}<]{{0,200}}[{UNKNOWN}<][^/\s@]{{0,200}}@")
"""The start of an address in which the reader writes a token: ``https://$TOKEN@github.com/a/b``."""
_OWNER = pattern(r"^(?:\w+://)?(?:git@)?([\w.-]+)[/:][^\s/:]+/?$")
_REF = pattern(r"(?:\w|\{distro\})(?:[\w./-]|\{distro\}){0,200}")


def checked_out(words: Sequence[str]) -> str | None:
    """Return the branch, tag or commit that a command of git takes, ``""`` for none, ``None`` for another command.

    Files that are taken from a commit (``git checkout 1.2 -- file``) are none.
    """
    inside = words[1:2] == ("-C",)  # git -C FOLDER checkout …
    name, rest = words[3:4] if inside else words[1:2], words[4:] if inside else words[2:]
    if {*name} == {"reset"} and "--hard" in rest:
        return next((word for word in rest if COMMIT.fullmatch(word)), None)
    if not (rest and {*name} & _TAKES):
        return None
    made = {index + 1 for index, word in enumerate(rest) if word in _NEW}
    ref = next((word for index, word in enumerate(rest) if index not in made and not word.startswith("-")), "")
    if "--" in rest or not _REF.fullmatch(ref):
        return ""
    return ref.removeprefix("tags/").removeprefix("origin/")


def cloned(command: Command, file: str, folder: str, heading: str, *, inside: bool) -> GitSource | None:
    """Return what a command of git clones, ``None`` for nothing; ``inside``: the text is in a folder of packages."""
    words = command.words
    addresses = ((word, _OWN_TOKEN.sub(r"\1", word)) for word in words if _URL.match(word))
    written, url = next((each for each in addresses if UNKNOWN not in each[1] and "<" not in each[1]), ("", ""))
    if not url or "clone" not in words or _of_owner(url):
        return None
    apart = [part for word in words for part in (word.split("=", 1) if word.startswith("--branch=") else (word,))]
    branch = next((apart[i + 1] for i, w in enumerate(apart[:-1]) if w in {"-b", "--branch"}), None)
    into, url = workspaces.folder_after(written, words, folder), served(url.rstrip(".,;)"))
    name = url.rstrip("/").rpartition("/")[2].rpartition(":")[2].removesuffix(".git")
    return GitSource(
        name=name,
        url=url,
        ref=None if branch is None or UNKNOWN in branch else branch,
        strength="prose",
        file=file,
        line=command.line,
        kind="clone",
        into="" if into == name else into,
        private=of_user(written),
        heading=heading,
        beside=workspaces.beside(words[-1] if words[-1] not in {written, url} else "", inside=inside),
    )


def _of_owner(url: str) -> bool:
    """Tell whether an address on a host of public code ends with the name of an owner: the page has a part left out."""
    match = _OWNER.match(url)
    return match is not None and match[1] in public_hosts()


def called_in(words: Sequence[str], folder: str, sources: Sequence[GitSource]) -> int | None:
    """Return the index of the source in whose folder git is called, by ``-C`` or after ``cd``, ``None`` for none."""
    inside = words[2] if words[1:2] == ("-C",) else folder
    return clone_at(inside.rstrip("/").split("/")[-1:], sources)


def clone_at(folders: Iterable[str], sources: Sequence[GitSource]) -> int | None:
    """Return the index of the last source that one of the folders is named after, by where it lies, ``None`` for none.

    ``opencv-4.5`` and ``OpenCV`` are folders of ``opencv``, the first one of an archive of 4.5: git writes no number
    behind the name of a clone.
    """
    names = {_plain(folder) for folder in folders}
    for index in range(len(sources) - 1, -1, -1):
        name, ref = _plain(sources[index].folder), _plain(sources[index].ref or "")
        more = [each.removeprefix(f"{name}_") for each in names if each.startswith(f"{name}_")]
        if name in names or any(not each[:1].isdigit() or each in ref for each in more):
            return index
    return None


def titled(heading: str, sources: Sequence[GitSource]) -> int | None:
    """Return the index of the last source where it was cloned in the section of its own name, ``None`` elsewhere.

    What is done there is done in its folder, also where nobody writes ``cd``.
    """
    if not sources or sources[-1].heading != heading:
        return None
    return len(sources) - 1 if _plain(heading.rpartition(" / ")[2]) == _plain(sources[-1].name) else None


def _plain(name: str) -> str:
    return re.sub(r"[-_.]+", "_", name).lower()
