"""The rosdep keys of the package.xml files that are built, and those among them that rosdep does not have."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from functools import cache

from roslab.config.model import Kind
from roslab.decide.decision import Warning_
from roslab.decide.reasons import warn
from roslab.decide.ros.credited import credited
from roslab.decide.ros.misnamed import (
    BUILD_TYPES,
    as_apt_writes,
    elsewhere,
    left_over,
    library_called,
    of_python_3,
    packaged,
)
from roslab.decide.ros.pip_keys import brought_by_pip, of_code
from roslab.decide.ros.workspace import Packages
from roslab.decide.system.names import Target
from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import Evidence
from roslab.evidence.prose.apt_scripts import adds_a_source
from roslab.evidence.ros.conditions import holds
from roslab.knowledge.distros import distro, ubuntus, ubuntus_with_python2
from roslab.knowledge.recipes import unpacked
from roslab.knowledge.released import released, rosdep_keys
from roslab.knowledge.ros_sources import ros_sources
from roslab.knowledge.vendor_packages import vendor_of
from roslab.values.dataclass import dataclass, replace
from roslab.values.pattern import pattern

_NO_KEY = pattern(r"rosdep has no key (\S+) for ROS (\S+): (.+)")
_OF_CMAKE = pattern(r"nothing is known that brings (\S+), which CMake requires")
_GOES_ON = ", and goes on without it where it is not there"
_LOOKS = f"the build looks for it in {{}}{_GOES_ON}"
_STOPS = "the build looks for it in {}, and stops where it is not there"
_STOPS_AT = ", and stops without it at {}, which the default command needs and whose code includes its headers"
_HARMLESS = "nothing else of its package names it, so that it does no harm; remove it there"
_HARMLESS_ALL = "nothing else of their packages names them, so that they do no harm; remove them there"
_PIPS_NAME = "the name of a package of pip, not a key of rosdep"
_NOWHERE = "nothing here says where it comes from"
_MOST_MEANT = 3
"""Most names that a warning proposes for one."""
_ONE = pattern(r"(?<= )(hold|looks for|without) it(?= |;)")
_NOT_INSTALLED = frozenset({"doc"})
"""rosdep leaves documentation alone."""
_OF_PIP = "-pip"
"""How keys end for which rosdep calls pip: https://github.com/ros/rosdistro/blob/master/CONTRIBUTING.md"""


@dataclass(frozen=True, kw_only=True, slots=True)
class Translated:
    """What to install for a key that is a library's name and no rosdep key, and the warning about it."""

    guessed: tuple[str, ...] = ()
    """Packages that the Ubuntu may lack."""
    recipe: str = ""
    skip: bool = False
    warning: Warning_ | None = None
    unknown: bool = False
    """Nothing of the tree says where it comes from."""


def declared_keys(packages: Packages, target: Target, kind: Kind) -> tuple[Dependency, ...]:
    """Return the keys of the packages that are built, and of those that they add, each once and sorted.

    Their conditions are evaluated.
    """
    variables = {
        "ROS_VERSION": "1" if kind == "ros1" else "2",
        "ROS_DISTRO": target.ros_distro or "",
        "ROS_PYTHON_VERSION": "2" if target.ubuntu in ubuntus_with_python2() and kind == "ros1" else "3",
    }
    found: dict[str, Dependency] = {}
    for manifest in (*packages.built, *packages.nested):
        for dependency in manifest.dependencies:
            if dependency.role in _NOT_INSTALLED or dependency.name in packages.names:
                continue
            if holds(dependency.condition, variables):
                found.setdefault(dependency.name, dependency)
    return tuple(found[name] for name in sorted(found))


def by_pip(keys: Iterable[str]) -> bool:
    """Tell whether rosdep calls pip for one of the keys."""
    return any(key.endswith(_OF_PIP) for key in keys)


def own_packages(keys: Iterable[Dependency], evidence: Evidence, target: Target) -> dict[str, tuple[Dependency, ...]]:
    """Return the packages of the keys that rosdep does not have and that a list of the repository's own defines."""
    own = {each.name: each for each in evidence.own_keys}
    there = rosdep_keys() | released(target.ros_distro or "")
    number = next((number for number, name in ubuntus().items() if name == target.ubuntu), "")
    found: dict[str, tuple[Dependency, ...]] = {}
    for mine in (own[key.name] for key in keys if key.name in own and key.name not in there):
        by = dict(mine.apt)
        packages = by.get(target.ubuntu or "") or by.get(number) or by.get("*", ())
        if packages:
            found[mine.name] = tuple(
                Dependency(namespace="apt", name=name, strength="declared", file=mine.file, line=mine.line, role="key")
                for name in packages
            )
    return found


def translate(
    key: Dependency,
    target: Target,
    *,
    cloned: bool,
    submodules: tuple[str, ...] = (),
    tried: str = "",
    installed: Collection[str] = (),
    evidence: Evidence,
) -> Translated:
    """Return what to do about a key that rosdep cannot resolve: a library's packages or recipe, else a warning.

    ``cloned``: a sister repository, whose packages are not known before it is cloned, may hold it. ``submodules``: the
    folders of submodules; one that is named like the key and has no package.xml is not checked out. ``tried``: where
    the build looks for it, in words. ``installed``: what pip installs. ``evidence``: code of
    C++ may be compiled with it.
    """
    name = key.name
    if name in rosdep_keys() or name in released(target.ros_distro or "") or _of_python_2(name, target):
        return Translated()
    if useless := _useless(key, target.ros_distro, installed, evidence):
        return Translated(skip=True, warning=warn(useless, key))
    found = library_called(name, target.ubuntu)
    new = of_python_3(name, target)
    meant = (new,) if new else packaged(name, target)
    what = f"a key for Python 2, which ROS {target.ros_distro} has not" if new else _PIPS_NAME
    if not meant and found is None and (spelled := as_apt_writes(name, target)):
        meant, what = (target.ros(spelled),), f"no key of rosdep, {spelled} is"
    if meant and not (found and found.apt and of_code(key, evidence)):
        message = f"{name} is {what}: {meant[0]} is installed for it"
        return Translated(guessed=meant, skip=True, warning=warn(message, key))
    if found and found.ros and target.knows(found.ros):
        found = replace(found, apt=(target.ros(found.ros),))
    if found is None or not (found.apt or found.recipe):
        if key.namespace == "ros":  # of a manifest.xml
            message = f"ROS {target.ros_distro} has no package {name}, and nothing here says where it comes from"
            hint = "it is taken out of the manifest in the image, and rosmake stops where the code needs it"
            return Translated(skip=True, warning=warn(f"{message}: {hint}", key))
        message = f"rosdep has no key {name} for ROS {target.ros_distro}"
        folder = next((path for path in submodules if path.rpartition("/")[2] == name), credited(name, evidence))
        brought = bool(cloned or folder or tried)
        alone = not brought and any(m.topic == "only_in_manifest" and m.value == name for m in evidence.mentions)
        hint = _harmless(name, target) if alone else _hint(name, target, cloned=cloned, folder=folder, tried=tried)
        needs, installer = vendor_of(name)
        vendors = f"; it needs {needs}, which the image lacks ({installer})" if needs else ""
        return Translated(warning=warn(f"{message}: {hint}{vendors}", key), unknown=not brought)
    how = "from an archive of its project" if unpacked(found.recipe) else "built from source"
    instead = " ".join(found.apt) or f"{found.recipe}, {how},"
    message = f"{name} is the name of a library, not a key of rosdep: {instead} is installed for it"
    return Translated(
        guessed=found.apt,  # a wrong guess must not stop the installation of all others
        recipe="" if found.apt else found.recipe,
        skip=True,
        warning=warn(message, key),
    )


def _useless(key: Dependency, ros_distro: str | None, installed: Collection[str], evidence: Evidence) -> str:
    """Return what is wrong with a key that no repository can bring, ``""`` where one can."""
    name = key.name
    if by_pip := brought_by_pip(key, installed, evidence):
        return f"{name} is no key of rosdep for ROS {ros_distro}: pip installs {by_pip}"
    if left_over(name, ros_distro):
        return f"rosdep has no key {name} for ROS {ros_distro}: left over from ROS 1; remove the dependency"
    if name in BUILD_TYPES:
        return f"{name} is the build type of a package, which <export> names, and no package: remove the dependency"
    return ""


def _of_python_2(name: str, target: Target) -> bool:
    """Tell whether a key is one of Python 2's, for a distribution that has it: today's tables lack many of them.

    rosdep reads those of the distribution's time, and tells in the image which are not there.
    """
    release = distro(target.ros_distro)
    return name.startswith("python-") and release is not None and release.python.startswith("2")


def of_an_apt_source(keys: Sequence[str], target: Target, evidence: Evidence) -> Warning_ | None:
    """Return one warning about all unknown keys, at the line of a page that adds a source of apt: they may be there."""
    pages = (m for m in evidence.mentions if m.topic == "step" and m.source == "readme" and "/" not in m.file)
    step = next((mention for mention in pages if adds_a_source(mention)), None)
    if not keys or step is None:
        return None
    message = f"rosdep has no key {', '.join(keys)} for ROS {target.ros_distro}"
    hint = f"what `{step.value}` adds to apt may have them; run it under `custom` in roslab.yaml"
    return warn(f"{message}: {hint}, or give their repositories under `source`", step)


def together(warnings: Iterable[Warning_]) -> Iterator[Warning_]:
    """Yield the warnings, those about several keys of which the same is said as one, at the place of the first."""
    alike: dict[tuple[str, str], list[tuple[Warning_, str]]] = {}
    for warning in warnings:
        match = _NO_KEY.fullmatch(warning.message)
        said = (match[2], match[3]) if match else (warning.message, f"{warning.file}:{warning.line}")
        alike.setdefault(said, []).append((warning, match[1] if match else ""))
    for (named, hint), found in alike.items():
        first, _ = found[0]
        if len(found) == 1 or not found[0][1]:
            yield from (warning for warning, _ in found)
            continue
        names = [name for _, name in found]
        plural = (
            _HARMLESS_ALL
            if hint == _HARMLESS
            else _ONE.sub(lambda one: f"{one[1]} them", hint)
            .replace("where it is not", "where they are not")
            .replace("correct the name", "correct the names")
        )
        keys = f"{', '.join(names[:-1])} and {names[-1]}"
        yield replace(first, message=f"rosdep has no keys {keys} for ROS {named}: {plural}")


def not_tried(
    warnings: Iterable[Warning_], before: Mapping[str, str], after: Mapping[str, str], stops: Collection[str]
) -> Iterator[Warning_]:
    """Yield the warnings, which tell of the repositories ``before``, with those ``after``, in which the build looks.

    Both have for each package where it is looked for. ``stops``: packages that the build stops without.
    """
    there = [name for name in before if name in after]
    changed = {_LOOKS.format(url): _NOWHERE for name, url in before.items() if name not in after}
    changed |= {_LOOKS.format(before[name]): _LOOKS.format(after[name]) for name in there}
    changed |= {_LOOKS.format(before[name]): _STOPS.format(after[name]) for name in there if name in stops}
    for warning in warnings:
        found = next((each for each in changed if each in warning.message), "")
        yield replace(warning, message=warning.message.replace(found, changed[found])) if found else warning


def stopping(
    warnings: Iterable[Warning_], packages: Packages, needed: Collection[str], evidence: Evidence
) -> Iterator[Warning_]:
    """Yield the warnings, with what it means that a ``needed`` package does not compile without a key.

    What it includes under a condition alone it may do without.
    """
    sure = (each for each in evidence.code if each.namespace == "include" and each.strength != "optional")
    folders = {each.name.partition("/")[0] for each in sure}
    asking = [m for m in packages.built if m.name in needed]
    stopped = {d.name: m.name for m in asking for d in m.dependencies if d.name in folders}
    for warning in warnings:
        match = _NO_KEY.fullmatch(warning.message)
        package = stopped.get(match[1]) if match else None
        said = warning.message.replace(_GOES_ON, _STOPS_AT.format(package)) if package else warning.message
        yield replace(warning, message=said)


def once(warnings: Iterable[Warning_], of_cmake: Iterable[Warning_]) -> Iterator[Warning_]:
    """Yield the warnings without those on keys of which CMake's tell more, unless another name is meant."""
    told = {match[1] for each in of_cmake if (match := _OF_CMAKE.match(each.message))}
    for warning in warnings:
        match = _NO_KEY.fullmatch(warning.message)
        if not (match and match[1] in told and " meant?)" not in match[3]):
            yield warning


def _harmless(name: str, target: Target) -> str:
    near = _near(name, target)
    return f"{_HARMLESS}, or correct the name (is {near} meant?)" if near else _HARMLESS


def _hint(name: str, target: Target, *, cloned: bool, folder: str, tried: str) -> str:
    if folder:
        return f"the submodule {folder} may hold it, but is not checked out: git submodule update --init --recursive"
    near = _near(name, target)
    where = "one of the cloned repositories may hold it" if cloned else _NOWHERE
    if tried:
        where = _LOOKS.format(tried)
    elif (
        where == _NOWHERE and (here := distro(target.ros_distro)) and (tabled := ros_sources(name, here.ros, here.name))
    ):
        url = tabled[-1].repo.removesuffix(".git")
        where = f"{url} has a package of that name"
    elif where == _NOWHERE and (other := elsewhere(name, target.ros_distro)):
        where = f"ROS {other} has a package of that name"
    correct = f"correct the name (is {near} meant?)" if near else "correct the name"
    return f"{where}; else {correct}, or give its repository under source in roslab.yaml"


def _near(name: str, target: Target) -> str | None:
    """Return the known names that one may be a slip for, as a sentence has them."""
    from roslab.decide.ros.slips import meant, nearest  # noqa: PLC0415 - for a key that nobody knows

    known = _known(target.ros_distro or "")
    return " or ".join(meant(name, known)[:_MOST_MEANT]) or nearest(name, known)


@cache
def _known(ros_distro: str) -> frozenset[str]:
    return frozenset(rosdep_keys() | released(ros_distro))
