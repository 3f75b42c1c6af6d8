"""Blanks in a command: placeholders for the reader of a page to fill in, and values of which one is to be chosen."""

from __future__ import annotations

import re

from roslab.evidence.lex.shell import DISTRO
from roslab.values.pattern import pattern

_RUN = pattern(r"\b(?:roslaunch|rosrun|ros2)\s")
BLANK = pattern(r"<[A-Za-z][^<>|&;\n]{0,60}>|<[\w.-]{1,30}(?:\s?\|\s?[\w.-]{1,30}){1,12}>")
"""A placeholder for the reader of a page to fill in, or to choose: ``<small | large>``."""
ARGUMENTS = "…arguments"
"""What stands for ``<args>`` in a command: all that its program is given."""
_PACKAGE = pattern(
    r"\bcd[ \t]+[\"']?(?:\$\(|`)(?:rospack[ \t]+find|ros2[ \t]+pkg[ \t]+prefix(?:[ \t]+--share)?)[ \t]+([\w-]+)[)`]"
    r"(?:/(?:share|lib)/\1(?![\w-]))?([\w./-]*)[\"']?"
)
"""A folder that is found by the name of a package: ``cd $(rospack find demo)/scripts``."""
_SPACED = pattern(r"(?<=[ \t])([A-Za-z_]\w{0,60})[ \t]{0,4}:=[ \t]{0,4}(?=[^\s:=])(?!\w{1,60}[ \t]{0,4}:=)")
"""A value that is given to a launch file with blanks before it: ``address := <ip>``."""
_ARGUMENTS = pattern(r"(?<=\s)[<\[](?:args?|arguments)(?:\s?\.{3})?[>\]](?=\s|$)", re.IGNORECASE)
_BRACED = pattern(r"(?<![$\w{=-])\{[A-Za-z][\w -]{0,40}\}(?=[/\s]|$)")
_CHOICE = pattern(r"(?<==)\{\s*([\w.-]+)\s*(?:[,|/]\s*[\w.-]+\s*){1,12}\}")
"""Values of which the reader chooses one: ``rviz:={true, false}``."""
_OFFERED = pattern(r"(?<=\s)(--?[A-Za-z][\w-]*[ =])[(\uff08]\s*([\w./-]+)\s*(?:[|\uff5c]\s*[\w./-]+\s*){1,12}[)\uff09]")
"""Values of an option of which the reader chooses one: ``--scene (packed | pile)``."""

_DASH = pattern(r"(?<=\s)[\u2013\u2014](?=([A-Za-z][\w-]?))")
"""The hyphens of an option, of which a word processor made a dash."""

_NAME = r"`+(?P<name>[A-Z][A-Z0-9_]{2,}|<[A-Za-z][\w -]{1,40}>|\$\{?[A-Za-z]\w+\}?)`+"
_ONE_OF = r"(?:(?:just |simply )?(?:one|any|either) (?:of|from)(?: the following)?:?|e\.g\.,?|for example,?)"
_VALUE = r"\s*[\[({]?\s*[`'\"]+(?P<value>[\w][\w./:-]*)[`'\"]+"
_NAMED = pattern(r"`(?:[A-Z][A-Z0-9_]{2}|<[A-Za-z]|\$\{?[A-Za-z])")
"""What each such name has: it begins with the backquote, which is found much faster than the words around it."""
_CHOSEN = tuple(
    pattern(form, re.IGNORECASE)
    for form in (
        rf"\b(?:replac\w+|chang\w+|substitut\w+|set) (?-i:{_NAME}) (?:with|by|to) {_ONE_OF}{_VALUE}",
        rf"(?-i:{_NAME}) (?:is|are|can be|may be|must be|should be|could be) (?:chosen )?{_ONE_OF}{_VALUE}",
    )
)
"""A sentence that gives the values of a name in the commands of its page: replace `METHOD` with one of `bc`, `iql`."""
_SAID = ("e.g.", "for example", *(f"{one} {of}" for one in ("one", "any", "either") for of in ("of", "from")))
"""Of these each such sentence has one, in any case."""

_EXAMPLE = pattern(
    r"^(?P<before>[ \t$>]*)(?P<program>(?:python|bash|sh|ros|\./)\S*)[ \t]+(?P<rest>[^\n#]*)(?P<end>\n?)"
    r"[ \t$>]*#+[ \t]*(?:for (?:example|instance)|e\.?g\b\.?|examples?)[ \t:,]+"
    r"`?(?P<command>(?P=program)[ \t][^\n`]+)`?[ \t]*$",
    re.MULTILINE | re.IGNORECASE,
)
"""A remark that fills in the command above it or beside it: ``# for example: python run.py a.yaml``."""
_REMARK = pattern(r"#[ \t]*(?:for|e\.?g|example)", re.IGNORECASE)
"""How each such remark begins: with a sign that is found much faster than the beginning of a line."""
_OWN = pattern(r"(?:[\s=]|\A)(?:/|~)")
_BLANK = pattern(r"[\[{<\u2026]|\.{3}|path/to|your|(?-i:\b(?:X+|[A-Z][A-Z_]{2,})\b)", re.IGNORECASE)

_LEFT = pattern(
    r"^(?P<before>[ \t$>]*(?P<name>[A-Z][A-Z0-9_]{2,})=)[\[<][A-Za-z][\w ./-]{1,40}[\]>](?=[ \t]+\S)", re.MULTILINE
)
"""A variable before a command whose value is left to the reader: ``ROUTES=[PATH TO ROUTES] ./run.sh``."""

_RELEASE = pattern(r"distro|version|release|ubuntu|cuda", re.IGNORECASE)

_USED = pattern(r"\bros-\$\{?([A-Za-z_]\w*)\}?-")
_EXPORTED = pattern(r"^[ \t$>]*export[ \t]+([A-Za-z_]\w*)=([\"']?)([a-z]+)\2[ \t]*(?:[#;&].*)?$", re.MULTILINE)

_BRANCH = pattern(
    r"""(?<=\s)(?P<option>-b\s+|--branch[\s=]\s*|checkout\s+)(?P<before>[\w./-]{0,40})(?:
        <(?:your[-_ ]?)?(?:ros[-_ ]?)?(?:distro(?:[-_ ]?name)?|distribution|ros[-_ ]?version)>
      | "?\$\{?ROS_DISTRO\}?"? | \{(?:ros[-_ ]?)?distro\}
      | (?-i:(?:YOUR_)?(?:ROS_?DISTRO|ROS_VERSION))
    )(?=[-_./\s"]|$)""",
    re.VERBOSE | re.IGNORECASE,
)
"""A branch that is called after the reader's distribution of ROS: ``--branch <YOUR_ROS_VERSION>-devel``."""


def with_arguments(text: str) -> str:
    """Return a command with one word for ``<args>``, which no shell reads."""
    return _ARGUMENTS.sub(ARGUMENTS, text) if "arg" in text.lower() else text


def with_packages(text: str) -> str:
    """Return a command with ``roscd`` for a folder that the name of a package finds."""
    return _PACKAGE.sub(r"roscd \1\2", text) if "cd " in text and ("rospack" in text or "pkg" in text) else text


def with_distro(text: str) -> str:
    """Return a command with ``{distro}``, as the shell's lexer has it, for the distribution in what git checks out."""
    if "git" not in text or not ("distro" in text.lower() or "version" in text.lower()):
        return text
    return _BRANCH.sub(lambda match: f"{match['option']}{match['before']}{DISTRO}", text)


def distros_of(text: str) -> dict[str, str]:
    """Return the variables for which a page exports one value, and that stand for a distribution: ``ros-$ROS1-tf``.

    Not ROS's own variable, which stands for whatever the reader has.
    """
    if "ros-$" not in text:
        return {}
    used = {match[1] for match in _USED.finditer(text)} - {"ROS_DISTRO"}
    values: dict[str, set[str]] = {}
    for match in _EXPORTED.finditer(text):
        values.setdefault(match[1], set()).add(match[3])
    return {name: next(iter(found)) for name, found in values.items() if name in used and len(found) == 1}


def chosen(text: str) -> str:
    """Return a page with the first of the values that it gives for a name in its commands in the place of the name.

    The name stays in backquotes, where the page speaks of it.
    """
    lowered = text.lower() if _NAMED.search(text) else ""
    for form in _CHOSEN if any(said in lowered for said in _SAID) else ():
        for match in form.finditer(text):
            if _RELEASE.search(match["name"]):
                continue  # which one is meant is weighed with all that the tree says
            name = rf"(?<![\w`-]){re.escape(match['name'])}(?![\w`-])"
            text = re.sub(name, match["value"], text)
    return _LEFT.sub(lambda left: left["before"] + _said(left, text), text) if "=[" in text or "=<" in text else text


def _said(left: re.Match[str], text: str) -> str:
    """Return the first value that a page gives for a variable, ``Use `ROUTES=a.xml```, else what stands there."""
    said = re.search(rf"`{left['name']}=([\w.+/-]+)`", text)
    return said[1] if said else left[0].removeprefix(left["before"])


def with_examples(text: str) -> str:
    """Return a page with the command of a remark in the place of the one with blanks that it is an example of."""
    return _EXAMPLE.sub(_as_example, text) if _REMARK.search(text) else text


def _as_example(match: re.Match[str]) -> str:
    """Return the command of a remark if the one above has blanks, and no file of the author's own fills them in."""
    taken = _BLANK.search(match["rest"]) and not _OWN.search(match["command"])
    return f"{match['before']}{match['command']}{match['end']}" if taken else match[0]


def filled(text: str, *, of_page: bool) -> str:
    """Return a command with ``$UNKNOWN`` for each placeholder, and with the first of values to choose from.

    ``of_page``: it stands on a page for people; elsewhere most of this is shell.
    """
    if "<" in text and (of_page or _RUN.search(text)):
        text = BLANK.sub("$UNKNOWN", text)  # otherwise `<sensor name>` would be read as a redirection
    if of_page and "{" in text:
        text = _BRACED.sub("$UNKNOWN", text)
    if of_page and not text.isascii():
        text = _DASH.sub(lambda match: "--" if len(match[1]) > 1 else "-", text)
    if (":= " in text or " :=" in text) and _RUN.search(text):
        text = _SPACED.sub(r"\1:=", text)  # to roslaunch the name alone is one more launch file
    if "={" in text:
        text = _CHOICE.sub(r"\1", text)
    return _OFFERED.sub(r"\1\2", text) if of_page and ("(" in text or "\uff08" in text) else text
