"""The plan of a tree is the same in every process: no answer and no order is that of a set of strings."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

SEEDS = ("1", "2", "3", "4")
PLAN = """
import sys
from pathlib import Path
from roslab.pipeline import plan_repository
from roslab.plan.plan import to_json
for folder in sorted(Path(sys.argv[1]).iterdir()):
    print(to_json(plan_repository(folder).plan))
"""
XML = "<package><name>{}</name><buildtool_depend>catkin</buildtool_depend>{}</package>"
CMAKE = "project({})\nfind_package(catkin REQUIRED)\n"


def package(folder: str, name: str, *keys: str) -> dict[str, str]:
    depends = "".join(f"<depend>{key}</depend>" for key in keys)
    return {f"{folder}/package.xml": XML.format(name, depends), f"{folder}/CMakeLists.txt": CMAKE.format(name)}


def workspaces() -> dict[str, str]:
    """Several workspaces with the same packages, of which the first one by name has fewest."""
    files = package("alone/src/map", "map")
    for name in ("berta", "carla", "doris", "emma", "frieda"):
        files |= package(f"{name}/src/map", "map") | package(f"{name}/src/drive", "drive")
    return files


def keys_of_apt() -> dict[str, str]:
    """A package whose keys are names of apt, which an install line has, too."""
    names = [f"lib{letter}{letter}-dev" for letter in "abcdefgh"]
    return package("demo", "demo", *names) | {"README.md": f"```\nsudo apt-get install {' '.join(names)}\n```\n"}


def clones() -> dict[str, str]:
    """A project of CMake with libraries of which a page compiles several in one line."""
    said = " && ".join(f"git clone https://github.com/a/{name}.git" for name in ("eigen", "opencv", "boost", "ceres"))
    finds = "".join(f"find_package({name} REQUIRED)\n" for name in ("Ceres", "Pangolin", "Boost"))
    page = f"```\n{said} && cd ceres && cmake . && make install\n```\n"
    return {"CMakeLists.txt": f"project(demo)\n{finds}add_executable(demo a.cpp)\n", "README.md": page, "a.cpp": ""}


def test_the_plan_is_the_same_in_every_process(tmp_path: Path) -> None:
    for number, files in enumerate((workspaces(), keys_of_apt(), clones())):
        for path, text in files.items():
            target = tmp_path / str(number) / path
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_text(text, encoding="utf-8")
    plans = {
        subprocess.run(
            [sys.executable, "-c", PLAN, str(tmp_path)],
            env={**os.environ, "PYTHONHASHSEED": seed, "PYTHONPATH": os.pathsep.join(sys.path)},
            check=True,
            capture_output=True,
            text=True,
        ).stdout
        for seed in SEEDS
    }
    assert len(plans) == 1
    assert "berta/src/map/package.xml" in plans.pop()
