"""Programs of C and C++ that stop without arguments: ``main`` reads them untested, or ends where there are too few."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator

from roslab.evidence import places
from roslab.evidence.cmake_project import CMakeProject
from roslab.evidence.facts import Mention
from roslab.evidence.lex.c_comments import without_c_comments
from roslab.repository.checkout import File, Repository
from roslab.values.pattern import pattern

MAX_SIZE = 256 * 1024
MAX_FILES = 1_000
_CODE = (".cpp", ".cc", ".cxx", ".c", ".cu")
_MAIN = pattern(
    r"\bmain\s*\(\s*(?:const\s+)?int\s+(\w+)\s*,\s*(?:const\s+)?char\s*(?:const\s*)?\*[\s*]*(\w+)\s*(?:\[\s*\])?\s*\)"
)
_ENDS = pattern(r"\b(?:return\b|exit\s*\()")
_FAILS = pattern(r"\bthrow\b|\b(?:return\b|exit\s*\()(?!\s*\(?\s*(?:0|EXIT_SUCCESS|false)?\s*\)?\s*;)")
_USAGE = pattern(r"usage", re.IGNORECASE)
_DIRECTIVE = pattern(r"[ \t]*#[ \t]*(if[ \t]+0\b|if|else|elif|endif)")


def read(repository: Repository, projects: Iterable[CMakeProject]) -> Iterator[Mention]:
    """Yield, for the only file that a program is named after, how many arguments it needs at least."""
    named = {name for each in projects for name, _ in each.executables}
    files: dict[str, list[File]] = {}
    for file in repository.suffixed(*_CODE) if named else ():
        stem = file.name.rpartition(".")[0]
        if stem in named and not (places.vendored(file.path) or places.test(file.path)):
            files.setdefault(stem, []).append(file)
    for file, *others in list(files.values())[:MAX_FILES]:
        text = "" if others or file.size > MAX_SIZE else repository.read(file)
        if "main" in text and (found := needed(text)):
            number, position, said = found
            line = text.count("\n", 0, position) + 1
            yield Mention(
                topic="argument_count", value=str(number), source="code", file=file.path, line=line, text=said
            )


def needed(text: str) -> tuple[int, int, str] | None:
    """Return how many arguments a program needs, where its text tells and by what; ``None`` where it may need none."""
    text = _without_dead(text)
    start = _MAIN.search(text)
    if start is None:
        return None
    body = without_c_comments(text[start.end() :])
    names = re.escape(start[1]), re.escape(start[2])
    if (ends := _ending(body, names[0])) is not None:
        number, position, said = ends
    else:
        number, position, said = _untested(body, *names)
    return (number, start.end() + position, said) if number > 0 else None


def _without_dead(text: str) -> str:
    """Return code with blanks for what lies below ``#if 0``."""
    lines, depth = text.split("\n"), 0
    for number, line in enumerate(lines) if "#" in text else ():
        directive = _DIRECTIVE.match(line)
        word = directive[1] if directive else ""
        if depth:
            lines[number] = " " * len(line)
            if word.startswith("if") or word == "endif":
                depth += 1 if word != "endif" else -1
            elif word and depth == 1:
                depth = 0
        elif word.startswith("if") and word != "if":
            depth = 1
    return "\n".join(lines)


def _ending(body: str, count: str) -> tuple[int, int, str] | None:
    """Return this of a test of the number that ends the program: ``if (argc < 3) { usage(); return 1; }``."""
    test = rf"\bif\s*\(\s*({count}\s*(<=?|!=)\s*(\d{{1,3}}))\s*\)"
    tested = re.search(rf"{test}\s*(?:\{{([^{{}}]{{0,2000}})\}}|([^;{{}}]{{0,400}};))", body)
    then = (tested[4] or tested[5] or "") if tested else ""
    if tested is None or not (_FAILS.search(then) or (_ENDS.search(then) and _USAGE.search(then))):
        return None  # what ends well has done its work by a default
    return int(tested[3]) - (tested[2] != "<="), tested.start(), tested[1]


def _untested(body: str, count: str, values: str) -> tuple[int, int, str]:
    """Return this of the arguments that are read where nothing asks for their number or for what they are."""
    handed = re.compile(rf"\(\s*{count}\s*,\s*{values}\b")  # ros::init(argc, argv, "demo")
    rest = handed.sub(lambda match: "(" + " " * (len(match[0]) - 1), body)
    read = list(re.finditer(rf"\b{values}\s*\[\s*(\d{{1,2}})\s*\]", rest))
    otherwise = re.search(rf"\b{count}\b|\b{values}\b(?!\s*\[\s*\d{{1,2}}\s*\])", rest)
    asked = re.search(rf"(?:!|\bif\s*\()\s*{values}\s*\[|\b{values}\s*\[\s*\d+\s*\]\s*(?:[=!]=|\?|&&)", rest)
    first = next((match for match in read if match[1] != "0"), None)
    if first is None or otherwise or asked:
        return 0, 0, ""
    return max(int(match[1]) for match in read), first.start(), first[0]
