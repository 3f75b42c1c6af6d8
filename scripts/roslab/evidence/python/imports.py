"""Python imports."""

from __future__ import annotations

import re
import sys
from collections.abc import Iterable, Iterator, Mapping
from functools import cache

from roslab.evidence import places
from roslab.evidence.dependency import Dependency
from roslab.evidence.python import notebooks
from roslab.evidence.python.compiled_modules import compiled_modules
from roslab.evidence.python.foreign import foreign
from roslab.evidence.python.modules import MAX_READ, Module, modules
from roslab.evidence.python.namesakes import Namesakes, namesakes
from roslab.evidence.python.of_python3 import of_modules, of_python3
from roslab.evidence.python.programs import read as programs
from roslab.evidence.python.rendered import rendered
from roslab.evidence.python.shown_by_imports import names, shown_by_imports
from roslab.evidence.python.statements import IMPORT, statements
from roslab.evidence.python.stopping_tries import starts
from roslab.evidence.python.through_modules import of_tree
from roslab.knowledge.frameworks import imports as known_imports
from roslab.knowledge.standard_modules import standard_modules
from roslab.knowledge.windows import shown
from roslab.repository.checkout import File, Repository
from roslab.values.dataclass import replace
from roslab.values.name import canonicalize_name
from roslab.values.pattern import pattern

_TYPELIB = pattern(r"\brequire_version\(\s*[\"'](\w+)[\"']\s*,\s*[\"']([\d.]+)[\"']")
_PLAIN_PYTHON = pattern(r"\A#![ \t]*/usr/(?:bin/env[ \t]+|(?:local/)?bin/)python[ \t]*\r?$", re.MULTILINE)
"""A first line that starts `python`, which Ubuntu 20.04 and newer install only on demand."""
_OF_NODES = frozenset({"torch", "tensorflow", "jax", "keras"})
"""Frameworks, which are too large to be installed for a helper script beside the nodes."""
_MESSAGES = pattern(r"\w+\.(?:msg|srv|action)(?:\.|$)")
"""The generated modules of a package of ROS."""
_ROS = pattern(r"^(?:import|from) r(?:os|cl)py\b", re.MULTILINE)


def read(repository: Repository) -> tuple[Dependency, ...]:
    """Return what the tree's Python files import from outside the tree and the standard library.

    Each name once, at its first place, one of a script, an example or a test only where no other imports it;
    ``optional`` if it is only imported inside a function or a ``try`` that goes on without it: then it has
    the role ``told`` where the module says how to install it. A framework that a node of ROS imports, by modules of the
    tree too, has the role ``node``; of what messages, services or actions are imported, the role ``messages``.
    Calls that open windows are included, each library's once for a file, and those of the modules that it imports; the
    package of a plain ``python`` if the first line of a program starts that, those for Python 3 of what programs import
    whose first line asks for that, and those of the libraries of GObject that a program asks for.
    """
    local, sorted_in, like = _local(repository)
    found: dict[str, Dependency] = {}
    said: dict[str, Dependency] = {}
    imported: dict[str, list[str]] = {}
    frameworks: dict[str, list[tuple[re.Match[str], list[str]]]] = {}
    outside: dict[str, set[str]] = {}
    for module in modules(repository):
        file, text = module.file, module.text
        if "" not in found and (started := _started(file, text)):
            found[""] = started
        if "import" not in text:
            continue
        drawn = rendered(module)
        opened = shown(text, words=module.words)
        for library, position in (opened if drawn is None else {**opened, "gym": drawn}).items():
            found[f"{library} {file.path}"] = Dependency(
                namespace="call", name=library, strength="used", file=file.path, line=text.count("\n", 0, position) + 1
            )
        found |= {f"{each.name} {each.role}": each for each in _typelibs(module)}
        found_in = [(match, modules_of(match, sorted_in)) for match in module.statements]
        imported[file.path] = [name for match, _ in found_in for name in names(match)]
        said = {**_told(module, found_in), **said}
        outside[file.path] = {top for _, tops in found_in for top in tops} - local
        found = {f"{each.name} {each.role}": each for each in of_python3(module, outside[file.path])} | found
        frameworks[file.path] = [each for each in found_in if not _OF_NODES.isdisjoint(each[1])]
        node = bool(frameworks[file.path]) and _of_node(module)
        stopped = starts(text) if any(match["indent"] for match, _ in found_in) else frozenset()
        for match, tops in found_in:
            tried = bool(match["indent"]) and match.start() not in stopped
            for top in tops:
                inside = top in local and not foreign(match, _whole(match), top, like, file)
                if _standard(top) or inside or top.startswith("_"):
                    continue
                known = found.get(top)
                role = "" if tried else _role(match, top, node=node)
                if known is not None and (tried or _stays(known, file)):
                    found[top] = replace(known, role=role, strength="used") if role else known
                    continue
                found[top] = Dependency(
                    namespace="import",
                    name=top,
                    strength="optional" if tried else "used",
                    file=file.path,
                    line=text.count("\n", 0, match.start()) + 1,
                    role=role or (known.role if known else ""),
                )
    calls = [each for each in found.values() if each.namespace == "call"]
    for call in shown_by_imports(imported, calls):
        found.setdefault(f"{call.name} {call.file}", call)
    found = {f"{each.name} {each.role}": each for each in of_modules(repository, outside)} | found
    _add_of_nodes(repository, found, frameworks)
    _add_told(said, found)
    _add_notebooks(repository, local, sorted_in, found)
    return tuple(sorted(found.values(), key=lambda dependency: (dependency.file, dependency.line)))


def _role(match: re.Match[str], top: str, *, node: bool) -> str:
    return "node" if node and top in _OF_NODES else "messages" if any(map(_MESSAGES.match, _whole(match))) else ""


def _stays(known: Dependency, file: File) -> bool:
    """Tell whether a place of an import is as good as this file: a script's, an example's or a test's gives way."""
    return known.strength == "used" and (not places.beside(known.file) or places.beside(file.path))


def _started(file: File, text: str) -> Dependency | None:
    """Return the package of ``python`` if the first line of a program starts that."""
    if not _PLAIN_PYTHON.match(text) or places.test(file.path):
        return None
    return Dependency(
        namespace="apt", name="python-is-python3", strength="used", file=file.path, line=1, role="shebang"
    )


def _told(module: Module, statements: Iterable[tuple[re.Match[str], list[str]]]) -> dict[str, Dependency]:
    """Return what a module imports inside a function or a ``try`` and tells to install; no test's."""
    file, text = module.file, module.text
    if "install" not in module.words or places.test(file.path):
        return {}
    from roslab.evidence.python.told import told  # noqa: PLC0415 - few modules say so

    if not (said := told(text)):
        return {}
    found: dict[str, Dependency] = {}
    for match, tops in statements:
        for top in tops if match["indent"] else ():
            package, _ = known_imports().get(top) or (None, None)
            names = [canonicalize_name(name) for name in (package, top) if name]
            version = next((said[name] for name in names if name in said), None)
            if version is not None:
                line = text.count("\n", 0, match.start()) + 1
                found[top] = Dependency(
                    namespace="import",
                    name=top,
                    strength="optional",
                    file=file.path,
                    line=line,
                    version=version or None,
                    role="told",
                )
    return found


def _add_told(said: Mapping[str, Dependency], found: dict[str, Dependency]) -> None:
    """Put what is told to be installed in the place of an import that may fail, or of a test's."""
    for name, each in said.items():
        known = found.get(name)
        if known and not known.role and (known.strength != "used" or places.test(known.file)):
            found[name] = each


def _of_node(module: Module) -> bool:
    """Tell whether a module imports the library of ROS's nodes."""
    return module.names_ros and bool(_ROS.search(module.text))


def _add_of_nodes(
    repository: Repository,
    found: dict[str, Dependency],
    frameworks: Mapping[str, Iterable[tuple[re.Match[str], list[str]]]],
) -> None:
    """Give the role ``node`` to frameworks that nodes import by other modules; ``frameworks``: statements by file."""
    whole = ((file, match, top) for file, each in frameworks.items() for match, tops in each for top in tops)
    left = [(file, match, top) for file, match, top in whole if top in found and not match["indent"]]
    left = [each for each in left if each[2] in _OF_NODES and found[each[2]].role != "node"]
    nodes = [each for each in modules(repository) if left and not places.test(each.file.path) and _of_node(each)]
    reached = of_tree(repository).reached(each.file.path for each in nodes) if nodes else frozenset()
    for file, match, top in left:
        if file in reached and found[top].role != "node":
            line = match.string.count("\n", 0, match.start()) + 1
            found[top] = replace(found[top], role="node", strength="used", file=file, line=line)


def _typelibs(module: Module) -> Iterator[Dependency]:
    """Yield the packages of ``gi.require_version("Gtk", "3.0")``.

    https://pygobject.gnome.org/guide/api/api.html#gi.require_version
    """
    file, text = module.file, module.text
    if "require_version" not in module.words or places.test(file.path):
        return
    from roslab.knowledge.typelibs import typelibs  # noqa: PLC0415 - few modules ask for one

    for match in _TYPELIB.finditer(text):
        if apt := typelibs().get((match[1], match[2])):
            line = text.count("\n", 0, match.start()) + 1
            yield Dependency(namespace="apt", name=apt, strength="used", file=file.path, line=line, role="typelib")


def _add_notebooks(
    repository: Repository, local: frozenset[str], sorted_in: frozenset[str], found: dict[str, Dependency]
) -> None:
    for file in notebooks.files(repository):
        text = repository.read(file, limit=notebooks.MAX_SIZE)
        for line, code in notebooks.imports(text):
            match = IMPORT.match(code)
            for top in modules_of(match, sorted_in) if match and not match["indent"] else ():
                if not _standard(top) and top not in local and top not in found and not top.startswith("_"):
                    found[top] = Dependency(
                        namespace="import", name=top, strength="optional", file=file.path, line=line
                    )


def modules_of(match: re.Match[str], sorted_in: frozenset[str] = frozenset()) -> list[str]:
    """Return the top-level modules that a statement imports, without those that ``sorted_in`` has whole."""
    return [name.partition(".")[0] for name in _whole(match) if name not in sorted_in]


def _whole(match: re.Match[str]) -> list[str]:
    """Return the modules that a statement imports, by their whole names."""
    return [match["module"]] if match["module"] else [part.split()[0] for part in match["plain"].split(",")]


@cache
def _standard(module: str) -> bool:
    """Tell whether a module is in Python's library; Debian and Ubuntu have separate packages for parts of it."""
    own = module in sys.stdlib_module_names or module in standard_modules()
    return own and module not in known_imports()


def _local(repository: Repository) -> tuple[frozenset[str], frozenset[str], Namesakes]:
    """Return every name that could be a module of the tree: its Python files, their folders and what it compiles.

    A folder that only holds others and is called like a known package (``gym``) sorts what is for that package. What
    is in it may be imported all the same: these modules are returned apart, whole (``datasets.indoor.loader``). So is a
    package inside another one that no program lies beside: nothing finds it without the name of the other. Of those
    that are called like known packages, the last value tells which import means them.
    """
    packages = {file.folder for file in repository.named("__init__.py")}
    beside = {program.file.rpartition("/")[0] for program in programs(repository)}
    inside = {folder for folder in packages if folder.rpartition("/")[0] in packages - beside}
    names: set[str] = set()
    above: set[str] = set()
    sorted_in: set[str] = set()
    for file in repository.suffixed(".py", ".pyx", ".so"):
        *holding, folder = file.folder.split("/")
        stem = file.name.partition(".")[0]
        names |= {stem} if file.folder in inside and folder in known_imports() else {stem, folder}
        above.update(holding)
        whole = [*holding, folder] if stem == "__init__" else [*holding, folder, stem]
        sorted_in |= {".".join(whole[at:]) for at, name in enumerate(holding) if name in known_imports()}
    names |= above - known_imports().keys()
    names -= _imported_beside(repository, names - {file.name.partition(".")[0] for file in repository.suffixed(".py")})
    of_ros = {file.folder.rpartition("/")[2] for file in repository.named("package.xml")}
    compiled = compiled_modules(repository)
    like = names & known_imports().keys() - of_ros - compiled
    started = (program.file for program in programs(repository))
    return (
        frozenset(names | of_ros | compiled),
        frozenset(sorted_in),
        namesakes(repository, like, started),
    )


def _imported_beside(repository: Repository, names: set[str]) -> set[str]:
    """Return the folders whose own programs import a known package of that name, which is not the folder.

    A program's folder is on Python's path, and not the one above it.
    """
    packages = {file.folder for file in repository.named("__init__.py")}
    found = set()
    for file in repository.suffixed(".py") if names & known_imports().keys() else ():
        name = file.folder.rpartition("/")[2]
        if name in names and name in known_imports() and file.folder not in packages:
            text = repository.read(file, limit=MAX_READ)
            if any((match["plain"] or "").partition(" ")[0] == name for match in statements(text)):
                found.add(name)
    return found
