"""What a Makefile at the root gives CMake, where an author calls that by it: ``cmake -DTASK=demo . -Bbuild``.

Variables have the values that the Makefile sets them to.
"""

from __future__ import annotations

from collections.abc import Iterator

from roslab.evidence.facts import Mention
from roslab.evidence.lex.make_tasks import NAMES, parsed
from roslab.repository.checkout import Repository
from roslab.values.dataclass import replace
from roslab.values.pattern import pattern

MAX_SIZE = 64 * 1024
_CALLS = pattern(r"\bcmake\s")
_OPTION = pattern(r"-D(?!CMAKE_)[A-Za-z_]\w*(?::[A-Z]+)?=[\w.+-]+")
"""One without a path: no folder of the author's machine."""


def read(repository: Repository) -> Iterator[Mention]:
    """Yield the first call that configures the root: ``text`` has its options, each a word."""
    file = next((file for name in NAMES for file in repository.named(name) if not file.folder), None)
    if file is None or file.size > MAX_SIZE or not repository.has("CMakeLists.txt"):
        return
    text = repository.read(file)
    if not _CALLS.search(text):
        return
    from roslab.evidence.lex.shell import logical_lines  # noqa: PLC0415 - few Makefiles call CMake
    from roslab.evidence.prose.configured import of_another  # noqa: PLC0415 - as above
    from roslab.evidence.prose.installs import Collector  # noqa: PLC0415 - as above

    tasks = parsed(text)
    for number, line in logical_lines(text):
        if line.startswith("\t") and _CALLS.search(line):
            collector = Collector(file.path, "script")
            collector.text(tasks.filled(line.replace("\n", " ").strip().lstrip("@-+"), {}), number)
            for said in collector.mentions:
                here = said.topic == "compiled" and said.value == "." and not collector.below.strip("./")
                if here and not of_another(said, repository):
                    options = " ".join(word for word in said.text.split() if _OPTION.fullmatch(word))
                    yield replace(said, text=options)
                    return
