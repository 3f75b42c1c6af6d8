"""Secrets of a build: where their values are on this machine, and the words by which BuildKit gets them.

A value is never a word of a command line: BuildKit reads it from a variable, a file or an agent.
https://docs.docker.com/reference/cli/docker/buildx/build/#secret
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path

from roslab.errors import ConfigurationError, Problem
from roslab.values.dataclass import dataclass
from roslab.values.secret import NETRC, SSH, variable


@dataclass(frozen=True, kw_only=True, slots=True)
class Secret:
    """A secret that is there."""

    name: str
    variable: str = ""
    """The variable of the environment that holds it."""
    file: str = ""
    """The file that holds it; of ``ssh`` a private key without a passphrase, ``""`` for the agent."""

    def words(self) -> list[str]:
        """Return the words of ``docker buildx build`` that hand it over."""
        if self.name == SSH:
            return ["--ssh", f"default={self.file}" if self.file else "default"]
        # The value is one field of a CSV line: a path may have a comma
        place = f"env={self.variable}" if self.variable else '"src={}"'.format(self.file.replace('"', '""'))
        return ["--secret", f"id={self.name},{place}"]


def of_environment(names: Sequence[str], environment: Mapping[str, str]) -> tuple[Secret, ...]:
    """Return the secrets of these names, each from where a user of this machine has it.

    Raises ``ConfigurationError`` with a problem for each that is missing, which says how to give it.
    """
    found, problems = [], []
    for name in names:
        given = _find(name, environment)
        if isinstance(given, Problem):
            problems.append(given)
        else:
            found.append(given)
    if problems:
        raise ConfigurationError(*problems)
    return tuple(found)


def _find(name: str, environment: Mapping[str, str]) -> Secret | Problem:
    if name == SSH:
        if environment.get("SSH_AUTH_SOCK"):
            return Secret(name=name)
        return _missing(name, "start an agent and add your key: `eval $(ssh-agent)`, then `ssh-add`")
    if name == NETRC:
        file = environment.get("NETRC") or str(Path(environment.get("HOME") or "/") / ".netrc")
        return Secret(name=name, file=file) if Path(file).is_file() else _missing(name, f"there is no file {file}; "
            "the variable NETRC names another")  # fmt: skip
    word = variable(name)
    if environment.get(word):
        return Secret(name=name, variable=word)
    file = environment.get(f"{word}_FILE", "")
    if file and Path(file).is_file():
        return Secret(name=name, file=file)
    return _missing(name, f"set the variable {word} to its value, or {word}_FILE to a file that holds it")


def _missing(name: str, hint: str) -> Problem:
    return Problem(message=f"roslab.yaml names the secret {name}, which is not there", hint=hint)
