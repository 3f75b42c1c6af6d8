"""Variables that a page exports and that the tree's own CMake or launch files read: a model, a device."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator

from roslab.evidence import places
from roslab.evidence.facts import Mention
from roslab.evidence.prose import own_places, search_paths
from roslab.evidence.prose.python_path import HERE, folder_of
from roslab.knowledge.machine_variables import of_every_image, of_one_machine
from roslab.repository.checkout import File, Repository, nearest
from roslab.values.name import bare_name
from roslab.values.pattern import pattern

DEEPEST = 1
"""A page below is about a part. Of one in a documentation folder counts what a launch file stops without."""
MAX_READERS = 400
"""Most files that are searched for a variable, those nearest to the root first."""
_EXPORT = pattern(
    r"^[ \t>]*(?:[-*$][ \t]+|`{1,3})*export[ \t]+([A-Z][A-Z0-9_]{2,40})=([\"']?)([\w.+-]{1,60})\2[ \t`]*(?:[ \t]#.*)?$",
    re.MULTILINE,
)
ANY = pattern(r"^[ \t$>]*export[ \t]+([A-Z][A-Z0-9_]{2,40})=([\"']?)([^\s\"'#;&|<>]{1,100})\2[ \t]*(?:#.*)?$")
"""A line of a block that exports one variable."""
_OF_OTHERS = pattern(
    r"(?:ROS|RMW|AMENT|COLCON|CATKIN|LD|LC|CUDA|CMAKE|PYTHON|NVIDIA|QT|OMP|MAKE|PIP|CONDA)_\w+|\w*(?:PATH|_HOME|_KEY|TOKEN)|"
    r"CC|CXX|LANG|HOME|USER|DISPLAY|DISTRO|VERSION|MAKEFLAGS|MASTER_ADDR|\w*_(?:IP|HOST|PORT|URI)"
)
"""Variables of ROS, of build tools and of one machine."""
_PROGRAMS = (".py", ".cpp", ".cc", ".cxx")
_READS = (
    r"\$ENV\{%s\}|\$\((?:opt)?env\s+%s\b|\b(?:environ|getenv)\b[^\n]{0,8}['\"]%s['\"]|"
    r"EnvironmentVariable\(\s*(?:name\s*=\s*)?['\"]%s['\"]|\bcondition\s*=\s*['\"][^'\"<>]*\$%s\b"
)
"""``$ENV{NAME}`` of CMake; of launch files ``$(env NAME)``, ``environ['NAME']``, ``EnvironmentVariable('NAME')``; of a
package.xml ``condition="$NAME == …"``; ``getenv("NAME")`` of C++."""


def read(repository: Repository, file: File, text: str) -> Iterator[Mention]:
    """Yield ``NAME=VALUE`` for each variable whose value is written out and which the tree or a simulator reads."""
    yield from search_paths.read(repository, file, text)
    yield from own_places.read(repository, file, text)
    below = file.path.count("/") > DEEPEST
    if "export " not in text or (below and not places.documentation(file.path)):
        return
    for match in _EXPORT.finditer(text):
        read_there = _stops_without if below else _is_read
        if not _OF_OTHERS.fullmatch(match[1]) and read_there(match[1], repository):
            line = text.count("\n", 0, match.start(1)) + 1
            value = f"{match[1]}={match[3]}"
            yield Mention(topic="variable", value=value, source="readme", file=file.path, line=line, text=value)


def of_line(repository: Repository, file: File, line: int, code: str, heading: str) -> Iterator[Mention]:
    """Yield what a line of a block exports, for the commands that follow it in the same section.

    A folder of the tree that is named from where the page is, or below the repository's own name, stands for it.
    """
    match = ANY.match(code)
    if match is None or _OF_OTHERS.fullmatch(match[1]):
        return
    value = match[3].replace("`pwd`", "$(pwd)")
    parts = value.split("/")
    ours = HERE.match(parts[0]) or any(bare_name(part) == bare_name(repository.name) for part in parts[:-1])
    if ours and ("/" in value or parts[0] != "."):
        folder = folder_of(value, repository)
        value = search_paths.joined([folder]) if folder else ""
    if value and "$" not in value:
        said = f"{match[1]}={value}"
        yield Mention(
            topic="exported", value=said, source="readme", file=file.path, line=line, text=said, heading=heading
        )


def read_by_tree(name: str, repository: Repository) -> bool:
    """Tell whether the tree's own files read a variable, but for ROS's, build tools' and those of one machine."""
    return not (_OF_OTHERS.fullmatch(name) or of_one_machine(name) or of_every_image(name)) and _is_read(
        name, repository
    )


def read_by_launch(name: str, repository: Repository) -> bool:
    """Tell whether launch files or a package.xml read a variable, and no CMake, whose switches need more than it."""
    from roslab.knowledge.build_variables import build_variables  # noqa: PLC0415 - few variables are asked for

    if name in build_variables() or not read_by_tree(name, repository):
        return False
    return not _reading(name, _of_cmake(repository), repository)


def read_by_program(name: str, repository: Repository) -> bool:
    """Tell whether programs of the tree read a variable, and no file that builds them, whose switches need more."""
    if _OF_OTHERS.fullmatch(name) or of_one_machine(name) or of_every_image(name):
        return False
    building = [*_of_cmake(repository), *repository.named("setup.py")]
    return not _reading(name, building, repository) and _reading(name, repository.once(_programs), repository)


def _programs(repository: Repository) -> list[File]:
    return nearest([file for file in repository.suffixed(*_PROGRAMS) if not places.vendored(file.path)])[:MAX_READERS]


def _of_cmake(repository: Repository) -> list[File]:
    return [file for file in repository.once(_readers) if file.name.endswith((".txt", ".cmake"))]


def _is_read(name: str, repository: Repository) -> bool:
    """Tell whether CMake, a package.xml or a launch file of the author's reads a variable, or a sister repository's.

    Those are not cloned before the build.
    """
    from roslab.knowledge.build_variables import build_variables  # noqa: PLC0415 - few variables are asked for

    if name in build_variables():
        return True
    return _reading(name, repository.once(_readers), repository)


def _stops_without(name: str, repository: Repository) -> bool:
    """Tell whether a launch file of the author's stops without a variable: ``$(env NAME)`` has no default."""
    said = re.compile(rf"\$\(env\s+{re.escape(name)}\s*\)")
    launches = (each for each in repository.once(_readers) if each.name.endswith((".launch", ".xacro", ".xml")))
    return any(said.search(text) for each in launches if "$(env" in (text := repository.read(each)))


def _readers(repository: Repository) -> list[File]:
    files = [
        *repository.named("CMakeLists.txt"),
        *repository.named("package.xml"),
        *repository.suffixed(".cmake", ".launch", ".xacro"),
    ]
    files += [file for file in repository.suffixed(".py", ".xml") if "launch" in file.name]
    return nearest([file for file in files if not places.vendored(file.path)])[:MAX_READERS]


def _reading(name: str, files: Iterable[File], repository: Repository) -> bool:
    reads = re.compile(_READS.replace("%s", re.escape(name)))
    texts = (repository.read(file) for file in files)
    return any(name in text and reads.search(text) for text in texts)
