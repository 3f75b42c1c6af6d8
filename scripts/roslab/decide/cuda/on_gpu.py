"""Whether a container needs a GPU, and what is told where a page or the code asks for one that the image is not for."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable

from roslab.config.model import Config
from roslab.decide.decision import Warning_
from roslab.decide.launch_calls import started_launch
from roslab.decide.reasons import warn
from roslab.decide.system.needs import TOOLKIT
from roslab.evidence.facts import Evidence, Mention
from roslab.knowledge.frameworks import framework_on_cuda
from roslab.values.pattern import pattern
from roslab.values.requirement import Requirement

_REQUIRES = pattern(r"\b(?:install|requir|need|prerequisite|depend|must have)", re.IGNORECASE)


def needs_gpu(
    evidence: Evidence, config: Config, command: tuple[str, ...] | str, installed: Collection[str], *, cuda: bool
) -> bool:
    """Tell whether a container gets the machine's GPU: as roslab.yaml says, else for CUDA, or for what is started.

    ``installed``: packages of apt, of which one is CUDA's toolkit; ``cuda``: the image is for CUDA.
    """
    if config.gpu is not None:
        return config.gpu
    return cuda or TOOLKIT in installed or (not config.compatible and computing_there(evidence, command) is not None)


def computing_there(evidence: Evidence, command: tuple[str, ...] | str) -> Mention | None:
    """Return the line by which what a command starts computes on a GPU in any case, ``None`` where none does."""
    said = [mention for mention in evidence.mentions if mention.topic == "on_gpu"]
    if not said or isinstance(command, str):
        return None
    launch = started_launch(evidence, command)
    started = {launch.file} if launch else {*command}
    return next((mention for mention in said if mention.value in started), None)


def told_of_no_gpu(evidence: Evidence, installed: Iterable[Requirement]) -> tuple[Warning_, ...]:
    """Warn where a page requires CUDA and a framework is installed that computes on it: the image has none."""
    asked = (m for m in evidence.mentions if m.topic == "cuda" and "/" not in m.file and m.source == "readme")
    said = next((m for m in asked if _REQUIRES.search(m.heading) or _REQUIRES.search(m.text)), None)
    found = sorted({each.key for each in installed if framework_on_cuda(each.key)}) if said else []
    if said is None or not found:
        return ()
    message = f"a page requires CUDA {said.value}, and this image is for no GPU: {found[0]} computes on the CPU"
    then = f"`base: {{cuda: '{said.value}'}}` in roslab.yaml makes one for it, `gpu: true` gives it to the container"
    return (warn(f"{message}; {then}", said),)
