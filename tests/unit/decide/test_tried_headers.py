"""A library that CMake only tries to find, and whose headers the code includes, is needed."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
RUN = "RUN git clone https://github.com/lab/{0}.git && cd {0} && mkdir build && cd build && cmake .. && make install\n"
PACKAGE = "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend></package>"


@pytest.mark.parametrize(
    ("code", "cloned", "built", "told"),
    [
        ("#include <acmenet/net.hpp>", "acmenet", ["acmenet"], False),
        ("#include <acmenet/net.hpp>", "other", [], True),
        ("#include <othernet/net.hpp>", "acmenet", [], False),
        ("#if ACMENET_FOUND\n#include <acmenet/net.hpp>\n#endif", "other", [], False),
        ("#ifdef HAVE_ACMENET\n#include <acmenet/net.hpp>\n#endif", "other", [], False),
        ("#if defined(USE_ACMENET) && A\n#include <acmenet/net.hpp>\n#endif", "other", [], False),
        ("#ifndef ACMENET_FOUND\n#define ACMENET_FOUND 0\n#endif\n#include <acmenet/net.hpp>", "other", [], True),
        ("#if !ACMENET_FOUND\n#include <acmenet/net.hpp>\n#endif", "other", [], True),
        ("#if WITH_ACMENET\n#else\n#include <acmenet/net.hpp>\n#endif", "other", [], True),
        ("#if WITH_OTHER\n#include <acmenet/net.hpp>\n#endif", "other", [], True),
        ('#if __has_include(<acmenet/net.hpp>)\n#include "acmenet/net.hpp"\n#endif', "other", [], False),
    ],
)
def test_what_the_code_includes_and_cmake_only_tries(
    tree: Tree, code: str, cloned: str, built: list[str], told: bool
) -> None:
    decision = tree(
        {
            "core/package.xml": PACKAGE,
            "core/CMakeLists.txt": "project(demo)\nfind_package(catkin REQUIRED)\nfind_package(AcmeNet)\n"
            "add_executable(demo demo.cpp)\n",
            "core/demo.cpp": f"{code}\nint main() {{}}\n",
            "docker/Dockerfile": f"FROM ros:noetic\nRUN apt-get install -y acmenet-tools\n{RUN.format(cloned)}",
        }
    )
    assert [source.name for source in decision.source] == built
    warned = [each for each in decision.warnings if each.message.startswith("the code includes acmenet/net.hpp")]
    assert [each.file for each in warned] == (["core/demo.cpp"] if told else [])
