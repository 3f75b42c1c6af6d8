"""What a project needs in any version and only its owner has: the repository of that name comes before the project.

Planning asks no index. Where pip's index has the package after all, its repository is as good; where that cannot be
installed, the index is asked for it, as ever.
"""

from __future__ import annotations

from collections.abc import Iterator

from roslab.decide.python.packages import Chosen
from roslab.decide.ros.sought_addresses import public_owner
from roslab.decide.ros.source_names import address, for_pip
from roslab.evidence.dependency import GitSource
from roslab.evidence.facts import Evidence
from roslab.knowledge.frameworks import imports
from roslab.knowledge.not_on_index import not_on_index
from roslab.knowledge.on_index import named_like
from roslab.values.dataclass import replace
from roslab.values.name import canonicalize_name
from roslab.values.requirement import Requirement
from roslab.values.requirement_line import stated


def with_repositories_of_owner(evidence: Evidence, chosen: Chosen) -> Chosen:
    """Add the repositories of the owner that a page at the root links to and that projects need by their names."""
    links = dict(_of_owner(evidence)) if chosen.projects else {}
    there = {each.key for each in chosen.guessed} | {address(each.url.removeprefix("git+")) for each in chosen.guessed}
    found: dict[str, Requirement] = {}
    for asked in (each for project in chosen.projects for each in project.requirements) if links else ():
        git = links.get(asked.key)
        if git is None or asked.role or not asked.name or asked.url or asked.specifier or asked.marker:
            continue
        if known_of_index(asked.key) or not there.isdisjoint((asked.key, address(git.url))):
            continue
        found.setdefault(asked.key, stated(for_pip(git), "import", asked.file, asked.line))
    return replace(chosen, guessed=(*found.values(), *chosen.guessed)) if found else chosen


def _of_owner(evidence: Evidence) -> Iterator[tuple[str, GitSource]]:
    """Yield what pages at the root link to or clone of the owner's other repositories, by the name of a package."""
    owner, here = address(public_owner(evidence)), address(evidence.origin or "")
    for git in evidence.sources if owner else ():
        of_page = git.kind in {"link", "clone"} and "/" not in git.file and not git.private
        if of_page and address(git.url).rpartition("/")[0] == owner and address(git.url) != here:
            yield canonicalize_name(git.name), git


def known_of_index(key: str) -> bool:
    """Tell whether a table knows of the index that it has such a package, or what to install in its place."""
    of_modules = {canonicalize_name(package) for package, _ in imports().values() if package}
    return key in of_modules or key in not_on_index() or named_like(key) is not None
