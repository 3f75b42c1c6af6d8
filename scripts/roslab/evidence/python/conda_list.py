"""Lists of packages that ``conda create --file`` reads, as ``conda list --export`` writes them.

https://docs.conda.io/projects/conda/en/stable/commands/create.html and …/commands/list.html, read 2026-11-23.
"""

from __future__ import annotations

import re
from collections.abc import Sequence

from roslab.evidence.conda_environment import CondaEnvironment
from roslab.values.conda import CondaPackage, conda_package, named_python
from roslab.values.pattern import pattern
from roslab.values.requirement import Requirement
from roslab.values.requirement_line import stated

_OF_CONDA = pattern(r"^(?:@EXPLICIT\b|#\s*\$ conda create|[A-Za-z_][\w.-]*=\d)")
"""A line that no list of pip's has: pip compares by two signs."""
_FILE = pattern(r"https?://\S+/(?P<name>[\w.-]+)-(?P<version>[^-/\s]+)-[^-/\s]+\.(?:tar\.bz2|conda)(?:#\w+)?$")
_BY_PIP = "pypi"
"""The first letters of the build string of what pip had installed; conda has no such package."""
_EXPLICIT = "@EXPLICIT"
_WRITTEN = pattern(r"^#\s*(?:\$ conda create\b|platform:\s*\w+-\w+)", re.MULTILINE)
_ELSEWHERE = pattern(r"^#\s*platform:(?!\s*linux-)", re.MULTILINE)
_HEAD = 400
"""How many characters the first comments have at most."""


def exported(text: str) -> bool:
    """Tell whether conda itself wrote a list, whatever its file is called: it says so in its first lines."""
    return bool(_WRITTEN.search(text[:_HEAD])) and any(_OF_CONDA.match(line) for line in text.split("\n"))


def of_pip(line: str) -> str:
    """Return what pip had installed of a line of such a list, ``""`` for a package of conda's."""
    package = conda_package(line)
    return f"{package.name}=={package.version}" if package and package.build.startswith(_BY_PIP) else ""


def parse(text: str, path: str, channels: Sequence[str]) -> CondaEnvironment | None:
    """Return the environment of a list, ``None`` if it is no list of conda's; ``channels`` are those of the page.

    A list of files (``@EXPLICIT``) is installed as it stands, of any other the lines are.
    """
    lines = text.split("\n")
    if not any(_OF_CONDA.match(line) for line in lines):
        return None
    found = [(number, line.strip()) for number, line in enumerate(lines, 1) if line.strip() and line.strip()[0] != "#"]
    explicit = any(line == _EXPLICIT for _, line in found)
    packages: list[CondaPackage] = []
    pip: list[Requirement] = []
    for number, line in found:
        match = _FILE.match(line) if explicit else None
        package = conda_package(f"{match['name']}={match['version']}" if match else line)
        if package is None or line == _EXPLICIT:
            continue
        if pinned := of_pip(package.written):
            pip.append(stated(pinned, "conda", path, number))
        else:
            packages.append(package)
    return CondaEnvironment(
        file=path,
        line=1,
        name=None,
        python=named_python(packages),
        packages=tuple(packages),
        requirements=tuple(pip),
        channels=tuple(channels) or ("defaults",),
        exported=exported(text) and not _ELSEWHERE.search(text[:_HEAD]),
        specs=() if explicit else tuple(package.written for package in packages),
    )
