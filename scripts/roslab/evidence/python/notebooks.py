"""Jupyter notebooks: the Python in their code cells.

They are read as JSON, since nbformat validates a whole notebook against its schema before returning it.
https://nbformat.readthedocs.io/en/latest/format_description.html
"""

from __future__ import annotations

import json
from collections.abc import Iterator
from typing import Any


def imports(text: str) -> Iterator[tuple[int, str]]:
    """Yield ``(line of the file, line of code)`` for the lines of code cells that begin with an import.

    Nothing if the text is no notebook, or a notebook in another language.
    """
    try:
        notebook = json.loads(text)
    except (ValueError, RecursionError):
        return
    if not isinstance(notebook, dict) or _language(notebook) != "python":
        return
    position, number = 0, 1
    for code in _code(notebook):
        if code.startswith(("import ", "from ")):
            found = text.find(code, position)
            if found >= 0:  # otherwise it is escaped, and the line of the import before it is used
                number += text.count("\n", position, found)
                position = found
            yield number, code


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
