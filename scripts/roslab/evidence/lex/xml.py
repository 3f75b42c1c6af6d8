"""XML as a small tree with line numbers: no entities, no document type, no network, no huge trees."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, NoReturn

from roslab.values.dataclass import dataclass, field

MAX_DEPTH = 255
"""Elements inside each other; libxml2 refuses more."""


@dataclass(kw_only=True, slots=True)
class Element:
    """An element: its text goes as far as its first child; where its tag has several lines, ``line`` is one of them."""

    tag: str
    attributes: dict[str, str]
    line: int
    text: str = ""
    children: list[Element] = field(default_factory=list)

    def get(self, name: str) -> str | None:
        """Return an attribute, ``None`` if it is not there."""
        return self.attributes.get(name)

    def below(self, *path: str) -> Iterator[Element]:
        """Yield the children of a name, or those at the end of a path of names."""
        for child in self.children:
            if child.tag == path[0]:
                yield from child.below(*path[1:]) if path[1:] else (child,)

    def all(self, tag: str) -> Iterator[Element]:
        """Yield the elements of a name at any depth, in the order of the file."""
        if self.tag == tag:
            yield self
        for child in self.children:
            yield from child.all(tag)


def parse(text: str) -> tuple[Element | None, str | None]:
    """Return the root, and what is wrong (``line 3: …``) where something is; it is then read as far as possible."""
    return (root, None) if (root := _plain(text)) else _any(text)


def _plain(text: str) -> Element | None:
    """Read a document without a document type, a namespace or anything wrong; ``None`` for every other.

    By Python's own reader: it is there at once, and lxml is slower to import than a hundred manifests to read.
    """
    from xml.parsers import expat  # noqa: PLC0415 - only packages of ROS have XML

    if "xmlns" in text:
        return None
    top = Element(tag="", attributes={}, line=0)
    opened = [top]
    parser = expat.ParserCreate()

    def start(tag: str, attributes: dict[str, str]) -> None:
        if len(opened) > MAX_DEPTH or ":" in "".join((tag, *attributes)):
            refuse()
        element = Element(tag=tag, attributes=attributes, line=parser.CurrentLineNumber)
        opened[-1].children.append(element)
        opened.append(element)

    def say(said: str) -> None:
        if not opened[-1].children:
            opened[-1].text += said

    def declare(_version: str, encoding: str | None, _: int) -> None:  # some give their package's own version
        if (encoding or "utf-8").lower() != "utf-8":
            refuse()

    def refuse(*_: Any) -> NoReturn:
        raise ValueError

    parser.StartElementHandler = start
    parser.EndElementHandler = lambda _: opened.pop()
    parser.CharacterDataHandler = say
    parser.XmlDeclHandler = declare
    parser.StartDoctypeDeclHandler = refuse
    try:
        parser.Parse(text.encode(), True)
    except (expat.ExpatError, ValueError):
        return None
    return top.children[0]


def _any(text: str) -> tuple[Element | None, str | None]:
    from lxml import etree  # noqa: PLC0415 - slow to import

    parser = etree.XMLParser(
        recover=True, resolve_entities=False, no_network=True, load_dtd=False, remove_comments=True, remove_pis=True
    )
    try:
        root = etree.fromstring(text.encode(), parser)
    except (etree.XMLSyntaxError, ValueError) as error:
        return None, str(error)
    problem = next((f"line {entry.line}: {entry.message}" for entry in parser.error_log), "") or None
    return (None if root is None else _element(root)), problem


def _element(node: Any) -> Element:
    return Element(
        tag=node.tag,
        attributes=dict(node.attrib),
        line=node.sourceline or 1,
        text=node.text or "",
        children=[_element(child) for child in node if isinstance(child.tag, str)],  # an entity has none
    )
