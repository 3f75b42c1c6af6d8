"""conda environment files."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable

from roslab.evidence.conda_environment import CondaEnvironment
from roslab.evidence.python import conda_content, conda_system
from roslab.repository.checkout import File, Repository
from roslab.values.conda import conda_package, named_python
from roslab.values.pattern import pattern
from roslab.values.requirement import Requirement
from roslab.values.requirement_line import requirement

_NAME = pattern(
    r"^(?:.*[-_.])?(?:conda|env|environment|mamba|robostack)(?:[-_.\d].*)?\.ya?ml$|^conda.*\.ya?ml$|^env\w*\.ya?ml$"
)
_LIST = pattern(r"require|depend|conda|env|spec|package|pip|freeze")
"""A word in the name of a list that conda may have written."""
_SHAPE = pattern(r"^dependencies\s*:", re.MULTILINE)
_FLOW = pattern(
    r"^(?:(channels|dependencies) *:|[ ]*- *(?:\{ *)?(pip) *:)(?:[ \t]*(?:#.*)?\r?\n)*[ \t]*\[", re.MULTILINE
)
"""A list in brackets, as the image's script unfolds it."""
_OPTIONS = ("-f ", "-i ", "--extra-index-url", "--find-links", "--index-url")
_FOLDER = pattern(r"(?:(?:-e|--editable)\s+)?((?:\.{1,2}|[\w.-]+/)(?:[\w.-]+/?)*|\./?[\w./-]*)(?:\[[\w,-]+\])?")
"""A folder of the tree: ``-e .``, ``submodules/simple-knn``."""
MAX_SIZE = 256 * 1024


def read(repository: Repository, asked: Iterable[Requirement] = ()) -> tuple[CondaEnvironment, ...]:
    """Return every conda environment of the tree, sorted by path.

    Files have its usual names, or are asked, or hold what only an environment does, or are lists that conda wrote.
    ``asked`` is what pages ask for: a file of any name that one gives conda is an environment.
    """
    asked = tuple(asked)
    given = {each.written.rpartition("/")[2]: each for each in asked if each.role == "environment"}
    found: list[CondaEnvironment | None] = []
    for file in sorted(repository.suffixed(".yml", ".yaml", ".txt"), key=lambda file: file.path):
        said = given.get(file.name)
        if file.name.endswith(".txt"):
            if said or _LIST.search(file.name.lower()):
                found.append(_list(repository, file, said, asked))
        elif said or usually_named(file.path):
            found.append(_environment(repository, file))
        elif conda_content.looked_at(file):
            found.append(_environment(repository, file, by_content=True))
    return tuple(environment for environment in found if environment)


def _list(
    repository: Repository, file: File, said: Requirement | None, asked: Iterable[Requirement]
) -> CondaEnvironment | None:
    """Read a list of packages, with the channels of the command that names it."""
    from roslab.evidence.python import conda_list  # noqa: PLC0415 - few trees have one

    text = repository.read(file, limit=MAX_SIZE)
    if not (said or conda_list.exported(text)):
        return None
    place = (said.file, said.line) if said else None
    channels = [each.written for each in asked if each.role == "channel" and (each.file, each.line) == place]
    return conda_list.parse(text, file.path, channels)


def usually_named(path: str) -> bool:
    """Tell whether a file has a name that environments have: ``environment.yml``, ``conda_gpu.yaml``."""
    return bool(_NAME.match(path.rpartition("/")[2].lower()))


def _environment(repository: Repository, file: File, *, by_content: bool = False) -> CondaEnvironment | None:
    from roslab.evidence.lex.yaml import load  # noqa: PLC0415 - few trees have one

    text = repository.read(file, limit=MAX_SIZE)
    if not _SHAPE.search(text) or (by_content and not conda_content.shaped(text)):
        return None
    data = load(text)
    if by_content and not conda_content.is_environment(data):
        return None
    entries = data.get("dependencies") if isinstance(data, dict) else None
    if not isinstance(entries, list):
        return None
    line_of = _lines_of(text)
    named = (conda_package(entry) for entry in entries if isinstance(entry, str))
    packages = tuple(package for package in named if package)
    inner = [entry["pip"] for entry in entries if isinstance(entry, dict) and isinstance(entry.get("pip"), list)]
    items = [item for listed in inner for item in listed if isinstance(item, str)]
    pip = [found for item in items if (found := _item(item, file.path, line_of(item)))]
    name, channels = data.get("name"), data.get("channels")
    system = conda_system.system_of(text, packages)
    return CondaEnvironment(
        file=file.path,
        line=1,
        name=name if isinstance(name, str) else None,
        python=named_python(packages),
        packages=packages,
        requirements=tuple(pip),
        system=system,
        on_linux=conda_system.as_on_linux(packages, system),
        flow=frozenset(first or second for first, second in _FLOW.findall(text)),
        channels=tuple(each for each in channels if isinstance(each, str)) if isinstance(channels, list) else (),
    )


def _lines_of(text: str) -> Callable[[str], int]:
    """Return what tells the line of an entry: that where it stands alone, else the first that holds it."""
    lines = text.split("\n")
    alone: dict[str, int] = {}
    for number, line in enumerate(lines, 1):
        alone.setdefault(line.strip().removeprefix("- ").partition(" #")[0].strip(" \"'"), number)

    def line_of(entry: str) -> int:
        holding = (number for number, line in enumerate(lines, 1) if entry in line)
        return alone.get(entry) or next(holding, 1)

    return line_of


def _item(item: str, path: str, line: int) -> Requirement | None:
    """Read one entry of the ``pip:`` part: a file, an option, a requirement."""
    if item.startswith(("-r ", "--requirement ")):
        written = item.rsplit(maxsplit=1)[-1]
        return Requirement(name="", written=written, origin="conda", role="file", file=path, line=line)
    if folder := _FOLDER.fullmatch(item):
        written = folder[1].removeprefix("./").rstrip("/") or "."
        return Requirement(name="", written=written, origin="conda", role="project", file=path, line=line)
    if item.startswith(_OPTIONS):
        return Requirement(name="", written=item, origin="conda", role="option", file=path, line=line)
    return requirement(item.split(" #", maxsplit=1)[0].strip(), "conda", path, line)
