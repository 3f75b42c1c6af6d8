"""Removes what CI services write before each line of a log."""

from __future__ import annotations

import codecs
import re
from collections import Counter
from collections.abc import Callable

from roslab.values.pattern import pattern

_SAMPLE = 400
"""Number of lines that are examined to find the prefix of all lines."""
_PREFIXES: dict[str, re.Pattern[str]] = {
    # gh run view --log: job, step and time, with tabs between; https://cli.github.com/manual/gh_run_view
    "gh": pattern(r"[^\t\n]{1,200}\t[^\t\n]{1,200}\t\ufeff?\d{4}-\d\d-\d\dT[\d:.]{8,20}Z ?"),
    # GitHub's raw logs; GitLab's with the number of the stream: https://docs.gitlab.com/ci/jobs/job_logs/
    "time": pattern(r"\ufeff?\d{4}-\d\d-\d\dT[\d:.]{8,20}Z (?:\d\d[OE][+ ]?)?"),
    # a part of what BuildKit repeats: the seconds that each line took
    "seconds": pattern(r"\d{1,5}\.\d{2,3}(?: |$)"),
    # docker compose: the service and a bar
    "compose": pattern(r"[a-zA-Z][\w.-]{0,60} {1,40}\| "),
    # docker compose and Jenkins
    "clock": pattern(r"\[?\d{4}-\d\d-\d\d[T ]\d\d:\d\d:\d\d(?:[.,]\d{1,9})?(?:Z|[+-]\d\d:?\d\d)?\]? "),
    # Jenkins's plugin for times, as build.ros.org has it
    "hour": pattern(r"\d\d:\d\d:\d\d(?:[.,]\d{1,6})? {1,2}"),
    # the client of docker for Python, under its logger
    "logging": pattern(r"(?:DEBUG|INFO|WARNING|ERROR):[A-Za-z][\w. -]{0,60}:"),
    # a log that was quoted in an issue or a mail
    "quote": pattern(r"> ?"),
    # what a step printed under act, without act's own words
    "bar": pattern(r"\| "),
    # act: [workflow/job], and a bar before what a step printed; a clock in brackets would be taken for it
    "act": pattern(r"\[[^\]\n]{1,200}\] {1,3}(?:\| ?)?"),
}
_OF_COLUMN_0 = pattern(
    r"#\d{1,6} \S|-- \w|CMake (?:Error|Warning)|g?make(?:\[\d{1,3}\])?: |\[ {0,2}\d{1,3}%\] "
    r"|(?:Starting|Finished|Failed|Aborted|Errors|Abandoned) {1,8}(?:>>>|<<<?) |--- (?:stderr|output): |Traceback \("
    r"|E: |/\S{1,300}:\d{1,6}:\d{1,5}: (?:fatal )?error: "
)
"""What begins a line, where nothing indents it."""
_NODE = pattern(r"^\[[\w.+-]{1,100}-\d{1,4}\] ", re.MULTILINE)
"""What launch of ROS 2 writes before each line of a node; it says when it starts one."""
_STARTED = "]: process started with pid ["
_EVENT = pattern(
    r"^(?:\[\d{1,9}\.\d{1,9}\] )?\([\w.-]{1,100}\) Std(?:err|out)Line: \{'line': b(['\"])(.{0,4000})\\n\1\}$",
    re.MULTILINE,
)
_OF_EVENT = "Line: {'line': b"
"""colcon's events.log has each line that a package printed as bytes of Python:
https://colcon.readthedocs.io/en/released/user/log-files.html"""
_TAG = pattern(r"</?(?:b|i|u|font|span|code|pre|strong)(?: [^<>\n]{0,100})?>")
_OF_HTML = ("</b>", "</font>", "</span>", "&gt;&gt;&gt; ", "&lt;&lt;&lt; ")
"""What a terminal's text has where it was copied as HTML."""
_SIGNS = (("&lt;", "<"), ("&gt;", ">"), ("&quot;", '"'), ("&#39;", "'"), ("&nbsp;", " "), ("&amp;", "&"))
_SECTION = pattern(r"^section_(?:start|end):\d{1,12}:[\w.-]{1,100}(?:\[[^\]\n]{0,100}\])?\s?", re.MULTILINE)


def stripper(text: str) -> Callable[[str], str] | None:
    """Return a function that removes the prefix that most lines of a text have; ``None`` if they have none."""
    filled = [line for line in text.split("\n", _SAMPLE)[:_SAMPLE] if line.strip()]
    votes = Counter(name for line in filled for name, prefix in _PREFIXES.items() if prefix.match(line))
    chosen = next((_PREFIXES[name] for name in _PREFIXES if votes[name] > 0.6 * len(filled)), None) or _indent(filled)
    section = any("section_start:" in line for line in filled)
    launched = _STARTED in text
    events = _OF_EVENT in text
    copied = any(sign in text for sign in _OF_HTML)
    if chosen is None and not section and not launched and not events and not copied:
        return None
    prefix = re.compile(f"^(?:{chosen.pattern})", re.MULTILINE) if chosen is not None else None

    def strip(text: str) -> str:
        text = _without_html(text) if copied else text
        plain = prefix.sub("", text) if prefix is not None else text
        plain = _NODE.sub("", plain) if launched else plain
        plain = _EVENT.sub(_printed, plain) if events else plain
        return _SECTION.sub("", plain) if "section_" in plain else plain

    return strip


def _indent(lines: list[str]) -> re.Pattern[str] | None:
    """Return the blanks before all lines, where some of them begin at the left: a page or a CI indents them."""
    width = min((len(line) - len(line.lstrip(" \t")) for line in lines), default=0)
    if not width or not any(_OF_COLUMN_0.match(line, width) for line in lines):
        return None
    return re.compile(rf"[ \t]{{{width}}}")


def _without_html(text: str) -> str:
    plain = _TAG.sub("", text)
    for name, sign in _SIGNS:
        plain = plain.replace(name, sign)
    return plain


def _printed(event: re.Match[str]) -> str:
    """Return the line of an event, whose bytes are written as those of Python; as it is where they are cut."""
    said = event[2].encode("latin-1", errors="replace")
    try:
        return codecs.escape_decode(said)[0].decode("utf-8", errors="replace") if b"\\" in said else event[2]
    except ValueError:
        return event[2]
