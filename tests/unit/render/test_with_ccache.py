"""The launcher of compilers: by ccache where a cache is mounted and the image has it, else as ever."""

from __future__ import annotations

import os
import shutil
import subprocess
from pathlib import Path

import pytest

SCRIPT = Path(__file__).parents[3] / "scripts/roslab/render/image_scripts/with-ccache.sh"
BASH = shutil.which("bash") or "bash"
COMPILER = '#!/bin/bash\necho "compiler $*" >>"${SAID}"\nexec c++ "$@"\n'
STAND_IN = '#!/bin/bash\necho "ccache $* in ${CCACHE_DIR} depend=${CCACHE_DEPEND}" >>"${SAID}"\nexec "$@"\n'

pytestmark = pytest.mark.skipif(shutil.which("c++") is None, reason="there is no compiler")


class Compiling:
    """Compiles a file by the launcher, in a folder of its own."""

    def __init__(self, root: Path) -> None:
        self.root, self.cache, self.said = root, root / "cache", root / "said"
        self.script = root / "with-ccache"
        self.script.write_text(SCRIPT.read_text().replace("/var/cache/roslab-build", str(self.cache)))
        (root / "bin").mkdir()
        self.path = f"{root / 'bin'}:{os.environ['PATH']}"
        self.program("compiler", COMPILER)
        (root / "a.h").write_text("int one();\n")
        (root / "a.cpp").write_text('#include "a.h"\nint one() { return 1; }\n')

    def program(self, name: str, text: str) -> None:
        file = self.root / "bin" / name
        file.write_text(text)
        file.chmod(0o755)

    def compile(self, *words: str) -> str:
        """Return what the compiler and a stand-in of ccache said."""
        self.said.write_text("")
        command = [BASH, str(self.script), "compiler", *words]
        environment = {**os.environ, "PATH": self.path, "SAID": str(self.said)}
        subprocess.run(command, cwd=self.root, env=environment, check=True)
        return self.said.read_text()


@pytest.fixture
def compiling(tmp_path: Path) -> Compiling:
    return Compiling(tmp_path)


def test_without_a_cache_or_without_ccache_it_compiles_as_ever(compiling: Compiling) -> None:
    compiling.program("ccache", STAND_IN)
    assert compiling.compile("-c", "a.cpp", "-o", "a.o") == "compiler -c a.cpp -o a.o\n"
    compiling.cache.mkdir()
    assert "ccache compiler" in compiling.compile("-c", "a.cpp", "-o", "a.o")
    assert (compiling.root / "a.o").exists()
    (compiling.root / "bin/ccache").unlink()
    compiling.program("compiler", COMPILER.replace("exec ", ": "))  # which needs other programs
    compiling.path = str(compiling.root / "bin")
    assert compiling.compile("-c", "a.cpp", "-o", "a.o") == "compiler -c a.cpp -o a.o\n"


def test_a_command_is_run_as_it_is_and_its_exit_code_is_kept(compiling: Compiling) -> None:
    counts = 'echo "direct_cache_hit $(cat "${CCACHE_DIR}/n")"; echo "cache_miss 9"'
    compiling.program("ccache", f"#!/bin/bash\n{counts}\n")
    (compiling.cache / "ccache").mkdir(parents=True)
    (compiling.cache / "ccache/n").write_text("2")
    (compiling.root / "make").write_text(f"echo 5 >{compiling.cache}/ccache/n; exit $1")

    def told(code: int) -> tuple[int, str]:
        command = ["bash", str(compiling.script), "--told", "bash", "make", str(code)]
        path = {**os.environ, "PATH": compiling.path}
        done = subprocess.run(command, cwd=compiling.root, env=path, capture_output=True, text=True, check=False)
        return done.returncode, done.stdout

    assert told(3) == (3, "")
    (compiling.cache / "ccache/n").write_text("2")
    assert told(0) == (0, "roslab: 3 files were compiled by an earlier build\n")
    assert told(0) == (0, ""), "none more"


@pytest.mark.parametrize(
    ("words", "added", "depend"),
    [
        (["-O2", "-c", "a.cpp", "-o", "b.o"], " -MD -MF b.o.d", "1"),
        (["-MD", "-MT", "b.o", "-MF", "own.d", "-c", "a.cpp", "-o", "b.o"], "", "1"),
        (["-MMD", "-c", "a.cpp", "-o", "b.o"], "", ""),
        (["-shared", "a.cpp", "-o", "b.so"], "", "1"),
    ],
)
def test_the_compiler_tells_of_headers_where_cmake_does_not_ask(
    compiling: Compiling, words: list[str], added: str, depend: str
) -> None:
    compiling.program("ccache", STAND_IN)
    compiling.cache.mkdir()
    said = compiling.compile(*words)
    assert (
        said.splitlines()[0] == f"ccache compiler {' '.join(words)}{added} in {compiling.cache}/ccache depend={depend}"
    )
