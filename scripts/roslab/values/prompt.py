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


_LABEL = pattern(
    r"\s{0,40}(?:[\u2460-\u2473]|\uff08\d{1,2}\uff09|\d{1,2}\u3001"  # numbers in circles and wide brackets
    r"|[\u3040-\u30ff\u3400-\u9fff]{1,20} ?\d{0,2} ?[\uff1a:]"  # the word for a terminal, and its number
    r"|\u279c {1,3}(?:(?:~|[\w.-]{1,40}) git:\([^)\s]{1,60}\) (?:\u2717 )?|~ )?|\u276f )"  # oh-my-zsh, and Pure
    r"\s{0,9}(?=[a-z./~$])"
)
"""What stands before a command in the blocks of Chinese and Japanese pages, and prompts of zsh.

https://github.com/ohmyzsh/ohmyzsh/blob/master/themes/robbyrussell.zsh-theme, 2026-11-29
"""


def typed(line: str, *, block: bool = False) -> str:
    """Return what follows a shell's prompt or ``Usage:``, else the line, without the remark that is behind ``//``.

    What argparse prints begins with ``usage:``, and is no call. In a ``block`` of code a label may stand before it.
    """
    match = PROMPT.match(line) or _USAGE.match(line) or (_LABEL.match(line) if block and not line.isascii() else None)
    return (line[match.end() :] if match else line).partition(" // ")[0]
