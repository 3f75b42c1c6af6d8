"""The arguments of the ``roslab`` command: every command and option with its help."""

from __future__ import annotations

import argparse
import os
import sys
from collections.abc import Callable, Sequence
from typing import TypeAlias

from roslab import __version__
from roslab.cli import argument_values as values

EXIT_CODES = """\
exit codes:
  0  done
  2  wrong arguments or a wrong roslab.yaml
  3  nothing to build was found
  4  refused for safety: a file of yours would be overwritten, a link leads out of the tree
  5  the engine, the registry, the build or the image failed
  1  a bug of roslab's own
  130  interrupted (Ctrl-C)
"""
OVERRIDING = {"--name": "name", "--date": "date", "--platform": "platforms", "--command": "command", "--test": "test"}
"""Options that set a key of roslab.yaml, and that key, which is also the name of the parsed option."""
_HELP = {
    "--name": ("NAME", "the image's name (default: roslab.yaml's, else the repository's)"),
    "--date": ("DAY", "the image of a day, YEAR-MONTH-DAY, or paper: the newest commit's; it wins over roslab.yaml's"),
    "--platform": ("LIST", "platforms to build for, such as linux/amd64,linux/arm64; they win over roslab.yaml's"),
    "--command": ("TEXT", "default command of the image, run by bash; it wins over roslab.yaml's"),
    "--test": ("TEXT", "command that proves the image, run by bash; it wins over roslab.yaml's"),
}
argparse._ = lambda word: word  # type: ignore[attr-defined]  # English as ours: to look for others imports ``locale``
ROUNDS = 5
"""Repairs of one build unless told otherwise."""
Commands: TypeAlias = "argparse._SubParsersAction[argparse.ArgumentParser]"


class _Help(argparse.RawDescriptionHelpFormatter):
    """Help as wide as the terminal.

    The parser makes one for each argument that it is given, and without a width ``shutil`` would be imported for it.
    """

    def __init__(self, prog: str, width: int | None = None) -> None:
        super().__init__(prog, width=width or _columns() - 2)


def _columns() -> int:
    """Return the columns of the terminal as ``shutil.get_terminal_size`` does."""
    said = os.environ.get("COLUMNS", "")
    if said.isdecimal() and int(said):
        return int(said)
    try:
        return (os.get_terminal_size(sys.__stdout__.fileno()).columns if sys.__stdout__ else 0) or 80
    except (ValueError, OSError):  # closed, or no terminal
        return 80


def parser(command: str | None = None) -> argparse.ArgumentParser:
    """Return the whole command line, or what ``command`` alone needs of it.

    ``github``, the steps of a workflow, is for workflows: no help shows it.
    """
    top = argparse.ArgumentParser(
        prog="roslab",
        description="Work out, build and run a container image for a robotics repository.",
        epilog=EXIT_CODES,
        formatter_class=_Help,
    )
    top.add_argument("--version", action="version", version=f"roslab {__version__}", help="print the version and exit")
    # Whether one is given is looked at after the parsing: argparse would miss the command before a mistyped option
    commands = top.add_subparsers(title="commands", metavar="COMMAND")
    if command == "github":
        from roslab.github.commands import add_parser  # noqa: PLC0415

        add_parser(commands)
        return top
    for name, add in _COMMANDS.items():
        if command == name or command not in _COMMANDS:
            add(commands)
    return top


def _inspect(commands: Commands) -> None:
    inspect = _command(commands, "inspect", "Show what was found in a repository and what follows from it.")
    _repository(inspect, *OVERRIDING)
    _format(inspect)
    inspect.add_argument(
        "--explain",
        metavar="QUESTION",
        help="show all evidence for and against one answer: kind, ros_distro, base_image …",
    )


def _plan(commands: Commands) -> None:
    plan = _command(commands, "plan", "Print the plan of the image as JSON, for workflows.")
    _repository(plan, *OVERRIDING)
    plan.add_argument("--format", choices=("json",), default="json", help="a plan is always JSON")


def _check(commands: Commands) -> None:
    check = _command(commands, "check", "Validate roslab.yaml and say which format it has.")
    _repository(check, *OVERRIDING)
    _format(check)


def _migrate(commands: Commands) -> None:
    migrate = _command(commands, "migrate", "Print today's form of an old roslab.yaml, with a line per change.")
    _repository(migrate)
    migrate.add_argument("--write", action="store_true", help="replace the file; the old one is kept as FILE.old")


def _create(commands: Commands) -> None:
    create = _command(commands, "create", "Write Dockerfile, docker_build.sh, docker_run.sh and README.ipynb.")
    _repository(create, *OVERRIDING)
    create.add_argument(
        "--output", metavar="DIR", type=values.folder, help="folder to write to (default: the repository)"
    )
    create.add_argument(
        "--force", action="store_true", help="replace files that roslab wrote before; never one of yours"
    )


def _explain(commands: Commands) -> None:
    explain = _command(commands, "explain", "Say in plain words why a build failed or a command died.")
    saved = "saved by `docker build . > LOG 2>&1`, act, GitHub or GitLab; - for standard input"
    log = f"the log of a failed build or of a command that died, {saved}"
    explain.add_argument("log", metavar="LOG", type=values.log, help=log)
    _repository(explain, default=None)
    _format(explain)
    explain.add_argument(
        "--ask",
        action="store_true",
        help="with the engine, ask the image's apt which package holds what is missing, and pip's index for wheels",
    )
    explain.add_argument(
        "--apply",
        action="store_true",
        help="add what is certainly missing to roslab.yaml, and show the change; the old one is kept as FILE.old",
    )


def _build(commands: Commands) -> None:
    build = _command(commands, "build", "Build the image, run it once, and only then give it its name.")
    _repository(build, *OVERRIDING)
    _tag(build)
    build.add_argument("--no-proof", action="store_true", help="do not run the image before it gets its name")
    build.add_argument(
        "--screenshots",
        metavar="DIR",
        help="folder for the screenshot of a program with windows (default: roslab/NAME in your cache folder)",
    )
    build.add_argument(
        "--slim", action="store_true", help="build a second image of what runs alone, too, whose name ends in -slim"
    )
    build.add_argument("--no-cache", action="store_true", help="build every layer anew")
    build.add_argument("--no-lock", action="store_true", help="take today's versions, whatever roslab.lock says")
    build.add_argument(
        "--twice", action="store_true", help="build twice from nothing, compare the bits, and name what differs"
    )
    build.add_argument(
        "--repair",
        metavar="N",
        type=values.rounds,
        default=ROUNDS,
        help=f"add what a build or the command certainly lacks, and build again, at most N times (default: {ROUNDS})",
    )
    build.add_argument(
        "--no-repair", dest="repair", action="store_const", const=0, help="build once: let the first failure stand"
    )
    build.add_argument(
        "--write",
        action="store_true",
        help="write what a repair added to roslab.yaml; the old one is kept as FILE.old",
    )
    build.add_argument(
        "--build-arg",
        action="append",
        default=[],
        metavar="NAME=VALUE",
        help="pass a build argument; may be repeated",
    )


def _lock(commands: Commands) -> None:
    lock = _command(commands, "lock", "Prove the image that `roslab build` made, and write its versions.")
    _repository(lock, *OVERRIDING)
    _tag(lock)
    lock.add_argument(
        "--check", action="store_true", help="write nothing: say what of roslab.lock could no longer be had"
    )


def _diff(commands: Commands) -> None:
    diff = _command(commands, "diff", "Say what moved from one image to another: packages, sources, base, variables.")
    diff.add_argument("old", metavar="IMAGE", help="an image; one that the engine has not is pulled")
    diff.add_argument("new", metavar="IMAGE", help="the other one")
    diff.add_argument("--platform", metavar="PLATFORM", help="the platform to compare (default: the engine's own)")
    _format(diff)


def _run(commands: Commands) -> None:
    run = _command(commands, "run", "Run the image that `roslab build` made, with its volumes, ports, display and GPU.")
    _repository(run, "--name")
    run.add_argument("--notebook", action="store_true", help="open JupyterLab instead of the default command")
    run.add_argument(
        "--list",
        action="store_true",
        help="print the default command and, below it, the others that were found, one on a line; run nothing",
    )
    _tag(run)
    run.add_argument("arguments", nargs="*", metavar="-- COMMAND", help="a command to run instead of the default one")


def _verify(commands: Commands) -> None:
    verify = _command(commands, "verify", "Prove a published image again, here, and compare with what it carries.")
    verify.add_argument("image", metavar="IMAGE", help="the image, such as ghcr.io/OWNER/NAME:TAG")
    verify.add_argument(
        "--platform", metavar="NAME", help="platform to prove, such as linux/arm64 (default: the engine's)"
    )
    verify.add_argument("--like", metavar="IMAGE", help="compare with what this other image carries")
    _format(verify)


def completed(arguments: Sequence[str]) -> list[str]:
    """Return the arguments with the number that ``--repair`` means alone: what follows may be the repository."""
    own = len(arguments) if "--" not in arguments else list(arguments).index("--")
    alone = [not after.lstrip("-").isdigit() for after in [*arguments[1:], ""]]  # -3 is a number too: a wrong one
    return [f"--repair={ROUNDS}" if at < own and a == "--repair" and alone[at] else a for at, a in enumerate(arguments)]


def _command(commands: Commands, name: str, summary: str) -> argparse.ArgumentParser:
    command = commands.add_parser(
        name,
        help=summary,
        description=summary,
        epilog=EXIT_CODES,
        formatter_class=_Help,
    )
    command.set_defaults(handler=name, asked=command)
    return command


def _repository(command: argparse.ArgumentParser, *overriding: str, default: str | None = ".") -> None:
    """Add the arguments of a command that reads a repository, and those options of ``OVERRIDING`` that it takes."""
    help_ = (
        "the repository (default: this folder)"
        if default
        else "the repository that was built: adds who asked and the lines to paste (for --ask and --apply: this folder)"
    )
    command.add_argument("path", nargs="?", default=default, type=values.folder, metavar="PATH", help=help_)
    command.add_argument("--config", metavar="FILE", help="roslab.yaml to read, relative to the repository")
    command.add_argument("--branch", metavar="NAME", help="the branch's name, where there is no .git to read it from")
    for option in overriding:
        metavar, text = _HELP[option]
        command.add_argument(option, dest=OVERRIDING[option], metavar=metavar, help=text)


def _format(command: argparse.ArgumentParser) -> None:
    command.add_argument(
        "--format", choices=("text", "json"), default="text", help="json is for programs (default: text)"
    )


def _tag(command: argparse.ArgumentParser) -> None:
    command.add_argument(
        "--tag", metavar="TAG", type=values.tag, default="latest", help="tag of the image (default: latest)"
    )


_COMMANDS: dict[str, Callable[[Commands], None]] = {
    "inspect": _inspect,
    "plan": _plan,
    "check": _check,
    "migrate": _migrate,
    "create": _create,
    "explain": _explain,
    "build": _build,
    "lock": _lock,
    "diff": _diff,
    "run": _run,
    "verify": _verify,
}
