"""Conda environments in which a C++ project is compiled, by CI or its developers: they make it no Python project."""

from __future__ import annotations

from roslab.decide.programs import top_of
from roslab.decide.python.pins import DEVELOPMENT
from roslab.evidence.facts import CondaEnvironment, Evidence
from roslab.knowledge.guesses import tooling


def to_compile(evidence: Evidence, environment: CondaEnvironment) -> bool:
    """Tell whether an environment lies with CI, or brings compilers, beside a CMake project at the root.

    Not where the code is mostly Python, or where a page starts Python: it is for that then.
    """
    top = top_of(evidence)
    if top is None or "/" in top.file or not mostly_cpp(evidence):
        return False
    commands = (mention for mention in evidence.mentions if mention.topic == "command" and mention.source == "readme")
    if any(mention.value.startswith("python") for mention in commands):
        return False
    brought = {package.name for package in environment.packages}
    return bool(DEVELOPMENT.search(environment.file)) or not brought.isdisjoint(tooling("compilers"))


def mostly_cpp(evidence: Evidence) -> bool:
    """Compare the files that include something with those that import something."""
    included = {d.file for d in evidence.code if d.namespace == "include"}
    imported = {d.file for d in evidence.code if d.namespace == "import"}
    return len(included) > len(imported)
