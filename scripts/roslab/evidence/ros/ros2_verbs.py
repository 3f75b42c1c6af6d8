"""The commands of ``ros2`` that launch files and shell scripts start, which few package.xml name: ``ros2 control``."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.evidence import places
from roslab.evidence.dependency import Dependency
from roslab.repository.checkout import File, Repository, nearest
from roslab.values.pattern import pattern

MAX_SIZE = 256 * 1024
MAX_FILES = 800
"""Most files that are opened, those nearest to the root first."""
_CALLED = pattern(r"(?<![\w./-])ros2(?:[ \t]+|[\"'][ \t]*,\s*[\"'])([a-z][\w-]*)(?=[\s\"'\\,])")
"""In a line of a shell, in a string, or as the words of a list: ``["ros2", "control", …]``."""
_ASIDE = pattern(r"(?:^|\s)#|(?<![\w./-])(?:echo|printf)\s|<!--(?!.*-->)|\b(?:print|LogInfo|description|help)\b")
"""What stands before it on a line where it is only told."""


def read(repository: Repository) -> tuple[Dependency, ...]:
    """Return the packages of these commands, each once, where it is called first."""
    from roslab.knowledge.ros2_verbs import ros2_verbs  # noqa: PLC0415 - few trees call one

    found: dict[str, Dependency] = {}
    for file in nearest(_files(repository))[:MAX_FILES]:
        text = repository.read(file)
        for match in _CALLED.finditer(text) if "ros2" in text else ():
            name = ros2_verbs().get(match[1])
            if (
                name
                and name not in found
                and not _ASIDE.search(text, text.rfind("\n", 0, match.start()) + 1, match.start())
            ):
                line = text.count("\n", 0, match.start()) + 1
                found[name] = Dependency(
                    namespace="ros", name=name, strength="used", file=file.path, line=line, role="exec"
                )
    return tuple(found.values())


def _files(repository: Repository) -> Iterator[File]:
    described = repository.suffixed(".launch", ".sh", ".bash")
    launching = (file for file in repository.suffixed(".py", ".xml", ".yaml", ".yml") if "launch" in file.path)
    for file in (*described, *launching):
        if file.size <= MAX_SIZE and not places.aside(file.path):
            yield file
