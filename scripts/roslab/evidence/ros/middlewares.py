"""The middlewares of ROS 2 that scripts, launch files, containers and pages choose: ``RMW_IMPLEMENTATION=rmw_…``.

Without the package of the one that is chosen no node starts, nor does ``ros2 launch``.
https://docs.ros.org/en/rolling/How-To-Guides/Working-with-multiple-RMW-implementations.html, read 2026-11-29.
"""

from __future__ import annotations

from collections.abc import Iterator

from roslab.evidence import places
from roslab.evidence.dependency import Dependency
from roslab.knowledge.released import ever_released
from roslab.repository.checkout import File, Repository, nearest
from roslab.values.endings import SHELL_SCRIPTS
from roslab.values.pattern import pattern

MAX_SIZE = 256 * 1024
MAX_FILES = 400
"""Most files that are opened, those nearest to the root first."""
_WORD = "RMW_IMPLEMENTATION"
_CHOSEN = pattern(
    rf"\b{_WORD}[\"'\]\s]{{0,4}}(?:[=,]|:[-=]?)?[ \t]*(?:value[ \t]*=[ \t]*)?[\"']?(rmw_[a-z0-9_]{{2,40}})\b"
)
"""Behind an equals sign, as the value of YAML, the second word of a call, a default of the shell, or in XML."""


def read(repository: Repository) -> tuple[Dependency, ...]:
    """Return the packages of these middlewares, each once, where it is chosen first."""
    if not repository.named("package.xml"):
        return ()
    found: dict[str, Dependency] = {}
    for file in nearest(setting_files(repository))[:MAX_FILES]:
        text = repository.read(file)
        for match in _CHOSEN.finditer(text) if _WORD in text else ():
            name, line = match[1], text[text.rfind("\n", 0, match.start()) + 1 : match.start()]
            if name not in found and ever_released(name) and not ("#" in line or "<!--" in line):
                found[name] = Dependency(
                    namespace="ros",
                    name=name,
                    strength="prose",
                    file=file.path,
                    line=text.count("\n", 0, match.start()) + 1,
                    role="exec",
                )
    return tuple(found.values())


def setting_files(repository: Repository) -> Iterator[File]:
    """Yield the files that may set a variable of the environment for what is started."""
    always = repository.suffixed(*SHELL_SCRIPTS, ".launch", ".env", ".md", ".rst")
    others = repository.suffixed(".py", ".xml", ".yaml", ".yml")
    for file in (*always, *(each for each in others if "launch" in each.path or "compose" in each.name)):
        if file.size <= MAX_SIZE and not places.aside(file.path):
            yield file
