"""Repositories of C++ beside Python: environments of conda for compiling it, and lists for its scripts."""

from __future__ import annotations

from roslab.decide.decision import Warning_
from roslab.decide.programs import compiled, top_of
from roslab.decide.python.pins import DEVELOPMENT
from roslab.decide.reasons import warn
from roslab.evidence.conda_environment import CondaEnvironment
from roslab.evidence.facts import Evidence
from roslab.knowledge.frameworks import framework_on_cuda
from roslab.knowledge.guesses import tooling
from roslab.values.endings import SHELL_SCRIPTS
from roslab.values.name import canonicalize_name

MEX = "mex.h"
"""The header of C++ that MATLAB compiles and loads: https://www.mathworks.com/help/matlab/ref/mex.html, 2026-11-28"""


def to_compile(evidence: Evidence, environment: CondaEnvironment) -> bool:
    """Tell whether an environment lies with CI, or brings compilers or what CMake asks for, beside code of C++."""
    brought = {package.name for package in environment.packages}
    development = bool(DEVELOPMENT.search(environment.file)) or not brought.isdisjoint(tooling("compilers"))
    top = top_of(evidence)
    asked = {canonicalize_name(each.name) for each in (top.dependencies if top else ()) if each.namespace == "cmake"}
    return (development or not brought.isdisjoint(asked - tooling("bindings"))) and of_cpp(evidence)


def of_cpp(evidence: Evidence) -> bool:
    """Tell whether a repository is about the CMake project at its root, whatever Python lies beside it.

    It is where a page starts a program that CMake compiles, by its path; else not where the code is mostly Python, or
    where a page starts Python.
    """
    top = top_of(evidence)
    if top is None or "/" in top.file:
        return False
    said = [mention for mention in evidence.mentions if mention.topic == "command" and mention.source == "readme"]
    names = {program.name for program in compiled(evidence)}
    if any("/" in word and word.rpartition("/")[2] in names for word in (each.value.split()[0] for each in said)):
        return True
    return mostly_cpp(evidence) and not any(mention.value.startswith("python") for mention in said)


def mostly_cpp(evidence: Evidence) -> bool:
    """Compare the files that include something with those that import something."""
    included = {d.file for d in evidence.code if d.namespace == "include"}
    imported = {d.file for d in evidence.code if d.namespace == "import"}
    return len(included) > len(imported)


def with_helpers(evidence: Evidence) -> bool:
    """Tell whether CMake makes programs, while no Python is started: its modules only serve them, or show results.

    What imports a framework is no helper, and a script that a page starts may start Python.
    """
    started = evidence.programs or any(each.file.endswith(".ipynb") for each in evidence.code)
    frameworks = any(each.namespace == "import" and framework_on_cuda(each.name) for each in evidence.code)
    said = (mention.value.split() for mention in evidence.mentions if mention.topic == "command")
    scripts = any(
        words[0].startswith(("python", "bash", "sh")) or words[0].endswith(SHELL_SCRIPTS) for words in said if words
    )
    return bool(compiled(evidence)) and not (started or frameworks or scripts)


def compiles_nothing(evidence: Evidence) -> bool:
    """Tell whether the CMake of a tree of Python makes no target, fetches nothing and has no code to compile.

    It may install modules, or stop for want of a library that nothing here is linked with.
    """
    makes = any(
        each.executables or each.made or each.targets or each.adds or each.sources or each.macros
        for each in evidence.cmake
    )
    imported = any(each.namespace == "import" for each in evidence.code)
    return imported and not makes and not any(each.namespace == "include" for each in evidence.code)


def built_otherwise(evidence: Evidence) -> tuple[Warning_, ...]:
    """Warn about each build tool that builds the repository and that no step of the image calls."""
    found = (each for each in evidence.mentions if each.topic == "other_builder")
    advice = (
        "which no step of the image calls; install it and call it under `custom` in roslab.yaml, or give a Dockerfile"
    )
    return tuple(warn(f"the repository is built by {each.value}, {advice}", each) for each in found)


def uncompiled(evidence: Evidence) -> tuple[Warning_, ...]:
    """Warn about C++ of a repository of which nothing shows how it is compiled.

    What is written for MATLAB, its own ``mex`` compiles.
    """
    included = [found for found in evidence.code if found.namespace == "include"]
    of_matlab = {found.file for found in included if found.name == MEX}
    others = [found for found in included if found.file not in of_matlab]
    if not others:
        message = "the C++ is MATLAB's, whose mex compiles it: nothing is compiled in the image"
        return tuple(warn(message, found) for found in included[:1])
    project = next((each for each in evidence.mentions if each.topic == "of_windows"), None)
    if project:
        message = f"the C++ is compiled by Visual Studio ({project.value}), which is of Windows alone"
        then = (
            "and nothing else shows how, so nothing is compiled in the image; "
            "write a CMakeLists.txt, or the build under `custom` in roslab.yaml"
        )
        return (warn(f"{message}, {then}", project),)
    message = (
        "there is C++, and nothing shows how it is compiled, so nothing is compiled; "
        "write the build under `custom` in roslab.yaml"
    )
    return (warn(message, others[0]),)
