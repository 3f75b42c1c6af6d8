"""Frameworks in a release, or a build, whose wheel computes on the CPU alone."""

from __future__ import annotations

from collections.abc import Iterable

from roslab.decide.cuda.conda_builds import built_for
from roslab.decide.cuda.local import of_the_cpu
from roslab.decide.decision import Warning_
from roslab.decide.python.pythons import ANY
from roslab.decide.reasons import warn
from roslab.evidence.facts import Evidence
from roslab.knowledge.accelerated import accelerated, computed_by, without_gpu
from roslab.knowledge.frameworks import newest_framework
from roslab.values.name import canonicalize_name
from roslab.values.requirement import Requirement


def built_for_cpu(evidence: Evidence, asked: Iterable[Requirement]) -> frozenset[str]:
    """Return the frameworks that pip or conda is asked for in a build for the CPU (``1.13.1+cpu``), in no other."""
    found = [(each.key, of_the_cpu(each.release or "")) for each in asked if ANY.may(each)]
    return _always([*found, *(each for environment in evidence.conda for each in built_for(environment))])


def without_gpus(evidence: Evidence, asked: Iterable[Requirement]) -> frozenset[str]:
    """Return the frameworks that pip has on the evidence's day, or in the release asked for, without code for GPUs.

    Their builds for GPUs were packages of other names. What only computes by one of them is as it is.
    """
    named = [(each.key, each.release) for each in (*asked, *evidence.listed) if ANY.may(each)]
    known = {name for name, _ in named}
    imported = {canonicalize_name(used.name) for used in evidence.code if used.namespace == "import"}
    named += [(name, None) for name in imported - known]
    found = _always((name, without_gpu(name, release or _of_day(evidence, name))) for name, release in named)
    return found | {name for name, by in computed_by().items() if by in found}


def warn_of_cpu(evidence: Evidence, asked: Iterable[Requirement]) -> tuple[Warning_, ...]:
    """Warn where a page speaks of CUDA, and what pip has computes on the CPU alone."""
    said = next((mention for mention in evidence.mentions if mention.topic == "cuda"), None)
    found = sorted(without_gpus(evidence, asked) - computed_by().keys()) if said else ()
    message = "{0} computes on the CPU alone in the release for this code: for GPUs there was the package {0}-gpu"
    return tuple(warn(message.format(name), said) for name in found)


def _always(found: Iterable[tuple[str, bool]]) -> frozenset[str]:
    """Return the frameworks that are so wherever they are named."""
    every: dict[str, bool] = {}
    for name, so in found:
        if name in accelerated():
            every[name] = every.get(name, True) and so
    return frozenset(name for name, so in every.items() if so)


def _of_day(evidence: Evidence, name: str) -> str:
    """Return the first release of the series that was the newest on the day of pip's packages, ``""`` without one."""
    below = next((use.bound.below for use in evidence.bounds if use.bound.key == name), None)
    newest = newest_framework(name, evidence.pip_day, None, below) if evidence.pip_day else None
    return newest.first if newest else ""
