"""README, INSTALL and installation pages: what people are told to install and run.

Markdown, reStructuredText and plain text are all read line by line: a Markdown library would take longer than
everything else together, and does not read the other two.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping

from roslab.evidence.facts import Mention
from roslab.evidence.lex.choices import with_first_choice
from roslab.evidence.lex.shell import (
    UNKNOWN,
    commands,
    fill_placeholders,
    logical_lines,
    without_remarks,
)
from roslab.evidence.prose import (
    apt_scripts,
    asides,
    downloads,
    exports,
    generated,
    here_lists,
    libtorch,
    links,
    made_lists,
    makes,
    mentions,
    octave,
    python_path,
    said_runs,
    tops,
)
from roslab.evidence.prose.absent_launches import absent_launch
from roslab.evidence.prose.blanks import BLANK, distros_of, with_arguments, with_examples
from roslab.evidence.prose.by_paths import started_by_paths
from roslab.evidence.prose.comments import commented_out
from roslab.evidence.prose.download_scripts import fetched_by
from roslab.evidence.prose.failing import of_failure
from roslab.evidence.prose.headings import (
    MAX_LINE,
    about,
    fence,
    heading_of,
    resumed,
    section_of,
    simulated,
    title_of,
    under,
)
from roslab.evidence.prose.host_scripts import in_container
from roslab.evidence.prose.in_containers import ENGINES, started_in
from roslab.evidence.prose.in_sentences import IN_SENTENCES, emphasised, in_sentence
from roslab.evidence.prose.installs import Collector
from roslab.evidence.prose.marks import without_marks
from roslab.evidence.prose.merged import Prose, merge
from roslab.evidence.prose.notes_behind import without_notes
from roslab.evidence.prose.own_files import with_files, with_files_below
from roslab.evidence.prose.own_scripts import called, checked, of_python
from roslab.evidence.prose.pages import pages, text_of
from roslab.evidence.prose.runners import started
from roslab.evidence.prose.script_folders import elsewhere
from roslab.evidence.prose.shell_functions import functions, meant
from roslab.evidence.prose.shells import leads_elsewhere
from roslab.evidence.prose.telling import Signs, lines_with, signs_in, telling
from roslab.evidence.prose.titled import titles_commands
from roslab.repository.checkout import File, Repository
from roslab.values.dataclass import replace
from roslab.values.pattern import pattern
from roslab.values.prompt import typed
from roslab.values.words import joined

_START = pattern(
    r"^[\s>*\-$%#.\d)]*?((?:sudo\s|\$\s|!|%)?\s*(?:sudo\s+(?:-\w\s+)?)?(?:[A-Z][A-Z0-9_]*=\S+\s+)*"
    r"(?:apt|apt-get|aptitude|pipx|pip[23]?(?:\.\d+)?|python[\d.]*|conda|mamba|micromamba|git|ros2|roslaunch|"
    r"rosrun|gz|ign|gazebo|webots|catkin|catkin_make|catkin_make_isolated|colcon|cmake|make|ninja|uv|poetry|pipenv|pdm|pixi|xvfb-run|mpirun|torchrun|accelerate|torchpack|horovodrun|streamlit|jupyter(?:-notebook|-lab)?|(?:ba)?sh|mkdir|(?:ros)?cd|"
    r"wget|curl|gdown|dpkg|docker|add-apt-repository)\s.*|catkin_make(?:_isolated)?|(?:\.{1,2}|build|bin)/[\w./+-]+(?:\s.*)?)$"
)
_SPAN = pattern(r"(`+)(.+?)\1")
_ALONE = pattern(
    r"\s{0,12}(?:[-*+]\s+|\d{1,2}[.)]\s+)?(`{1,2})\s{0,4}(?:\$\s+)?([^`\n]{1,300}?)\s{0,4}\1\s{0,4}(?:<br\s?/?>)?\s*"
)
"""A line that is nothing but code."""
_BARE = pattern(r"make|ninja|\./[\w./+-]+")
"""A command without arguments, where it is the whole line."""
_SUBSTITUTED = pattern(r"(?<=[\w:=/-])`[^`\n]+`|`[^`\n]+`(?=/\w)")
"""What a shell fills in within a word: ``-I:`rospack find demo`/msg``."""
_THERE = pattern(r"cd\s+[^\s;&|()]+\s*(?:;|&&)\s*[^\s()][^()]*$")
"""Code that goes to a folder and goes on: ``cd lib; ./build.sh``."""
_MARKED = pattern(r"\s{0,40}[>$]\s")
"""A line of a quotation, or behind the prompt of a shell: the lines that it goes on in may begin with ``>``, too."""
_MARK = pattern(r"^>\s{0,40}")
_BRANCH = pattern(r"\s{0,40}(?:[├└]─|[|`+]--)")
"""A branch of a drawn tree: the line above the first one names its root and is no command."""
_STRUCK = pattern(r"(?<!~)~~(?!~)((?:(?!~~)[\s\S]){1,2000})~~(?!~)")
"""Text that is struck through: ``~~outdated~~``."""
_PROMPT = pattern(r"^(?:\$|!|%)\s*")


def read(repository: Repository) -> Prose:
    """Return the install and run lines and the versions of the pages that explain how to install."""
    found = pages(repository)
    texts = [(file, text_of(repository, file)) for file in found]
    paths = (mention for file, text in texts for mention in python_path.read(repository, file, text))
    exported = (mention for file, text in texts for mention in exports.read(repository, file, text))
    above = (mention for file, text in texts for mention in _exported(repository, file, text))
    made = (mention for file, text in texts for mention in generated.read(repository, file, text))
    read = merge(of_page(repository, file) for file in found)
    own = functions(repository)
    called = meant(named(repository, dict.fromkeys(own, "")), own)
    return replace(read, mentions=(*read.mentions, *paths, *exported, *above, *made, *called))


def _exported(repository: Repository, file: File, text: str) -> Iterator[Mention]:
    for line, code, heading in _code(text, exports.ANY) if "export " in text else ():
        yield from exports.of_line(repository, file, line, code, heading)


def named(
    repository: Repository, programs: Mapping[str, str], folders: Mapping[str, str] | None = None
) -> tuple[Mention, ...]:
    """Return the lines in the blocks of pages that run one of these programs, which the repository installs.

    Each name with the file of the tree that is installed as it, if it is one. ``folders``: those of the projects that
    install them, to which a page goes before.
    """
    if not programs:
        return ()
    names = "|".join(map(re.escape, sorted(programs)))
    before = r"^\s*(?:[$>]\s+)?(?:[A-Z][A-Z0-9_]*=\S+\s+)*(?:\w+\s+run\s(?:.*\s)?)?"
    called = re.compile(rf"{before}(?:{names})(?:\s|$)", re.MULTILINE)
    found: list[Mention] = []
    for file in pages(repository):
        text = text_of(repository, file)
        runs = any(name in text for name in programs) and called.search(text)
        lists = made_lists.listing(text) if runs else frozenset()
        for line, code, heading in _code(text, called) if runs else ():
            if line in lists:
                continue
            for start, logical in logical_lines(BLANK.sub("$UNKNOWN", with_arguments(code)), line):
                found += (
                    Mention(
                        topic="command",
                        value=joined(command.words).replace(UNKNOWN, "…"),
                        source="readme",
                        file=file.path,
                        line=command.line,
                        text=" ".join(command.words).replace(UNKNOWN, "…")[:200],
                        heading=heading,
                        variables=command.assigned,
                    )
                    for command in map(started, commands(logical, start))
                    if command.words[0] in programs
                )
    given = (with_files_below(with_files(each, repository), folders or {}, repository) for each in found)
    return tuple(_with_own_file(mention, programs) for mention in given)


def _with_own_file(mention: Mention, programs: Mapping[str, str]) -> Mention:
    own = programs.get(mention.value.split()[0], "")
    return replace(mention, files=(own, *mention.files)) if own else mention


def of_page(repository: Repository, file: File) -> Prose:
    """Return what a page says; in its commands, files of the tree are relative to the root: ``../map.yaml``."""
    prose = _read(text_of(repository, file), file)
    found = (each for m in prose.mentions for each in _checked(m, repository))
    told = tuple(started_by_paths(found, prose.mentions))
    named = said_runs.read(repository, file, text_of(repository, file), told)
    told += tuple(each for m in named for each in (_done_by(m, repository) if m.topic == "command" else (m,)))
    asked = (each for mention in told for each in (*called(mention, repository), *octave.asked(mention, repository)))
    return replace(prose, mentions=told, dependencies=(*prose.dependencies, *asked))


def _compiled(mention: Mention, repository: Repository) -> Iterator[Mention]:
    from roslab.evidence.prose import presets  # noqa: PLC0415 - few pages compile by hand
    from roslab.evidence.prose.configured import of_another  # noqa: PLC0415 - as above

    if not of_another(mention, repository):
        yield presets.with_variables(mention, repository)


def _checked(mention: Mention, repository: Repository) -> Iterator[Mention]:
    if mention.topic == "build_script":
        yield from checked(mention, repository)
    elif mention.topic == "make":
        yield makes.with_makefile(mention, repository)
    elif mention.topic in {"fetched", "unpacked"}:
        yield from filter(None, [downloads.placed(mention, repository)])
    elif mention.topic == "data":
        yield from () if repository.named(mention.value.partition("?")[0].rpartition("/")[2]) else (mention,)
    elif mention.topic != "command":
        yield from _compiled(mention, repository) if mention.topic == "compiled" else (mention,)
    elif started := in_container(told := with_files(mention, repository), repository):
        yield from (with_files(started, repository),) if started.value else ()
    else:
        yield from _done_by(told, repository)


def _done_by(command: Mention, repository: Repository) -> Iterator[Mention]:
    """Yield a command with what it asks for, unless it leads away from the tree."""
    if not leads_elsewhere(command, repository):
        yield command
        yield from absent_launch(command, repository)
        yield from fetched_by(command, repository)
        yield from of_python(command, repository)
        yield from elsewhere(command, repository)


def _read(text: str, file: File) -> Prose:
    collector = Collector(file.path, "readme", distros_of(text))
    contained: list[Mention] = []
    if "~~" in text and "~~~" not in text:
        text = _STRUCK.sub(lambda match: "\n" * match[0].count("\n"), text)
    for line, code, heading in _code(text):
        collector.heading = heading
        collector.text(code, line)
        contained += started_in(code, line, heading, file.path) if any(engine in code for engine in ENGINES) else ()
    collector.sources = [*asides.marked(collector.sources, text), *links.read(text, file, collector.sources)]
    found = collector.prose()
    said = (
        *mentions.read(text, file.path, "readme"),
        *apt_scripts.read(file.path, text),
        *libtorch.read(file.path, text),
    )
    return replace(found, mentions=(*found.mentions, *contained, *said))


def _code(text: str, also: re.Pattern[str] | None = None) -> Iterator[tuple[int, str, str]]:
    """Yield ``(line, shell text, titles above it)``; what is simulated in a section about hardware has its own title.

    That is the lines of fenced and indented blocks, lines that begin with a command, and inline code; with ``also``,
    only the lines of fenced blocks in which it is found.
    """
    shown = with_examples(with_first_choice(here_lists.spelled_out(without_remarks(tops.gone_to(text)))))
    lines = shown.split("\n")
    if "[-" in shown:
        from roslab.evidence.prose.synopses import with_synopses  # noqa: PLC0415 - few pages have one

        lines = with_synopses(lines)
    signs = signs_in(shown) if not also else ()
    signed = lines_with(shown, (*signs, *IN_SENTENCES)) if not also else frozenset()
    titles: dict[int, str] = {}
    elsewhere = index = 0
    fenced, lead = False, ""
    title, commented, here = title_of(lines), commented_out(lines, _START), resumed(lines)
    while index < len(lines):
        line = lines[index]
        index += 1
        if not line.strip():
            continue
        elsewhere = 0 if elsewhere and index in here and about(titles) else elsewhere
        if fence(line):
            fenced = not fenced
            continue
        if not fenced:
            below = lines[index] if index < len(lines) else ""
            heading = heading_of(line, below)
            elsewhere = section_of(heading, elsewhere) if index != title else 0
            titles = under(titles, heading)
            lead = line if line.rstrip(" *_").endswith(":") or not line.startswith(("    ", "\t")) else lead
        drawn = fenced and index < len(lines) and _BRANCH.match(lines[index][:MAX_LINE])
        if also:
            tells = bool(fenced and not drawn and also.search(line))
        else:
            tells = index in signed and (telling(line, signs) or (not fenced and telling(line, IN_SENTENCES)))
        without = bool(elsewhere and tells) and simulated(lead, titles)
        if len(line) > MAX_LINE or not tells or index in commented or (elsewhere and not without):
            continue
        first, marked = index, _MARKED.match(line)
        while line.rstrip().endswith("\\") and index < len(lines) and len(line) < 4 * MAX_LINE:
            following = lines[index].lstrip()
            line = line.rstrip() + "\n" + (_MARK.sub("", following) if marked else following)
            index += 1
        title = not fenced and "`" in line and titles_commands(lines, first)
        for shell in map(without_notes, _shell(line, signs, fenced=fenced, title=title)):
            yield first, shell, " / ".join((*titles.values(), *((lead.strip(" :*_"),) if without else ())))


def _shell(line: str, signs: Signs, *, fenced: bool, title: bool) -> Iterator[str]:
    bold = tuple(emphasised(line, _START)) if not fenced else ()
    line = without_marks(typed(line, block=fenced), fenced=fenced)
    if (alone := _ALONE.fullmatch(line)) and (_START.match(alone[2]) or _BARE.fullmatch(alone[2])):
        line, fenced = alone[2], True
    if match := _START.match(line.replace("\\\n", "\\\x01")):
        shell = _PROMPT.sub("", match[1].strip()).replace("\\\x01", "\\\n")
        # In a block they are the shell's, else Markdown's, but for the distribution in ros-`rosversion -d`-tf
        yield shell if fenced else _SUBSTITUTED.sub("$UNKNOWN", fill_placeholders(shell)).replace("`", "")
    elif fenced:
        yield line
    else:
        found = (*_SPAN.finditer(line), *bold)
        spans = (typed(s[2]) for s in found if not of_failure(s.string, s.start(), s.end(), s[2].strip()))
        told = (span for span in spans if telling(span, signs) and " " in span)
        yield from (f"({span})" if _THERE.match(span) else span for span in told)  # a shell of its own
        yield from in_sentence(line, title=title)
