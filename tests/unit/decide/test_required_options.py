"""Commands that lack what their program requires."""

from __future__ import annotations

from pathlib import Path

import pytest

from trees import decided

GUARD = "\n\nif __name__ == '__main__':\n    main()\n"
MANIFEST = (
    "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend><build_depend>rospy</build_depend></package>"
)


def _program(*arguments: str) -> str:
    return "import argparse\n\np = argparse.ArgumentParser()\n" + "".join(f"p.{each}\n" for each in arguments) + GUARD


@pytest.mark.parametrize(
    ("argument", "page", "command"),
    [
        ("add_argument('--map', required=True)", "python plan.py\npython show.py", "show.py"),
        ("add_argument('-m', '--map', type=str, required=True)", "python plan.py -m a\npython show.py", "plan.py"),
        ("add_argument('--map', required=True)", "python plan.py --map=a\npython show.py", "plan.py"),
        ("add_argument('map')", "python plan.py\npython show.py", "show.py"),
        ("add_argument('map')", "python plan.py a\npython show.py", "plan.py"),
        ("add_argument('--map', default='a')", "python plan.py\npython show.py", "plan.py"),
        ("add_argument('--map', required=True)", "python plan.py", "plan.py"),
        ("add_subparsers()\np.add_argument('--map', required=True)", "python plan.py\npython show.py", "plan.py"),
    ],
)
def test_another_program_comes_first(tmp_path: Path, argument: str, page: str, command: str) -> None:
    show = {"show.py": _program()} if "show.py" in page else {}
    files = {"plan.py": _program(argument), **show, "README.md": f"# demo\n\n## Run\n```\n{page}\n```\n"}
    assert decided(tmp_path, files).command[:2] == ("python", command)


def test_a_usage_text_is_no_run(tmp_path: Path) -> None:
    usage = "rosrun demo plan.py\n    [-h]\n    --map MAP\n    [--show SHOW]"
    run = "rosrun demo plan.py --map a.csv"
    files = {
        "package.xml": MANIFEST,
        "CMakeLists.txt": "project(demo)\nfind_package(catkin REQUIRED)\n",
        "scripts/plan.py": "#!/usr/bin/env python\n" + _program("add_argument('--map', required=True)"),
        "a.csv": "",
        "README.md": f"# demo\nROS noetic\n```\n{usage}\n```\n\nExample:\n```\n{run}\n```\n",
    }
    found = decided(tmp_path, files)
    assert found.command == tuple(run.split())
    assert ("rosrun", "demo", "plan.py") not in found.command_candidates


def test_a_node_without_what_it_requires_is_behind_another(tmp_path: Path) -> None:
    files = {
        "package.xml": MANIFEST,
        "CMakeLists.txt": "project(demo)\nfind_package(catkin REQUIRED)\n",
        "scripts/plan.py": "#!/usr/bin/env python\n" + _program("add_argument('--map', required=True)"),
        "scripts/show.py": "#!/usr/bin/env python\n" + _program(),
        "README.md": "# demo\nROS noetic\n```\nrosrun demo plan.py\nrosrun demo show.py\n```\n",
    }
    assert decided(tmp_path, files).command == ("rosrun", "demo", "show.py")


MAIN = "int main(int argc, char **argv) {{ {} }}\n"
UNTESTED = MAIN.format("run(argv[1]);")


@pytest.mark.parametrize(
    ("code", "page", "command"),
    [
        (UNTESTED, "rosrun demo slam\nroslaunch demo a.launch", "roslaunch demo a.launch"),
        (UNTESTED, "rosrun demo slam _rate:=3\nroslaunch demo a.launch", "roslaunch demo a.launch"),
        (UNTESTED, "rosrun demo slam map.yaml\nroslaunch demo a.launch", "rosrun demo slam map.yaml"),
        (MAIN.format("run();"), "rosrun demo slam\nroslaunch demo a.launch", "rosrun demo slam"),
        (UNTESTED, "rosrun demo slam", "roslaunch demo a.launch"),
    ],
)
def test_a_compiled_program_that_is_given_too_few(tmp_path: Path, code: str, page: str, command: str) -> None:
    files = {
        "package.xml": MANIFEST.replace("rospy", "roscpp"),
        "CMakeLists.txt": "project(demo)\nfind_package(catkin REQUIRED)\nadd_executable(slam slam.cpp)\n",
        "slam.cpp": code,
        "map.yaml": "rate: 1\n",
        "launch/a.launch": "<launch><node pkg='demo' type='slam' name='slam' args='map.yaml'/></launch>",
        "README.md": f"# Demo\n## Usage\n```\n{page}\n```\n",
    }
    assert " ".join(decided(tmp_path, files).command) == command


def test_what_a_lone_program_needs_is_told(tmp_path: Path) -> None:
    files = {
        "CMakeLists.txt": "cmake_minimum_required(VERSION 3.10)\nproject(demo)\nadd_executable(slam slam.cpp)\n",
        "slam.cpp": MAIN.format("if (argc < 3) { return 1; } run(argv[1]);"),
        "README.md": "# Demo\n## Usage\n```\n./build/slam <map> <bag>\n```\n",
    }
    found = decided(tmp_path, files)
    assert found.command == ("slam",)
    ((message, file, line),) = [(w.message, w.file, w.line) for w in found.warnings if "stops without" in w.message]
    assert "2 arguments, which its program reads (argc < 3)" in message
    assert (file, line) == ("slam.cpp", 1)
