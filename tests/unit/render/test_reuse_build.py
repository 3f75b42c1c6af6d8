"""The script that compiles with the last build's tree: it does only where nothing but code has changed."""

from __future__ import annotations

import os
import shutil
import subprocess
from pathlib import Path

import pytest

SCRIPT = Path(__file__).parents[3] / "scripts/roslab/render/image_scripts/reuse-build.sh"
COMPILER = """\
set -e
mkdir -p build devel
for file in $(find src -name '*.cpp'); do
  object="build/$(basename "$file").o"
  if [ ! -e "$object" ] || [ "$file" -nt "$object" ]; then
    echo "compiled $(basename "$file")"
    cp "$file" "$object"
    cp "$file" devel/
  fi
done
! grep -rq broken src
"""
"""What make and a compiler do: compile what is newer than its object."""

pytestmark = pytest.mark.skipif(shutil.which("dpkg-query") is None, reason="the script is for images with dpkg")


class Builder:
    """Builds a workspace again and again, each time from a checkout of its own, with one cache."""

    def __init__(self, root: Path) -> None:
        self.root, self.cache = root, root / "cache"
        self.cache.mkdir()
        self.script = root / "reuse-build"
        self.script.write_text(SCRIPT.read_text().replace("/var/cache/roslab-build", str(self.cache)))
        (root / "compiler").write_text(COMPILER)
        self.number = 0

    def build(self, files: dict[str, str], **environment: str) -> tuple[list[str], dict[str, str]]:
        """Return what was compiled, and what is in the image."""
        self.number += 1
        home = self.root / "home"  # the same path at every build, as in an image
        shutil.rmtree(home, ignore_errors=True)
        for path, text in files.items():
            file = home / "ws" / "src" / path
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(text)
            old = 1_700_000_000 + self.number  # a checkout gives each file a time of its own
            os.utime(file, (old, old))
        ran = subprocess.run(
            ["bash", self.script, "bash", str(self.root / "compiler")],
            cwd=home / "ws",
            env={**os.environ, **environment},
            capture_output=True,
            text=True,
            check=False,
        )
        compiled = [line.split()[1] for line in ran.stdout.splitlines() if line.startswith("compiled ")]
        devel = home / "built" / "devel"
        assert (ran.returncode == 0) == devel.is_dir(), ran.stderr
        assert not (home / "built" / "build").exists(), "the tree is not in the image"
        made = {file.name: file.read_text() for file in devel.iterdir()} if devel.is_dir() else {}
        return sorted(compiled), made


@pytest.fixture
def builder(tmp_path: Path) -> Builder:
    return Builder(tmp_path)


FILES = {"a/a.cpp": "a", "a/b.cpp": "b", "a/CMakeLists.txt": "project(a)", "a/package.xml": "<package/>"}
ALL = ["a.cpp", "b.cpp"]


def test_an_edited_file_alone_is_compiled_again(builder: Builder) -> None:
    assert builder.build(FILES)[0] == ALL
    assert builder.build(FILES) == ([], {"a.cpp": "a", "b.cpp": "b"})
    assert builder.build({**FILES, "a/b.cpp": "more"}) == (["b.cpp"], {"a.cpp": "a", "b.cpp": "more"})
    assert builder.build(FILES) == (["b.cpp"], {"a.cpp": "a", "b.cpp": "b"}), "back again, with an older time"


def test_what_each_build_has_anew_is_no_change(builder: Builder) -> None:
    builder.build(FILES, TRACEPARENT="00-1", OTEL_TRACE_PARENT="00-1", HOSTNAME="one", MAKEFLAGS="-j2")
    assert builder.build(FILES, TRACEPARENT="00-2", OTEL_TRACE_PARENT="00-2", HOSTNAME="two", MAKEFLAGS="-j1")[0] == []


@pytest.mark.parametrize(
    "change",
    [
        {"a/c.cpp": "c"},
        {"a/CMakeLists.txt": "project(b)"},
        {"a/package.xml": "<package format='2'/>"},
        {"a/setup.cfg": "[metadata]"},
    ],
)
def test_any_other_change_compiles_everything(builder: Builder, change: dict[str, str]) -> None:
    builder.build(FILES)
    assert set(ALL) <= set(builder.build({**FILES, **change})[0])


def test_another_variable_compiles_everything(builder: Builder) -> None:
    builder.build(FILES)
    assert builder.build(FILES, CXXFLAGS="-O0")[0] == ALL


def test_a_failure_leaves_nothing_to_the_next_build(builder: Builder) -> None:
    builder.build(FILES)
    assert builder.build({**FILES, "a/a.cpp": "broken"}) == (["a.cpp"], {})
    assert builder.build(FILES)[0] == ALL


def test_without_a_cache_everything_is_compiled(builder: Builder) -> None:
    builder.cache.rmdir()
    assert builder.build(FILES)[0] == builder.build(FILES)[0] == ALL


def test_what_a_build_leaves_is_what_is_kept(builder: Builder) -> None:
    """The kept tree is brought up to date by what has changed: added, edited, removed, or now of another type."""
    compiler = builder.root / "compiler"
    once = "mkdir -p build/gone build/other; touch build/gone/file build/link build/other/file build/stays"
    compiler.write_text(f"{once}; echo 1 >build/edited; mkdir -p devel; ln -sfn edited build/points")
    builder.build(FILES)
    tree = builder.cache / "tree" / "build"
    before = (tree / "stays").stat().st_ino
    again = (
        "rm -r build/gone build/other build/link; echo 22 >build/other; ln -s other build/link; echo 2 >build/edited"
    )
    compiler.write_text(
        f"set -e; {again}; ln -sfn other build/points; mkdir -p 'build/new folder'; touch 'build/new folder/a b'"
    )
    builder.build(FILES)
    found = {str(path.relative_to(tree)) for path in tree.rglob("*")}
    assert found == {"edited", "link", "new folder", "new folder/a b", "other", "points", "stays"}
    assert (tree / "edited").read_text() == "2\n"
    assert (tree / "link").readlink() == (tree / "points").readlink() == Path("other")
    assert (tree / "other").read_text() == "22\n"
    assert (tree / "stays").stat().st_ino == before, "it was not copied as a whole"


def test_what_has_not_changed_is_not_written_again(builder: Builder) -> None:
    builder.build(FILES)
    kept = builder.cache / "tree" / "build" / "a.cpp.o"
    before = kept.stat().st_ino
    builder.build({**FILES, "a/b.cpp": "more"})
    assert kept.stat().st_ino == before
    assert (kept.parent / "b.cpp.o").read_text() == "more"


def test_no_file_of_a_reused_tree_is_newer_than_another(builder: Builder) -> None:
    """Also where they are more than a command line holds: CMake begins anew where a file that it read is newer."""
    times = "find build devel -printf '%T@\\n' | sort --unique | wc --lines"
    long = "x" * 200
    fill = f"mkdir -p build devel; if [ ! -e build/times ]; then touch build/{long}{{1..900}}; fi"
    (builder.root / "compiler").write_text(f'{fill}; times="$({times})"; echo $times >devel/times; touch build/times')
    builder.build(FILES)
    assert builder.build(FILES)[1]["times"] == "1\n"


@pytest.mark.parametrize(
    "names", ['echo "$PWD/build/libkept.so" >devel/environment', 'ln -s "$PWD/build/libkept.so" devel/environment']
)
def test_a_build_tree_that_stays_has_no_objects_and_no_logs(builder: Builder, names: str) -> None:
    """A workspace whose programs load a library out of it keeps it; CMake's logs are others at each build."""
    makes = (
        "mkdir -p build/CMakeFiles/3.25.1 devel; touch build/{libkept.so,a.o} build/CMakeFiles/{CMakeOutput.log,"
        f"CMakeConfigureLog.yaml,3.25.1/kept.cmake}}; {names}"
    )
    workspace = builder.root / "home" / "ws"
    (workspace / "src").mkdir(parents=True)
    subprocess.run(["bash", builder.script, "bash", "-c", makes], cwd=workspace, check=True)
    built = builder.root / "home" / "built"
    kept = {str(file.relative_to(built)) for file in built.rglob("*") if not file.is_dir()}
    assert kept == {"build/libkept.so", "build/CMakeFiles/3.25.1/kept.cmake", "devel/environment"}


WRITING = """
mkdir -p src/world/models src/world/__pycache__
if [ ! -e build/done ]; then echo house >src/world/models/a.sdf; touch build/done; fi
touch src/a/COLCON_IGNORE src/a/a.o src/world/__pycache__/a.pyc
echo changed >src/a/CMakeLists.txt
"""
"""What CMake of a package does that downloads beside itself, once for a build tree."""


def test_what_the_build_adds_to_the_source_is_kept(builder: Builder) -> None:
    compiler = builder.root / "compiler"
    compiler.write_text(COMPILER + WRITING)
    built = builder.root / "home/built"
    for compiled in (ALL, [], ["b.cpp"]):  # at first, with the kept tree, and with that tree and an edit
        files = {**FILES, "a/b.cpp": "new"} if len(compiled) == 1 else FILES
        assert builder.build(files)[0] == compiled
        added = [file.relative_to(built).as_posix() for file in (built / "src").rglob("*") if file.is_file()]
        assert added == ["src/world/models/a.sdf"]
        assert not (built / ".written").exists()


def test_without_a_cache_it_is_kept_too(builder: Builder) -> None:
    shutil.rmtree(builder.cache)
    (builder.root / "compiler").write_text(COMPILER + WRITING)
    builder.build(FILES)
    assert (builder.root / "home/built/src/world/models/a.sdf").read_text() == "house\n"


def test_what_a_failed_attempt_added_is_kept(builder: Builder) -> None:
    shutil.rmtree(builder.cache)
    again = builder.root / "again"
    once = f"if [ ! -e {again} ]; then touch {again}; false; fi\n"
    (builder.root / "compiler").write_text(f"{COMPILER}{WRITING}{once}")
    builder.build(FILES)
    home = builder.root / "home"
    ran = subprocess.run(["bash", builder.script, "bash", builder.root / "compiler"], cwd=home / "ws", check=False)
    assert ran.returncode == 0
    assert (home / "built/src/world/models/a.sdf").exists()
