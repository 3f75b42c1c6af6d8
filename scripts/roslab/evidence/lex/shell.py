"""Shell text split into commands, for Dockerfiles, CI files, READMEs and install scripts.

No shell is run or emulated: quotes, continuations, separators and simple variables are enough to read install lines. A
word with a command substitution is dropped, since its value is unknown. shlex splits words but not commands, and gives
no lines; bashlex reads only correct bash, which half of a README is not.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from typing import NamedTuple

from roslab.evidence.lex.braces import expanded
from roslab.values.dataclass import dataclass, field
from roslab.values.pattern import pattern

UNKNOWN = "\x00"
"""In a word, this stands for a value that only a running shell knows."""
DISTRO = "\x02distro\x03"
"""In a text, this stands for the distribution of ROS that the image has: ``{distro}`` in a word."""
MAX_LOGICAL = 20_000
"""Most characters of one logical line; a longer one is data."""
MAX_VALUE = 4_000
"""Most characters of a variable's value: one that doubles itself in each line would fill the memory."""
_PLACEHOLDER = pattern(
    r"""\bros-(?:
        \$?\{\{\s*[\w.-]{0,60}?distro[\w.-]{0,60}\s*\}\}      # ${{ matrix.ros_distro }}, ${{ needs.ros-distro.x }}
      | "?'?\$\{?\(?\w*(?:distro|version|rosver)\w*\}?\)?'?"?    # $ROS_DISTRO, "${ROS_DISTRO}"
      | \$\(\s*rosversion\s+-d\s*\) | `\s*rosversion\s+-d\s*`
      | <[^<>\n]{1,40}> | \[[^\[\]\n]{1,30}\] | \{[\w\s-]{1,30}\} | %\w+% | \#+
      | (?:your[-_]?)?(?:ros[-_]?)?distro(?:[-_]?name)?          # your-distro
      | [A-Z][A-Z0-9_]*                                          # YOUR_DISTRO, XXX
    )-(?=[a-z0-9])""",
    re.VERBOSE | re.IGNORECASE,
)
_OF_VARIABLE = pattern(r"\bros-\$(?:\{(\w+)\}|(\w+))-(?=[a-z0-9])")
_CAPITALS = pattern(r"^ros-([A-Za-z0-9_]+)-$")
_TOKEN = pattern(
    r"""(?P<space>[^\S\n]+|\n)
      | (?P<single>'[^']*') | (?P<double>"(?:\\.|[^"\\])*")
      | (?P<unknown>\$\((?:[^()]|\([^()]*\))*\)|`[^`]*`)
      | (?P<variable>\$\{[^}\n]*\}|\$\w+)
      | (?P<separator>&&|\|\||;;|(?<![\w.-])[{}](?=\s|$|[^\w])|[;|&()])
      | (?P<version>[<>!=~]=|[<>](?=\d))
      | (?P<placeholder><[A-Za-z](?:[^<>|&;\n]{0,80}[^\s<>|&;])?>)   # <path to your images>: no redirection
      | (?P<redirect>\d?[<>]{1,3}&?\d?)
      | (?P<escape>\\.)
      | (?P<plain>[^\s'"$`;|&()<>\\{}!=~]+)
      | (?P<other>.)""",
    re.VERBOSE | re.DOTALL,
)
_MARK = "`"
_WRAPPERS = frozenset(
    (
        *("export", "ARG", "ENV", "sudo", "time", "exec", "nice", "command", "then", "do", "else", "if", "!", "while"),
        *("[sudo]", "RUN", "$", "%", "yes", "eval", "retry", "-", "*", "run:"),
    )
)
_VALUED_SUDO = frozenset({"-u", "-g", "-n", "--user"})
_KEPT = pattern(r"\s*\w+=(\"?)(?:\$\(([^()`\n]{1,600})\)|`([^`\n]{1,600})`)\1\s*")
"""A command whose words are kept: ``said=$(pip install six)``."""
_ASSIGNMENT = pattern(r"^([A-Za-z_]\w*)=(.*)$", re.DOTALL)
_SHELLS = frozenset({"bash", "sh", "zsh", "dash"})


class Command(NamedTuple):
    """One simple command: its words without wrappers such as sudo, the line of each."""

    words: tuple[str, ...]
    lines: tuple[int, ...]
    assigned: tuple[str, ...] = ()
    """The variables that stand before it, ``NAME=VALUE``; not those whose value only a running shell knows."""
    given: str = ""
    """The file that it reads, by ``<``."""
    may_fail: bool = False
    """Another one is run where it fails, by ``||``."""

    @property
    def line(self) -> int:
        """Line of the first word."""
        return self.lines[0]


def fill_placeholders(text: str) -> str:
    """Return the text with every placeholder of a ROS distro (``ros-YOUR_DISTRO-x``) as ``ros-{distro}-x``."""
    if "ros-" not in text:
        return text

    def fill(match: re.Match[str]) -> str:
        bare = _CAPITALS.match(match[0])
        # IGNORECASE lets [A-Z] match lower case too: such a word is the name of a distro or a package.
        blank = bare and (bare[1].isupper() or "distro" in bare[1].lower() or set(bare[1]) == {"x"})
        return match[0] if bare and not blank else "ros-{distro}-"

    return _PLACEHOLDER.sub(fill, text)


_EXPLAINED = pattern(r"(?<!\\)\\[ \t]+#[^\n]*$", re.MULTILINE)


def without_remarks(text: str) -> str:
    """Take the comments out that pages have behind a continuation: to a shell they end the command."""
    return _EXPLAINED.sub(lambda _: "\\", text) if "\\ " in text or "\\\t" in text else text


def logical_lines(text: str, first: int = 1) -> Iterator[tuple[int, str]]:
    """Yield ``(line, text)`` with continuations joined; newlines stay inside, comment lines become empty ones."""
    pending: list[str] = []
    start = first
    for number, line in enumerate(text.split("\n"), first):
        stripped = line.strip()
        if not pending:
            start = number
            if stripped.startswith("#"):
                continue
        elif stripped.startswith("#"):  # Docker drops comments inside a continuation; shell authors mean it too
            pending.append("")
            continue
        if stripped.endswith("\\") and not stripped.endswith("\\\\"):
            pending.append(line.rstrip()[:-1])
            continue
        pending.append(line)
        joined = "\n".join(pending)
        pending = []
        if len(joined) <= MAX_LOGICAL:
            yield start, joined
    if pending and sum(map(len, pending)) <= MAX_LOGICAL:
        yield start, "\n".join(pending)


def commands(text: str, line: int = 1, variables: Mapping[str, str] | None = None) -> Iterator[Command]:
    """Yield the simple commands of one logical line; ``variables`` are filled in, and assignments are added to them.

    ``$_`` is the last word of the command before: ``mkdir --parents ~/ws/src && cd $_``.
    """
    known = dict(variables or {})
    text = kept[2] or kept[3] if " install " in text and (kept := _KEPT.fullmatch(text)) else text
    for simple in _split(_filled(fill_placeholders(_with_values(text, known))), line, known):
        known["_"] = UNKNOWN
        for command in _unwrapped(simple, known):
            known["_"] = command.words[-1]
            yield command


def _with_values(text: str, known: Mapping[str, str]) -> str:
    """Return the text with the values of variables that stand for a distribution: the image's may be another ROS."""
    if not known or "ros-$" not in text:
        return text
    return _OF_VARIABLE.sub(lambda m: f"ros-{known[m[1] or m[2]]}-" if (m[1] or m[2]) in known else m[0], text)


def _filled(text: str) -> str:
    # The braces of the token would be read as a group of commands, so private characters replace them for now.
    return expanded(text).replace("ros-{distro}-", f"ros-{DISTRO}-")


@dataclass
class _Words:
    """The words of the current command, and the word that is being assembled."""

    words: list[tuple[str, int]] = field(default_factory=list)
    word: str = ""
    started: int = 0
    redirected: str = ""
    """The sign of a redirection whose file the next word is: it is no word of the command."""
    given: str = ""

    def take(self, pieces: list[str], line: int) -> None:
        for index, piece in enumerate(pieces):
            if index:
                self.finish()
            self.word, self.started = self.word + piece, self.started or line

    def finish(self) -> None:
        if self.started:
            word = self.word.replace("\x02", "{").replace("\x03", "}")
            if not self.redirected:
                self.words.append((word, self.started))
            self.given = word if self.redirected == "<" else self.given
            self.redirected = ""
        self.word, self.started = "", 0

    def end(self, separator: str = "") -> _Simple:
        self.finish()
        found = _Simple(self.words, self.given, separator == "||")
        self.words, self.given = [], ""
        return found


class _Simple(NamedTuple):
    """One simple command with its wrappers: each word with its line."""

    words: list[tuple[str, int]]
    given: str
    may_fail: bool


def _split(text: str, line: int, known: Mapping[str, str]) -> Iterator[_Simple]:
    now, comment = _Words(), False
    for match in _TOKEN.finditer(text):
        kind, token = match.lastgroup, match[0]
        if kind == "space":
            now.finish()
            line += token.count("\n")
            comment = comment and "\n" not in token
            continue
        comment = comment or (not now.started and token.startswith("#"))
        if comment:
            continue
        if kind == "separator":
            yield now.end(token)
        elif kind == "redirect" or (kind == "version" and not now.started):
            now.finish()
            now.redirected = "" if token.endswith(("&1", "&2", "&")) else token
        elif token != _MARK:  # nothing closes it: it is no shell's, but a mark of the page
            now.take(_pieces(kind or "other", token, known), line)
            line += token.count("\n")
    yield now.end()


def _pieces(kind: str, token: str, known: Mapping[str, str]) -> list[str]:
    """Return a token's value; an unquoted variable is split into words as in a shell, an empty one into none."""
    if kind != "variable":
        return [_value(kind, token, known)]
    return [] if known.get(token.strip("${}")) == "" else _value(kind, token, known).split()


def _value(kind: str, token: str, known: Mapping[str, str]) -> str:
    if kind == "single":
        return token[1:-1]
    if kind == "double":
        return _expand(token[1:-1].replace('\\"', '"'), known)
    if kind in {"unknown", "placeholder"}:
        return UNKNOWN
    if kind == "variable":
        return _expand(token, known)
    if kind == "escape":
        return token[1:] if token[1:] != "\n" else ""
    return token


_REFERENCE = pattern(r"\$\{(\w+)(?::?[-=]([^}]*))?[^}]*\}|\$(\w+)|\$\([^)]*\)|`[^`]*`")


def _expand(text: str, known: Mapping[str, str]) -> str:
    def value(match: re.Match[str]) -> str:
        name = match[1] or match[3]
        if name is None:
            return UNKNOWN
        return (known.get(name) or match[2] or UNKNOWN)[:MAX_VALUE]

    return _REFERENCE.sub(value, text)[:MAX_LOGICAL] if "$" in text or "`" in text else text


def expand(text: str, known: Mapping[str, str]) -> str:
    """Return the text with ``$NAME`` and ``${NAME:-default}`` filled in; one without a value stays as written."""

    def value(match: re.Match[str]) -> str:
        name = match[1] or match[3]
        return (known.get(name) if name else None) or match[2] or match[0]

    return _REFERENCE.sub(value, text)[:MAX_VALUE] if "$" in text else text


def _start(words: list[tuple[str, int]], known: dict[str, str]) -> int:
    """Return the index of the program, after assignments and wrappers; the assignments are added to ``known``."""
    index = 0
    while index < len(words):
        word = words[index][0]
        assignment = _ASSIGNMENT.match(word)
        if assignment and UNKNOWN not in assignment[2]:
            known[assignment[1]] = assignment[2][:MAX_VALUE]
        if word == "sudo":
            while index + 1 < len(words) and words[index + 1][0].startswith("-"):
                index += 2 if words[index + 1][0] in _VALUED_SUDO else 1
        elif not assignment and word not in _WRAPPERS:
            return index
        index += 1
    return index


def _unwrapped(simple: _Simple, known: dict[str, str], depth: int = 0) -> Iterator[Command]:
    words = simple.words
    index = _start(words, known)
    rest = words[index:]
    if not rest:
        return
    program = rest[0][0].rpartition("/")[2]
    if program in _SHELLS and depth < 3:
        script = next((i + 1 for i, (word, _) in enumerate(rest) if re.fullmatch(r"-\w*c", word)), len(rest))
        if script < len(rest):
            text, line = rest[script]
            for inner in _split(_filled(text), line, known):
                yield from _unwrapped(inner, known, depth + 1)
            return
    assigned = (word for word, _ in words[:index] if _ASSIGNMENT.match(word) and UNKNOWN not in word)
    found = (tuple(word for word, _ in rest), tuple(line for _, line in rest))
    yield Command(*found, tuple(assigned), given=simple.given, may_fail=simple.may_fail)
