"""The program that makes something of data where pages run no other: then making it is the use of a repository."""

from __future__ import annotations

import re
from collections.abc import Sequence

from roslab.decide.candidate import Candidate, is_python, program_of
from roslab.decide.reasons import of_readme
from roslab.decide.sections import about_running
from roslab.decide.upkeep import upkeep
from roslab.values.pattern import pattern

_MAKES = pattern(
    r"(?:^|[_.-])(?:extract\w*|convert\w*|conver[st]ion|export\w*|annotat\w*|generat(?:e|ing|ion|or)|record\w*|collect\w*)"
    r"(?:[_.-]|$)|[a-z]2[a-z]|[a-z\d]_(?:to|2)_[a-z]",
    re.IGNORECASE,
)
"""The name of a program that makes something: ``extract_bagfile``, ``bag2csv``; no download, and no set-up."""
_NETWORK = pattern(
    r"(?:^|[_.-]|2)(?:onnx|trt|tensorrt|engine|tflite|torchscript|weights?|models?)(?:[_.-]|$)", re.IGNORECASE
)
"""What another program runs."""


def only_making(candidates: Sequence[Candidate]) -> Candidate | None:
    """Return the first program of Python that the README runs whole in a section about use, where all pages run such.

    By its name it would serve another program, and there is none.
    """
    written = [c for c in candidates if c.strong and not upkeep(c)]
    if not written or not all(is_python(c) and _makes(_name(c)) for c in written):
        return None
    said = (c for c in written if "/" not in c.file and of_readme(c.file) and about_running(c.heading) > 0)
    return next((c for c in said if not (c.cut or c.absent or c.elsewhere or c.inside)), None)


def _makes(name: str) -> bool:
    return bool(_MAKES.search(name)) and not _NETWORK.search(name)


def _name(candidate: Candidate) -> str:
    return program_of(candidate.argv)[-1].rpartition("/")[2].removesuffix(".py")
