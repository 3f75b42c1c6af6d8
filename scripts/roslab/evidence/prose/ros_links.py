"""Packages of ROS to whose pages at ros.org the items of a list of prerequisites link.

https://index.ros.org/?search_packages=true, https://wiki.ros.org/Names, 2026-11-26
"""

from __future__ import annotations

from collections.abc import Iterator

from roslab.evidence.dependency import Dependency
from roslab.evidence.prose.merged import Prose
from roslab.evidence.prose.needed_items import needed_items
from roslab.evidence.prose.pages import pages, text_of
from roslab.knowledge.released import ever_released
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

_HOSTS = ("index.ros.org/p/", "wiki.ros.org/")
_LINK = pattern(
    r"https?://(?:(?:www\.)?index\.ros\.org/p/([a-z][a-z0-9_]{1,60})(?:/[\w./#-]{0,200})?|"
    r"(?:www\.)?wiki\.ros\.org/([a-z][a-z0-9_]{1,60}))/?(?=[)\s>\"'?#,.;]|$)"
)


def read(repository: Repository) -> Prose:
    """Return what the pages at the root list, each name at its first place."""
    files = (file for file in pages(repository) if "/" not in file.path)
    return Prose(tuple(asked for file in files for asked in listed(text_of(repository, file), file.path)))


def listed(text: str, file: str) -> Iterator[Dependency]:
    """Yield each package of a page once, by its name in apt, for whatever distribution the image has."""
    if not any(host in text for host in _HOSTS):
        return
    told = set[str]()
    for line in needed_items(text):
        for index, wiki in _LINK.findall(line.text):
            name = index or wiki
            if name not in told and ever_released(name):
                told.add(name)
                apt = f"ros-{{distro}}-{name.replace('_', '-')}"
                yield Dependency(namespace="apt", name=apt, strength="prose", file=file, line=line.number, role="named")
