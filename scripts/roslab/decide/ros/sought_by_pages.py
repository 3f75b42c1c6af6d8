"""Packages that the README runs programs of and nothing brings, looked for in what the page clones or links to."""

from __future__ import annotations

from collections.abc import Collection, Mapping

from roslab.decide.ros.credited import told_by_pages
from roslab.decide.ros.slips import meant
from roslab.decide.ros.source_names import address, akin, plain
from roslab.decide.system.needs import started
from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import Evidence
from roslab.evidence.ros.vcs import https
from roslab.knowledge.distros import distros
from roslab.knowledge.libraries import library
from roslab.knowledge.released import released
from roslab.values.pattern import pattern

MOST = 3
"""Most clones of a page that are looked through for a package that none of them is called like."""
_PACKAGE = pattern(r"[a-z][a-z0-9]*(?:_[a-z0-9]+)*")
PLACEHOLDER = pattern(r"(?:^|_)(?:your|my|pkg|package|name|foo|bar|xxx+)(?:_|$)")
"""A name that stands for another: `rosrun your_package your_node`."""


def run_by_page(evidence: Evidence, ros_distro: str, known: Collection[str]) -> Mapping[str, Dependency]:
    """Return the packages that the README at the root runs programs of, by their names; none of the ``known``.

    One that another distribution released, and this one not, is none that apt has.
    """
    own = {manifest.name for manifest in evidence.manifests if manifest.name}
    found: dict[str, Dependency] = {}
    for each in started(evidence, "ros1" if distros()[ros_distro].ros == 1 else "ros2"):
        if each.strength != "prose" or "/" in each.file or not each.file.startswith("README"):
            continue
        named = _PACKAGE.fullmatch(each.name) and not PLACEHOLDER.search(each.name)
        there = each.name in own or plain(each.name) in known or each.name in released(ros_distro)
        if named and not (there or meant(each.name, own) or library("cmake", each.name, None)):
            found.setdefault(each.name, each)
    return found


def in_clones(
    asked: Mapping[str, Dependency], evidence: Evidence, taken: Collection[str]
) -> dict[str, tuple[str, ...]]:
    """Return the addresses of what that page clones, each with the packages that it may hold.

    Those are what it is called like; of the others every clone may hold them, where there are few. Of what the page
    only links to, the repository with the very name of a package. ``taken``: the addresses of what is cloned anyway.
    """
    own = frozenset(plain(manifest.name) for manifest in evidence.manifests if manifest.name)
    here = {address(evidence.origin).rpartition("/")[2]} if evidence.origin else set()
    pages = {each.file for each in asked.values()}
    clones = {
        https(git.url).removesuffix(".git"): git
        for git in told_by_pages(evidence.sources, evidence, here, own)
        if git.file in pages and not (git.installed or git.removed) and address(git.url) not in taken
    }
    like = {name: [url for url, git in clones.items() if akin(name, git.name)] for name in asked}
    found: dict[str, tuple[str, ...]] = {}
    for name, urls in like.items():
        for url in urls or (clones if len(clones) <= MOST else ()):
            found[url] = (*found.get(url, ()), name)
    for git in evidence.sources:
        name = next((each for each in asked if plain(each) == plain(git.name) and not like[each]), "")
        if name and git.kind == "link" and git.file in pages and address(git.url) not in taken and not git.private:
            found.setdefault(https(git.url).removesuffix(".git"), (name,))
    return found
