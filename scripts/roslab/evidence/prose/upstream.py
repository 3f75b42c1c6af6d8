"""The repositories that industrial_ci builds before this one: its ``UPSTREAM_WORKSPACE``.

https://github.com/ros-industrial/industrial_ci/blob/master/doc/index.rst, "Workspace definition", read on 2026-11-22
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from roslab.evidence.dependency import GitSource
from roslab.evidence.lex.yaml import Scalar
from roslab.evidence.ros.vcs import https
from roslab.values.pattern import pattern

NAME = "upstream_workspace"
_ASSIGNED = pattern(r"\bUPSTREAM_WORKSPACE=(?:\"([^\"\n]*)\"|'([^'\n]*)'|(\S+))")
_HOSTS = {"github": "github.com", "gitlab": "gitlab.com", "bitbucket": "bitbucket.org"}
_REPOSITORY = pattern(
    r"(?<!\S)(?:(github|gitlab|bitbucket):([\w.-]+(?:/[\w.-]+)+)|git\+((?:https?|ssh)://[^\s#]+))(?:\#([\w./+-]+))?(?!\S)"
)
"""``github:OWNER/NAME#REF`` or ``git+URL#REF``; lists, folders and what is removed again, ``-NAME``, are others."""


def upstream(values: Iterable[Scalar], file: str) -> Iterator[GitSource]:
    """Yield each repository that a value of a CI file, or an assignment in it, puts into the upstream workspace."""
    for value in values:
        whole = (value.text,) if value.key.lower() == NAME else ()
        assigned = ("".join(group or "" for group in match.groups()) for match in _ASSIGNED.finditer(value.text))
        for text in (*whole, *assigned):
            for match in _REPOSITORY.finditer(text):
                host, path, url, ref = match.groups()
                address = https(url) if url else f"https://{_HOSTS[host]}/{path}"
                yield GitSource(
                    name=address.rstrip("/").rpartition("/")[2].removesuffix(".git"),
                    url=address,
                    ref=ref,
                    strength="prose",
                    file=file,
                    line=value.line,
                    kind="upstream",
                )
