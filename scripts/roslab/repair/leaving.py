"""Packages that do not compile and that nothing needs: the build goes on without them, by ``skip_packages``."""

from __future__ import annotations

from collections.abc import Collection, Iterator

from roslab.config.addition import Entry, has
from roslab.decide.programs import owner
from roslab.decide.ros.workspace import packages_of
from roslab.decide.system.left_out import SKIP, needing
from roslab.explain.answer import Answer, Explanation
from roslab.knowledge.failures import of_machine
from roslab.plan.ros_build import WORKSPACE
from roslab.repair.asked import asked, here, in_log
from roslab.repair.change import Asked, Change, Given
from roslab.repair.needs import Needs, needs
from roslab.values.dataclass import dataclass
from roslab.values.origin import Place
from roslab.values.pattern import pattern

KEY = "skip_packages"
_COMPILER = pattern(
    r"(?m)^(?P<file>[^\s:]{1,300}):(?P<line>\d{1,6})(?::\d{1,5})?: (?:fatal )?error: (?P<said>[^\n]{1,300})"
)
_CMAKE = pattern(
    r"(?m)^CMake Error at (?P<file>\S{1,300}):(?P<line>\d{1,6}) [^\n]{0,100}:\n"
    r"(?:[ \t]{0,8}\n)?[ \t]{1,8}(?P<said>[^\n]{1,300})"
)
_LINKER = pattern(r"\b(?:undefined reference to|multiple definition of|cannot find -l)[^\n;]{1,200}")
_SHARE = 2
"""Where a shell is started, one of so many packages may be left out: of more, something else is wrong."""
_LONGEST = 120
_QUOTES = str.maketrans("\u2018\u2019\u201c\u201d", "''\"\"")
_AKA = pattern(r" \{aka [^}\n]{1,200}\}")


@dataclass(frozen=True, kw_only=True, slots=True)
class Left:
    """What is left out, or why nothing is."""

    changes: tuple[Change, ...] = ()
    why: str = ""


def left_out(answer: Answer, given: Given) -> Left:
    """Return the packages in which a build stopped and which are left out of the next one, as changes of roslab.yaml.

    Each step that failed must have stopped in packages of the repository alone, by no fault of the network or the
    machine, and the default command, its launch files and the tests must need none of them, nor of those that cannot be
    built without them. Where a shell is started, nothing that remains may need them.
    """
    build = given.plan.workspace.ros
    if build is None or build.tool not in SKIP or given.plan.author_dockerfile or given.config.generation != "today":
        return Left()
    failed: dict[str, Explanation] = {}
    for found in answer.explanations:
        names = _packages(found, given)
        if not names or found.id in of_machine():
            return Left()
        failed |= {name: found for name in names if name not in failed}
    needed = needs(given) if failed else None
    if needed is None or any(has(given.config, Entry(key=KEY, value=name)) for name in failed):
        return Left()
    packages = packages_of(given.evidence)
    with_it = {name: needing(name, packages) for name in failed}
    going = {each for names in with_it.values() for each in names}
    if why := _kept(needed, {*failed}, going, len(given.config.skip_packages)):
        return Left(why=why)
    reason = "nothing else needs it" if needed.shell else "the command does not need it"
    whole = len(failed) == 1
    return Left(
        changes=tuple(
            _change(name, found, given, others=with_it[name][1:], reason=reason, whole=whole)
            for name, found in failed.items()
        )
    )


def _packages(found: Explanation, given: Given) -> tuple[str, ...]:
    """Return the packages of the repository in which a step stopped; none where one of them is another's."""
    own = {m.file.rpartition("/")[0]: m.name for m in packages_of(given.evidence).built if m.name}
    place = given.plan.workspace.folder
    before = f"{place}/".removeprefix(f"{WORKSPACE}/src/") if place != WORKSPACE else ""
    names = []
    for said in found.packages:
        if said in own.values():
            names.append(said)
            continue
        path = said.removeprefix(before) if place != WORKSPACE else f"src/{said}"
        at = owner(f"{path}/CMakeLists.txt", own) if place == WORKSPACE or f"{said}/".startswith(before) else None
        if at is None:
            return ()
        names.append(at)
    return tuple(dict.fromkeys(names))


def _kept(needed: Needs, failed: Collection[str], going: Collection[str], before: int) -> str:
    """Return why packages must be built, ``""`` if the image is of use without them."""
    listed = ", ".join(sorted(failed))
    if lost := needed.of(needed.started) & {*going}:
        who = "the page" if needed.shell else "the command"
        return f"{listed} does not compile, and {who} needs {min(lost & {*failed} or lost)}"
    stay = {name for name, m in needed.built.items() if name not in going and not m.metapackage}
    if not stay:
        return f"{listed} does not compile, and no other package would be left"
    if not needed.shell:
        return ""
    if {*going} - {*failed} or needed.of(stay) & {*failed}:
        return f"{listed} does not compile, and other packages need it"
    if (before + len(failed)) * _SHARE > before + len(failed) + len(stay):
        return f"{listed} does not compile, and {before} packages are left out already"
    return ""


def _change(
    name: str, found: Explanation, given: Given, *, others: Collection[str], reason: str, whole: bool
) -> Change:
    said, place = _said(name, found, given, whole=whole)
    at = f" at {place}" if place else ""
    more = f"; with it {', '.join(others)}, which cannot be built without it" if others else ""
    return Change(
        key=KEY,
        value=name,
        failure=found.id or "",
        certain=True,
        asked=Asked(what=said, place=place),
        why=f"does not compile: {said}{at}; {reason}{more}",
    )


def _said(name: str, found: Explanation, given: Given, *, whole: bool) -> tuple[str, Place | None]:
    """Return what stopped the compilation of a package, and where; ``whole``: the step stopped in no other one."""
    folder = next(m.file.rpartition("/")[0] for m in packages_of(given.evidence).built if m.name == name)
    inside = f"{folder}/" if folder else ""
    for kind in (_COMPILER, _CMAKE):
        for match in kind.finditer(found.log):
            file = here(match["file"], given.files, (inside,))
            if file.startswith(inside) and file:
                known = found.cause.partition(":")[0] if kind is _CMAKE and whole else ""
                return _short(known or match["said"]), Place(file=file, line=int(match["line"]))
    if whole and (linker := next(_LINKER.finditer(found.log), None)):
        return _short(linker[0]), None
    place = in_log(found, given)
    if place and not place.file.startswith(inside):
        place = None
    return (_short(found.error) if whole and found.error else "its build ends with an error"), place


def _short(text: str) -> str:
    """Return what a compiler said on one line, in plain quotation marks and without what it adds to help."""
    plain = text.translate(_QUOTES).partition("; did you mean ")[0]
    flat = " ".join(_AKA.sub("", plain).split())
    return flat if len(flat) <= _LONGEST else f"{flat[: _LONGEST - 1]}…"


def told(changes: Collection[Change]) -> Iterator[str]:
    """Yield what each change does, as it is said after the number of a repair."""
    for change in changes:
        yield (
            f"leaves out {change.value}, which {change.why}"
            if change.key == KEY
            else f"adds {change}, for {change.asked}"
        )


def without_useless(changes: Collection[Change], answer: Answer, given: Given) -> list[Change]:
    """Return the changes without those that were made for what fails still."""
    still = {(found.id, asked(found, given).what) for found in answer.explanations if found.id}
    return [change for change in changes if (change.failure, change.asked.what) not in still]
