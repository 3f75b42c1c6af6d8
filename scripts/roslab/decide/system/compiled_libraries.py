"""What the builds of libraries look for that CMake compiles with the project: submodules, copies, what it fetches."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.evidence import places
from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import Evidence
from roslab.knowledge.compiled_libraries import compiled_libraries


def needs_of_libraries(evidence: Evidence) -> Iterator[Dependency]:
    """Yield the packages that such a library needs, which is known by the name of its repository or folder.

    Without them some go on, and then open no window. A submodule need not be checked out.
    """
    known = compiled_libraries()
    urls = {git.name: git.url for git in evidence.sources if git.kind == "submodule"}
    for project in evidence.cmake:
        if places.aside(project.file):
            continue
        for folder in project.adds:
            module = next((name for name in urls if f"/{folder}/".endswith(f"/{name}/")), None)
            copied = module is not None or places.vendored(f"{folder}/")
            for apt in known.get(_name(urls[module] if module else folder), ()) if copied else ():
                yield _asked(apt, project.file, project.line)
        for git in project.sources:
            parts = (part for part in git.url.lower().split("/")[3:])
            for apt in next((known[name] for name in map(_name, parts) if name in known), ()):
                yield _asked(apt, git.file, git.line)


def _name(path: str) -> str:
    return path.rstrip("/").rpartition("/")[2].lower().removesuffix(".git")


def _asked(apt: str, file: str, line: int) -> Dependency:
    return Dependency(namespace="apt", name=apt, strength="used", file=file, line=line, role="compiled")
