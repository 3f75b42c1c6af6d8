"""What has been read of a CMakeLists.txt so far."""

from __future__ import annotations

from itertools import islice

from roslab.evidence.dependency import Dependency, GitSource
from roslab.evidence.installed_path import InstalledPath
from roslab.evidence.lex.cmake import Call
from roslab.evidence.native.find_modules import Asked
from roslab.evidence.native.installed_paths import MAX_PATHS, code_not_there
from roslab.evidence.native.made_targets import TARGET
from roslab.evidence.native.outside import outside_of_workspaces
from roslab.evidence.native.program_folders import ProgramFolders
from roslab.repository.checkout import Repository
from roslab.values.dataclass import dataclass, field, replace
from roslab.values.pattern import pattern

_CODE = pattern(r"\w[\w./+-]*\.(?:c|cc|cpp|cxx|cu)$")
_HERE = pattern(r"^\$\{(?:CMAKE_CURRENT_SOURCE_DIR|CMAKE_CURRENT_LIST_DIR)\}/")
_SWITCH = pattern(r"(?:OFF )?(?!UNIX$|LINUX$|WIN32$|MSVC$|APPLE$)[A-Za-z]\w*(?<!_FOUND)")
_WHERE_FOUND = pattern(r"(?<!NOT )\b(?:(\w+)_FOUND\b|TARGET (\w+)::)")


@dataclass
class Reading:
    """What has been read of one file so far."""

    switches: tuple[str, ...] = ()
    """The conditions of options under which its folder is added."""
    by_tool: tuple[str, ...] = ()
    """Those of the build tool."""
    unset: tuple[str, ...] = ()
    """Those of variables that no file declares as options."""
    outside: dict[tuple[str, int], None] = field(default_factory=dict)
    without: dict[tuple[str, int], frozenset[str]] = field(default_factory=dict)
    name: str | None = None
    minimum: Dependency | None = None
    languages: list[str] = field(default_factory=list)
    macros: dict[str, None] = field(default_factory=dict)
    cuda: list[Call] = field(default_factory=list)
    """The calls that bring CUDA."""
    executables: dict[str, int] = field(default_factory=dict)
    guards: dict[tuple[str, str], None] = field(default_factory=dict)
    optional: dict[tuple[str, str], None] = field(default_factory=dict)
    written: ProgramFolders = field(default_factory=ProgramFolders)
    tests: bool = False
    untested: tuple[str, ...] = ()
    """The options, off by themselves, without which none of them is made."""
    libraries: set[str] = field(default_factory=set)
    targets: dict[str, None] = field(default_factory=dict)
    installed: list[InstalledPath] = field(default_factory=list)
    placed: dict[str, set[str]] = field(default_factory=dict)
    """The folders into which it always installs each target."""
    configs: dict[str, None] = field(default_factory=dict)
    made: dict[str, None] = field(default_factory=dict)
    """Those that it makes by itself, not what lies elsewhere (``IMPORTED``)."""
    named: set[str] = field(default_factory=set)
    """Files of code that programs name, relative to this one's folder."""
    always: dict[str, int] = field(default_factory=dict)
    """Those that a program or a library names as they are and in any case, with their lines."""
    under: dict[str, dict[str, int]] = field(default_factory=dict)
    """Those that are named so where an option is on, which it is by itself, by its name."""
    compiled: set[str] = field(default_factory=set)
    """Those that libraries name."""
    dependencies: list[Dependency] = field(default_factory=list)
    modules: set[Asked] = field(default_factory=set)
    """What was asked of the tree's own modules."""
    sources: list[GitSource] = field(default_factory=list)
    brought: dict[str, None] = field(default_factory=dict)
    linked: dict[str, int] = field(default_factory=dict)
    files: dict[str, int] = field(default_factory=dict)
    """Files of libraries below the source that it always links."""
    included: set[str] = field(default_factory=set)
    """Files of the tree that it includes, and those that they include."""
    newer: dict[str, Dependency] = field(default_factory=dict)

    def library(self, call: Call) -> None:
        """Note a library, with its files where it is made here and does not lie elsewhere (``IMPORTED``)."""
        self._code(call)
        self.libraries.update(call.words[:1])
        if "IMPORTED" not in call.words:
            self.made |= dict.fromkeys(call.words[:1])
            self.compiled.update(word for each in call.words if _CODE.match(word := _HERE.sub("", each)))

    def program(self, call: Call) -> None:
        """Note a program with its files, and the packages that its conditions ask for."""
        self._code(call)
        name, *files = call.words
        before = name in self.executables
        self.executables.setdefault(name, call.line)
        self.written.add(name)
        self.named.update(word for word in files if _CODE.match(word))
        outside_of_workspaces(name, (*self.by_tool, *call.conditions), self.outside, self.without, again=before)
        switches = [condition.removeprefix("ON ") for condition in (*self.unset, *call.conditions)]
        waits = {(name, switch): None for switch in switches if _SWITCH.fullmatch(switch)}
        if before:  # the other branch of a condition makes it too
            self.optional = {each: None for each in self.optional if each[0] != name or each in waits}
        else:
            self.optional |= waits
        for condition in call.conditions:
            found = _WHERE_FOUND.finditer(condition) if not condition.startswith("NOT (") else ()
            self.guards |= {(name, (match[1] or match[2]).lower()): None for match in found}

    def without_options(self) -> tuple[tuple[str, int, str], ...]:
        """Return the programs that a workspace makes only where an option is off, with its ROS and the option."""
        told = ((self.written.file(name), ros, sorted(options)) for (name, ros), options in self.without.items())
        return tuple((name, ros, option) for name, ros, options in told for option in options)

    def component(self, call: Call) -> None:
        """Note the program that starts a component of ROS 2, which the call makes of a library and installs.

        https://github.com/ros2/rclcpp (rclcpp_components/cmake/rclcpp_components_register_node.cmake), 2026-11-27.
        """
        for word, name in zip(call.words, call.words[1:], strict=False):
            if word == "EXECUTABLE" and TARGET.match(name):
                self.program(replace(call, words=(name,), written=()))

    def test(self, call: Call) -> None:
        """Note a test, and the options that are off and that it waits for, of all the one that waits for the fewest."""
        off = tuple(each.removeprefix("OFF ") for each in call.conditions if each.startswith("OFF "))
        self.untested = min(self.untested, off, key=len) if self.tests else off
        self.tests = True

    def _code(self, call: Call) -> None:
        """Note the files that a program or a library is compiled from in any case, or where one option is on."""
        if len(call.conditions) > 1 or call.in_function or "IMPORTED" in call.words:
            return
        found = self.always
        if call.conditions:
            kind, _, option = call.conditions[0].partition(" ")
            if kind != "ON":
                return
            found = self.under.setdefault(option, {})
        for word in call.written[1:]:
            path = _HERE.sub("", word)
            if _CODE.fullmatch(path):
                found.setdefault(path, call.line)

    def lacking(self, text: str, folder: str, repository: Repository) -> tuple[tuple[str, str, int], ...]:
        """Return the options for which code is compiled that the tree does not have, each with the first such file.

        The programs that wait for one of them are no longer among those that are made. ``text``: the whole file, in
        ``folder``.
        """
        found = ((on, code_not_there(code, text, folder, repository)) for on, code in self.under.items())
        lacking = tuple(islice(((on, *code[0]) for on, code in found if code), MAX_PATHS))
        options = {on for on, _, _ in lacking}
        for name, option in self.optional if lacking else ():
            if option in options:
                self.executables.pop(name, None)
        return lacking
