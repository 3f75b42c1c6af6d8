"""Jobs of GitLab's CI that by their stage bring something out: what they install is for that alone."""

from __future__ import annotations

import re

from roslab.evidence.lex.yaml import Scalar
from roslab.values.pattern import pattern

_HEAD = pattern(r"[^\s#-][^#]*:\s*(?:#.*)?$")
_STAGE = pattern(
    r"\s+stage\s*:\s*[\"']?(?:[\w.]*[\s_-])?(?:deploy\w*|releas\w*|publish\w*|pages|upload\w*)[\"']?\s*(?:#.*)?$",
    re.IGNORECASE,
)
"""The stage of a job, by its name: https://docs.gitlab.com/ci/yaml/#stage, read 2026-11-28."""


def without_deploys(values: tuple[Scalar, ...], text: str, path: str) -> tuple[Scalar, ...]:
    """Return the values of a CI file without those of such jobs; only GitLab's files have jobs as their keys."""
    if not path.startswith(".gitlab"):
        return values
    job, aside = 0, set()
    jobs: list[int] = []
    for number, line in enumerate(text.split("\n"), 1):
        job = number if _HEAD.match(line) else job
        jobs.append(job)
        if _STAGE.match(line):
            aside.add(job)
    return tuple(value for value in values if not aside or jobs[min(value.line, len(jobs)) - 1] not in aside)
