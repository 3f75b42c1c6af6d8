"""What a sentence says is to be run, without a command: ``The script to run is `demo/a.py` ``, ``Run `./bin/a` ``."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Collection, Iterable, Iterator

from roslab.evidence.facts import Mention
from roslab.evidence.prose.headings import MAX_LINE, Line, lines_of
from roslab.evidence.prose.own_files import with_files
from roslab.evidence.prose.started_in import started_in
from roslab.repository.checkout import File, Repository
from roslab.values.dataclass import replace
from roslab.values.pattern import pattern
from roslab.values.words import joined

_FILE = r"(?<!`)`{1,2}(?P<path>(?:\./)?(?:[\w.-]+/)*[\w-]+\.(?:py|(?:ba)?sh))(?P<rest>(?: [^`<\n]{1,200})?)`{1,2}(?!`)"
_SHELL = (".sh", ".bash")
_ENDINGS = (".py", *_SHELL)
_SPAN = pattern(_FILE)
_THING = r"(?:scripts?|files?|programs?|modules?|code|entry[- ]?points?)"
_RUN = r"(?:run|execut\w+|start\w*|launch\w*)\b(?! by\b)"
_ITS = rf"(?:(?:the|our|this)\s+)?(?:(?:[\w-]+\s+)?{_THING}\s+)?{_FILE}"
_WHO = r"\b(?:to|must|should|can|need)\b[^.`]{0,12}"
_EXAMPLE = r"(?:provides|gives|has|contains|is|shows)\s+an?\s+example\s+(?:(?:of|on|for)\s+)?"
_SAID = tuple(
    pattern(form, re.IGNORECASE)
    for form in (
        rf"\b{_THING}\b[^.`]{{0,40}}\b{_RUN}[^.`]{{0,20}}(?:\bis\b|:)[^.`]{{0,15}}{_FILE}",
        rf"\b(?:is|are|be)\s+(?:run|executed|started|launched)\s+(?:by|using|via|through)\s+{_ITS}",
        rf"{_FILE}\s+is\s+(?:the|our|an?)\s+(?:[\w-]+\s+){{0,2}}{_THING}\b[^.`]{{0,20}}{_WHO}\b{_RUN}",
        rf"{_FILE}\s+(?:{_EXAMPLE}|shows\s+)how\s+to\s+{_RUN}[^.`]{{0,30}}",
    )
)
"""A sentence that runs a script by its path."""
_IN_FOLDER = r"(?:\./)?(?:[\w.-]{1,80}/){0,9}(?:bin|build|Release)/(?:[\w.-]{1,80}/){0,9}[\w+-]{1,80}"
_BUILT = rf"(?<!`)`(?P<path>{_IN_FOLDER})(?P<rest>(?: [^`<\n]{{1,200}})?)`(?!`)"
_BY = r"(?:by|with|using|via|through)"
_VERB = r"(?:run(?:n?ing)?|start(?:ing)?|launch(?:ing)?|execut(?:e|ing)|call(?:ing)?|invok(?:e|ing)|typ(?:e|ing)|enter)"
_COMPILED = tuple(
    pattern(form, re.IGNORECASE)
    for form in (
        rf"\b{_VERB}\b(?:\s+(?:it|the|a|program|executable|binary|our|file)){{0,3}}(?:\s+{_BY})?:?\s+{_BUILT}",
        rf"\b(?:run|executed|started|launched|called|invoked)\s+{_BY}(?:\s+\w+ing)?\s+{_BUILT}",
        rf"{_BUILT}\s+(?:runs|starts|launches|opens)\b",
    )
)
"""A sentence that runs by its path what is compiled: ``Run `./bin/navigation` ``, `` `./build/demo` starts it``."""
_ITEM = pattern(
    r"^[ \t]{0,6}[-*+][ \t]+`{1,2}(?P<name>[A-Za-z]\w*(?:-\w+)*)`{1,2}[ \t]*(?:[:\u2013\u2014]|-[ \t])", re.MULTILINE
)
"""An item of a list that begins with a name in code and tells what it does: only that of a program counts later."""
_TOLD = pattern(
    r"(?:^[ \t>]{0,8}(?:[-*+]|\d{1,3}[.)])?[ \t]{0,4}|[.:;,] |\b(?:then|and|please|just|simply) )"
    r"(?:run|execute|start|launch)(?: (?:the|our|this))?(?: (?:script|file|program))?(?::|) "
    r"(?P<mark>`{0,2})(?P<path>(?:\./)?(?:[\w-]{1,80}/){0,9}[\w-]{1,80}\.(?:ba)?sh)(?P=mark)(?![\w`/-])",
    re.IGNORECASE,
)
"""A sentence that has a script of the shell run, in code or in plain words: ``- execute run.sh``."""
_HELPS = pattern(
    r"install|setup|set_up|build|compile|make|config|depend|deps|require|download|fetch|docker|container|image|conda|"
    r"v?env|clean|format|lint|update|upgrade|deploy|flash|udev|clone|submodule|test|ci(?:[_./-]|$)",
    re.IGNORECASE,
)
"""The name of a script that prepares or looks after the tree."""
_TESTS = pattern(r"\b(?:unit)?tests?\b|\bCI\b", re.IGNORECASE)
"""What such a sentence runs for those who work on the code."""
_NO_MORE = pattern(r"\b(?:not|never|no longer|used to|old|deprecated|obsolete)\b|n't\b", re.IGNORECASE)
"""What is not, or no more, to be run."""
_TITLE = pattern(
    r"^\W*(?:\d[\d.]*\W*)?(?:how to (?:run|use|start|launch|execute)|"
    r"(?:run|runn?ing|usage|execution)\b(?! (?:the )?tests?\b))",
    re.IGNORECASE,
)
"""A section that has one script run, if it names no other and gives no command."""
_SET = pattern(
    r"\b(?:edit|modif|chang|adjust|configur|adapt|tun(?:e|ing)|set|sets|setting|open|inspect|implement|defin|written|"
    r"found|locat|instead|not|n't|cannot|refactor|replac|import)",
    re.IGNORECASE,
)
"""A sentence that speaks of what the file holds, or of what it is no more."""
_IN = pattern(
    r"\b(?:in|into|inside|of|from|at|like|as|with|see also)\s+(?:the\s+)?(?:(?:file|script)\s+)?\Z", re.IGNORECASE
)


def read(repository: Repository, page: File, text: str, mentions: Iterable[Mention]) -> Iterator[Mention]:
    """Yield the command that starts each such script: by its path from the root, or in its folder.

    It starts in its folder where it, or a module beside it, names a path that is in the tree from there alone.
    ``mentions``: what the page runs by commands. What is compiled starts by the path that the sentence has.
    """
    if not _may_say(text):
        return
    commands = [m for m in mentions if m.topic == "command"]
    known = {word for m in commands for word in m.value.split()}
    lines = [line for line in lines_of(text) if not line.elsewhere and len(line.text) <= MAX_LINE]
    found: dict[str, Mention] = {}
    for line in lines:
        if line.fenced or line.heading or "`" not in line.text:
            continue
        for written, rest in _named(line.text):
            _keep(found, _mention(written, rest, line, page, repository), known)
        for each in _compiled(line, page, known):
            found.setdefault(each.value, each)
    taken = {m.heading for m in (*commands, *found.values())}
    for line, written, rest in _alone(lines, taken, page, repository):
        _keep(found, _mention(written, rest, line, page, repository), known)
    for line, name in _items(lines, taken | known, commands):
        found.setdefault(name, _command((name,), line, page))
    for line, path in _told(lines, commands, found):
        _keep(found, _mention(path, "", line, page, repository), known)
    yield from found.values()
    yield from (replace(each, topic="said_run", files=(), inside="", heading="") for each in found.values())


def _keep(found: dict[str, Mention], mention: Mention | None, known: set[str]) -> None:
    if mention and not {*mention.files, *(posixpath.basename(file) for file in mention.files)} & known:
        found.setdefault(mention.value, mention)


def _named(text: str) -> Iterator[tuple[str, str]]:
    """Yield the path and the arguments of each script that a line says is to be run."""
    for form in _SAID:
        for match in form.finditer(text):
            said = _SPAN.sub("", match[0])
            if not (_TESTS.search(said) or _NO_MORE.search(text[max(0, match.start() - 30) : match.start()] + said)):
                yield match["path"], match["rest"]


def _may_say(text: str) -> bool:
    """Tell whether a page may name what is read here: a script of the shell, or something in code."""
    shell = any(ending in text for ending in _SHELL)
    return shell or ("`" in text and (".py" in text or _built(text) or bool(_ITEM.search(text))))


def _starts(command: Mention) -> bool:
    """Tell whether a command of the page starts a file of the tree or a launch, and builds or installs nothing."""
    return (
        any(file.endswith(_ENDINGS) for file in command.files) or "launch" in command.value or "rosrun" in command.value
    )


def _told(lines: Iterable[Line], commands: Iterable[Mention], found: Collection[str]) -> Iterator[tuple[Line, str]]:
    """Yield each script of the shell that a sentence has the reader run, and that does more than prepare the tree.

    None where the page has ``found`` others, or one of its ``commands`` starts something of the tree: that is meant.
    """
    for line in () if found or any(map(_starts, commands)) else lines:
        if line.fenced or line.heading or not any(ending in line.text for ending in _SHELL):
            continue
        for said in _TOLD.finditer(line.text):
            around = line.text[max(0, said.start() - 30) : said.start("path")] + line.text[said.end() : said.end() + 40]
            if not (_HELPS.search(said["path"]) or _TESTS.search(around) or _NO_MORE.search(around)):
                yield line, said["path"]


def _built(text: str) -> bool:
    """Tell whether a page has the path of what is compiled in code."""
    return any(f"{folder}/" in text for folder in ("bin", "build", "Release"))


def _compiled(line: Line, page: File, known: set[str]) -> Iterator[Mention]:
    """Yield the command of each compiled program that a line says is to be run, if the page does not start it."""
    for match in (match for form in _COMPILED for match in form.finditer(line.text)):
        around = line.text[max(0, match.start() - 30) : match.start()] + line.text[match.end() : match.end() + 40]
        if not (_TESTS.search(around) or _NO_MORE.search(around)):
            path = match["path"].removeprefix("./")
            if known.isdisjoint((path, f"./{path}")):
                yield _command((f"./{path}", *match["rest"].split()), line, page)


def _command(words: Iterable[str], line: Line, page: File) -> Mention:
    value, heading = joined(words), " / ".join(line.titles.values())
    return Mention(
        topic="command", value=value, source="readme", file=page.path, line=line.number, text=value, heading=heading
    )


def _alone(
    lines: Iterable[Line], taken: Collection[str], page: File, repository: Repository
) -> Iterator[tuple[Line, str, str]]:
    """Yield the one script that a section on running names, where it has neither a block nor a command."""
    for heading, section in _sections(lines).items():
        title = heading.rpartition(" / ")[2]
        if heading in taken or not _TITLE.search(title) or any(line.fenced for line in section):
            continue
        named = ((line, span) for line in section if not line.heading for span in _SPAN.finditer(line.text))
        spans = [(line, span) for line, span in named if not _in_a_cell(line.text, span)]
        if len({_path(span["path"], page, repository) for _, span in spans}) != 1:
            continue
        line, span = spans[0]
        if not any(_SET.search(each.text) or _IN.search(each.text[: it.start()]) for each, it in spans):
            yield line, span["path"], span["rest"]


def _items(lines: Iterable[Line], known: Collection[str], commands: Iterable[Mention]) -> Iterator[tuple[Line, str]]:
    """Yield the names with which items of sections on running begin that have neither a block nor a command.

    None where one of the page's ``commands`` starts something by its path: that is meant first.
    """
    if any("/" in m.value.partition(" ")[0] for m in commands):
        return
    for heading, section in _sections(lines).items():
        if heading in known or not _TITLE.search(heading.rpartition(" / ")[2]) or any(line.fenced for line in section):
            continue
        for line in section:
            if (item := _ITEM.match(line.text)) and item["name"] not in known:
                yield line, item["name"]


def _sections(lines: Iterable[Line]) -> dict[str, list[Line]]:
    sections: dict[str, list[Line]] = {}
    for line in lines:
        sections.setdefault(" / ".join(line.titles.values()), []).append(line)
    return sections


def _in_a_cell(text: str, span: re.Match[str]) -> bool:
    """Tell whether a cell of a table says more than the path, as a list of plans does."""
    cell = text[: span.start()].rpartition("|")[2] + text[span.end() :].partition("|")[0]
    return text.lstrip().startswith("|") and bool(cell.strip())


def _mention(written: str, rest: str, line: Line, page: File, repository: Repository) -> Mention | None:
    """Return the command that starts a script of the tree, ``None`` for one that the tree lacks."""
    path = _path(written, page, repository)
    if path is None:
        return None
    program = "python" if path.endswith(".py") else "bash"
    said = with_files(_command((program, path, *rest.split()), line, page), repository)
    folder, name = posixpath.split(path)
    if said.inside or not folder or program != "python":
        return said
    there = replace(said, value=joined((program, name, *rest.split())), inside=folder)
    return replace(said, inside=started_in(there, said.value.split(), repository, went=False))


def _path(written: str, page: File, repository: Repository) -> str | None:
    """Return the path of a script from the root, or from the folder of its page."""
    path = posixpath.normpath(written)
    below = posixpath.join(page.folder, path)
    return path if repository.has(path) else below if repository.has(below) else None
