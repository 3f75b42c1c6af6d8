"""What a conda environment has for pip, with the repairs that a list of requirements gets.

conda hands these lines to one call of pip, so that one which pip refuses would stop all the others.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence, Set
from typing import NamedTuple

from roslab.decide.decision import Warning_
from roslab.decide.python.bare import needs_of
from roslab.decide.python.manifests import path_of
from roslab.decide.python.mistaken import mistaken
from roslab.decide.python.of_manifests import of_environment, own_names
from roslab.decide.python.packages import Chosen
from roslab.decide.python.refused import (
    from_page,
    further_index,
    in_full,
    of_pages,
    refused,
    right,
    told_in_full,
    unfit,
)
from roslab.decide.python.too_new import in_python, loosened, told, unmet
from roslab.decide.reasons import warn
from roslab.evidence.facts import Evidence
from roslab.knowledge.not_on_index import of_ros
from roslab.values.dataclass import dataclass, replace
from roslab.values.name import canonicalize_name
from roslab.values.requirement import Requirement

_OWN = "{asked} is left out: it is a project of this tree, which is installed from there"
_LINES = frozenset({"", "repaired"})
"""The roles of what names a package, as a line of its own."""


@dataclass(frozen=True, kw_only=True, slots=True)
class CondaPart:
    """How the part is installed."""

    local: tuple[str, ...] = ()
    """Lines that are taken out of the file: folders of the tree, lists that pip would refuse, and the names of what it
    cannot install."""
    others: bool = False
    """pip installs something else of the file."""
    instead: tuple[Requirement, ...] = ()
    """What pip installs in place of lines that are taken out, in the same call as the others."""
    declared: tuple[Requirement, ...] = ()
    """All that pip is given by name: these, and every line where nothing reads the file itself."""
    tried: tuple[Requirement, ...] = ()
    """What pip tries in place of lines that are taken out, once the environment is there."""
    warnings: tuple[Warning_, ...] = ()


def conda_part(
    evidence: Evidence, chosen: Chosen, python: str | None, *, by_file: bool, by_name: Collection[str]
) -> CondaPart:
    """Return how what the chosen environment has for pip is installed, for the image's ``python``.

    ``by_file``: conda makes the environment from its file. ``by_name`` are paths of lists that are installed by
    the names in them, as where one has folders of the tree: the environment must not include them.
    """
    listed = tuple(of_environment(evidence, chosen))
    names = {canonicalize_name(project.name) for project in chosen.projects if project.name}
    off, instead, tried, warnings = _repaired(listed, python, names, of_pages(evidence, own_names(evidence)))
    folders = [each.written for each in listed if each.role == "project"]
    lists = [each for each in listed if each.role == "file" and path_of(each) in by_name]
    out = (*folders, *(each.written.removeprefix("./") for each in lists), *(each.name for each in off))
    others = by_file and any(each.role != "project" and each not in (*off, *lists) for each in listed)
    kept = [] if by_file else [each for each in listed if each not in off and not each.role]
    return CondaPart(
        local=tuple(dict.fromkeys(out)) if by_file else (),
        others=others,
        instead=tuple(instead) if others else (),
        declared=(*kept, *instead),
        tried=tuple(tried),
        warnings=tuple(warnings),
    )


class _Repaired(NamedTuple):
    off: list[Requirement]
    instead: list[Requirement]
    tried: list[Requirement]
    warnings: list[Warning_]


def _repaired(
    listed: Sequence[Requirement], python: str | None, own: Set[str], pages: Mapping[str, Requirement]
) -> _Repaired:
    """Return the lines that are taken out, and what comes in their place.

    ``own`` are the names of what is installed from the tree, ``pages`` what is taken from git, by name.
    """
    named = [each for each in listed if each.name and each.role in _LINES]
    further = any(further_index(each.written) for each in listed if each.role == "option")
    wrong = mistaken(named)
    off: list[Requirement] = []
    instead: list[Requirement] = []
    tried: list[Requirement] = []
    warnings: list[Warning_] = []
    for each in named:
        count = len(off)
        off.append(each)
        if each in wrong:
            warnings.append(wrong[each])
        elif in_python(each, python):
            warnings.append(told(each, python))
        elif from_page(each, pages):
            instead += right([each], pages)
        elif each.key in own and not each.url:
            warnings.append(warn(_OWN.format(asked=each.written), each))
        elif refused(each) and not (further and of_ros(each.key)):
            warnings.append(unfit(each))
            tried += [*right([each]), *needs_of([each], {other.key for other in listed})]
        elif unmet(each, python):
            warnings.append(told(each, python))
            instead += right(loosened([each], python))
        elif in_full(each) is not each:
            warnings += told_in_full([each])
            instead.append(in_full(each))
        elif each.role == "repaired":
            instead.append(each)
        else:
            del off[count:]
    off, kept = _with_namesakes(named, off)
    return _Repaired(off, [replace(each, role="") for each in (*instead, *kept)], tried, warnings)


def _with_namesakes(
    named: Sequence[Requirement], off: Sequence[Requirement]
) -> tuple[list[Requirement], list[Requirement]]:
    """Return what is taken out by its name, and of that what stays: another line may name it for another Python."""
    names = {each.name for each in off}
    out = [each for each in named if each.name in names]
    return out, [each for each in out if each not in off]
