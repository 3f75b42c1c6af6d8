"""Who asked for what is missing: the line of a CMakeLists.txt, a source, a package.xml or roslab.yaml."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping

from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import Evidence
from roslab.explain.answer import Explanation
from roslab.repair.change import Asked, Given
from roslab.values.origin import Place
from roslab.values.pattern import pattern

_KINDS = (
    ("header", ("include",), "the header"),
    ("name", ("cmake", "ros", "rosdep"), "the package"),
    ("module", ("import", "pkg-config"), "the module"),
    ("library", ("link",), "the library"),
    ("key", ("rosdep",), "the key"),
    ("program", (), "the program"),
    ("package", ("rosdep", "ros"), "the package"),
    ("tool", (), "the program"),
)
"""For each name that a failure captures, the kinds of dependencies that it may be, and what it is called."""
FRAME = pattern(r'File "(?P<file>[^"\n]{1,300})", line (?P<line>\d{1,6})')
_CMAKE = pattern(r"(?m)(?:CMake Error at |^ {1,4})(?P<file>[\w./+-]{1,300}):(?P<line>\d{1,6}) \(")
"""The place of an error, or a line of the calls that led to it."""
_NAMED = pattern(r"[`']([^`'\n]{1,80})'")
"""What an error of a compiler or a linker is about."""
_AT = pattern(r"(?P<file>[\w./+-]{1,300}\.\w{1,8}):(?P<line>\d{1,6})\b")


def asked(found: Explanation, given: Given, value: str = "") -> Asked:
    """Return what a failed step lacks and who asked for it, as evidence, roslab.yaml and the log name it.

    ``value`` is the value of roslab.yaml or the package that the repair names.
    """
    names = dict(found.names)
    if names.get("last") and names.get("what"):
        what = f"{names['what']}, which Python has up to {names['last']}"
        return Asked(what=what, place=in_log(found, given) or _named_by_plan(given, names.get("package", "")))
    for captured, kinds, title in _KINDS:
        words = [word for word in names.get(captured, "").split(", ") if word]
        for word in words:
            place = _declared(given.evidence, word, kinds) or _written(given, word)
            if place:
                return Asked(what=f"{title} {word}", place=place)
        if words:
            return Asked(what=f"{title} {words[0]}", place=in_log(found, given))
    if names.get("flag") and (quoted := _NAMED.search(found.error)):
        return Asked(what=f"what is said of {quoted[1]}", place=in_log(found, given))
    what = f"numpy without {names['symbol']}" if names.get("symbol") and "numpy" in value else found.id or ""
    return Asked(what=what.replace("-", " "), place=in_log(found, given) or _named_by_plan(given, value))


def _declared(evidence: Evidence, word: str, kinds: tuple[str, ...]) -> Place | None:
    """Return the place of a dependency with this name, a declared one before one that is only used."""
    found = [each for each in _dependencies(evidence) if each.namespace in kinds and _same(each, word)]
    ranks = {"declared": 0, "used": 1, "optional": 2, "prose": 3}
    best = min(found, key=lambda each: (ranks[each.strength], each.file, each.line), default=None)
    return Place(file=best.file, line=best.line) if best else None


def _same(dependency: Dependency, word: str) -> bool:
    name = dependency.name
    if dependency.namespace == "include":
        return name == word or name.endswith(f"/{word}")
    if dependency.namespace == "import":
        return name.split(".")[0] == word.split(".", maxsplit=1)[0]
    return name == word or word.endswith(f"-{name.replace('_', '-')}")


def _dependencies(evidence: Evidence) -> Iterator[Dependency]:
    for manifest in evidence.manifests:
        yield from manifest.dependencies
    for project in evidence.cmake:
        yield from project.dependencies
    yield from evidence.code


def _written(given: Given, word: str) -> Place | None:
    """Return the place of a value of roslab.yaml or of a requirement file with this name."""
    for key in ("apt", "pip", "pip3", "skip_keys"):
        for index, value in enumerate(getattr(given.config, key)):
            origin = given.config.origin(f"{key}.{index}") or given.config.origin(key)
            if re.split(r"[=<>~! \[;]", value)[0] == word and isinstance(origin, Place):
                return origin
    for file in given.evidence.requirements:
        for requirement in file.requirements:
            if requirement.name and requirement.name.lower() == word.lower():
                return Place(file=requirement.file, line=requirement.line)
    return None


def _named_by_plan(given: Given, value: str) -> Place | None:
    """Return the place of the plan's own reason for a package, such as the line of a requirement."""
    name = re.split(r"[=<>~! ]", value)[0]
    for reason in given.plan.reasons:
        if name and reason.file and re.split(r"[=<>~! ]", reason.answer)[0] == name:
            return Place(file=reason.file, line=reason.line)
    return None if not name else _written(given, name) or _declared(given.evidence, name, ("import",))


def in_log(found: Explanation, given: Given) -> Place | None:
    """Return the last place of the repository that the failed lines name; paths in the image are longer than here."""
    names: Mapping[str, str] = dict(found.names)
    end = found.log[-6000:]
    inside = tuple(f"{folder}/" for folder in package_folders(found, given))
    said = [*FRAME.finditer(found.error), *_AT.finditer(found.error)]
    for places in (said, [*_CMAKE.finditer(end)], [*FRAME.finditer(end)] if "Traceback" in end else []):
        for match in reversed(places):
            if file := here(match["file"], given.files, inside):
                return Place(file=file, line=int(match["line"]))
    file = here(names.get("file", ""), given.files, inside)
    return Place(file=file) if file else None


def package_folders(found: Explanation, given: Given) -> tuple[str, ...]:
    """Return the folders of the repository's packages in which a build tool stopped, by their names."""
    names = {*found.packages}
    folders = (each.file.rpartition("/")[0] for each in given.evidence.manifests if names and each.name in names)
    return tuple(folder for folder in folders if folder)


def here(path: str, files: frozenset[str], inside: Iterable[str] = ()) -> str:
    """Return the repository's file that a path of the image means, ``""`` if none: the longest end that exists.

    ``inside``: folders, with a slash behind each, to which a short path may be relative.
    """
    parts = [part for part in path.split("/") if part not in ("", ".")]
    plain = "/".join(parts)
    if not path.startswith("/") and (one := next((f"{each}{plain}" for each in inside if each + plain in files), "")):
        return one
    for start in range(len(parts)):
        if "/".join(parts[start:]) in files:
            return "/".join(parts[start:])
    return ""
