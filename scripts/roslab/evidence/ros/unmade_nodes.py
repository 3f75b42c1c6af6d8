"""Nodes of a package of the tree that a launch file starts, and that the build of the package does not install."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping

from roslab.evidence.launch_file import LaunchFile
from roslab.repository.checkout import Repository
from roslab.values.dataclass import replace
from roslab.values.pattern import pattern

_BUILD_FILES = ("CMakeLists.txt", "setup.py", "setup.cfg")
_ANY = pattern(
    r"\bGLOB(?:_RECURSE)?\b|\bglob\s?\(|\bfind_packages\s?\(.*\bscripts\b|\bforeach\b|"
    r"\bDIRECTORY\b[^()]{0,400}?\bDESTINATION\s+[\"']?(?:\$\{\w+\}/)?lib|"
    r"\bDIRECTORY\b[^()]{0,400}?\bDESTINATION\s+[\"']?\$\{CMAKE_INSTALL_(?:LIB|BIN)DIR\}|"
    r"\b(?:listdir|iterdir|scandir)\s?\(|\badd_executable\s?\(\s*[\w-]*\$\{(?!PROJECT_NAME\})|"
    r"\b(?:PROGRAMS|add_executable\s?\(|TARGETS|EXECUTABLE)\s+[\"']?\$\{(?!PROJECT_NAME\})\w+\}",
    re.IGNORECASE,
)
"""What installs programs that it does not name."""
COMMENT = pattern(r"(?:^|(?<=\s))#[^\n]*")
RENAMES = pattern(r"\b(?:RENAME|configure_file|create_symlink)\b", re.IGNORECASE)
_NAMED = pattern(r"[\w-]+\.py\b|(?<=add_executable\()\s*[\w-]+|[\w-]+(?=\s*=\s*[\w.]+:\w+)")


def with_unmade(
    launches: Iterable[LaunchFile], repository: Repository, packages: Mapping[str, str]
) -> tuple[LaunchFile, ...]:
    """Return the launch files of ROS 2 with those of their nodes, each with the name that is most like it, or ``""``.

    ``packages`` are the names of the packages by their folders. ROS 1 starts what lies in the source, too.
    """
    folders = {name: folder for folder, name in packages.items()}
    texts: dict[str, str] = {}
    found = []
    for launch in launches:
        own = [(package, program) for package, program in launch.nodes if launch.ros == 2 and package in folders]
        for package, _ in own:
            if package not in texts:
                texts[package] = "\n".join(_texts(folders[package], repository))
        unmade = tuple(
            (package, program, _nearest(program, _NAMED.findall(texts[package])))
            for package, program in own
            if _unmade(program, package, texts[package])
        )
        found.append(replace(launch, unmade=unmade) if unmade else launch)
    return tuple(found)


def _nearest(program: str, names: Iterable[str]) -> str:
    from difflib import get_close_matches  # noqa: PLC0415 - for a program that nothing installs

    return next(iter(get_close_matches(program, [*names], n=1)), "")


def _texts(folder: str, repository: Repository) -> Iterator[str]:
    """Yield the texts of the files that build a package, those of its folders included."""
    inside = f"{folder}/" if folder else ""
    files = (*repository.named(*_BUILD_FILES), *repository.suffixed(".cmake"))
    yield from (COMMENT.sub("", repository.read(file)) for file in files if file.path.startswith(inside))


def _unmade(program: str, package: str, text: str) -> bool:
    """Tell whether nothing there names a program, nor may make it by another name than its own.

    One without an ending is not named by ``install(PROGRAMS scripts/talker.py)``, which keeps the file's name.
    """
    stem = program.rpartition(".")[0] or program
    by_package = stem.startswith(package) and ("PROJECT_NAME}" in text or "package_name" in text)
    whole = r"(?!\.py\b)" if stem == program and not RENAMES.search(text) else ""
    named = re.search(rf"(?<![\w-]){re.escape(stem)}(?![\w-]){whole}", text)
    return bool(text) and not named and not by_package and not _ANY.search(text)
