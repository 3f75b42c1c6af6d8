"""The image's default command."""

from __future__ import annotations

import posixpath
import shlex

from roslab.config.model import Config, Kind, Volume
from roslab.decide.among import among
from roslab.decide.author_command import (
    composed,
    entry_point_of,
    folder_of,
    given,
    left_to_base,
    listed_in,
    startable,
    started,
    taken_by,
    there_in,
)
from roslab.decide.brought_launches import brought
from roslab.decide.by_name import by_name, in_bin
from roslab.decide.by_name import told as said_by_name
from roslab.decide.candidate import Candidate, is_python, program_of, there
from roslab.decide.candidates import candidates_of, once
from roslab.decide.contained import only_contained
from roslab.decide.container_scripts import known_folders, of_image, shown
from roslab.decide.decision import Choice, Reason
from roslab.decide.demanded_arguments import told as lacking_arguments
from roslab.decide.demanded_arguments import without_lacking
from roslab.decide.entry_scripts import stops
from roslab.decide.first_command import first_of, serves
from roslab.decide.gone_programs import gone_programs
from roslab.decide.helpers_first import behind_helpers
from roslab.decide.included import included
from roslab.decide.launched import launched
from roslab.decide.launches_without import without_unconfigurable
from roslab.decide.left_to_reader import left_to_reader
from roslab.decide.lone import alone, behind_others
from roslab.decide.meant_commands import listed, named_like_it, pointed_at, started_below, whole_of
from roslab.decide.of_clones import first_of_clones
from roslab.decide.only_making import only_making
from roslab.decide.outward import ports_of_page, volumes_of
from roslab.decide.own_commands import own
from roslab.decide.reasons import because, configured
from roslab.decide.released_pages import without_copied_packages
from roslab.decide.required_options import behind_whole
from roslab.decide.ros.as_sources import as_mounted
from roslab.decide.ros.in_tree import copied
from roslab.decide.ros.workspace import packages_of
from roslab.decide.scripts import ports_in, ports_of
from roslab.decide.sections import about_running
from roslab.decide.sessions import of_sessions
from roslab.decide.shown_folders import first_shown
from roslab.decide.skipped_commands import without_skipped
from roslab.decide.spoken_to import without_speaking
from roslab.decide.unbuilt_packages import starts_one, unbuilt
from roslab.decide.upkeep import upkeep
from roslab.decide.wanted_arguments import without_wanting
from roslab.decide.written_commands import TOOLS
from roslab.evidence.entry_script import Taken
from roslab.evidence.facts import AuthorDockerfile, Evidence
from roslab.evidence.prose.copies import below
from roslab.values.dataclass import dataclass, replace
from roslab.values.origin import Place
from roslab.values.pattern import pattern
from roslab.values.words import line_of

MAX_CANDIDATES = 30
_ARGUMENT = pattern(
    r"(?:^|[\s=])(?:\.{0,2}/|[\w.-]+/)|(?:^|\s)(?:--?help|-h|--?usage|--?version)\b|--show-args\b|\s(?:-s|--ros-args)$"
)
"""An argument that names a file or asks for help: such a command is no default."""


class Weight:
    """How much each reason for a command counts."""

    AUTHORS_IMAGE = 60  # the CMD of the author's Dockerfile, which is built
    FIRST = 40  # the first of those that the README runs
    ONLY_ONE = 30  # one candidate is clearly meant
    WRITTEN = 20  # a README runs it
    SHELL = 10  # several candidates; wins over a file that nobody mentions
    FOUND = 5  # it can be started, but nobody mentions it


@dataclass(frozen=True, kw_only=True, slots=True)
class Command:
    """A command (a string runs in ``bash -c``), what else it might have been, and whether it opens windows."""

    command: tuple[str, ...] | str = ("bash",)
    candidates: tuple[tuple[str, ...], ...] = ()
    gui: bool = False
    ports: tuple[str, ...] = ()
    """Where it listens."""
    volumes: tuple[Volume, ...] = ()
    """Folders of the host that Docker Compose mounts into containers of the author's image."""
    given: bool = False
    """A container of the author's image has to be given it, as the image does not start it by itself."""
    entrypoint: bool = True
    """It is given through the entry point of that image."""
    entrypoint_takes: Taken = "commands"
    """What that entry point does with words that a container is given."""
    page: Candidate | None = None
    """What a page runs, if that is the command."""
    guessed: bool = False
    """No page runs or names it: it is what launch files or programs are called, or what most of them are in."""


def decide_command(
    evidence: Evidence, config: Config, kind: Kind, dockerfile: str | None, python: str | None = None
) -> Choice[Command]:
    """Return the default command: what roslab.yaml says, the author's Dockerfile, the one obvious program, or a shell.

    ``dockerfile`` is the author's own that is built, if any; ``python`` is the version that has the packages.
    """
    authored = next((each for each in evidence.dockerfiles if each.file == dockerfile), None)
    by_argv: dict[tuple[str, ...], Candidate] = {}
    lacking = unbuilt(evidence, authored) if authored else frozenset()
    taken = taken_by(authored) if authored else "commands"
    for candidate in (_started_by(python, each, kind) for each in candidates_of(evidence, kind)):
        if not starts_one(candidate, lacking) and (authored is None or there_in(candidate, authored)):
            known = by_argv.setdefault(candidate.argv, candidate)
            if candidate.strong and about_running(known.heading) < 0 < about_running(candidate.heading):
                by_argv[candidate.argv] = candidate  # the same, where the first page only tries it
    found = behind_whole(by_argv.values(), evidence)
    by_image = (listed_in(each, authored) if authored else each.argv for each in once(by_argv.values()))
    named = in_bin(evidence, kind) if authored is None else {}
    candidates = tuple(dict.fromkeys(by_name(argv, named, kind) for argv in by_image))[:MAX_CANDIDATES]
    mounts = (*(volumes := volumes_of(authored, config)), *config.volume)
    if config.command is not None:
        text = line_of(config.command)
        said = configured(config, "command", text, "command")
        gui = shown(text, config, evidence, authored)
        chosen = Command(command=config.command, candidates=candidates, gui=gui, volumes=volumes)
        chosen = replace(_given(chosen, dockerfile, authored), entrypoint_takes=taken)
        warnings = of_image(authored, chosen.command, evidence, mounts)
        return Choice(answer=chosen, reasons=(said,), warnings=warnings)
    command, why = (authored and _authors(authored)) or _obvious(evidence, found, kind, dockerfile, authored)
    gui = shown(shlex.join(command), config, evidence, authored)
    told = () if dockerfile or command in by_argv else started_below(evidence, kind, command)
    same = [c for c in (*found, *told) if c.argv == command]
    inside = next((c for c in same if c.inside or (c.makes and not dockerfile)), None)
    page = by_argv.get(command, *told)
    ports = ports_of(command) or (authored.service.ports if authored and authored.service else ())
    ports = ports or (ports_of_page(page, evidence) if page and not dockerfile else ()) or ports_in(command, evidence)
    whole = launched(inside or page, evidence) if page else None
    command = as_mounted(whole.argv if whole else command, evidence)
    called = by_name(command, named, kind)
    why, command = said_by_name(why, command, called), called
    within = folder_of(page, authored) if page and authored and not started(authored) else None
    chosen = Command(
        command=there(whole or inside or page, within) if page and (inside or within) else command,
        candidates=candidates,
        gui=gui,
        ports=ports,
        volumes=volumes,
        page=page,
        guessed=bool(page and not page.strong) and why.weight == Weight.ONLY_ONE,
    )
    if (authored and composed(authored)) or (not (authored and started(authored)) and command != ("bash",)):
        chosen = _given(chosen, dockerfile, authored)
    elif authored and command == ("bash",) and kind not in {"ros1", "ros2"} and left_to_base(authored):
        chosen = replace(chosen, given=True, entrypoint=False)  # the base's own program is none of the repository
    elif authored and command == ("bash",) and stops(authored):
        chosen = replace(chosen, given=True, entrypoint=False)
    chosen = replace(chosen, entrypoint_takes=taken)
    reasons = (why, *(_found(candidate) for candidate in found[:MAX_CANDIDATES]))
    shell = command == ("bash",) and not dockerfile
    gone = (*gone_programs(evidence, kind), *lacking_arguments(found)) if shell else ()
    left = left_to_reader(page, evidence, known_folders(authored, evidence, mounts)) if page else gone
    return Choice(
        answer=chosen, reasons=reasons, warnings=(*of_image(authored, chosen.command, evidence, mounts), *left)
    )


def _started_by(version: str | None, candidate: Candidate, kind: Kind) -> Candidate:
    """Return a program beside nodes with the Python that has ROS's packages: before noetic that is ``python2``."""
    if kind != "ros1" or candidate.argv[0] != "python3" or not (version or "").startswith("2"):
        return candidate
    return replace(candidate, argv=("python2", *candidate.argv[1:]))


def _given(chosen: Command, dockerfile: str | None, authored: AuthorDockerfile | None) -> Command:
    """Return a command as containers of the author's image, if that is built, are given it.

    One that the author set in roslab.yaml replaces an entry point that is a program, or a shell.
    """
    through = authored is None or entry_point_of(authored) in {"none", "wrapper"}
    return replace(chosen, given=True, entrypoint=through) if dockerfile else chosen


def _authors(authored: AuthorDockerfile) -> tuple[tuple[str, ...], Reason] | None:
    """Return what the author's Dockerfile starts, ``None`` for a shell."""
    if not (argv := composed(authored) or started(authored)):
        return None
    place = Place(file=authored.file, line=authored.command_line or authored.line)
    why = "the author's Dockerfile starts it"
    if authored.service and authored.service.command:
        why = f"Docker Compose starts it, which {authored.service.said} runs"
        place = Place(file=authored.service.file, line=authored.service.line)
    return argv, because("command", shlex.join(argv), why, place, weight=Weight.AUTHORS_IMAGE)


def _obvious(
    evidence: Evidence, found: list[Candidate], kind: Kind, dockerfile: str | None, authored: AuthorDockerfile | None
) -> tuple[tuple[str, ...], Reason]:
    """Return the program that the README runs first, or the one obvious program, else a shell.

    Of the programs, only those that a container of the author's image can be given, if that is built; and none that
    nothing but a copy of others' repository, or the page of a released package, names beside packages of the author's.
    """
    built = {file for m in evidence.mentions if m.topic == "build_script" for file in m.files}
    foreign = copied(evidence, packages_of(evidence))
    ours = [c for c in found if own(c.argv, evidence) and not (upkeep(c) or below(c.file, foreign))]
    ours = without_lacking(without_copied_packages(without_skipped(ours, evidence, kind), evidence))
    ours = without_unconfigurable(ours, evidence)
    ours = [c for c in ours if program_of(c.argv)[-1] not in built]
    if dockerfile:
        ours = [c for c in ours if authored and startable(c, authored)]
        ours = [c for c in ours if kind != "cpp" or not is_python(c)]  # that image was made for what is compiled
    ours = without_speaking(without_wanting(ours, found), found, evidence)
    first = first_of(ours)
    first = behind_helpers(first, ours, evidence) if first else None
    if first and "/" in first.file and not dockerfile:
        first = listed(evidence, kind) or first
    if first:
        why = among(first, ours, found)
        argv = given(first, authored) if dockerfile and authored else first.argv
        return argv, because("command", shlex.join(argv), why, first, weight=Weight.FIRST)
    meant = None if dockerfile else only_contained(ours) or pointed_at(evidence, kind) or included(evidence, kind)
    meant = meant or (None if dockerfile else of_sessions(ours) or first_of_clones(found, evidence, kind))
    if meant and not upkeep(meant):
        return meant.argv, because("command", shlex.join(meant.argv), meant.why, meant, weight=Weight.FIRST)
    ours = [c for c in ours if c.strong or not (c.cut or c.session)]
    brings = brought(evidence) if kind in {"ros1", "ros2", "cpp"} else {}
    if kind in {"ros1", "ros2", "cpp"} and (named := named_like_it(ours, evidence, brings)):
        why = f"{named.why}, named like its package or like a demonstration"
        return named.argv, because("command", shlex.join(named.argv), why, named, weight=Weight.ONLY_ONE)
    if kind in {"ros1", "ros2"} and not any(c.strong for c in ours) and (whole := whole_of(ours, evidence, brings)):
        why = f"{whole.why}, which brings most of the others"
        return whole.argv, because("command", shlex.join(whole.argv), why, whole, weight=Weight.ONLY_ONE)
    every = ours
    ours = [c for c in ours if not (c.strong and serves(c))]
    obvious = [c for c in ours if c.strong and not _ARGUMENT.search(" ".join(c.argv[2:]))]
    obvious = _barest(obvious if dockerfile or any(c.strong for c in ours) else ours)
    clear = len(obvious) == 1 and not (obvious[0].strong and _others(evidence, obvious[0]))
    only = behind_others(found, every) or (obvious[0] if clear else alone(found, every))
    if only := only or (None if dockerfile else first_shown(found, evidence) or only_making(every)):
        why = among(only, [], found)
        argv = given(only, authored) if dockerfile and authored else only.argv
        return argv, because("command", shlex.join(argv), why, only, weight=Weight.ONLY_ONE)
    programs = len({program_of(c.argv) for c in found})
    why = f"{programs} programs could be the default" if programs > 1 else "no program stands out"
    written = [c for c in found if c.strong]
    if written and all(c.lacking for c in written):
        why = "what pages run lacks arguments that its launch file demands"
    said = because("command", "bash", f"{why}, so it is a shell; set `command` in roslab.yaml", weight=Weight.SHELL)
    return ("bash",), said


def _found(candidate: Candidate) -> Reason:
    """Return the reason for a candidate, not decisive: it is one of several."""
    weight = Weight.WRITTEN if candidate.strong else Weight.FOUND
    return because("command", shlex.join(candidate.argv), candidate.why, candidate, weight=weight, decisive=False)


def _others(evidence: Evidence, only: Candidate) -> bool:
    """Tell whether the same page also runs other Python files of the tree that have no ``__main__`` guard."""
    programs = [script.file for script in evidence.programs]
    folders = {file.rpartition("/")[0] for file in (*programs, *(d.file for d in evidence.code))} | {""}
    for mention in evidence.mentions:
        if mention.topic == "command" and mention.file == only.file and mention.value.startswith("python"):
            named = next((posixpath.normpath(p) for p in mention.value.split()[1:] if p.endswith(".py")), "setup.py")
            unknown = not any(program.endswith(named) for program in programs)
            if unknown and named.rpartition("/")[2] not in TOOLS and named.rpartition("/")[0] in folders:
                return True
    return False


def _barest(candidates: list[Candidate]) -> list[Candidate]:
    """Keep the call with the fewest arguments for each program: variants of one call are no ambiguity."""
    programs: dict[tuple[str, ...], Candidate] = {}
    for candidate in candidates:
        argv = candidate.argv
        program = program_of(argv)
        known = programs.get(program)
        if known is None or len(argv) < len(known.argv):
            programs[program] = candidate
    return list(programs.values())
