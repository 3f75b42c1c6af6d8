"""The tree's own modules for required packages: what they look for and stop without, and those that never stop."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import lru_cache

from roslab.evidence.dependency import Dependency
from roslab.evidence.lex.cmake import Call, calls
from roslab.evidence.native.cmake_needs import needs
from roslab.evidence.native.linker_flags import module_of, of_module
from roslab.evidence.native.searched import SEARCHED, held, known, sought_header
from roslab.evidence.native.x86_searched import wanted
from roslab.knowledge.libraries import header, library
from roslab.repository.checkout import File, Repository
from roslab.values.dataclass import replace
from roslab.values.pattern import pattern

Asked = tuple[tuple[str, ...], tuple[str, ...], bool]
"""Words and conditions of a call, and whether a function makes it."""
MOST = 60
"""Most calls of a file whose modules are read."""
_FINDS = frozenset({"find_library", "find_path"})
_TELLS = "find_package_handle_standard_args"
_VARIABLES = "REQUIRED_VARS"
_OPTION = pattern(r"(?:VERSION_VAR|HANDLE_\w+|CONFIG_MODE|REASON_\w+|FAIL_MESSAGE|NAME_MISMATCHED)")
_WORD = pattern(r"\w+")
_STOPS = pattern(r"handle_standard_args|(?:FATAL|SEND)_ERROR", re.IGNORECASE)
_WAYS = frozenset({"find_package", "find_library", "pkg_check_modules"})


def by_module(
    call: Call, repository: Repository, file: File, known: set[Asked], *, included: bool = False
) -> Iterator[Dependency]:
    """Yield what the tree's own module for what ``find_package`` asks for needs itself, nothing for another call.

    ``known``: what calls of the file have asked of such modules so far. Of an ``included`` file, only what the module
    requires.
    """
    asked = (call.words, call.conditions, call.in_function)
    if call.name != "find_package" or asked in known or len(known) >= MOST or not module_of(call, repository, file):
        return
    known.add(asked)
    if not included:
        yield from of_module(call, repository, file)
        yield from searched_by_module(call, repository, file)
    yield from required_by_module(call, repository, file)


def searched_by_module(call: Call, repository: Repository, file: File) -> Iterator[Dependency]:
    """Yield the first library of no table and not of the tree without which such a module does not find its package.

    Where it finds it without any library, that is the first such header.

    https://cmake.org/cmake/help/latest/module/FindPackageHandleStandardArgs.html, 2026-11-28. A search under a
    condition counts where that only asks for what the module has found before. None for a package that a table knows.
    """
    name = call.words[0] if call.words else ""
    if "REQUIRED" not in call.words or call.conditions or call.in_function or library("cmake", name, None):
        return
    module = module_of(call, repository, file)
    text = repository.read(module) if module else ""
    if _TELLS not in (lowered := text.lower()) or ("find_library" not in lowered and "find_path" not in lowered):
        return
    looked: dict[str, Call] = {}
    required: list[str] = []
    for inner in calls(text, _FINDS | {_TELLS}):
        if inner.name == _TELLS:
            required += _required(inner)
        elif inner.words:
            looked.setdefault(inner.words[0], inner)
    found = {*looked, f"{name}_FOUND", f"{name.upper()}_FOUND", "NOT", "AND", "OR"}
    always = [search for variable in required if (search := looked.get(variable)) and _always(search, found)]
    libraries = [search for search in always if search.name == "find_library"]
    for search in libraries:
        names = [each.removeprefix("-l") for each in wanted(search)]
        if names and not any("$" in each or known(each) or held(each, repository) for each in names):
            yield Dependency(
                namespace="link", name=names[0], strength="used", file=file.path, line=call.line, role=SEARCHED
            )
            return
    for search in always if not libraries else ():
        asked = sought_header([search], file.path, repository)
        if asked and header(asked.name, None) is None:
            yield replace(asked, line=call.line)
            return


def required_by_module(call: Call, repository: Repository, file: File) -> Iterator[Dependency]:
    """Yield what such a module itself requires, whatever it finds: another package that it wraps."""
    required = call.name == "find_package" and "REQUIRED" in call.words and not call.in_function
    module = module_of(call, repository, file) if required else None
    text = repository.read(module) if module else ""
    if module is None or text.count("find_package") <= text.count("find_package_"):
        return
    for inner in calls(text, frozenset({"find_package"})):
        own = inner.words[:1] == call.words[:1] or inner.conditions or inner.in_function
        if not own and "REQUIRED" in inner.words:
            yield from needs(replace(inner, conditions=call.conditions), module.path, None)


def goes_on(call: Call, text: str, repository: Repository, file: File) -> bool:
    """Tell whether CMake looks for another library where a module that never stops has not found a required one.

    That is behind the ``else`` of ``if(NAME_FOUND)``, and what the author has: who installs what the page says lacks
    the first one. With that there, the build takes it, which nobody may have tried on this Ubuntu.
    """
    if call.name != "find_package" or "REQUIRED" not in call.words:
        return False
    module = module_of(call, repository, file)
    if module is None or f"not ({call.words[0]}_found)".lower() not in _conditions(text):
        return False
    return not _STOPS.search(repository.read(module))


@lru_cache(maxsize=1)  # a file is asked about once for each of its calls
def _conditions(text: str) -> frozenset[str]:
    """Return the conditions, in lower case, under which a file looks for anything."""
    if "_FOUND" not in text:
        return frozenset()
    return frozenset(each.lower() for other in calls(text, _WAYS) for each in other.conditions)


def _required(call: Call) -> list[str]:
    """Return the variables that have to be set: those after ``REQUIRED_VARS``, or behind the message."""
    if _VARIABLES not in call.words:
        return list(call.words[2:])
    words = call.words[call.words.index(_VARIABLES) + 1 :]
    end = next((at for at, word in enumerate(words) if _OPTION.fullmatch(word)), len(words))
    return list(words[:end])


def _always(search: Call, found: set[str]) -> bool:
    return not search.in_function and all(found.issuperset(_WORD.findall(each)) for each in search.conditions)
