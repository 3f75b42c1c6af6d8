"""Dockerfiles that copy packages into the image and compile none of them: they set up an environment."""

from __future__ import annotations

import posixpath
from collections.abc import Collection, Iterable, Sequence

from roslab.evidence.lex.dockerfile import Instruction
from roslab.evidence.prose.built_packages import UNREAD, step, texts_of
from roslab.evidence.service import Service
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

_OF_ROS = pattern(r"(?:^|/)ros2?(?:[-_:]|$)|^osrf/|[:-](?:ros|kinetic|melodic|noetic|humble|jazzy)(?:[-_]|$)")
_BUILDS = pattern(
    r"\b(?:catkin\w*|colcon|ros\w*make|ament|c?make|ninja|build\w*|install|pip\d?|setup\.py|python[\d.]*|just|bazel"
    r"|scons|meson|conan|cargo|gcc|clang|waf|uv|poetry|conda|mamba)\b|\bg\+\+|\.(?:sh|bash|py)\b|(?:^|\s)\./"
)
"""What may build packages, itself or by way of a script."""
_COMPILES = pattern(
    r"\b(?:catkin\w*[ \t]+|catkin_make\w*|colcon[ \t]+|rosmake|ament[ \t]+|c?make|ninja|setup\.py|scons|meson"
    r"|conan|cargo|gcc|clang|uv|poetry)\b|\bg\+\+"
    r"|\bpip[\d.]*[ \t]+install\b[^;&|\n]{0,1000}(?:[ \t][.~]{0,2}/|[ \t]\.(?:\s|$|\[)|[ \t]-e|--editable)"
)
"""What builds packages where the text of each script is known: pip does where it is given a folder."""
_OF_SYSTEM = pattern(
    r"\b(?:apt(?:-get)?|rosdep)\b[^;&|\n]*|(?<![^\s;&|])[^\s;&|]*/(?:setup|local_setup)\.(?:ba|z)?sh\b"
)
"""What only installs packages of a system, or reads a workspace that is there."""
_RELEASED = pattern(r"\bros-[a-z]+-([a-z][a-z0-9-]*)")
_OF_PYTHON = ("setup.py", "setup.cfg", "pyproject.toml", "requirements.txt", "environment.yml")
_RUNS = frozenset({"RUN", "CMD", "ENTRYPOINT"})


def unbuilt(
    repository: Repository,
    base: str,
    context: str,
    copied: Iterable[tuple[str, int]],
    written: Sequence[Instruction],
    *,
    service: Service | None,
) -> str | None:
    """Return why an image has nothing compiled though a Dockerfile copies packages into it, ``None`` where it may have.

    On a base of ROS that are those with a package.xml; on others, and where there are none, the project of CMake at the
    top, where no Python is beside it. ``copied``: what it copies of its ``context``, each with its line; ``service``:
    how Docker Compose starts it. What is commented out builds nothing. Where apt installs one of the packages, that is
    what the image starts.
    """
    packages = frozenset(file.path for file in repository.named("package.xml") if _OF_ROS.search(base))
    holding = packages or _project(repository)
    first = next((line for source, line in copied if _holds(f"{context}/{source}", holding)), None)
    if first is None:
        return None
    steps = [each for each in written if each.name in _RUNS and (each.line > first or "type=bind" in each.text)]
    if any(_installs(each.text, holding) for each in written if each.name == "RUN"):
        return None
    run = [each for each in steps if each.name == "RUN"]
    started = [*(step(each) for each in steps if each.name != "RUN"), *(service.command if service else ())]
    if any(_BUILDS.search(_OF_SYSTEM.sub(" ", text)) for text in started):
        return None
    if any(_BUILDS.search(_OF_SYSTEM.sub(" ", step(each))) for each in run):
        read = texts_of(repository, run) if packages else None
        if read is None or any(UNREAD.search(text) or _COMPILES.search(_OF_SYSTEM.sub(" ", text)) for text in read):
            return None
    what = "the packages" if packages else "the project of CMake"
    return f"it copies {what} (line {first}) and builds none of them: it sets up an environment"


def _project(repository: Repository) -> frozenset[str]:
    """Return the file that tells what CMake would compile, if that is the whole tree."""
    alone = repository.has("CMakeLists.txt") and not any(map(repository.has, _OF_PYTHON))
    return frozenset({"CMakeLists.txt"}) if alone else frozenset()


def _holds(source: str, manifests: Collection[str]) -> bool:
    """Tell whether a path of the tree, which is copied, is one of the files or a folder with one."""
    path = posixpath.normpath(source.lstrip("/") or ".")
    if path in {".", "*"}:
        return bool(manifests)
    return any(file == path or file.startswith(f"{path}/") for file in manifests)


def _installs(text: str, manifests: Iterable[str]) -> bool:
    """Tell whether a step installs one of the packages of ROS by apt, as it was released."""
    names = {posixpath.basename(posixpath.dirname(file)).replace("_", "-") for file in manifests}
    return any(match[1] in names for match in _RELEASED.finditer(text))
