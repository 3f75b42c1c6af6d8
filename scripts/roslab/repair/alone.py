"""A target of a plain CMake project that does not compile: the default command's program is built without it."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.explain.answer import Answer, Explanation
from roslab.repair.change import Asked, Change, Given
from roslab.repair.linked import linked
from roslab.repair.said import by_machine, said
from roslab.values.pattern import pattern
from roslab.values.words import line_of

KEY = "build_args"
_FAILED = pattern(
    r"(?m)^make(?:\[\d{1,3}\])?: \*\*\* \[(?:[^\]\n]{0,200}: )?(?:[^\]:\n]{0,300}/)?"
    r"CMakeFiles/(?P<target>[^/\]\n]{1,200})\.dir/all\]"
)
"""The line of make for a target that it gave up. https://cmake.org/cmake/help/latest/generator/Unix%20Makefiles.html."""
_ALL = pattern(r"add_custom_target\s{0,9}\([^)]{1,200}\bALL\b|add_custom_command\s{0,9}\(\s{0,9}TARGET\b")
"""What is made beside the programs, such as copies of data: the program may need it."""
_CMAKE = ("CMakeLists.txt", ".cmake")


def alone(answer: Answer, given: Given) -> tuple[Change, ...]:
    """Return what has make build the default command's program, with what that links, and nothing else.

    Where make stopped at other targets alone, none of which the program links or waits for, nothing is installed or
    tested, and CMake makes nothing but libraries and programs.
    """
    program = given.plan.workspace.program
    name = line_of(given.plan.run.command).partition(" ")[0].rpartition("/")[2]
    if program is None or program.install or program.arguments or given.plan.author_dockerfile:
        return ()
    if given.config.generation != "today" or name not in _programs(given) or _tested(given) or _more(given):
        return ()
    failed = [(target, found) for found in answer.explanations for target in _targets(found)]
    wrong = any(by_machine(found) or not _targets(found) for found in answer.explanations)
    if wrong or not failed or given.read is None:
        return ()
    if linked(name, _files(given), given.read).intersection(target for target, _ in failed):
        return ()
    target, found = failed[0]
    what, place = said(found, given)
    at = f" at {place}" if place else ""
    why = f"for {target} does not compile: {what}{at}; the command does not need it"
    asked = Asked(what=what, place=place)
    return (Change(key=KEY, value=name, failure=found.id or "", certain=True, asked=asked, why=why),)


def _targets(found: Explanation) -> tuple[str, ...]:
    return tuple(dict.fromkeys(match["target"] for match in _FAILED.finditer(found.log)))


def _programs(given: Given) -> Iterator[str]:
    """Yield the programs that CMake makes as targets of their names."""
    for project in given.evidence.cmake:
        yield from (name for name, _ in project.executables if name in project.targets)


def _tested(given: Given) -> bool:
    return bool(given.config.test) or any("ctest " in word for each in given.plan.proofs for word in each.command)


def _more(given: Given) -> bool:
    return given.read is None or any(_ALL.search(given.read(file)) for file in _files(given))


def _files(given: Given) -> Iterator[str]:
    return (file for file in given.files if file.endswith(_CMAKE))
