"""Values that a page gives for a name in its commands, and programs that only write another format."""

from __future__ import annotations

import shlex
from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
SCRIPT = "import argparse\nif __name__ == '__main__':\n    argparse.ArgumentParser().parse_args()\n"


@pytest.mark.parametrize(
    ("sentence", "value"),
    [
        ("Replace `METHOD` with one of `bc`, `ddpm`, or `iql`.", "bc"),
        ("Change `METHOD` to any of the following: `bc`, `iql`.", "bc"),
        ("`METHOD` can be one of ['bc', 'iql'].", "bc"),
        ("Replace `METHOD` with the name of yours.", "METHOD"),
        ("Replace `OTHER` with one of `bc`, `iql`.", "METHOD"),
    ],
)
def test_the_first_of_the_values_that_a_page_gives_for_a_name(tree: Tree, sentence: str, value: str) -> None:
    page = f"# Training\n{sentence}\n```\npython train.py --config configs/train.py:METHOD\n```\n"
    files = {"train.py": SCRIPT, "configs/train.py": "a = 1\n", "requirements.txt": "numpy\n", "README.md": page}
    assert tree(files).command == ("python", "train.py", "--config", f"configs/train.py:{value}")


def test_a_release_of_ros_is_weighed_with_all_that_the_tree_says(tree: Tree) -> None:
    page = "Replace `<distro>` with one of `jazzy`, `humble`.\n```\napt install ros-<distro>-xacro\n```\n"
    xml = "<package><name>demo</name><buildtool_depend>ament_cmake</buildtool_depend></package>"
    cmake = "project(demo)\nfind_package(ament_cmake)\n"
    workflow = (
        "jobs:\n  a:\n    container: ros:humble\n    runs-on: ubuntu-22.04\n    steps:\n      - run: colcon build\n"
    )
    files = {"package.xml": xml, "CMakeLists.txt": cmake, "README.md": page, ".github/workflows/a.yml": workflow}
    assert tree(files).ros_distro == "humble"


@pytest.mark.parametrize(
    ("name", "serves"),
    [
        ("raw_to_numpy", True), ("labelme2coco", True), ("bag_2_csv", True), ("data/frames_to_hdf5", True),
        ("move_to_goal", False), ("sim2real", False), ("image_to_scene", False),
    ],
)  # fmt: skip
def test_a_program_that_writes_another_format_is_not_the_one_that_is_meant(tree: Tree, name: str, serves: bool) -> None:
    page = f"# Usage\n```\npython {name}.py\n```\n```\npython drive.py\n```\n"
    files = {f"{name}.py": SCRIPT, "drive.py": SCRIPT, "requirements.txt": "numpy\n", "README.md": page}
    assert tree(files).command == ("python", "drive.py" if serves else f"{name}.py")


def test_a_page_that_went_to_a_folder_without_the_program_goes_nowhere(tree: Tree) -> None:
    page = "# Run\n```\ncd src/data\npython load_dataset.py\n```\n## Test\n```\npython test.py --cfg cfg/a.yaml\n```\n"
    files = {"src/data/load_dataset.py": SCRIPT, "src/test.py": SCRIPT, "src/cfg/a.yaml": "a: 1\n"}
    found = tree({**files, "requirements.txt": "numpy\n", "README.md": page})
    assert found.command == "cd src && exec python test.py --cfg cfg/a.yaml"


@pytest.mark.parametrize(
    ("block", "command"),
    [
        ("skip=0 # frames\ninsert=7\npython run.py out $skip ${insert}", "python run.py out 0 7"),
        ("name='long walk'\npython run.py --name \"$name\"", "python run.py --name 'long walk'"),
        ("data=/path/to/data\npython run.py $data", "python run.py"),
        ("```\n```\nskip=0\n```\n```\npython run.py $skip", "python run.py"),
        ("python run.py \u2014dir out \u2013n 3", "python run.py --dir out -n 3"),
    ],
)
def test_what_a_block_sets_before_it_runs_something(tree: Tree, block: str, command: str) -> None:
    files = {"run.py": "import numpy\n", "README.md": f"# Usage\n```\n{block}\n```\n"}
    assert tree(files).command == tuple(shlex.split(command))


@pytest.mark.parametrize(
    ("lines", "command"),
    [
        (
            "python run.py --map maps/map_{name}.yml\n# for example: python run.py --map maps/map_a.yml",
            "maps/map_a.yml",
        ),
        ("python run.py --map MAP_FILE  # e.g. python run.py --map maps/map_a.yml", "maps/map_a.yml"),
        ("python run.py --map maps/map_b.yml\n# for example: python run.py --map maps/map_a.yml", "maps/map_b.yml"),
        ("python run.py --map maps/map_{name}.yml\n# for example: python run.py --map /home/me/a.yml", ""),
        ("python run.py --map maps/map_{name}.yml\n# python run.py --map maps/map_a.yml", ""),
    ],
)
def test_a_remark_fills_in_the_command_above_it(tree: Tree, lines: str, command: str) -> None:
    page = f"# Demo\n## Usage\n```\n{lines}\n```\n"
    files = {"run.py": SCRIPT, "maps/map_a.yml": "", "maps/map_b.yml": "", "requirements.txt": "numpy\n"}
    assert tree({**files, "README.md": page}).command == ("python", "run.py", *(("--map", command) if command else ()))


@pytest.mark.parametrize(
    ("sentence", "program"),
    [
        ("- Train (**the data is not available now, it will be released later**)", "run.py"),
        ("Train. The data has not been released yet.", "run.py"),
        ("More data has not been released yet. Train with:", "train.py"),
        ("Train. If the data is not available, it is downloaded.", "train.py"),
    ],
)
def test_a_program_whose_data_is_not_published_is_not_the_one(tree: Tree, sentence: str, program: str) -> None:
    page = f"# Demo\n## Usage\n{sentence}\n```\npython train.py\n```\nThen\n```\npython run.py\n```\n"
    files = {"run.py": SCRIPT, "train.py": SCRIPT, "requirements.txt": "numpy\n", "README.md": page}
    assert tree(files).command == ("python", program)
