"""What a launch file needs by way of what it starts: launch files, robot descriptions, programs of Python.

Only what is loaded whatever the arguments are is followed: what a condition or an argument decides may never be.
"""

from __future__ import annotations

import posixpath
import re
from collections.abc import Callable, Iterator, Mapping

from roslab.evidence.dependency import Dependency
from roslab.evidence.launch_file import LaunchFile
from roslab.evidence.lex.always_run import always_run
from roslab.evidence.lex.xml_comments import without_xml_comments
from roslab.evidence.ros import rviz_plugins
from roslab.evidence.ros.given_arguments import Given, filled, given_to
from roslab.evidence.ros.gone import included_elsewhere
from roslab.evidence.ros.read_descriptions import always_read
from roslab.repository.checkout import File, Repository
from roslab.values.dataclass import replace
from roslab.values.pattern import pattern

MAX_SIZE = 256 * 1024
MOST = 60
"""Most files that are followed from one launch file."""
_PACKAGE = r"[a-z][a-z0-9_-]{1,60}"
_FOUND = pattern(rf"\$\(\s*find(?:-pkg-share)?\s+['\"]?({_PACKAGE})['\"]?\s*\)(?:/([\w./-]{{1,200}}\w))?")
_NODE = pattern(r"<node\s([^>]{0,2000})>")
_SAID = pattern(r"\b(pkg|type|exec)\s{0,9}=\s{0,9}[\"']([\w.-]{1,80})[\"']")
_QUOTED = pattern(r"[\"'](?:[\w./-]{0,200}/)?([\w.-]{1,80}\.(?:py|launch\.xml|launch|xacro|urdf|ya?ml|rviz))[\"']")
_LOOK_UP = ("get_path", "get_package_share_directory", "get_package_share_path")
_LOOKED_UP = pattern(
    rf"^[ \t]{{0,99}}[^\n#]{{0,200}}\b(?:{'|'.join(_LOOK_UP)})"
    rf"\(\s{{0,9}}[\"']({_PACKAGE})[\"']\s{{0,9}}\)",
    re.MULTILINE,
)
"""A package that a program of Python looks for, from the beginning of its line."""
_ELSEWHERE = pattern(
    r"#![ \t]{0,9}(/(?:home|Users|root|mnt|media|data)/\S{1,200}|/(?!opt/conda/)\S{0,99}conda\d?/\S{1,200})"
)
"""A first line that names an interpreter in somebody's own folder; images of conda have theirs in `/opt/conda`."""
_IMPORTED = pattern(
    r"^[ \t]{0,80}(?:from[ \t]{1,9}([\w.]{1,200})[ \t]{1,9}import\b|import[ \t]{1,9}([\w., \t]{1,400}))", re.MULTILINE
)
"""What a program of Python imports from, or a list of modules that it imports."""
_GIVEN = pattern(r"(\w{1,60}):=|[\"'](\w{1,60})[\"']\s{0,9}:(?!=)")
"""What a launch file gives xacro: ``sim:=true``, or a mapping of Python."""
_DESCRIPTIONS = (".xacro", ".urdf")
_PARAMETERS = (".yaml", ".yml", ".rviz")

Conditional = Callable[[str, int, int], bool]


def with_reached(
    repository: Repository, found: tuple[LaunchFile, ...], folders: Mapping[str, str], conditional: Conditional
) -> tuple[LaunchFile, ...]:
    """Return the launch files with what they need by way of others.

    ``folders``: the package of each folder, ``conditional``: whether a condition decides about a part of a launch file.
    """
    follow = _Follow(repository, found, folders, conditional)
    foreign = {each.file: tuple(follow.foreign(each)) if each.ros == 1 else () for each in found}
    return tuple(
        replace(
            each,
            reached=tuple(follow.needs(each)),
            foreign=foreign[each.file],
            without_ros=frozenset(file for file, _ in foreign[each.file] if follow.without_ros(file)),
            elsewhere=tuple(follow.elsewhere(each.file)),
            gone=tuple(follow.gone(each.file)),
            loaded=tuple(follow.loaded(each.file)),
        )
        for each in found
    )


class _Follow:
    def __init__(
        self,
        repository: Repository,
        launch: tuple[LaunchFile, ...],
        folders: Mapping[str, str],
        conditional: Conditional,
    ) -> None:
        self.repository, self.conditional = repository, conditional
        self.launch = {each.file: each for each in launch}
        self.packages = {name: folder for folder, name in folders.items()}
        self.given: frozenset[str] | None = None
        self.read: dict[tuple[str, Given], tuple[tuple[tuple[str, Given], ...], tuple[Dependency, ...]]] = {}

    def needs(self, start: LaunchFile) -> Iterator[Dependency]:
        """Yield each package once that the files need which a launch file loads, but not what it names itself."""
        seen = {each.name for each in start.dependencies}
        for path in self.loaded(start.file):
            for each in self._of(path)[1] if path != start.file else ():
                if each.name not in seen:
                    seen.add(each.name)
                    yield each

    def foreign(self, start: LaunchFile) -> Iterator[tuple[str, str]]:
        """Yield the programs of Python that cannot be started as they are, with what their first line names.

        Not those that catkin starts by a program of its own, which it writes where CMake installs them:
        https://github.com/ros/catkin/blob/noetic-devel/cmake/catkin_install_python.cmake, read 2026-11-26.
        """
        for path in self.loaded(start.file):
            file = self._file(path) if path != start.file and path.endswith(".py") else None
            if file is not None:
                named = _ELSEWHERE.match(self.repository.read(file))
                if named and not self._installed(path):
                    yield path, named[1]

    def without_ros(self, path: str) -> bool:
        """Tell whether a program imports nothing of ROS: no package of the tree, or that any distribution released."""
        from roslab.knowledge.released import ever_released  # noqa: PLC0415 - few launch files need it

        file = self._file(path)
        said = _IMPORTED.finditer(self.repository.read(file) if file else "")
        parts = (part.strip() for match in said for part in (match[1] or match[2]).split(","))
        names = {part.partition(" ")[0].partition(".")[0] for part in parts}
        return not any(name in self.packages or ever_released(name) for name in names)

    def elsewhere(self, start: str) -> Iterator[tuple[str, str, int]]:
        """Yield the programs of Python that put folders of the author's machine on their path."""
        for path in self.loaded(start):
            file = self._file(path) if path != start and path.endswith(".py") and path not in self.launch else None
            if file is not None:
                from roslab.evidence.ros import author_paths  # noqa: PLC0415 - few launch files load programs

                yield from ((path, folder, line) for folder, line in author_paths.read(self.repository.read(file)))

    def _installed(self, path: str) -> bool:
        made = (
            f for f in self.repository.named("CMakeLists.txt") if path.startswith(f"{f.folder}/" if f.folder else "")
        )
        name = posixpath.basename(path)
        return any("catkin_install_python" in (text := self.repository.read(f)) and name in text for f in made)

    def gone(self, start: str) -> Iterator[tuple[str, str, str, int]]:
        """Yield the launch files that one and those which it loads include, and that are nowhere."""
        for path in self.loaded(start):
            file = self._file(path) if path in self.launch else None
            if file:
                yield from included_elsewhere(self.repository, file, self.packages, self.conditional)

    def loaded(self, start: str) -> Iterator[str]:
        """Yield a launch file and each file once that it loads."""
        told, taken = set[str](), set[tuple[str, Given]]()
        waiting: list[tuple[str, Given]] = [(start, ())]
        while waiting and len(taken) < MOST:
            path, given = waiting.pop(0)
            if (path, given) not in taken:
                taken.add((path, given))
                yield from (path,) if path not in told else ()
                told.add(path)
                waiting += self._of(path, given)[0]

    def _file(self, path: str) -> File | None:
        found = next((each for each in self.repository.named(posixpath.basename(path)) if each.path == path), None)
        return found if found and found.size <= MAX_SIZE else None

    def _of(self, path: str, given: Given = ()) -> tuple[tuple[tuple[str, Given], ...], tuple[Dependency, ...]]:
        """Return the files that a file loads, each with the arguments that it is given, and the packages it needs."""
        if (path, given) not in self.read:
            self.read[path, given] = self._reading(path, given)
        return self.read[path, given]

    def _reading(self, path: str, given: Given) -> tuple[tuple[tuple[str, Given], ...], tuple[Dependency, ...]]:
        if (file := self._file(path)) is None:
            return (), ()
        text = self.repository.read(file)
        if path in self.launch:
            xml = filled(without_xml_comments(text), given)
            loads = (
                ((each, ()) for each in self._quoted(text, self.launch[path].package))
                if path.endswith(".py")
                else self._started(xml)
            )
            named = self.launch[path].dependencies
            return tuple(loads), tuple(d for d in named if d.namespace == "ros" and d.strength != "optional")
        if path.endswith(_DESCRIPTIONS):
            included = lambda part: (each for each, _ in self._files(part))  # noqa: E731 - as short as its use
            parts = tuple(always_read(path, self._description, included, self._given()))
            return tuple((each, ()) for _, part in parts for each, _ in self._files(part)), tuple(
                _asked(match[1], match, part, name) for name, part in parts for match in _FOUND.finditer(part)
            )
        if path.endswith(".py"):
            found = _LOOKED_UP.finditer(text) if any(call in text for call in _LOOK_UP) else ()
            return (), tuple(_asked(m[1], m, text, path) for m in found if always_run(text, m.start()))
        return (), tuple(_shown(text, path) if path.endswith(".rviz") else ())

    def _given(self) -> frozenset[str]:
        """Return the arguments of descriptions that launch files set, whatever they are."""
        if self.given is None:
            texts = (self.repository.read(file) for file in filter(None, map(self._file, self.launch)))
            self.given = frozenset(one or other for text in texts for one, other in _GIVEN.findall(text))
        return self.given

    def _description(self, path: str) -> str | None:
        """Return the text of a robot description without its comments, ``None`` for another file."""
        file = self._file(path) if path.endswith(_DESCRIPTIONS) else None
        return without_xml_comments(self.repository.read(file)) if file else None

    def _started(self, text: str) -> Iterator[tuple[str, Given]]:
        """Yield the files that a launch file in XML includes or loads, and the programs of Python that it starts."""
        yield from ((each, given_to(text, place)) for each, place in self._files(text))
        for match in _NODE.finditer(text):
            said = dict(_SAID.findall(match[1]))
            name, folder = said.get("type") or said.get("exec") or "", self.packages.get(said.get("pkg", ""))
            if name.endswith(".py") and folder is not None and not self.conditional(text, match.start(), match.end()):
                there: list[tuple[str, Given]] = [
                    (each.path, ())
                    for each in self.repository.named(name)
                    if each.path.startswith(f"{folder}/" if folder else "")
                ]
                yield from there if len(there) == 1 else ()

    def _files(self, text: str) -> Iterator[tuple[str, int]]:
        """Yield the files of the tree's packages that a text names to load, each with its place in the text."""
        for match in _FOUND.finditer(text):
            folder = self.packages.get(match[1])
            if match[2] and folder is not None and not self.conditional(text, match.start(), match.end()):
                yield posixpath.normpath(posixpath.join(folder, match[2])), match.start()

    def _quoted(self, text: str, package: str | None) -> Iterator[str]:
        """Yield what a launch file in Python names that is the only file of its name, or of that in its package."""
        own = f"{folder}/" if (folder := self.packages.get(package or "")) else ""
        for match in _QUOTED.finditer(text):
            there = self.repository.named(match[1])
            if len(there) > 1 and own and match[1].endswith(_PARAMETERS):
                there = tuple(each for each in there if each.path.startswith(own))
            if len(there) == 1 and not self.conditional(text, match.start(), match.end()):
                yield there[0].path


def _shown(text: str, path: str) -> Iterator[Dependency]:
    """Yield the packages of the plugins of a configuration of rviz, which goes on without them."""
    for name, place in rviz_plugins.named(text):
        line = text.count("\n", 0, place) + 1
        yield Dependency(namespace="ros", name=name, strength="optional", file=path, line=line, role="exec")


def _asked(name: str, match: re.Match[str], text: str, path: str) -> Dependency:
    line = text.count("\n", 0, match.start()) + 1
    return Dependency(namespace="ros", name=name, strength="used", file=path, line=line, role="exec")
