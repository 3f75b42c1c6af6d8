"""Packages whose code includes a header that the tree would have, and does not: they do not compile."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from roslab.decide.decision import Warning_
from roslab.decide.programs import owner
from roslab.decide.reasons import warn
from roslab.decide.ros.workspace import Packages
from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import Evidence
from roslab.evidence.native.nowhere import LIBRARY


def nowhere(evidence: Evidence, packages: Packages, known: Callable[[str], bool]) -> dict[str, list[Dependency]]:
    """Return the built packages that include such headers, with these.

    A path that leads into the folder of something ``known``, as of what is cloned beside the tree, may be there.
    """
    folders = {m.file.rpartition("/")[0]: m.name for m in packages.built if m.name}
    found: dict[str, list[Dependency]] = {}
    for each in evidence.code:
        if (
            each.namespace != "nowhere"
            or each.role == LIBRARY
            or (each.name.startswith("..") and known(_folder(each.name)))
        ):
            continue
        if package := owner(each.file, folders):
            found.setdefault(package, []).append(each)
    return found


def without_own(
    evidence: Evidence, packages: Packages, known: Callable[[str], bool], build_tool: str
) -> Iterator[Warning_]:
    """Yield a warning for each of them."""
    for package, headers in nowhere(evidence, packages, known).items():
        names = ", ".join(dict.fromkeys(each.name for each in headers))
        what = f"{package} includes {names}, which nothing in the repository is or makes"
        yield warn(f"{what}: {build_tool} will most likely stop there; add it", headers[0])


def _folder(path: str) -> str:
    """Return the first folder of a path that it leads into."""
    return next((part for part in path.split("/") if part != ".."), "")
