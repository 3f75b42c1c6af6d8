"""Files of build tools that no step of the image calls, at a repository's root, and folders that only they build."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.evidence import places
from roslab.evidence.facts import Mention
from roslab.knowledge.other_builders import OtherBuilder, other_builders
from roslab.repository.checkout import Repository, nearest
from roslab.values.pattern import pattern

_OF_WINDOWS = (".sln", ".vcxproj", ".vcproj")
_OF_OTHERS = ("CMakeLists.txt", "package.xml", "manifest.xml", "setup.py", "pyproject.toml", "requirements.txt")


def read(repository: Repository) -> Iterator[Mention]:
    """Yield one mention for each tool."""
    told = set[str]()
    for each in other_builders():
        if each.builder not in told and repository.has(each.file) and _meant(repository, each, each.file):
            told.add(each.builder)
            yield Mention(
                topic="other_builder", value=each.builder, source="filename", file=each.file, line=1, text=each.file
            )


def of_windows(repository: Repository) -> Iterator[Mention]:
    """Yield a mention of the project of Visual Studio, of several the one nearest to the root, if none is another's.

    https://learn.microsoft.com/en-us/cpp/build/reference/vcxproj-file-structure, read 2026-11-29.
    """
    if not repository.named(*_OF_OTHERS):
        own = (file for file in repository.suffixed(*_OF_WINDOWS) if not places.vendored(file.path))
        for file in nearest(own)[:1]:
            path = file.path
            yield Mention(topic="of_windows", value=path, source="filename", file=path, line=1, text=file.name)


def without(repository: Repository) -> Repository:
    """Return the repository without the folders whose CMake includes what only such a tool makes.

    Flutter's ``linux`` includes ``flutter/ephemeral/generated_config.cmake``, which ``flutter build`` writes.
    """
    folders = tuple(
        f"{file.folder}/{folder}/".lstrip("/")
        for each in other_builders()
        if each.makes_cmake_in
        for file in repository.named(each.file)
        if _meant(repository, each, file.path)
        for folder in each.makes_cmake_in
    )
    if not folders:
        return repository
    return repository.leaving_out({file.path for file in repository.files if file.path.startswith(folders)})


def _meant(repository: Repository, each: OtherBuilder, path: str) -> bool:
    return not each.contains or bool(pattern(each.contains).search(repository.read(path)))
