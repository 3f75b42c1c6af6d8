"""What a build on another machine left in the tree: CMake refuses to go on from it in another folder.

``catkin build`` refuses a build space that catkin_make made, by a file of that space:
https://github.com/catkin/catkin_tools/blob/main/catkin_tools/verbs/catkin_build/cli.py, 2026-11-26.
"""

from __future__ import annotations

import posixpath
from collections.abc import Iterator

from roslab.evidence import places
from roslab.evidence.facts import Mention
from roslab.repository.checkout import Repository, nearest
from roslab.values.pattern import pattern

CACHE = "CMakeCache.txt"
FILES = "CMakeFiles"
MARK = ".built_by"
"""Says in a build, devel or install space which tool made it: catkin's tools and colcon write it."""
_TOOLS = ("catkin", "colcon")
_TOOL_OF = {"catkin build": "catkin_tools"} | {name: name for name in ("catkin_make", "catkin_make_isolated")}
_SETTINGS = "CATKIN_IGNORE"
"""catkin_tools writes it into the folder of its settings."""
_MARKS = {".catkin": "_setup_util.py", ".colcon_install_layout": "", "catkin_make.cache": CACHE}
"""Files that only the tools write into a space, each with one that lies beside it; older ones left no other mark.
https://github.com/ros/catkin (cmake/catkin_workspace.cmake, python/catkin/builder.py) and
https://github.com/colcon/colcon-core (colcon_core/verb/build.py, colcon_core/location.py), 2026-11-27."""
_LOG = "logger_all.log"
"""colcon writes one for each of its calls, in a folder of the call's own."""
MOST = 200
"""Each may be two lines of the ignore file; of more, the first."""
_MADE_IN = pattern(r"^CMAKE_CACHEFILE_DIR:INTERNAL=(\S[^\n]{0,200})$")
_PLAIN = pattern(r"[\w.][\w./+-]*\Z")
"""A path that is one line of an ignore file."""


def names(repository: Repository) -> tuple[str, ...]:
    """Return the spaces that a workspace tool made, and each other cache of CMake with the folder beside it, sorted."""
    spaces = _spaces(repository)
    inside = tuple(f"{space}/" for space in spaces)
    folders = [path.removesuffix(CACHE) for path, _, _ in _caches(repository) if not path.startswith(inside)]
    return spaces + tuple(name for folder in folders for name in (f"{folder}{FILES}", f"{folder}{CACHE}"))


def read(repository: Repository) -> Iterator[tuple[str, str, int]]:
    """Yield what the author should know of the first cache: the message, the file and the line.

    Not of what was compiled here: that is no part of the repository, and is hidden all the same.
    """
    here = f"{repository.path}/"
    found = [cache for cache in _caches(repository) if f"{cache[1]}/" != f"{here}{cache[0].removesuffix(CACHE)}"]
    for path, folder, line in found[:1]:
        more = f", and so are {len(found) - 1} more" if len(found) > 2 else ", and so is one more" if found[1:] else ""
        why = "CMake refuses it in any other folder, so a generated Dockerfile leaves it out"
        yield f"CMake wrote it in {folder}{more}: {why}", path, line


def tools(whole: Repository) -> Iterator[Mention]:
    """Yield the tool of catkin that made each space which a build left, and catkin_tools where it keeps its settings.

    https://github.com/catkin/catkin_tools/blob/main/catkin_tools/metadata.py (METADATA_DIR_NAME), 2026-11-29. The
    nearest first; none of a copy or an example. ``whole`` has these spaces, too.
    """
    for file in nearest(file for file in whole.named(MARK, _SETTINGS) if not places.aside(file.path))[:MOST]:
        settings = file.name == _SETTINGS
        if settings and posixpath.basename(file.folder) != ".catkin_tools":
            continue
        said = "catkin build" if settings else whole.read(file).strip()
        if tool := _TOOL_OF.get(said):
            what = f"{file.folder or 'the tree'} is of `{said}`, by which the author has built it"
            yield Mention(topic="built_by", value=tool, source="code", file=file.path, line=1, text=what)


def without(repository: Repository) -> Repository:
    """Return the repository without what a workspace tool wrote to such spaces: copies of the sources, and the rest.

    The same object where there are none, or all packages that there are lie in them.
    """
    spaces = tuple(f"{space}/" for space in _spaces(repository))
    packages = repository.named("package.xml") if spaces else ()
    if not spaces or (packages and all(file.path.startswith(spaces) for file in packages)):
        return repository
    return repository.leaving_out({file.path for file in repository.files if file.path.startswith(spaces)})


def _spaces(repository: Repository) -> tuple[str, ...]:
    """Return the folders that hold a tool's mark, without those inside another; a folder with a manifest is source."""
    marked = {file.folder for file in repository.named(MARK) if repository.read(file).strip().startswith(_TOOLS)}
    for mark, beside in _MARKS.items():
        marked |= {f.folder for f in repository.named(mark) if not beside or repository.has(f"{f.folder}/{beside}")}
    logs = (file.folder.rpartition("/")[0] for file in repository.named(_LOG))
    marked |= {folder for folder in logs if posixpath.basename(folder) == "log"}
    made = sorted(folder for folder in marked if folder and _PLAIN.match(folder))
    made = [space for space in made if not repository.has(f"{space}/package.xml")]
    return tuple(s for s in made if not any(s.startswith(f"{other}/") for other in made))[:MOST]


def _caches(repository: Repository) -> Iterator[tuple[str, str, int]]:
    """Yield each cache with the folder that it was made in and the line that names that."""
    paths = sorted(file.path for file in repository.named(CACHE) if _PLAIN.match(file.path))
    for path in paths[:MOST]:
        for number, line in enumerate(repository.read(path).split("\n"), 1):
            if line.startswith("CMAKE_CACHEFILE_DIR") and (match := _MADE_IN.match(line.rstrip())):
                yield path, match[1], number
                break
