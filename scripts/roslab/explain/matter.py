"""The lines of a step that may say why it failed: without lines that are never errors, and short enough to search."""

from __future__ import annotations

import re

from roslab.explain.reading import Line
from roslab.explain.skim import is_marked
from roslab.explain.steps import Step
from roslab.knowledge.failures import compiled
from roslab.knowledge.table import rows
from roslab.values.pattern import pattern

MOST = 300_000
"""Most characters of a step that patterns are matched on; of a longer step, its beginning and its end."""
_QUOTES = str.maketrans({0x2018: "'", 0x2019: "'", 0x201C: '"', 0x201D: '"'})
"""Compilers use curved quotation marks in a UTF-8 locale."""
_MANGLED = pattern(r"â€[\u02dc™œ\x9d\x98\x99\x9c]|<E2><80><9[89CD]>|\\342\\200\\23[0145]|M-bM-\^@M-\^[XY\\]")
"""These marks as bytes of another encoding, as less and git, as octal numbers, and as ``cat -v`` show them."""
_ASKED = pattern(r"(?<=[\s(])\?(?=[\w~:<])([^?\n]{1,1800})\?(?=[\s,;.)]|$)")
"""The same where the log has a question mark for each sign that its encoding lacks."""
_FOREIGN = pattern(
    r"Fehler|nicht gefunden|erreur|fichier|introuvable|No existe|denegado|referencia a"
    r"|kann nicht|Impossible de|No se (?:ha podido|pudieron)|Impossibil|no encontrad|pero |aber |mais |non esistente"
    r"|non (?:trovat|ha |sta )|Fehlschlag beim|Fallo al|no va a|negato|Dipende: |Depende: |No hay |nicht im "
)
_OTHER = pattern(
    r"error: (?:use of undeclared |unknown type name|no (?:type|template|member|matching|viable|instance)\b|static_?)"
    r"|\{aka |\d\): (?:fatal )?error: |\b(?:lld|mold): (?:error|fatal): "
)
"""What a compiler or linker says otherwise than gcc and GNU ld do."""
_NEVER = pattern(
    r"\s{0,8}(?:"
    r"\+{1,3} (?!(?:curl|wget|git) )"  # commands printed by `set -x`; an address in one may be what is wrong
    r"|npm (?:WARN|warn|notice|http|verb|info|sill|timing) |warning \S{1,200} > "
    r"|Get:\d|Ign:\d|Hit:\d|Setting up |Unpacking |Selecting previously|Preparing to unpack|\(Reading database"
    r"|Reading (?:package lists|state)|Building dependency tree|Processing triggers|update-alternatives: "
    r"|checking (?![^\n]{0,300}configure: error: )"
    r"|-- (?:Looking for|Performing Test|Check for|Checking(?! for modules? ')|Detecting|Found )"
    r"|-- (?:Installing: |Up-to-date: )"
    r"|Removing intermediate container| ---> "
    r"|Download(?:ing|ed)(?: from \S{1,40})?: https?://|Progress \(\d"
    r"|go: (?:finding|downloading|extracting) \S{1,200} v"
    r"|(?:[|│] {1,3}){0,30}(?:[+`]--|[├└]─)[-─┬ ]{0,3}(?![^\n]{1,200} exist \(perhaps)[@\w])"  # a tree of packages
)
_JOINED = pattern(r"^\s{0,8}(?:Reading|Building|Processing)[^\n]{1,60}?\.\.\.(?: ?(?:\d{1,3}%|Done))? ?(?=[EWN]: )")
"""apt's progress, which ends without a line break, before a message on the other stream."""
_PROBE = pattern(
    r"_configtest|conftest\.|CMakeTmp|CMakeScratch|TryCompile-|cmTC_|CheckSymbolExists|check_c_source|check_libyaml"
    r"|\bext/_yaml\."
)
_ECHO = pattern(
    r"(?:process|executor failed running|The command) .{0,4000}?((?:exit|non-zero) code: ?\d{1,3})", re.DOTALL
)
_CODE = pattern(r"(?:exit|non-zero) code: ?\d{1,3}$")
_FAILED_TO = pattern(r"^(?:ERROR: )?(?:failed to (?:build|solve): ){1,3}")
_OTHERWISE = pattern(r"roslab: the tables of rosdistro \S{1,60} do not answer: the base's own are used$")
_OF_TABLES = pattern(r"unable to process source|urlopen error|error loading sources list")
"""What rosdep says of tables that do not answer."""
_GAVE_UP = pattern(r"\s{0,8}(?:WARNING: )?Retrying \(Retry\(total=0")
_TRIES = pattern(r"\s{0,8}(?:WARNING: )?Retrying \(Retry\(total=")
_FETCHES = pattern(r"\s{0,8}(?:Downloading|Using cached) \S{1,300}\.(?:whl|tar\.gz|zip)\b")
_SAYS = pattern(
    r"(?i)\b(?:error|fatal|failed|failure|cannot|can't|could not|couldn't|unable|undefined|not found"
    r"|no such|denied|killed|invalid|missing|unsupported|unrecognized|refused|aborted|expired|mismatch"
    r"|exception|requires?|required)\b"
    r"|\*\*\*|^E: |ERR!"
)
_QUIET = pattern(
    r"(?i)\bwarn(?:ing)?\b|^W: |\b0 (?:errors|failed|failures)\b|liberror|error[-_]?prone"
    r"|\berror\.(?:h|c|cpp|o|py|js)\b"
    r"|debconf: |no error|ignoring|\[ *\d{1,3}%\] (?:Building|Built)|deprecat|errors? occurred!|compilation terminated"
    r"|^\s*(?:note|hint): |See also \"|Waiting for unfinished jobs|recipe for target|make.{0,8}: Leaving"
)
_PARAGRAPH = pattern(r"  \S")
_LAST = pattern(
    r"(?i)make(?:\[\d+\])?: \*\*\* |returned a non-zero|exit(?:ed with)? (?:code|status)|command .{0,60} failed"
)


def lines(step: Step) -> list[Line]:
    """Return a step's lines, including the builder's own message, without those that are never errors."""
    found = [
        Line(line.number, _in_words_of_gcc(_quoted(_english(text)).translate(_QUOTES)))
        for line in step.lines
        if (text := _alone(line.text)) and not _NEVER.match(text) and not _PROBE.search(text)
    ]
    found = _without_index(_without_tables(found))
    word = last_word(step)
    if word:
        found.append(Line(found[-1].number if found else 0, word))
    return _bounded(found)


def _without_tables(found: list[Line]) -> list[Line]:
    """Return the lines without rosdep's about tables in whose place the base's own are used: these answer."""
    last = next((index for index, line in enumerate(found) if _OTHERWISE.match(line.text.strip())), 0)
    return [line for line in found[:last] if not _OF_TABLES.search(line.text)] + found[last:] if last else found


def _without_index(found: list[Line]) -> list[Line]:
    """Return the lines without pip's tries of an index after which it took packages of another."""
    first = next((index for index, line in enumerate(found) if _GAVE_UP.match(line.text)), None)
    if first is None or not any(_FETCHES.match(line.text) for line in found[first:]):
        return found
    return [line for line in found if not _TRIES.match(line.text)]


def _alone(text: str) -> str:
    """Return a line without the progress of apt that its message was written behind."""
    return _JOINED.sub("", text) if "..." in text else text


def _english(text: str) -> str:
    """Return a line with the commonest messages of compilers and the C library in English."""
    if not text.isascii() or _FOREIGN.search(text):
        for row in rows("localised"):
            text = compiled(row["pattern"]).sub(row["english"], text)
    return text


def _quoted(text: str) -> str:
    """Return a line of a compiler with quotation marks in the place of what another encoding made of them."""
    if "â€" in text or "<E2>" in text or "\\342" in text or "M-b" in text:
        text = _MANGLED.sub("'", text)
    return _ASKED.sub(r"'\1'", text) if "?" in text and "error: " in text else text


def _in_words_of_gcc(text: str) -> str:
    """Return a line of clang, nvcc, lld or mold as gcc and GNU ld say it, and without what gcc adds of other names."""
    if _OTHER.search(text):
        for row in rows("other_wordings"):
            text = compiled(row["pattern"]).sub(row["gcc"], text)
    return text


def last_word(step: Step) -> str:
    """Return the builder's own message about the failure, without the command that it repeats."""
    text = _FAILED_TO.sub("", step.error)
    echo = _ECHO.search(text)
    return echo[1] if echo else text


def _bounded(found: list[Line]) -> list[Line]:
    size = sum(len(line.text) + 1 for line in found)
    if size <= MOST:
        return found
    head, tail, room = [], [], MOST // 3
    for line in found:
        room -= len(line.text) + 1
        if room < 0:
            break
        head.append(line)
    room = MOST // 3
    middle = [line for line in found[len(head) :] if is_marked(line.text)]
    said = []
    for line in middle:
        room -= len(line.text) + 1
        if room < 0:
            break
        said.append(line)
    room = MOST // 3
    for line in reversed(found[len(head) :]):
        room -= len(line.text) + 1
        if room < 0:
            break
        tail.append(line)
    kept = {id(line): line for line in (*head, *said, *reversed(tail))}
    return sorted(kept.values(), key=lambda line: line.number)


def unwrapped(found: list[Line]) -> list[Line]:
    """Return the lines with each paragraph of a message of CMake, which it wraps at blanks, on one."""
    out: list[Line] = []
    inside = False
    for line in found:
        text = line.text
        if text[:1].strip():
            inside = text.startswith("CMake Error")
        elif inside and _PARAGRAPH.match(text) and out and _PARAGRAPH.match(out[-1].text):
            out[-1] = Line(out[-1].number, f"{out[-1].text} {text.strip()}")
            continue
        out.append(line)
    return out


def telling(found: list[Line], most: int = 20) -> list[Line]:
    """Return the lines that matter if no known failure explains a step: the first errors, and the end.

    They include the end of a traceback, the first error of a compiler and the reason that an installer gives. There are
    at most ``most``.
    """
    said = [at for at, line in enumerate(found) if _SAYS.search(line.text) and not _QUIET.search(line.text)]
    first = [at for at in said if not _LAST.search(found[at].text)] or said
    chosen: dict[int, None] = {}
    for at in first[:4]:
        for near in range(at, min(at + 3, len(found))):
            chosen.setdefault(near)
    for at in range(max(0, len(found) - 6), len(found)):
        chosen.setdefault(at)
    keep = sorted(list(chosen)[:most])
    return [found[at] for at in keep]


def first_error(found: list[Line]) -> Line | None:
    """Return the first line that reports an error, or the last line with the exit code."""
    said = [line for line in found if _SAYS.search(line.text) and not _QUIET.search(line.text)]
    plain = [line for line in said if not _LAST.search(line.text)]
    end = found[-2:]
    if len(end) > 1 and _CODE.match(end[1].text):
        end = [Line(end[0].number, f"{end[0].text.strip()} ({end[1].text})")]
    return next(iter([*plain, *said, *end[-1:]]), None)
