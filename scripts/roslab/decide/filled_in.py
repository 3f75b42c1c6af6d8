"""Commands of pages without the values that the reader fills in."""

from __future__ import annotations

import itertools
import re
from typing import NamedTuple

from roslab.decide.bare_options import ROS_ARGUMENTS, RULES, without_bare
from roslab.decide.blank_launches import BLANK
from roslab.decide.candidate import is_component
from roslab.decide.outputs import names_output, written_below
from roslab.values.pattern import pattern

PLACEHOLDER = pattern(
    r"YOUR|your[_-]|path[/_-]to|/path|/where/|\[|\]|\.\.\.|…|/home/|~|\$|<|>|\{[a-z]\w*\}|xxx|(?<![a-z])([a-z])\1{2,}(?![a-z])|"
    r"(?-i:(?<![A-Za-z])XX(?![A-Za-z])|/[A-Z_]{5,}(?:\.\w+)?$|(?:=|^)[A-Z_]+_(?:NAME|PATH|DIR|FILE|FOLDER|ID|IP|ROOT|LOCATION)$)|"
    r"^-{0,2}(?:[\w-]+=)?\w*[_-]\*$",
    re.IGNORECASE,
)
"""Also ``yyy-yy``, as a repeated letter stands for a value that the reader fills in, ``name:=PACKAGE_NAME``, and
``--config-name=train_*``: what a shell would fill in has a folder or an ending, ``data/*.png``."""
_BRACKETS = pattern(r"<[^<>]{1,80}>|\[[^\[\]]{1,80}\]|\$\([^()]{1,80}\)")
"""A blank of several words: ``<path to the data>``, ``[--option VALUE]``, ``$(rospack find demo)``."""
_OPTIONAL = pattern(r"\[\s*(?:-|\w+:=)")
_NUMBERS = pattern(r"\[[.,\s-]*\d[\d.,\s-]*\]")
"""A list of numbers: ``--hid [32,32]``."""
_PATHS = pattern(r"(?<==)\[([\w.:-]*/[\w./:,-]+)\]")
"""A list of paths that Hydra is given: ``models=[out/a.pth,out/b.pth]``."""
_NAMED_VALUE = pattern(r"([\w-]+) \1[_-](?:name|id|path|dir|folder|file)", re.IGNORECASE)
"""An option and a value that only says what it is: ``--algo algo_name``."""
_SAYS_WHAT = pattern(r"(?:^|=)[a-z]+(?:_[a-z]+)*_(?:path|dir|directory|folder|filename|file|name)$")
"""A value that only says what belongs there: ``log_file_path``, ``map:=map_name``."""
_NUMBERED = pattern(r"(?:--?(?:\w+[_-])?)?(?:args?|arguments?|options?)[_-]?(?:\d|[nN])", re.IGNORECASE)
"""An argument that only says that there are some: ``--train_arg_1``, ``arg1``, ``--option-N``."""
_STANDS_FOR = pattern(
    r"(?:^|=)(?:CONFIG|FILE|INPUT|OUTPUT|IMAGE|VIDEO|MODEL|CHECKPOINT|DATASET)(?:_(?:FILE|NAME))?\.[a-z]\w{0,4}$"
)
"""A file of the reader's own, where the tree has none of that name: ``CONFIG.yaml``."""
_KEY = pattern(r"[A-Z][A-Z0-9_]*(?:\.[A-Z][A-Z0-9_]*)+")
"""A key of yacs, whose value is the next word: ``MODEL.WEIGHTS a.pth``."""
_OVERRIDE = pattern(r"[+~]{0,2}[A-Za-z_][\w./@-]*=(?!=)")
"""An argument with its name, as Hydra takes them in any order: ``data.root=PATH``."""
_COLON = pattern(r"([A-Za-z_]\w{2,}):(?!=|//)")
"""An argument with its name, as programs take it that split it themselves: ``file_path:/path/to/a.yaml``."""
_CAPITALS = pattern(r"[A-Z]{2,}(?:_[A-Z]+)*")
_GIVEN = pattern(r"(?:-{0,2}|.*\.)([A-Za-z][\w-]*):?=(.*)")
"""An argument with its value: ``--seed=SEED``, ``train.seed=SEED``, ``map:=MAP``."""
_ARGUMENT = pattern(r"[a-z][a-z0-9]*(?:_[a-z0-9]+)+")
FEWEST = 2
"""Fewest arguments that show how a program takes them."""
_AMOUNTS = frozenset({"NUM", "NUMBER", "SIZE", "COUNT"})
_MORE = frozenset({*_AMOUNTS, "OF", "THE", "YOUR", "NAME", "VALUE", "ID", "LIST"})
"""Words that may stand beside the name of an option in a value that only says what belongs there."""


class Filled(NamedTuple):
    """A command without the values that the reader fills in."""

    words: tuple[str, ...]
    gap: tuple[str, ...]
    """The options that went with their values, ``""`` for anything else but ``map:=PATH``: these leave a gap."""
    blanks: tuple[str, ...]
    """Names of arguments that a launch file may have a default for: ``map:=PATH``."""


def filled(command: str, files: tuple[str, ...]) -> Filled:
    """Return a command without the values that the reader fills in.

    ``map:=PATH`` is left out whole, as the launch file may have a default, and its name returned; an option goes with
    its value, and what follows an argument that is left out, with it; one that has several, and ``--ros-args``, with
    the last of them. Words that name the program stay, and so do ``files``, which the tree has.
    """
    kept: list[str] = []
    blanks: list[str] = []
    gap: list[str] = []
    emptied: set[int] = set()
    positional = False
    words = _BRACKETS.sub(_blank, command).split()
    words = words[1:] if words[:1] == words[1:2] else words  # ``roslaunch roslaunch``
    pairs = _paired(words)
    for said, following in itertools.zip_longest(words, words[1:], fillvalue=""):
        word = written_below(kept[-1] if kept else "", said)
        blank = bool(PLACEHOLDER.search(_PATHS.sub(r"\1", _NUMBERS.sub("", word)))) or word.endswith(":=")
        value = kept[-1:] != [ROS_ARGUMENTS] and bool(kept) and kept[-1][:1] == "-" != word[:1]
        blank = blank or (value and bool(_NAMED_VALUE.fullmatch(f"{kept[-1].lstrip('-')} {word}")))
        unknown = bool(_SAYS_WHAT.search(word) or _STANDS_FOR.search(word) or _NUMBERED.fullmatch(word))
        unknown = unknown and word not in files
        blank = blank or (value and word in {"N", "X"}) or unknown
        keys = value and following[:1].isdigit()  # ``NUM_GPUS 8`` is a key of yacs with its value
        blank = blank or (word not in files and not keys and _names_option(kept[-1] if value else "", word))
        blank = blank and not (word in pairs or names_output(kept[-1] if value else "", word))
        if not _named(kept) or not (blank or (positional and not value and word[:1] != "-")):
            kept.append(word)
            continue
        keyed = _named(kept[:-1]) and bool(_KEY.fullmatch(kept[-1])) and "=" not in word
        colon = _COLON.match(word) if not value else None
        override = not value and bool(colon or _OVERRIDE.match(word))
        option = word.partition("=")[0] if word.startswith("-") or override else kept[-1] if value else ""
        option = colon[1] if colon else option
        if keyed or (value and (":=" not in word or kept[-1] in RULES)):
            kept.pop()  # the option goes with it: ``-p map:=PATH``, and ``MODEL.WEIGHTS PATH``
            emptied.discard(len(kept))
        if keyed and kept[-1].startswith("-"):
            emptied.add(len(kept) - 1)  # ``--opts MODEL.WEIGHTS PATH``, unless another key follows
        if ":=" not in word:
            gap.append(option)
            positional = positional or not (value or keyed or override or word.startswith("-"))
        else:
            blanks.append(word.partition(":=")[0])
    return Filled(without_bare(kept, emptied), tuple(gap), tuple(blanks))


def _paired(words: list[str]) -> frozenset[str]:
    """Return the names of arguments that a program splits itself by twos: ``environment_path rooms start_id 0``.

    Each of them is a name of several words, and has a value that is none of the reader's.
    """
    start = next((at for at in range(1, len(words)) if _named(words[:at])), len(words))
    names, values = words[start::2], words[start + 1 :: 2]
    told = len(names) == len(values) >= FEWEST and all(map(_ARGUMENT.fullmatch, names))
    own = any(PLACEHOLDER.search(value) or _SAYS_WHAT.search(value) or value[:1] == "-" for value in values)
    return frozenset(names) if told and not own else frozenset()


def _names_option(option: str, word: str) -> bool:
    """Tell whether a value is a name in capitals for an amount or for what its option is: ``--gpus NUM_GPUS``."""
    given = _GIVEN.fullmatch(word)
    option, value = (given[1], given[2]) if given else (option, word)
    if not option or not _CAPITALS.fullmatch(value):
        return False
    words = {each.removesuffix("S") for each in value.split("_")}
    own = {each.removesuffix("S") for each in re.split(r"[-_]+", option.upper()) if each}
    amount = len(words) > 1 and not _AMOUNTS.isdisjoint(words)
    return amount or (not own.isdisjoint(words) and words <= own | _MORE)


def _blank(match: re.Match[str]) -> str:
    """Return a blank without its words, nothing for an argument that may be left out: ``[rviz:=true]``."""
    if _NUMBERS.fullmatch(match[0]) or _PATHS.match(match.string, match.start()):
        return match[0]
    return "" if _OPTIONAL.match(match[0]) else BLANK


def _named(words: list[str]) -> bool:
    """Tell whether the first words of a command name its program."""
    if words and words[0].startswith("python"):
        return any(word.endswith(".py") for word in words) or "-m" in words[:-1]
    fewest = {"roslaunch": 3, "rosrun": 3, "ros2": 4, "bash": 2, "sh": 2}.get((words or [""])[0], 1)
    return len(words) >= fewest + is_component(words)
