"""Whether a program can do without what a page gives it: what it tells argparse, click or Hydra of an argument."""

from __future__ import annotations

import posixpath
from collections.abc import Iterable, Iterator
from itertools import pairwise

from roslab.evidence.facts import Mention
from roslab.evidence.lex.lines import matches_at
from roslab.evidence.program import Program
from roslab.repository.checkout import Repository
from roslab.values.dataclass import replace
from roslab.values.pattern import pattern

MAX_SIZE = 128 * 1024
MAX_CALL = 1500
MOST = 60
"""Most programs that no page starts of which the arguments are read."""
_CALL = pattern(r"(?:add_argument|click\.option)\(\s*((?:[\"']-{1,2}[\w-]+[\"']\s*,?\s*)+)")
_POSITIONAL = pattern(r"add_argument\(\s*[\"']([A-Za-z]\w*)[\"']")
_LEFT_OUT = pattern(r"\bnargs\s?=\s?(?:[\"'][?*]|argparse\.REMAINDER)")
"""An argument without a dash that may be left out."""
_ARGUMENT = "@click.argument("
"""Required but by a default: https://click.palletsprojects.com/en/stable/arguments/, read 2026-11-28."""
_HYDRA = "@hydra.main"
_KEY = pattern(r"[a-z_][\w-]*(?:[./][\w-]+)+")
"""A key of a configuration: ``trainer.devices``."""
_NAME = pattern(r"-{1,2}[\w-]+")
_REQUIRED = pattern(r"\brequired\s?=\s?True\b|\bprompt\s?=\s?(?!False\b|None\b)")
_DEMANDED = pattern(r"\brequired\s?=\s?True\b")
_GIVEN = pattern(
    r"\bdefault\s?=\s?(?!None\b)|\bis_flag\s?=\s?True\b|\baction\s?=\s?[\"'](?:store_|append|count|help|version)"
)
_SETTINGS = pattern(r"\bdefault\s?=\s?[\"']([\w./-]+\.(?:ya?ml|json|toml|conf|cfg|ini|xml|gin))[\"']")
"""A default that is a file of settings, which is read; other files may be written."""


def read(repository: Repository, mentions: Iterable[Mention]) -> Iterator[Mention]:
    """Yield each option with which a page starts a file of Python, with ``required``, ``open`` or ``default``.

    ``open`` has neither a value of its own nor is it required, or its value is a file of settings that the tree lacks:
    the program may go on without, or stop. Nothing of an option that the file itself does not define.
    https://docs.python.org/3/library/argparse.html, read 2026-11-25
    click asks for an option with a ``prompt`` where it is not given, and nobody answers in an image:
    https://click.palletsprojects.com/en/stable/options/#prompting, read 2026-11-26
    The arguments without a dash that the program requires are ``positional``, and one that Hydra refuses is
    ``refused``: https://hydra.cc/docs/advanced/override_grammar/basic/, read 2026-11-26.
    """
    for mention in mentions:
        program = next((file for file in mention.files if file.endswith(".py")), "")
        if mention.topic != "command" or mention.source != "readme" or not program:
            continue
        text = repository.read(program, limit=MAX_SIZE)
        for name in (positional := _positional(text)):
            yield replace(mention, topic="positional", value=name, text=name, file=program, files=(), inside="")
        if positional:
            yield replace(mention, topic="option", value="", text="required", file=program, files=(), inside="")
        for word in _refused(mention.value, program) if _HYDRA in text else ():
            yield replace(mention, topic="refused", value=word, text=mention.value, inside="")
        given = {word.partition("=")[0] for word in mention.value.split() if word.startswith("-")}
        told = _options(text, program, repository) if given else {}
        for name in sorted(given & told.keys()):
            yield replace(mention, topic="option", value=name, text=told[name], file=program, files=(), inside="")


def of_programs(repository: Repository, programs: Iterable[Program], mentions: Iterable[Mention]) -> Iterator[Mention]:
    """Yield the arguments without a dash that programs require which no page starts: nothing gives them any.

    Of all programs, also the options that they require, each with all its names: ``-m --map``.
    """
    said = [mention for mention in mentions if mention.topic == "command"]
    started = {file for mention in said for file in mention.files}
    by_ros = {word for m in said if m.value.startswith("ros") for word in m.value.split()[:4] if word.endswith(".py")}
    known = list(programs)
    others = [each for each in known if each.kind == "main" and each.file not in started]
    ours = [each for each in known if each.file in started or each.file.rpartition("/")[2] in by_ros]
    for program in (*ours, *others[:MOST]):
        text = repository.read(program.file, limit=MAX_SIZE)
        at = Mention(topic="required", value="", source="code", file=program.file, line=program.line, text="")
        for name in _positional(text) if program.file not in started else ():
            yield replace(at, topic="positional", value=name, text=name)
        for name in _required(text):
            yield replace(at, value=name, text=name)


def demands(text: str) -> bool:
    """Tell whether a program stops without an argument, by its calls of argparse or click."""
    return bool(_positional(text) or _required(text)) or _ARGUMENT in text


def _positional(text: str) -> tuple[str, ...]:
    """Return the arguments without a dash that a program requires, ``()`` where it has parsers for several commands."""
    if "add_subparsers(" in text:
        return ()
    found = dict.fromkeys(
        match[1]
        for match in matches_at(_POSITIONAL, text, "add_argument(")
        if not _LEFT_OUT.search(_until_closed(text[match.end() : match.end() + MAX_CALL]))
    )
    return tuple(found)


def _required(text: str) -> tuple[str, ...]:
    """Return the options that argparse requires, ``()`` where it has parsers for several commands or may set others."""
    if "required" not in text or "add_subparsers(" in text or "set_defaults(" in text:
        return ()
    found = matches_at(_CALL, text, "add_argument(")
    rests = ((match, _until_closed(text[match.end() : match.end() + MAX_CALL])) for match in found)
    return tuple(dict.fromkeys(" ".join(_NAME.findall(match[1])) for match, rest in rests if _DEMANDED.search(rest)))


def _refused(command: str, program: str) -> Iterator[str]:
    """Yield the words behind a program that are neither an option nor a value of one, and have no ``=``."""
    words = command.split()
    behind = words[words.index(program) :] if program in words else []
    for before, word in pairwise(behind):
        if not word.startswith(("-", "~")) and not before.startswith("-") and _KEY.fullmatch(word):
            yield word


def _options(text: str, program: str, repository: Repository) -> dict[str, str]:
    found: dict[str, str] = {}
    for match in matches_at(_CALL, text, "add_argument(", "click.option("):
        rest = _until_closed(text[match.end() : match.end() + MAX_CALL])
        given = _GIVEN.search(rest) and not _lacks(rest, program, repository)
        told = "required" if _REQUIRED.search(rest) else "default" if given else "open"
        found |= dict.fromkeys(_NAME.findall(match[1]), told)
    return found


def _lacks(rest: str, program: str, repository: Repository) -> bool:
    """Tell whether the default is a file of settings that neither the root nor the program's folder has."""
    match = _SETTINGS.search(rest)
    folders = ("", posixpath.dirname(program))
    return match is not None and not any(
        repository.has(posixpath.normpath(posixpath.join(folder, match[1]))) for folder in folders
    )


def _until_closed(text: str) -> str:
    """Return what stands before the parenthesis that closes a call; those in strings count too."""
    depth = 1
    for place, letter in enumerate(text):
        depth += (letter == "(") - (letter == ")")
        if depth == 0:
            return text[:place]
    return text
