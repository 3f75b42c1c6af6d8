"""Whether build files or the code of a tree name a folder of their user's home, or read a variable of the shell."""

from __future__ import annotations

import re

from roslab.evidence import places
from roslab.repository.checkout import File, Repository, nearest
from roslab.values.dataclass import dataclass

MAX_SIZE = 256 * 1024
MAX_FILES = 400
_BUILD = ("CMakeLists.txt", "Makefile", "setup.py")
_CODE = (
    ".cmake",
    ".mk",
    ".pri",
    ".pro",
    ".cpp",
    ".cc",
    ".cxx",
    ".c",
    ".hpp",
    ".h",
    ".py",
    ".launch",
    ".xacro",
    ".yaml",
)
_HOME = (
    r"(?:~|\$\{?HOME\}?|\$ENV\{HOME\}|\$\(HOME\)|\$\(env HOME\)|\bhome\(\)|/home/[\w.-]+|/root|"
    r"\b(?:getenv|environ|getEnv)\b[^\n]{0,8}[\"']HOME[\"'])"
)
_THEN = r"[\s\"')\]+,]{0,12}/?[\s\"']{0,4}"
"""Between the home and the folder: ``~/x``, ``os.path.join(home, "x")``, ``Path.home() / "x"``, ``home + "/x"``."""
_READS = (
    r"\$ENV\{%s\}|\$\((?:opt)?env\s+%s\b|\$\(%s\)|\$\{%s\}|\b(?:environ|getenv)\b[^\n]{0,8}['\"]%s['\"]|"
    r"EnvironmentVariable\(\s*(?:name\s*=\s*)?['\"]%s['\"]"
)


@dataclass(frozen=True, kw_only=True, slots=True)
class Named:
    """A folder below the home; ``begins``: its name may go on, as one with a release does."""

    folder: str
    begins: bool = False


class Readers:
    """The files of a tree that may look for a folder or read a variable, build files first; vendored code is not."""

    def __init__(self, repository: Repository) -> None:
        """Remember the checkout; its files are read when they are asked for."""
        self._repository = repository
        self._texts: list[tuple[str, str]] | None = None

    def naming(self, *named: Named) -> str:
        """Return the first file that names one of these folders below the home, ``""`` for none."""
        words = [re.escape(each.folder) + (r"[\w.+-]*" if each.begins else "") for each in named]
        found = re.compile(rf"{_HOME}{_THEN}(?:{'|'.join(words)})(?![\w.-]*[\w-])")
        first = [each.folder.partition("/")[0] for each in named]
        return next((p for p, text in self._all() if any(name in text for name in first) and found.search(text)), "")

    def reading(self, name: str) -> str:
        """Return the first file that reads a variable, ``""`` for none."""
        found = re.compile(_READS.replace("%s", re.escape(name)))
        return next((path for path, text in self._all() if name in text and found.search(text)), "")

    def _all(self) -> list[tuple[str, str]]:
        if self._texts is None:
            tree = self._repository
            build = [file for name in _BUILD for file in tree.named(name)]
            code = [*tree.suffixed(*_CODE)]
            both = (*self._own(build), *self._own(code))
            self._texts = [(file.path, tree.read(file)) for file in dict.fromkeys(both)]
        return self._texts

    @staticmethod
    def _own(files: list[File]) -> list[File]:
        own = [f for f in files if not places.vendored(f.path) and f.size < MAX_SIZE]
        return nearest(own)[:MAX_FILES]
