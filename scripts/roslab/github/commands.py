"""``roslab github STEP``: the steps of the action and of the workflows; environment in, outputs out."""

from __future__ import annotations

import argparse
import os
from collections.abc import Callable, Mapping
from importlib import import_module

from roslab.errors import RoslabError

STEPS: Mapping[str, tuple[str, str]] = {
    "source": ("Fetch the submodules, large files and tags that the checkout lacks.", "steps"),
    "plan": (
        "Read the event, the inputs and the repository; decide what is built and whether it is published.",
        "steps",
    ),
    "ready": ("Check the engine and the registry before anything is built.", "steps"),
    "dockerfile": ("Write the Dockerfile and the settings of the build.", "building"),
    "explain": ("Say in plain words why the build failed.", "explaining"),
    "prove": ("Run the image on its platforms.", "proving"),
    "slim": ("Build the slim image and run it on its platforms.", "slim"),
    "index": ("Put the proved images under their commit's tag.", "publishing"),
    "tag": ("Move the other tags to the proved images.", "publishing"),
    "summary": ("Write the job's summary.", "steps"),
    "drift": ("Build from nothing, prove, and compare with the image that was archived.", "drift"),
    "clean": ("Remove the versions of an image that nobody needs, or show which they are.", "clean"),
}
"""What each step does, and the module with the function of its name: each is a process that imports only its own."""


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
        function(options.step)(os.environ)
    except RoslabError as error:
        _keep(options.step, error)
        raise
    return 0


def function(step: str) -> Callable[[Mapping[str, str]], None]:
    """Return what a step runs."""
    found: Callable[[Mapping[str, str]], None] = getattr(import_module(f"roslab.github.{STEPS[step][1]}"), step)
    return found


def _keep(step: str, error: RoslabError) -> None:
    """Keep a failure for the step that writes the summary; if no run exists yet, write the summary now."""
    from roslab.github import kept, steps, workflow  # noqa: PLC0415 - a step that does not fail needs none of them
    from roslab.github.run import Folder  # noqa: PLC0415

    lines = [" ".join(str(problem).split()) for problem in error.problems]
    try:
        folder = Folder.of(os.environ)
    except RoslabError:
        if step != "summary":
            workflow.summary(steps.nothing_built(lines), os.environ)
        return
    kept.fail(folder.artifact, lines)
