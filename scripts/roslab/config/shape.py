"""Checks a tree against the schema and reports unknown keys, wrong types and bad values, with places and hints.

It implements the small part of JSON Schema that ``schema.json`` uses. Validators of libraries are not suitable: they
know neither lines nor the original text of a number, and their messages talk about schemas. All problems are reported
at once, and the valid parts are passed on to later checks.
"""

from __future__ import annotations

import json
from collections.abc import Callable

from roslab.config import vocabulary
from roslab.config.advice import advice
from roslab.config.cited import MAX_PROBLEMS, shown
from roslab.config.node import Mapping, Mark, Node, Scalar, Sequence, Where, kind
from roslab.config.vocabulary import Schema
from roslab.errors import Problem
from roslab.values.dataclass import dataclass, field, replace

_FOUND = {
    "array": "a list",
    "object": "a mapping",
    "null": "nothing",
    "boolean": "a truth value",
    "integer": "a number",
    "number": "a number",
    "date": "a date",
    "string": "text",
}

_ABOUT = ("title", "description", "examples")


@dataclass(kw_only=True, slots=True)
class Shape:
    """Collects the problems of a tree."""

    where: Where
    whole: str = "the file"
    """The name of the tree's root in messages."""
    problems: list[Problem] = field(default_factory=list)
    unknown: Callable[[str], str | None] = lambda _: None
    """Returns a hint about an unknown top-level key: which format has it, and what to write."""

    def check(self, node: Node, schema: Schema, path: str = "") -> Node | None:
        """Return the tree without the wrong parts, ``None`` if nothing is left."""
        schema = vocabulary.resolve(schema)
        if "anyOf" in schema:
            branch = next((b for b in map(vocabulary.resolve, schema["anyOf"]) if _admits(b, node)), None)
            if branch is not None:
                named: Schema = {word: schema[word] for word in _ABOUT if word in schema}
                return self.check(node, {**named, **branch}, path)
            return self._wrong_type(node, schema, path)
        if not _admits(schema, node):
            return self._wrong_type(node, schema, path)
        if isinstance(node, Mapping):
            return self._mapping(node, schema, path)
        if isinstance(node, Sequence):
            return self._sequence(node, schema, path)
        return self._scalar(node, schema, path) if isinstance(node, Scalar) else None

    def complain(self, mark: Mark, message: str, hint: str | None = None) -> None:
        """Record a problem, unless there are already more than anybody would read."""
        if len(self.problems) < MAX_PROBLEMS:
            self.problems.append(Problem(message=message, hint=hint, origin=self.where(mark)))

    def _wrong_type(self, node: Node, schema: Schema, path: str) -> Node | None:
        values = dict.fromkeys(str(value) for value in schema.get("enum", ()))
        if isinstance(node, Scalar) and values:
            was, hint = f'{_FOUND[node.kind]} ("{shown(node.text)}")', f"allowed: {', '.join(values)}"
        elif isinstance(node, Scalar) and node.kind not in {"string", "null"}:
            was = f'{_FOUND[node.kind]} ("{shown(node.text)}")'
            quoted = f'put it in quotes: "{shown(node.text)}"'
            hint = quoted if _takes(schema, node.text) else f"{schema['description']} {_sentence(schema)}"
        else:
            was, hint = _FOUND[kind(node)], _example(schema)
        self.complain(node.start, f"{path or self.whole} is {was}, not {_article(schema['title'])}", hint)
        return None

    def _mapping(self, node: Mapping, schema: Schema, path: str) -> Mapping:
        pairs: list[tuple[Scalar, Node]] = []
        properties = schema.get("properties", {})
        for key, value in node.pairs:
            below = f"{path}.{shown(key.text)}" if path else shown(key.text)
            if key.text in properties:
                rest = self.check(value, properties[key.text], below)
            elif isinstance(schema.get("additionalProperties"), dict):
                if self._key(key, schema, below):
                    rest = self.check(value, schema["additionalProperties"], below)
                else:
                    rest = None
            else:
                rest = self._unknown(key, tuple(properties), path)
            pairs.append((key, rest if rest is not None else _nothing(value)))
        self._relations(node, schema, path)
        return replace(node, pairs=tuple(pairs))

    def _key(self, key: Scalar, schema: Schema, path: str) -> bool:
        rule = vocabulary.resolve(schema["propertyNames"])
        if key.kind == "string" and _matches(rule, key.text):
            return True
        self.complain(key.start, f'{path}: "{shown(key.text)}" is no {rule["title"]}', rule["description"])
        return False

    def _unknown(self, key: Scalar, allowed: tuple[str, ...], path: str) -> Node | None:
        where = f" in {path}" if path else ""
        hint = self.unknown(key.text) if not path else None
        if hint is None:
            meant = str(vocabulary.rows("translations").get(key.text, "")).removeprefix(f"{path}.")
            meant = meant if meant.partition(".")[0] in allowed else vocabulary.nearest(key.text, allowed) or ""
            hint = f"did you mean `{meant}`?" if meant else f"allowed: {', '.join(allowed)}"
        self.complain(key.start, f'unknown key "{shown(key.text)}"{where}', hint)
        return None

    def _relations(self, node: Mapping, schema: Schema, path: str) -> None:
        """Check which keys need, or exclude, each other."""
        names, where = set(node.names), path or self.whole
        for name in schema.get("required", ()):
            if name not in names:
                self.complain(node.start, f"{where} has no `{name}`", _example(schema))
        for name, needed in schema.get("dependentRequired", {}).items():
            for other in needed:
                key = node.key(name)
                if key is not None and other not in names:
                    self.complain(key.start, f"{where}: `{name}` needs `{other}`", f"add `{other}` to {where}")
        alternatives = [set(choice["required"]) for choice in schema.get("oneOf", ())]
        if alternatives and sum(choice <= names for choice in alternatives) != 1:
            words = " or ".join(f"`{name}`" for choice in alternatives for name in choice)
            self.complain(node.start, f"{where} needs either {words}", _example(schema))
        for rule in schema.get("allOf", ()):
            if set(rule["not"]["required"]) <= names:
                key = node.key(rule["not"]["required"][-1])
                self.complain((key or node).start, f"{path}: {rule['title']}".removeprefix(": "), "keep one of them")

    def _sequence(self, node: Sequence, schema: Schema, path: str) -> Sequence | None:
        if len(node.items) < schema.get("minItems", 0):
            self.complain(
                node.start, f"{path or self.whole} is empty, not {_article(schema['title'])}", _example(schema)
            )
            return None
        below = (f"{path}[{i}]" if path else "" for i in range(len(node.items)))
        checked = (self.check(item, schema["items"], at) for item, at in zip(node.items, below, strict=True))
        return replace(node, items=tuple(item for item in checked if item is not None))

    def _scalar(self, node: Scalar, schema: Schema, path: str) -> Scalar | None:
        if node.kind in {"null", "boolean"} and "enum" not in schema:
            return node
        values = schema.get("enum", ())
        allowed = [str(value) for value in values if not isinstance(value, bool)]
        if "const" in schema:
            allowed = [str(schema["const"])]
        truth = node.text.lower() in {"true", "yes", "on"}
        if node.text in allowed or (node.kind == "boolean" and any(value is truth for value in values)):
            return node
        if not allowed and node.kind != "boolean" and _matches(schema, node.text):
            return node
        title = schema["title"]
        hint = advice(title, node.text)
        if hint is None and allowed:
            meant = vocabulary.nearest(node.text, allowed)
            hint = f"did you mean `{meant}`? " if meant else ""
            hint += "allowed: " + ", ".join(dict.fromkeys(allowed))
        elif hint is None:
            hint = f"{schema['description']} {_sentence(schema)}"
        self.complain(node.start, f'{path}: "{shown(node.text)}" is no {title}'.removeprefix(": "), hint)
        return None


def _nothing(node: Node) -> Scalar:
    """Return an empty value to replace a wrong one, so that its key still exists."""
    return Scalar(start=node.start, end=node.end, text="", kind="null", plain=True)


def _matches(schema: Schema, text: str) -> bool:
    fits = schema.get("minLength", 0) <= len(text) <= schema.get("maxLength", len(text))
    # Python's `$` also matches before a last line break, which JSON Schema's does not.
    return fits and "\n" not in text and bool(vocabulary.compiled(schema.get("pattern", "")).search(text))


def _types(schema: Schema) -> set[str]:
    """Return the types that a schema without ``anyOf`` accepts."""
    if "type" in schema:
        return {schema["type"]} if isinstance(schema["type"], str) else set(schema["type"])
    values = schema.get("enum", [schema["const"]] if "const" in schema else [])
    found = {"boolean" if isinstance(v, bool) else "string" if isinstance(v, str) else "number" for v in values}
    return found or {"string"}


def _admits(schema: Schema, node: Node) -> bool:
    types, found = _types(schema), kind(node)
    if found == "date":
        return schema.get("format") == "date"
    return found in types or (found == "integer" and "number" in types)


def _takes(schema: Schema, text: str) -> bool:
    """Return whether a schema accepts a text."""
    branches = [vocabulary.resolve(branch) for branch in schema.get("anyOf", ())] or [schema]
    return any(
        "string" in _types(branch) and _matches(branch, text) and text in branch.get("enum", (text,))
        for branch in branches
    )


def _example(schema: Schema) -> str:
    examples = schema.get("examples")
    if not examples:
        return str(schema["description"])
    texts = (e if isinstance(e, str) else json.dumps(e, ensure_ascii=False) for e in examples)
    return "for example: " + " or ".join(f"`{text}`" for text in texts)


def _sentence(schema: Schema) -> str:
    example = _example(schema)
    return f"{example[0].upper()}{example[1:]}"


def _article(title: str) -> str:
    return f"an {title}" if title[0].lower() in "aeiou" else f"a {title}"
