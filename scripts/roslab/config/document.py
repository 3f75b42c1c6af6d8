"""The text of a YAML file as a tree, built from PyYAML's events without recursion and within limits.

Tags construct nothing, an alias bomb or deep nesting gives one clear problem, and duplicate keys, which YAML libraries
ignore, are reported with both lines.
"""

from __future__ import annotations

from typing import Any

from roslab.config.cited import FORBIDDEN, MAX_PROBLEMS, shown
from roslab.config.node import Mapping, Mark, Node, Scalar, ScalarKind, Sequence, in_file
from roslab.errors import ConfigurationError, Problem
from roslab.values.dataclass import dataclass, field
from roslab.values.origin import Place
from roslab.values.yaml import yaml

MAX_CHARACTERS = 64 * 1024
"""The longest real file of this program has 2,200 characters, that of another program 17,000."""
MAX_DEPTH = 32
MAX_NODES = 20_000
"""Most values in a file, counted with every alias expanded."""

_LOADER = getattr(yaml, "CSafeLoader", yaml.SafeLoader)
_TAG = "tag:yaml.org,2002:"
_KINDS: dict[str, ScalarKind] = {
    "str": "string",
    "int": "integer",
    "float": "number",
    "bool": "boolean",
    "null": "null",
    "timestamp": "date",
}
_HINTS = (
    ("cannot start any token", "indent with spaces, never with tabs; put a value that begins with @, ` or % in quotes"),
    ("mapping values are not allowed", "put a value that holds a colon and a space in quotes"),
    ("could not find expected ':'", "write KEY: VALUE, with a space after the colon"),
    ("tab character", "indent with spaces, never with tabs"),
    ("expected ',' or", "close the bracket: [a, b] or {a: b}"),
    ("did not find expected", "indent the lines that belong together by the same number of spaces"),
    ("unexpected end of stream", "close the quote"),
    ("undefined alias", "write the value out"),
)
_TOO_DEEP = ("nested too deep", f"at most {MAX_DEPTH} levels are read, roslab.yaml needs four")
_MERGE = "<<"


@dataclass(kw_only=True, slots=True)
class _Open:
    """A list or mapping whose end has not been read yet."""

    event: yaml.events.CollectionStartEvent
    parts: list[Node] = field(default_factory=list)


class _Stop(Exception):  # noqa: N818 - ends the reading of events, never leaves this module
    """The rest of the file cannot be read."""

    def __init__(self, message: str, hint: str, mark: Mark | None = None) -> None:
        self.problem = (message, hint, mark)
        super().__init__(message)


@dataclass(kw_only=True, slots=True)
class Document:
    """The tree of one file and the problems with its keys; ``root`` is ``None`` if the file is empty."""

    file: str
    root: Node | None = None
    problems: list[Problem] = field(default_factory=list)
    _stack: list[_Open] = field(default_factory=list)
    _anchors: dict[str, Node | None] = field(default_factory=dict)

    def complain(self, message: str, hint: str, mark: Mark | None) -> None:
        """Record a problem at a place."""
        origin = in_file(self.file)(mark) if mark else Place(file=self.file)
        self.problems.append(Problem(message=message, hint=hint, origin=origin))

    def take(self, event: yaml.events.Event) -> None:
        """Add one event of the parser to the tree."""
        if isinstance(event, yaml.DocumentStartEvent):
            if self.root is not None:
                hint = "one file holds one configuration: take out the line `---` and what follows it"
                raise _Stop("a second document begins here", hint, _mark(event.start_mark))
            self._anchors.clear()
        elif isinstance(event, yaml.AliasEvent):
            self._alias(event)
        elif isinstance(event, yaml.ScalarEvent):
            self._close(_scalar(event), event.anchor)
        elif isinstance(event, yaml.events.CollectionStartEvent):
            _check_tag(event.tag, ("seq", "map"), _mark(event.start_mark))
            if len(self._stack) >= MAX_DEPTH:
                raise _Stop(*_TOO_DEEP, _mark(event.start_mark))
            if event.anchor:
                self._anchors[event.anchor] = None
            self._stack.append(_Open(event=event))
        elif isinstance(event, yaml.events.CollectionEndEvent):
            opened = self._stack.pop()
            build = self._mapping if isinstance(opened.event, yaml.MappingStartEvent) else self._sequence
            self._close(build(opened, _mark(event.end_mark)), opened.event.anchor)

    def _alias(self, event: yaml.AliasEvent) -> None:
        name, mark = event.anchor or "", _mark(event.start_mark)
        target = self._anchors.get(name)
        if target is None:
            why = "contains itself" if name in self._anchors else "is not defined above"
            raise _Stop(f"the alias *{name} {why}", "write the value out", mark)
        self._add(target, mark)

    def _close(self, node: Node, anchor: str | None) -> None:
        if anchor:
            self._anchors[anchor] = node
        self._add(node, node.start)

    def _add(self, node: Node, mark: Mark) -> None:
        if not self._stack:
            self.root = node
            return
        parts = self._stack[-1].parts
        parts.append(node)
        # Counted here and not at the end of a list, so that reading a list of a million items stops early.
        if node.size > MAX_NODES or len(parts) > MAX_NODES:
            raise _Stop("holds too many values", f"at most {MAX_NODES} are read, aliases written out", mark)

    def _sequence(self, opened: _Open, end: Mark) -> Sequence:
        return Sequence(
            start=_mark(opened.event.start_mark),
            end=end,
            size=1 + sum(part.size for part in opened.parts),
            items=tuple(opened.parts),
            flow=bool(opened.event.flow_style),
        )

    def _mapping(self, opened: _Open, end: Mark) -> Mapping:
        pairs: dict[str, tuple[Scalar, Node]] = {}
        merged: list[Mapping] = []
        for key, value in zip(opened.parts[::2], opened.parts[1::2], strict=True):
            if not isinstance(key, Scalar):
                self.complain("a key must be a word", "write KEY: VALUE", key.start)
            elif key.text == _MERGE and key.plain:
                merged += self._merged(value)
            elif key.text in pairs:
                first = pairs[key.text][0].start.line
                hint = f"keep one of them: the first is on line {first}"
                self.complain(f'"{shown(key.text)}" stands here a second time', hint, key.start)
            else:
                pairs[key.text] = (key, value)
        for mapping in merged:
            for key, value in mapping.pairs:
                pairs.setdefault(key.text, (key, value))
        return Mapping(
            start=_mark(opened.event.start_mark),
            end=end,
            size=1 + sum(key.size + value.size for key, value in pairs.values()),
            pairs=tuple(pairs.values()),
            flow=bool(opened.event.flow_style),
        )

    def _merged(self, value: Node) -> list[Mapping]:
        """Return the mappings that ``<<`` refers to; the first has priority, as in YAML."""
        items = value.items if isinstance(value, Sequence) else (value,)
        found = [item for item in items if isinstance(item, Mapping)]
        if len(found) < len(items):
            self.complain('"<<" takes mappings only', "write the keys out", value.start)
        return found


def parse(text: str | bytes, *, file: str) -> Document:
    """Read the tree of a YAML text.

    Bytes are decoded as UTF-8; invalid ones become U+FFFD, which is allowed in comments but not in values.
    Raises ``ConfigurationError`` if the text is too long, not YAML, or not text at all.
    """
    if len(text) > MAX_CHARACTERS:
        hint = f"at most {MAX_CHARACTERS} are read: this is no configuration"
        raise ConfigurationError(Problem(message=f"holds {len(text)} characters", hint=hint, origin=Place(file=file)))
    if isinstance(text, bytes):
        text = text.decode("utf-8", errors="replace")
    text = text.removeprefix("\ufeff")
    document = Document(file=file)
    plain = text.replace("\n", "").replace("\t", "").isprintable()  # most are, and the pattern takes long to compile
    for match in () if plain else FORBIDDEN.finditer(text):
        before = text[: match.start()]
        mark = Mark(line=before.count("\n") + 1, column=match.start() - before.rfind("\n"), index=match.start())
        document.complain(f"the character U+{ord(match[0]):04X} is not allowed", "save the file as UTF-8 text", mark)
        if len(document.problems) == MAX_PROBLEMS:
            break
    if document.problems:
        raise ConfigurationError(*document.problems)
    try:
        for event in yaml.parse(text, Loader=_LOADER):
            document.take(event)
    except _Stop as stop:
        document.complain(*stop.problem)
        raise ConfigurationError(*document.problems) from None
    except (yaml.YAMLError, ValueError, OverflowError) as error:  # the last two: bad escapes in the pure Python parser
        document.complain(*_syntax(error))
        raise ConfigurationError(*document.problems) from None
    del document.problems[MAX_PROBLEMS:]
    return document


def _mark(mark: Any) -> Mark:  # the C parser has its own class of marks
    return Mark(line=mark.line + 1, column=mark.column + 1, index=mark.index)


def _scalar(event: yaml.ScalarEvent) -> Scalar:
    start = _mark(event.start_mark)
    plain = event.style is None or event.style == ""
    text = event.value
    if event.tag and event.tag != "!":
        _check_tag(event.tag, tuple(_KINDS), start)
        kind = _KINDS[event.tag.removeprefix(_TAG)]
    else:
        kind = _resolve(text) if plain and event.tag is None else "string"
    if event.style in {"|", ">"}:
        text = text.removesuffix("\n")  # this line break ends the block and is not part of the value
    return Scalar(start=start, end=_mark(event.end_mark), text=text, kind=kind, plain=plain)


def _resolve(text: str) -> ScalarKind:
    """Return the type that an unquoted text has in YAML 1.1."""
    resolvers = yaml.SafeLoader.yaml_implicit_resolvers
    for tag, expression in resolvers.get(text[:1], []) + resolvers.get(None, []):
        if expression.match(text):
            return _KINDS.get(tag.removeprefix(_TAG), "string")
    return "string"


def _check_tag(tag: str | None, allowed: tuple[str, ...], mark: Mark) -> None:
    if tag and tag != "!" and tag.removeprefix(_TAG) not in allowed:
        raise _Stop(f"the tag {shown(tag)} is not allowed", "roslab.yaml needs no tags: take it out", mark)


def _syntax(error: Exception) -> tuple[str, str, Mark | None]:
    """Return a parser's error as a message, a hint and a place."""
    complaint = getattr(error, "problem", None) or "it cannot be read"
    mark = getattr(error, "problem_mark", None) or getattr(error, "context_mark", None)
    if "maximum nesting depth" in complaint:  # libyaml 0.2.6 and later, which scans ahead of the events
        return *_TOO_DEEP, _mark(mark) if mark else None
    hint = next((hint for words, hint in _HINTS if words in complaint), "see https://yaml.org for the syntax")
    return f"no valid YAML: {complaint}", hint, _mark(mark) if mark else None
