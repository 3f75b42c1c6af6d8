"""Shapes that several layers share: a RUN of several commands, a list of words over several lines."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from roslab.render import quote

JOBS = (
    """jobs="$(awk -v cores="$(nproc)" '/^MemAvailable/ {n = int($2 / 2000000); """
    """print (n < 1) ? 1 : (n > cores) ? cores : n}' /proc/meminfo)\""""
)
"""As many compilers as there are cores, but 2 GB of memory for each: a template-heavy file needs that much."""

REPORT = "/usr/local/share/roslab/left-out.txt"
"""Inside the image: what was guessed or named and could not be installed, one ``KIND NAME`` a line."""


def run(*commands: str, comment: str = "") -> str:
    """Return one RUN in which each command must succeed before the next."""
    body = " \\\n && ".join(commands)
    return f"{comment_lines(comment)}RUN {body}"


def comment_lines(text: str) -> str:
    """Return text as comment lines, ``""`` for none."""
    return "".join(f"# {line}\n" for line in text.splitlines())


def words(items: Iterable[str], *, indent: int = 6) -> str:
    """Return quoted words, one a line, ready to end a command inside a RUN."""
    pad = " " * indent
    return "".join(f" \\\n{pad}{quote.shell(item)}" for item in items)


def apt_install(packages: Sequence[str]) -> str:
    """Return a RUN that installs packages and leaves no package lists behind."""
    return run(
        "apt-get update",
        f"apt-get install --yes --no-install-recommends{words(packages)}",
        "rm -rf /var/lib/apt/lists/*",
    )


def heredoc(path: str, text: str, *, executable: bool = False) -> str:
    """Return a COPY of a small text file that stands in the Dockerfile itself."""
    mode = "--chmod=755 " if executable else ""
    # The blank line after its end is for hadolint, which reads no instruction right below one
    return f"COPY {mode}<<'ROSLAB' {path}\n{text.rstrip()}\nROSLAB\n"
