"""The channels of a conda environment: what its file lists as such and is none, and those that it does not name."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.decide.decision import Warning_
from roslab.decide.python.conda_alone import CondaAlone
from roslab.decide.python.image_python import Python
from roslab.decide.python.pins import DEVELOPMENT
from roslab.decide.reasons import warn
from roslab.evidence.conda_environment import CondaEnvironment
from roslab.evidence.facts import Evidence
from roslab.knowledge.channel_builds import channel_builds
from roslab.values.origin import Place
from roslab.values.pattern import pattern

_NO_CHANNEL = pattern(
    r"https?://(?:www\.)?anaconda\.org/[\w.-]+/(?!label/)[\w.-]+(?:/.*)?"  # the page of a package, or its download
    r"|https?://\S+(?:/download|\.(?:conda|tar\.(?:bz2|gz)|zip|whl))/?"
)
"""https://docs.conda.io/projects/conda/en/stable/user-guide/concepts/channels.html, read 2026-11-23."""

_DEFAULTS = "defaults"


def further_channels(evidence: Evidence, conda: str | None) -> tuple[str, ...]:
    """Return the channels of an environment that names none of its own: those of its page, and those of its builds.

    What conda exports as a list, or its author copied from an export, is without the channels that packages are of.
    """
    environment = next((each for each in evidence.conda if each.file == conda), None)
    if environment is None or (environment.channels and not _of_list(environment)):
        return ()
    folder = environment.file.rpartition("/")[0]
    said = (each for each in evidence.prose_pip if each.role == "channel" and not DEVELOPMENT.search(each.file))
    found = [each.written for each in said if each.file.rpartition("/")[0] in {"", folder}]
    listed = [package.written for package in environment.packages]
    found += (name for name, builds in channel_builds() if any(builds.fullmatch(each) for each in listed))
    return tuple(dict.fromkeys(each for each in found if each != _DEFAULTS))


def _of_list(environment: CondaEnvironment) -> bool:
    """Tell whether an environment is a list of packages, which the page has given no channels."""
    return environment.file.endswith(".txt") and environment.channels == (_DEFAULTS,)


def by_specs(evidence: Evidence, conda: str | None) -> CondaEnvironment | None:
    """Return an environment of which conda is given the packages by name: pixi's, or one of another system."""
    return next((each for each in evidence.conda if each.file == conda and (each.specs or each.on_linux)), None)


def by_name(environment: CondaEnvironment | None, alone: CondaAlone) -> tuple[str, ...]:
    """Return the channels of packages that are given by name; conda adds its own to a file that does not shut them out.

    Those of such an environment, else of what conda ``alone`` has.
    """
    if environment is None:
        return alone.channels
    added = () if environment.specs or {_DEFAULTS, "nodefaults"} & {*environment.channels} else (_DEFAULTS,)
    named = (each for each in environment.channels if each != "nodefaults" and not _NO_CHANNEL.fullmatch(each))
    return (*named, *added)


def no_channels(evidence: Evidence, conda: str | None) -> tuple[str, ...]:
    """Return the addresses of packages among the channels of a file: the build stops where no channel answers."""
    listed = (each for environment in evidence.conda if environment.file == conda for each in environment.channels)
    return tuple(dict.fromkeys(each for each in listed if _NO_CHANNEL.fullmatch(each)))


def in_brackets(evidence: Evidence, conda: str | None) -> bool:
    """Tell whether a list of a file, of which lines may have to be changed, stands in brackets: ``pip: [a, b]``."""
    changed = {"dependencies", "pip", *(["channels"] if no_channels(evidence, conda) else [])}
    return any(each.flow & changed for each in evidence.conda if each.file == conda)


def told(answer: Python, evidence: Evidence) -> Iterator[Warning_]:
    """Yield a warning for each that is left out, and for a file that was written on another system."""
    file = answer.conda_file or ""
    for each in evidence.conda:
        if each.file == file and each.on_linux:
            left = f"builds, the releases of libraries and what {each.system} alone has are left out"
            yield warn(f"{file} is of an environment on {each.system}: {left}", Place(file=file))
    for address in answer.conda_no_channels:
        message = f"{address} is no channel of conda: it is left out of {file}"
        yield warn(f"{message}; name the owner and the package there (owner::package)", Place(file=file))


def default_channels(evidence: Evidence, conda: str | None) -> bool:
    """Tell whether conda would add its default channels to those of the file.

    https://docs.conda.io/projects/conda/en/stable/user-guide/tasks/manage-environments.html, read 2026-11-21.
    """
    return any(not {"defaults", "nodefaults"} & {*each.channels} for each in evidence.conda if each.file == conda)
