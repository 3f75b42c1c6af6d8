"""ROS packages whose programs and launch files scripts of the tree start: ``rosrun rosserial_python …``."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.evidence import places
from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import Mention
from roslab.knowledge.released import ever_released
from roslab.repository.checkout import Repository, nearest
from roslab.values.endings import SHELL_SCRIPTS
from roslab.values.pattern import pattern

MAX_SIZE = 64 * 1024
MAX_FILES = 100
"""Most scripts that are opened, those nearest to the root first."""
_STARTED = pattern(
    r"(?<![\w./-])(?:rosrun|roslaunch|ros2[ \t]+(?:run|launch))[ \t]+"
    r"(?:--?\S+[ \t]+)*([a-z][a-z0-9_]+)[ \t]+[\w\"'$./-]"
)
_IN_STRINGS = pattern(
    r"(?<![\w./-])(?:roslaunch|rosrun|ros2[\"',\s]{1,9}(?:run|launch))[\"',\s]{1,9}(?:--?[\w-]+[\"',\s]{1,9}){0,5}([A-Za-z][A-Za-z0-9_]+)(?=[\"',\s])"
)
"""In a string of Python, or as the words of a list: ``["roslaunch", "demo", "a.launch"]``."""

_NOT_RUN = pattern(r"(?:^|\s)#.*|(?<![\w./-])(?:echo|printf)\s(?:\"(?:[^\"\\]|\\.)*\"|'[^']*'|[^;&|\"'])*")
"""A comment, and what a line prints."""
_WORDS = ("rosrun", "roslaunch", "ros2")


def read(repository: Repository) -> tuple[Dependency, ...]:
    """Return each released package once, at its first place; ``roslaunch a.launch`` names none."""
    found: dict[str, Dependency] = {}
    scripts = [f for f in repository.suffixed(*SHELL_SCRIPTS) if f.size <= MAX_SIZE and not places.aside(f.path)]
    for file in nearest(scripts)[:MAX_FILES]:
        text = repository.read(file)
        for number, line in enumerate(text.splitlines(), 1) if any(word in text for word in _WORDS) else ():
            for name in _STARTED.findall(_NOT_RUN.sub("", line)) if any(word in line for word in _WORDS) else ():
                if name not in found and ever_released(name):
                    found[name] = Dependency(
                        namespace="ros", name=name, strength="prose", file=file.path, line=number, role="exec"
                    )
    return tuple(found.values())


def calls(repository: Repository) -> Iterator[Mention]:
    """Yield each package of which a script of the shell or a file of Python starts something, with that file."""
    if not repository.named("package.xml", "manifest.xml"):
        return
    files = [f for f in repository.suffixed(".sh", ".bash", ".py") if f.size <= MAX_SIZE]
    for file in nearest(f for f in files if not places.vendored(f.path))[: MAX_FILES * 10]:
        text = repository.read(file)
        if not any(word in text for word in _WORDS):
            continue
        found: dict[str, int] = {}
        for number, line in enumerate(text.splitlines(), 1):
            for name in _IN_STRINGS.findall(_NOT_RUN.sub("", line)) if any(word in line for word in _WORDS) else ():
                found.setdefault(name, number)
        for name, number in found.items():
            yield Mention(topic="calls", value=name, source="code", file=file.path, line=number, text=name)
