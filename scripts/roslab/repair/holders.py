"""What apt's own index of files says of what a failed build lacks, where no table names a package."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping, Sequence

from roslab.config.addition import has
from roslab.errors import BuildError
from roslab.explain.answer import Answer, Explanation
from roslab.knowledge.repairs import complete, repairs
from roslab.repair import missing
from roslab.repair.asked import asked
from roslab.repair.change import Change, Given, Repair
from roslab.values.dataclass import dataclass, replace
from roslab.values.pattern import pattern

_DEVELOPMENT = "-dev"
"""End of the names of packages that hold headers and what links: Debian Policy, 8.4."""

_LINE = pattern(r"(?m)^(?P<number>\d{1,6}) (?P<package>[a-z0-9][a-z0-9+.-]{1,200})$")
"""A line of the answer; the name of a package: Debian Policy, 5.6.1."""
_SHOWN = 5
"""Most packages that are named of those that hold a file: a common name of a header stands in a hundred."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Sought:
    """One thing that a build lacks, and the paths under which a package would hold it, the likeliest first."""

    found: Explanation
    paths: tuple[str, ...]
    """Regular expressions, each for a whole path without its first slash."""


def sought(answer: Answer) -> tuple[Sought, ...]:
    """Return what apt's index of files can be asked for, of the failures whose cause is certain."""
    return tuple(
        Sought(found=found, paths=paths)
        for found in answer.explanations
        if found.id and found.certainty == "certain"
        for paths in _paths(repairs()[found.id].files if found.id in repairs() else (), dict(found.names))
    )


def sought_for(answer: Answer, given: Given) -> tuple[Sought, ...]:
    """Return what apt is asked for of a repository, whose own programs no package holds."""
    found = sought(answer) if not given.plan.author_dockerfile else ()
    return tuple(one for one in found if not missing.is_own(dict(one.found.names).get("program", ""), given))


def _paths(templates: tuple[str, ...], names: Mapping[str, str]) -> Iterator[tuple[str, ...]]:
    """Yield the paths of each of several names, of which a failure captures all at once."""
    used = {name for name in names if name != "low" and any(f"{{{name}}}" in template for template in templates)}
    for word in [word for name in used for word in names[name].split(", ") if word]:
        given = {**dict.fromkeys(used, re.escape(word)), "low": re.escape(word.lower())}
        yield tuple(_filled(template, given) for template in templates if complete(template, given))


def _filled(template: str, names: Mapping[str, str]) -> str:
    return re.sub(r"\{([a-z]+)\}", lambda match: names[match[1]], template)


def completed(found: Repair, answer: Answer, given: Given, ask: Callable[[Sequence[str]], str]) -> Repair:
    """Return a repair with what apt's index of files has of what is missing, where nothing else is certain.

    ``ask`` gives the answer that ``changes`` reads for the paths in their order, and raises ``BuildError``.
    """
    wanted = sought_for(answer, given) if not found.certain.changes else ()
    if not wanted:
        return found
    try:
        said = ask([path for one in wanted for path in one.paths])
    except BuildError as error:
        reason = f"apt was not asked which package holds it: {error.problems[0].message}"
        return _refused(found, wanted, [(wanted[0].found.id or "", reason)])
    new: list[Change] = []
    refused: list[tuple[str, str]] = []
    for one, each in zip(wanted, changes(wanted, said, given), strict=True):
        if isinstance(each, str):
            refused.append((one.found.id or "", each))
        elif has(given.config, each.entry):
            refused.append((each.failure, f"roslab.yaml has {each.value} already, and that did not help"))
        else:
            new.append(each)
    return _refused(replace(found, changes=(*found.changes, *new)), wanted, refused)


def _refused(found: Repair, wanted: tuple[Sought, ...], refused: list[tuple[str, str]]) -> Repair:
    """Return a repair with these reasons for what was sought, and with its own for all other failures."""
    named = {one.found.id for one in wanted}
    others = (each for each in found.refused if each[0] not in named)
    return replace(found, refused=(*refused, *others))


def changes(wanted: tuple[Sought, ...], answer: str, given: Given) -> Iterator[Change | str]:
    """Yield the package of each thing that was sought, or why there is none.

    ``answer`` has lines of a path's number, from 1 over all that was sought, and a package that holds it.
    """
    said: dict[int, list[str]] = {}
    for match in _LINE.finditer(answer):
        said.setdefault(int(match["number"]), []).append(match["package"])
    first = 1
    for one in wanted:
        held = next((said[at] for at in range(first, first + len(one.paths)) if at in said), [])
        first += len(one.paths)
        what = asked(one.found, given)
        packages = [package for package in held if package.endswith(_DEVELOPMENT)] or held
        if len(packages) == 1:
            yield Change(
                key="apt",
                value=packages[0],
                failure=one.found.id or "",
                certain=True,
                asked=asked(one.found, given, packages[0]),
            )
        elif packages:
            yield f"{what} is in {_listed(packages)}: name one under `apt`"
        else:
            yield f"no package of the image's sources holds {what}"


def _listed(packages: Sequence[str]) -> str:
    first = packages[:_SHOWN]
    *others, last = (*first, f"{len(packages) - _SHOWN} more") if len(packages) > _SHOWN else first
    return f"{', '.join(others)} and {last}"
