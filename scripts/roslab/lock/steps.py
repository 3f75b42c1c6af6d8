"""Which step of a generated Dockerfile installed a package: apt's own record of its calls, laid along the steps."""

from __future__ import annotations

from collections.abc import Sequence

from roslab.plan.locked import Package
from roslab.plan.packages import asked_files
from roslab.plan.plan import Plan
from roslab.values.dataclass import replace

SOURCES = frozenset({"ca-certificates", "curl", "gnupg", "software-properties-common"})
"""What add-package-sources.sh installs."""
ICUB = frozenset({"curl", "gnupg", "icub"})


def steps(plan: Plan) -> tuple[tuple[str, frozenset[str] | None], ...]:
    """Return the steps that call apt in the Dockerfile's order, each with the names that it asks for.

    ``None`` for a step that may ask for anything. Their names are those that the layers pin them by.
    """
    depends = frozenset(name for library in plan.libraries for name in library.depends) if plan.compatible else None
    sisters = frozenset(name for source in plan.workspace.sources for name in source.depends)
    repositories = ("repositories", SOURCES if plan.repositories else frozenset[str]())
    named = (("packages", frozenset(plan.apt)), ("tools", frozenset(plan.apt_tools)))
    guessed = ("guessed", frozenset(plan.apt_guessed))
    own = ("own", frozenset(asked_files(plan.own_packages)))
    icub = ("icub", ICUB if plan.icub else frozenset[str]())
    order: Sequence[tuple[str, frozenset[str] | None]]
    if plan.compatible:
        first = ("first", frozenset(plan.apt_first))
        order = (first, named[1], icub, repositories, named[0], guessed, ("libraries", depends))
    else:
        order = (repositories, *named, own, guessed, icub)
    order = (*order, ("sisters", sisters))
    order = (*order, ("rosdep", None)) if plan.rosdep else order
    order = (*order, ("custom", None)) if plan.custom and plan.custom.commands else order
    return tuple((name, asked) for name, asked in order if asked is None or asked)


def placed(
    plan: Plan, packages: Sequence[Package], history: Sequence[tuple[tuple[str, ...], tuple[str, ...]]]
) -> tuple[Package, ...]:
    """Return the packages with their steps; the base's own keep theirs.

    Calls and steps are in the same order, so a call belongs to the first step, from that of the call before it on,
    that asked for its names, else to the first that may ask for anything.
    """
    order = steps(plan)
    base = {package.name for package in packages if package.step == "base"}
    found: dict[str, str] = {}
    at = 0
    for asked, installed in history:
        new = [name for name in installed if name not in base]
        if not new:
            continue
        fitting = [i for i in range(at, len(order)) if (names := order[i][1]) and asked and names.issuperset(asked)]
        fitting += [i for i in range(at, len(order)) if order[i][1] is None]
        if fitting:
            at = fitting[0]
            found |= {name: order[at][0] for name in new if name not in found}
    return tuple(p if p.step else replace(p, step=found.get(p.name, "")) for p in packages)
