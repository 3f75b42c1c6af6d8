"""Where the headers of messages are included: a header of the tree that nothing includes is compiled by nobody."""

from __future__ import annotations

from collections.abc import Mapping

from roslab.evidence.dependency import Dependency
from roslab.evidence.native.generated import package_of
from roslab.evidence.native.limits import HEADERS
from roslab.repository.checkout import Repository
from roslab.values.dataclass import dataclass, field, replace

_FURTHER = (".hxx", ".tpp", ".ipp", ".inl", ".txx", ".tcc", ".ui")
"""Files that may include a header, too, and are not searched for what they include."""


@dataclass
class MessageHeaders:
    """The places of each header, until a source, which is no header itself, includes it under no condition."""

    places: dict[str, list[Dependency]] = field(default_factory=dict)
    certain: set[str] = field(default_factory=set)

    def add(self, key: str, place: Dependency) -> None:
        """Note a place where a header is included, if that is of a message."""
        if not package_of(place.name):
            return
        self.places.setdefault(key, []).append(place)
        if place.strength != "optional" and not place.file.endswith(HEADERS):
            self.certain.add(key)

    def settle(self, found: dict[str, Dependency], names: Mapping[str, bool] | None, repository: Repository) -> None:
        """Give each header its first place that may be compiled, preferably under no condition, else an optional one.

        ``names``: what any file includes, as it is written, and whether the tree has it; ``None`` where not all files
        were read.
        """
        last: dict[str, list[str]] = {}
        for name in names or () if self.places else ():
            last.setdefault(name.rpartition("/")[2], []).append(name)
        for key, places in self.places.items():
            compiled = [each for each in places if names is None or _compiled(each.file, last, names, repository)]
            always = [each for each in compiled if each.strength != "optional"]
            found[key] = (always or compiled or [replace(places[0], strength="optional")])[0]


def _compiled(file: str, last: Mapping[str, list[str]], names: Mapping[str, bool], repository: Repository) -> bool:
    """Tell whether a file may be compiled: a source, or a header that one includes or that a build file names."""
    base = file.rpartition("/")[2]
    if not base.endswith(HEADERS):
        return True
    for name in last.get(base, ()):
        if not names[name] or name.startswith(".") or f"/{file}".endswith(f"/{name}"):
            return True
    others = (*repository.suffixed(*_FURTHER), *repository.named("CMakeLists.txt"))
    return any(base in repository.read(other) for other in others)
