"""The modules of OpenCV's second repository, opencv_contrib, for code that includes their headers.

Where OpenCV is compiled, it is without them: what includes ``opencv2/xfeatures2d.hpp`` stopped there, though Ubuntu's
own package would have it.
"""

from __future__ import annotations

from collections.abc import Iterable

from roslab.config.model import Source
from roslab.decide.system.on_cuda import LIBRARY, release_of
from roslab.evidence import places
from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import Evidence
from roslab.knowledge.opencv_modules import NONFREE, REPOSITORY, opencv_modules
from roslab.values.dataclass import replace
from roslab.values.version import Version

_FOLDER = ".contributed"
_ON = "-DOPENCV_ENABLE_NONFREE=ON"


def with_contributed(
    libraries: Iterable[tuple[Source, Dependency]], evidence: Evidence
) -> tuple[tuple[Source, Dependency], ...]:
    """Return the libraries, OpenCV of the table with the modules that the code includes, and what these need.

    Each is moved beside OpenCV's own: https://github.com/opencv/opencv_contrib/blob/4.5.5/README.md, 2026-11-29.
    """
    return tuple(
        (_with(source, evidence), asked) if source.tabled and source.name == LIBRARY else (source, asked)
        for source, asked in libraries
    )


def _with(source: Source, evidence: Evidence) -> Source:
    release = release_of(source)
    included = {
        each.name.removeprefix("opencv2/").removesuffix(".hpp")
        for each in evidence.code
        if each.namespace == "include" and each.name.startswith("opencv2/") and not places.vendored(each.file)
    }
    known = opencv_modules()
    asked = sorted({name for each in included if (name := each.partition("/")[0]) in known})
    whole = dict.fromkeys(name for each in asked for name in (*known[each].needs, each))
    there = (
        [name for name in whole if not known[name].since or release >= Version(known[name].since)] if release else []
    )
    if not there:
        return source
    moved = " ".join(f"{_FOLDER}/modules/{name}" for name in there)
    clone = f"git clone --quiet --depth 1 --branch {source.ref} {REPOSITORY} {_FOLDER}"
    prepare = " && ".join(filter(None, (source.prepare, clone, f"mv {moved} modules/", f"rm -rf {_FOLDER}")))
    options = f"{source.cmake_options} {_ON}" if NONFREE in included else source.cmake_options
    return replace(source, cmake_options=options, prepare=prepare)
