"""Archives that pages, scripts and CI unpack into the reader's home, of which the tree's build or code speaks."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterable, Iterator

from roslab.evidence import places
from roslab.evidence.facts import Mention
from roslab.evidence.lex.shell import UNKNOWN, Command, commands, expand, logical_lines
from roslab.evidence.prose import author_dockerfile, handed_places
from roslab.evidence.prose.downloads import option, stem_of
from roslab.evidence.prose.installs import MentionSource
from roslab.evidence.prose.merged import Prose
from roslab.evidence.prose.named_places import Named, Readers
from roslab.evidence.prose.pages import pages, text_of
from roslab.repository.checkout import File, Repository, nearest
from roslab.values.dataclass import dataclass, field
from roslab.values.endings import SHELL_SCRIPTS
from roslab.values.pattern import pattern

MAX_SIZE = 128 * 1024
MAX_FILES = 200
DEEPEST = 3
"""Most folders above a script that is read."""
_FETCHES = pattern(r"\b(?:wget|curl)\b")
_UNPACKS = pattern(r"\b(?:tar|unzip)\b")
_OF_HOME = pattern(r"~|\bHOME\b|/home/|/root\b")
_HOME = pattern(r"^(?:~|/root|/home/[\w.-]+)(?=/|$)")
_BELOW_HOME = pattern(r"~(?:/|$)")
"""The reader's own home, and not that of ``~somebody``."""
_SPAN = pattern(r"`{1,3}([^`\n]+)`{1,3}")
_LEADS = pattern(r"^[\s>*\d.)$%#-]*(?:run:\s*)?")
"""What stands before a command: the marks of a list or a quotation, a prompt, a key of CI."""
_CALLS = pattern(r"^(?:RUN\s|sudo\s|mkdir\s|cd\s|wget\s|curl\s|tar\s|unzip\s)")
_ASSIGNED = pattern(
    r"^[ \t]*(?:export[ \t]+|ENV[ \t]+|ARG[ \t]+)?([A-Za-z_]\w*)=[\"']?([\w./:${}~+-]+)[\"']?[ \t]*$", re.MULTILINE
)
_URL = pattern(rf"https?://[^\s\"'<>{UNKNOWN}]+/[^\s\"'<>{UNKNOWN}]+$")
_ARCHIVE = pattern(r"\.(?:zip|tar|tgz|tbz2|txz|tar\.(?:gz|bz2|xz))$")
_OTHER = pattern(r"mac[_-]?os|osx|darwin|windows|win(?:32|64)|aarch64|arm64|(?<![a-z])armv?\d", re.IGNORECASE)
"""Of another system or processor than most images have."""
_WORKED_IN = pattern(r"(?:^|/)(?:src|\w*_?ws|Downloads|Desktop|tmp|\.cache)(?:/|$)")
"""Folders in which the reader works, and no place that a program looks in."""
_EXPORTED = pattern(
    r"""\bexport[ \t]+([A-Z][A-Z0-9_]{2,40})="""
    r"""(?:\\?"([^"'\\\n]{1,300})\\?"(?=[\s"'`;&|)]|$)|'([^"'\n]{1,300})'(?=[\s"`;&|)]|$)|([^\s"'`;&|()]{1,300}))"""
)
"""A variable with its value: one word of the shell, in quotes or up to the end of a text that ``echo`` writes."""
_PLACE = pattern(r"~/[\w./+@ -]+")
"""A place that is written out, in the characters that such a path has."""
_SET_BY_IMAGE = frozenset({"HOME", "PATH"})
"""Variables with which every program of the image starts: a folder of an archive takes the place of neither."""
_SEARCHED = frozenset({"LD_LIBRARY_PATH", "CMAKE_PREFIX_PATH"})
"""Lists of folders that the linker and CMake read themselves."""
_INTO = {"wget": ("-O", "--output-document"), "curl": ("-o", "--output")}
_BELOW = {
    "wget": ("-P", "--directory-prefix"),
    "curl": ("--output-dir",),
    "unzip": ("-d",),
    "tar": ("-C", "--directory"),
}
_NAMED = frozenset({"variable", "handed_place"})
_STRIP = "--strip-components"
_FEW = pattern(r"[0-9]{1,2}")
"""As many folders as a path has."""


@dataclass(frozen=True, kw_only=True, slots=True)
class _Unpacked:
    """An archive that is unpacked into a folder of the home; ``strip``: how many folders tar leaves out."""

    url: str
    folder: str
    line: int
    strip: str = "0"


@dataclass
class _Reader:
    """Follows the commands of one text: where it is, and which archives it fetched."""

    variables: dict[str, str]
    folder: str = ""
    fetched: dict[str, str] = field(default_factory=dict)
    piped: str = ""
    found: list[_Unpacked] = field(default_factory=list)
    elsewhere: list[_Unpacked] = field(default_factory=list)
    """What is unpacked outside of the home, as if it went there."""

    def command(self, command: Command) -> None:
        """Read one command."""
        words = command.words
        program = words[0].rpartition("/")[2]
        if program == "cd" and len(words) > 1:
            self.folder = self._at(words[1])
        elif program in _INTO:
            self._fetch(program, words)
        elif program in {"tar", "unzip"}:
            self._unpack(program, command)

    def _at(self, path: str) -> str:
        path = _HOME.sub("~", path)
        return posixpath.normpath(path if path.startswith("~") else posixpath.join(self.folder, path))

    def _fetch(self, program: str, words: tuple[str, ...]) -> None:
        url = next((word for word in words[1:] if _URL.match(word)), "")
        name = posixpath.basename(option(words, _INTO[program]) or url.partition("?")[0])
        if url and not _OTHER.search(url):
            self.piped = url
            self.fetched[name] = url

    def _unpack(self, program: str, command: Command) -> None:
        archive = next((word for word in command.words[1:] if _ARCHIVE.search(word)), "")
        url = self.fetched.get(posixpath.basename(archive), "") if archive else self.piped
        into = option(command.words, _BELOW[program])
        folder = self._at(into) if into else self.folder
        if not url or not _ARCHIVE.search(url.partition("?")[0]):
            return
        strip = (option(command.words, (_STRIP,)) if program == "tar" else "") or "0"
        below = folder[2:] or "."
        if _BELOW_HOME.match(folder) and UNKNOWN not in folder and not _WORKED_IN.search(below):
            if _FEW.fullmatch(strip):
                self.found.append(_Unpacked(url=url, folder=below, line=command.line, strip=strip))
        elif strip == "0":
            self.elsewhere.append(_Unpacked(url=url, folder=".", line=command.line))


def read(repository: Repository) -> Prose:
    """Return each archive with its folder in the home, and the variables that the text exports with a place in it.

    Only where a build file or the code names that folder or reads such a variable: nothing else looks for it.
    """
    found: list[Mention] = []
    readers = Readers(repository)
    texts = tuple(_texts(repository))
    fetching = [each for each in texts if _FETCHES.search(each[2]) and _UNPACKS.search(each[2])]
    handed = handed_places.handed(repository, texts) if fetching else ()
    for file, source, text in fetching:
        if not (handed or _OF_HOME.search(text)):
            continue
        reader = _Reader({"HOME": "~", **_assigned(text)})
        for start, line in _lines(text):
            for command in commands(line, start, reader.variables):
                reader.command(command)
        folders = tuple(dict.fromkeys(each.folder for each in reader.found))
        for folder in folders:
            offered = [each for each in reader.found if each.folder == folder]
            variables = tuple(_exported(text, offered, file, source, readers))
            for each, named in _spoken(offered, readers, variables):
                found += (_archive(each, file, source, named), *variables)
        for each in (*reader.found, *reader.elsewhere) if handed else ():
            if said := tuple(handed_places.mentions(handed, name_of(each.url), each.folder, source)):
                found += (_archive(each, file, source, said[0].inside), *said)
    first = {(m.topic, m.value.partition("=")[0] if m.topic in _NAMED else m.value): m for m in reversed(found)}
    chosen = frozenset(first.values())
    return Prose((), (), (), tuple(dict.fromkeys(m for m in found if m in chosen)))


def _archive(each: _Unpacked, file: File, source: MentionSource, reader: str) -> Mention:
    return Mention(
        topic="home_archive",
        value=each.url,
        source=source,
        file=file.path,
        line=each.line,
        text=f"{each.url.rpartition('/')[2]} in ~/{each.folder}",
        files=(each.folder, each.strip),
        inside=reader,
    )


def name_of(url: str) -> str:
    """Return the name of the folder that most such archives hold: without the system and the processor."""
    return re.sub(
        r"[-_.](?:linux|ubuntu|x86|amd64|x64|shared|cxx11|with)(?![a-z]).*$", "", stem_of(url.partition("?")[0])
    )


def _texts(repository: Repository) -> Iterator[tuple[File, MentionSource, str]]:
    for page in pages(repository):
        yield page, "readme", text_of(repository, page)
    scripts = [file for file in repository.suffixed(*SHELL_SCRIPTS) if file.path.count("/") <= DEEPEST]
    workflows = [file for file in repository.suffixed(".yml", ".yaml") if file.folder == ".github/workflows"]
    written: tuple[tuple[MentionSource, Iterable[File]], ...] = (
        ("script", scripts),
        ("dockerfile", author_dockerfile.files(repository)),
        ("ci", workflows),
    )
    for source, files in written:
        own = [file for file in files if not places.vendored(file.path) and file.size < MAX_SIZE]
        for file in nearest(own)[:MAX_FILES]:
            yield file, source, repository.read(file)


def _assigned(text: str) -> dict[str, str]:
    known: dict[str, str] = {"HOME": "~"}
    for match in _ASSIGNED.finditer(text):
        value = expand(match[2], known)
        if "$" not in value:
            known.setdefault(match[1], value)
    return known


def _lines(text: str) -> Iterator[tuple[int, str]]:
    for start, line in logical_lines(text):
        if not (_FETCHES.search(line) or _UNPACKS.search(line) or "cd " in line):
            continue
        bare = _LEADS.sub("", line)
        if _CALLS.match(bare):
            yield start, bare.rstrip("`")
        else:
            yield from ((start, span[1]) for span in _SPAN.finditer(line) if _CALLS.match(span[1]))


def _spoken(
    offered: Iterable[_Unpacked], readers: Readers, variables: tuple[Mention, ...]
) -> Iterator[tuple[_Unpacked, str]]:
    """Yield the archives of a folder that are named by theirs, else the first if the folder is, each with the reader.

    What goes to the home itself, or below an ordinary folder of it, has to be named itself.
    """
    found = [(each, readers.naming(*_named(each))) for each in offered]
    exact = [(each, named) for each, named in found if named]
    first = found[0][0]
    if exact:
        yield from exact
    elif first.folder != "." and (named := readers.naming(Named(folder=first.folder))):
        yield first, named
    elif read := next((each.inside for each in variables if each.inside), ""):
        yield first, read


def _named(each: _Unpacked) -> tuple[Named, ...]:
    if each.strip != "0":
        return (Named(folder=each.folder),)
    below = "" if each.folder == "." else each.folder
    stem = name_of(each.url)
    return (Named(folder=posixpath.join(below, stem)), *([Named(folder=stem, begins=True)] if not below else []))


def _exported(
    text: str, offered: list[_Unpacked], file: File, source: MentionSource, readers: Readers
) -> Iterator[Mention]:
    """Yield the variables that a text exports with a place below what is unpacked, each with what reads it."""
    below = [each.folder if each.folder != "." else name_of(each.url) for each in offered]
    for match in _EXPORTED.finditer(text):
        parts = [part.lstrip("\\") for part in (match[2] or match[3] or match[4].partition(">>")[0]).split(":")]
        parts = [_HOME.sub("~", re.sub(r"^\$(?:HOME\b|\{HOME\})", "~", part)).rstrip("/") for part in parts]
        inside = [p for p in parts if any(f"{p}/".startswith(f"~/{each}/") for each in below) and _PLACE.fullmatch(p)]
        searched = match[1] in _SEARCHED
        if inside and match[1] not in _SET_BY_IMAGE and (searched or len(parts) == 1):
            by = "" if searched else readers.reading(match[1])
            value = f"{match[1]}={':'.join(inside)}"
            line = text.count("\n", 0, match.start(1)) + 1
            yield Mention(
                topic="variable", value=value, source=source, file=file.path, line=line, text=value, inside=by
            )
