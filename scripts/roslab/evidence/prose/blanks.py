"""Blanks in a command: placeholders for the reader of a page to fill in, and values of which one is to be chosen."""

from __future__ import annotations

from roslab.values.pattern import pattern

_RUN = pattern(r"\b(?:roslaunch|rosrun|ros2)\s")
BLANK = pattern(r"<[A-Za-z][^<>|&;\n]{0,60}>|<[\w.-]{1,30}(?:\s?\|\s?[\w.-]{1,30}){1,12}>")
"""A placeholder for the reader of a page to fill in, or to choose: ``<small | large>``."""
_BRACED = pattern(r"(?<![$\w{=-])\{[A-Za-z][\w -]{0,40}\}(?=[/\s]|$)")
_CHOICE = pattern(r"(?<==)\{\s*([\w.-]+)\s*(?:[,|/]\s*[\w.-]+\s*){1,12}\}")
"""Values of which the reader chooses one: ``rviz:={true, false}``."""
_OFFERED = pattern(r"(?<=\s)(--?[A-Za-z][\w-]*[ =])[(\uff08]\s*([\w./-]+)\s*(?:[|\uff5c]\s*[\w./-]+\s*){1,12}[)\uff09]")
"""Values of an option of which the reader chooses one: ``--scene (packed | pile)``."""


def filled(text: str, *, of_page: bool) -> str:
    """Return a command with ``$UNKNOWN`` for each placeholder, and with the first of values to choose from.

    ``of_page``: it stands on a page for people; elsewhere most of this is shell.
    """
    if "<" in text and (of_page or _RUN.search(text)):
        text = BLANK.sub("$UNKNOWN", text)  # otherwise `<sensor name>` would be read as a redirection
    if of_page and "{" in text:
        text = _BRACED.sub("$UNKNOWN", text)
    if "={" in text:
        text = _CHOICE.sub(r"\1", text)
    return _OFFERED.sub(r"\1\2", text) if of_page and ("(" in text or "\uff08" in text) else text
