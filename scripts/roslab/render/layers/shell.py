"""Shapes that several layers share: a RUN of several commands, a list of words over several lines."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from roslab.render import quote
from roslab.render.layers.secrets import AGAIN, NONE, Secrets
from roslab.values.dataclass import dataclass

JOBS = '"$(compile-jobs)"'
"""As many compilers as there are cores, but 2 GB of memory for each: a template-heavy file needs that much."""
_LOGS = "/var/log/{apt/[!h]*,alternatives.log,dpkg.log}"
FORGET = (
    f"rm -rf /var/cache/{{apt/*.bin,ldconfig/aux-cache}} {_LOGS}",
    "find /var/log/apt -name history.log -exec sed --in-place '/-Date: /d' {} +",
)
"""End a step of apt: what holds the time of the build or the machine's inodes goes. apt's record of what each call
installed stays, without its times: ``roslab lock`` reads it. The lists are in a mount, and so in no layer."""
SET_JOBS = f"jobs={JOBS}"
CHECKOUT = "checkout-branch"
"""The script that checks out a branch which may be gone."""
COMMIT = "checkout-commit"
"""The script that checks out a recorded commit which may be gone."""
SUBMODULES = "fetch-submodules"
"""The script that fetches the submodules of a clone, as far as they can be had."""
PATCH = "apply-patch"
"""The script that applies a patch of the repository to a clone."""
AGAIN_TABLES = ("build-limits.txt", "build-programs.txt")
"""What the script that calls pip again knows."""
_PRINTING = ("compile-jobs", "index-as-of", "pip-cache")
"""Scripts that print what a command says with it."""
_ASKING_AGAIN = ("install-cloned-files", "install-optional-pip", "install-python-clones")
"""Scripts that read the one which calls pip again, or call one that does."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Around:
    """What a RUN needs around its commands, such as pins that hold for this RUN alone."""

    before: str = ""
    """Instructions above it, each with its line's end."""
    first: tuple[str, ...] = ()
    last: tuple[str, ...] = ()

    def __add__(self, other: Around) -> Around:
        return Around(
            before=self.before + other.before, first=(*self.first, *other.first), last=(*other.last, *self.last)
        )


NOTHING = Around()


def jobs(most: int | None) -> str:
    """Return the number of compilers, which the author may have limited."""
    return JOBS.replace("compile-jobs", f"compile-jobs {most}") if most else JOBS


def run(*commands: str, comment: str = "", secrets: Secrets = NONE, around: Around = NOTHING) -> str:
    """Return one RUN in which each command must succeed before the next, with the secrets that it may read."""
    body = "".join(f"{mount} \\\n    " for mount in secrets.mounts)
    body += " \\\n && ".join((*secrets.commands, *around.first, *commands, *around.last))
    said = "\n".join((*secrets.commands, *around.first, *commands))
    scripts = "".join(copy_script(name) for name in _PRINTING if f'"$({name}' in said)
    of_day = "--or-today" in said
    if of_day or f"source {AGAIN}" in said or any(f"{name} " in said for name in _ASKING_AGAIN):
        tables = ("released-together.txt", *AGAIN_TABLES) if of_day else AGAIN_TABLES
        scripts += copy_script(AGAIN) + copy_data(tables)
    scripts += "".join(copy_script(name) for name in (CHECKOUT, COMMIT, SUBMODULES, PATCH) if f"{name} " in said)
    return f"{comment_lines(comment)}{scripts}{around.before}RUN {body}"


def call(
    script: str,
    arguments: str = "",
    *,
    comment: str,
    before: str = "",
    secrets: Secrets = NONE,
    around: Around = NOTHING,
) -> str:
    """Return a RUN of a script that the Dockerfile carries.

    ``arguments`` are quoted, each after a space; ``before`` are instructions that it needs, each with its line's end.
    """
    called = run(f"{script}{arguments}", secrets=secrets, around=around)
    return f"{comment_lines(comment)}{copy_script(script)}{before}{called}"


def copy_script(name: str) -> str:
    """Return the line that brings a script into a stage."""
    return f"COPY --from=scripts /{name} /usr/local/bin/\n"


def copy_data(names: Iterable[str]) -> str:
    """Return the line that brings keys and tables that scripts read into a stage, ``""`` for none."""
    files = " ".join(f"/{name}" for name in names)
    return f"COPY --from=scripts {files} /usr/local/share/roslab/\n" if files else ""


def comment_lines(text: str) -> str:
    """Return text as comment lines, ``""`` for none."""
    return "".join(f"# {line}\n" for line in text.splitlines())


def words(items: Iterable[str]) -> str:
    """Return quoted words ready to end a command inside a RUN: one on the command's line, several on a line each."""
    quoted = [quote.shell(item) for item in items]
    between = " " if len(quoted) == 1 else " \\\n      "
    return "".join(between + word for word in quoted)


def apt_install(packages: Sequence[str], secrets: Secrets = NONE, around: Around = NOTHING) -> str:
    """Return a RUN that installs packages and leaves no times behind.

    To apt a name with a plus that it does not have is a pattern, and ``g++-14`` is found in ``clang-14``.
    """
    exact = " -oAPT::Cmd::Pattern-Only=true" if any("+" in name for name in packages) else ""
    return run(
        "apt-get update",
        f"apt-get install{exact} --yes --no-install-recommends{words(packages)}",
        *FORGET,
        secrets=secrets,
        around=around,
    )


def heredoc(path: str, text: str, *, executable: bool = False) -> str:
    """Return a COPY of a small text file that stands in the Dockerfile itself."""
    mode = "--chmod=755 " if executable else ""
    # The blank line after its end is for hadolint, which reads no instruction right below one
    return f"COPY {mode}<<'EOF' {path}\n{text.rstrip()}\nEOF\n"
