"""The ``roslab`` command: runs the requested command, turns errors into messages and returns the exit code."""

from __future__ import annotations

import argparse
import atexit
import errno
import gc
import os
import signal
import sys
from collections.abc import Callable, Sequence
from importlib import import_module
from typing import NoReturn

from roslab.cli.arguments import completed, parser
from roslab.errors import RoslabError
from roslab.values import kept_modules, kept_trees

MODULES = {
    "build": "building",
    "explain": "explaining",
    "lock": "locking",
    "diff": "locking",
    "run": "running",
    "verify": "verifying",
}
"""Modules of the commands that are not in ``commands``."""


def run() -> NoReturn:
    """Run the command line and end the process, without giving back what it made: that takes long for many values."""
    kept_modules.install("roslab.cli.commands", "roslab.evidence.gather", "roslab.decide.deciding")
    kept_trees.install()
    # A stream that the caller has closed is None: what is said there is for nobody, and no bug of ours
    sys.stdout = sys.stdout or open(os.devnull, "w", encoding="utf-8")  # noqa: PTH123, SIM115 - it is open to the end
    sys.stderr = sys.stderr or open(os.devnull, "w", encoding="utf-8")  # noqa: PTH123, SIM115
    code = main()
    try:
        sys.stdout.flush()
        sys.stderr.flush()
    except (AttributeError, OSError, ValueError):  # closed, or full: Python says so when it ends itself
        sys.exit(code)
    atexit._run_exitfuncs()
    os._exit(code)


def main(argv: Sequence[str] | None = None) -> int:
    """Run the command line and return the exit code; no traceback reaches a user."""
    gc.set_threshold(1_000_000)  # nearly all that a command makes stays until it ends: to look for the rest is lost
    arguments = list(sys.argv[1:] if argv is None else argv)
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(143))  # so that `finally` runs and nothing half-built remains
    debug = os.environ.get("ROSLAB_DEBUG") == "1"
    code = 0
    try:
        options = _parsed(completed(arguments))
        code = _handler(options)(options)
        sys.stdout.flush()  # what cannot be written is seen here, not when the process ends
    except RoslabError as error:
        _report(error)
        return error.exit_code
    except BrokenPipeError:
        # The reader of our output has closed it (`| head`): not an error, but Python would print one at exit
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
    except KeyboardInterrupt:
        sys.stderr.write("\nroslab: interrupted\n")
        return 130
    except Exception as error:  # the last line of defence: a bug of ours, or a full disk
        return _unexpected(error, debug=debug)
    return code


def _parsed(arguments: list[str]) -> argparse.Namespace:
    """Return the options; what follows the ``--`` of ``run`` is its command, also where no folder stands before."""
    top = parser(next(iter(arguments), None))
    end = arguments.index("--") if arguments[:1] == ["run"] and "--" in arguments else len(arguments)
    options, unknown = top.parse_known_args(arguments[:end])
    if unknown:  # the usage of the command says what it takes, that of roslab alone does not
        getattr(options, "asked", top).error(f"unrecognized arguments: {' '.join(unknown)}")
    if not hasattr(options, "handler"):
        top.error("the following arguments are required: COMMAND")
    if end < len(arguments):
        options.arguments = [*options.arguments, *arguments[end + 1 :]]
    return options


def _unexpected(error: Exception, *, debug: bool) -> int:
    """Say what stopped the command that no code of ours foresaw, and return its exit code."""
    if debug:
        raise error
    if isinstance(error, OSError) and error.errno in (errno.ENOSPC, errno.EDQUOT):
        sys.stderr.write(f"roslab: error: {error.strerror}: what was to be written is not complete\n")
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())  # as for a closed pipe
        return 5
    from roslab.repository.checkout import printable  # noqa: PLC0415 - nobody waits for it before

    # One line without control characters: on GitHub a line of its own could be a command to the runner
    said = printable(f"{type(error).__name__}: {error}").replace("##[", "## [")
    sys.stderr.write(f"roslab: a bug: {said}\n")
    sys.stderr.write("Please report it; ROSLAB_DEBUG=1 shows where it happened.\n")
    return 1


def _handler(options: argparse.Namespace) -> Callable[[argparse.Namespace], int]:
    if callable(options.handler):
        handler: Callable[[argparse.Namespace], int] = options.handler
        return handler
    # `--help` and wrong arguments need none of these, and each command only its own
    module = import_module(f"roslab.cli.{MODULES.get(options.handler, 'commands')}")
    found: Callable[[argparse.Namespace], int] = getattr(module, options.handler)
    return found


def _report(error: RoslabError) -> None:
    if os.environ.get("GITHUB_ACTIONS") == "true":
        from roslab.github.workflow import error_commands  # noqa: PLC0415

        sys.stdout.flush()
        sys.stdout.write(error_commands(error))
        return
    red, plain = ("\033[31m", "\033[0m") if _colour() else ("", "")
    for problem in error.problems:
        place = problem.origin if problem.file else "roslab"
        named = f"{problem.origin}: " if problem.origin and not problem.file else ""
        hint = f"\n  {problem.hint}" if problem.hint else ""
        sys.stderr.write(f"{place}: {red}error{plain}: {named}{problem.message}{hint}\n")


def _colour() -> bool:
    return sys.stderr.isatty() and "NO_COLOR" not in os.environ and os.environ.get("TERM") != "dumb"
