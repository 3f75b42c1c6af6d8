"""Which conda environment of the tree is made."""

from __future__ import annotations

import re
from collections.abc import Sequence

from roslab.config.model import Config, Kind
from roslab.decide.python.manifests import VARIANT, for_reference, resolve
from roslab.decide.python.parts import of_parts
from roslab.evidence import places
from roslab.evidence.conda_environment import CondaEnvironment
from roslab.evidence.facts import Evidence
from roslab.knowledge.tools import PIXI
from roslab.values.pattern import pattern
from roslab.values.requirement import Requirement

_PAGE = pattern(r"^(?:docs?/|\.github/)?(?:readme|install(?:ation)?)\b[^/]*$", re.IGNORECASE)
"""The pages whose lines tell how the project is installed."""
OF_OTHER_SYSTEM = pattern(
    r"(?:^|[-_./])(?:mac|macos|osx|darwin|windows|win(?:32|64)?|m1|arm)(?:[-_.]|$)", re.IGNORECASE
)
"""An environment of another system."""
_LIST = ".txt"
"""How a list of conda's packages ends, which is no environment unless a page or the list itself says so."""


def conda_file(evidence: Evidence, config: Config, kind: Kind) -> str | None:
    """Return the project's environment file: the plainest name, nearest to the root.

    A requirements.txt or an installable project with requirements beside it is preferred: more people can use it. One
    in a folder is left where the page at the root installs by pip.
    """
    if config.conda:
        return config.conda
    if kind in {"ros1", "ros2", "cpp"}:
        return None
    aside = for_reference(evidence) | of_parts(evidence)
    known = [each for each in evidence.conda if not places.vendored(each.file) and each.file not in aside]
    said = _first_of_readme(evidence, known)
    if said and (named := _environment(said, known)):
        return named
    own = [each for each in known if each.file.count("/") <= 1 and (each.exported or not each.file.endswith(_LIST))]
    if not own:
        return None
    from roslab.evidence.python.conda import usually_named  # noqa: PLC0415 - few trees have one

    best = min(
        own,
        key=lambda e: (
            bool(e.specs),
            e.exported,
            bool(OF_OTHER_SYSTEM.search(e.file)),
            not usually_named(e.file) and not e.file.endswith(_LIST),
            e.file.count("/"),
            bool(VARIANT.search(e.file.rpartition(".")[0])),
            len(e.file),
            e.file,
        ),
    )
    folder = best.file.rpartition("/")[0]
    by_pip = folder and said and said.role != "environment" and "/" not in said.file and not resolve(said, [best.file])
    beside = any(
        file.purpose == "run"
        and file.file != best.file
        and file.file.rpartition("/")[0] in {"", folder}
        and not VARIANT.search(file.file.rpartition(".")[0])
        for file in evidence.requirements
    )
    declared = any(
        p.installable and not p.folder and any(not asked.role for asked in p.requirements) for p in evidence.python
    )
    return None if by_pip or beside or declared else best.file


def _first_of_readme(evidence: Evidence, known: Sequence[CondaEnvironment]) -> Requirement | None:
    """Return what the README installs first: an environment that it creates, a project or a file of requirements."""
    first: dict[str, Requirement] = {}
    files = [each.file for each in known]
    for asked in evidence.prose_pip:
        if asked.role in {"environment", "file", "project"} and _PAGE.search(asked.file):
            if asked.role == "environment" and not _creates(evidence, asked, files):
                continue
            known_one = first.setdefault(asked.file, asked)
            if asked.line < known_one.line:
                first[asked.file] = asked
    return next((first[page] for page in sorted(first, key=lambda page: (page.count("/"), page))), None)


def _environment(said: Requirement, known: Sequence[CondaEnvironment]) -> str | None:
    """Return the file of the environment that a page creates, if it does."""
    if said.role != "environment":
        return None
    if said.written == PIXI:  # or pyproject.toml
        return next((each.file for each in known if each.specs), None)
    return resolve(said, [each.file for each in known])


def _creates(evidence: Evidence, asked: Requirement, files: Sequence[str]) -> bool:
    """Tell whether a file that a page gives conda counts: it is there, and not for another system."""
    listed = {each.file for each in evidence.requirements}  # conda reads a list of pip's as well
    there = asked.written == PIXI or resolve(asked, files) or resolve(asked, listed)
    return bool(there) and not OF_OTHER_SYSTEM.search(asked.written)
