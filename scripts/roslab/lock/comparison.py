"""What moved from one image to another."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Literal

from roslab.lock.inventory import Inventory
from roslab.plan.locked import Lock, Machine
from roslab.values.dataclass import dataclass, replace

Kind = Literal["base", "apt", "pip", "conda", "source", "env"]
KINDS: tuple[Kind, ...] = ("base", "apt", "pip", "conda", "source", "env")


@dataclass(frozen=True, kw_only=True, slots=True)
class Change:
    """One thing that is not the same."""

    kind: Kind
    name: str
    old: str | None
    """``None`` if it was not there."""
    new: str | None
    """``None`` if it is there no more."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Comparison:
    """Everything that moved, in the order of ``KINDS`` and by name."""

    changes: tuple[Change, ...]
    packages: int
    """How many packages (of apt, pip, conda, or cloned) both together name."""
    sizes: tuple[int, int]
    """Bytes of each image, 0 where that is not known."""

    @property
    def moved(self) -> tuple[Change, ...]:
        """Return the packages that moved; the base and the variables are none."""
        return tuple(change for change in self.changes if change.kind not in ("base", "env"))


Contents = Mapping[Kind, Mapping[str, str]]


def contents(image: Inventory) -> Contents:
    """Return what an image holds, a value for each name of each kind."""
    first = image.layers[0] if image.layers else ""
    return {
        "base": {"first layer": first} if first else {},
        "apt": _versions((package.name, package.architecture, package.version) for package in image.apt),
        "pip": {
            each.package.name if each.environment == "image" else f"{each.package.name} ({each.environment})": (
                each.package.url or each.package.version
            )
            for each in image.python
        },
        "conda": _conda(image.conda),
        "source": {source.name: source.commit for source in image.sources},
        "env": dict(image.variables),
    }


def locked(machine: Machine) -> Contents:
    """Return what a lock says that an image of one platform holds."""
    return {
        "apt": _versions((package.name, package.architecture, package.version) for package in machine.apt),
        "pip": {
            package.name if environment.name == "image" else f"{package.name} ({environment.name})": (
                package.url or package.version
            )
            for environment in machine.python
            for package in environment.packages
        },
        "conda": _conda(machine.conda),
    }


def _versions(packages: Iterable[tuple[str, str, str]]) -> dict[str, str]:
    """Return versions by name; a package that is there for two machines has both in its names."""
    rows = list(packages)
    twice = (
        {name for name, architecture, _ in rows if sum(1 for other, _, _ in rows if other == name) > 1}
        if (len({name for name, _, _ in rows}) < len(rows))
        else set[str]()
    )
    return {f"{name}:{architecture}" if name in twice else name: version for name, architecture, version in rows}


def _conda(urls: Iterable[str]) -> dict[str, str]:
    """Return versions with builds by name: https://docs.conda.io/projects/conda/en/stable/user-guide/concepts/pkg-specs.html."""
    found = {}
    for url in urls:
        file = url.partition("#")[0].rpartition("/")[2]
        name, _, version = file.removesuffix(".conda").removesuffix(".tar.bz2").rpartition("-")
        name, _, number = name.rpartition("-")
        found[name] = f"{number}-{version}"
    return found


def compare(old: Contents, new: Contents, *, sizes: tuple[int, int] = (0, 0)) -> Comparison:
    """Return what moved; a kind that one side does not tell of is left out."""
    changes = []
    packages = 0
    for kind in KINDS:
        if kind not in old or kind not in new:
            continue
        before, after = old[kind], new[kind]
        names = sorted({*before, *after})
        packages += len(names) if kind not in ("base", "env") else 0
        changes += [
            Change(kind=kind, name=name, old=before.get(name), new=after.get(name))
            for name in names
            if before.get(name) != after.get(name)
        ]
    return Comparison(changes=tuple(changes), packages=packages, sizes=sizes)


def of_locks(old: Lock | None, new: Lock) -> Comparison:
    """Return what one lock has otherwise than another, on all its platforms: each name is that of its platform, too."""
    found = [_compared(old, new, machine) for machine in new.machines]
    return Comparison(
        changes=tuple(dict.fromkeys(change for each in found for change in each.changes)),
        packages=sum(each.packages for each in found),
        sizes=(0, 0),
    )


def _compared(old: Lock | None, new: Lock, machine: Machine) -> Comparison:
    before = old.machine(machine.platform) if old else None
    known = _of_lock(old, before) if old and before else {kind: {} for kind in KINDS}
    found = compare(known, _of_lock(new, machine))
    named = (replace(each, name=f"{each.name} on {machine.platform}") for each in found.changes)
    return replace(found, changes=tuple(named))


def _of_lock(lock: Lock, machine: Machine) -> Contents:
    base = {lock.base: lock.digest} if lock.digest else {}
    taken = {material.source: material.digest for material in lock.materials}
    return {**locked(machine), "base": base | taken, "source": {each.name: each.commit for each in lock.sources}}
