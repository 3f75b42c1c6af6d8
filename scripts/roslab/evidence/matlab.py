"""Files of MATLAB, whose ending Objective-C has, too."""

from __future__ import annotations

import re

from roslab.repository.checkout import Repository, nearest
from roslab.values.pattern import pattern

READ = 50
"""Most files of that ending that are opened."""
_APPLE = pattern(
    r"^[ \t]*(?:@(?:interface|implementation|import|protocol)\b|#[ \t]*(?:import|include)\b)", re.MULTILINE
)

_LOADS = pattern(r"^[ \t]*pkg[ \t]*\(?[ \t]*['\"]?load['\"]?[ \t,]+['\"]?([A-Za-z][\w-]*)", re.MULTILINE)

_COMMENT = pattern(r"%[^\n]*")
_CALLED = pattern(r"(?<![\w.])([A-Za-z]\w{2,40})[ \t]*[(;]")
_NAME_VALUE = pattern(r"^[^%\n]{0,200}?\w\([^()%'\"\n]{1,200},[ \t]*[A-Z]\w{1,40}[ \t]*=(?!=)", re.MULTILINE)
"""``imwarp(image, form, OutputView=view)``"""


def files(repository: Repository) -> int:
    """Return the number of a tree's files of MATLAB, 0 where one of that ending is Objective-C."""
    found = nearest([file for file in repository.suffixed(".m") if file.size])
    apple = any(_APPLE.search(repository.read(file)) for file in found[:READ])
    return 0 if apple else len(found)


def loaded(repository: Repository) -> tuple[str, ...]:
    """Return the packages of Octave that the files nearest to the root load: ``pkg load image``."""
    found = nearest([file for file in repository.suffixed(".m") if file.size])[:READ]
    return tuple(dict.fromkeys(name.lower() for file in found for name in _LOADS.findall(repository.read(file))))


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
