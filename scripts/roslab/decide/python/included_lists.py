"""Lists of requirements that another one includes and that are not where it looks for them."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator

from roslab.decide.decision import Warning_
from roslab.decide.python.manifests import with_includes
from roslab.decide.reasons import warn
from roslab.evidence.facts import Evidence, RequirementFile
from roslab.values.dataclass import replace

_GONE = "{path} is included and is not in the tree: what it names is not installed, and the rest one by one"
_MISPLACED = "{path} is included and is not in the tree: {taken} is taken for it; correct the path"


def misplaced(evidence: Evidence, file: RequirementFile) -> list[Warning_]:
    """Return a warning for each list that is taken in place of one that the file, or what it includes, does not find.

    pip would refuse the file as it stands.
    """
    return [
        warn(_MISPLACED.format(path=path, taken=taken), replace(each, line=line))
        for each in with_includes(evidence, [file])
        for path, taken, line in each.misplaced
    ]


def gone(lacking: Iterable[tuple[RequirementFile, str]], cloned: Collection[str]) -> Iterator[Warning_]:
    """Yield a warning for each list that files include and that neither the tree nor what the image clones has."""
    for file, path in lacking:
        if path not in cloned:
            line = dict(zip(file.includes, file.include_lines, strict=False)).get(path, file.line)
            yield warn(_GONE.format(path=path), replace(file, line=line))
