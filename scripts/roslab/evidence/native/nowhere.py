"""Headers that code includes as the tree's own, and that nothing in it is or makes: such code does not compile."""

from __future__ import annotations

import posixpath
from collections.abc import Collection, Iterator, Mapping
from functools import cached_property

from roslab.evidence import places
from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import PackageManifest
from roslab.evidence.lex.cmake import EVERY, calls
from roslab.evidence.lex.lines import end_of_line, lines_with
from roslab.evidence.native.cmake_needs import made_here
from roslab.evidence.native.limits import HEADERS, Signs, conditional
from roslab.evidence.native.unlisted import Unlisted
from roslab.repository.checkout import File, Repository
from roslab.values.dataclass import dataclass, field
from roslab.values.pattern import pattern

_MESSAGE = pattern(r"(\w+)/(\w+)\.h|(\w+)/(?:msg|srv|action)/(\w+)\.hpp")
"""A message's header, https://wiki.ros.org/msg, also of a name that no message should have."""
_PART = pattern(r"__\w+$|(?:Action)?(?:Request|Response|Goal|Result|Feedback|Action)$")
"""What a service and an action add to the names of their headers, and Dashing to the parts of one (``__struct``)."""
_GENERATED = pattern(r"Config\.h$|_export\.h$|\.pb\.h$|visibility_control\.h")
"""Headers that CMake makes of other files than messages."""
_INTERFACES = (".msg", ".srv", ".action", ".idl")
_OF_LIBRARY = pattern(r"([A-Za-z]\w{3,})/(?:\1|(?!\1/)[\w./-]+)\.(?:h|hpp|hh)")
"""A header in a library's folder: ``fbow/fbow.h``, which some have for all of their own, or another one."""
_OF_ALL = pattern(r"(\w+)/\1\.\w+$")
_ELSEWHERE = pattern(
    r"(?:mach|Carbon|Cocoa|Core\w+|IOKit|Foundation|ApplicationServices|Audio\w+|OpenGL|GLUT|android|thrust|cuda)/"
)
"""Headers of other systems, for which alone a source with them is, and of CUDA's toolkit."""
LIBRARY = "library"
"""The role of such a header."""
_WORKSPACE = pattern(r"(?:\.\./)+(?:[\w.-]+/)*(?:build|devel|install)/")
"""A path to what the workspace is built into."""


@dataclass
class Nowhere:
    """The includes of a repository's packages that no header fits."""

    repository: Repository
    manifests: tuple[PackageManifest, ...]
    submodules: tuple[str, ...] = ()
    found: dict[tuple[str, str], dict[str, Dependency]] = field(default_factory=dict)
    """By the header and the package that includes it, by the files that do."""
    known: dict[str, bool] = field(default_factory=dict)
    _calls: dict[str, Mapping[str, list[bool]]] = field(default_factory=dict)

    def header(self, name: str, file: File, text: str, position: int) -> bool:
        """Note an include at a position of a file if its header is nowhere, and tell whether it is."""
        if name not in self.known:
            self.known[name] = bool(self.manifests) and self._lacks(name)
        library = not self.known[name] and self.of_library(name)
        if not (self.known[name] or library):
            return False
        package = self._package(file.path) if self.manifests else ""
        places_of = self.found.setdefault((name, package or ""), {})
        if package is not None and file.path not in places_of and not conditional(text, position):
            path = posixpath.normpath(posixpath.join(file.folder, name))
            if not name.startswith("../") or not (self.repository.may_have(path) or self._within(path, package)):
                line = text.count("\n", 0, position) + 1
                role = LIBRARY if library else ""
                places_of[file.path] = Dependency(
                    namespace="nowhere", name=name, strength="used", file=file.path, line=line, role=role
                )
        return self.known[name]

    def all(self, signs: Signs) -> Iterator[Dependency]:
        """Yield each once, where a compiler first comes to a file with it: a source, or what one includes.

        ``signs`` tell what each file includes.
        """
        unlisted = Unlisted(self.repository)
        for places_of in self.found.values():
            if first := next((each for each in places_of.values() if self._compiled(each, signs, unlisted)), None):
                yield first

    def _compiled(self, each: Dependency, signs: Signs, unlisted: Unlisted) -> bool:
        if places.aside(each.file):
            return False
        if each.file.endswith(HEADERS):
            return each.file.rpartition("/")[2] in signs.reached_by(unlisted)
        return not (unlisted.has(each.file) or (each.role == LIBRARY and self._waits(each.file)))

    def _waits(self, path: str) -> bool:
        """Tell whether every call of CMake that names a source waits for something that may be off."""
        folder, _, name = path.rpartition("/")
        above = [folder]
        while above[-1]:
            above.append(above[-1].rpartition("/")[0])
        files = [file for file in self.repository.named("CMakeLists.txt") if file.folder in above]
        named = [made for file in files for made in self._made(file).get(name, ())]
        return bool(named) and not any(named)

    def _made(self, file: File) -> Mapping[str, list[bool]]:
        """Return for each word of a CMakeLists.txt, without folders, whether the calls that have it are always made."""
        if file.path not in self._calls:
            found: dict[str, list[bool]] = {}
            for call in calls(self.repository.read(file), EVERY):
                made = made_here(call.conditions)
                for word in {word.rpartition("/")[2] for word in call.written}:
                    found.setdefault(word, []).append(made)
            self._calls[file.path] = found
        return self._calls[file.path]

    def of_library(self, name: str) -> bool:
        """Tell whether a header is one of a library elsewhere: no file of the tree has its name, or makes it."""
        if not _OF_LIBRARY.fullmatch(name) or _ELSEWHERE.match(name):
            return False
        last = name.rpartition("/")[2]
        alone = _OF_ALL.match(name) or not self.repository.named(last)
        return bool(alone) and not (_GENERATED.search(name) or self._written(name))

    def _lacks(self, name: str) -> bool:
        """Tell whether no file of the tree is this header or makes it, though it is called like one of the tree's."""
        last = name.rpartition("/")[2]
        if self.repository.named(last, f"{last}.in") or _GENERATED.search(name) or _WORKSPACE.match(name):
            return False
        if name.startswith("../"):
            return True
        match = _MESSAGE.fullmatch(name)
        package = (match[1] or match[3]) if match else ""
        folders = [posixpath.dirname(each.file) for each in self.manifests if each.name == package and not each.ignored]
        if not (match and folders) or not any(map(self._makes_messages, folders)):
            return False
        message = match[2] or match[4]
        stems = {_plain(message), _plain(_PART.sub("", message))}
        if any(_plain(file.name.rpartition(".")[0]) in stems for file in self.repository.suffixed(*_INTERFACES)):
            return False
        return not any(message in self.repository.read(file) for file in self._cmake(folders))

    def _written(self, name: str) -> bool:
        """Tell whether a header has a template, or CMake names it with its folder, as it does to make it of a file."""
        if self.repository.named(f"{posixpath.basename(name)}.in"):
            return True
        return name in self._lists

    @cached_property
    def _lists(self) -> str:
        """The lines of every list of CMake that may name a header."""
        texts = (self.repository.read(file) for file in self.repository.named("CMakeLists.txt"))
        return "\n".join(text[start : end_of_line(text, start)] for text in texts for start in lines_with(text, ".h"))

    def _within(self, path: str, package: str) -> bool:
        """Tell whether a path is inside of a package, where it may be generated, or in a submodule."""
        inside = self._package(path) == package and not path.startswith("..")
        return inside or any(path.startswith(f"{folder}/") for folder in self.submodules)

    def _makes_messages(self, folder: str) -> bool:
        return any(
            file.path.startswith(f"{folder}/" if folder else "") for file in self.repository.suffixed(*_INTERFACES)
        )

    def _cmake(self, folders: Collection[str]) -> Iterator[File]:
        for file in self.repository.named("CMakeLists.txt"):
            if any(not folder or file.path.startswith(f"{folder}/") for folder in folders):
                yield file

    @cached_property
    def _folders(self) -> frozenset[str]:
        """The folders of the packages."""
        return frozenset(posixpath.dirname(each.file) for each in self.manifests)

    def _package(self, path: str) -> str | None:
        """Return the folder of the package that a path lies in, ``None`` for none."""
        while path:
            path = posixpath.dirname(path)
            if path in self._folders:
                return path
        return None


def _plain(name: str) -> str:
    return name.replace("_", "").lower()
