"""ROS packages whose programs and launch files the tree's shell scripts start: ``rosrun rosserial_python …``."""

from __future__ import annotations

from roslab.evidence import places
from roslab.evidence.dependency import Dependency
from roslab.knowledge.released import ever_released
from roslab.repository.checkout import Repository, nearest
from roslab.values.pattern import pattern

MAX_SIZE = 64 * 1024
MAX_FILES = 100
"""Most scripts that are opened, those nearest to the root first."""
_STARTED = pattern(
    r"(?<![\w./-])(?:rosrun|roslaunch|ros2[ \t]+(?:run|launch))[ \t]+"
    r"(?:--?\S+[ \t]+)*([a-z][a-z0-9_]+)[ \t]+[\w\"'$./-]"
)

_NOT_RUN = pattern(r"(?:^|\s)#.*|(?<![\w./-])(?:echo|printf)\s(?:\"(?:[^\"\\]|\\.)*\"|'[^']*'|[^;&|\"'])*")
"""A comment, and what a line prints."""
_WORDS = ("rosrun", "roslaunch", "ros2")


def read(repository: Repository) -> tuple[Dependency, ...]:
    """Return each released package once, at its first place; ``roslaunch a.launch`` names none."""
    found: dict[str, Dependency] = {}
    scripts = [f for f in repository.suffixed(".sh", ".bash") if f.size <= MAX_SIZE and not places.aside(f.path)]
    for file in nearest(scripts)[:MAX_FILES]:
        text = repository.read(file)
        for number, line in enumerate(text.splitlines(), 1) if any(word in text for word in _WORDS) else ():
            for name in _STARTED.findall(_NOT_RUN.sub("", line)) if any(word in line for word in _WORDS) else ():
                if name not in found and ever_released(name):
                    found[name] = Dependency(
                        namespace="ros", name=name, strength="prose", file=file.path, line=number, role="exec"
                    )
    return tuple(found.values())
