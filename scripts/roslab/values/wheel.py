"""What a wheel's file name says: https://packaging.python.org/en/latest/specifications/binary-distribution-format/."""

from __future__ import annotations

from functools import cache
from typing import TYPE_CHECKING

from roslab.values.dataclass import dataclass
from roslab.values.pattern import pattern

if TYPE_CHECKING:
    from packaging.tags import Tag

    from roslab.values.version import Standard

_CPYTHON = pattern(r"cp(\d)(\d{1,2})")


@dataclass(frozen=True, slots=True)
class Wheel:
    """The parts of a wheel's file name."""

    name: str
    version: Standard
    tags: frozenset[Tag]

    @property
    def python(self) -> str | None:
        """The only CPython that it is built for: ``3.8`` of ``cp38``."""
        found = {match[1] + "." + match[2] for tag in self.tags if (match := _CPYTHON.fullmatch(tag.interpreter))}
        return min(found) if len(found) == 1 else None

    @property
    def amd64_only(self) -> bool:
        """Whether it is built for Linux on amd64 alone."""
        return all(tag.platform.startswith(("linux", "manylinux")) and "x86_64" in tag.platform for tag in self.tags)


@cache
def wheel_of(url: str) -> Wheel | None:
    """Return the wheel that a URL names; ``None`` if its end is no wheel's file name."""
    ending = url.partition("#")[0].partition("?")[0].rpartition("/")[2]
    if not ending.endswith(".whl"):
        return None
    from urllib.parse import unquote  # noqa: PLC0415 - few addresses end so

    from packaging.utils import InvalidWheelFilename, parse_wheel_filename  # noqa: PLC0415

    try:
        name, version, _, tags = parse_wheel_filename(unquote(ending))
    except InvalidWheelFilename:
        return None
    return Wheel(name, version, tags)
