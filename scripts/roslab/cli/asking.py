"""Questions of a repair to the apt of the image's base and to pip's index, by the engine of this machine."""

from __future__ import annotations

import argparse
import os
from collections.abc import Sequence

from roslab.engine.asking import ask
from roslab.engine.docker import native_platform, say
from roslab.engine.secrets import of_environment
from roslab.pipeline import Planned
from roslab.render.dockerfile import holders as question_of_files
from roslab.render.dockerfile import wheels as question_of_wheels
from roslab.repair.chain import Asking


def asking(planned: Planned, options: argparse.Namespace, arguments: tuple[tuple[str, str], ...] = ()) -> Asking:
    """Return who is asked for a repair of a plan; ``arguments`` are those of its build."""
    plan = planned.plan

    def answered(question: str) -> str:
        platforms = plan.platforms if getattr(options, "platforms", None) else (native_platform(),)
        return ask(question, platforms, secrets=of_environment(plan.secrets, os.environ), arguments=arguments)

    def files(paths: Sequence[str]) -> str:
        say("roslab: asking apt which package holds what is missing")
        return answered(question_of_files(plan, paths))

    def wheels(lines: Sequence[str]) -> str:
        say("roslab: asking pip's index for which Python it has a wheel")
        return answered(question_of_wheels(plan, lines))

    return Asking(files=files, wheels=wheels)
