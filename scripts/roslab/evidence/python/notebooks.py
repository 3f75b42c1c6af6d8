"""Jupyter notebooks: the Python in their code cells, and what these install.

They are read as JSON, since nbformat validates a whole notebook against its schema before returning it.
https://nbformat.readthedocs.io/en/latest/format_description.html
"""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator
from typing import Any

from roslab.evidence import places
from roslab.repository.checkout import File, Repository, nearest
from roslab.values.pattern import pattern

MAX_SIZE = 8 * 1024 * 1024
LARGE = 1024 * 1024
"""From this size on, most of a notebook is the pictures that it once printed."""
MAX_FILES = 50
MAX_LARGE = 4
_INSTALL = pattern(
    r"\s*[!%]\s*((?:sudo\s+)?(?:python[\d.]*\s+-m\s+pip|pip[23]?|apt|apt-get|conda|mamba)\s+.*\binstall\s.*)"
)
"""A line that IPython gives to the shell, or to a tool by its own word for it.
https://ipython.readthedocs.io/en/stable/interactive/magics.html"""
_NEXT = pattern(r"(?<=\S)\s+(?=[!%]\s{0,3}(?:sudo\s+)?(?:python[\d.]*\s+-m\s+pip|pip[23]?|apt|apt-get|conda|mamba)\s)")
"""Where a second one begins in a line: the break between two was lost."""


def files(repository: Repository) -> list[File]:
    """Return the notebooks that are opened, those nearest to the root first; of large ones a few."""
    found = (file for file in repository.suffixed(".ipynb") if file.size < MAX_SIZE and not places.vendored(file.path))
    kept = nearest(found)
    large = [file for file in kept if file.size >= LARGE][MAX_LARGE:]
    return [file for file in kept if file not in large][:MAX_FILES]


def alone(repository: Repository) -> tuple[str, ...]:
    """Return the notebooks in Python of a tree that has no other Python at its root, nearest to the root first."""
    return repository.once(_alone)


def _alone(repository: Repository) -> tuple[str, ...]:
    if any("/" not in file.path for file in repository.suffixed(".py")):
        return ()
    return tuple(file.path for file in files(repository) if _of_python(repository.read(file, limit=MAX_SIZE)))


def _of_python(text: str) -> bool:
    notebook = _parsed(text)
    return notebook is not None and _language(notebook) == "python"


def imports(text: str) -> Iterator[tuple[int, str]]:
    """Yield ``(line of the file, line of code)`` for the lines of code cells that begin with an import.

    Nothing if the text is no notebook, or a notebook in another language.
    """
    return _lines(text, lambda code: code if code.startswith(("import ", "from ")) else None)


def installs(text: str) -> Iterator[tuple[int, str]]:
    """Yield ``(line of the file, command)`` for the lines that install something: ``!pip install ikpy``."""
    if "install" not in text:
        return iter(())
    return _lines(text, _install)


def _install(code: str) -> str | None:
    said = [match[1] for each in _NEXT.split(code) if (match := _INSTALL.match(each))]
    return " && ".join(said) if said and _INSTALL.match(code) else None


def _lines(text: str, wanted: Callable[[str], str | None]) -> Iterator[tuple[int, str]]:
    notebook = _parsed(text)
    if notebook is None or _language(notebook) != "python":
        return
    position, number = 0, 1
    for code in _code(notebook):
        if (kept := wanted(code)) is not None:
            found = text.find(code, position)
            if found >= 0:  # otherwise it is escaped, and the line of the one before it is used
                number += text.count("\n", position, found)
                position = found
            yield number, kept


def _parsed(text: str) -> dict[str, Any] | None:
    try:
        notebook = json.loads(text)
    except (ValueError, RecursionError):
        return None
    return notebook if isinstance(notebook, dict) else None


def _code(notebook: dict[str, Any]) -> Iterator[str]:
    sheets = notebook.get("worksheets")  # format 3 and older
    for holder in (notebook, *(sheets if isinstance(sheets, list) else ())):
        cells = holder.get("cells") if isinstance(holder, dict) else None
        for cell in cells if isinstance(cells, list) else ():
            if isinstance(cell, dict) and cell.get("cell_type") == "code":
                source = cell.get("source", cell.get("input"))
                whole = "".join(map(str, source)) if isinstance(source, list) else source
                if isinstance(whole, str):
                    yield from whole.splitlines()


def _language(notebook: dict[str, Any]) -> str:
    """Return the language of the cells, Python if the notebook does not say."""
    metadata = notebook.get("metadata")
    for name, key in (("language_info", "name"), ("kernelspec", "language")):
        said = metadata.get(name) if isinstance(metadata, dict) else None
        if isinstance(said, dict) and isinstance(said.get(key), str):
            return str(said[key]).lower()
    return "python"
