"""Variables that a page exports and that the tree's own CMake or launch files read: a model, a device."""

from __future__ import annotations

import re
from collections.abc import Iterator

from roslab.evidence import places
from roslab.evidence.facts import Mention
from roslab.evidence.prose import search_paths
from roslab.repository.checkout import File, Repository, nearest
from roslab.values.pattern import pattern

DEEPEST = 1
"""A page below is about a part."""
MAX_READERS = 400
"""Most files that are searched for a variable, those nearest to the root first."""
_EXPORT = pattern(
    r"^[ \t>]*(?:[-*$][ \t]+|`{1,3})*export[ \t]+([A-Z][A-Z0-9_]{2,40})=([\"']?)([\w.+-]{1,60})\2[ \t`]*$", re.MULTILINE
)
_OF_OTHERS = pattern(
    r"(?:ROS|RMW|AMENT|COLCON|CATKIN|LD|LC|CUDA|CMAKE|PYTHON|NVIDIA|QT|OMP|MAKE|PIP|CONDA)_\w+|\w*(?:PATH|_HOME|_KEY|TOKEN)|"
    r"CC|CXX|LANG|HOME|USER|DISPLAY|DISTRO|VERSION|MAKEFLAGS|MASTER_ADDR|\w*_(?:IP|HOST|PORT|URI)"
)
"""Variables of ROS, of build tools and of one machine."""
_READS = (
    r"\$ENV\{%s\}|\$\((?:opt)?env\s+%s\b|\b(?:environ|getenv)\b[^\n]{0,8}['\"]%s['\"]|"
    r"EnvironmentVariable\(\s*(?:name\s*=\s*)?['\"]%s['\"]"
)
"""``$ENV{NAME}`` of CMake; of launch files ``$(env NAME)``, ``environ['NAME']``, ``EnvironmentVariable('NAME')``."""


def read(repository: Repository, file: File, text: str) -> Iterator[Mention]:
    """Yield ``NAME=VALUE`` for each variable whose value is written out and which the tree or a simulator reads."""
    yield from search_paths.read(repository, file, text)
    if "export " not in text or file.path.count("/") > DEEPEST:
        return
    for match in _EXPORT.finditer(text):
        if not _OF_OTHERS.fullmatch(match[1]) and _is_read(match[1], repository):
            line = text.count("\n", 0, match.start(1)) + 1
            value = f"{match[1]}={match[3]}"
            yield Mention(topic="variable", value=value, source="readme", file=file.path, line=line, text=value)


def _is_read(name: str, repository: Repository) -> bool:
    """Tell whether CMake or a launch file of the author's reads a variable."""
    reads = re.compile(_READS.replace("%s", name))
    files = [*repository.named("CMakeLists.txt"), *repository.suffixed(".cmake", ".launch", ".xacro")]
    files += [file for file in repository.suffixed(".py", ".xml") if "launch" in file.name]
    files = [file for file in files if not places.vendored(file.path)]
    for file in nearest(files)[:MAX_READERS]:
        found = repository.read(file)
        if name in found and reads.search(found):
            return True
    return False
