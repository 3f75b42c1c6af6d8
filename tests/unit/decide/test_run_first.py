"""Which line of a page a person would type first to run it: what comes before, beside and after it is not meant."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
MAIN = "import numpy\nif __name__ == '__main__':\n    print(1)\n"
PYTHON = dict.fromkeys(
    ("train.py", "play.py", "profile_net.py", "view_result.py", "reset_arms.sh", "demo/track.py", "demo/show.py"), MAIN
)
ROS = {
    "package.xml": "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend></package>",
    "CMakeLists.txt": "project(demo)\nfind_package(catkin REQUIRED)\n",
    "launch/map.launch": "<launch/>",
    "launch/replay.launch": "<launch/>",
    "scripts/create_udev_rules": "#!/bin/bash\nsudo cp demo.rules /etc/udev/rules.d\n",
}


@pytest.mark.parametrize(
    ("page", "command"),
    [
        (
            "# Usage\n```\npython train.py -n 3\npython play.py --net <net>\n```\n## More\n`python train.py -s`\n",
            "python train.py -n 3",
        ),
        (
            "# Usage\n```\npython play.py --net /path/to/net.pt\npython train.py --task walk\n```\n",
            "python play.py",
        ),
        ("```\npython train.py --task=walk --load_run log_file_path -n 3\n```\n", "python train.py --task=walk -n 3"),
        ("```\npython train.py --cfg=config_file --name demo\n```\n", "python train.py --name demo"),
        ("```\npython train.py map_file\n```\n", "python train.py map_file"),
        ("```\npython train.py CONFIG.yaml\n```\n", "python train.py"),
        ("```\npython play.py --train_arg_1 --arg2\npython train.py -n 3\n```\n", "python play.py"),
        ("```\npython train.py arg1 ARG_N\n```\n", "python train.py"),
        ("```\npython train.py --args 3 --options4all\n```\n", "python train.py --args 3 --options4all"),
        ("```\npython train.py --model MODEL.pth -n 3\n```\n", "python train.py -n 3"),
        ("```\npython train.py VIDEO.yaml -n 3\n```\n", "python train.py VIDEO.yaml -n 3"),
        ("# Run\nFor trouble: `sh reset_arms.sh`.\n```\npython train.py\n```\n", "python train.py"),
        ("# Start\n```\npython profile_net.py\n```\n# Example\n```\npython train.py\n```\n", "python train.py"),
        (
            "# Train\n```\npython train.py\n```\n# Watch others using yours\n```\npython play.py\n```\n",
            "python train.py",
        ),
        ("# Train\n```\npython train.py\n```\n# 2. Using it\n```\npython play.py\n```\n", "python play.py"),
        ("# Train\n```\npython train.py\n```\n# Using more cores\n```\npython play.py\n```\n", "python train.py"),
        ("# Train\n```\npython train.py\n```\n# Using\n```\npython play.py\n```\n", "python play.py"),
        ("# FAQs\n## Run it headless\n```\npython play.py\n```\n# Run\n`python train.py`\n", "python train.py"),
        ("# Known issues\nSlow? `python play.py -s`\n# Nets\n`python train.py`\n", "python train.py"),
        ("# Demo\n## From a pre-recorded film\n`python train.py`\n## Demo\n`python play.py`\n", "python train.py"),
        ("# Run\n## Sanity test\n`python play.py`\n## Run on your data\n`python train.py`\n", "python play.py"),
        ("# Demos\n```\npython view_result.py a.pth\npython train.py -n 3\n```\n", "python train.py -n 3"),
        ("1. `python train.py --config-name=train_*`\n```\npython train.py -n 3\n```\n", "python train.py -n 3"),
        ("`python train.py --root=DATA_ROOT --net NET_LOCATION`\n`python train.py -n 3`\n", "python train.py -n 3"),
        (
            "```\npython train.py --films=films/*.mp4\npython train.py -n 3\n```\n",
            "python train.py --films=films/*.mp4",
        ),
    ],
)
def test_the_first_program_of_python(tree: Tree, page: str, command: str) -> None:
    assert " ".join(tree({**PYTHON, "map_file": "", "VIDEO.yaml": "", "README.md": page}).command) == command


def test_a_page_below_says_it_where_the_root_has_a_remedy_alone(tree: Tree) -> None:
    pages = {
        "README.md": "# Troubleshooting\nWithout a display:\n```\nMUJOCO_GL=egl python play.py\n```\n",
        "nets/README.md": "# Run\n```\npython train.py -n 3\n```\n",
    }
    code = "open('configs/fast.yaml')\nif __name__ == '__main__':\n    pass\n"
    files = {f"nets/{name}.py": code for name in ("train", "play")}
    found = tree({**pages, **files, "nets/configs/fast.yaml": "", "requirements.txt": "numpy\n"}).command
    assert found == "cd nets && exec python train.py -n 3"


@pytest.mark.parametrize(
    ("page", "command"),
    [
        ("roslaunch roslaunch demo replay.launch\nroslaunch demo map.launch\n", "roslaunch demo replay.launch"),
        ("roslaunch demo map.launch bag:=bag_path fast:=true\n", "roslaunch demo map.launch fast:=true"),
        (
            "roslaunch demo map.launch image:=/camera/color/image_raw\nroslaunch demo replay.launch\n",
            "roslaunch demo map.launch image:=/camera/color/image_raw",
        ),
        ("roslaunch demo map.launch world:=/data/day\nroslaunch demo replay.launch\n", "roslaunch demo replay.launch"),
        ("./scripts/create_udev_rules\nroslaunch demo map.launch\n", "roslaunch demo map.launch"),
    ],
)
def test_the_first_launch_file(tree: Tree, page: str, command: str) -> None:
    assert " ".join(tree({**ROS, "README.md": page}).command) == command


def test_the_master_of_ros_that_an_image_starts_is_no_program_of_its_author(tree: Tree) -> None:
    dockerfile = 'FROM ros:noetic-ros-base\nCOPY . /ws/src/demo\nRUN cd /ws && catkin_make\nCMD ["roscore"]\n'
    found = tree({**ROS, "Dockerfile": dockerfile, "README.md": "```\nroslaunch demo map.launch\n```\n"})
    assert found.dockerfile == "Dockerfile"
    assert found.command == ("roslaunch", "demo", "map.launch")


def test_a_page_of_the_documentation_about_launching_it_is_read(tree: Tree) -> None:
    page = "Launching\n=========\n\n.. code-block:: bash\n\n    python3 train.py\n"
    found = tree({**PYTHON, "README.md": "# A planner\n", "docs/source/launching.rst": page})
    assert found.command == ("python3", "train.py")


@pytest.mark.parametrize(
    ("line", "command"),
    [
        ("python -m torch.distributed.launch --nproc_per_node 4 --use_env train.py -n 3", "python train.py -n 3"),
        ("python3 -m torch.distributed.run --nproc_per_node=4 -m net.fit -n 3", "python -m net.fit -n 3"),
        ("torchrun --nproc_per_node 4 --nnodes 1 train.py", "python train.py"),
        ("python -um net.fit -n 3", "python -m net.fit -n 3"),
        ("python -u -m net.fit -n 3", "python -m net.fit -n 3"),
        ("python3 -W ignore -X dev -OBm net.fit", "python3 -m net.fit"),
        ("python -mnet.fit -m 3", "python -m net.fit -m 3"),
        ("python -Wignore -B train.py -u -m 3", "python -Wignore -B train.py -u -m 3"),
        ("python -u make_stats.py\npython -W ignore train.py -n 3", "python -W ignore train.py -n 3"),
        ("python -u -m torch.distributed.launch --nproc_per_node 4 train.py", "python train.py"),
        ("python -i train.py", "python -i train.py"),
        ("conda run -n walk python train.py", "python train.py"),
        ("uv run --extra gpu walk -n 3", "walk -n 3"),
        ("poetry run walk", "walk"),
        ("pixi run -e gpu film -n 3", "python train.py -s -n 3"),
        ("./bin/go -n 3", "bash bin/go -n 3"),
        ("bin/watch", "python3 bin/watch"),
        ("python ./bin/watch --fast", "python bin/watch --fast"),
        ("./bin/data", "bash"),
        ("python train.py --gpu X -n N -s 1", "python train.py -s 1"),
        ("python train.py --seq XX -s 1", "python train.py -s 1"),
        ("python train.py --eval --net a.pt\npython play.py", "python play.py"),
        ("python train.py --test", "python train.py --test"),
        ("python make_stats.py\npython train.py", "python train.py"),
    ],
)
def test_what_a_line_starts_by_way_of_another_program(tree: Tree, line: str, command: str) -> None:
    files = {
        "pyproject.toml": "[project]\nname = 'net'\nversion = '1'\n[project.scripts]\nwalk = 'net.fit:main'\n"
        "[tool.setuptools]\npackages = ['net']\n",
        "pixi.toml": "[workspace]\nchannels = ['conda-forge']\n[dependencies]\npython = '3'\n"
        "[tasks]\nfilm = 'python train.py -s'\n",
        "net/__init__.py": "",
        "net/fit.py": MAIN,
        "make_stats.py": MAIN,
        "bin/go": "#!/usr/bin/env bash\npython train.py\n",
        "bin/watch": "#!/usr/bin/env python3\nimport numpy\n",
        "bin/data": "12 13\n",
    }
    assert " ".join(tree({**PYTHON, **files, "README.md": f"# Run\n```\n{line}\n```\n"}).command) == command


@pytest.mark.parametrize(
    ("lines", "command"),
    [
        ("./build.sh\n./run_kitti.sh data", "bash run_kitti.sh data"),
        ("./build.sh\n./build/align\n./run_kitti.sh data", "align"),
        ("./build.sh", "bash"),
        ("./align /data/kitti/XX", "align"),
    ],
)
def test_a_script_that_starts_what_is_compiled(tree: Tree, lines: str, command: str) -> None:
    files = {
        "CMakeLists.txt": "project(Align CXX)\nadd_executable(align a.cpp)\nadd_executable(fuse b.cpp)\n",
        **dict.fromkeys(("a.cpp", "b.cpp"), "int main() {}\n"),
        **dict.fromkeys(("build.sh", "run_kitti.sh"), "./build/align $1\n"),
    }
    assert " ".join(tree({**files, "README.md": f"# Run\n```\n{lines}\n```\n"}).command) == command


@pytest.mark.parametrize(
    ("line", "files", "command"),
    [
        ("PYTHONPATH=$PWD python arm/ui", {"arm/ui/__main__.py": "print(1)\n"}, ("python", "arm/ui")),
        ("python arm/ui/ --dark", {"arm/ui/__main__.py": "print(1)\n"}, ("python", "arm/ui", "--dark")),
        ("python arm/ui", {"arm/ui/view.py": "print(1)\n"}, ("python", "run.py")),
    ],
)
def test_a_folder_is_run_where_it_has_a_main(
    tree: Tree, line: str, files: dict[str, str], command: tuple[str, ...]
) -> None:
    page = f"# Run\n```\n{line}\n```\nor\n```\npython run.py\n```\n"
    main = "import numpy\nif __name__ == '__main__':\n    pass\n"
    assert tree({"README.md": page, "run.py": main, "requirements.txt": "numpy\n", **files}).command == command


@pytest.mark.parametrize(
    ("sentence", "first"),
    [
        ("Test your installation by running:", "demo_test"),
        ("After the workspace is built, source and run a demo:", "demo_test"),
        ("Run a demo on any of them. To test the planner, you can also run", "mapping"),
        ("The tests are here:", "mapping"),
    ],
)
def test_what_a_page_has_the_reader_try(tree: Tree, sentence: str, first: str) -> None:
    page = f"# Demo\n## Installation\n{sentence}\n```\nrosrun demo demo_test\n```\n"
    page += "## Usage\n```\nrosrun demo mapping\n```\n"
    cmake = (
        "project(demo)\nfind_package(catkin REQUIRED)\nadd_executable(demo_test a.cpp)\nadd_executable(mapping b.cpp)\n"
    )
    manifest = "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend></package>"
    found = tree({"README.md": page, "CMakeLists.txt": cmake, "package.xml": manifest, "a.cpp": "", "b.cpp": ""})
    assert found.command == ("rosrun", "demo", first)


@pytest.mark.parametrize(
    ("sentence", "first"),
    [
        ("5. Check the demo is available by running\n    - `python ./test.py`", "test.py"),
        ("5. Test the installation by running:\n\n`python ./test.py`", "test.py"),
        ("5. Verify that CUDA is available by running\n    - `python ./test.py`", "train.py"),
        ("5. Verify that it is available before you run the training:\n    - `python ./test.py`", "train.py"),
        ("5. Install it\n    - `python ./test.py`", "train.py"),
        ("5. Check the demo is available by running what `python ./test.py` tests", "train.py"),
    ],
)
def test_what_a_page_has_the_reader_try_in_a_line_of_code(tree: Tree, sentence: str, first: str) -> None:
    page = f"# Robot\n## Installation\n{sentence}\n## Usage\n```\npython train.py\n```\n"
    found = tree({"README.md": page, "train.py": MAIN, "test.py": MAIN, "requirements.txt": "numpy\n"})
    assert found.command[1] == first


@pytest.mark.parametrize(
    ("code", "call", "first"),
    [
        ("if __name__ == '__main__':\n    data = '/media/me/disk/data/'\n    print(data)\n", "", "other.py"),
        ("DATA = '/home/me/data'\nprint(DATA)\n", "", "other.py"),
        ("DATA = '/home/me/data'\nprint(DATA)\n", " --data maps", "main.py"),  # the page gives it another
        ("def tried():\n    data = '/home/me/data'\n    print(data)\nprint(1)\n", "", "main.py"),
        ("DATA = '/opt/demo/data'\nprint(DATA)\n", "", "main.py"),
    ],
)
def test_a_script_that_reads_its_authors_folder_comes_after_others(
    tree: Tree, code: str, call: str, first: str
) -> None:
    page = f"# Usage\n```\npython main.py{call}\npython other.py\n```\n"
    found = tree(
        {"README.md": page, "main.py": code, "other.py": MAIN, "maps/a.txt": "", "requirements.txt": "numpy\n"}
    )
    assert found.command[1] == first


@pytest.mark.parametrize(
    ("sentence", "dockerfile", "command"),
    [
        ("Test your installation by running:", "", ("python", "scripts/cage.py")),
        ("Test your installation by running:", "FROM ubuntu:24.04\nCOPY . /demo\nWORKDIR /demo\nRUN make\n", ("bash",)),
        ("There are scripts:", "", ("bash",)),
    ],
)
def test_a_python_program_beside_compiled_code(
    tree: Tree, sentence: str, dockerfile: str, command: tuple[str, ...]
) -> None:
    page = f"# Demo\n{sentence}\n```\npython scripts/cage.py\n```\n## Data\n```\npython scripts/to_json.py\n```\n"
    files = {"README.md": page, "CMakeLists.txt": "project(demo)\nadd_library(demo a.cpp)\n", "a.cpp": ""}
    files |= {"scripts/cage.py": MAIN, "scripts/to_json.py": MAIN, **({"Dockerfile": dockerfile} if dockerfile else {})}
    assert tree(files).command == command


@pytest.mark.parametrize(
    ("page", "started"),
    [
        ("doc/simulation.md", True),
        ("doc/gazebo_simulation.md", True),
        ("doc/simulations/notes.md", False),
        ("doc/about_simulation_results.md", False),
    ],
)
def test_a_page_of_the_documentation_on_the_simulation_starts_something(tree: Tree, page: str, started: bool) -> None:
    files = {
        **ROS,
        page: "# Simulation\n```\nroslaunch demo replay.launch\n```\n",
        "README.md": "# Demo of ROS Noetic\n",
    }
    assert (tree(files).command == ("roslaunch", "demo", "replay.launch")) is started
