"""What libraries look for that are compiled here: submodules, copies, what CMake fetches and what a page has."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.decide.ros.source_names import address
from roslab.evidence import places
from roslab.evidence.dependency import Dependency, GitSource
from roslab.evidence.facts import Evidence
from roslab.knowledge.compiled_libraries import compiled_libraries, required_by
from roslab.knowledge.recipes import recipe_at


def needs_of_libraries(evidence: Evidence) -> Iterator[Dependency]:
    """Yield the packages that such a library needs, which is known by the name of its repository or folder.

    Without them some go on, and then open no window. A submodule need not be checked out. What a page compiles by hand
    looks for some of them again when it runs; a library of the recipes has its own. Of what CMake fetches itself, its
    own CMake may require a library, which stops the whole.
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
            yield from (_asked(apt, git.file, git.line) for apt in looked_for(git))
            yield from (_required(name, git) for name in required_by().get(_name(git.url), ()))
    for git in evidence.sources:
        if git.kind == "clone" and git.installed and not (git.aside or places.aside(git.file)):
            yield from (_asked(apt, git.file, git.line) for apt in looked_for(git) if not recipe_at(address(git.url)))


def looked_for(git: GitSource) -> tuple[str, ...]:
    """Return what the build of a repository looks for, which is known by its name or its owner's."""
    known = compiled_libraries()
    parts = git.url.lower().split("/")[3:]
    return next((known[name] for name in map(_name, parts) if name in known), ())


def _name(path: str) -> str:
    return path.rstrip("/").rpartition("/")[2].lower().removesuffix(".git")


def _asked(apt: str, file: str, line: int) -> Dependency:
    return Dependency(namespace="apt", name=apt, strength="used", file=file, line=line, role="compiled")


def _required(name: str, git: GitSource) -> Dependency:
    return Dependency(
        namespace="cmake", name=name, strength="declared", file=git.file, line=git.line, role="compiled", required=True
    )
