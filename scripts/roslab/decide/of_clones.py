"""What the README at the root runs of a package that the tree has not, and that a clone beside it brings."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator

from roslab.config.model import Kind
from roslab.decide.candidate import LAUNCHERS, Candidate, is_component
from roslab.decide.first_command import first_of
from roslab.decide.own_commands import own
from roslab.decide.ros.slips import meant
from roslab.decide.ros.sought_by_pages import PLACEHOLDER
from roslab.decide.ros.source_names import address, akin, plain
from roslab.evidence.dependency import GitSource
from roslab.evidence.facts import Evidence
from roslab.knowledge.distros import distro
from roslab.knowledge.released import ever_released, released
from roslab.values.dataclass import replace

NEAR = 30
"""Most lines between the name of a clone on the page and the command that runs a package of it."""


def first_of_clones(found: Iterable[Candidate], evidence: Evidence, kind: Kind) -> Candidate | None:
    """Return the command of a listed clone's package that the README runs first, ``None`` for none.

    Only where the README runs nothing of the tree's own packages. That the clone has the package is told by its name,
    or by the page, which names the clone before it: nobody can look into it before the image is built.
    """
    names = {manifest.name for manifest in evidence.manifests if manifest.name}
    if kind not in {"ros1", "ros2"} or not names:
        return None
    found = [c for c in found if c.strong and c.argv[0] in LAUNCHERS and not c.tried]
    clones = list(_clones(evidence))
    if not clones or any(own(c.argv, evidence) for c in found if "/" not in c.file):
        return None
    addresses = {address(git.url) for git in clones}
    named = {(each.file, each.line) for each in evidence.sources if address(each.url) in addresses}
    found = [c for c in found if "/" not in c.file and not _published(_package(c), evidence)]
    brought = [c for c in found if _brings(clones, c, named, names)]
    first = first_of(brought)
    return replace(first, why=f"{first.why}, of a repository that is cloned beside this one") if first else None


def _clones(evidence: Evidence) -> Iterator[GitSource]:
    """Yield what a list of the tree clones into the workspace, or a page beside the repository itself."""
    for git in evidence.sources:
        listed = git.kind == "vcs" or (git.kind == "clone" and git.beside)
        if listed and not (git.itself or git.aside or git.removed or git.installed or git.doubt):
            yield git


def _brings(clones: list[GitSource], candidate: Candidate, named: Collection[tuple[str, int]], names: set[str]) -> bool:
    """Tell whether a clone has the package of a command. ``named``: the lines of pages that have a clone's address."""
    package = _package(candidate)
    if not package or package in names or PLACEHOLDER.search(package) or meant(package, names):
        return False
    before = range(candidate.line - NEAR, candidate.line)
    return any(_like(package, git) for git in clones) or any((candidate.file, line) in named for line in before)


def _package(candidate: Candidate) -> str:
    at = 2 + is_component(candidate.argv) if candidate.argv[0] == "ros2" else 1
    return "".join(candidate.argv[at : at + 1])


def _published(package: str, evidence: Evidence) -> bool:
    """Tell whether a distribution that the tree names released a package, any where it names none: apt may have it."""
    named = {found.name for m in evidence.mentions if m.topic == "distro" and (found := distro(m.value))}
    return ever_released(package) and (not named or any(package in released(name) for name in named))


def _like(package: str, git: GitSource) -> bool:
    """Tell whether a package is called like a repository, or like a part of it."""
    return akin(package, git.name) and (plain(package).startswith(plain(git.name)) or plain(git.name) in plain(package))
