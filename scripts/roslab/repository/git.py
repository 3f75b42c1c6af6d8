"""The commit of a checkout, read by git without running what the repository's own configuration could name."""

from __future__ import annotations

import os
import re
import subprocess
from pathlib import Path

SECONDS = 30.0
"""How long git may take: it reads one object."""
_SETTINGS = ("log.showSignature=false", "core.fsmonitor=false")
_ENVIRONMENT = {"GIT_ALLOW_PROTOCOL": "none", "GIT_NO_LAZY_FETCH": "1", "GIT_TERMINAL_PROMPT": "0"}
"""An object that is not there is fetched from nowhere. https://git-scm.com/docs/git#_environment_variables"""


def head(root: Path) -> tuple[str, int | None]:
    """Return the commit of a checkout and its time in seconds since 1970, ``("", None)`` where there is none."""
    settings = [word for setting in (f"safe.directory={root}", *_SETTINGS) for word in ("-c", setting)]
    command = ["git", "--no-pager", "-C", str(root), *settings, "log", "-1", "--format=%H %ct"]
    try:
        answer = subprocess.run(
            command,
            capture_output=True,
            stdin=subprocess.DEVNULL,
            env={**os.environ, **_ENVIRONMENT},
            text=True,
            errors="replace",
            timeout=SECONDS,
            check=False,
        )
    except (OSError, subprocess.TimeoutExpired):  # no git on this machine
        return "", None
    match = re.fullmatch(r"([0-9a-f]{40,64}) (\d+)", answer.stdout.strip())
    return (match[1], int(match[2])) if match else ("", None)
