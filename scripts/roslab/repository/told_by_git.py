"""What git tells of a checkout: its commit, branches and remote, which change without any file of the tree."""

from __future__ import annotations

import os
import re
from collections.abc import Mapping
from functools import cached_property
from typing import TYPE_CHECKING, Any, TypeVar

from roslab.repository import git
from roslab.repository.reading import text_of
from roslab.values.kept_file import stamp
from roslab.values.pattern import pattern

if TYPE_CHECKING:
    import datetime as dt
    from pathlib import Path

_HEAD = pattern(r"ref: refs/heads/(.+)")
_ORIGIN = pattern(r'\[remote "origin"\][^\[]*?\burl\s*=\s*(\S+)')
_BRANCH = pattern(r"ref: (refs/(?!.*\.\.)[^\s]+)\s*\Z")
_COMMIT = pattern(r"[0-9a-f]{40,64}\s*\Z")
_OF_COMMIT = frozenset({"committed", "links", "recorded"})
"""What a commit alone tells."""
_SHOWN_BY = ("config", "packed-refs", "shallow", "info/grafts", "refs/replace")
"""Files of git's that tell which commit a branch is at, or put others in its place."""
Answer = TypeVar("Answer")


class _told(cached_property[Answer]):  # noqa: N801 - used as a decorator
    """A property that is asked for once, and noted with its answer."""

    def __get__(self, instance: Any, owner: Any = None) -> Any:
        """Return the answer; from the second time on Python does not come here."""
        answer = super().__get__(instance, owner)
        if instance is not None:
            instance.told[(self.attrname,)] = answer
        return answer


class ToldByGit:
    """What git tells of a folder; ``told`` holds each question that was asked so far with its answer."""

    path: str
    branch_hint: str | None
    top: Path | None
    told: dict[tuple[Any, ...], Any]

    @property
    def folder_name(self) -> str:
        """The folder's name."""
        return self.path.rpartition("/")[2]

    def tells(self, answers: Mapping[tuple[Any, ...], Any]) -> bool:
        """Tell whether git gives the same answers again, which were ``told`` in another run.

        What a commit says of itself it says again: to ask for it takes longer than all the rest.
        """
        same = bool(answers.get(("committed",)) and answers.get(("checkout",)) == self.checkout)
        asked = {question: answer for question, answer in answers.items() if not (same and question[0] in _OF_COMMIT)}
        return all(self._answer(*question) == answer for question, answer in asked.items())

    @property
    def answered(self) -> bool:
        """Whether git answered in time whatever was asked of this folder."""
        return self.path not in git.unanswered

    def _answer(self, name: str, *about: Any) -> Any:
        answer = getattr(self, name)
        return answer(*about) if about else answer

    @cached_property
    def git_folder(self) -> str | None:
        """The git directory of the checkout: ``.git`` itself, or where a ``.git`` file points to."""
        entry = f"{self.top or self.path}/.git"
        if os.path.isdir(entry):  # noqa: PTH112 - as above
            return entry
        if os.path.isfile(entry) and (match := re.match(r"gitdir: (.+)", text_of(entry))):  # noqa: PTH113
            return os.path.realpath(os.path.join(self.top or self.path, match[1].strip()))  # noqa: PTH118
        return None

    @_told
    def checkout(self) -> tuple[Any, ...] | None:
        """Return what in git's files tells the commit of the checkout; ``None`` where it is not told there."""
        folder = self.git_folder or ""
        common = os.path.join(folder, text_of(f"{folder}/commondir").strip())  # noqa: PTH118 - of a worktree
        head = self._git_text("HEAD")
        match = _BRANCH.match(head)
        stamps = tuple(stamp(os.path.join(common, name)) for name in _SHOWN_BY)  # noqa: PTH118
        at = text_of(os.path.join(common, match[1])) if match else head  # noqa: PTH118
        packed = match and not at and stamps[_SHOWN_BY.index("packed-refs")]
        return (head, at, stamps) if packed or _COMMIT.match(at) else None

    @_told
    def branch(self) -> str | None:
        """Name of the branch: as the caller gave it, else from ``.git/HEAD``, ``None`` if that is detached."""
        if self.branch_hint:
            return self.branch_hint
        head = self._git_text("HEAD")
        return match[1].strip() if (match := _HEAD.match(head)) else None

    @_told
    def branches(self) -> tuple[str, ...]:
        """Return the names of the branches that git knows, those of remotes too."""
        return git.branches(self.path) if self.git_folder else ()

    @_told
    def origin(self) -> str | None:
        """URL of the remote ``origin``, as ``.git/config`` has it."""
        match = _ORIGIN.search(self._git_text("config"))
        return match[1] if match else None

    @cached_property
    def name(self) -> str:
        """Its name in the origin's URL, else the folder's: on a runner the folder may be called anything."""
        return self.origin.rstrip("/").rpartition("/")[2].removesuffix(".git") if self.origin else self.folder_name

    @_told
    def committed(self) -> dt.datetime | None:
        """Time of the checkout's commit in UTC; ``None`` if there is no commit or no git."""
        seconds = git.head(self.path)[1] if self.git_folder else None
        if seconds is None:
            return None
        import datetime as dt  # noqa: PLC0415 - slow to import, and most plans do without

        return dt.datetime.fromtimestamp(seconds, tz=dt.timezone.utc)

    def recorded(self, paths: tuple[str, ...]) -> dict[str, str]:
        """Return the commit that the checkout's commit records for each submodule at one of the paths, if git tells."""
        question = ("recorded", tuple(sorted(paths)))  # several readers ask for the same ones
        if question not in self.told:
            self.told[question] = git.recorded(self.path, question[1]) if paths and self.git_folder else {}
        found: dict[str, str] = self.told[question]
        return found

    @_told
    def links(self) -> tuple[str, ...]:
        """Return the paths of the submodules that the checkout's commit records, if git tells."""
        return git.links(self.path) if self.git_folder else ()

    def subjects(self, path: str) -> tuple[str, ...]:
        """Return the subjects of the commits that changed a file, the newest first, if git tells."""
        found = git.subjects(self.path, path) if self.git_folder else ()
        self.told["subjects", path] = found
        return found

    def _git_text(self, name: str) -> str:
        return text_of(f"{self.git_folder}/{name}") if self.git_folder else ""
