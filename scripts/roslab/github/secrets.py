"""Secrets of a build on a runner: read from one text, kept in private files for as long as the build needs them.

The text is the input ``secrets`` of the action, or the secret ``build-secrets`` of a workflow:

    pip_index=https://robot:PASSWORD@pypi.example.org/simple
    ssh=-----BEGIN OPENSSH PRIVATE KEY-----
    …
    registry:docker.io=robot:PASSWORD

A value goes on until the next line that begins with a name of roslab.yaml or with ``registry:``, so that a key or a
.netrc needs no quotes.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from pathlib import Path

from roslab.engine.client import login
from roslab.engine.secrets import Secret
from roslab.errors import ConfigurationError, Problem, RefusedError
from roslab.github import workflow
from roslab.github.access import OWN
from roslab.github.event import Event
from roslab.github.inputs import HOST
from roslab.github.run import Folder, Run
from roslab.values.dataclass import dataclass, field
from roslab.values.pattern import pattern
from roslab.values.secret import PIP_INDEX, SSH, variable

FOLDER = "secrets"
"""Below the folder of the run; the last step of a job removes it."""
_NAME = pattern(r"(?P<name>[A-Za-z][\w-]*)=")
_REGISTRY = pattern(r"registry:(?P<host>[^\s=]+)=(?P<username>[^\s:]*):?(?P<password>\S*)\s*")
SHORTEST = 6
"""Fewest characters that are hidden in a log: a shorter word would hide others."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Login:
    """A login at a registry that base images are pulled from."""

    host: str
    username: str
    password: str = field(repr=False)


@dataclass(frozen=True, kw_only=True, slots=True)
class Given:
    """What the caller handed over; an empty value counts as not given."""

    values: Mapping[str, str] = field(repr=False)
    """Values by their names in roslab.yaml."""
    logins: tuple[Login, ...]


def read(text: str, names: Sequence[str]) -> Given:
    """Read the text; ``names`` are those in roslab.yaml, found also in capitals and with ``_`` for ``-``.

    Raises ``ConfigurationError``, without any part of a value, for a line that belongs to nothing.
    """
    known = {variable(name): name for name in names}
    values: dict[str, list[str]] = {}
    logins, problems = [], []
    lines: list[str] | None = None
    for number, line in enumerate(text.replace("\r\n", "\n").split("\n"), start=1):
        match = _NAME.match(line)
        if match and variable(match["name"]) in known:
            lines = values.setdefault(known[variable(match["name"])], [])
            lines.append(line[match.end() :])
        elif line.startswith("registry:"):
            found = _REGISTRY.fullmatch(line)
            if found and HOST.fullmatch(found["host"]):
                logins.append(Login(host=found["host"], username=found["username"], password=found["password"]))
            else:
                problems.append(_wrong(number, "is no login", "write registry:HOST=USER:PASSWORD"))
            lines = None
        elif lines is not None:
            lines.append(line)
        elif line.strip():
            hint = f"roslab.yaml names {', '.join(names)}" if names else "roslab.yaml names none under `secrets`"
            problems.append(_wrong(number, "belongs to no secret", f"write NAME=VALUE; {hint}"))
    joined = {name: "\n".join(lines).strip() for name, lines in values.items()}
    if "\n" in joined.get(PIP_INDEX, ""):
        problems.append(Problem(message=f"the secret {PIP_INDEX} has several lines", hint="write its URL on one line"))
    if problems:
        raise ConfigurationError(*problems)
    return Given(values={name: value for name, value in joined.items() if value}, logins=tuple(logins))


def _wrong(number: int, what: str, hint: str) -> Problem:
    return Problem(message=f"line {number} of the secrets {what}", hint=hint)


def prepare(folder: Folder, run: Run, what: Event, environment: Mapping[str, str], client: Path) -> None:
    """Keep the secrets for the build, log in at the registries of base images, and hide all of it in the log.

    ``client`` is docker's private folder. What is missing stops the run, or, where the event cannot have secrets, gives
    a warning. Raises ``ConfigurationError``, ``RefusedError`` or ``BuildError``.
    """
    given = read(environment.get("ROSLAB_SECRETS", ""), run.plan.secrets)
    for word in _hidden(given):
        workflow.mask(word)
    own = environment.get("ROSLAB_GITHUB_TOKEN", "")
    for each in given.logins:
        if own and each.password == own and each.host != OWN:
            message = f"refused: the run's own token is sent to {OWN} alone, not to {each.host}"
            raise RefusedError(Problem(message=message, hint=f"give registry:{each.host} a password of its own"))
    _require(given, run, what, environment)
    place = folder.path / FOLDER
    place.mkdir(mode=0o700)
    for name, value in given.values.items():
        file = place / name
        file.touch(mode=0o600)
        # Keys and .netrc are text files, which end with a line break; a bare value has none
        file.write_text(value + ("\n" if name == SSH or "\n" in value else ""), encoding="utf-8")
    for each in given.logins:
        if run.push and each.host == run.registry:
            message = f"the login registry:{each.host} is not used: the image is pushed there by another"
            workflow.warn(Problem(message=message, hint="give that one the right to read the base image too"))
        elif each.username and each.password:
            login(client, each.host, each.username, each.password)


def held(folder: Folder, run: Run, environment: Mapping[str, str]) -> tuple[Secret, ...]:
    """Return the secrets that this job has for its build, in the order of roslab.yaml."""
    place = folder.path / FOLDER
    found = [Secret(name=name, file=str(place / name)) for name in run.plan.secrets if (place / name).is_file()]
    if SSH in run.plan.secrets and not (place / SSH).is_file() and environment.get("SSH_AUTH_SOCK"):
        found.append(Secret(name=SSH))  # an earlier step of the job started an agent
    return tuple(found)


def outputs(secrets: Sequence[Secret]) -> dict[str, str]:
    """Return the inputs of docker/build-push-action that hand the secrets over."""
    return {
        "secret-files": "\n".join(f"{each.name}={each.file}" for each in secrets if each.name != SSH),
        "ssh": "\n".join(each.words()[1] for each in secrets if each.name == SSH),
    }


def _require(given: Given, run: Run, what: Event, environment: Mapping[str, str]) -> None:
    """Raise ``ConfigurationError`` for each missing secret; of a run that can have none, warn."""
    agent = bool(environment.get("SSH_AUTH_SOCK"))
    missing = [name for name in run.plan.secrets if name not in given.values and not (name == SSH and agent)]
    empty = [each.host for each in given.logins if not (each.username and each.password)]
    problems = [
        *(
            Problem(message=f"roslab.yaml names the secret {name}, which is not there", hint=_how(name))
            for name in missing
        ),
        *(Problem(message=f"the login registry:{host} has no user or no password", hint=_set()) for host in empty),
    ]
    if not problems:
        return
    if not withheld(what):
        raise ConfigurationError(*problems)
    who = "Dependabot's run" if what.actor == DEPENDABOT else "a pull request from a fork"
    named = ", ".join([*missing, *(f"registry:{host}" for host in empty)])
    hint = "the build goes on: layers that the cache has need none, and a step that needs one fails"
    workflow.warn(Problem(message=f"{who} gets no secrets, so {named} is missing", hint=hint))


DEPENDABOT = "dependabot[bot]"


def withheld(what: Event) -> bool:
    """Return whether GitHub gives the run no secrets of the repository.

    https://docs.github.com/en/actions/how-tos/write-workflows/choose-what-workflows-do/use-secrets
    """
    return what.foreign or what.actor == DEPENDABOT


def _how(name: str) -> str:
    line = f"{name}=${{{{ secrets.{variable(name)} }}}}"
    return f"give the action's input `secrets`, or a workflow's secret `build-secrets`, a line `{line}`; {_set()}"


def _set() -> str:
    return "an empty one is not set in the repository's settings, under Secrets and variables"


def _hidden(given: Given) -> list[str]:
    """Return the words to hide in the log: a runner knows a caller's secrets, but not the parts of a text."""
    words = [each.password for each in given.logins]
    for value in given.values.values():
        words += [line.strip() for line in value.split("\n")]
        words += re.findall(r"//[^/@\s:]*:([^/@\s]+)@", value) + re.findall(r"\bpassword\s+(\S+)", value)
    return [word for word in dict.fromkeys(words) if len(word) >= SHORTEST]
