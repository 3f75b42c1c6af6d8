"""What only CUDA's compiler sees tells of versions where CUDA is compiled."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision
from roslab.decide.system.code_fits import misfits
from roslab.evidence.gather import gather
from roslab.repository.checkout import Repository

Tree = Callable[[dict[str, str]], Decision]
CMAKE = "cmake_minimum_required(VERSION 3.5)\nproject(demo)\nfind_package(OpenCV REQUIRED)\n"
OLD = "void f() { cv::imread(name, CV_LOAD_IMAGE_UNCHANGED); }\n"


@pytest.mark.parametrize(
    ("files", "refused"),
    [
        ({"a.cu": OLD}, True),
        ({"a.cu": '#include "u.hpp"\n', "u.hpp": OLD}, True),
        ({"a.cu": "", "u.hpp": OLD}, False),
        ({"CMakeLists.txt": CMAKE + "add_executable(a a.cpp)\n", "a.cpp": "", "a.cu": OLD}, False),
        ({"CMakeLists.txt": CMAKE + "find_package(CUDA REQUIRED)\ncuda_add_executable(a a.cu)\n", "a.cu": OLD}, True),
        ({"CMakeLists.txt": CMAKE + "find_package(CUDA)\n", "a.cu": '#include "u.hpp"\n', "u.hpp": OLD}, False),
        ({"CMakeLists.txt": CMAKE, "a.cu": '#include "u.hpp"\n', "a.cpp": '#include "u.hpp"\n', "u.hpp": OLD}, True),
    ],
)
def test_names_in_sources_of_cuda(tree: Tree, tmp_path: object, files: dict[str, str], refused: bool) -> None:
    tree(files)
    assert ("jammy" in misfits(gather(Repository.open(str(tmp_path))))) is refused


KEEPS = "#include <cv_bridge/cv_bridge.h>\n"
USES = "void f() { cv::cvtColor(a, b, CV_RGB2GRAY); }\n"


@pytest.mark.parametrize(
    ("files", "refused"),
    [
        ({"b.cpp": KEEPS, "c.cpp": KEEPS + USES}, False),
        ({"b.cpp": '#include "k.h"\n', "c.cpp": '#include "k.h"\n' + USES, "k.h": KEEPS}, False),
        ({"b.cpp": KEEPS, "c.cpp": USES}, True),
        ({"b.cpp": '#include "k.h"\n', "c.cpp": USES, "k.h": KEEPS}, True),
    ],
)
def test_every_file_that_includes_what_keeps_names_has_them(
    tree: Tree, tmp_path: object, files: dict[str, str], refused: bool
) -> None:
    tree({"CMakeLists.txt": CMAKE, **files})
    assert ("jammy" in misfits(gather(Repository.open(str(tmp_path))))) is refused
