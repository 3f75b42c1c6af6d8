"""Programs that CMake files call: those that make the sources of another project ready, fetch or generate something.

https://cmake.org/cmake/help/latest/module/ExternalProject.html, 2026-11-27
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from roslab.evidence import places
from roslab.evidence.dependency import Dependency
from roslab.evidence.lex.cmake import Call, calls
from roslab.evidence.native.cmake_needs import of_no_build
from roslab.knowledge.cmake_calls import packages_of_calls
from roslab.repository.checkout import File, Repository
from roslab.values.pattern import pattern

_CALLING = frozenset(
    {
        *("externalproject_add", "externalproject_add_step", "execute_process", "exec_program"),
        *("add_custom_command", "add_custom_target"),
    }
)
_NAMES = _CALLING | {"find_program"}
_REPOSITORIES = {"SVN_REPOSITORY": "svn", "HG_REPOSITORY": "hg"}
_BEFORE = pattern(r"(?:\w+_)?COMMAND$|(?:&&|\|\|?|;)$")
"""What a command begins after."""
_PASSED = pattern(r"(?:(?:.*/)?(?:ba|da)?sh|env|sudo|cmake|\$\{CMAKE_COMMAND\}|-\S+|\w+=.*)$")
"""What may stand before the program that is really called."""


def read(repository: Repository, files: Iterable[File]) -> Iterator[Dependency]:
    """Yield the packages of the programs that files of CMake call, each once and where it is called first."""
    seen: set[str] = set()
    for file in files:
        if places.vendored(file.path) or places.aside(file.path) or places.test(file.path):
            continue
        text = repository.read(file)
        if not any(name in text for name in (*packages_of_calls(), *_REPOSITORIES)):
            continue
        for name, line in programs(text):
            for package in packages_of_calls().get(name, ()):
                if package not in seen:
                    seen.add(package)
                    yield Dependency(
                        namespace="apt", name=package, strength="used", file=file.path, line=line, role="run"
                    )


def programs(text: str) -> Iterator[tuple[str, int]]:
    """Yield the names of the programs that a file calls in every build on Linux, each with its line."""
    found: dict[str, str] = {}
    for call in calls(text, _NAMES):
        if call.name == "find_program":
            names = [word for word in call.words[1:] if word != "NAMES"][:1]
            found |= {f"${{{call.words[0]}}}": name for name in names}
        elif not any(of_no_build(condition) for condition in call.conditions):
            written = call.written if call.written != call.words else ()  # a filled text is split at semicolons
            words = dict.fromkeys((*_called(call, call.words), *_called(call, written)))
            yield from ((found.get(word, word).rpartition("/")[2], call.line) for word in words)


def _called(call: Call, texts: tuple[str, ...]) -> Iterator[str]:
    """Yield the words that stand where a program does, and the programs that fetch a repository."""
    words = [part for text in texts for part in text.replace(";", " ; ").split()]
    yield from (program for key, program in _REPOSITORIES.items() if key in words)
    begins = call.name == "exec_program"
    for word in words:
        if _BEFORE.match(word):
            begins = True
        elif begins and not _PASSED.match(word):
            begins = False
            yield word
