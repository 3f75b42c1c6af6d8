"""Inputs and options that override roslab.yaml, read with the same schema and readers as the file.

Together they form one document in today's format, in which line N is the Nth given value. So every problem, warning
and reason can name the input or option that it is about.
"""

from __future__ import annotations

from collections.abc import Sequence as Several
from typing import Any

from roslab.config import reader, vocabulary
from roslab.config.cited import FORBIDDEN
from roslab.config.given import Override
from roslab.config.model import Base, Config, TagParts
from roslab.config.node import Mapping, Mark, Node, Scalar, Sequence
from roslab.config.reading import Reading
from roslab.config.shape import Shape
from roslab.config.vocabulary import Schema
from roslab.errors import ConfigurationError, Problem
from roslab.knowledge.distros import releases_of
from roslab.values.dataclass import fields, replace
from roslab.values.origin import Origin
from roslab.values.pattern import pattern

_SEPARATOR = pattern(r"[\s,]+")


def overridden(text: str | None, overrides: Several[Override], *, file: str | None) -> Config:
    """Return the content of roslab.yaml with the overrides applied; ``text`` is ``None`` if there is no such file.

    Raises ``ConfigurationError`` with every problem of both.
    """
    if not overrides:
        return Config() if text is None else reader.read(text, file=file or "roslab.yaml")
    said, problems = _read(overrides)
    try:
        config = overridden(text, (), file=file)
    except ConfigurationError as error:
        raise ConfigurationError(*error.problems, *problems) from None
    problems = problems or _conflicts(config, said)
    if problems:
        raise ConfigurationError(*problems)
    return laid_over(config, said)


def _conflicts(config: Config, said: Config) -> tuple[Problem, ...]:
    """Return the problem of a ROS distribution that has no packages for the Ubuntu release of the file."""
    ros, ubuntu = said.base.ros, config.base.ubuntu
    if ros is None or ubuntu is None or config.base.image is not None:
        return ()
    distro = ros.partition("-")[0]
    if ubuntu in releases_of()[distro]:
        return ()
    message = f"ROS {distro} has no packages for Ubuntu {ubuntu}, which {config.origin('base.ubuntu')} names"
    hint = "leave `ubuntu` out of the file: it follows from the distribution"
    return (Problem(message=message, hint=hint, origin=said.origin("base.ros")),)


def problems_of(overrides: Several[Override]) -> tuple[Problem, ...]:
    """Return the problems of the overrides alone."""
    return _read(overrides)[1]


def _read(overrides: Several[Override]) -> tuple[Config, tuple[Problem, ...]]:
    """Return the configuration given by the overrides alone, and their problems."""

    def where(mark: Mark) -> Origin:
        return overrides[mark.line - 1].origin

    shape = Shape(where=where, whole="it")
    pairs: list[tuple[str, Scalar, Node]] = []
    for line, override in enumerate(overrides, 1):
        mark = Mark(line=line, column=1, index=0)
        schema = _schema(override.key)
        if strange := FORBIDDEN.search(override.text):
            hint = "write plain text, without control characters, in UTF-8"
            shape.complain(mark, f"the character U+{ord(strange[0]):04X} is not allowed", hint)
        elif node := shape.check(_node(override.text.strip(), schema, mark), schema):
            pairs.append((override.key, _scalar(override.key.rpartition(".")[2], mark), node))
    reading = Reading(where=where)
    config = reader.config_of(reading, _document(pairs), "today")
    # The option or input is named before the message, so that its key need not be
    keys: dict[Origin | None, str] = {each.origin: each.key for each in overrides}
    said = (replace(each, message=each.message.removeprefix(f"{keys.get(each.origin)}: ")) for each in reading.problems)
    return config, (*shape.problems, *said)


def laid_over(config: Config, said: Config) -> Config:
    """Return a configuration in which the values of inputs and options replace those of the file.

    Only this function implements the precedence: an action's input or a command's option > roslab.yaml > evidence >
    default. The last two are left to ``decide``, which uses the evidence only for what the configuration leaves open.
    """
    base = replace(config.base, **_changed(said.base, Base()))
    tags = replace(config.tags, **_changed(said.tags, TagParts()))
    changed = {**_changed(said, Config()), "base": base, "tags": tags, "warnings": (*config.warnings, *said.warnings)}
    new = dict(said.origins)
    kept = ((path, origin) for path, origin in config.origins if not _replaced(path, new))
    return replace(config, **{**changed, "origins": (*kept, *said.origins)})


def _changed(said: Config | Base | TagParts, nothing: Config | Base | TagParts) -> dict[str, Any]:
    """Return the fields that differ from their defaults."""
    return {f.name: value for f in fields(said) if (value := getattr(said, f.name)) != getattr(nothing, f.name)}


def _replaced(path: str, by: dict[str, Origin]) -> bool:
    """Return whether the overrides give a key, or the list that contains it as an entry."""
    return path in by or (path.rpartition(".")[0] in by and not path.startswith(("base.", "tags.")))


def _schema(key: str) -> Schema:
    schema = vocabulary.definition("today")
    for name in key.split("."):
        schema = vocabulary.resolve(vocabulary.resolve(schema)["properties"][name])
    return schema


def _node(text: str, schema: Schema, mark: Mark) -> Node:
    if schema.get("type") == "boolean" and text in ("true", "false"):
        return replace(_scalar(text, mark), kind="boolean")
    if not _takes_list(schema):
        return _scalar(text, mark)
    items = tuple(_scalar(part, mark) for part in _SEPARATOR.split(text) if part)
    return Sequence(start=mark, end=mark, items=items, flow=True)


def _takes_list(schema: Schema) -> bool:
    """Return whether a key is mainly a list; a command, which may be a list too, is a line of shell here."""
    branches = [vocabulary.resolve(branch) for branch in schema.get("anyOf", (schema,))]
    return branches[0].get("type") == "array"


def _scalar(text: str, mark: Mark) -> Scalar:
    return Scalar(start=mark, end=mark, text=text, kind="string", plain=False)


def _document(pairs: Several[tuple[str, Scalar, Node]]) -> Mapping:
    """Return the tree of a file that contains these values."""
    start = Mark(line=1, column=1, index=0)
    top = tuple((name, node) for key, name, node in pairs if "." not in key)
    for group in dict.fromkeys(key.partition(".")[0] for key, _, _ in pairs if "." in key):
        inner = tuple((name, node) for key, name, node in pairs if key.startswith(f"{group}."))
        below = Mapping(start=inner[0][0].start, end=start, pairs=inner, flow=False)
        top = (*top, (_scalar(group, below.start), below))
    return Mapping(start=start, end=start, pairs=top, flow=False)
