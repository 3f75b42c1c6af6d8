"""Reads a log from any source as plain lines: handles encodings, colours, progress bars and CI services' prefixes."""

from __future__ import annotations

import codecs
import re
from collections import Counter
from collections.abc import Callable, Iterator
from itertools import chain
from typing import IO, NamedTuple

LONGEST = 2000
"""Most characters of a line that are kept: a progress bar or minified source code can be a line of millions."""
_new = tuple.__new__
"""Makes a ``Line`` in a third of the time, for logs of a million lines."""
_CHUNK = 1 << 20
_SAMPLE = 400
"""Number of lines that are examined to find the prefix of all lines."""


class Line(NamedTuple):
    """One line of a log: its number, from 1, and its text without colours and without a service's prefix."""

    number: int
    text: str


_COLOUR = re.compile(
    r"\x1b\[[0-?]{0,40}[ -/]{0,4}[@-~]"  # colours and cursor movements
    r"|\x1b\][^\x07\x1b]{0,300}(?:\x07|\x1b\\)"  # titles and links
    r"|\x1b[()][0-9A-Z]|\x1b[@-Z\\-_=>]"
    r"|\^\[\[[0-9;]{0,20}m"  # colours as `cat -v` shows them
)
_BARE_COLOUR = re.compile(r"\[(?:\d{1,3}(?:;\d{1,3}){0,4})?m")
"""A colour whose escape character was lost when the log was saved."""
MARKS = (
    "rror", "ERR", "atal", "FATAL", "ailed", "ailure", "AIL", "ound", "No such", "annot", "an't", "nable", "ndefined",
    "ould not", "enied", "illed", "raceback", "xpired", "XPIRED", "404", "403", "equire", "E: ", "W: ", "nvalid",
    "issing", "xception", "bort", "nsupp", "efused", "timed", "no longer", "space",
)  # fmt: skip
"""Parts of words; every line that says why something failed has at least one of them."""


def is_marked(text: str) -> bool:
    """Return whether a line might say why something failed; a plain loop is fast enough for a million lines."""
    for mark in MARKS:  # noqa: SIM110 - `any` with a generator takes three times as long
        if mark in text:
            return True
    return False


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
    """Read a log line by line in bounded memory, whatever its encoding and however long its lines are."""
    yield from _without_prefixes(_split(_decoded(stream)))


def _decoded(stream: IO[bytes]) -> Iterator[str]:
    data = stream.read(_CHUNK)
    encoding = _guess(data[:4096])
    errors = "roslab-windows" if encoding.startswith("utf-8") else "replace"
    decoder = codecs.getincrementaldecoder(encoding)(errors)
    while data:
        yield decoder.decode(data)
        data = stream.read(_CHUNK)
    yield decoder.decode(b"", final=True)


def _split(chunks: Iterator[str]) -> Iterator[Line]:
    number, left = 0, ""
    for chunk in chunks:
        whole = left + chunk
        end = whole.rfind("\n") + 1
        left = whole[end:]
        if len(left) > 8 * LONGEST:
            left = left[: 4 * LONGEST] + left[-4 * LONGEST :]
        for part in _plain(whole[:end]).split("\n")[:-1]:
            number += 1
            if "\r" not in part and len(part) <= LONGEST:
                yield _new(Line, (number, part))
            else:
                yield from _line(number, part)
    if left:
        yield from _line(number + 1, _plain(left))


def _plain(text: str) -> str:
    if "\x1b" in text or "^[[" in text:
        return _COLOUR.sub("", text)
    return _BARE_COLOUR.sub("", text) if "[0m" in text or "[m" in text else text


def _line(number: int, text: str) -> Iterator[Line]:
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


_PREFIXES: dict[str, re.Pattern[str]] = {
    # gh run view --log: job, step and time, with tabs between; https://cli.github.com/manual/gh_run_view
    "gh": re.compile(r"[^\t\n]{1,200}\t[^\t\n]{1,200}\t\ufeff?\d{4}-\d\d-\d\dT[\d:.]{8,20}Z ?"),
    # GitHub's raw logs; GitLab's with the number of the stream: https://docs.gitlab.com/ci/jobs/job_logs/
    "time": re.compile(r"\ufeff?\d{4}-\d\d-\d\dT[\d:.]{8,20}Z (?:\d\d[OE][+ ]?)?"),
    # act: [workflow/job], and a bar before what a step printed
    "act": re.compile(r"\[[^\]\n]{1,200}\] {1,3}(?:\| ?)?"),
    # docker compose and Jenkins
    "clock": re.compile(r"\[?\d{4}-\d\d-\d\d[T ]\d\d:\d\d:\d\d(?:[.,]\d{1,9})?(?:Z|[+-]\d\d:?\d\d)?\]? "),
}


def _without_prefixes(log: Iterator[Line]) -> Iterator[Line]:
    first: list[Line] = []
    for line in log:
        first.append(line)
        if len(first) == _SAMPLE:
            break
    strip = _stripper(first)
    if strip is None:
        yield from first
        yield from log
        return
    for line in chain(first, log):
        yield Line(line.number, strip(line.text))


def _stripper(sample: list[Line]) -> Callable[[str], str] | None:
    """Return a function that removes the prefix that most lines of a sample have; ``None`` if they have none."""
    filled = [line.text for line in sample if line.text.strip()]
    votes = Counter(name for text in filled for name, prefix in _PREFIXES.items() if prefix.match(text))
    chosen = next((_PREFIXES[name] for name in _PREFIXES if filled and votes[name] > 0.6 * len(filled)), None)
    section = any("section_start:" in text for text in filled)
    if chosen is None and not section:
        return None

    def strip(text: str) -> str:
        if chosen is not None and (found := chosen.match(text)):
            text = text[found.end() :]
        if text.startswith(("section_start:", "section_end:")):
            text = re.sub(r"^section_(?:start|end):\d{1,12}:[\w.-]{1,100}(?:\[[^\]]{0,100}\])?\s?", "", text)
        return text

    return strip
