"""Jupyter notebooks: the Python in their code cells.

They are read as JSON, since nbformat validates a whole notebook against its schema before returning it.
https://nbformat.readthedocs.io/en/latest/format_description.html
"""

from __future__ import annotations

import json
from collections.abc import Iterator
from typing import Any

from roslab.evidence import places
from roslab.repository.checkout import File, Repository, nearest

MAX_SIZE = 1024 * 1024
MAX_FILES = 50


def files(repository: Repository) -> list[File]:
    """Return the notebooks that are opened, those nearest to the root first."""
    kept = [file for file in repository.suffixed(".ipynb") if not places.vendored(file.path) and file.size < MAX_SIZE]
    return nearest(kept)[:MAX_FILES]


def alone(repository: Repository) -> tuple[str, ...]:
    """Return the notebooks in Python of a tree that has no other Python at its root, nearest to the root first."""
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
    notebook = _parsed(text)
    if notebook is None or _language(notebook) != "python":
        return
    position, number = 0, 1
    for code in _code(notebook):
        if code.startswith(("import ", "from ")):
            found = text.find(code, position)
            if found >= 0:  # otherwise it is escaped, and the line of the import before it is used
                number += text.count("\n", position, found)
                position = found
            yield number, code


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
