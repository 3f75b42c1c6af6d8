"""The examples in the folder that a page names where it starts nothing: its first one is what a reader would try."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator

from roslab.config.model import Kind
from roslab.decide.candidate import Candidate
from roslab.decide.first_command import serves
from roslab.decide.notebook_server import server
from roslab.decide.reasons import page_of
from roslab.evidence.facts import Evidence
from roslab.values.dataclass import replace
from roslab.values.pattern import pattern

_NOTEBOOK = ".ipynb"
_TEST = pattern(r"(?:^|[/_-])(?:tests?|testing)(?:[_.-])", re.IGNORECASE)


def in_shown_folder(evidence: Evidence, kind: Kind) -> Iterator[Candidate]:
    """Yield these, which are offered behind all others; beside nodes only programs of Python, beside C++ none."""
    plain = kind in {"python", "cuda"}
    for said in evidence.mentions:
        if said.topic != "shown" or kind == "cpp" or not (plain or said.value.endswith(".py")):
            continue
        folder = said.value.rpartition("/")[0]
        start = server(evidence) if said.value.endswith(_NOTEBOOK) else ("python3",)
        yield Candidate(
            argv=(*start, said.value),
            why=f"an example of {folder}/, which {page_of(said.file)} names",
            file=said.file,
            line=said.line,
            strong=False,
            cut=True,
            heading=said.heading,
            files=(said.value,),
            inside=said.inside,
        )


def first_shown(candidates: Iterable[Candidate], evidence: Evidence) -> Candidate | None:
    """Return the first of them that needs neither arguments nor data, serves no other, and is no test."""
    whole = {file for said in evidence.mentions if said.topic == "shown" for file in said.files}
    found = (each for each in candidates if each.files and whole.issuperset(each.files) and not each.strong)
    first = next((each for each in found if not (serves(each) or _TEST.search(each.files[0]))), None)
    return replace(first, why=f"{first.why}, and the first without arguments and data") if first else None
