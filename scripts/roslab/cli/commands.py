"""What each command does; results go to standard output, progress to standard error."""

from __future__ import annotations

import argparse
import json
import sys

from roslab.cli.planning import named, planned_of, warnings_of
from roslab.config import locate
from roslab.errors import ConfigurationError, Problem


def inspect(options: argparse.Namespace) -> int:
    """Print what was found and why."""
    from roslab.render import report  # noqa: PLC0415 - the other commands do without

    planned = planned_of(options)
    if options.explain:
        questions = sorted({reason.question for reason in planned.decision.reasons})
        if options.explain not in questions:
            raise ConfigurationError(
                Problem(message=f"no question {options.explain!r} here", hint=f"one of: {', '.join(questions)}")
            )
        sys.stdout.write(report.explanation(planned.decision.reasons, options.explain))
    elif options.format == "json":
        sys.stdout.write(report.inspection_json(planned.decision, planned.plan))
    else:
        sys.stdout.write(report.inspection_text(planned.decision, planned.plan))
    return 0


def plan(options: argparse.Namespace) -> int:
    """Print the plan as JSON."""
    from roslab.plan.plan import to_json  # noqa: PLC0415

    sys.stdout.write(to_json(planned_of(options).plan))
    return 0


def check(options: argparse.Namespace) -> int:
    """Validate roslab.yaml, and check that the repository can be planned with it."""
    from roslab.config.generation import NAMES  # noqa: PLC0415 - the other commands do without

    planned = planned_of(options)
    config = planned.config
    if options.format == "json":
        warnings = [{"message": w.message, "file": w.file, "line": w.line} for w in planned.decision.warnings]
        sys.stdout.write(
            json.dumps({"file": config.file, "format": config.generation, "warnings": warnings}, indent=2) + "\n"
        )
        return 0
    sys.stdout.write(
        f"{config.file}: valid, in {NAMES[config.generation]}\n"
        if config.file
        else "no roslab.yaml: everything comes from the repository\n"
    )
    sys.stdout.write(warnings_of(planned))
    return 0


def migrate(options: argparse.Namespace) -> int:
    """Print an old roslab.yaml in today's format."""
    from roslab.config.migrate import migrate as migrated  # noqa: PLC0415
    from roslab.repository.checkout import Repository  # noqa: PLC0415

    repository = Repository.open(options.path, branch=options.branch)
    file = locate.find(repository, named(options))
    if file is None:
        raise ConfigurationError(Problem(message="there is no roslab.yaml to migrate", hint="name it with --config"))
    migration = migrated(locate.text(repository, file), file=file)
    for change in migration.changes:
        sys.stderr.write(f"{change}\n")
    if options.write:
        from roslab.files import replace_with_backup  # noqa: PLC0415

        replace_with_backup(repository.root / file, migration.text)
    else:
        sys.stdout.write(migration.text)
    return 0


def create(options: argparse.Namespace) -> int:
    """Write the generated files to the repository's root or to ``--output``."""
    from pathlib import Path  # noqa: PLC0415 - the other commands do without

    from roslab.files import write_all  # noqa: PLC0415
    from roslab.pipeline import rendered  # noqa: PLC0415

    planned = planned_of(options)
    folder = Path(options.output) if options.output else planned.repository.root
    written = write_all(rendered(planned, folder), folder, force=options.force)
    for entry in written:
        sys.stdout.write(f"{entry}\n")
    sys.stderr.write(warnings_of(planned))
    return 0
