"""The inputs of the action and of the workflows, read from the environment."""

from __future__ import annotations

import json
import posixpath
import re
from collections.abc import Mapping
from typing import Any, Literal, cast

from roslab.config import Override
from roslab.config.locate import Named
from roslab.config.overrides import problems_of
from roslab.errors import ConfigurationError, Problem
from roslab.github.event import Push
from roslab.plan.plan import image_name
from roslab.repository.checkout import printable
from roslab.values.dataclass import dataclass
from roslab.values.origin import Input
from roslab.values.pattern import pattern

Cache = Literal["auto", "registry", "none"]
Runner = str | list[str] | dict[str, Any]
"""A label, a list of labels that the runner must all have, or an object of ``group`` and ``labels``."""
PUSH = ("auto", "true", "false")
CACHE = ("auto", "registry", "none")
SETTINGS = {
    "platforms": "platforms",
    "command": "command",
    "test": "test",
    "kind": "kind",
    "date": "date",
    "build-tool": "build",
    "distro": "base.ros",
    "cuda": "base.cuda",
    "python": "base.python",
    "tag-prefix": "tags.prefix",
    "tag-suffix": "tags.suffix",
}
"""Inputs that set a key of roslab.yaml, and that key."""
DEFAULT_RUNNER = "ubuntu-24.04"
RUNNERS: dict[str, Runner] = {"linux/arm64": "ubuntu-24.04-arm", "linux/arm": "ubuntu-24.04-arm"}
"""Free for public repositories: https://docs.github.com/en/actions/reference/runners/github-hosted-runners"""
HOST = pattern(r"(?:[a-z0-9](?:[a-z0-9.-]*[a-z0-9])?|\[[0-9a-f:]+\])(?::\d{1,5})?", re.IGNORECASE)
COMPONENT = pattern(r"[a-z0-9]+(?:(?:\.|_|__|-+)[a-z0-9]+)*")
"""https://github.com/distribution/reference/blob/main/regexp.go"""
VARIANT = ("path", "config", "date", "kind", "distro", "build-tool", "cuda", "python", "tag-prefix", "tag-suffix")
"""Inputs that make variants of one image; each variant has its own cache and artifacts."""
LABEL = pattern(r"[A-Za-z0-9][A-Za-z0-9 ._:/=@+-]{0,255}")
LONGEST = 256
"""Most characters in a group's name."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Inputs:
    """What the caller asked for."""

    ref: str = ""
    """Commit, git tag or branch to build instead of the event's."""
    path: str = ""
    """Folder that is built as if it were the repository, ``""`` for all of it."""
    config: Named | None = None
    image: str | None = None
    """NAME or OWNER/NAME, in lower case."""
    push: Push = "auto"
    registry: str = "ghcr.io"
    username: str = ""
    cache: Cache = "auto"
    overrides: tuple[Override, ...] = ()
    """Keys of roslab.yaml that the inputs set; validated together with it to report all mistakes at once."""
    runners: tuple[tuple[str, Runner], ...] = ()
    """Platforms (or prefixes of their names) and the runner that builds them."""
    variant: str = ""
    """Text that distinguishes this call from others for the same image."""


def read(environment: Mapping[str, str]) -> Inputs:
    """Read ``INPUT_*``; an empty one counts as not given.

    Raises ``ConfigurationError`` with one problem for each wrong input.
    """
    asked, problems = gather(environment)
    if problems:
        raise ConfigurationError(*problems, *problems_of(asked.overrides))
    return asked


def gather(environment: Mapping[str, str]) -> tuple[Inputs, tuple[Problem, ...]]:
    """Return the inputs, and one problem for each wrong one that has no key in roslab.yaml; it has its default.

    ``overrides`` are validated later, with roslab.yaml, so that a caller can report all mistakes of both at once.
    """
    said = {
        name[6:].lower().replace("_", "-"): value.strip()
        for name, value in environment.items()
        if name.startswith("INPUT_")
    }
    problems: list[Problem] = []
    push = said.get("push", "").lower() or "auto"
    cache = said.get("cache", "").lower() or "auto"
    registry = (said.get("registry") or "ghcr.io").lower().removesuffix("/")
    if push not in PUSH:
        problems.append(_one_of("push", push, PUSH))
    if cache not in CACHE:
        problems.append(_one_of("cache", cache, CACHE))
    if not HOST.fullmatch(registry):
        hint = "write a host such as ghcr.io or registry.example.org:5000, without https://"
        problems.append(_wrong("registry", f"{printable(registry)!r} is no registry", hint))
    image, wrong_image = _image(said["image"], registry) if said.get("image") else (None, [])
    runners, wrong_runners = _runners(said.get("runners") or "{}")
    problems += [*wrong_image, *wrong_runners]
    overrides = tuple(
        Override(key=key, text=text, origin=Input(name=name))
        for name, key in SETTINGS.items()
        if (text := said.get(name))
    )
    wrong = {str(problem.origin.name) for problem in problems if isinstance(problem.origin, Input)}
    asked = Inputs(
        ref=said.get("ref", ""),
        path=part(environment),
        config=Named(path=path, origin=Input(name="config")) if (path := said.get("config")) else None,
        image=None if "image" in wrong else image,
        push="auto" if "push" in wrong else cast("Push", push),
        registry="ghcr.io" if "registry" in wrong else registry,
        username=said.get("username", ""),
        cache="auto" if "cache" in wrong else cast("Cache", cache),
        overrides=overrides,
        runners=runners,
        variant=json.dumps({name: said[name] for name in VARIANT if said.get(name)}),
    )
    return asked, tuple(problems)


def part(environment: Mapping[str, str]) -> str:
    """Return the input ``path`` in its simplest form: ``./robots/arm/`` becomes ``robots/arm``."""
    path = posixpath.normpath(environment.get("INPUT_PATH", "").strip() or ".")
    return "" if path == "." else path


def _one_of(name: str, value: str, allowed: tuple[str, ...]) -> Problem:
    return _wrong(name, f"{printable(value)!r} is not known", f"write {', '.join(allowed[:-1])} or {allowed[-1]}")


def _wrong(name: str, message: str, hint: str) -> Problem:
    return Problem(message=message, hint=hint, origin=Input(name=name))


def _image(said: str, registry: str) -> tuple[str, list[Problem]]:
    """Return the input ``image`` as NAME or OWNER/NAME, and its problems."""
    path = said.lower()
    host, slash, rest = path.partition("/")
    if slash and ("." in host or ":" in host or host == "localhost"):
        if host != registry:
            hint = f"set the input registry to {printable(host)}, or leave the host out of the image"
            return path, [_wrong("image", f"{printable(path)!r} is not on {printable(registry)}", hint)]
        path = rest
    if not all(COMPONENT.fullmatch(part) for part in path.split("/")):
        hint = "write NAME or OWNER/NAME without a tag: the tags follow from the event"
        return path, [_wrong("image", f"{printable(said)!r} is no image name", hint)]
    return path, []


def _runners(text: str) -> tuple[tuple[tuple[str, Runner], ...], list[Problem]]:
    """Read the runners; the workflow itself reads the keys ``plan`` and ``tag``, the jobs that build nothing."""
    hint = 'write JSON, for example {"linux/arm64": ["self-hosted", "arm64"], "plan": {"group": "small"}}'
    try:
        said = json.loads(text)
    except ValueError as error:
        return (), [_wrong("runners", f"no JSON: {error}", hint)]
    if not isinstance(said, dict):
        return (), [_wrong("runners", "no JSON object", hint)]
    found, problems = [], []
    for name, value in said.items():
        if not re.fullmatch(r"plan|tag|linux(/[a-z0-9]+){0,2}", name):
            problems.append(_wrong("runners", f"{printable(name)!r} is no platform, nor `plan` or `tag`", hint))
        elif not _is_runner(value):
            problems.append(_wrong("runners", f"{name} names no label, list of labels or group", hint))
        else:
            found.append((name, value))
    return tuple(found), problems


def _is_runner(value: Any) -> bool:
    """Return whether ``runs-on`` accepts a value according to the workflow syntax.

    https://docs.github.com/en/actions/reference/workflows-and-actions/workflow-syntax#jobsjob_idruns-on
    """
    if isinstance(value, dict):
        labels = value.get("labels", [])
        group = value.get("group", "")
        if not value or value.keys() - {"group", "labels"} or not isinstance(group, str) or len(group) > LONGEST:
            return False
        value = labels if isinstance(labels, list) else [labels]
    elif not value:
        return False
    labels = value if isinstance(value, list) else [value]
    return all(isinstance(label, str) and LABEL.fullmatch(label) for label in labels)


def runner(platform: str, runners: tuple[tuple[str, Runner], ...]) -> Runner:
    """Return what a platform's job runs on: the longest prefix of its name wins, the caller's before the defaults."""
    for known in (dict(runners), RUNNERS):
        fitting = [start for start in known if f"{platform}/".startswith(f"{start}/")]
        if fitting:
            return known[max(fitting, key=len)]
    return DEFAULT_RUNNER


def image(inputs: Inputs, *, owner: str, name: str) -> str:
    """Return the image's full name without a tag, ``ghcr.io/owner/name``, in lower case as registries require.

    ``owner`` is the repository's, ``name`` the plan's.
    """
    path = inputs.image or name
    return f"{inputs.registry}/{path if '/' in path else f'{image_name(owner)}/{path}'}"
