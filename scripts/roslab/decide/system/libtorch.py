"""The C++ library of PyTorch, for which CMake asks: no package of Ubuntu has it, an archive of its project does."""

from __future__ import annotations

import shlex

from roslab.config.model import Config, Kind, Source
from roslab.decide.ros.distro_dates import dated
from roslab.decide.ros.workspace import Packages
from roslab.decide.system.needs import code_needs
from roslab.decide.system.unreached import unreached
from roslab.evidence import places
from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import Evidence
from roslab.evidence.native.torch_on_gpu import TOPIC
from roslab.knowledge.frameworks import newest_framework
from roslab.values.origin import Place
from roslab.values.version import Version, version_of

NAME = "libtorch"
_LINES = "%s\\n"
_INSTALL = (
    "cmake_minimum_required(VERSION 3.5)",
    f"project({NAME} NONE)",
    'file(WRITE "${CMAKE_BINARY_DIR}/torch.conf" "${CMAKE_INSTALL_PREFIX}/torch/lib\\n")',
    "install(DIRECTORY include lib share DESTINATION torch)",
    'install(FILES "${CMAKE_BINARY_DIR}/torch.conf" DESTINATION /etc/ld.so.conf.d)',
)
"""The archive has no build: a folder of its own, whose name CMake looks for, keeps its headers from hiding others.

https://cmake.org/cmake/help/latest/command/find_package.html#config-mode-search-procedure
"""


def libtorch(
    evidence: Evidence, config: Config, kind: Kind, packages: Packages, cuda: str | None
) -> tuple[tuple[Source, Dependency], ...]:
    """Return the library where the build asks for it, in the release that a page names, else in that of its time.

    ``cuda``: that of the image, for which there may be an archive.
    """
    if config.compatible or kind == "python":
        return ()
    folders = tuple(manifest.file.rpartition("/")[0] for manifest in packages.built if kind in {"ros1", "ros2"})
    other = unreached(evidence, by_page=False)
    needs = (each for each in code_needs(evidence, packages) if _asks(each) and each.file not in other)
    asked = next((each for each in needs if _entered(each, folders)), None)
    if asked is None or (release := _release(evidence)) is None:
        return ()
    from roslab.knowledge.libtorch import libtorch_archive  # noqa: PLC0415 - few trees need it

    source = Source(
        name=NAME,
        zip=libtorch_archive(release, cuda),
        prepare=f"{shlex.join(('printf', _LINES, *_INSTALL))} > CMakeLists.txt",
        place=Place(file=asked.file, line=asked.line),
    )
    return ((source, asked),)


def _asks(each: Dependency) -> bool:
    aside = places.sample(each.file)
    return each.namespace == "cmake" and each.name.lower() == "torch" and each.strength != "optional" and not aside


def _entered(each: Dependency, folders: tuple[str, ...]) -> bool:
    """Tell whether the build tool of a workspace comes to a file: to those of its packages, in these folders."""
    return not folders or any(not folder or each.file.startswith(f"{folder}/") for folder in folders)


def _release(evidence: Evidence) -> str | None:
    """Return the release in full, ``1.8.0``."""
    from roslab.knowledge.libtorch import oldest  # noqa: PLC0415 - as above

    named = [mention.value for mention in evidence.mentions if mention.topic == NAME]
    named += [each.value.partition(" ")[2] for each in evidence.mentions if each.topic == TOPIC]
    named += [each.release or "" for each in evidence.listed if each.key == "torch"]
    named += [git.ref or "" for git in evidence.sources if git.url.removesuffix(".git").endswith("/pytorch/pytorch")]
    release = next((found for each in named if (found := version_of(each.removeprefix("v")))), None)
    date = dated(evidence)
    newest = newest_framework("torch", date.value if date else None)
    if release is None:
        release = Version(newest.first) if newest else oldest()
    return ".".join(map(str, (*max(release, oldest()).release, 0, 0)[:3]))
