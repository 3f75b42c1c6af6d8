"""Names in running text: ROS distros, Ubuntu releases, CUDA and Python versions, lists of repositories."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from functools import cache
from typing import Literal

from roslab.evidence.facts import Mention
from roslab.evidence.lex.lines import matches_at
from roslab.evidence.prose import gazebo
from roslab.knowledge.distros import english_words, ever, ubuntus
from roslab.values.pattern import pattern

MAX_MENTIONS = 120
"""Most mentions per file and topic: a changelog names very many versions."""
_NO_UBUNTU = {
    "focal": r"(?!['\u2019]?s?[\s_-]{1,3}(?:lengths?|points?|planes?|search|fields?|distances?|axis|ratio|loss|spots?))"
}
"""What follows a word that is no release name there: "focal length" is no Ubuntu."""
_QUALIFIED = r"(?:lts|linux|version|\(?(?:64|32)[\s-]?bits?\)?)"
"""What may stand before a release's number: ``Ubuntu 64-bit 16.04``."""
_KIND = r"(?:desktop|server|os|distribution|release|versions?|lts|\u7248\u672c|\u7cfb\u7edf)"
"""What else may stand before a whole one, also in Chinese: ``Ubuntu Desktop 22.04``, ``Ubuntu version: 22.04``."""
_CUDA = r"cuda(?:[\s_-]{0,3}toolkit)?(?:\s{0,3}\(?(?:version|v|==?|>=|~|:|\|)?\s{0,3}|[-=:]{1,3})(\d{1,2}\.\d)"
_CUDNN = r"cudnn(?:[\s:v=_-]|version){0,9}(\d)"
_PYTHON = (
    r"python(?:[`*_]{0,3}\s{0,3}(?:versions?\s{0,3})?(?:>=|<=|==?|~=|[:|(]|is|up\s?to|until|at most)?\s{0,3}[`*_]{0,3}"
    r"|[-=])([23]\.\d{1,2})(?:\.\d+|\.x)?(?!\d)"
)
_LOCAL = pattern(r"(?<=[+/])cu(\d{2,3})\b")
"""``+cu118`` and ``/cu118``."""
_MORE = pattern(r"(?:[\s,/|&-]{0,4}(?:or|and|to)?\s{0,3}(?:python)?\s{0,2}[23]\.\d{1,2}(?!\.?\d)){1,6}", re.IGNORECASE)
"""What may follow a Python version: ``3.6, 3.7 or 3.8``. Blanks are bounded, so that no line takes long."""
_LETTERS = bytes(byte if chr(byte).isascii() and chr(byte).isalpha() else 32 for byte in range(256))
"""What stands for each byte of a text that is to be split into words of letters alone."""
_LIST = pattern(
    r"(?:https?://[^\s\"'`<>()]{1,300}/|(?<![A-Za-z]))([\w-][\w.-]{0,60}\.(?:repos|rosinstall))\b", re.IGNORECASE
)


def _word(source: str) -> re.Pattern[str]:
    return pattern(rf"(?<![A-Za-z])(?:{source})", re.IGNORECASE)


_NO_MORE = r"(?!\.?\d)(?!\s{0,2}(?:[GMTK]i?B|bit|cores?|threads?|CPU)\b)(?!(?:st|nd|rd|th)\b)"
"""What does not follow the year alone of a release: another number, or what it counts."""
Topic = Literal["distro", "ubuntu", "cuda", "cudnn", "python", "no_python", "vcs_file"]


@cache
def _patterns() -> tuple[tuple[Topic, tuple[str, ...], re.Pattern[str]], ...]:
    """Return each topic with texts, of which every match has one, and its pattern, made from the tables' names.

    Where the pattern is a ``_word``, its matches begin with one of the texts.
    """
    whole = "|".join(map(re.escape, ubuntus()))
    numbers = f"{whole}|" + "|".join(version.removesuffix(".04") + _NO_MORE for version in ubuntus())
    codenames = "|".join(name + _NO_UBUNTU.get(name, "") for name in ubuntus().values())
    return (
        ("distro", tuple(sorted(ever())), _word(rf"({'|'.join(sorted(ever()))})s?(?![A-Za-z])")),  # ROS KINETICS
        (
            "ubuntu",
            ("ubuntu", *ubuntus().values()),
            _word(
                rf"(?:ubuntu[\s:_-]{{0,3}}(?:{_QUALIFIED}[\s,]{{0,2}}){{0,2}}({numbers})|"
                rf"ubuntu\s{{0,2}}(?:{_KIND}\s{{0,2}}){{0,2}}[|:(\uff08\uff1a]?\s{{0,2}}({whole})|"
                rf"({codenames}))(?!(?!lts\b|x(?:64|86))[A-Za-z])"
            ),
        ),
        ("cuda", ("cuda",), _word(_CUDA)),
        ("cuda", ("+cu", "/cu"), _LOCAL),
        ("cudnn", ("cudnn",), _word(_CUDNN)),
        ("python", ("python",), _word(_PYTHON)),
        ("vcs_file", (".repos", ".rosinstall"), _LIST),
    )


@cache
def _goes_on() -> dict[str, tuple[re.Pattern[str], re.Pattern[str]]]:
    """Return, for each topic, a pattern for a list of further versions, and one for a version in it."""
    number = "|".join(map(re.escape, ubuntus()))
    released = r"(?:1\d|2\d)\.(?:04|10)"  # those between two long-term releases may stand in a list of them
    more = rf"(?:[\s,/|&~-]{{0,4}}(?:or|and|to)?\s{{0,3}}(?:ubuntu)?\s{{0,2}}{released}(?![\d.]\d)){{1,5}}"
    return {
        "python": (_MORE, pattern(r"\d\.\d{1,2}")),
        "ubuntu": (pattern(more, re.IGNORECASE), pattern(number)),  # 18.04~20.04
    }


_TRACEBACK = pattern(r"File \"[^\"\n]{0,200}\Z")
"""A line of a traceback before a Python version: it is about somebody's own machine."""
_REMOVED = pattern(
    r"(?<![\w./-])(?:rm|unlink|(?:apt|apt-get|brew|conda)\s+(?:remove|purge|unlink|uninstall)|setcap|getcap)\s[^\n;&|]{0,200}\Z"
)
"""A command before a Python version that takes it away, or its privileges: it is about the author's machine."""
_OF_MODULE = pattern(r"(?<![\w./-])(?:ml|module)\s+[^\n;&|]{0,120}/[\w.+-]{1,40}-\Z", re.IGNORECASE)
"""What stands before the CUDA that a cluster built another module with: ``ml load TensorFlow/2.15.1-CUDA-12.1.1``."""
_EXAMPLE = pattern(r"\b(?:for example|for instance|e\.g\.)[^\n]*:\W*(?:<br ?/?>)?\W*\Z", re.IGNORECASE)
"""A line that an example follows, which then stands in a block of its own."""
_MASTER = pattern(r"\broscore\b")
_CONTEXT = pattern(r"\bros\b|ros[-_ ]?[12]|distro|ubuntu|branch|catkin|colcon|/opt/ros", re.IGNORECASE)
_OF_A_SYSTEM = pattern(r"debian|linux|codename|docker|\bapt(?:-get)?\b|\blts\b|\b\d\d\.(?:04|10)\b", re.IGNORECASE)
_ITEM = pattern(r"-[ \t]+[\"']?\w+[\"']?")
_ITEMS = pattern(rf"^[ \t]*{_ITEM.pattern}[ \t]*$", re.MULTILINE)
"""One word of a list of YAML that has a line for each, and all of them."""
_NEAR = 160
"""How far from a word of such a list the others are looked for."""
_STOOD_ON = pattern(r"\b(?:on|for|under)\s+(?:the\s+)?[`*_\"']{0,3}\Z", re.IGNORECASE)
_ENDS = pattern(r"[`*_\"']{0,3}\s*(?:[^\w\s]|(?:and|or)\b|\n|\Z)", re.IGNORECASE)


def read(text: str, file: str, source: Literal["dockerfile", "ci", "readme", "script"]) -> Iterator[Mention]:
    """Yield the versions that a text names, with the line each stands on."""
    yield from gazebo.named(text, file, source)
    yield from _masters(text, file) if source == "readme" else ()
    lowered = text.lower()
    for topic, words, each in _patterns():
        position, line, found = 0, 1, 0
        named = _distros_in(lowered) if topic == "distro" else words
        for match in _matches(each, named, text, lowered):
            start = max(text.rfind("\n", max(0, match.start() - 200), match.start()) + 1, match.start() - 90)
            end = text.find("\n", match.end(), match.end() + 90)
            context = text[max(0, start) : end if end >= 0 else match.end() + 90].strip()
            value = next(group for group in match.groups() if group).lower()
            value = f"{value}.04" if topic == "ubuntu" and value.isdecimal() else value  # ``Ubuntu 24``
            if topic == "distro" and value in english_words() and not _means_ros(match, context, source):
                continue
            if topic == "ubuntu" and source == "readme" and not _a_release(value, context, match):
                continue
            if _of_others(topic, text, max(0, start), match.start()):
                continue
            if topic == "distro" and source == "readme":
                context = _introduced(text, start, context)
            if each is _LOCAL:
                value = f"{value[:-1]}.{value[-1]}"
            line += text.count("\n", position, match.start())
            position = match.start()
            left = _denied(text, match) if topic == "python" and source == "readme" else ""
            said: Topic = "no_python" if left else topic
            for stated in (f"{left}{value}", *(() if left else _further(topic, text, match.end()))):
                yield Mention(topic=said, value=stated, source=source, file=file, line=line, text=context)
            found += 1
            if found >= MAX_MENTIONS:
                break


def _of_others(topic: Topic, text: str, start: int, end: int) -> bool:
    """Tell whether the line before a version, from ``start`` to ``end``, shows that the code is not about it."""
    if topic == "cuda":
        return bool(_OF_MODULE.search(text, start, end))
    return topic == "python" and _of_no_use(text, start, end)


def _masters(text: str, file: str) -> Iterator[Mention]:
    """Yield the first place where a page names the program that is the master of ROS 1."""
    if found := _MASTER.search(text):
        line = text.count("\n", 0, found.start()) + 1
        yield Mention(topic="master", value="roscore", source="readme", file=file, line=line, text=found[0])


def _denied(text: str, match: re.Match[str]) -> str:
    from roslab.evidence.prose.denied import denied  # noqa: PLC0415 - few pages name a Python

    return denied(text, match.start(), match.end())


def _means_ros(match: re.Match[str], context: str, source: str) -> bool:
    """Tell whether an ordinary word is a distribution: ROS, a branch, an Ubuntu or one that is none is near it.

    Or it labels a block. In a list of CI that has a line for each, the others are near.
    """
    from roslab.evidence.prose.labels import is_label  # noqa: PLC0415 - few pages have such a word

    labels = source == "readme" and is_label(match.string, match.start(), match.end())
    if labels or _CONTEXT.search(context):
        return True
    beside = [context]
    if source == "ci" and _ITEM.fullmatch(context):
        beside += _ITEMS.findall(match.string, max(0, match.start() - _NEAR), match.end() + _NEAR)
    return not _no_words().isdisjoint(name for each in beside for name in _distros_in(each.lower()))


@cache
def _no_words() -> frozenset[str]:
    """Return the distributions whose names are no ordinary words: where one stands, another word is one too."""
    return frozenset(ever()) - frozenset(english_words())


def _a_release(value: str, context: str, match: re.Match[str]) -> bool:
    """Tell whether a page means a release of Ubuntu by its name: each of them is an ordinary word, too.

    What tells is a word of a system or another release on its line, nothing else on it, or "on" right before it.
    """
    names = set(ubuntus().values())
    if value not in names or _CONTEXT.search(context) or _OF_A_SYSTEM.search(context):
        return True
    words = set(re.findall(r"[a-z]+", context.lower()))
    if words == {value} or words & (names - {value}):
        return True
    text = match.string
    return bool(_STOOD_ON.search(text, max(0, match.start() - 20), match.start()) and _ENDS.match(text, match.end()))


def _of_no_use(text: str, start: int, end: int) -> bool:
    """Tell whether what stands before a Python version on its line says that it is not the one to take."""
    return any(before.search(text, start, end) for before in (_TRACEBACK, _REMOVED))


def _distros_in(lowered: str) -> list[str]:
    """Return the names of distributions that stand in a text, which is faster than to look for each of them."""
    words = frozenset(lowered.encode(errors="replace").translate(_LETTERS).split())
    return [name for name, forms in _forms() if not forms.isdisjoint(words)]


@cache
def _forms() -> tuple[tuple[str, frozenset[bytes]], ...]:
    """Return the name of each distribution with the words that name it: ``kinetic``, ``kinetics``."""
    return tuple((name, frozenset({name.encode(), f"{name}s".encode()})) for name in sorted(ever()))


def _matches(each: re.Pattern[str], words: Iterable[str], text: str, lowered: str) -> Iterator[re.Match[str]]:
    """Return the matches of a pattern; most texts have few of the words, and each pattern has to be compiled."""
    if each not in {_LOCAL, _LIST} and len(lowered) == len(text):
        return matches_at(each, text, *words, place_in=lowered)
    # It begins otherwise; or a letter became two, so that a place in one text is none in the other
    return each.finditer(text) if any(word in lowered for word in words) else iter(())


def _introduced(text: str, start: int, context: str) -> str:
    """Return a line with the one above it, if that introduces an example: ``For example, on kinetic:``."""
    above = text[max(0, start - 400) : max(0, start)].rstrip("`~ \t\r\nabhs").rpartition("\n")[2]
    return f"{above.strip()} {context}" if _EXAMPLE.search(above) else context


def _further(topic: str, text: str, end: int) -> list[str]:
    """Return the versions that follow one directly: ``Python 3.6, 3.7 or 3.8``."""
    if topic not in _goes_on():
        return []
    goes_on, number = _goes_on()[topic]
    more = goes_on.match(text, end)
    return number.findall(more[0]) if more else []
