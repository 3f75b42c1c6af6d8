"""The command that runs an image."""

from __future__ import annotations

import argparse
import os
import shlex
import shutil
import subprocess
import tempfile
from pathlib import Path

from roslab.cli.planning import planned_of
from roslab.errors import BuildError, Problem
from roslab.pipeline import rendered
from roslab.plan.plan import Plan
from roslab.values.words import line_of


def commands(plan: Plan) -> list[str]:
    """Return the default command and the others that were found, the strongest first, each as a shell reads it."""
    command = line_of(plan.run.command)
    return list(dict.fromkeys((command, *map(shlex.join, plan.run.candidates))))


def run(options: argparse.Namespace) -> int:
    """Run the image with the same script that ``create`` writes as docker_run.sh."""
    planned = planned_of(options)
    if options.list:
        print(*commands(planned.plan), sep="\n")
        return 0
    if not shutil.which("docker"):
        raise BuildError(Problem(message="docker is not installed", hint="https://docs.docker.com/engine/install/"))
    with tempfile.TemporaryDirectory(prefix="roslab-") as folder:
        script = Path(folder) / "docker_run.sh"
        text = next(file.text for file in rendered(planned, Path(folder)) if file.path == "docker_run.sh")
        script.write_text(text, encoding="utf-8")
        arguments = ["--notebook"] if options.notebook else []
        environment = {
            **os.environ,
            "ROSLAB_IMAGE": os.environ.get("ROSLAB_IMAGE", f"{planned.plan.name}:{options.tag}"),
        }
        return subprocess.run(
            ["bash", str(script), *arguments, *options.arguments],
            env=environment,
            cwd=planned.repository.root,
            check=False,
        ).returncode
