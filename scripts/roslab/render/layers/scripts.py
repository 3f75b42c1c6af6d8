"""The scripts and keys that a Dockerfile carries, so that what is the same in every image does not hide what is not.

They stand in a stage of their own, and each is copied where it is first used. BuildKit compares what is copied by
content: a changed script repeats the steps from its first use on and nothing before, wherever it stands in the file.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from functools import cache
from pathlib import Path

from roslab.knowledge.build_limits import build_limits
from roslab.knowledge.build_programs import build_programs
from roslab.knowledge.compiled import public_hosts
from roslab.knowledge.frameworks import same_numbers
from roslab.knowledge.keys import key
from roslab.knowledge.libraries import cmake_packages
from roslab.knowledge.library_names import library_names
from roslab.knowledge.os_releases import archives
from roslab.knowledge.shared_objects import table as shared_objects
from roslab.render.layers import shell
from roslab.values.pattern import pattern

_FOLDER = Path(__file__).parent.parent / "image_scripts"
_COPY = pattern(r"^COPY --from=scripts (/.+) /usr/local/(?:bin|share/roslab)/$", re.MULTILINE)
"""What ``shell.copy_script`` and ``shell.copy_data`` write."""
_TABLES: dict[str, Callable[[], str]] = {
    "archives.txt": archives,
    "build-limits.txt": build_limits,
    "build-programs.txt": build_programs,
    "git-hosts.txt": lambda: "\n".join(sorted(public_hosts())),
    "released-together.txt": same_numbers,
    "shared-objects.txt": shared_objects,
}
"""Tables of the program's knowledge that scripts read."""
_OF_UBUNTU = pattern(r"(cmake|libraries)-(\w+)\.txt")
"""What libraries are called on an Ubuntu: a part of a table."""
_WHY = "# What is the same in every image, as small scripts; what belongs to this repository begins below them."


def stage(image: str) -> str:
    """Return the stage that holds the scripts and keys that the other stages copy; ``""`` where they copy none."""
    names = dict.fromkeys(name.removeprefix("/") for files in _COPY.findall(image) for name in files.split())
    parts = (shell.heredoc(f"/{name}", _text(name), executable="." not in name) for name in names)
    return "\n".join((_WHY, "FROM scratch AS scripts", *parts)).rstrip("\n") if names else ""


@cache
def _text(name: str) -> str:
    if name.endswith(".asc"):
        return key(name.removesuffix(".asc"))
    if found := _OF_UBUNTU.fullmatch(name):
        return (cmake_packages if found[1] == "cmake" else library_names)(found[2])
    if name in _TABLES:
        return _TABLES[name]()
    return (_FOLDER / f"{name}.sh").read_text(encoding="utf-8")
