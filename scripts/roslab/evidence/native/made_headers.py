"""Headers that the sources of a setup.py include, which a licensed program makes and the tree does not have."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from roslab.evidence.facts import Mention
from roslab.evidence.lex.includes import includes
from roslab.evidence.native.extension_code import compiled
from roslab.evidence.native.limits import conditional
from roslab.evidence.python_project import PythonProject
from roslab.repository.checkout import Repository

_COMPILES = frozenset({"c", "cython", "cuda"})


def read(repository: Repository, projects: Iterable[PythonProject]) -> Iterator[Mention]:
    """Yield for each such script the first include of every header, with the program that makes it (``text``).

    None that the script itself names: it may make or fetch it.
    """
    scripts = {p.file: p.folder for p in projects if _COMPILES & {*p.extensions} and p.file.endswith("setup.py")}
    for script, folder in scripts.items():
        yield from _of(repository, script, folder, {*scripts.values()})


def _of(repository: Repository, script: str, folder: str, folders: set[str]) -> Iterator[Mention]:
    from roslab.knowledge.made_headers import made_by  # noqa: PLC0415 - few trees compile for Python

    text, seen = repository.read(script), set[str]()
    for path, code in compiled(repository, text, folder, folders):
        for match in includes(code):
            name = match[1].rpartition("/")[2]
            tool = made_by(name) if name not in seen and name not in text else None
            if tool is None or repository.named(name) or conditional(code, match.start(1)):
                continue
            seen.add(name)
            yield Mention(
                topic="made_header",
                value=name,
                source="code",
                file=path,
                line=code.count("\n", 0, match.start(1)) + 1,
                text=tool,
                inside=folder,
            )
