"""Files that a module of Python opens as soon as it is imported, and that the tree does not have."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping

from roslab.evidence.facts import Mention
from roslab.evidence.lex.lines import matching_lines
from roslab.evidence.python.modules import modules
from roslab.evidence.python.statements import statements
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

_OPENS = pattern(
    r"(?:with\s+|\w+\s*=\s*(?:json\.load\(|yaml\.\w+\()?)open\(\s*[\"']((?:[\w-]+/)*[\w-]+\.[\w.]{1,12})[\"']"
    r"\s*(?:,\s*(?:mode\s*=\s*)?[\"']r[bt]?[\"']\s*)?(?:,\s*encoding\s*=\s*[\"'][\w-]+[\"']\s*)?\)"
)
"""At the beginning of a line, so under no condition, and to read."""
_QUOTES = pattern(r"\"\"\"|'''")
MOST = 5


def read(repository: Repository) -> Iterator[Mention]:
    """Yield each such file at the first place that opens it; ``files`` are the modules that import that one, and it.

    Not what the text of another module names as well: it may write the file.
    """
    opening: dict[str, tuple[str, int]] = {}
    for module in modules(repository):
        for found in matching_lines(_OPENS, module.text, "open("):
            name = found[1].rpartition("/")[2]
            shown = len(_QUOTES.findall(module.text, 0, found.start())) % 2  # in a longer string, such as a docstring
            got = re.search(rf"[/ ]{re.escape(name)}[\"']", module.text[: found.start()])  # of an address, a command
            if not repository.named(name) and not shown and not got and len(opening) < MOST:
                opening.setdefault(found[1], (module.file.path, module.text.count("\n", 0, found.start()) + 1))
    texts = {module.file.path: module.text for module in modules(repository)} if opening else {}
    for path, (file, line) in opening.items():
        writes = (text for text in texts.values() if path in text)
        if not any(re.search(r"[\"'][wax]\+?b?[\"']|\bdump\(|\bsave\w*\(", text) for text in writes):
            files = tuple(_importing(file, texts))
            yield Mention(
                topic="opened", value=path, source="code", file=file, line=line, text=f"open {path}", files=files
            )


def _importing(file: str, texts: Mapping[str, str]) -> Iterator[str]:
    """Yield a module and those that import it at their top by its whole name, and these in turn."""
    by_name: dict[str, list[str]] = {}
    for path, text in texts.items():
        for match in statements(text):
            if not match["indent"] and match["module"]:
                by_name.setdefault(match["module"], []).append(path)
    found = [file]
    for each in found:
        yield each
        name = each.removesuffix(".py").removesuffix("/__init__").replace("/", ".")
        found += [path for path in by_name.get(name, ()) if path not in found]
