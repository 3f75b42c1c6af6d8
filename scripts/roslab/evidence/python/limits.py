"""Signs in Python code of the oldest Python that reads it and of the ROS 2 that it imports, and in launch files."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping

from roslab.evidence import places
from roslab.evidence.code_limit import CodeLimit
from roslab.evidence.lex.lines import end_of_line, lines_with
from roslab.evidence.python.modules import modules
from roslab.knowledge.code_limits import OF_ROS2, Limit, limits
from roslab.knowledge.hints import Search
from roslab.repository.checkout import Repository
from roslab.values.version import Version

NODES = "Python of nodes"
"""The library of a sign in the code of a node of ROS, which runs with the Python of the Ubuntu."""
MANY = 3
"""How many times as many launch files with a sign are the tree's own kind."""
_POSTPONED = "from __future__ import annotations"
"""With it, no annotation is computed, and any Python that knows it reads those of newer ones."""


def read(repository: Repository) -> tuple[CodeLimit, ...]:
    """Return each sign at its first place; of nodes and of other code apart.

    Tests and examples tell nothing, nor do launch files that are written for two versions; of files for either, a few
    that came with a driver tell nothing beside the many others.
    """
    code = [limit for limit in limits() if limit.where in {"line", "annotation", "python"}]
    wanted = {
        "launch": Search((limit for limit in limits() if limit.where == "launch"), words=True),
        # A node of ROS has the Python of its distribution, whatever one of its modules needs
        "node": Search((limit for limit in code if not limit.below or _of_ros2(limit)), words=True),
        "other": Search((limit for limit in code if not _of_ros2(limit)), words=True),
    }
    found: dict[tuple[str, str], CodeLimit] = {}
    files = Counter[str]()
    for module in modules(repository):
        file, text = module.file, module.text
        if places.sample(file.path):
            continue
        kind = "launch" if "LaunchDescription" in text else "node" if module.names_ros else "other"
        for sign in wanted[kind].possible(text, module.words):
            library = NODES if kind == "node" and not _of_ros2(sign) else sign.library
            if place := _first(sign, text):
                line = text.count("\n", 0, place) + 1
                limit = CodeLimit(
                    library=library,
                    at_least=sign.at_least,
                    below=sign.below,
                    what=sign.what,
                    file=file.path,
                    line=line,
                )
                found.setdefault((library, sign.what), limit)
                files[sign.what] += 1
                if kind != "launch":
                    wanted[kind] = wanted[kind].without(sign)
    all_found = tuple(found.values())
    return tuple(limit for limit in all_found if not _contradicted(limit, all_found, files))


def _of_ros2(sign: Limit) -> bool:
    return sign.library.startswith(OF_ROS2)


def _contradicted(limit: CodeLimit, others: tuple[CodeLimit, ...], files: Mapping[str, int]) -> bool:
    """Tell whether other code needs what this limit rules out: the tree is written for both.

    A name that was away for a while contradicts nothing by itself, nor do few ``files`` beside many with the limit.
    """
    same = [other for other in others if other.library == limit.library]
    same = [other for other in same if files[limit.what] < MANY * files[other.what] or other.what == limit.what]
    lowest = [other.at_least for other in same if other.at_least and not other.below]
    highest = [other.below for other in same if other.below and not other.at_least]
    if not (lowest and highest):
        return False
    return limit.library != "Python" or min(map(Version, highest)) <= max(map(Version, lowest))


def _first(sign: Limit, text: str) -> int | None:
    """Return the position of a sign that is in no comment, ``None`` where there is none; 0 is no position of one."""
    if sign.where == "annotation" and _POSTPONED in text:
        return None
    for start, end in _parts(sign, text):
        for match in sign.pattern.finditer(text, start, end):
            if not text[text.rfind("\n", 0, match.start()) + 1 : match.start() + 1].lstrip().startswith("#"):
                return match.start() or 1
    return None


def _parts(sign: Limit, text: str) -> Iterator[tuple[int, int]]:
    """Yield where the parts of a text begin and end in which a sign can be: the lines with a hint, or all of it."""
    if sign.where not in {"line", "annotation"}:
        yield 0, len(text)
        return
    for start in lines_with(text, *sign.hints.each):
        yield start, end_of_line(text, start)
