"""Places, warnings and problems that are collected while a tree is read into the model."""

from __future__ import annotations

from roslab.config.node import Mapping, Node, Scalar, Sequence, Where
from roslab.errors import Problem
from roslab.values.dataclass import dataclass, field
from roslab.values.origin import Origin


@dataclass(frozen=True, kw_only=True, slots=True)
class Text:
    """A value and the node it came from."""

    value: str
    node: Scalar


@dataclass(kw_only=True, slots=True)
class Reading:
    """The reading of one file, or of the values of inputs and options."""

    where: Where
    origins: dict[str, Origin] = field(default_factory=dict)
    warnings: list[tuple[str, Origin | None]] = field(default_factory=list)
    problems: list[Problem] = field(default_factory=list)

    def note(self, path: str, node: Node | None) -> None:
        """Record where the key at a dotted path of the model was given."""
        if node is not None:
            self.origins.setdefault(path, self.where(node.start))

    def warn(self, message: str, node: Node | None) -> None:
        """Record a warning about an outdated or reinterpreted value, with the reason."""
        self.warnings.append((message, self.where(node.start) if node else None))

    def complain(self, message: str, hint: str, node: Node) -> None:
        """Record a problem."""
        self.problems.append(Problem(message=message, hint=hint, origin=self.where(node.start)))

    def mapping(self, root: Mapping, key: str) -> Mapping | None:
        """Return a mapping, ``None`` if it is missing or unusable."""
        node = root.get(key)
        return node if isinstance(node, Mapping) else None

    def text(self, root: Mapping | None, key: str, path: str) -> Text | None:
        """Return a single value as text."""
        node = root.get(key) if root else None
        if root is None or not isinstance(node, Scalar) or node.kind == "null":
            return None
        self.note(path, root.key(key))
        return Text(value=node.text.strip(), node=node)

    def value(self, root: Mapping | None, key: str, path: str) -> str | None:
        """Return a single value as text, without its node."""
        text = self.text(root, key, path)
        return text.value if text else None

    def truth(self, root: Mapping | None, key: str, path: str) -> bool | None:
        """Return a truth value."""
        text = self.text(root, key, path)
        return text.value.lower() in {"true", "yes", "on"} if text else None

    def texts(self, root: Mapping, key: str, path: str) -> tuple[Text, ...] | None:
        """Return a list of texts, ``None`` if the key is missing or empty.

        A single text counts as a list of one, with a warning: the old generators treated each letter as an entry.
        """
        node = root.get(key)
        if node is None or (isinstance(node, Scalar) and node.kind == "null"):
            return None
        self.note(path, root.key(key))
        if isinstance(node, Scalar):
            self.warn(f"`{key}` is a list: its one entry should stand on a line of its own, after `- `", node)
        items = node.items if isinstance(node, Sequence) else (node,)
        return tuple(Text(value=item.text.strip(), node=item) for item in items if isinstance(item, Scalar))

    def values(self, root: Mapping, key: str, path: str) -> tuple[str, ...] | None:
        """Return a list of texts without their nodes, and record the place of each."""
        texts = self.texts(root, key, path)
        if texts is None:
            return None
        for index, text in enumerate(texts):
            self.note(f"{path}.{index}", text.node)
        return tuple(text.value for text in texts)
