"""Turning commands into facts: what they install, clone, build and run."""

from __future__ import annotations

import posixpath
from collections.abc import Iterable, Mapping
from typing import Literal

from roslab.evidence.dependency import Dependency, GitSource
from roslab.evidence.facts import Mention
from roslab.evidence.lex.shell import UNKNOWN, Command, commands, logical_lines
from roslab.evidence.prose import blanks, removed_clones, workspaces
from roslab.evidence.prose.by_other_means import Topic, steps
from roslab.evidence.prose.coinbrew import packages
from roslab.evidence.prose.configured import by_hand, folder_of, installs, options_of, prepares, preset_of, source_of
from roslab.evidence.prose.install_tree import from_workspace, package_and_program
from roslab.evidence.prose.merged import Prose
from roslab.evidence.prose.runners import by_ros, started
from roslab.evidence.prose.telling import telling
from roslab.evidence.python.install_lines import CONDA, PIP, STOP, Version, conda_asks, pip_asks, setup_asks
from roslab.evidence.python.manager_lines import manager_asks
from roslab.values.dataclass import dataclass, field, replace
from roslab.values.pattern import pattern
from roslab.values.requirement import Requirement
from roslab.values.words import joined

MentionSource = Literal["dockerfile", "ci", "readme", "script"]
_APT = frozenset({"apt", "apt-get", "aptitude", "apt-fast", "nala"})
_APT_VALUED = frozenset({"-t", "-o", "--target-release", "-c", "--option", "--default-release"})
_APT_NAME = pattern(  # a name has a letter; at the end of one a hyphen has apt remove the package
    r"^(?![\d.+-]+$)(?:ros-\{distro\}-[a-z0-9][a-z0-9+.-]*|[a-z0-9][a-z0-9+.-]*[a-z0-9+.]|ros-(?:\{distro\}|[a-z]+)-[a-z0-9][a-z0-9-]{2,}\*|[a-z][a-z0-9+.-]*-py3\*-[a-z0-9+.-]*[a-z0-9+.])$"
)
_PYTHON = pattern(r"^(?:i?python)(\d(?:\.\d+)?)?$")
_BUILT = pattern(r"^(?:\.{1,2}|build|bin)/(?:[\w.+-]+/)*[\w+-]+$")
"""The path of a compiled program, or of a script whose name has no ending."""
_STARTS = pattern(
    r"jupyter[ -](?:notebook|lab)\b|streamlit run$|octave(?:-cli)?(?:\s|$)|pixi run$|(?:ba)?sh \S+\.(?:ba)?sh$|"
    rf"(?:{_BUILT.pattern.removesuffix('$')}(?=\s|$))|\.{{0,2}}/?[\w./-]+\.(?:ba)?sh(?:\s|$)"
)
"""A compiled program or a shell script, by its path; a server of a notebook or of a page; Octave."""
_BUILD_TOOLS = frozenset({"catkin_make", "catkin_make_isolated", "colcon"})


@dataclass
class Collector:
    """Collects the facts from one file's commands; ``prose()`` returns them."""

    file: str
    source: MentionSource
    variables: Mapping[str, str] = field(default_factory=dict)
    dependencies: list[Dependency] = field(default_factory=list)
    requirements: list[Requirement] = field(default_factory=list)
    sources: list[GitSource] = field(default_factory=list)
    mentions: list[Mention] = field(default_factory=list)
    folder: str = ""
    """The folder after ``cd``, as far as known; paths given to pip are relative to it."""
    whole: str = ""
    """That folder from the ``src`` of a workspace on, where its path has one."""
    inside: bool = False
    """The folder is the ``src`` of a workspace."""
    sources_at: str | None = None
    """That folder, once the text has been in one."""
    heading: str = ""
    """The sections that the text stands in."""
    options: str = ""
    """The options of the last ``cmake``."""
    configured: bool = False
    """``cmake`` was called since the last clone."""
    prepared: bool = False
    """Something else was that writes a Makefile."""
    below: str = ""
    """The folder that it named by a path."""
    place: str = ""
    """The folder again, of a path of the reader's all that follows a clone of the text: ``~/tools/NAME/c++/build``."""
    cloned: int | None = None
    """Index of the last clone."""
    fresh: set[int] = field(default_factory=set)
    """Indices of the clones whose first ``git checkout`` is still to come."""

    def text(self, text: str, line: int = 1) -> None:
        """Read every logical line of a text; one in parentheses is a shell of its own, and stays where it was."""
        if telling(text):
            before, alone = self.folder, text[:1] + text[-1:] == "()"
            for start, logical in logical_lines(text[1:-1] if alone else text, line):
                self.logical(logical, start)
            self.folder = before if alone else self.folder

    def logical(self, text: str, line: int) -> None:
        """Read one logical line."""
        if telling(text):
            text = text if "ROS_DISTRO" in self.variables else blanks.with_distro(text)
            text = blanks.filled(blanks.with_packages(blanks.with_arguments(text)), of_page=self.source == "readme")
            for command in commands(text, line, self.variables):
                for topic, value in steps(command, self.heading, self.folder):
                    self._mention(topic, value.replace(UNKNOWN, "…"), command)
                self.command(command)

    def command(self, command: Command) -> None:
        """Read one simple command."""
        self._python(manager_asks(command, self.file, self._here), command)
        command = from_workspace(command)
        if (run := started(command)) is not command:
            self.command(run)
            return
        words = command.words
        program = words[0].rpartition("/")[2]
        if program == "uv" and words[1:2] == ("pip",):
            command, program = Command(words[1:], command.lines[1:]), "pip"
        elif (python := _PYTHON.match(program)) and words[1:2] == ("-m",) and len(words) > 2 and PIP.match(words[2]):
            name = "pip2" if (python[1] or "").startswith("2") else "pip"
            command, program = Command(words[2:], command.lines[2:]), name
        if program in _APT:
            self._apt(command)
        elif PIP.match(program):
            self._python(pip_asks(command, self.file, self._here), command)
        elif program in CONDA:
            self._python(conda_asks(command, self.file), command)
        elif program == "git":
            self._git(command)
        elif program in {"cd", "roscd"}:
            self.mentions = [m for m in self.mentions if m.topic != "made"]  # the page makes a folder to go there
            self._cd(words[1] if len(words) > 1 else "~")
        else:
            self._program(program, command)

    def prose(self) -> Prose:
        """Return the collected facts, without duplicates."""
        return Prose(
            tuple(dict.fromkeys(self.dependencies)),
            tuple(dict.fromkeys(self.requirements)),
            tuple(dict.fromkeys(self.sources)),
            tuple(dict.fromkeys(self.mentions)),
        )

    def _mention(
        self,
        topic: Literal["python", "cuda", "build_tool", "command", "framework", "compiled"] | Topic,
        value: str,
        command: Command,
        text: str | None = None,
    ) -> None:
        words = " ".join(command.words).replace(UNKNOWN, "…")[:200] if text is None else text
        self.mentions.append(
            Mention(
                topic=topic,
                value=value,
                source=self.source,
                file=self.file,
                line=command.line,
                text=words,
                heading=self.heading,
                inside=workspaces.longer(self.folder, self.whole)
                if topic in {"command", "build_tool"} and self.source == "readme"
                else "",
                variables=command.assigned if topic == "command" else (),
            )
        )

    def _apt(self, command: Command) -> None:
        words = command.words
        if "install" not in words:
            return
        index = words.index("install") + 1
        while index < len(words):
            word, line = words[index].strip("\"'`"), command.lines[index]
            index += 2 if word in _APT_VALUED else 1
            if word.startswith("-") or UNKNOWN in word:
                continue
            name = word.rstrip(",.:;)") if not word.endswith("++") else word
            if name in STOP and not (name == "sudo" and self._listed(words[index:])):
                break
            name, _, version = name.partition("=")
            name = name.partition("/")[0].partition(":")[0]
            if _APT_NAME.match(name):
                self._named(name, version or None, line)

    def _named(self, name: str, version: str | None, line: int) -> None:
        self.dependencies.append(
            Dependency(
                namespace="apt",
                name=name,
                strength="prose",
                file=self.file,
                line=line,
                version=version,
                heading=self.heading,
            )
        )

    def _listed(self, rest: tuple[str, ...]) -> bool:
        """Tell whether `sudo` among the words of apt is the package: in a list, and not before a command."""
        return self.source != "readme" and not (rest and (rest[0] in _APT or PIP.match(rest[0])))

    def _python(self, asks: Iterable[Requirement | Version], command: Command) -> None:
        for asked in asks:
            if isinstance(asked, Version):
                self._mention(asked.topic, asked.number, command)
            else:
                self.requirements.append(asked)

    def _here(self, path: str) -> str:
        """Return a path relative to the folder in which the text began."""
        return posixpath.join(self.folder, path.removeprefix("./")) if self.folder and path[:1] not in "/~" else path

    def _cd(self, target: str) -> None:
        left = self.source == "script" and workspaces.leaves_repository(target, self.folder, self.file)
        self.inside = workspaces.of_packages(target) or (left and self.sources_at is None)
        if known := not (workspaces.of_reader(target) or UNKNOWN in target):
            self.folder = posixpath.normpath(posixpath.join(self.folder, target)).removeprefix("../").strip(".")
            self.place = posixpath.normpath(posixpath.join(self.place, target))
        else:
            self.folder = "" if target in {"~", "-"} else workspaces.end_of(target).replace(UNKNOWN, "").strip("/")
            self.whole = workspaces.below_sources(target)
            self.place = workspaces.through(target, (git.folder for git in self.sources)) or self.folder
        self.inside = self.inside or (known and self.folder == self.sources_at)
        if self.inside:
            self.sources_at = self.folder

    def _git(self, command: Command) -> None:
        from roslab.evidence.prose.checkouts import COMMIT, called_in, checked_out, cloned  # noqa: PLC0415 - few pages clone

        words = command.words
        ref = checked_out(words)
        if ref is not None:
            clone = called_in(words, self.folder, self.sources)
            clone = self.cloned if clone is None else clone
            if clone is not None and clone in self.fresh:
                self.fresh.remove(clone)
                branch = None if COMMIT.fullmatch(ref) else self.sources[clone].ref
                self.sources[clone] = replace(self.sources[clone], ref=branch or ref or None)
            return
        found = cloned(command, self.file, self.folder, self.heading, inside=self.inside)
        if found is None:
            return
        self.cloned, self.options, self.below, self.configured, self.prepared = len(self.sources), "", "", False, False
        self.fresh.add(self.cloned)
        self.sources.append(found)

    def _by_hand(self, program: str, command: Command) -> None:
        """Note what CMake is told, and, where something is installed, the clone in whose folder the text is now."""
        from roslab.evidence.prose.archives import archives  # noqa: PLC0415 - few pages compile by hand
        from roslab.evidence.prose.checkouts import clone_at, titled  # noqa: PLC0415 - as above
        from roslab.evidence.prose.found_where_built import with_found  # noqa: PLC0415 - as above

        words, here = command.words, workspaces.longer(self.folder, self.place)
        if program in {"wget", "curl", "tar"}:
            self.sources = archives(command, self.file, self.sources, self.cloned)
            return
        if program == "cmake":
            self.sources = with_found(words, self.sources, self.mentions)
            self._mention("build_tool", "cmake", command)
            if not {"--build", "--install", "--version"} & {*words}:
                self.options, self.configured, self.below = options_of(words), True, folder_of(words, here)
                # A folder in which CMake is run, ``.`` where the text begins, with its options, may be a library's
                self._mention("compiled", source_of(self.folder, words), command, text=self.options + preset_of(words))
        if not installs(program, words, configured=self.configured):
            return
        clone = clone_at([*here.split("/"), *self.below.split("/")], self.sources)
        clone = titled(self.heading, self.sources) if clone is None and program != "dpkg" else clone
        if self.configured and program != "dpkg":
            inside = [m for m in self.mentions if m.topic == "compiled" and f"/{m.value}/" in f"/{self.folder}/"]
            self.mentions += [replace(m, topic="installed_here") for m in inside[-1:]]
        if clone is not None:
            said, how = self.sources[clone], (self.options, self.below, here)
            self.sources[clone] = by_hand(said, program, *how, configured=self.configured, prepared=self.prepared)

    def _prepare(self, command: Command) -> None:
        """Note a call that may write a Makefile, and what COIN-OR's script fetches, which apt has too."""
        self.prepared = self.prepared or prepares(command.words[0])
        for name, line in packages(command):
            self._named(name, None, line)

    def _program(self, program: str, command: Command) -> None:
        words = command.words
        self._prepare(command)
        removed_clones.note(program, words, self.sources)
        if program in _BUILD_TOOLS:
            self._mention("build_tool", program, command)
        elif program == "catkin" and words[1:2] in {("build",), ("init",), ("config",), ("b",)}:
            self._mention("build_tool", "catkin_tools", command)
        elif program in {"cmake", "make", "ninja", "dpkg", "wget", "curl", "tar"}:
            self._by_hand(program, command)
        elif by_ros(program, words):
            self._run(command)
        elif (python := _PYTHON.match(program)) and len(words) > 1:
            if python[1] and "." in python[1]:
                self._mention("python", python[1], command)
            if words[1].endswith("setup.py"):
                here = self._here if self.source == "readme" else str  # a script that compiles is run as it is
                self._python(setup_asks(command, self.file, here), command)
            elif any(word.endswith(".py") for word in words[1:4]) or words[1] == "-m" or "/" in words[1]:
                self._run(command)
        elif self.source == "readme" and (_STARTS.match(" ".join(words[:2])) or package_and_program(words[0])):
            self._run(command)

    def _run(self, command: Command) -> None:
        words = [word for word in command.words if "<" in word or UNKNOWN in word]
        if not words or (self.source == "readme" and command.words[0] not in words):
            self._mention("command", joined(command.words).replace(UNKNOWN, "…"), command)
