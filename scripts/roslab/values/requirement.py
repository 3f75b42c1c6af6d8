"""What pip is asked for, as one value: later code uses the fields and parses no line again."""

from __future__ import annotations

from typing import TYPE_CHECKING, Literal

from roslab.values.dataclass import dataclass, replace
from roslab.values.name import canonicalize_name
from roslab.values.specifier import Allowed, Specifiers
from roslab.values.version import Version, version_of

if TYPE_CHECKING:
    from packaging.markers import Marker

    from roslab.values.wheel import Wheel

RequirementOrigin = Literal["manifest", "conda", "prose", "import", "build", "configuration", "table", "lock"]
"""Who asks: a file made for pip, a conda environment, an install line for humans or for another machine, the code, the
build, roslab.yaml, a table of the program's own, or a lock."""
Role = Literal[
    "environment",
    "channel",
    "",
    "editable",
    "repaired",
    "member",
    "source",
    "extra",
    "test",
    "python2",
    "conda",
    "project",
    "file",
    "option",
    "listed",
    "bounded",
]
"""``""``: to be installed as it stands; ``editable``: from a URL, with ``-e``; ``repaired``: pip would refuse the way
its author spells it; ``member``, ``source``: uv has it in the same tree, or from elsewhere than the index; ``extra``,
``test``: only for those who ask for more; ``python2``: by Python 2's pip; ``conda``: by ``conda install``, or among
conda's own packages. ``project``, ``file``, ``environment`` and ``option`` name no package: a path to install, a
requirements file, a conda environment's file, an option of pip's. ``listed``: a page names it, and no command
installs it; ``bounded``: a sentence of it limits the version of what something else asks for."""
_NO_PACKAGE = frozenset({"project", "file", "option", "environment", "channel"})
_EXACT = frozenset({"==", "===", "~="})
_UPPER = frozenset({"<", "<="})


FREE = Specifiers()
"""What every version fulfils."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Requirement:
    """One thing that pip is asked for, with the place that asks."""

    name: str
    """As it is spelled; for a bare URL, what its end suggests; ``""`` if unknown."""
    written: str
    """As pip is given it, without its marker: ``PyYAML>=5``, ``name @ URL``, a bare URL, a path, an option."""
    specifier: Allowed = FREE
    """Empty if it is not pinned, or if the version follows no standard (then only ``written`` has it)."""
    extras: tuple[str, ...] = ()
    url: str = ""
    marker: Marker | None = None
    origin: RequirementOrigin
    role: Role = ""
    group: str = ""
    """The name of the extra, if the role is ``extra``; of a ``project``, its manager, where it is not pip."""
    file: str = ""
    line: int = 1
    beside: bool = False
    """Whether it is to be built beside what is installed: ``--no-build-isolation``."""
    editable: bool = False
    """Whether a page installs its folder so that the files there are used: ``-e``, or ``develop`` of setuptools."""

    @property
    def key(self) -> str:
        """Normalised name. https://peps.python.org/pep-0503/#normalized-names."""
        return canonicalize_name(self.name)

    @property
    def text(self) -> str:
        """The whole line as it is passed to pip, with its marker."""
        return f"{self.written}; {self.marker}" if self.marker else self.written

    @property
    def told(self) -> str:
        """The line for a report: without its marker, and with the name that a bare ``git+URL`` lacks."""
        return f"{self.key} @ {self.url}" if self.vcs and self.written == self.url and self.name else self.written

    @property
    def package(self) -> bool:
        """Whether it is a package rather than a path, a file or an option."""
        return self.role not in _NO_PACKAGE

    @property
    def vcs(self) -> bool:
        """Whether pip fetches it with git or the like."""
        return "+" in self.url.partition("://")[0]

    @property
    def wheel(self) -> Wheel | None:
        """The wheel that its URL names."""
        if not self.url:
            return None
        from roslab.values.wheel import wheel_of  # noqa: PLC0415 - most have no URL

        return wheel_of(self.url)

    @property
    def release(self) -> str | None:
        """The release that it is pinned to, with its local part (``1.13.1+cu117``); ``None`` if it is not pinned."""
        if found := self.wheel:
            return str(found.version)
        exact = (each.version.rstrip(".*").lstrip("v") for each in self.specifier if each.operator in _EXACT)
        return next((text for text in exact if version_of(text)), None)

    @property
    def below(self) -> str | None:
        """The lowest upper bound of its specifiers."""
        uppers = [each.version for each in self.specifier if each.operator in _UPPER and version_of(each.version)]
        return min(uppers, key=Version, default=None)

    @property
    def at_least(self) -> str | None:
        """The highest of its ``>=``."""
        lowers = [each.version for each in self.specifier if each.operator == ">=" and version_of(each.version)]
        return max(lowers, key=Version, default=None)

    def only_if(self, condition: str) -> Requirement:
        """Return it with an additional marker; one that pip cannot read is ignored."""
        if not condition.strip():
            return self
        from roslab.values.standard_requirement import InvalidMarker, Marker  # noqa: PLC0415 - slow to import

        try:
            more: Marker | None = Marker(condition)
        except InvalidMarker:
            more = None
        if more and self.marker:
            more = Marker(f"({self.marker}) and ({more})")
        return replace(self, marker=more or self.marker)

    def fetched_from(self, url: str) -> Requirement:
        """Return it with the URL that uv fetches it from."""
        return replace(self, written=f"{self.key} @ {url}", url=url, specifier=FREE, role="source")

    @property
    def limited(self) -> bool:
        """Whether it excludes the newest version or names where it comes from."""
        return bool(self.url) or any(each.operator in _EXACT | _UPPER for each in self.specifier)
