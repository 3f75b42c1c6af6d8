"""What the default command lacks of what a page gives it: the values that the reader fills in, and what is refused."""

from __future__ import annotations

import posixpath
from collections.abc import Collection, Iterator

from roslab.decide.candidate import LAUNCHERS, Candidate, is_python, program_of
from roslab.decide.chores import made_before, prepared_before
from roslab.decide.decision import Warning_
from roslab.decide.demanded_arguments import filled_in
from roslab.decide.filled_in import filled
from roslab.decide.reasons import warn
from roslab.decide.required_options import too_few
from roslab.evidence.facts import Evidence, Mention
from roslab.values.pattern import pattern

_NAMES = "the default command names"
_NOWHERE = "which neither the tree nor a download of the page has: correct it under `command` in roslab.yaml"
_OF_SYSTEM = pattern(
    r"/(?:(?:s?bin|boot|dev|etc|home|lib(?:32|64)?|opt|proc|root|run|sys|tmp|usr|var|Users|ws)(?:/|$)|path|your)|/[^/]*$"
)
"""What an image may have, what is one person's, and what is at the root, whose folder nobody can mount."""
_SETTINGS = pattern(r"(?!\.\.?/\.\.)[\w.][\w./-]*\.(?:ya?ml|json|xml)")
"""By its path from where the command starts."""


def left_to_reader(page: Candidate, evidence: Evidence, there: Collection[str] = ()) -> tuple[Warning_, ...]:
    """Return the warnings about the default command, which is a page's or a guess.

    ``there``: folders of the container that have what nobody reads: mounted ones, and an author's copy of the tree.
    """
    said = next((m for m in evidence.mentions if _is(m, page)), None)
    told = _told(said, page, evidence) if said else _required(page, evidence)
    absent = (warn(f"{_NAMES} {path}, {_NOWHERE}", page) for path in _settings(page))
    counted, outside = _counted(page, evidence), _outside(page, there)
    before = (*prepared_before(page, evidence), *made_before(page, evidence))
    return (*told, *counted, *outside, *absent, *_weights(page, evidence), *before)


def _outside(page: Candidate, there: Collection[str]) -> Iterator[Warning_]:
    """Yield a warning for the folder of the first file that the command names by a path which no image has."""
    for word in page.absent:
        path = posixpath.normpath(word.rpartition("=")[2])
        covered = any(f"{path}/".startswith(f"{folder.rstrip('/')}/") for folder in there)
        if path.startswith("/") and not (covered or _OF_SYSTEM.match(path)):
            folder = posixpath.dirname(path)
            message = f"{_NAMES} {path}, which the image does not have: mount its folder with --volume FOLDER:{folder}"
            yield warn(f"{message}, or give another under `command` in roslab.yaml", page)
            return


def _counted(page: Candidate, evidence: Evidence) -> Iterator[Warning_]:
    """Yield a warning where a compiled program is not given the arguments without which it stops."""
    if said := too_few(page.argv, evidence):
        arguments = "an argument" if said.value == "1" else f"{said.value} arguments"
        message = f"the default command stops without {arguments}, which its program reads ({said.text})"
        yield warn(f"{message}: give them under `command` in roslab.yaml", said)


def _required(guess: Candidate, evidence: Evidence) -> Iterator[Warning_]:
    """Yield a warning where a program that no page starts requires arguments."""
    words = guess.argv[len(program_of(guess.argv)) :]
    needed = [m for m in evidence.mentions if m.topic == "positional" and m.source == "code" and m.file == guess.file]
    if needed and not words and is_python(guess):
        names = ", ".join(dict.fromkeys(m.value for m in needed))
        message = f"the default command stops without {names}, which the program requires"
        yield warn(f"{message}: give it under `command` in roslab.yaml", needed[0])


def _is(mention: Mention, page: Candidate) -> bool:
    same = mention.topic == "command" and (mention.file, mention.line) == (page.file, page.line)
    return same and set(program_of(page.argv)) & {*mention.files, *mention.value.split()} != set()


def _told(said: Mention, page: Candidate, evidence: Evidence) -> Iterator[Warning_]:
    program = next((file for file in said.files if file.endswith(".py")), "")
    gap = filled(said.value, said.files).gap
    options = {m.value: m.text for m in evidence.mentions if m.topic == "option" and m.file == program}
    needed = list(dict.fromkeys(m.value for m in evidence.mentions if m.topic == "positional" and m.file == program))
    given = sum(not word.startswith("-") for word in page.argv[len(program_of(page.argv)) :])
    missing = needed[given:] if "" in gap else []
    if missing:
        yield warn(
            f"the default command stops without {', '.join(missing)}, which the page leaves to the reader: give it "
            "under `command` in roslab.yaml",
            said,
        )
    if numbers := _not_given(page, evidence):
        yield warn(
            f"the script of the default command gives options the values {' and '.join(numbers)}, which the page "
            "leaves out: give them under `command` in roslab.yaml",
            said,
        )
    if named := [name for name in dict.fromkeys(gap) if name and options.get(name) != "default"]:
        yield warn(
            f"the default command is without what the page leaves to the reader ({', '.join(named)}): give it under "
            "`command` in roslab.yaml where it is needed",
            said,
        )
    yield from filled_in(page, said.value)
    for mention in evidence.mentions:
        if mention.topic == "refused" and (mention.file, mention.line) == (said.file, said.line):
            yield warn(
                f"Hydra refuses the argument {mention.value} of the default command, which has no `=`: correct it "
                "under `command` in roslab.yaml",
                said,
            )


def _settings(page: Candidate) -> list[str]:
    """Return the files of settings that the tree lacks; what a launch file is given may lie in its package."""
    return [] if page.argv[0] in LAUNCHERS else [word for word in page.absent if _SETTINGS.fullmatch(word)]


def _weights(page: Candidate, evidence: Evidence) -> Iterator[Warning_]:
    """Yield a warning for the first file of weights that the command's settings name and that a script downloads."""
    fetched = {file for m in evidence.mentions if m.topic in {"fetched", "unpacked"} for file in m.files} - {"", "."}
    named = [m for m in evidence.mentions if m.topic == "weights" and {*m.files} & {*page.files}]
    named = [m for m in named if not any(m.value == file or m.value.startswith(f"{file}/") for file in fetched)]
    for mention in named[:1]:
        message = f"the default command's settings name {mention.value}, which the tree lacks"
        yield warn(
            f"{message}: the page downloads such files (`{mention.text}`); fetch it by `custom` in roslab.yaml", mention
        )


def _not_given(page: Candidate, evidence: Evidence) -> list[str]:
    """Return the parameters of a shell script (``$1``) that it needs and the command does not have."""
    script, *given = page.argv[1:] if page.argv[0] == "bash" else ("",)
    found = (m.value for m in evidence.mentions if m.topic == "parameter" and m.file == script)
    return [f"${number}" for number in dict.fromkeys(found) if int(number) > len(given)]
