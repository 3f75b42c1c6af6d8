"""The author's Dockerfiles, under any usual name."""

from __future__ import annotations

import posixpath
import re
from typing import TYPE_CHECKING

from roslab.evidence.facts import AuthorDockerfile, Mention
from roslab.evidence.lex.shell import Command, expand
from roslab.evidence.prose import mentions, other_dockerfiles
from roslab.evidence.prose.build_scope import Scope
from roslab.evidence.prose.build_values import Values, secret_of
from roslab.evidence.prose.cloned_folders import from_one, is_itself
from roslab.evidence.prose.copies import in_copy
from roslab.evidence.prose.installs import Collector
from roslab.evidence.prose.merged import Prose, merge
from roslab.evidence.prose.other_dockerfiles import source_of, text_of
from roslab.evidence.prose.stage import Start, from_start
from roslab.evidence.ros import vcs
from roslab.repository.checkout import File, Repository
from roslab.values.dataclass import dataclass, field, replace
from roslab.values.pattern import pattern

if TYPE_CHECKING:
    from roslab.evidence.lex.dockerfile import Instruction

MAX_SIZE = 256 * 1024
_NAME = pattern(r"^(?:dockerfile(?:[-_.].*)?|.*\.dockerfile|.*[-_.]dockerfile|containerfile)$")
_NOT = pattern(
    r"\.(?:md|rst|html?|py|ya?ml|json|sh|png|jpe?g|svg|j2|jinja2?|em|in|template|tmpl|erb|dockerignore|txt)$"
)
_UPDATE = pattern(r"\brosdep\s+update\b(?!\s+--(?:include-eol-distros|rosdistro))")
"""Not told to keep distributions that have ended. https://github.com/ros-infrastructure/rosdep/issues/818"""
_PAIR = pattern(r"(\w+)=(\"[^\"]*\"|'[^']*'|\S*)")
_PRIVATE = pattern(
    r"id_rsa|GITHUB_TOKEN|ACCESS_TOKEN|OAUTH|:\$\{?\w*(?:TOKEN|PASSWORD)\w*\}?@",
    re.IGNORECASE,
)
_MOUNT = pattern(r"--mount=(\S*\btype=(?:ssh|secret)\b\S*)")
_COMPILES = pattern(r"\b(?:cmake|make|ninja|git\s+(?:apply|am)|patch)\b")
_COMMENT = pattern(r"^[ \t]*#.*$", re.MULTILINE)


def read(repository: Repository) -> tuple[AuthorDockerfile, ...]:
    """Return every Dockerfile of the tree, sorted by path; ``prose`` returns what they mention."""
    return tuple(_dockerfile(repository, file) for file in files(repository))


def prose(repository: Repository) -> Prose:
    """Return the versions and build commands that the Dockerfiles name."""
    return merge(
        Prose(mentions=_said(text, file.path))
        for file in files(repository)
        if (text := text_of(repository, file, MAX_SIZE))
    )


def files(repository: Repository) -> list[File]:
    """Return the Dockerfiles of the tree, sorted by path."""
    return repository.once(_files)


def _files(repository: Repository) -> list[File]:
    names = (name for name in repository.by_name if _NAME.match(name) and not _NOT.search(name))
    found = (*repository.named(*names), *other_dockerfiles.read(repository))
    return sorted((file for file in found if file.size < 4 * MAX_SIZE), key=lambda file: file.path)[:200]


def _said(text: str, path: str) -> tuple[Mention, ...]:
    from roslab.evidence.lex.dockerfile import instructions  # noqa: PLC0415 - most trees have no Dockerfile

    collector = Collector(path, source_of(path))
    for instruction in instructions(text):
        if instruction.name in {"RUN", "CMD"}:
            _collect(collector, instruction)
    return (*mentions.read(_COMMENT.sub("", text), path, source_of(path)), *collector.mentions)


@dataclass
class _Reading:
    """What has been read of one Dockerfile so far."""

    collector: Collector
    known: dict[str, str]
    stages: dict[str, str] = field(default_factory=dict)
    start: Start = field(default_factory=Start)
    starts: dict[str, Start] = field(default_factory=dict)
    base: str | None = None
    base_line: int = 1
    bases: list[tuple[str, int]] = field(default_factory=list)
    copied: list[tuple[str, int]] = field(default_factory=list)
    problem: str | None = None  # why it does not parse
    updates_rosdep: int | None = None
    images: list[tuple[int, str]] = field(default_factory=list)
    """The line of each FROM, and the image that its stage starts from in the end."""
    secrets: list[tuple[str, int]] = field(default_factory=list)
    values: Values = field(default_factory=Values)
    scope: Scope = field(default_factory=Scope)
    needs: str | None = None
    """What it needs that a build cannot give it."""
    inside: str = ""
    """The folder of something cloned that WORKDIR names, or one below, from that folder on."""
    installed: list[str] = field(default_factory=list)
    """What it gives pip of its copy of the whole context, by its path there."""

    def take(self, instruction: Instruction) -> None:
        """Read one instruction."""
        from roslab.evidence.lex.balance import unbalanced  # noqa: PLC0415 - most trees have no Dockerfile

        name, body, line = instruction.name, instruction.text, instruction.line
        self.needs = self.needs or self.values.missing(name, body, line)
        if not name:
            self.problem = self.problem or f"line {line} is no instruction: {body.strip()[:60]!r}"
        elif self.base is None and name not in {"ARG", "FROM"}:
            self.problem = self.problem or f"line {line}: {name} before FROM"
        if name == "FROM":
            self._from(body, line)
        elif name in {"ARG", "ENV"}:
            self._set(name, body, line)
        elif name == "RUN":
            self._enter(body, line)
            self.start.kept = None if "type=bind" in body else self.start.kept
            _collect(self.collector, instruction)
            self._install(instruction.steps)
            if wrong := "" if instruction.script else unbalanced(instruction.steps):
                self.problem = self.problem or f"line {line} is nothing that a shell reads: {wrong}"
            if _UPDATE.search(body):
                self.updates_rosdep = self.updates_rosdep or line
            mounts = _MOUNT.findall(body)
            self.secrets += [(secret_of(mount), line) for mount in mounts]
            if not mounts and _PRIVATE.search(body):
                self.needs = self.needs or f"line {line} needs a private key or token"
        elif name in {"COPY", "ADD"}:
            self._copy(body, line)
        else:
            self._start(name, body, line)

    def _install(self, body: str) -> None:
        from roslab.evidence.prose.installed_context import installed  # noqa: PLC0415 - most trees have no Dockerfile

        if self.start.source is not None:
            self.installed += installed(body, self.start.source, posixpath.join("/", self.start.workdir), self.known)

    def _enter(self, body: str, line: int) -> None:
        """Go where a line begins that may compile something cloned, or change it."""
        if self.inside:
            self.collector.folder = ""
            if _COMPILES.search(body):
                self.collector.command(Command(("cd", self.inside), (line, line)))

    def _start(self, name: str, body: str, line: int) -> None:
        from roslab.evidence.lex.dockerfile import argv  # noqa: PLC0415 - as above

        start = self.start
        if name == "WORKDIR":
            start.workdir = posixpath.join(start.workdir, expand(body.strip().strip("\"'"), self.known))
            cloned = {clone.folder for clone in self.collector.sources}
            left, self.inside = self.inside, from_one(cloned, start.workdir)
            self.collector.folder = "" if left else self.collector.folder
        elif name == "ENTRYPOINT":
            start.entrypoint, start.line = argv(body), start.line or line
        elif name == "CMD":
            start.command, start.line = argv(body), line

    def _copy(self, body: str, line: int) -> None:
        from roslab.evidence.lex.dockerfile import sources  # noqa: PLC0415 - as above
        from roslab.evidence.prose.stages import kept  # noqa: PLC0415 - as above

        copied = sources(expand(body, self.known))
        self.start.kept = None if copied else kept(body, self.start, self.starts)
        self.copied += [(source, line) for source in copied]
        words = [word for word in body.split() if not word.startswith("--")]
        if len(words) < 2 and not body.lstrip().startswith("["):
            self.problem = self.problem or f"line {line} names nothing to copy, or no place to copy it to"
        if copied in ([""], ["."]) and len(words) == 2:
            self.start.source = posixpath.normpath(posixpath.join(self.start.workdir, expand(words[1], self.known)))

    def _from(self, body: str, line: int) -> None:
        from roslab.evidence.lex.dockerfile import FROM  # noqa: PLC0415 - as above

        if match := FROM.match(expand(body.strip(), self.known)):
            if match[1].lower() not in self.stages and match[1] != "scratch":
                self.bases.append((match[1], line))
            self.inside = ""
            self.scope.enter(self.known, match[1].lower(), (match[2] or "").lower())
            self.base, self.base_line = self.stages.get(match[1].lower(), match[1]), line
            self.images.append((line, self.base))
            self.start = replace(self.starts.get(match[1].lower(), Start()))
            if match[2]:
                self.stages[match[2].lower()] = self.base
                self.starts[match[2].lower()] = self.start

    def _set(self, name: str, body: str, line: int) -> None:
        if name == "ARG":
            for variable, default in _PAIR.findall(body):
                self.scope.argument(self.known, variable, expand(default.strip("\"'"), self.known))
            return
        words = body.split(None, 1)
        old = len(words) == 2 and "=" not in words[0]  # the form for one variable: ENV NAME VALUE
        pairs = [(words[0], words[1].strip())] if old else [(k, v.strip("\"'")) for k, v in _PAIR.findall(body)]
        self.known.update((key, expand(value, self.known)) for key, value in pairs)
        self.scope.fixed.update(key for key, _ in pairs)
        self.start.environment += tuple((key, self.known.get(key, ""), line) for key, _ in pairs)


def _dockerfile(repository: Repository, file: File) -> AuthorDockerfile:
    from roslab.evidence.lex.dockerfile import instructions  # noqa: PLC0415 - as above
    from roslab.evidence.prose.absent_in_steps import stops_at_absent  # noqa: PLC0415 - as above
    from roslab.evidence.prose.author_variables import set_for_ros  # noqa: PLC0415 - as above
    from roslab.evidence.prose.build_context import build_context  # noqa: PLC0415 - as above
    from roslab.evidence.prose.built_packages import built  # noqa: PLC0415 - as above
    from roslab.evidence.prose.composed import services  # noqa: PLC0415 - as above
    from roslab.evidence.prose.dockerfile_purpose import purpose_of, removes_its_copy  # noqa: PLC0415 - many trees have no Dockerfile
    from roslab.evidence.prose.entry_scripts import entry_script, started_by  # noqa: PLC0415 - as above
    from roslab.evidence.prose.hidden_installs import hides  # noqa: PLC0415 - as above
    from roslab.evidence.prose.python_steps import changes_setup, newest_pips, own_shell  # noqa: PLC0415 - as above
    from roslab.evidence.prose.recipe import recipe  # noqa: PLC0415 - as above
    from roslab.evidence.prose.ros_in_image import ros_of  # noqa: PLC0415 - as above
    from roslab.evidence.prose.stages import copied_from, entered, only_files, taken, unused  # noqa: PLC0415 - as above
    from roslab.evidence.prose.stopped_steps import stops  # noqa: PLC0415 - as above
    from roslab.evidence.prose.unbuilt_copies import unbuilt  # noqa: PLC0415 - as above
    from roslab.evidence.prose.uncopied import paths_of, uncopied  # noqa: PLC0415 - as above

    known: dict[str, str] = {}
    reading = _Reading(collector=Collector(file.path, "dockerfile", known), known=known)
    text = text_of(repository, file, MAX_SIZE)
    for instruction in (written := tuple(instructions(text))):
        reading.take(instruction)
    problem = reading.problem or (None if reading.base else "no FROM")
    copies, context, missing = build_context(repository, file, reading.copied, reading.installed)
    collector, start, missing = reading.collector, reading.start, only_files(written, reading.base) or missing
    if reading.base == "scratch" and (base := reading.stages.get((copied_from(written) or "").lower())):
        reading.base, reading.base_line = base, dict(reading.bases).get(base, reading.base_line)
    if started := uncopied(repository, context or "", dict(reading.copied), (*start.entrypoint, *start.command)):
        missing = missing or f"it starts {started} and does not copy it: the repository is mounted when it is run"
    if removes_its_copy((each.text for each in written if each.name == "RUN"), start.source):
        missing = missing or f"it removes its copy of the repository and installs nothing of it: {start.source}"
    if other_dockerfiles.named_otherwise(file):
        missing = missing or "it has a name of its own: it tells what the image needs, and none is made with it"
    service, taken_there = services(repository).get(file.path), taken(written, known)
    missing = missing or unbuilt(
        repository, reading.base or "", context or "", reading.copied, written, service=service
    )
    apart = unused(written, known)

    def of_image(line: int) -> bool:
        return not any(line in stage for stage in apart)

    used = [each for each in written if of_image(each.line)]
    missing = missing or stops_at_absent(repository, used, known, context or "", copied=reading.copied, start=start)
    missing = missing or stops(repository, used, reading.base)
    itself = any(is_itself(repository, clone) for clone in collector.sources)
    purpose = "vendored" if in_copy(repository, file) else purpose_of(file.path, reading.base or "", problem, service)
    return AuthorDockerfile(
        file=file.path,
        line=1,
        base=reading.base,
        base_line=reading.base_line,
        bases=tuple(reading.bases),
        stages=tuple(reading.images),
        copies_repository=copies or itself,
        clones=tuple(each for each in collector.sources if of_image(each.line)),
        patches=tuple(each for each in collector.mentions if each.topic in {"patched", "edited"}),
        dependencies=tuple(each for each in dict.fromkeys(collector.dependencies) if of_image(each.line)),
        requirements=tuple(each for each in dict.fromkeys(collector.requirements) if of_image(each.line)),
        command=start.command,
        command_line=start.line,
        entrypoint=started_by(repository, start.entrypoint),
        entry=entry_script(repository, start.entrypoint, written, (name for name, _, _ in start.environment)),
        starts_in_source=start.source is not None and start.source == posixpath.normpath(start.workdir),
        source=from_start(start),
        purpose=purpose,
        service=service,
        environment=set_for_ros(repository, file.path, start.environment, service),
        problem=problem or reading.needs or missing,
        context=context,
        secrets=tuple(sorted(dict(reversed(reading.secrets)).items(), key=lambda found: found[1])),
        clones_itself=itself,
        recipe=recipe(text),
        updates_rosdep=reading.updates_rosdep,
        newest_pips=tuple(newest_pips(written, reading.images)),
        changes_setup=changes_setup(written),
        own_shell=own_shell(written),
        copied=paths_of(context or "", reading.copied),
        taken=taken_there,
        enters=entered(written, repository.once(vcs.missing)),
        hides=hides(written),
        ros=ros_of(written, reading.base or ""),
        built=None if taken_there else built(repository, written),
        kept=start.kept,
    )


def _collect(collector: Collector, instruction: Instruction) -> None:
    text = instruction.steps
    if instruction.script:
        collector.text(text, instruction.line)
    else:
        collector.logical(text, instruction.line)
