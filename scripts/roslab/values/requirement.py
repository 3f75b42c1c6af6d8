"""What pip is asked for, parsed once: later code uses the fields and parses no line again."""

from __future__ import annotations

import re
from dataclasses import dataclass, replace
from functools import cache
from typing import Literal, NamedTuple
from urllib.parse import unquote

from packaging.markers import InvalidMarker, Marker
from packaging.requirements import InvalidRequirement
from packaging.requirements import Requirement as Parsed
from packaging.specifiers import SpecifierSet
from packaging.tags import Tag
from packaging.utils import InvalidWheelFilename, canonicalize_name, parse_wheel_filename
from packaging.version import Version

from roslab.values.specifier import specifiers
from roslab.values.version import version_of

RequirementOrigin = Literal["manifest", "conda", "prose", "import", "build", "configuration", "table"]
"""Who asks: a file made for pip, a conda environment, an install line for humans or for another machine, the code, the
build, roslab.yaml, or a table of the program's own."""
Role = Literal[
    "environment",
    "",
    "editable",
    "repaired",
    "member",
    "source",
    "extra",
    "test",
    "python2",
    "conda",
    "project",
    "file",
    "option",
]
"""``""``: to be installed as it stands; ``editable``: from a URL, with ``-e``; ``repaired``: pip would refuse the way
its author spells it; ``member``, ``source``: uv has it in the same tree, or from elsewhere than the index; ``extra``,
``test``: only for those who ask for more; ``python2``: by Python 2's pip; ``conda``: by ``conda install``, or among
conda's own packages. ``project``, ``file``, ``environment`` and ``option`` name no package: a path to install, a
requirements file, a conda environment's file, an option of pip's."""
_NO_PACKAGE = frozenset({"project", "file", "option", "environment"})
_EXACT = frozenset({"==", "===", "~="})
_UPPER = frozenset({"<", "<="})
_EDITABLE = re.compile(r"^(?:-e|--editable)[ =]*(\S.*)$")
_PER_LINE = re.compile(r"\s+--(?:hash|global-option|install-option|config-settings)[ =]\S+")
_URL = re.compile(r"^(?:(?:git|hg|svn|bzr)\+\S+|https?://\S+|file:\S+|git://\S+|git@\S+)$")
_PATH = re.compile(r"[\w./-]+(?:\[.*\])?")
_NAME = re.compile(r"([A-Za-z0-9](?:[A-Za-z0-9._-]*[A-Za-z0-9])?)\s*(\[[\w\s,.-]*\])?\s*(.*)")
_VERSIONS = re.compile(r"\(?\s*(?:(?:===?|!=|~=|<=?|>=?)\s*[\w.*+!-]+\s*,?\s*)+\)?")
_EXPORTED = re.compile(r"=([\w.+!-]+?)(?:=[^=\s]+)?")
_CPYTHON = re.compile(r"cp(\d)(\d{1,2})")
_EGG = re.compile(r"[#&]egg=([\w.-]+)")
_LAST = re.compile(r"/([\w.-]+?)(?:\.git)?(?:@[^/]*)?(?:#.*)?$")
_FREE = SpecifierSet()


@dataclass(frozen=True, kw_only=True, slots=True)
class Requirement:
    """One thing that pip is asked for, with the place that asks."""

    name: str
    """As it is spelled; for a bare URL, what its end suggests; ``""`` if unknown."""
    written: str
    """As pip is given it, without its marker: ``PyYAML>=5``, ``name @ URL``, a bare URL, a path, an option."""
    specifier: SpecifierSet = _FREE
    """Empty if it is not pinned, or if the version follows no standard (then only ``written`` has it)."""
    extras: tuple[str, ...] = ()
    url: str = ""
    marker: Marker | None = None
    origin: RequirementOrigin
    role: Role = ""
    group: str = ""
    """The name of the extra, if the role is ``extra``."""
    file: str = ""
    line: int = 1

    @property
    def key(self) -> str:
        """Normalised name. https://peps.python.org/pep-0503/#normalized-names."""
        return canonicalize_name(self.name)

    @property
    def text(self) -> str:
        """The whole line as it is passed to pip, with its marker."""
        return f"{self.written}; {self.marker}" if self.marker else self.written

    @property
    def told(self) -> str:
        """The line for a report: without its marker, and with the name that a bare ``git+URL`` lacks."""
        return f"{self.key} @ {self.url}" if self.vcs and self.written == self.url and self.name else self.written

    @property
    def package(self) -> bool:
        """Whether it is a package rather than a path, a file or an option."""
        return self.role not in _NO_PACKAGE

    @property
    def vcs(self) -> bool:
        """Whether pip fetches it with git or the like."""
        return "+" in self.url.partition("://")[0]

    @property
    def wheel(self) -> Wheel | None:
        """The wheel that its URL names."""
        return _wheel(self.url) if self.url else None

    @property
    def release(self) -> str | None:
        """The release that it is pinned to, with its local part (``1.13.1+cu117``); ``None`` if it is not pinned."""
        if found := self.wheel:
            return str(found.version)
        exact = (each.version.rstrip(".*").lstrip("v") for each in self.specifier if each.operator in _EXACT)
        return next((text for text in exact if version_of(text)), None)

    @property
    def below(self) -> str | None:
        """The lowest upper bound of its specifiers."""
        uppers = [each.version for each in self.specifier if each.operator in _UPPER and version_of(each.version)]
        return min(uppers, key=Version, default=None)

    @property
    def at_least(self) -> str | None:
        """The highest of its ``>=``."""
        lowers = [each.version for each in self.specifier if each.operator == ">=" and version_of(each.version)]
        return max(lowers, key=Version, default=None)

    def only_if(self, condition: str) -> Requirement:
        """Return it with an additional marker; one that pip cannot read is ignored."""
        try:
            more = Marker(condition) if condition.strip() else None
        except InvalidMarker:
            more = None
        if more and self.marker:
            more = Marker(f"({self.marker}) and ({more})")
        return replace(self, marker=more or self.marker)

    def fetched_from(self, url: str) -> Requirement:
        """Return it with the URL that uv fetches it from."""
        return replace(self, written=f"{self.key} @ {url}", url=url, specifier=_FREE, role="source")

    @property
    def limited(self) -> bool:
        """Whether it excludes the newest version or names where it comes from."""
        return bool(self.url) or any(each.operator in _EXACT | _UPPER for each in self.specifier)


class Wheel(NamedTuple):
    """The parts of a wheel's file name."""

    name: str
    version: Version
    tags: frozenset[Tag]

    @property
    def python(self) -> str | None:
        """The only CPython that it is built for: ``3.8`` of ``cp38``."""
        found = {match[1] + "." + match[2] for tag in self.tags if (match := _CPYTHON.fullmatch(tag.interpreter))}
        return min(found) if len(found) == 1 else None

    @property
    def amd64_only(self) -> bool:
        """Whether it is built for Linux on amd64 alone."""
        return all(tag.platform.startswith(("linux", "manylinux")) and "x86_64" in tag.platform for tag in self.tags)


class _Read(NamedTuple):
    """A parsed line, without its place."""

    name: str
    written: str
    specifier: SpecifierSet = _FREE
    extras: tuple[str, ...] = ()
    url: str = ""
    marker: Marker | None = None
    role: Role = ""


def requirement(
    text: str,
    origin: RequirementOrigin,
    file: str = "",
    line: int = 1,
    *,
    role: Role = "",
    group: str = "",
    repair: bool = True,
) -> Requirement | None:
    """Parse one requirement as people write it; ``None`` if it names nothing that can be installed.

    What ``packaging`` cannot read is a bare URL, a path (role ``project``), or, with ``repair``, a spelling that pip
    refuses and whose meaning is plain (role ``repaired``).
    """
    read = _read(text.strip())
    if read is None or (read.role == "repaired" and not repair):
        return None
    return Requirement(
        name=read.name,
        written=read.written,
        specifier=read.specifier,
        extras=read.extras,
        url=read.url,
        marker=read.marker,
        origin=origin,
        role=read.role if read.role == "project" else role or read.role,
        group=group,
        file=file,
        line=line,
    )


def stated(
    text: str, origin: RequirementOrigin = "table", file: str = "", line: int = 1, *, role: Role = ""
) -> Requirement:
    """Parse a line that is known to be a requirement; what only pip understands stays in ``written``."""
    found = requirement(text, origin, file, line, role=role)
    return found or Requirement(name="", written=text, origin=origin, role=role, file=file, line=line)


@cache
def _read(text: str) -> _Read | None:
    """Parse a line: by the standard, else as a URL or a path, else after repairs."""
    editable = _EDITABLE.match(text)
    role: Role = "editable" if editable else ""
    text = _PER_LINE.sub("", editable[1] if editable else text).strip()
    if text[:1] in {'"', "'"} and text[-1:] == text[:1] and len(text) > 2:
        text, role = text[1:-1].strip(), role or "repaired"
    text = text.rstrip(",")
    try:
        parsed = None if role == "editable" and _PATH.fullmatch(text) else Parsed(text)
    except InvalidRequirement:
        parsed = None
    if parsed is not None and not (parsed.url or "").startswith("file:"):
        return _standard(parsed, text, role)
    requirement, marker, spelled = _marked(text)
    if _URL.match(requirement):
        return _Read(name=_named(requirement), written=requirement, url=requirement, marker=marker, role=role)
    if requirement.startswith((".", "/")) or (role == "editable" and _PATH.fullmatch(requirement)):
        return _Read(name="", written=requirement, marker=marker, role="project")
    found = _repaired(requirement)
    if found is None:
        return None
    return found._replace(marker=marker, role=found.role or role or ("" if spelled else "repaired"))


def _standard(parsed: Parsed, text: str, role: Role) -> _Read:
    """Return what ``packaging`` parsed, with the specifiers in the author's order."""
    extras = tuple(sorted(parsed.extras))
    if parsed.url:
        listed = f"[{','.join(extras)}]" if extras else ""
        written = f"{parsed.name}{listed} @ {parsed.url}"
    else:
        written = re.sub(r"[\s()]+", "", text.partition(";")[0])
    return _Read(parsed.name, written, parsed.specifier, extras, parsed.url or "", parsed.marker, role)


def _marked(text: str) -> tuple[str, Marker | None, bool]:
    """Split a line at its marker (a semicolon in a URL is no marker) and tell whether pip can read the marker."""
    before = text.partition(" ;")[0].strip()
    requirement, _, condition = text.partition(" ;" if _URL.match(before) else ";")
    try:
        return requirement.strip(), Marker(condition) if condition.strip() else None, True
    except InvalidMarker:
        return requirement.strip(), None, False


def _repaired(text: str) -> _Read | None:
    """Return the meaning of a spelling that follows no standard."""
    matched = _NAME.fullmatch(text)
    if matched is None:
        return None
    name, listed, rest = matched[1], (matched[2] or "").replace(" ", ""), matched[3].strip()
    extras = tuple(sorted(filter(None, listed.strip("[]").split(","))))
    if not rest:  # its marker was what pip cannot read
        return _Read(name, name + listed, extras=extras, role="repaired")
    if rest.startswith("@"):  # pip freeze in conda: a path of the author's machine
        return _Read(name, name + listed, extras=extras, role="repaired")
    if _VERSIONS.fullmatch(rest):
        allowed = specifiers(rest)
        written = re.sub(r"[\s()]+", "", rest) if allowed is None else str(allowed)
        return _Read(name, name + listed + written, allowed or _FREE, extras, role="repaired" if allowed else "")
    if exported := _EXPORTED.fullmatch(rest):  # conda list --export: name=version=build
        pinned = specifiers(f"=={exported[1]}")
        return _Read(name, f"{name}=={exported[1]}", pinned or _FREE, role="repaired")
    return None


def _named(url: str) -> str:
    """Return the package name in a bare URL: from its ``#egg=``, its wheel, or its last part."""
    if egg := _EGG.search(url):
        return egg[1]
    if wheel := _wheel(url):
        return wheel.name
    last = _LAST.search(url)
    return last[1] if last else ""


@cache
def _wheel(url: str) -> Wheel | None:
    file = unquote(url.partition("#")[0].partition("?")[0].rpartition("/")[2])
    if not file.endswith(".whl"):
        return None
    try:
        name, version, _, tags = parse_wheel_filename(file)
    except InvalidWheelFilename:
        return None
    return Wheel(name, version, tags)
