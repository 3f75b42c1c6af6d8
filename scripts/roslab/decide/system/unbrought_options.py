"""Options with which an author compiles a library, and that ask for what its stage does not bring: they are dropped."""

from __future__ import annotations

from roslab.config.model import Source
from roslab.decide.decision import Warning_
from roslab.decide.reasons import warn
from roslab.decide.ros.source_names import plain
from roslab.evidence.dependency import Dependency
from roslab.knowledge.unbrought_options import Needs, needs_of_options
from roslab.values.dataclass import replace
from roslab.values.pattern import pattern

_ON = pattern(r"-D(\w+)(?::\w+)?=(?:ON|TRUE|YES|Y|1)$", 2)


def without_unbrought(source: Source, asked: Dependency) -> tuple[Source, tuple[Warning_, ...]]:
    """Return a library without such options, with a warning for each; CMake would stop at it.

    On the author's machine lay what they need, a licensed solver among it.
    """
    kept, told = [], []
    for word in source.cmake_options.split():
        needed = _needed(word, source)
        if needed is None:
            kept.append(word)
        else:
            what = f"{source.name} is built without the author's {word}, which needs {needed.what}"
            told.append(warn(f"{what}; `source` in roslab.yaml can have it", source.place or asked))
    return (replace(source, cmake_options=" ".join(kept)), tuple(told)) if told else (source, ())


def _needed(word: str, source: Source) -> Needs | None:
    """Return what an option needs and the stage does not bring, ``None`` for nothing."""
    match = _ON.match(word)
    for each in needs_of_options().get(match[1], ()) if match else ():
        of_library = not each.library or plain(each.library) == plain(source.name)
        if of_library and not (each.apt and {*each.apt} <= {*source.depends}):
            return each
    return None
