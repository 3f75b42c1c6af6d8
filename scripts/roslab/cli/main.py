"""The ``roslab`` command: arguments, one ``try``, exit codes."""

from __future__ import annotations

import argparse
import os
import signal
import sys
from collections.abc import Callable, Sequence

from roslab import __version__
from roslab.errors import RoslabError

EXIT_CODES = """\
exit codes:
  0  done
  2  wrong arguments or a wrong roslab.yaml
  3  nothing to build was found
  4  refused for safety: a file of yours would be overwritten, a link leads out of the tree
  5  the engine, the registry, the build or the image failed
  1  a bug of roslab's own
"""


def parser() -> argparse.ArgumentParser:
    """Return the whole command line."""
    top = argparse.ArgumentParser(
        prog="roslab",
        description="Work out, build and run a container image for a robotics repository.",
        epilog=EXIT_CODES,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    top.add_argument("--version", action="version", version=f"roslab {__version__}")
    commands = top.add_subparsers(title="commands", metavar="COMMAND", required=True)
    _reading_commands(commands)
    _building_commands(commands)
    if "github" in sys.argv[1:2]:  # only a workflow calls it: its modules stay off a laptop's path
        from roslab.github.commands import add_parser  # noqa: PLC0415

        add_parser(commands)
    return top


def _command(
    commands: argparse._SubParsersAction[argparse.ArgumentParser],
    name: str,
    handler: str,
    summary: str,
    *,
    path: bool = True,
) -> argparse.ArgumentParser:
    command = commands.add_parser(
        name,
        help=summary,
        description=summary,
        epilog=EXIT_CODES,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    command.set_defaults(handler=handler)
    if path:
        command.add_argument(
            "path", nargs="?", default=".", metavar="PATH", help="the repository (default: this folder)"
        )
        command.add_argument("--config", metavar="FILE", help="roslab.yaml to read, relative to the repository")
        command.add_argument(
            "--branch", metavar="NAME", help="the branch's name, where there is no .git to read it from"
        )
        command.add_argument(
            "--name", metavar="NAME", help="the image's name (default: roslab.yaml's, else the repository's)"
        )
    return command


def _reading_commands(commands: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    inspect = _command(commands, "inspect", "inspect", "Show what was found in a repository and what follows from it.")
    inspect.add_argument(
        "--format", choices=("text", "json"), default="text", help="json is for programs (default: text)"
    )
    inspect.add_argument(
        "--explain",
        metavar="QUESTION",
        help="show all evidence for and against one answer: kind, ros_distro, base_image …",
    )
    plan = _command(commands, "plan", "plan", "Print the plan of the image as JSON, for workflows.")
    _overrides(plan)
    check = _command(commands, "check", "check", "Validate roslab.yaml and say which format it has.")
    check.add_argument(
        "--format", choices=("text", "json"), default="text", help="json is for programs (default: text)"
    )
    migrate = _command(
        commands, "migrate", "migrate", "Print today's form of an old roslab.yaml, with a line per change."
    )
    migrate.add_argument("--write", action="store_true", help="replace the file; the old one is kept as FILE.old")
    create = _command(
        commands, "create", "create", "Write Dockerfile, docker_build.sh, docker_run.sh and README.ipynb."
    )
    create.add_argument("--output", metavar="DIR", help="folder to write to (default: the repository)")
    create.add_argument(
        "--force", action="store_true", help="replace files that roslab wrote before; never one of yours"
    )
    _overrides(create)
    explain = _command(commands, "explain", "explain", "Say in plain words why a build failed.", path=False)
    explain.add_argument("log", metavar="LOG", help="the saved log of a build, - for standard input")


def _building_commands(commands: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    build = _command(commands, "build", "build", "Build the image, run it once, and only then give it its name.")
    _overrides(build)
    build.add_argument("--tag", metavar="TAG", default="latest", help="tag of the image (default: latest)")
    build.add_argument("--no-proof", action="store_true", help="do not run the image before it gets its name")
    build.add_argument(
        "--screenshots",
        metavar="DIR",
        help="folder for the screenshot of a program with windows (default: roslab/NAME in your cache folder)",
    )
    build.add_argument("--no-cache", action="store_true", help="build every layer anew")
    build.add_argument(
        "--build-arg",
        action="append",
        default=[],
        metavar="NAME=VALUE",
        help="pass a build argument; may be repeated",
    )
    run = _command(
        commands,
        "run",
        "run",
        "Run the image that `roslab build` made, with its volumes, ports, display and GPU.",
    )
    run.add_argument("--notebook", action="store_true", help="open JupyterLab instead of the default command")
    run.add_argument("--tag", metavar="TAG", default="latest", help="tag of the image (default: latest)")
    run.add_argument("arguments", nargs="*", metavar="-- COMMAND", help="a command to run instead of the default one")


def _overrides(command: argparse.ArgumentParser) -> None:
    command.add_argument("--platform", metavar="LIST", help="platforms, linux/amd64,linux/arm64 …")
    command.add_argument(
        "--command", dest="default_command", metavar="TEXT", help="default command of the image, run by bash"
    )
    command.add_argument("--test", metavar="TEXT", help="command that proves the image, run by bash")


def main(argv: Sequence[str] | None = None) -> int:
    """Run the command line and return the exit code; no traceback reaches a user."""
    arguments = list(sys.argv[1:] if argv is None else argv)
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(143))  # so that `finally` runs and nothing half-built stays
    debug = os.environ.get("ROSLAB_DEBUG") == "1"
    try:
        options = parser().parse_args(arguments)
        return _handler(options)(options)
    except RoslabError as error:
        _report(error)
        return error.exit_code
    except BrokenPipeError:
        # The reader of our output went away (`| head`): not an error, but Python would print one at exit
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 0
    except KeyboardInterrupt:
        sys.stderr.write("\nroslab: interrupted\n")
        return 130
    except Exception as error:  # the last line of defence: a bug of ours
        if debug:
            raise
        sys.stderr.write(f"roslab: a bug: {type(error).__name__}: {error}\n")
        sys.stderr.write("Please report it; ROSLAB_DEBUG=1 shows where it happened.\n")
        return 1


def _handler(options: argparse.Namespace) -> Callable[[argparse.Namespace], int]:
    if callable(options.handler):
        handler: Callable[[argparse.Namespace], int] = options.handler
        return handler
    from roslab.cli import commands  # noqa: PLC0415 - `--help` and wrong arguments need none of it

    found: Callable[[argparse.Namespace], int] = getattr(commands, options.handler)
    return found


def _report(error: RoslabError) -> None:
    if os.environ.get("GITHUB_ACTIONS") == "true":
        from roslab.github.workflow import error_commands  # noqa: PLC0415

        sys.stdout.flush()
        sys.stdout.write(error_commands(error))
        return
    red, plain = ("\033[31m", "\033[0m") if _colour() else ("", "")
    for problem in error.problems:
        hint = f"\n  {problem.hint}" if problem.hint else ""
        sys.stderr.write(f"{problem.origin or 'roslab'}: {red}error{plain}: {problem.message}{hint}\n")


def _colour() -> bool:
    return sys.stderr.isatty() and "NO_COLOR" not in os.environ and os.environ.get("TERM") != "dumb"
