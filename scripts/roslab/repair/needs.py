"""Which packages of a workspace use which others, and what the image is for: what must be built in any case."""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Iterable, Iterator

from roslab.decide.programs import owner
from roslab.decide.ros.workspace import packages_of
from roslab.evidence.facts import PackageManifest
from roslab.repair.change import Given
from roslab.values.dataclass import dataclass
from roslab.values.pattern import pattern
from roslab.values.words import line_of

_SHELL = "bash"
_COMMENT = pattern(r"(?m)#[^\n]*")
_CMAKE = ("CMakeLists.txt", ".cmake")
_READ = (
    *_CMAKE,
    *(".c", ".cc", ".cpp", ".cxx", ".h", ".hh", ".hpp", ".hxx", ".ipp", ".py", ".sh", ".bash"),
    *(".launch", ".xml", ".test", ".xacro", ".urdf", ".sdf", ".world", ".yaml", ".yml", ".rviz", ".msg", ".srv"),
    ".action",
)
"""Ends of the names of files that may use another package; so may those without an end, as scripts are."""
_MOST = 4000
"""Most files that are read: of more, nothing is certain."""
_BEFORE = r"""(?:["'<(/]|\$\(find |find-pkg-(?:share|prefix) |package://|\b(?:from|import|rosrun|roslaunch) |: ?|^"""
_BEFORE += r"""|\bros2 (?:run|launch) )"""
_AFTER = r"""(?=["'>)/.]|::|\s|$)"""


@dataclass(frozen=True, kw_only=True, slots=True)
class Needs:
    """What the packages that are built need of each other."""

    built: dict[str, PackageManifest]
    """Those that are built, by name; a metapackage of them builds nothing."""
    started: frozenset[str]
    """Packages that the default command starts or a test names, or of which the page at the root launches something."""
    shell: bool
    """Nothing but a shell is started, or what has to do with no package: each may be what the image is for."""
    uses: Callable[[str], Collection[str]]
    """Returns the packages that one needs to be built, or may need once it runs."""

    def of(self, names: Iterable[str]) -> frozenset[str]:
        """Return these packages and all that they need in turn."""
        found = dict.fromkeys(name for name in names if name in self.built)
        pending = [*found]
        for name in pending:
            new = [each for each in self.uses(name) if each not in found]
            found |= dict.fromkeys(new)
            pending += new
        return frozenset(found)


def needs(given: Given) -> Needs | None:
    """Return what the packages need; ``None`` where that cannot be told: no workspace, or too many files."""
    packages = packages_of(given.evidence)
    files = {*given.plan.rosdep.manifests} if given.plan.rosdep else set()
    built = {m.name: m for m in packages.built if m.name and m.file in files}
    folders = {m.file.rpartition("/")[0]: name for name, m in built.items()}
    texts: dict[str, list[str]] = {}
    for file in sorted(given.files):
        uses_others = file.endswith(_READ) or "." not in file.rpartition("/")[2]
        if uses_others and (name := owner(file, folders)):
            texts.setdefault(name, []).append(file)
    if given.read is None or not built or sum(map(len, texts.values())) > _MOST:
        return None
    read, kept = given.read, dict[str, frozenset[str]]()

    def uses(name: str) -> Collection[str]:
        if name not in kept:
            said = {each for file in texts.get(name, ()) for each in _named(file, read(file), built)}
            asked = {d.name for d in built[name].dependencies if d.role not in {"test", "doc"}}
            kept[name] = frozenset((said | (asked & built.keys())) - {name})
        return kept[name]

    lines = [line_of(each) for each in (given.plan.run.command, given.config.test) if each]
    words = [word for line in lines for word in line.split()]
    at = (owner(file, folders) for word in words for file in [word.removeprefix("./")] if file in given.files)
    scripts = (word.removeprefix("./") for word in words)
    beside = {name for file in scripts if file in given.files for name in _named(file, read(file), built)}
    named = {*given.plan.workspace.must_build, *words, *(name for name in at if name), *beside} & built.keys()
    told = {line for line in lines if line != _SHELL}
    return Needs(built=built, started=frozenset(named), shell=not (told and named), uses=uses)


def _named(file: str, text: str, names: Collection[str]) -> Iterator[str]:
    """Yield the packages that a file names where it means packages: in an include, an import, a launch file's find."""
    among = [name for name in names if name in text]
    if not among:
        return
    words = "|".join(re.escape(name) for name in sorted(among, key=len, reverse=True))
    if file.endswith(_CMAKE):
        text, whole = _COMMENT.sub("", text), rf"(?<![\w-])({words})(?![\w-])"
    else:
        whole = rf"(?m){_BEFORE}({words}){_AFTER}"
    yield from dict.fromkeys(re.findall(whole, text))
