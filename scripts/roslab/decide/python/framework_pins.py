"""Versions of frameworks that a manifest leaves open and an install line pins."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping

from roslab.decide.cuda.local import cuda_of
from roslab.decide.decision import Choice, Reason
from roslab.decide.python.bounds import Constraints
from roslab.decide.python.pins import Pin
from roslab.decide.python.weights import PackageWeight as Weight
from roslab.decide.reasons import because
from roslab.knowledge.frameworks import framework, newest_framework, newest_on_cuda, next_after, released_together
from roslab.values.pattern import pattern
from roslab.values.requirement import Requirement
from roslab.values.requirement_line import stated
from roslab.values.version import Version

_BUILD = pattern(r"(.+)-cu(?:da)?(\d{2,3}|\d{2}x)")
_LEADING = ("torch", "tensorflow", "jax")
_INSTALL_LINE = 1
"""Of ``Pin.trust``."""
_WHY = "an install line pins what the manifest leaves free"
WHY_LOCKED = "the lock has this release of what the manifest leaves free"
_WHY_LATER = "one manifest pins what another one, which is installed before it, leaves free"


def framework_pins(
    pins: Iterable[Pin],
    asked: Iterable[Requirement],
    cuda: str | None,
    python: str | None,
    day: str | None,
) -> Choice[Constraints]:
    """Return constraints for frameworks that ``asked`` leaves open, from install lines or a lock that fit the CUDA.

    Today's newest release of the framework may fit neither the code and its compiled parts nor the image's CUDA. What
    one manifest pins and another leaves open is pinned for both: what is compiled between them must fit what stays.
    A tensorflow without torch or jax beside it is kept to releases for the image's CUDA: its newest one of the ``day``
    that has a wheel for the ``python`` may be for another.
    """
    pins = tuple(pins)
    everything = [each for each in asked if each.name]
    free = {each.key: each for each in everything if not each.limited}
    found = dict(_of_manifests(everything, free))
    free = {key: each for key, each in free.items() if key not in {exact.key for exact in found}}
    said = [pin for pin in pins if (pin.trust == _INSTALL_LINE or pin.requirement.origin == "lock") and pin.release]
    for name in _LEADING:
        fitting = [p for p in said if name == p.name and name in free and _fits(p, free[name], cuda)]
        if not fitting:
            continue
        leading = min(fitting, key=lambda pin: cuda_of(pin.release or "") != cuda)
        beside = released_together().get(name, ())
        together = [p for p in said if p.name in beside and p.name in free and _of_one_build(p, leading)]
        one = {pin.name: pin for pin in reversed((leading, *together))}
        for pin in reversed(one.values()):
            exact = stated(f"{pin.name}=={pin.release}")
            why = WHY_LOCKED if pin.requirement.origin == "lock" else _WHY
            found.setdefault(exact, because("dependencies", exact.written, why, pin.requirement, weight=Weight.BOUND))
    others = {each.key for each in everything} & {"torch", "jax"}
    if pins and cuda and not others and all(each.key != "tensorflow" for each in found):
        found.update(_of_cuda(free, cuda, python, day))
    return Choice(answer=tuple(found), reasons=tuple(found.values()))


def _of_cuda(
    free: Mapping[str, Requirement], cuda: str, python: str | None, day: str | None
) -> Iterator[tuple[Requirement, Reason]]:
    """Yield what keeps a tensorflow that is asked for in any version to those for the image's CUDA."""
    said = free.get("tensorflow")
    newest, fitting = newest_framework("tensorflow", day, python), newest_on_cuda("tensorflow", cuda, python, day)
    if said is None or newest is None or fitting is None or cuda in newest.cuda:
        return
    if after := next_after(fitting):
        bound = stated(f"tensorflow<{after.first}")
        why = f"the newest is for CUDA {newest.cuda[0]}, and the image has {cuda}"
        yield bound, because("dependencies", bound.written, why, said, weight=Weight.BOUND)


def _of_manifests(
    asked: Iterable[Requirement], free: Mapping[str, Requirement]
) -> Iterator[tuple[Requirement, Reason]]:
    """Yield the one release of each framework that manifests pin where another manifest leaves it open."""
    families = {name: (name, *released_together().get(name, ())) for name in _LEADING}
    known = {name for family in families.values() for name in family}
    pinned: dict[str, dict[str, Requirement]] = {}
    for each in asked:
        if each.key in known and each.origin == "manifest" and each.release and not each.url:
            pinned.setdefault(each.key, {}).setdefault(each.release, each)
    agreed = [family for name, family in families.items() if len(pinned.get(name, ())) == 1]
    for key in (name for family in agreed for name in family if name in free and free[name].origin == "manifest"):
        if len(pinned.get(key, ())) == 1:
            ((release, said),) = pinned[key].items()
            exact = stated(f"{key}=={release}")
            yield exact, because("dependencies", exact.written, _WHY_LATER, said, weight=Weight.BOUND)


def one_build(asked: Iterable[Requirement], cuda: str | None) -> tuple[Requirement, ...]:
    """Keep one build of each package: ``spconv-cu102`` and ``cupy-cuda11x`` contain the same module as others of them.

    So does the plain name, which compiles it. Without one for the image's CUDA, the first is kept.
    """
    kept = list(asked)
    builds: dict[str, list[tuple[str, Requirement]]] = {}
    for each in kept:
        if match := _BUILD.fullmatch(each.key):
            builds.setdefault(match[1], []).append((match[2], each))
    major, digits = (cuda or "").partition(".")[0], (cuda or "").replace(".", "")
    for name, same in builds.items():
        fitting = [each for built, each in same if built in {digits, f"{major}x"}] or [same[0][1]]
        others = {each for _, each in same} - {fitting[0]}
        kept = [each for each in kept if each not in others and each.key != name]
    return tuple(kept)


def _of_one_build(pin: Pin, leading: Pin) -> bool:
    """Tell whether one file pins two frameworks for each other: a lock may have builds of ``+cpu`` and ``+cu130``."""
    builds = {(each.release or "").partition("+")[2] for each in (pin, leading)} - {""}
    return pin.requirement.file == leading.requirement.file and len(builds) < 2


def _fits(pin: Pin, manifest: Requirement, cuda: str | None) -> bool:
    """Tell whether the manifest allows a pinned release, and whether its wheel fits the image's CUDA."""
    release = pin.release or ""
    if cuda is None or not manifest.specifier.contains(release.partition("+")[0], prereleases=True):
        return False
    if local := cuda_of(release):
        return local == cuda
    row = framework(pin.name, release)
    return row is not None and any(Version(each).release == Version(cuda).release[:2] for each in row.cuda)
