"""What a shell prints before a command that a page shows."""

from __future__ import annotations

from roslab.values.pattern import pattern

PROMPT = pattern(
    r"\s{0,40}(?:\([\w.-]{1,40}\)\s?)?"  # (venv)
    r"(?:[\w.-]{1,40}@[\w.-]{1,40}(?:[: ]\s*[~/][^\s$#%>]*)?\s?[$#%]"  # user@host:~/folder$
    r"|\[[\w.-]{1,40}@[\w.-]{1,40} [^\s\]]{1,80}\]\s?[$#]"  # [user@host folder]$
    r"|\[[\w./~-]{1,80}\]\s?\$"  # [folder]$
    r"|(?!\d)[\w.-]{1,40}(?::?[~/][\w./~-]{0,80})?\$(?=\s)"  # robot$
    r"|[\[(]?(?i:terminal|shell|tab|window) ?#?\d{1,2}[\])]? ?[$>:#]"  # [terminal 1]$
    r"|(?:\$ )?(?:\.\.|[A-Za-z]:)[/\\][\w./\\~-]{0,80}>(?=\s)"  # $ ../folder> and C:\\folder>
    r"|[~/][\w./~-]{0,80}\$|\$)"  # ~/folder$
    r"(?:\s+(?=\S)|\s*$)"
)
"""To be matched at the start of a line; what follows the match is the command."""

_USAGE = pattern(r"\s{0,40}Usage:\s{1,9}(?=\.{0,2}/|build/|python[\d.]{0,5}\s|ros(?:launch|run|2)\s)")
"""What a text about the usage of a program begins with, before how it is called."""


def typed(line: str) -> str:
    """Return what follows a shell's prompt or ``Usage:``, else the line, without the remark that is behind ``//``.

    What argparse prints begins with ``usage:``, and is no call.
    """
    match = PROMPT.match(line) or _USAGE.match(line)
    return (line[match.end() :] if match else line).partition(" // ")[0]
