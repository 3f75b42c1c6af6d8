"""Which Ubuntu or distribution of ROS the branches of a script's ``if`` are for: only one of them runs."""

from __future__ import annotations

from collections.abc import Iterable

from roslab.evidence.dependency import Dependency
from roslab.knowledge.distros import ever, ubuntus
from roslab.values.dataclass import replace
from roslab.values.pattern import pattern

_STEP = pattern(r"[ \t]{0,80}(if|elif|else|fi)\b([^\n]{0,400})")
_CLOSED = pattern(r";\s{0,9}fi\s*(?:[;#&|].*)?$")
_OPENS = pattern(r"\bif\b")
_OF_PYTHON = ":"
"""The end of such a line of Python, which a script may write to a file."""
_EQUAL = pattern(r"\$[^=\n]{1,80}?(?<!!)==?\s{0,4}[\"']?([a-z]{4,9}|\d\d\.\d\d)[\"']?(?=[\s\];)]|$)")
_ELSE = pattern(r"!=|!\s|&&|\s-[a-z]{1,2}\s|<|>|=~")
"""The condition asks for more than that, or for something else."""


def headed(asked: tuple[Dependency, ...], text: str) -> tuple[Dependency, ...]:
    """Return the lines of apt with what the branch that they stand in is for as their title.

    What ``else`` is for is every release that the conditions before it do not name.
    """
    if "if" not in text or not _EQUAL.search(text):
        return asked
    titles = _titles(text.split("\n"))
    return tuple(replace(each, heading=titles.get(each.line, each.heading)) for each in asked)


def _titles(lines: Iterable[str]) -> dict[int, str]:
    found: dict[int, str] = {}
    blocks: list[_Block] = []
    for number, line in enumerate(lines, 1):
        step = None if line.rstrip().endswith(_OF_PYTHON) else _STEP.match(line)
        word, closes = step[1] if step else "", bool(_CLOSED.search(line))
        if closes and _OPENS.search(line):
            word, closes = "", False  # a block on a line of its own
        if word == "if":
            blocks.append(_Block(blocks[-1].title or blocks[-1].around if blocks else ""))
        if not blocks:
            continue
        if step and word in {"if", "elif"}:
            blocks[-1].asks(step[2])
        elif word == "else":
            blocks[-1].others()
        if word != "fi" and (not word or closes) and (title := blocks[-1].title or blocks[-1].around):
            found[number] = title
        if word == "fi" or closes:
            blocks.pop()
    return found


class _Block:
    """An ``if`` that is being read."""

    def __init__(self, around: str) -> None:
        self.around = around
        """The title of the branch that it stands in."""
        self.title = ""
        self.named: set[str] = set()
        self.known = True
        """Every condition so far asks for releases, and for nothing else."""

    def asks(self, condition: str) -> None:
        """Take up a condition; its branch has no title where it asks for something else too."""
        releases = {ubuntus().get(name, name) for name in _EQUAL.findall(condition)}
        sure = bool(releases) and not _ELSE.search(condition) and releases <= {*ubuntus().values(), *ever()}
        self.title = " ".join(sorted(releases)) if sure else ""
        self.named |= releases
        self.known = self.known and sure

    def others(self) -> None:
        """Begin the branch for what no condition names."""
        every = (set(names) for names in (ubuntus().values(), ever()) if self.named <= set(names))
        self.title = " ".join(sorted(next(every, set()) - self.named)) if self.known else ""
