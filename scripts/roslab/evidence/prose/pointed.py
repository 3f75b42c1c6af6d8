"""Launch files, scripts, notebooks and examples of the tree that a page at the root only names in its sentences."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import NamedTuple

from roslab.evidence.facts import Mention
from roslab.evidence.prose.headings import MAX_LINE, lines_of
from roslab.evidence.prose.pages import pages, text_of
from roslab.evidence.prose.script_folders import started_above, started_beside
from roslab.evidence.python.top_level import first_statement
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

_FILE = pattern(r"(?<![\w./-])(?:\./)?(?:[\w-]+/)*[\w-]+(?:\.launch(?:\.(?:py|xml))?|\.(?:ba)?sh|\.ipynb)(?![\w/-])")
_EXAMPLE = pattern(r"(?<![\w./-])(?:\./)?(?:[\w-]+/)*(?:[\w-]+_)?(?:examples?|demo)(?:_[\w-]+)?\.py(?![\w/-])")
_WORDS = (".launch", ".sh", ".bash", ".ipynb", "example", "demo", ".py")
"""Of these each match of the forms has one."""
_SHOWS = pattern(r"\b(?:shows?|demonstrat(?:es?|ing)|illustrat(?:es?|ing)|explains?)\b", re.IGNORECASE)
"""A sentence on what an example is for: ``example.py shows how to use it``."""
_PYTHON = r"[`*\"'(\[]{0,3}(?:\./)?(?P<path>(?:[\w-]+/)*[\w-]+\.py)(?![\w/-])"
_SPAN = r"``?(?:\./)?(?P<path>(?:[\w-]+/)*[\w-]+\.py)``?"
_THING = r"(?:script|file|program)"
_VERB = r"(?:run|execute|start|launch|call)"
_MAIN_ONE = r"(?:(?:main|primary)\s+(?:file|script|program|module)|(?:main\s+)?entry[- ]?point)"
_MAIN = tuple(
    pattern(form, re.IGNORECASE)
    for form in (
        rf"\b{_MAIN_ONE}\b[^.`:]{{0,60}}?(?:\bis|:)\s+{_PYTHON}",
        rf"{_PYTHON}[`*\"')\]]{{0,3}}\s+is\s+(?:the|our)\s+{_MAIN_ONE}\b",
        rf"(?<!not )(?<!n't )(?<!never )(?<!to re)\brun(?:ning)?\s+(?:the\s+)?(?:(?:script|file|program)\s+)?{_PYTHON}",
    )
)
"""A sentence that calls a program of Python the main one, or has it run without a command."""
_RUN = tuple(
    pattern(form, re.IGNORECASE)
    for form in (
        rf"(?<!not )(?<!n't )\b(?:call|(?:execut|start|launch|call)ing)\s+(?:the\s+)?(?:{_THING}\s+)?{_SPAN}",
        rf"{_SPAN}[^.`]{{0,40}}\b(?:and|then|to)\s+(?:then\s+)?{_VERB}\s+(?:it|this|that|the {_THING})\b",
    )
)
"""A sentence that has one in backquotes run by other words than a command is read from, maybe on two lines."""
_OFFERED = pattern(rf"{_SPAN}\s+(?:script\s+)?(?:can|may)\s+be\s+used\s+(?:to|for)\b", re.IGNORECASE)
"""A sentence that says what a program of Python is for."""
_LINKED = pattern(
    r"\[[^\]\n]{0,80}\b(?:example|demo)(?: (?:script|file|program))?[`*]{0,3}\]"
    r"\((?:\./)?(?P<path>(?:[\w-]+/)*[\w-]+\.py)\)",
    re.IGNORECASE,
)
"""A link whose text calls a program of Python an example: ``[our usage example](python/first.py)``. Of a page with
several none is the one."""
_RUNNING = pattern(
    r"(?:^|/ )\W*(?:\d[\d.]*\W*)?(?:how to (?:run|use|start|execute)|run(?:ning)?\b|usage|getting started|quick.?start|"
    r"execution)",
    re.IGNORECASE,
)
"""A section on starting it: what it says of a program goes before what others do."""
_NEXT_ITEM = pattern(r"\s*(?:[-*+>|#]|\d+[.)])")
_COMMAND = pattern(r"\b(?:roslaunch|rosrun|rosbag\s+(?:play|record|info|filter|reindex)|ros2)\s")
"""A line that runs something: it is read as a command."""
_TUNED = pattern(
    r"\b(?:tun(?:e[ds]?|ing)|adjust(?:s|ed|ing)?|configur(?:e[ds]?|ing)|edit(?:s|ed|ing)?|modif(?:y|ies|ied|ying)|"
    r"chang(?:e[ds]?|ing)|explained|described|documented)\b[^.;]{0,120}\Z",
    re.IGNORECASE,
)
"""The words of a sentence before a file in which something is set or explained: ``See how to tune it in a.launch``."""
_STARTS = pattern(
    r"\b(?:runs?|running|starts?|started|starting|execut(?:e[ds]?|ing)|launch(?!\s*-?files?\b)\w*)\b", re.IGNORECASE
)
_USES = pattern(
    r"\b(?:use|try|play)\s+(?:the\s+)?(?:(?:launch\s*-?\s*)?files?\s+|(?:script|notebook|example)\s+)?[`*\"'(\[]{0,9}\Z",
    re.IGNORECASE,
)
"""The words right before a file that is to be started: ``use`` a map, and the parameters used in it, tell nothing."""
MOST = 20
"""Most files that are kept."""


class _Sentence(NamedTuple):
    """A line of a page."""

    number: int
    text: str
    heading: str
    whole: str
    """With the next line, where that goes on."""


def read(repository: Repository) -> tuple[Mention, ...]:
    """Return each such file once, by its path, with the titles that it stands under."""
    found: dict[str, Mention] = {}
    for page in pages(repository):
        text = text_of(repository, page) if "/" not in page.path else ""
        linked = (_LINKED,) if len({match["path"] for match in _LINKED.finditer(text)}) == 1 else ()
        for sentence in _sentences(text) if any(word in text for word in _WORDS) else ():
            for line, written, at in _named(sentence, repository, linked):
                path = None if _only_set(line, written, at) else _path(written, repository)
                if path and len(found) < MOST:
                    said = Mention(
                        topic="pointed",
                        value=path,
                        source="readme",
                        file=page.path,
                        line=sentence.number,
                        text=line.strip()[:200],
                        heading=sentence.heading,
                        inside=started_above((path,), repository) or started_beside((path,), repository),
                    )
                    kept = found.setdefault(path, said)
                    if path.endswith(".py") and _RUNNING.search(said.heading) and not _RUNNING.search(kept.heading):
                        found[path] = said
    return tuple(found.values())


def offered(text: str, path: str) -> bool:
    """Tell whether a line only says what a program can be used for."""
    return any(path.endswith(match["path"]) for match in _OFFERED.finditer(text))


def _named(
    sentence: _Sentence, repository: Repository, linked: tuple[re.Pattern[str], ...] = ()
) -> Iterator[tuple[str, str, int]]:
    """Yield each file that a sentence names so, with the words around it and its place in these.

    ``linked``: the form of a link to the example of a page, if it has one.
    """
    line = sentence.text
    yield from ((line, match[0].removeprefix("./"), match.start()) for match in _FILE.finditer(line))
    if _SHOWS.search(line):
        yield from ((line, match[0].removeprefix("./"), match.start()) for match in _EXAMPLE.finditer(line))
    if ".py" not in sentence.whole:
        return
    for form in _MAIN:
        yield from ((line, match["path"], match.start("path")) for match in form.finditer(line))
    line = sentence.whole
    for form in (*_RUN, _OFFERED, *linked):
        for match in form.finditer(line):
            if match.start() < len(sentence.text) and _is_program(match["path"], repository):
                yield line, match["path"], match.start("path")


def _is_program(written: str, repository: Repository) -> bool:
    """Tell whether a file of the tree does something when it is started."""
    path = _path(written, repository)
    text = repository.read(path) if path else ""
    return "__main__" in text or first_statement(text) is not None


def _only_set(line: str, written: str, at: int) -> bool:
    """Tell whether a line names a file only as the place where something is set, and has nothing started.

    A notebook that explains something is run for that.
    """
    if written.endswith(".ipynb") or not _TUNED.search(_FILE.sub("", line[:at])):
        return False
    return not (_STARTS.search(_FILE.sub("", line)) or _USES.search(line[:at]))


def _path(written: str, repository: Repository) -> str | None:
    """Return the path of a file of the tree, ``None`` if there is none or several of its name.

    ``PACKAGE/FILE.launch`` may lie in the package's folder for launch files.
    """
    if repository.has(written):
        return written
    folder, _, name = written.rpartition("/")
    ends = (f"/{written}", f"/{folder}/launch/{name}" if folder else f"/{written}")
    named = [file.path for file in repository.named(name) if f"/{file.path}".endswith(ends)]
    return named[0] if len(named) == 1 else None


def _sentences(text: str) -> Iterator[_Sentence]:
    """Yield the lines outside of blocks and of sections for other systems, each with the titles above it."""
    lines = [
        line
        for line in lines_of(text)
        if not (line.fenced or line.heading or line.elsewhere or len(line.text) > MAX_LINE)
        and not _COMMAND.search(line.text)
    ]
    for place, line in enumerate(lines, 1):
        after = lines[place] if place < len(lines) else None
        goes_on = after and after.number == line.number + 1 and after.text.strip() and not _NEXT_ITEM.match(after.text)
        whole = f"{line.text.rstrip()} {after.text.strip()}" if after and goes_on else line.text
        yield _Sentence(line.number, line.text, " / ".join(line.titles.values()), whole)
