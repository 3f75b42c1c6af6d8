"""Modules of no table that a command imports before it does anything: the index's package of their name is tried."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Set
from itertools import islice

from roslab.config.model import Config, Kind
from roslab.decide.command import decide_command
from roslab.decide.python.at_top import started_files
from roslab.decide.python.lost import unknown_modules, with_told_links
from roslab.decide.python.may_bring import absent, begins_like, declares, names_there
from roslab.decide.python.of_owner import with_repositories_of_owner
from roslab.decide.python.own import OwnPython
from roslab.decide.python.packages import Chosen
from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import Evidence, Mention
from roslab.evidence.python.modules import run_by_pages
from roslab.knowledge.never_by_name import never_by_name, widespread_stems
from roslab.knowledge.not_on_index import of_ros
from roslab.knowledge.released import ever_released
from roslab.knowledge.standard_modules import standard_modules
from roslab.values.dataclass import replace
from roslab.values.name import bare_name, canonicalize_name
from roslab.values.requirement_line import stated

MOST = 16
"""Most modules that are tried: code that imports more of no table lacks whole folders of its own."""
SHORTEST = 5
"""Fewest letters of a module that is tried: shorter names of the index are taken by whoever came first."""


def with_unknown_modules(evidence: Evidence, config: Config, kind: Kind, own: OwnPython) -> Chosen:
    """Return what is chosen with what links bring, what default command and README import, and the names to try.

    A package that is tried has the module's name and nothing else in its favour: so only what a command cannot start
    without is, and where neither a declared package, nor a submodule, nor a link of a page may bring it.
    """
    chosen = with_repositories_of_owner(evidence, with_told_links(evidence, kind, own.chosen))
    unknown = unknown_modules(evidence, kind, chosen) if any(m.topic == "reached" for m in evidence.mentions) else []
    if not unknown:
        return chosen
    default, pages = _reached(evidence, config, kind, own.version)
    reached = [(used, place) for used in unknown if (place := default.get(used.name) or pages.get(used.name))]
    reached.sort(key=lambda pair: pair[0].name not in default)
    others = _others(evidence, chosen) if reached else frozenset()
    able = (stated(used.name, "import", at.file, at.line) for used, at in reached if _may_be_tried(used, others))
    tried = tuple(islice(able, MOST)) if not absent(evidence) else ()
    stopping = tuple(default[used.name] for used in unknown if used.name in default)
    return replace(
        chosen,
        guessed=(*chosen.guessed, *tried),
        by_name=tuple(each.key for each in tried),
        stopping=stopping,
    )


def _reached(
    evidence: Evidence, config: Config, kind: Kind, python: str | None
) -> tuple[Mapping[str, Mention], Mapping[str, Mention]]:
    """Return by module the first place that the default command reaches, and the same of what pages run."""
    command = decide_command(evidence, config, kind, None, python).answer
    argv = command.page.argv if command.page else command.command
    default = {*started_files(argv, evidence)}
    readme = run_by_pages(each for each in evidence.mentions if each.source == "readme")
    return _places(evidence, default), _places(evidence, readme)


def _places(evidence: Evidence, programs: Set[str]) -> dict[str, Mention]:
    found: dict[str, Mention] = {}
    for each in evidence.mentions:
        if each.topic == "reached" and each.inside in programs:
            found.setdefault(each.value, each)
    return found


def _may_be_tried(used: Dependency, others: Set[str]) -> bool:
    """Tell whether nothing speaks against the package of a module's own name; ``others``: of what may bring it."""
    name = used.name
    if len(bare_name(name)) < SHORTEST or never_by_name(name) or name in standard_modules():
        return False
    if ever_released(name) or of_ros(canonicalize_name(name)):
        return False
    return not begins_like(name, others)


def _others(evidence: Evidence, chosen: Chosen) -> frozenset[str]:
    """Return the names of what may bring a module: packages, repositories that pages name, and the tree itself."""
    names = names_there(evidence, chosen) if declares(chosen) else set()
    names |= set(_words(git.name for git in evidence.sources))
    names |= set(_words((evidence.origin.rstrip("/").rpartition("/")[2].removesuffix(".git"),)))
    names |= set(_words(project.name for project in evidence.cmake if project.name))
    return frozenset(bare_name(name) for name in names) - widespread_stems()


def _words(names: Iterable[str]) -> Iterator[str]:
    for name in names:
        yield name
        yield from canonicalize_name(name).split("-")
