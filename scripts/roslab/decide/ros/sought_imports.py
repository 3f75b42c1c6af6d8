"""Modules that nodes import, that no table knows, and that repositories of the same owner may bring."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from roslab.decide.python.firmware import without_firmware
from roslab.decide.python.on_index import on_index
from roslab.decide.ros.sought import PACKAGE
from roslab.decide.ros.sought_addresses import public_owner
from roslab.decide.ros.source_names import OF_MESSAGES, address, plain
from roslab.evidence import places
from roslab.evidence.dependency import Dependency, GitSource
from roslab.evidence.facts import Evidence
from roslab.knowledge.frameworks import imports
from roslab.knowledge.guesses import ros_modules, same_module
from roslab.knowledge.not_on_index import not_on_index
from roslab.knowledge.python2_packages import of_python2
from roslab.knowledge.released import ever_released
from roslab.values.name import bare_name, canonicalize_name
from roslab.values.requirement import Requirement

_SHORTEST = 4
"""Fewest letters of a beginning that two names have in common by more than chance."""

_MOST = 3
"""Most repositories that are looked through for modules that none of them is called like."""


def modules_of_owner(evidence: Evidence, installed: Iterable[Requirement]) -> Iterator[Dependency]:
    """Yield the modules at the top of nodes that nothing brings, each once, as packages of ROS.

    Only what has a name of several words, as packages of ROS have: of one word there are modules of everything.
    ``installed``: what pip installs. What a package.xml, a page or a clone names has an answer already, right or wrong.
    """
    asked = {each.name for manifest in evidence.manifests for each in manifest.dependencies}
    asked |= {each.name for each in evidence.prose} | {each.name for each in evidence.manifests if each.name}
    asked |= {plain(git.name) for git in evidence.sources} | {each.key for each in installed}
    named = {canonicalize_name(name) for name in asked}
    foreign = {each.name: each for each in evidence.code if each.namespace == "import" and each.strength == "used"}
    told: set[str] = set()
    for said in evidence.mentions:
        name = said.value
        if said.topic != "node_import" or name in told or name not in foreign or places.aside(said.file):
            continue
        told.add(name)
        known = _known(foreign[name], evidence)
        brought = canonicalize_name(name) in named or any(same_module(canonicalize_name(name), n) for n in named)
        parts = any(bare_name(name).startswith(bare_name(each)) for each in named if len(bare_name(each)) >= _SHORTEST)
        if "_" in name and PACKAGE.fullmatch(name) and not (known or brought or parts):
            yield Dependency(
                namespace="ros", name=name, strength="declared", file=said.file, line=said.line, role="exec"
            )


def modules_of_links(evidence: Evidence, installed: Iterable[Requirement]) -> tuple[Dependency, ...]:
    """Return the modules of no table that the tree always imports, for which a repository of the owner's may be cloned.

    ``installed``: what pip installs.
    """
    named = {canonicalize_name(each.name) for each in evidence.manifests if each.name}
    named |= {canonicalize_name(asked.name) for manifest in evidence.manifests for asked in manifest.dependencies}
    named |= {canonicalize_name(name) for made in evidence.cmake for name in (*made.targets, *made.made)}
    named |= {each.key for each in installed}
    found = (
        used
        for used in evidence.code
        if used.namespace == "import"
        and used.strength == "used"
        and not (places.aside(used.file) or places.vendored(used.file) or used.name.endswith(OF_MESSAGES))
        and canonicalize_name(used.name) not in named
        and not _known(used, evidence)
    )
    return tuple(without_firmware(found))


def linked_of_owner(evidence: Evidence) -> tuple[GitSource, ...]:
    """Return the other repositories of the same owner that pages link to, the first of them, each once."""
    here, owner = address(evidence.origin), public_owner(evidence)
    found: dict[str, GitSource] = {}
    for git in evidence.sources:
        at = address(git.url)
        theirs = owner and at.rpartition("/")[0] == address(owner) and at != here
        if theirs and git.kind == "link" and not (git.private or places.vendored(git.file)):
            found.setdefault(at, git)
    return tuple(found.values())[:_MOST]


def _known(used: Dependency, evidence: Evidence) -> bool:
    """Tell whether a table knows a module, or the index of pip a package of its name."""
    name = used.name
    tabled = name in imports() or canonicalize_name(name) in not_on_index() or of_python2(name)
    return tabled or name in ros_modules() or ever_released(name) or on_index(evidence, used) is not None
