"""The Python programs that can be started."""

from __future__ import annotations

import re

from roslab.evidence import places
from roslab.evidence.lex.lines import first_line
from roslab.evidence.program import Program
from roslab.evidence.python.imported_programs import imported_programs
from roslab.evidence.python.modules import modules
from roslab.evidence.python.own_folder import own_folder
from roslab.evidence.python.own_tests import only_tests
from roslab.evidence.python.packages_started import package
from roslab.evidence.python.sample_programs import is_sample
from roslab.evidence.python.top_level import called_like_one, first_statement
from roslab.repository.checkout import Repository
from roslab.values.dataclass import replace
from roslab.values.pattern import pattern

_MAIN = pattern(r"^if[ \t]+__name__[ \t]*==[ \t]*[\"']__main__[\"']", re.MULTILINE)
_NODE = pattern(r"^[ \t]*(?:import rospy|from rospy|import rclpy|from rclpy)", re.MULTILINE)

_RELATIVE = pattern(r"^from[ \t]+\.", re.MULTILINE)
"""Not in a ``try``, where the other import may follow: https://docs.python.org/3/reference/import.html, 2026-11-27."""


def read(repository: Repository) -> tuple[Program, ...]:
    """Return the Python files that are programs: a ``__main__`` guard, ``__main__.py``, a ROS node.

    Without a guard, what lies at the root, is called ``main_….py``, ``run_….py`` or ``demo_….py``, and does something.
    None is what a tool wrote into a new project to be replaced.
    """
    return repository.once(_programs)


def _programs(repository: Repository) -> tuple[Program, ...]:
    found = []
    for module in modules(repository):
        file, text = module.file, module.text
        if places.test(file.path) or file.name in {"setup.py", "conftest.py"}:
            continue
        if file.name == "__main__.py":
            found.append(Program(file=file.path, line=1, kind="main", module=package(repository, module)))
        elif "__main__" in module.words and (match := first_line(_MAIN, text, "__main__")):
            if only_tests(text[match.end() :]) or is_sample(text):
                continue
            node = module.names_ros and bool(_NODE.search(text))
            found.append(
                Program(
                    file=file.path,
                    line=text.count("\n", 0, match.start()) + 1,
                    kind="node" if node else "main",
                    inside=own_folder(repository, module),
                    relative=bool(_RELATIVE.search(text)) and "__package__" not in text,
                )
            )
        elif not file.folder and called_like_one(file.name) and (line := first_statement(text)):
            if is_sample(text):
                continue
            node = module.names_ros and bool(_NODE.search(text))
            found.append(Program(file=file.path, line=line, kind="node" if node else "main", guarded=False))
    near = (each.file for each in found if each.kind == "main" and each.file.count("/") <= 1)
    imported = imported_programs(repository, near) if not repository.named("package.xml") else frozenset()
    found = [replace(each, imported=True) if each.file in imported else each for each in found]
    return tuple(sorted(found, key=lambda script: script.file))
