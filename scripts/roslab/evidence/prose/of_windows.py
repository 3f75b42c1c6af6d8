r"""Calls of Python that a page writes as Windows has them, ``.venv\Scripts\python.exe .\src\main.py``, as a shell does.

https://docs.python.org/3/using/windows.html#launcher, read 2026-11-28: ``py`` starts Python there.
"""

from __future__ import annotations

import posixpath
import re

from roslab.repository.checkout import File, Repository
from roslab.values.pattern import pattern

_CALL = pattern(
    r"(?:^[ \t]*(?:\(\w[\w.-]{0,40}\)[ \t]*)?(?:PS[ \t]+)?[A-Za-z]:\\[^>\n]{0,120}>[ \t]*)?"
    r"(?<![\w./\\:*-])(?P<python>(?:\.\\)?(?:[\w.-]{1,40}\\){0,3}python(?:3[\d.]{0,4})?(?:\.exe)?|py(?:\.exe)?)"
    r"(?P<options>(?:[ \t]+-[uBW3][\d.]{0,4}){0,3})[ \t]+"
    r"(?P<what>(?P<script>[\w.\\/-]{1,200}\.py)|-m[ \t]+[\w.]{1,100})(?![\w.\\/-])"
    r"(?P<rest>(?:[^\n`]|(?<=[ \t])`[ \t]*\n){0,800})",
    re.MULTILINE,
)
_CONTINUED = pattern(r"`[ \t]*\n")
"""How a line goes on in PowerShell: https://learn.microsoft.com/powershell/module/microsoft.powershell.core/about/about_parsing."""
_PATH = pattern(r"(?<![\w./\\:-])(?:\.\\)?[\w.-]{1,80}(?:\\[\w.-]{1,80}){0,9}\\?(?=[\s\"'`]|$)")
"""A word of a call that may be a path."""
_RELEASE = pattern(r"[ \t]+-3[\d.]*")
"""What the launcher alone understands: the release that is meant."""


def as_in_a_shell(text: str, repository: Repository, page: File) -> str:
    """Return a page with each call of Python in Windows' way as a shell has it, where its program is in the tree."""
    if not ("\\" in text or ".exe" in text or "py " in text):
        return text

    def called(match: re.Match[str]) -> str:
        python, what, script = match["python"], match["what"], match["script"]
        prompt = match[0][: match.start("python") - match.start()]
        windows = "\\" in f"{prompt}{python}{what}" or python.endswith(".exe") or python == "py"
        if not windows or (script and not _there(_path(script), repository, page)):
            return match[0]
        options = _RELEASE.sub("", match["options"])
        rest = _PATH.sub(lambda word: _path(word[0]) if "\\" in word[0] else word[0], match["rest"])
        return f"python{options} {_path(script) if script else what}{_CONTINUED.sub(lambda _: chr(92) + chr(10), rest)}"

    return _CALL.sub(called, text)


def _path(written: str) -> str:
    return written.replace("\\", "/").removeprefix("./")


def _there(path: str, repository: Repository, page: File) -> bool:
    """Tell whether a program is in the tree, from its root, from the page, or from a folder that the page goes to."""
    if repository.has(posixpath.normpath(path)) or repository.has(
        posixpath.normpath(posixpath.join(page.folder, path))
    ):
        return True
    end = f"/{posixpath.normpath(path)}"
    return any(file.path.endswith(end) for file in repository.named(posixpath.basename(path)))
