"""The script that compiles with the last build's tree, with CMake and make themselves in place of catkin_make."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
from pathlib import Path

import pytest

SCRIPT = Path(__file__).parents[3] / "scripts/roslab/render/image_scripts/reuse-build.sh"
NEEDED = ("cmake", "make", "c++", "dpkg-query")
CATKIN_MAKE = """\
#!/bin/bash
set -e
echo called catkin_make
mkdir -p build devel && cd build
cmake -G 'Unix Makefiles' ../src
make
"""
FILES = {
    "CMakeLists.txt": """\
cmake_minimum_required(VERSION 3.5)
project(robot CXX)
add_executable(robot main.cpp part.cpp)
add_custom_command(TARGET robot POST_BUILD COMMAND robot >${CMAKE_SOURCE_DIR}/../devel/said)
""",
    "main.cpp": '#include <cstdio>\nint part();\nint main() { std::printf("%d", part()); }\n',
    "part.cpp": "int part() { return 1; }\n",
    "part.hpp": "const int number = 2;\n",
}
INCLUDES = {"part.cpp": '#include "part.hpp"\n#include <vector>\nint part() { return number; }\n'}

pytestmark = pytest.mark.skipif(
    any(shutil.which(name) is None for name in NEEDED), reason="there is no CMake, make, compiler or dpkg"
)


class Builder:
    """Builds a workspace again and again with one cache, each time from a checkout of its own."""

    def __init__(self, root: Path) -> None:
        self.root, self.cache = root, root / "cache"
        self.cache.mkdir()
        self.program("reuse-build", SCRIPT.read_text().replace("/var/cache/roslab-build", str(self.cache)))
        self.program("headers-first", '#!/bin/bash\nexec "$@"\n')
        self.program("catkin_make", CATKIN_MAKE)

    def program(self, name: str, text: str) -> None:
        file = self.root / "bin" / name
        file.parent.mkdir(exist_ok=True)
        file.write_text(text)
        file.chmod(0o755)

    def build(self, files: dict[str, str], *words: str) -> tuple[list[str], str]:
        """Return what was called and compiled, and what the program says; "" where the build fails."""
        home = self.root / "home"
        shutil.rmtree(home, ignore_errors=True)
        for name, text in files.items():
            file = home / "ws" / "src" / name
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(text)
            os.utime(file, (1_700_000_000, 1_700_000_000))
        ran = subprocess.run(
            ["reuse-build", "headers-first", "catkin_make", "-j2", *words],
            cwd=home / "ws",
            env={**os.environ, "PATH": f"{self.root / 'bin'}:{os.environ['PATH']}"},
            capture_output=True,
            text=True,
            check=False,
        )
        found = re.findall(r"called \w+|(?<=robot\.dir/)\w+\.cpp(?=\.o$)", ran.stdout, re.MULTILINE)
        said = home / "built/devel/said"
        assert (ran.returncode == 0) == said.exists(), ran.stderr
        return sorted(found), said.read_text() if said.exists() else ""


@pytest.fixture
def builder(tmp_path: Path) -> Builder:
    return Builder(tmp_path)


ALL = ["called catkin_make", "main.cpp", "part.cpp"]


def test_make_alone_compiles_what_has_changed(builder: Builder) -> None:
    """Headers of the source are known from the build in which they came on; those of the image are on no list."""
    assert builder.build(FILES, "-DCMAKE_BUILD_TYPE=Release") == (ALL, "1")
    for files, made in (
        ({**FILES, **INCLUDES}, (["part.cpp"], "2")),
        ({**FILES, **INCLUDES, "part.hpp": "const int number = 3;\n"}, (["part.cpp"], "3")),
        ({**FILES, **INCLUDES, "part.hpp": "const int number = 3;\n"}, ([], "3")),
        ({**FILES, **INCLUDES}, (["part.cpp"], "2")),
        ({**FILES, "part.hpp": "const int number = 3;\n"}, (["part.cpp"], "1")),
        (FILES, ([], "1")),
    ):
        assert builder.build(files, "-DCMAKE_BUILD_TYPE=Release") == made
    text = "".join(file.read_text() for file in (builder.cache / "tree").rglob("compiler_depend.*"))
    assert "main.cpp" in text
    assert "/cstdio" not in text


def test_a_build_file_that_changes_or_a_target_calls_catkin_make(builder: Builder) -> None:
    assert builder.build(FILES) == (ALL, "1")
    assert builder.build({**FILES, "CMakeLists.txt": FILES["CMakeLists.txt"] + "# more\n"})[0] == ALL
    assert builder.build(FILES, "robot")[0] == ALL
    assert builder.build(FILES, "robot")[0] == ["called catkin_make"]
    assert builder.build(FILES, "-DCMAKE_CXX_FLAGS=-O1 -g")[0] == ALL


def test_what_make_alone_cannot_compile_is_told_by_catkin_make(builder: Builder) -> None:
    builder.build(FILES)
    found, said = builder.build({**FILES, "part.cpp": "broken\n"})
    assert ("called catkin_make" in found, said) == (True, "")
    assert builder.build(FILES) == (ALL, "1")


GENERATED = {
    "CMakeLists.txt": """\
cmake_minimum_required(VERSION 3.20)
project(robot NONE)
set(said ${CMAKE_BINARY_DIR}/../devel/said)
add_custom_command(OUTPUT ${said} DEPENDS name.py DEPFILE made.d
  COMMAND sh ${CMAKE_SOURCE_DIR}/make.sh ${CMAKE_SOURCE_DIR} ${said} ${CMAKE_BINARY_DIR}/made.d)
add_custom_target(texts ALL DEPENDS ${said})
""",
    "make.sh": 'read -r name <"$1/name.py"\ncp "$1/$name" "$2"\necho "$2: $1/$name" >"$3"\n',
    "name.py": "one.py\n",
    "one.py": "1",
    "two.py": "2",
}
"""A program that reads a file of which CMake knows only by what that program tells."""


def test_what_a_program_tells_of_its_files_is_known_too(builder: Builder) -> None:
    assert builder.build(GENERATED)[1] == "1"
    files = {**GENERATED, "name.py": "two.py\n"}
    assert builder.build(files)[1] == "2"
    assert builder.build({**files, "two.py": "3"})[1] == "3"
