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
from roslab.engine.docker import check, output
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
        image = os.environ.get("ROSLAB_IMAGE", "")
        if not image:
            image = _built(f"{planned.plan.name}:{options.tag}")
            arguments += ["--option", "--pull=never"]
        return subprocess.run(
            ["bash", str(script), *arguments, *options.arguments],
            env={**os.environ, "ROSLAB_IMAGE": image},
            cwd=planned.repository.root,
            check=False,
        ).returncode


def _built(image: str) -> str:
    """Return an image that the engine has: a registry's of that name is somebody else's."""
    if output(["docker", "image", "inspect", image]).returncode:
        check()
        hint = "run `roslab build` first, or name a published one in the variable ROSLAB_IMAGE"
        raise BuildError(Problem(message=f"there is no image {image} here", hint=hint))
    return image
