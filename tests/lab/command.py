"""Run a command of the machine, keep what it said, and say it when it failed."""

from __future__ import annotations

import os
import subprocess
from collections.abc import Mapping, Sequence
from pathlib import Path

from .home import folder


class LabError(Exception):
    """The lab cannot do a step; the text says which, why, and where the log lies."""


def run(
    argv: Sequence[str | Path],
    *,
    log: str = "",
    cwd: Path | None = None,
    env: Mapping[str, str] | None = None,
    stdin: str | None = None,
    timeout: float | None = None,
) -> str:
    """Run a command and return its standard output.

    `log` names a file in the lab's log folder that gets all it says (for the long ones); `env` is added to ours.
    Raises LabError with the last lines when it fails, is absent or takes too long.
    """
    words = [str(word) for word in argv]
    environment = {**os.environ, **env} if env else None
    try:
        if log:
            path = folder("log") / f"{log}.log"
            with path.open("w") as handle:
                print("$", *words, file=handle, flush=True)
                done = subprocess.run(
                    words, cwd=cwd, env=environment, input=stdin, text=True,
                    stdout=handle, stderr=subprocess.STDOUT, timeout=timeout, check=False,
                )  # fmt: skip
            said = path.read_text(errors="replace")
        else:
            done = subprocess.run(
                words, cwd=cwd, env=environment, input=stdin, text=True,
                capture_output=True, timeout=timeout, check=False,
            )  # fmt: skip
            said = done.stdout + done.stderr
    except FileNotFoundError as error:
        raise LabError(f"{words[0]}: not installed on this machine ({error})") from error
    except subprocess.TimeoutExpired as error:
        raise LabError(f"{' '.join(words)}: no end after {timeout} s") from error
    if done.returncode:
        tail = "\n".join("    " + line for line in said.splitlines()[-15:])
        where = f" (all of it: {folder('log') / log}.log)" if log else ""
        raise LabError(f"{' '.join(words)}: exit code {done.returncode}{where}\n{tail}")
    return said if log else done.stdout


def succeeds(argv: Sequence[str | Path], *, env: Mapping[str, str] | None = None, timeout: float = 60) -> bool:
    """Tell whether a command ends with code 0 in time; an absent command does not."""
    try:
        run(argv, env=env, timeout=timeout)
    except LabError:
        return False
    return True
