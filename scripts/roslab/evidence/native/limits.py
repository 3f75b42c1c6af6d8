"""Signs in C++ code and in CMake files of the versions of compilers and libraries that the code compiles with."""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from functools import cache

from roslab.evidence import places
from roslab.evidence.facts import CodeLimit
from roslab.knowledge.code_limits import limits
from roslab.repository.checkout import Repository

_INCLUDE = re.compile(r"^[ \t]*#[ \t]*include[ \t]*[<\"]([\w./+-]+)[>\"]", re.MULTILINE)
_STANDARD = re.compile(
    r"^[^#\n]*?(?:\bCMAKE_CXX_STANDARD[ \t]+|-std=(?:c|gnu)\+\+|\bcxx_std_|\bCXX_STANDARD[ \t]+)(\d\w)\b", re.MULTILINE
)
_GUARD = re.compile(r"__has_include|CV_(?:MAJOR_)?VERSION|CERES_VERSION|imgproc/types_c\.h|constants_c\.h")
"""The file, or one that it includes, chooses by what is there."""


@cache
def _anywhere(where: str) -> re.Pattern[str]:
    """Return one pattern for all signs of a kind: most files have none."""
    parts = (limit.pattern.pattern.lstrip("^").rstrip("$") for limit in limits() if limit.where == where)
    begin, end = (r"#[ \t]*include[ \t]*[<\"](?:", ")") if where == "include" else ("(?:", ")")
    return re.compile(begin + "|".join(parts) + end)


@dataclass
class Signs:
    """The signs that were found so far, each at its first place."""

    found: dict[tuple[str, str], CodeLimit] = field(default_factory=dict)
    guarded: bool = False
    """A file of the tree asks for the version of a library: its names tell nothing."""

    def source(self, path: str, text: str) -> None:
        """Read a C++ file."""
        self.guarded = self.guarded or bool(_GUARD.search(text))
        if _anywhere("include").search(text):
            for found in _INCLUDE.finditer(text):
                self._note("include", found[1], path, text.count("\n", 0, found.start(1)) + 1)
        if _anywhere("name").search(text):
            for limit in (each for each in limits() if each.where == "name"):
                if (match := limit.pattern.search(text)) and not _comment(text, match.start()):
                    self._note("name", match[0], path, text.count("\n", 0, match.start()) + 1)

    def all(self, repository: Repository) -> tuple[CodeLimit, ...]:
        """Return the signs of the sources that were read and of the CMake files."""
        if self.guarded:
            self.found = {key: limit for key, limit in self.found.items() if key[0] == "GCC"}
        for file in repository.named("CMakeLists.txt"):
            if not (places.vendored(file.path) or places.test(file.path) or places.example(file.path)):
                text = repository.read(file)
                for match in _STANDARD.finditer(text):
                    self._note("standard", match[1], file.path, text.count("\n", 0, match.start(1)) + 1)
        return tuple(self.found.values())

    def _note(self, where: str, value: str, file: str, line: int) -> None:
        for sign in limits():
            if sign.where == where and sign.pattern.search(value):
                found = CodeLimit(
                    library=sign.library, at_least=sign.at_least, below=sign.below, what=sign.what, file=file, line=line
                )
                self.found.setdefault((sign.library, sign.what), found)


def _comment(text: str, position: int) -> bool:
    line = text[text.rfind("\n", 0, position) + 1 : position]
    return "//" in line or line.lstrip().startswith("*")
