"""Lines of a page that a program printed as a list: files with their modes (``ls -l``, dive), layers of an image.

Their columns cut commands off and put sizes and names of folders behind them.
https://www.gnu.org/software/coreutils/manual/html_node/What-information-is-listed.html and
https://docs.docker.com/reference/cli/docker/image/history/, 2026-11-26.
"""

from __future__ import annotations

import re

from roslab.values.pattern import pattern

MODE = r"(?!-{10})[bcdlps-](?:[r-][w-][xsStT-]){3}[.+]?"
"""Type and permissions of a file: ``drwxr-xr-x``. Ten dashes underline a title or head a table."""
_LISTED = pattern(
    rf"^(?:[^\n]{{0,300}}(?<!\S){MODE}(?!\S)|[ \t]*(?:<missing>|[0-9a-f]{{12}})[ \t]+(?:\d+|an?|about an?) \w+ ago\b)"
    r"[^\n]*$",
    re.MULTILINE,
)


def without_listings(page: str) -> str:
    """Return a page with such lines empty, so that its other lines keep their numbers."""
    return _LISTED.sub("", page) if "rw" in page or "r-x" in page or "<missing>" in page else page
