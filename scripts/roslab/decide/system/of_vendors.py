"""Packages of apt that a vendor's own source alone has: the build goes on where that has none for the image."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator

from roslab.decide.base import BaseImage
from roslab.decide.decision import Choice, Warning_
from roslab.decide.reasons import warn
from roslab.decide.ros.workspace import Packages
from roslab.decide.system.left_out import needing
from roslab.decide.system.packages import SystemPackages
from roslab.evidence import places
from roslab.evidence.apt_source import host_of
from roslab.knowledge.apt_sources import added_sources
from roslab.values.dataclass import replace

_NOT_BUILT = "what links it is not built"
_KNOWN = (
    f"{{}} is only in its vendor's own source ({{}}), in its newest release; if that does not install, {_NOT_BUILT}"
)
_UNKNOWN = (
    f"{{}} is only in its vendor's own source ({{}}), and none of those is known for {{}}, so that {_NOT_BUILT}: give "
    "an image that has it as `base.image` in roslab.yaml"
)


def may_lack(system: Choice[SystemPackages], base: BaseImage, own: Collection[str]) -> Choice[SystemPackages]:
    """Return the packages with those that may fail which only a vendor's images have; each is told.

    ``own``: those of roslab.yaml, which have to install.
    """
    known = [each for each in added_sources() if each.base.pattern and not each.base.fullmatch(base.image)]
    found = {
        name: [each for each in known if each.packages.fullmatch(name)] for name in system.answer.apt if name not in own
    }
    found = {name: sources for name, sources in found.items() if sources}
    if not found:
        return system
    places = {reason.answer: reason for reason in reversed(system.reasons) if reason.file}
    told = []
    for name, sources in found.items():
        here = any(base.ubuntu in each.ubuntu for each in sources)
        image = f"Ubuntu {base.ubuntu}" if base.ubuntu else base.image
        told.append(warn((_KNOWN if here else _UNKNOWN).format(name, host_of(sources[0].url), image), places.get(name)))
    answer = replace(
        system.answer,
        apt=tuple(name for name in system.answer.apt if name not in found),
        apt_guessed=tuple(dict.fromkeys((*system.answer.apt_guessed, *found))),
    )
    return replace(system, answer=answer, warnings=(*system.warnings, *told))


def what_stops(
    warnings: Iterable[Warning_], packages: Packages, may_go: Collection[str], build_tool: str
) -> Iterator[Warning_]:
    """Yield the warnings; of a package that has to be built, that the build stops where it lacks such a library.

    ``may_go``: the names or folders of those that the build leaves out where they do not compile.
    """
    folders = {m.file.rpartition("/")[0]: m.name for m in packages.built if m.name}
    for warning in warnings:
        told = warning.file and _NOT_BUILT in warning.message
        folder = places.innermost((warning.file or "").rpartition("/")[0], folders) if told else None
        if folder is None or not {package := folders[folder], folder}.isdisjoint(may_go):
            yield warning
            continue
        others = needing(package, packages)[1:]
        all_but_last = ", ".join(others[:-1])
        named = f"{all_but_last} and {others[-1]} need" if all_but_last else "".join(f"{each} needs" for each in others)
        needed = f", and {named} that" if others else ""
        stops = f"{build_tool} stops at {package}, which links it{needed}"
        yield replace(warning, message=warning.message.replace(_NOT_BUILT, stops))
