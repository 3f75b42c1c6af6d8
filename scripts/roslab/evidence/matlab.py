"""Files of MATLAB, whose ending Objective-C has, too."""

from __future__ import annotations

import re
from collections.abc import Iterator

from roslab.evidence.facts import Mention
from roslab.repository.checkout import Repository, nearest
from roslab.values.pattern import pattern

READ = 50
"""Most files of that ending that are opened."""
PAGES, MAX_PAGE = 5, 128 * 1024
_NAME = pattern(r"\b(?:MATLAB|Simulink)\b", re.IGNORECASE)
_CODE = (".py", ".c", ".cc", ".cpp", ".cxx", ".cu", ".h", ".hpp", ".ipynb")
_APPLE = pattern(
    r"^[ \t]*(?:@(?:interface|implementation|import|protocol)\b|#[ \t]*(?:import|include)\b)", re.MULTILINE
)

_LOADS = pattern(
    r"(?:^|[;,])[ \t]{0,99}pkg(?:[ \t]{1,9}|[ \t]{0,9}\([ \t]{0,9})['\"]?load['\"]?([ \t,][^;)%#\n]{1,300})",
    re.MULTILINE,
)
_WORD = pattern(r"(?<![\w-])[A-Za-z][\w-]*")

_COMMENT = pattern(r"%[^\n]*")
_CALLED = pattern(r"(?<![\w.])([A-Za-z]\w{2,40})[ \t]*[(;]")
_NAME_VALUE = pattern(r"^[^%\n]{0,200}?\w\([^()%'\"\n]{1,200},[ \t]*[A-Z]\w{1,40}[ \t]*=(?!=)", re.MULTILINE)
"""``imwarp(image, form, OutputView=view)``"""


def files(repository: Repository) -> int:
    """Return the number of a tree's files of MATLAB, 0 where one of that ending is Objective-C."""
    found = nearest([file for file in repository.suffixed(".m") if file.size])
    apple = any(_APPLE.search(repository.read(file)) for file in found[:READ])
    return 0 if apple else len(found)


def mentions(repository: Repository) -> Iterator[Mention]:
    """Yield the number of the files, where they outnumber the other code and a page or a model says that they are its.

    Models of Simulink are MATLAB's alone.
    """
    models = repository.suffixed(".slx", ".mdl")
    others = repository.suffixed(*_CODE)
    if len(repository.suffixed(".m")) + len(models) <= len(others) or not (number := files(repository)):
        return
    pages = nearest([file for file in repository.suffixed(".md", ".rst", ".txt") if file.size <= MAX_PAGE])[:PAGES]
    for page in pages:
        if said := _NAME.search(text := repository.read(page)):
            line = text.count("\n", 0, said.start()) + 1
            yield Mention(topic="matlab", value=str(number), source="readme", file=page.path, line=line, text=said[0])
            return
    for model in models[:1]:
        text = f"{len(models)} models of Simulink"
        yield Mention(topic="matlab", value=str(number), source="filename", file=model.path, line=1, text=text)


def loaded(repository: Repository) -> tuple[str, ...]:
    """Return the packages of Octave that the files nearest to the root load: ``pkg load image signal``.

    A word that is no package, as ``load`` of a second call on the line, is in no table of them.
    """
    found = nearest([file for file in repository.suffixed(".m") if file.size])[:READ]
    said = (words for file in found for words in _LOADS.findall(repository.read(file)))
    return tuple(dict.fromkeys(name.lower() for words in said for name in _WORD.findall(words)))


def for_octave(repository: Repository) -> bool:
    """Tell whether Octave may run a tree's files.

    It opens no models of Simulink, lacks the functions of MATLAB's products, and gives no options by ``Name=value``
    (https://www.mathworks.com/help/matlab/matlab_prog/function-argument-syntax.html, MATLAB R2021a, 2026-11-27).
    """
    from roslab.knowledge.matlab_only import matlab_only  # noqa: PLC0415 - of a refusal

    if repository.suffixed(".slx", ".mdl"):
        return False
    found = nearest([file for file in repository.suffixed(".m") if file.size])
    texts = [repository.read(file) for file in found[:READ]]
    lacking = matlab_only() - {file.name.partition(".")[0] for file in found}
    called = {name for text in texts for name in _CALLED.findall(_COMMENT.sub("", text))}
    return not (called & lacking or any(_NAME_VALUE.search(text) for text in texts))
