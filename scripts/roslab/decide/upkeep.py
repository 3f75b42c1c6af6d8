"""Scripts that keep the project itself, which are no program of it."""

from __future__ import annotations

import re

from roslab.decide.candidate import Candidate, program_of
from roslab.values.endings import SHELL_SCRIPTS
from roslab.values.pattern import pattern

_UPKEEP = pattern(
    r"(?:^|/)(?:\.\w[\w-]*|build[_-]?(?:tools?|utils?|scripts?)|cmake|ci|continuous_integration|docs?|documentation|sphinx\w*|"
    r"packaging|releases?|deploy\w*(?=/[^ ]*\.(?:ba)?sh$)|dev(?:[_-]?tools?)?|maint\w*|admin|debian|"
    r"conda(?:[._-]recipe)?|recipe)/|"
    r"(?:^|[/_.-])(?:changelog|release(?:_?notes)?|bump(?:_?version)?|(?:get|update|set|sync|check)_(?:\w+_)?version|versioneer|publish|upload|"
    r"coverage|codecov|stubgen|pre_?commit|git_?hook|noxfile|fabfile|conftest|setup|conf|gen_?docs?|make_?docs?)\.(?:py|(?:ba)?sh)$|"
    r"(?:^|/)(?:(?:sync|set)[_-]?(?:times?|clocks?|date)|(?:time|clock)[_-]?sync|ntp\w*)\.(?:ba)?sh$|"
    r"(?:^|/)(?:(?:sync|deploy)_to_\w+|(?:(?:dist|make)[_-]?)?clean(?:[_-]?(?:up|all))?|uninstall)\.(?:ba)?sh$",
    re.IGNORECASE,
)
"""A script that keeps the project itself: of its releases, its build, its documentation, its continuous integration,
or one that copies it to other machines, sets their clocks or takes away what was built."""


def upkeep(candidate: Candidate) -> bool:
    """Tell whether a script is for those who work on the project: who only uses it never runs it."""
    words = program_of(candidate.argv)
    script = words[1] if words[0] in {"python3", "bash", "sh"} and len(words) > 1 else words[0]
    return bool(_UPKEEP.search(script)) and script.endswith((".py", *SHELL_SCRIPTS))
