"""What a conda file lists as its channels and is none."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.decide.decision import Warning_
from roslab.decide.python.image_python import Python
from roslab.decide.reasons import warn
from roslab.evidence.facts import Evidence
from roslab.values.origin import Place
from roslab.values.pattern import pattern

_NO_CHANNEL = pattern(
    r"https?://(?:www\.)?anaconda\.org/[\w.-]+/(?!label/)[\w.-]+(?:/.*)?"  # the page of a package, or its download
    r"|https?://\S+(?:/download|\.(?:conda|tar\.(?:bz2|gz)|zip|whl))/?"
)
"""https://docs.conda.io/projects/conda/en/stable/user-guide/concepts/channels.html, read 2026-11-23."""


def no_channels(evidence: Evidence, conda: str | None) -> tuple[str, ...]:
    """Return the addresses of packages among the channels of a file: the build stops where no channel answers."""
    listed = (each for environment in evidence.conda if environment.file == conda for each in environment.channels)
    return tuple(dict.fromkeys(each for each in listed if _NO_CHANNEL.fullmatch(each)))


def told(answer: Python) -> Iterator[Warning_]:
    """Yield a warning for each that is left out."""
    file = answer.conda_file or ""
    for address in answer.conda_no_channels:
        message = f"{address} is no channel of conda: it is left out of {file}"
        yield warn(f"{message}; name the owner and the package there (owner::package)", Place(file=file))


def default_channels(evidence: Evidence, conda: str | None) -> bool:
    """Tell whether conda would add its default channels to those of the file.

    https://docs.conda.io/projects/conda/en/stable/user-guide/tasks/manage-environments.html, read 2026-11-21.
    """
    return any(not {"defaults", "nodefaults"} & {*each.channels} for each in evidence.conda if each.file == conda)
