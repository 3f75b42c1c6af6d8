"""Libraries from source that only packages ask for which the image may go without, and then goes without both.

Nobody has read such a library, and a page of one package names it: it must not stop all others.
"""

from __future__ import annotations

from collections.abc import Collection

from roslab.config.model import Config, Source
from roslab.decide.command import Command
from roslab.decide.decision import Choice, Warning_
from roslab.decide.reasons import warn
from roslab.decide.ros.built_sources import Sources
from roslab.decide.ros.workspace import Packages
from roslab.decide.system.left_out import needing
from roslab.decide.system.must_build import must_build
from roslab.decide.system.required import asking
from roslab.evidence.facts import Evidence
from roslab.values.dataclass import replace


def for_spare_packages(
    choice: Choice[Sources],
    evidence: Evidence,
    config: Config,
    packages: Packages,
    command: Command,
    *,
    left_out: Collection[str],
) -> Choice[Sources]:
    """Return the sources without libraries that only packages which are left out ask for, and with those marked.

    Where a shell is started, any package may be what the repository is about.
    """
    sources = choice.answer.sources
    unread = [each for each in sources if each.build == "cmake" and each.unread and not each.unasked]
    if not unread or config.compatible:
        return choice
    by_name = asking(evidence, packages, (each.name for each in unread))
    needed = {*must_build(evidence, command.command, packages, choice.answer, left_out=left_out, ros_distro=None)}
    others = {m.name for m in packages.built if not m.metapackage} - {*left_out}
    kept: list[Source] = []
    warnings: list[Warning_] = []
    for source in sources:
        by = by_name.get(source.name, ())
        if not by or not {*by} <= {*left_out}:
            with_them = {name for each in by for name in needing(each, packages)}
            spare = by and command != Command() and needed and not with_them & needed and others - with_them
            kept.append(_tried(source) if spare else source)
            if spare:
                what = f"{source.name} is built for {', '.join(by)}, which the default command does not need"
                warnings.append(warn(f"{what}: where it cannot be built, the image goes without", source.place))
    answer = replace(choice.answer, sources=tuple(kept))
    return replace(choice, answer=answer, warnings=(*choice.warnings, *warnings))


def _tried(source: Source) -> Source:
    """Return a library whose failure stops nothing, nor that of a package which it needs."""
    return replace(source, unasked=True, depends=(), offered=(*source.depends, *source.offered))
