"""The script that compiles a workspace of catkin once more where a header was not generated in time."""

from __future__ import annotations

import os
import shutil
import subprocess
from pathlib import Path

import pytest

SCRIPT = Path(__file__).parents[3] / "scripts/roslab/render/image_scripts/headers-first.sh"
CATKIN = """\
mkdir -p devel
for package in $(ls src); do
  mkdir -p build/$package
  printf 'help:\\n\\t@echo "... %s_generate_messages"\\n%s_generate_messages:\\n\\ttouch ../../devel/%s.h\\n' \
    $package $package $package >build/$package/Makefile
  header=$(cat src/$package/main.cpp)
  echo "tried $package"
  if [ ! -e devel/${header%%/*}.h ] || [ "${header##*/}" = NoSuch.h ]; then
    echo "main.cpp:1:10: fatal error: $header: No such file or directory" >&2
    exit 1
  fi
done
"""
"""What ``catkin build`` does where nothing waits for a package's headers: it stops at the first without them."""


@pytest.mark.skipif(shutil.which("make") is None, reason="the script asks make for its targets")
@pytest.mark.parametrize(
    ("tool", "includes", "code", "tried"),
    [
        ("catkin", {"a": "a/Level.h", "b": "b/LevelConfig.h"}, 0, "aabab"),
        ("catkin", {"a": "a/with_custom_points.h"}, 0, "aa"),
        ("catkin", {"L": "L/Point_cloud.h"}, 0, "LL"),
        ("catkin", {"a": "a/NoSuch.h"}, 1, "aa"),
        ("catkin", {"a": "nowhere/Level.h"}, 1, "a"),
        ("catkin", {"a": "nowhere/some_header.h"}, 1, "a"),
        ("colcon", {"a": "a/Level.h"}, 1, "a"),
    ],
)
def test_catkin_build_generates_a_packages_headers_first(
    tmp_path: Path, tool: str, includes: dict[str, str], code: int, tried: str
) -> None:
    program = tmp_path / "programs" / tool
    program.parent.mkdir()
    program.write_text(f"#!/bin/bash\n{CATKIN}")
    program.chmod(0o755)
    workspace = tmp_path / "ws"
    for package, header in includes.items():
        (workspace / "src" / package).mkdir(parents=True)
        (workspace / "src" / package / "main.cpp").write_text(header)
    ran = subprocess.run(
        ["bash", SCRIPT, tool, "build"],
        cwd=workspace,
        env={**os.environ, "PATH": f"{program.parent}:{os.environ['PATH']}"},
        capture_output=True,
        text=True,
        check=False,
    )
    assert ran.returncode == code, ran.stderr
    assert [line.split()[1] for line in ran.stdout.splitlines() if line.startswith("tried ")] == [*tried]


@pytest.mark.skipif(shutil.which("make") is None, reason="the script asks make for its targets")
def test_many_headers_that_were_not_there_yet_do_not_stop_it(tmp_path: Path) -> None:
    program = tmp_path / "catkin"
    many = "for number in $(seq 9000); do echo 'm.cpp:1:1: fatal error: a/M.h: No such file or directory'; done"
    made = "printf 'help:\\n\\t@echo \"... a_gencfg\"\\na_gencfg:\\n\\ttouch ../../made\\n' >build/a/Makefile"
    program.write_text(f"#!/bin/bash\nmkdir -p build/a\n{made}\n[ -e made ] || {{ {many}; exit 1; }}\n")
    program.chmod(0o755)
    path = {**os.environ, "PATH": f"{tmp_path}:{os.environ['PATH']}"}
    ran = subprocess.run(
        ["bash", SCRIPT, "catkin"], cwd=tmp_path, env=path, capture_output=True, text=True, check=False
    )
    assert ran.returncode == 0, ran.stderr
