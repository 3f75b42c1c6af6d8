"""Commands that a sentence of a page names: ``run `demo` ``, ``go into `lib/arm` ``, ``clone https://…``."""

from __future__ import annotations

import re
from collections.abc import Iterator

from roslab.evidence.prose.failing import of_failure
from roslab.evidence.prose.telling import Signs
from roslab.values.pattern import pattern

_NAMED = pattern(r"\b(?:run|start|launch|execute)\b(?:\s+the)?(?:\s+\w+)?\s+`([A-Za-z][\w+-]*)`", re.IGNORECASE)
"""A sentence that runs a program by its name."""
_GO_INTO = pattern(
    r"\b(?:go|change|move|navigate|enter|cd)\b(?:\s+(?:in|to|into|inside|the|folder|directory)){0,4}\s+"
    r"`([\w.-]+/[\w./-]*)`",
    re.IGNORECASE,
)
"""A sentence that goes into a folder of the tree before a block of commands."""
_CLONED = pattern(
    r"\bclone\b(?:\s+(?:the|from|repo|repository|package|library|official)){0,4}[\s:]+(?:\[[^\]\n]{1,80}\]\()?<?"
    r"(https://(?:github|gitlab)\.com/[\w-]+/[\w.-]*\w)(?=[\s)>.,;]|$)(?![^`]*`)",
    re.IGNORECASE,
)
"""A sentence that has the reader clone a repository by its address."""
_NAMED_PYTHON = pattern(
    r"(?<!\bnot )(?<!n't )(?<!\bnever )\b(?:run|runn?ing|start|launch|execute|use)\b"
    r"(?:\s+(?:the|a|script|file|program|our)){0,3}\s+"
    r"`{1,3}([\w./-]+\.py(?: [^`\n]{0,200})?)`{1,3}(?!`|\s+as\b)",
    re.IGNORECASE,
)
"""A sentence that runs a file of Python; what is used *as* something is read by another program."""
_NAMED_SHELL = pattern(
    r"\b(?:run|runn?ing|start|launch|execute)\b(?:\s+(?:the|a|script|file|program|our)){0,3}\s+"
    r"`(?:(?:\./)?~/[\w.-]+/|\./)((?:[\w.-]+/)+[\w.-]+\.(?:ba)?sh(?: [^`<\n]{0,200})?)`",
    re.IGNORECASE,
)
"""A sentence that runs a script below a folder of the tree, which may lie in the reader's home."""
_SHELL: Signs = ((".sh", _NAMED_SHELL), (".bash", _NAMED_SHELL))
IN_SENTENCES: Signs = (("`", _NAMED), (".py", _NAMED_PYTHON), *_SHELL, ("`", _GO_INTO), ("://", _CLONED))
"""What a sentence tells to do, each after a part of it."""
_SAID_LAUNCH = pattern(
    r"(?<![`\w/-])(?:roslaunch|ros2 launch) +(?:[a-z]\w+ +[\w./-]+|(?:~/)?[\w.-]+/[\w./-]+)"
    r"(?:\.launch(?:\.(?:py|xml|ya?ml))?|_launch\.py)"
    r"(?: +\w+:=[^\s\"'\u201d`,;)]+)*(?![\w`])"
)
"""A launch in a sentence, by a package or a path: ``Run "roslaunch demo map.launch" to start``."""
_WORD = (
    r"(?:to|or|and|but|is|are|was|were|can|will|should|must|has|have|in|on|at|with|without|for|from|as|by|of|if|"
    r"when|then|it|its|the|an|this|that|these|those|your|any|each|all|instead|commands?|nodes?|packages?)\b"
)
"""A word of the sentence itself, where a package or a program would stand: ``use rosrun to start it``."""
_SAID_NODE = pattern(
    rf"(?<![`\w/-])(?:rosrun|ros2 run) +(?!{_WORD})[a-z]\w+ +(?!{_WORD})[A-Za-z]\w+(?:[.-]\w+)*(?![\w`/])"
    r"(?: +_?\w+:=[^\s\"'\u201d`,;)]+)*(?![\w`])"
)
"""A node in a sentence, by its package: ``Then start rosrun demo viewer in a second terminal``."""
_AVOIDED = pattern(
    r"(?:\bnot|n['\u2019]t|\bnever|\bcannot|\binstead of|\brather than|\bno longer|\bwithout)\s"
    r"(?:[\w-]+\s+){0,3}[\"'\u201c(]?\Z",
    re.IGNORECASE,
)
"""What comes before a command that a sentence keeps the reader from."""
_FARTHEST = 80
_EMPHASISED = pattern(
    r"(?<![\w*`])(\*\*|<code>|<b>|<strong>)(?=[a-z.])([^*`<>\n]{4,300}?)(?:\1|</(?:code|b|strong)>)(?![\w*`])"
)
"""A command in bold letters, or in those of HTML's code."""
_SAID_PYTHON = pattern(
    r"(?<!\bnot )(?<!n't )(?<!\bnever )\b(?:run|running|use|using|execute|start|usage|command)\b[\s\w*:]{0,30}?"
    r"(?:(?<=\s)(?P<open>[\"\u201c'])|(?<=[\s:*]))(?P<call>python3?[ ](?:-u[ ])?[\w./-]{1,100}\.py(?![\w/]))"
    r"(?P<rest>[^\"\u201c\u201d'`<>|;,()]{0,200})(?(open)[\"\u201d']|$)",
    re.IGNORECASE,
)
"""A file of Python that a sentence runs, in quotation marks or at its end: ``Run: python main.py --config a``."""


_NO_WORD = pattern(r"[/=:.\d]")
"""What a path, a setting or a number has, and no word of a sentence."""


def emphasised(line: str, command: re.Pattern[str]) -> Iterator[re.Match[str]]:
    """Yield what a page has in bold letters or in HTML's for code, and which is a ``command`` (the second group)."""
    if "**" in line or "<" in line:
        yield from (match for match in _EMPHASISED.finditer(line) if command.match(match[2]))


def in_sentence(line: str, *, title: bool = False) -> Iterator[str]:
    """Yield what a line of prose tells to do, as the shell's commands.

    ``title``: it is that of a block of commands below, which say how its program is started.
    """
    if "ros" in line:
        yield from (said[0] for form in (_SAID_LAUNCH, _SAID_NODE) for said in form.finditer(line) if _meant(said))
    yield from (f"git clone {named[1]}" for named in (_CLONED.finditer(line) if "://" in line else ()))
    quoted = "`" in line
    if not quoted and ".py" in line and "python" in line:
        yield from (said for match in _SAID_PYTHON.finditer(line) if (said := _call(match)))
    yield from (f"cd {named[1]}" for named in (_GO_INTO.finditer(line) if quoted else ()))
    yield from (f"./{named[1]}" for named in (_NAMED.finditer(line) if quoted and not title else ()))
    yield from (f"python {named[1]}" for named in _NAMED_PYTHON.finditer(line))
    shell = any(part in line for part, _ in _SHELL)
    yield from (f"./{named[1]}" for named in (_NAMED_SHELL.finditer(line) if shell else ()))


def _meant(said: re.Match[str]) -> bool:
    """Tell whether a sentence has the reader start what it names, and not avoid or mend it."""
    line, (start, end) = said.string, said.span()
    return not (_AVOIDED.search(line[max(0, start - _FARTHEST) : start]) or of_failure(line, start, end, said[0]))


def _call(said: re.Match[str]) -> str:
    """Return the call of a file of Python, ``""`` where words of the sentence follow: ``python a.py is run``."""
    rest = said["rest"].rstrip(" .:")
    before = ""
    for word in rest.split():
        valued = before.startswith("-") and "=" not in before
        if not (word.startswith("-") or valued or _NO_WORD.search(word)):
            return ""
        before = word
    return f"{said['call']} {rest.strip()}".rstrip()
