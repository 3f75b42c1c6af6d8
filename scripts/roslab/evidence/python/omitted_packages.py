"""Folders of a ROS package of Python that its setup.py does not install, and that its programs import.

``packages=['demo']`` installs the folder ``demo`` without those inside it
(https://setuptools.pypa.io/en/latest/userguide/package_discovery.html, read 2026-11-27). On the author's machine
colcon's ``--symlink-install`` hides that: it installs links to the source.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING

from roslab.evidence.facts import Mention
from roslab.evidence.python.modules import MAX_READ, setup_scripts
from roslab.repository.checkout import Repository

if TYPE_CHECKING:
    from roslab.evidence.python.setup_py import SetupScript

_ELSEWHERE = frozenset({"package_dir", "py_modules", "cmdclass", "**"})
"""Arguments of ``setup`` by which packages may be installed that are not named."""
_MOST = 200
"""Most modules of one package that are read."""


def read(repository: Repository) -> Iterator[Mention]:
    """Yield each such folder at the call of ``setup``, its text the file and line that import it."""
    for module in setup_scripts(repository):
        folder = module.file.folder
        manifest = f"{folder}/package.xml".lstrip("/")
        if "packages" not in module.text or not repository.has(manifest):
            continue
        from roslab.evidence.python.setup_py import read as packages_of  # noqa: PLC0415 - it imports Python's own parser

        script = packages_of(module.text)
        if script.packages and script.scripts and not script.catkin and not _ELSEWHERE & script.arguments:
            yield from _of_script(repository, module.file.path, folder, script)


def _of_script(repository: Repository, path: str, folder: str, script: SetupScript) -> Iterator[Mention]:
    above = f"{folder}/" if folder else ""
    told: set[str] = set()
    for name, file, line in _imported(repository, above, _started(script.scripts)):
        omitted = next((part for part in _above(name) if _omits(repository, above, part, script.packages)), None)
        if omitted and omitted not in told:
            told.add(omitted)
            by = f"{file}:{line}"
            yield Mention(topic="omitted_package", value=omitted, source="code", file=path, line=script.line, text=by)


def _started(scripts: Iterable[str]) -> Iterator[str]:
    """Yield the modules of entries: ``run = demo.node:main``."""
    yield from (entry.partition("=")[2].partition(":")[0].strip() for entry in scripts)


def _above(module: str) -> Iterator[str]:
    """Yield a module and what holds it, the outermost first."""
    parts = module.split(".")
    yield from (".".join(parts[:at]) for at in range(1, len(parts) + 1))


def _omits(repository: Repository, above: str, package: str, packages: Iterable[str]) -> bool:
    """Tell whether a name is a folder of the tree with code, inside a package that is installed, and is not itself."""
    folder = f"{above}{package.replace('.', '/')}"
    holds = "." in package and package.rpartition(".")[0] in packages and package not in packages
    return holds and folder in repository.folders and any(f.folder == folder for f in repository.suffixed(".py"))


def _imported(repository: Repository, above: str, modules: Iterable[str]) -> Iterator[tuple[str, str, int]]:
    """Yield what modules of the tree always import, and these in turn, with the file and line of each import."""
    pending, seen = [*modules], set[str]()
    while pending and len(seen) < _MOST:
        module = pending.pop(0)
        path = f"{above}{module.replace('.', '/')}"
        file = next((each for each in (f"{path}.py", f"{path}/__init__.py") if repository.has(each)), None)
        if module in seen or file is None:
            continue
        seen.add(module)
        package = module if file.endswith("/__init__.py") else module.rpartition(".")[0]
        for name, line in _names(repository, file, package):
            yield name, file, line
            pending += list(_above(name))


def _names(repository: Repository, file: str, package: str) -> Iterator[tuple[str, int]]:
    import ast  # noqa: PLC0415 - what needs Python's own parser is imported where a setup.py asks for it

    from roslab.evidence.python.parsed import parsed  # noqa: PLC0415 - as above

    tree = parsed(repository.read(file, limit=MAX_READ))
    for node in tree.body if tree else ():
        if isinstance(node, ast.Import):
            yield from ((alias.name, node.lineno) for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            outer = package.split(".")[: len(package.split(".")) - node.level + 1] if node.level else []
            base = ".".join([*outer, *([node.module] if node.module else [])])
            yield from ((f"{base}.{alias.name}", node.lineno) for alias in node.names if alias.name != "*")
            yield base, node.lineno
