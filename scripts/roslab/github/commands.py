"""``roslab github STEP``: the steps of the action and of the workflows; environment in, outputs out."""

from __future__ import annotations

import argparse
import os
from collections.abc import Callable, Mapping

from roslab.errors import RoslabError
from roslab.github import building, clean, drift, explaining, kept, proving, publishing, slim, steps, workflow
from roslab.github.run import Folder

STEPS: Mapping[str, tuple[str, Callable[[Mapping[str, str]], None]]] = {
    "source": ("Fetch the submodules, large files and tags that the checkout lacks.", steps.source),
    "plan": (
        "Read the event, the inputs and the repository; decide what is built and whether it is published.",
        steps.plan,
    ),
    "ready": ("Check the engine and the registry before anything is built.", steps.ready),
    "dockerfile": ("Write the Dockerfile and the settings of the build.", building.dockerfile),
    "explain": ("Say in plain words why the build failed.", explaining.explain),
    "prove": ("Run the image on its platforms.", proving.prove),
    "slim": ("Build the slim image and run it on its platforms.", slim.slim),
    "index": ("Put the proved images under their commit's tag.", publishing.index),
    "tag": ("Move the other tags to the proved images.", publishing.tag),
    "summary": ("Write the job's summary.", steps.summary),
    "drift": ("Build from nothing, prove, and compare with the image that was archived.", drift.drift),
    "clean": ("Remove the versions of an image that nobody needs, or show which they are.", clean.clean),
}


def add_parser(subparsers: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    """Add ``roslab github`` to the command line."""
    command = subparsers.add_parser("github", help="steps of a workflow", description="Steps of a workflow on GitHub.")
    names = command.add_subparsers(title="steps", metavar="STEP", required=True)
    for name, (text, _) in STEPS.items():
        step = names.add_parser(name, help=text, description=text)
        step.set_defaults(handler=run, step=name)


def run(options: argparse.Namespace) -> int:
    """Run one step; an error that stops it is also kept for the summary."""
    try:
        STEPS[options.step][1](os.environ)
    except RoslabError as error:
        _keep(options.step, error)
        raise
    return 0


def _keep(step: str, error: RoslabError) -> None:
    """Keep a failure for the step that writes the summary; if no run exists yet, write the summary now."""
    lines = [" ".join(str(problem).split()) for problem in error.problems]
    try:
        folder = Folder.of(os.environ)
    except RoslabError:
        if step != "summary":
            workflow.summary(steps.nothing_built(lines), os.environ)
        return
    kept.fail(folder.artifact, lines)
