"""What only writes documentation, which no program needs.

Where CMake finds it, ``make all`` may write the documentation, and stop where more is missing: LaTeX, fonts.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from roslab.evidence.dependency import Dependency
from roslab.knowledge.documentation import documenting

Need = tuple[Dependency, bool]


def without_documentation(needs: Iterable[Need]) -> Iterator[Need]:
    """Yield the needs without those that CMake looks for and does not require.

    Nor those of CI, which may publish what it writes. What a page installs by name is kept.
    """
    needs = tuple(needs)
    found = [each for each, _ in needs if each.namespace == "cmake" and _module(each) in documenting()]
    required = {_module(each) for each in found if each.strength == "declared"}
    optional = {_module(each) for each in found} - required
    packages = {documenting()[name] for name in optional} - {""}
    for each, trusted in needs:
        if each.namespace == "cmake" and _module(each) in optional:
            continue
        if each.namespace != "apt" or each.name not in packages or not each.file.startswith("."):
            yield each, trusted


def _module(dependency: Dependency) -> str:
    return dependency.name.partition(" ")[0]
