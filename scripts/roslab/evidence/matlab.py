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


def files(repository: Repository) -> int:
    """Return the number of a tree's files of MATLAB, 0 where one of that ending is Objective-C."""
    found = nearest([file for file in repository.suffixed(".m") if file.size])
    apple = any(_APPLE.search(repository.read(file)) for file in found[:READ])
    return 0 if apple else len(found)


def loaded(repository: Repository) -> tuple[str, ...]:
    """Return the packages of Octave that the files nearest to the root load: ``pkg load image``."""
    found = nearest([file for file in repository.suffixed(".m") if file.size])[:READ]
    return tuple(dict.fromkeys(name.lower() for file in found for name in _LOADS.findall(repository.read(file))))


def simulink(repository: Repository) -> bool:
    """Tell whether a tree has models of Simulink."""
    return bool(repository.suffixed(".slx", ".mdl"))
