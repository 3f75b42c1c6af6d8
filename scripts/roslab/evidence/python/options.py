"""Whether a program can do without an option that a page gives it: what it tells argparse, or click, of the option."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from roslab.evidence.facts import Mention
from roslab.evidence.lex.lines import matches_at
from roslab.repository.checkout import Repository
from roslab.values.dataclass import replace
from roslab.values.pattern import pattern

MAX_SIZE = 128 * 1024
MAX_CALL = 1500
_CALL = pattern(r"(?:add_argument|click\.option)\(\s*((?:[\"']-{1,2}[\w-]+[\"']\s*,?\s*)+)")
_NAME = pattern(r"-{1,2}[\w-]+")
_REQUIRED = pattern(r"\brequired\s?=\s?True\b|\bprompt\s?=\s?(?!False\b|None\b)")
_GIVEN = pattern(
    r"\bdefault\s?=\s?(?!None\b)|\bis_flag\s?=\s?True\b|\baction\s?=\s?[\"'](?:store_|append|count|help|version)"
)


def read(repository: Repository, mentions: Iterable[Mention]) -> Iterator[Mention]:
    """Yield each option with which a page starts a file of Python, with ``required``, ``open`` or ``default``.

    ``open`` has neither a value of its own nor is it required: the program may go on without, or stop. Nothing of an
    option that the file itself does not define. https://docs.python.org/3/library/argparse.html, read 2026-11-25
    click asks for an option with a ``prompt`` where it is not given, and nobody answers in an image:
    https://click.palletsprojects.com/en/stable/options/#prompting, read 2026-11-26
    """
    for mention in mentions:
        program = next((file for file in mention.files if file.endswith(".py")), "")
        if mention.topic != "command" or mention.source != "readme" or not program:
            continue
        given = {word.partition("=")[0] for word in mention.value.split() if word.startswith("-")}
        told = _options(repository.read(program, limit=MAX_SIZE)) if given else {}
        for name in sorted(given & told.keys()):
            yield replace(mention, topic="option", value=name, text=told[name], file=program, files=(), inside="")


def _options(text: str) -> dict[str, str]:
    found: dict[str, str] = {}
    for match in matches_at(_CALL, text, "add_argument(", "click.option("):
        rest = _until_closed(text[match.end() : match.end() + MAX_CALL])
        told = "required" if _REQUIRED.search(rest) else "default" if _GIVEN.search(rest) else "open"
        found |= dict.fromkeys(_NAME.findall(match[1]), told)
    return found


def _until_closed(text: str) -> str:
    """Return what stands before the parenthesis that closes a call; those in strings count too."""
    depth = 1
    for place, letter in enumerate(text):
        depth += (letter == "(") - (letter == ")")
        if depth == 0:
            return text[:place]
    return text
