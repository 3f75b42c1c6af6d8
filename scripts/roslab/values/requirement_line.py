"""Reads one requirement line as people write it, by the standard first, then as a URL or a path, then after repairs."""

from __future__ import annotations

import re
from functools import cache, partial
from typing import TYPE_CHECKING

from roslab.values.dataclass import replace
from roslab.values.pattern import pattern
from roslab.values.requirement import FREE, Requirement, RequirementOrigin, Role
from roslab.values.specifier import PLAIN, specifiers

if TYPE_CHECKING:
    from packaging.markers import Marker
    from packaging.requirements import Requirement as Parsed

_IDENTIFIER = r"[A-Za-z0-9](?:[A-Za-z0-9._-]*[A-Za-z0-9])?"
_PLAIN = pattern(rf"({_IDENTIFIER})\s*(?:\[\s*({_IDENTIFIER}(?:\s*,\s*{_IDENTIFIER})*)\s*\])?\s*({PLAIN})")
"""A line as most are, which everybody reads alike: no address, no marker, numbers alone."""
_EDITABLE = pattern(r"^(?:-e|--editable)[ =]*(\S.*)$")
_PER_LINE = pattern(r"\s+--(?:hash|global-option|install-option|config-settings)[ =]\S+")
_URL = pattern(r"^(?:(?:git|hg|svn|bzr)\+\S+|https?://\S+|file:\S+|git://\S+|git@\S+)$")
_CLONE = pattern(
    r"https?://[\w.-]+(?:/[\w.-]+){2,6}\.git(?:[@#]\S*)?|https?://(?:www\.)?git(?:hub|lab)\.com(?:/[\w.-]+){2}/?"
)
"""The address of a repository, which pip takes for that of an archive and refuses: it was meant to be cloned."""
_PATH = pattern(r"[\w./-]+(?:\[.*\])?")
_NAME = pattern(r"([A-Za-z0-9](?:[A-Za-z0-9._-]*[A-Za-z0-9])?)\s*(\[[\w\s,.-]*\])?\s*(.*)")
_VERSIONS = pattern(r"\(?\s*(?:(?:===?|!=|~=|<=?|>=?)\s*[\w.*+!-]+\s*,?\s*)+\)?")
_EITHER = pattern(r"(==\s*\d[\w.]*)\s*(?:/|\bor\b)\s*(?:==\s*)?\d[\w.]*")
"""Two versions that were used, as prose has them: the first one is taken."""
_EXPORTED = pattern(r"=([\w.+!-]+?)(?:=[^=\s]+)?")
_SLIP = pattern(r"([=<>~!:\s-]*)v?(\d[\w.*+!]*?)\.?")
"""A version with signs in another order, too few or too many of them, or a last full stop."""
_EGG = pattern(r"[#&]egg=([\w.-]+)")
_LAST = pattern(r"/([\w.-]+?)(?:\.git(?:@.*)?|@[^/]*)?/?$")
_BLANKS = pattern(r"\s+")
_NOWHERE = partial(Requirement, origin="table")
"""A requirement before its place and origin are known."""


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
    role = read.role if read.role == "project" else role or read.role
    return replace(read, origin=origin, role=role, group=group, file=file, line=line)


def stated(
    text: str, origin: RequirementOrigin = "table", file: str = "", line: int = 1, *, role: Role = ""
) -> Requirement:
    """Parse a line that is known to be a requirement; what only pip understands stays in ``written``."""
    found = requirement(text, origin, file, line, role=role)
    return found or Requirement(name="", written=text, origin=origin, role=role, file=file, line=line)


@cache
def _read(text: str) -> Requirement | None:
    """Parse a line without its place: by the standard, else as a URL or a path, else after repairs."""
    if plain := _PLAIN.fullmatch(text):
        extras = tuple(sorted({each.strip() for each in (plain[2] or "").split(",")} - {""}))
        written, allowed = _BLANKS.sub("", text), specifiers(plain[3])
        return _NOWHERE(name=plain[1], written=written, specifier=allowed or FREE, extras=extras)
    editable = _EDITABLE.match(text)
    role: Role = "editable" if editable else ""
    text = _PER_LINE.sub("", editable[1] if editable else text).strip()
    if text[:1] in {'"', "'"} and text[-1:] == text[:1] and len(text) > 2:
        text, role = text[1:-1].strip(), role or "repaired"
    text = text.rstrip(",")
    parsed = None if role == "editable" and _PATH.fullmatch(text) else _parsed(text)
    if parsed is not None and not (parsed.url or "").startswith("file:"):
        return _standard(parsed, text, role)
    requirement, marker, spelled = _marked(text)
    if _CLONE.fullmatch(requirement):
        requirement, role = f"git+{requirement}", role or "repaired"
    if _URL.match(requirement):
        return _NOWHERE(name=_named(requirement), written=requirement, url=requirement, marker=marker, role=role)
    if requirement.startswith((".", "/")) or (role == "editable" and _PATH.fullmatch(requirement)):
        return _NOWHERE(name="", written=requirement, marker=marker, role="project")
    found = _repaired(requirement)
    if found is None:
        return None
    return replace(found, marker=marker, role=found.role or role or ("" if spelled else "repaired"))


def _parsed(text: str) -> Parsed | None:
    """Return what ``packaging`` reads, ``None`` for what it cannot: addresses and paths alone are told at once."""
    address = _URL.match(text) and ";" not in text and not text.startswith("git@")
    if address or text.startswith((".", "/")):
        return None
    from roslab.values.standard_requirement import InvalidRequirement  # noqa: PLC0415 - slow to import
    from roslab.values.standard_requirement import Requirement as Parsed  # noqa: PLC0415

    try:
        return Parsed(text)
    except InvalidRequirement:
        return None


def _standard(parsed: Parsed, text: str, role: Role) -> Requirement:
    """Return what ``packaging`` parsed, with the specifiers in the author's order."""
    extras = tuple(sorted(parsed.extras))
    if parsed.url:
        listed = f"[{','.join(extras)}]" if extras else ""
        written = f"{parsed.name}{listed} @ {parsed.url}"
    else:
        written = re.sub(r"[\s()]+", "", text.partition(";")[0])
    return _NOWHERE(
        name=parsed.name,
        written=written,
        specifier=parsed.specifier,
        extras=extras,
        url=parsed.url or "",
        marker=parsed.marker,
        role=role,
    )


def _marked(text: str) -> tuple[str, Marker | None, bool]:
    """Split a line at its marker (a semicolon in a URL is no marker) and tell whether pip can read the marker."""
    before = text.partition(" ;")[0].strip()
    requirement, _, condition = text.partition(" ;" if _URL.match(before) else ";")
    if not condition.strip():
        return requirement.strip(), None, True
    from roslab.values.standard_requirement import InvalidMarker, Marker  # noqa: PLC0415 - slow to import

    try:
        return requirement.strip(), Marker(condition), True
    except InvalidMarker:
        return requirement.strip(), None, False


def _repaired(text: str) -> Requirement | None:
    """Return the meaning of a spelling that follows no standard."""
    matched = _NAME.fullmatch(text)
    if matched is None:
        return None
    name, listed, rest = matched[1], (matched[2] or "").replace(" ", ""), matched[3].strip()
    extras = tuple(sorted(filter(None, listed.strip("[]").split(","))))
    if not rest or rest.startswith("@"):  # its marker was what pip cannot read, or conda's path of the author's machine
        return _NOWHERE(name=name, written=name + listed, extras=extras, role="repaired")
    if either := _EITHER.fullmatch(rest):
        rest = either[1]
    if slip := _slip(rest):
        return _NOWHERE(
            name=name, written=name + listed + slip, specifier=specifiers(slip) or FREE, extras=extras, role="repaired"
        )
    if _VERSIONS.fullmatch(rest):
        allowed = specifiers(rest)
        written = re.sub(r"[\s()]+", "", rest) if allowed is None else str(allowed)
        role: Role = "repaired" if allowed else ""
        return _NOWHERE(name=name, written=name + listed + written, specifier=allowed or FREE, extras=extras, role=role)
    if exported := _EXPORTED.fullmatch(rest):  # conda list --export: name=version=build
        pinned = specifiers(f"=={exported[1]}")
        written = f"{name}=={exported[1]}" if pinned else name + listed
        return _NOWHERE(name=name, written=written, specifier=pinned or FREE, extras=extras, role="repaired")
    return None


def _slip(text: str) -> str:
    """Return the versions that are meant where signs slipped (``=>1.2``, ``=-7.0``, ``1.2``), ``""`` of any other text.

    A number alone may be a word of a sentence.
    """
    meant = []
    for part in text.split(","):
        found = _SLIP.fullmatch(part.strip())
        signs = re.sub(r"[\s:-]", "", found[1]) if found else ""
        if found is None or not (signs or "." in found[2]) or ({"<", ">"} <= {*signs}):
            return ""
        compares = next((sign for sign in "><~!" if sign in signs), "=")
        operator = compares if compares in "<>" and "=" not in signs else "==" if compares == "=" else f"{compares}="
        meant.append(f"{operator}{found[2]}")
    written = ",".join(meant)
    return written if specifiers(written) and written != re.sub(r"\s", "", text) else ""


def _named(url: str) -> str:
    """Return the package name in a bare URL: from its ``#egg=``, its wheel, or its last part."""
    from roslab.values.wheel import wheel_of  # noqa: PLC0415 - few addresses are those of wheels

    if egg := _EGG.search(url):
        return egg[1]
    if wheel := wheel_of(url):
        return wheel.name
    last = _LAST.search(url.partition("#")[0])
    return last[1] if last else ""
