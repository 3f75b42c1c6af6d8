"""What of a lock could no longer be had, asked before the build that would use it."""

from __future__ import annotations

import json
import os
import tempfile
from collections.abc import Iterator, Sequence
from itertools import pairwise

from roslab.engine import docker as engine
from roslab.engine import registry
from roslab.engine.asking import ask
from roslab.engine.docker import last_line, output
from roslab.engine.secrets import Secret
from roslab.errors import BuildError
from roslab.lock import index
from roslab.lock.inventory import inspect
from roslab.plan.locked import LockedSource, Missing
from roslab.plan.plan import Plan
from roslab.values.dataclass import dataclass

GIT = ("env", "GIT_TERMINAL_PROMPT=0", "git")
"""A repository that asks for a password is private or gone: nobody is asked."""
GONE = ("not found", "unknown", "no such", "404", "denied")
"""Words of a registry that does not have an image."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Answer:
    """What is gone, and what could not be asked."""

    missing: tuple[Missing, ...]
    silent: tuple[str, ...]


def check(plan: Plan, question: str, platform: str, secrets: Sequence[Secret] = ()) -> Answer:
    """Ask the registry, apt's sources, pip's indexes and git for what a plan's lock names for a platform.

    ``question`` is the Dockerfile that asks apt's sources, as ``render.dockerfile.question`` writes it, and
    ``secrets`` are those of the build.
    """
    silent: list[str] = []
    gone = [*_base(plan, silent)]
    gone += [] if gone else _apt(question, platform, secrets, silent)
    machine = plan.lock.machine(platform) if plan.lock else None
    if machine:
        packages = [package for each in machine.python for package in each.packages]
        lost, why = index.missing(packages, _indexes(plan))
        gone += lost
        silent += [why] if why else []
    for source in plan.lock.sources if plan.lock else ():
        gone += _source(source, silent)
    return Answer(missing=tuple(gone), silent=tuple(silent))


def _base(plan: Plan, silent: list[str]) -> Iterator[Missing]:
    name, _, digest = plan.base_image.partition("@")
    if not digest or _held(plan.base_image):
        return
    try:
        registry.digest_of(plan.base_image, attempts=2)
    except BuildError as error:
        said = str(error)
        if not any(word in said.lower() for word in GONE):
            silent.append(said)
            return
        yield Missing(kind="base", name=name, wanted=digest, nearest=_digest(name))


def _held(reference: str) -> bool:
    try:
        return bool(inspect(reference))
    except BuildError:
        return False


def _digest(name: str) -> str | None:
    try:
        return registry.digest_of(name, attempts=1)
    except BuildError:
        return None


def _apt(question: str, platform: str, secrets: Sequence[Secret], silent: list[str]) -> Iterator[Missing]:
    try:
        answer = ask(question, (platform,), secrets=secrets)
    except engine.FailedBuild as error:
        silent.append(f"apt's sources were not asked: {error.problems[0].message}")
        return
    for line in answer.splitlines():
        name, wanted, *nearest = line.split()
        yield Missing(kind="apt", name=name, wanted=wanted, nearest=nearest[0] if nearest else None)


def _indexes(plan: Plan) -> tuple[str, ...]:
    """Return the indexes that pip asks: of its options, the base's variables, the secret, and PyPI."""
    options = (*plan.python.options, *plan.python.pip_options)
    words = [word for option in options for word in option.replace("=", " ").split()]
    named: dict[str, list[str]] = {"--index-url": [], "--extra-index-url": []}
    for flag, value in pairwise(words):
        named.get("--index-url" if flag == "-i" else flag, []).append(value)
    variables = _variables(plan.base_image)
    first = named["--index-url"] or [variables.get("PIP_INDEX_URL") or index.default()]
    more = [*named["--extra-index-url"], *variables.get("PIP_EXTRA_INDEX_URL", "").split()]
    more += [os.environ["PIP_INDEX"]] if "pip_index" in plan.secrets and os.environ.get("PIP_INDEX") else []
    return tuple(dict.fromkeys(filter(None, (*first, *more))))


def _variables(base: str) -> dict[str, str]:
    try:
        given = inspect(base).get("Config", {}).get("Env") or ()
    except BuildError:
        answer = output(["docker", "buildx", "imagetools", "inspect", "--format", "{{json .Image}}", base])
        try:
            data = json.loads(answer.stdout)
            data = data if "config" in data else next(iter(data.values()))
            given = data["config"].get("Env") or ()
        except (ValueError, KeyError, TypeError, AttributeError, StopIteration):
            given = ()
    return dict(entry.partition("=")[::2] for entry in given)


def _source(source: LockedSource, silent: list[str]) -> Iterator[Missing]:
    """Ask a repository for a commit; the nearest is what its default branch is at."""
    listed = output([*GIT, "ls-remote", "--", source.url])
    if listed.returncode:
        said = last_line(listed.stderr)
        if "not found" not in said.lower():
            silent.append(f"{source.url} does not answer: {said}")
            return
        yield Missing(kind="source", name=source.name, wanted=source.commit, nearest=None)
        return
    known = [line.split()[0] for line in listed.stdout.splitlines() if line]
    if source.commit in known:
        return
    with tempfile.TemporaryDirectory(prefix="roslab-") as folder:
        output([*GIT, "init", "--quiet", "--bare", folder])
        got = output([*GIT, "-C", folder, "fetch", "--quiet", "--depth=1", "--", source.url, source.commit], 300.0)
    if got.returncode:
        yield Missing(kind="source", name=source.name, wanted=source.commit, nearest=known[0] if known else None)
