"""The arguments that a launch file declares, whatever their defaults."""

from __future__ import annotations

from roslab.values.pattern import pattern

_IN_PYTHON = pattern(r"\bDeclareLaunchArgument\(\s*(?:name\s*=\s*)?[\"'](\w+)[\"']")
_IN_XML = pattern(r"<arg\s[^<>]{0,300}?\bname\s?=\s?[\"'](\w+)[\"']")


def declared_arguments(text: str) -> tuple[str, ...]:
    """Return their names, each once, in the order of the text."""
    found = (*_IN_PYTHON.findall(text), *(_IN_XML.findall(text) if "<arg" in text else ()))
    return tuple(dict.fromkeys(found))
