"""Projects of CMake in the tree that link the library of the built one are compiled once it is installed."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.pipeline import plan_repository
from roslab.render.dockerfile import dockerfile
from trees import tree_of

PAGE = "# Arm\n\n## Use\n```\ncd arm/samples/one\n./build.bash\ncd bin\n./wave\n```\n"
SCRIPT = "#!/bin/bash\ncd $(dirname $0)\nmkdir -p build\ncd build\ncmake ..\nmake\n"
LIBRARY = "project(arm)\nadd_subdirectory(src)\n"
SOURCES = "add_library(${CMAKE_PROJECT_NAME} arm.cpp)\ninstall(TARGETS ${PROJECT_NAME} LIBRARY DESTINATION lib)\n"
SAMPLE = (
    "project(one)\nset(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${PROJECT_SOURCE_DIR}/bin)\nset(ALL wave grasp)\n"
    "foreach(x IN LISTS ALL)\nadd_executable(${x} ${x}.cpp)\ntarget_link_libraries(${x} PRIVATE arm)\nendforeach()\n"
)
FILES = {
    "README.md": PAGE,
    "lib/CMakeLists.txt": LIBRARY,
    "lib/src/CMakeLists.txt": SOURCES,
    "lib/src/arm.cpp": "int arm;\n",
    "samples/one/CMakeLists.txt": SAMPLE,
    "samples/one/build.bash": SCRIPT,
    "samples/one/wave.cpp": "int main() {}\n",
    "samples/one/grasp.cpp": "int main() {}\n",
}
MESSAGE = "# What is compiled once all above is built: it may need that"


def test_they_are_compiled_after_it_and_their_programs_are_there(tmp_path: Path) -> None:
    tree_of(tmp_path, FILES)
    planned = plan_repository(tmp_path)
    text = dockerfile(planned.plan)
    installs, compiles = text.index("RUN install-program"), text.index(f"{MESSAGE}\n")
    assert installs < compiles < text.index("/samples/one \\\n", compiles)
    assert planned.decision.command == ("wave",)
    assert ("grasp",) in planned.decision.command_candidates
    assert "/samples/one/bin:" in text
    assert not [each for each in planned.decision.warnings if "is compiled, not" in each.message]


FOUND = {
    "lib/src/CMakeLists.txt": f"{SOURCES}install(EXPORT arm FILE arm-config.cmake DESTINATION lib/cmake/arm)\n",
    "samples/one/CMakeLists.txt": "project(one)\nfind_package(arm REQUIRED)\nadd_executable(wave wave.cpp)\n",
}


def test_so_are_those_that_find_its_package(tmp_path: Path) -> None:
    tree_of(tmp_path, FILES | FOUND)
    planned = plan_repository(tmp_path)
    assert MESSAGE in dockerfile(planned.plan)
    assert planned.decision.program_folders[-1:] == ("source/samples/one/build",)


@pytest.mark.parametrize(
    "files",
    [
        {"README.md": "# Arm\n", "samples/one/build.bash": "echo\n"},  # nobody builds it
        {"samples/one/CMakeLists.txt": SAMPLE.replace("PRIVATE arm", "PRIVATE m")},
        {"samples/one/CMakeLists.txt": SAMPLE.replace("project(one)", "project(one)\nadd_library(arm x.cpp)")},
        {"CMakeLists.txt": "project(all)\nadd_subdirectory(lib)\nadd_subdirectory(samples/one)\n"},  # it is a part
    ],
)
def test_others_are_not(tmp_path: Path, files: dict[str, str]) -> None:
    tree_of(tmp_path, FILES | files)
    assert MESSAGE not in dockerfile(plan_repository(tmp_path).plan)
