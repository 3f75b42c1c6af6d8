"""Reads a log from any source as plain lines: handles encodings, colours, progress bars and CI services' prefixes."""

from __future__ import annotations

import codecs
import re
from collections.abc import Callable, Iterator
from typing import IO, NamedTuple

from roslab.explain import prefixes, skim
from roslab.explain.skim import is_marked
from roslab.values.pattern import pattern

LONGEST = 2000
"""Most characters of a line that are kept: a progress bar or minified source code can be a line of millions."""
_new = tuple.__new__
"""Makes a ``Line`` in a third of the time, for logs of a million lines."""
_CHUNK = 1 << 20
BEGINNING = 3
"""Number of chunks at the beginning of a log of which every line is kept."""


class Line(NamedTuple):
    """One line of a log: its number, from 1, and its text without colours and without a service's prefix."""

    number: int
    text: str


_COLOUR = pattern(
    r"\x1b\[[0-?]{0,40}[ -/]{0,4}[@-~]"  # colours and cursor movements
    r"|\x1b\][^\x07\x1b]{0,300}(?:\x07|\x1b\\)"  # titles and links
    r"|\x1b[()][0-9A-Z]|\x1b[@-Z\\-_=>]"
    r"|\^\[\[[0-9;]{0,20}m"  # colours as `cat -v` shows them
)
_BARE_COLOUR = pattern(r"\[\d{1,3}(?:;\d{1,3}){0,4}m|\[m(?=\s|$|\[)", re.MULTILINE)
"""A colour whose escape character was lost when the log was saved."""


def _guess(data: bytes) -> str:
    """Return the probable encoding of a log, given its first bytes."""
    for mark, name in (
        (codecs.BOM_UTF8, "utf-8-sig"),
        (codecs.BOM_UTF32_LE, "utf-32"),
        (codecs.BOM_UTF16_LE, "utf-16"),
        (codecs.BOM_UTF16_BE, "utf-16"),
    ):
        if data.startswith(mark):
            return name
    if len(data) > 3 and data.count(0) > len(data) // 4:
        return "utf-16-le" if data[1:64:2].count(0) >= data[0:64:2].count(0) else "utf-16-be"
    return "utf-8"


def _as_windows(error: UnicodeError) -> tuple[str, int]:
    """Decode bytes that are not UTF-8 as Windows-1252, so that one such line does not affect the others."""
    if not isinstance(error, UnicodeDecodeError):
        raise error
    return error.object[error.start : error.end].decode("cp1252", errors="replace"), error.end


codecs.register_error("roslab-windows", _as_windows)


def lines(stream: IO[bytes]) -> Iterator[Line]:
    """Read a log line by line in bounded memory, whatever its encoding and however long its lines are.

    Of a log of tens of megabytes, unimportant lines far from any failure are left out: see ``skim``.
    """
    strip: Callable[[str], str] | None = None
    number = 0
    for text, quiet in skim.with_quiet(_chunks(stream), BEGINNING):
        if not number:
            strip = prefixes.stripper(text)
        plain = strip(text) if strip else text
        if quiet and (kept := skim.kept(plain)) is not None:
            for at, line in kept:
                yield from _lines(number + at, line)
            number += plain.count("\n")
            continue
        for part in plain.removesuffix("\n").split("\n"):
            number += 1
            if "\r" not in part and len(part) <= LONGEST:
                yield _new(Line, (number, part))
            else:
                yield from _lines(number, part)


def _chunks(stream: IO[bytes]) -> Iterator[str]:
    """Yield a log in texts of whole lines, without colours; a line of megabytes loses its middle."""
    left = ""
    for chunk in _decoded(stream):
        whole = left + chunk
        end = whole.rfind("\n") + 1
        left = whole[end:]
        if len(left) > 8 * LONGEST:
            left = left[: 4 * LONGEST] + left[-4 * LONGEST :]
        if end:
            yield _plain(whole[:end])
    if left:
        yield _plain(left)


def _decoded(stream: IO[bytes]) -> Iterator[str]:
    data = stream.read(_CHUNK)
    encoding = _guess(data[:4096])
    errors = "roslab-windows" if encoding.startswith("utf-8") else "replace"
    decoder = codecs.getincrementaldecoder(encoding)(errors)
    while data:
        yield decoder.decode(data)
        data = stream.read(_CHUNK)
    yield decoder.decode(b"", final=True)


def _plain(text: str) -> str:
    if "\x1b" in text or ("^" in text and "^[[" in text):
        return _COLOUR.sub("", text)
    return _BARE_COLOUR.sub("", text) if "[0m" in text or "[m" in text else text


def _lines(number: int, text: str) -> Iterator[Line]:
    """Yield a line; of a progress bar's states only the first, the last few and those that may matter."""
    if "\r" not in text.rstrip("\r"):
        yield Line(number, cut(text.rstrip("\r")))
        return
    parts = [part for part in text[-200_000:].split("\r") if part.strip()]
    keep = set(range(2)) | set(range(len(parts) - 4, len(parts)))
    parts = [part for at, part in enumerate(parts) if at in keep or (len(parts) < 2000 and is_marked(part))]
    for part in parts or [""]:
        yield Line(number, cut(part))


def cut(text: str) -> str:
    """Shorten a line that is too long to its beginning and its end, where a progress bar's line has the error."""
    return text if len(text) <= LONGEST else f"{text[: LONGEST - 600]} … {text[-597:]}"
