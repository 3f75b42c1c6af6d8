"""Converts an old roslab.yaml to today's format, for the same image and with its comments.

The text itself is edited, key by key, because libraries that keep comments do not keep the layout. Afterwards the
result is read and compared with the original; if they differ, a new file is written from the model.
"""

from __future__ import annotations

import re

from roslab.config import written
from roslab.config.document import parse
from roslab.config.edit import Edits, flow_list, is_text, quoted
from roslab.config.generation import NAMES
from roslab.config.model import Config, Generation
from roslab.config.node import Mapping, Node, Scalar, Sequence, in_file
from roslab.config.reader import mapping_of, read
from roslab.config.reading import Reading, Text
from roslab.config.source import clone
from roslab.errors import ConfigurationError
from roslab.values.dataclass import dataclass, replace

_RENAMED: dict[Generation, dict[str, str]] = {
    "paper": {"packages": "apt", "python-packages": "pip2", "repos": "repo"},
    "interim": {
        "apt-packages": "apt",
        "pip-packages": "pip2",
        "pip3-packages": "pip3",
        "source-packages": "source",
    },
    "later": {"pip": "pip2"},
    "today": {},
}


@dataclass(frozen=True, kw_only=True, slots=True)
class Migration:
    """The text in today's format, and one line for each change; there is none if it already was in today's format."""

    text: str
    changes: tuple[str, ...]


def migrate(text: str | bytes, *, file: str = "roslab.yaml") -> Migration:
    """Return a file of any format in today's format.

    Raises ``ConfigurationError`` if the file is wrong: only a file that was understood can be rewritten.
    """
    config = read(text, file=file)
    text = (text.decode("utf-8", errors="replace") if isinstance(text, bytes) else text).removeprefix("\ufeff")
    if config.generation == "today":
        return Migration(text=text, changes=())
    edits = Edits(text=text)
    _edit(edits, mapping_of(parse(text, file=file)), config)
    result = edits.applied()
    try:
        if comparable(read(result, file=file)) == comparable(config):
            return Migration(text=result, changes=tuple(edits.changes))
    except ConfigurationError:
        pass  # an edit failed because the layout is unusual
    head = re.match(r"(?:[ \t]*(?:#[^\n]*)?\r?\n)*", text)
    result = (head[0] if head else "") + written.written(config)
    return Migration(text=result, changes=(*edits.changes, "written anew: comments below the first key are lost"))


def comparable(config: Config) -> Config:
    """Return a configuration without the parts that do not affect its image: format, places and warnings."""
    sources = tuple(replace(source, place=None) for source in config.source)
    return replace(config, generation="today", file=None, origins=(), warnings=(), source=sources)


def _edit(edits: Edits, root: Mapping, config: Config) -> None:
    generation = config.generation
    _head(edits, root, config)
    if generation == "paper":
        _paper(edits, root, config)
    if generation == "interim":
        _interim_base(edits, root, config)
    for old, new in _RENAMED[generation].items():
        if new != "pip2" or config.pip_python == "2":
            edits.rename(root, old, new)
    name = root.get("name")
    if isinstance(name, Scalar) and config.name and name.text.strip() != config.name:
        edits.value(name, config.name, f"the name becomes `{config.name}`, in lower case")
    base = root.get("base")
    ubuntu = base.get("ubuntu") if isinstance(base, Mapping) else None
    if isinstance(ubuntu, Scalar) and ubuntu.text == "melodic":
        edits.value(ubuntu, "bionic", "`ubuntu: melodic` becomes `ubuntu: bionic`")
    for key, values in (("repo", config.repositories), ("apt", config.apt)):
        _list(edits, root, next((o for o, n in _RENAMED[generation].items() if n == key), key), values)
    for key in ("source", "source-packages"):
        _sources(edits, root.get(key))
    _volumes(edits, root.get("volume"))
    _custom(edits, root, config)


def _head(edits: Edits, root: Mapping, config: Config) -> None:
    """Write ``format: 3`` first, and then what the old format did by default."""
    lines = ["format: 3"]
    edits.changes.append("new: `format: 3`, the mark of a file of today")
    if config.compatible:
        lines.append(f"compatible: {config.compatible}")
        edits.changes.append(
            f"new: `compatible: {config.compatible}`, as before: what the file names is installed, old paths work; "
            "take it out for today's way"
        )
    if "notebook" not in root.names:
        lines.append("notebook: true")
        edits.changes.append("new: `notebook: true`, as every image of the old formats held JupyterLab")
    for name, value in (("gpu", config.gpu), ("gui", config.gui)):
        if value and name not in root.names and "runtime" not in root.names:
            lines.append(f"{name}: true")
            edits.changes.append(
                f"new: `{name}: true`, as the old run script gave the container the GPU and the display"
            )
    if config.build and "build" not in root.names:
        lines.append(f"build: {config.build}")
        edits.changes.append(f"new: `build: {config.build}`, as {NAMES[config.generation]} did where nothing was said")
    first = root.pairs[0][0]
    separator = edits.separator(root, first)
    edits.put(first.start.index, first.start.index, "".join(line + separator for line in lines))


def _paper(edits: Edits, root: Mapping, config: Config) -> None:
    base = f"base: {_flow(written.base(config.base))}"
    runtime = [f"{name}: true" for name in ("gpu", "gui") if name not in root.names]
    if "distro" in root.names:
        edits.pair(root, "distro", [base], f"`distro` becomes `{base}`")
    if "runtime" in root.names:
        words = runtime if "distro" in root.names else [base, *runtime]
        edits.pair(root, "runtime", words, f"`runtime: nvidia` becomes {' and '.join(f'`{word}`' for word in words)}")


def _interim_base(edits: Edits, root: Mapping, config: Config) -> None:
    key, base = root.key("base"), root.get("base")
    if key is None or not isinstance(base, Mapping) or not base.pairs:
        return
    start = key.start.index
    end = base.end.index if base.flow else max(value.end.index for _, value in base.pairs)
    new = f"base: {_flow(written.base(config.base))}"
    lost = ", its comments are lost" if "#" in edits.text[start:end] else ""
    edits.put(start, end, new, f"line {key.start.line}: `base` becomes `{new}`{lost}")


def _flow(said: dict[str, str]) -> str:
    return "{" + ", ".join(f"{key}: {value}" for key, value in said.items()) + "}"


def _list(edits: Edits, root: Mapping, key: str, values: tuple[str, ...]) -> None:
    """Write a single value that should be a list as a list."""
    node = root.get(key)
    if node is not None and is_text(node):
        edits.value(node, flow_list(values), f"the one entry of `{key}` becomes a list")


def _sources(edits: Edits, node: Node | None) -> None:
    for item in node.items if isinstance(node, Sequence) else ():
        if not isinstance(item, Mapping):
            continue
        edits.rename(item, "checkout", "ref")
        repo, key = item.get("repo"), item.key("repo")
        if not isinstance(repo, Scalar) or key is None:
            continue
        url, branch = clone(Reading(where=in_file("")), Text(value=repo.text.strip(), node=repo))
        if url == repo.text.strip():
            continue
        words = [f"repo: {url}"]
        if branch and "ref" not in item.names and "checkout" not in item.names:
            words.append(f"ref: {branch if re.match('[A-Za-z]+[/_]', branch) else quoted(branch)}")
        edits.pair(item, "repo", words, f"`repo` becomes {' and '.join(f'`{word}`' for word in words)}")


def _volumes(edits: Edits, node: Node | None) -> None:
    """Join the entries of one volume under one dash; some files have a separate dash for each."""
    seen: set[str] = set()
    for item in node.items if isinstance(node, Sequence) and not node.flow else ():
        if not isinstance(item, Mapping):
            continue
        start = item.start.index
        dash = edits.text.rfind("-", 0, start)
        if seen and len(item.pairs) == 1 and not seen & set(item.names) and "host_path" not in item.names:
            if not edits.text[dash + 1 : start].strip():
                edits.put(dash, dash + 1, " ", f"line {item.start.line}: becomes part of the volume above")
            seen |= set(item.names)
        else:
            seen = set(item.names)


def _custom(edits: Edits, root: Mapping, config: Config) -> None:
    """Write who ran the commands and in which folder, because a plain list has another meaning today."""
    key, node = root.key("custom"), root.get("custom")
    if key is None or node is None or config.custom is None or isinstance(node, Mapping):
        return
    said = {k: v for k, v in written.custom(config.custom).items() if k != "commands"}
    words = [f"{k}: {str(v).lower()}" for k, v in said.items()]
    told = f"line {key.start.line}: `custom` says who runs it and where: {', '.join(words)}"
    if isinstance(node, Sequence) and not node.flow:
        _nest(edits, root, node, [*words, "commands:"], told)
        return
    new = f"{{{', '.join(words)}, commands: {flow_list(config.custom.commands)}}}"
    edits.put(node.start.index, node.end.index, new, told)


def _nest(edits: Edits, root: Mapping, node: Sequence, words: list[str], told: str) -> None:
    """Insert lines between ``custom:`` and its list, which becomes the value of the last one."""
    key = root.key("custom") or node
    text, first, last = edits.text, node.items[0].start.index, node.items[-1].end.index
    dash = text.rfind("-", 0, first)
    line = text.rfind("\n", 0, dash) + 1
    indent = dash - line
    if indent <= key.start.column - 1:  # the list is not indented, but keys below `custom` must be
        indent += 2
        for found in re.finditer(r"^", text[line:last], re.MULTILINE):
            edits.put(line + found.start(), line + found.start(), "  ")
    separator = edits.separator(root, key).rstrip(" ") + " " * indent
    after = text.index(":", key.end.index) + 1
    edits.put(after, after, "".join(separator + word for word in words), told)
