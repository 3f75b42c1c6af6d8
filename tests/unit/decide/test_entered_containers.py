"""A script that only enters a container is no program, and a script of the shell is no node."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
ROS = {
    "demo/package.xml": "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend></package>",
    "demo/CMakeLists.txt": "project(demo)\nfind_package(catkin REQUIRED)\n",
    "run.py": "import rospy\nif __name__ == '__main__':\n    pass\n",
}
PYTHON = {"run.py": "import numpy\nif __name__ == '__main__':\n    pass\n", "requirements.txt": "numpy\n"}
PAGE = "ROS Noetic\n## Run\n```\npython3 run.py --world 0\n```\nIn a container:\n```\n./start.sh python3 run.py\n```\n"
ALONE = "## Run\n```\n./start.sh\n```\n"


@pytest.mark.parametrize(
    "script",
    [
        "singularity exec -i --nv -n --network=none -p -B `pwd`:/ws ${1} /bin/bash /ws/entrypoint.sh ${@:2}",
        "sudo apptainer run --nv image.sif",
        "exec apptainer shell image.sif",
        "docker run --rm demo python3 run.py",
    ],
)
def test_a_script_that_enters_a_container_starts_nothing(tree: Tree, script: str) -> None:
    decision = tree({**ROS, "README.md": PAGE, "start.sh": f"#!/bin/bash\n{script}\n"})
    assert decision.command == ("python3", "run.py", "--world", "0")
    assert not any("start.sh" in argv for argv in decision.command_candidates)


SENT = """HOST=robot.local
HERE="$(dirname "$(realpath "$0")")"
rsync -az --exclude=.git \\
  "$HERE/" "pi@${HOST}:/home/pi/demo/"
"""


@pytest.mark.parametrize(
    "script", [SENT, "scp -r src pi@robot.local:demo\n", 'ssh pi@robot.local "cd demo && python3 run.py"\n']
)
def test_a_script_that_sends_the_tree_elsewhere_starts_nothing(tree: Tree, script: str) -> None:
    page = "## Deploy\n```\n./start.sh\n```\n## Run\n```\npython3 run.py --world 0\n```\n"
    decision = tree({**PYTHON, "README.md": page, "start.sh": script})
    assert decision.command == ("python3", "run.py", "--world", "0")
    assert not any("start.sh" in argv for argv in decision.command_candidates)


def test_arrows_of_a_diagram_are_no_arguments(tree: Tree) -> None:
    page = "```mermaid\nclassDiagram\n  demo *-- server\n```\n## Run\n```\n./demo --fast\n```\n"
    cmake = "cmake_minimum_required(VERSION 3.5)\nproject(demo)\nadd_executable(demo main.cpp)\ninstall(TARGETS demo)\n"
    decision = tree({"CMakeLists.txt": cmake, "main.cpp": "int main() {}\n", "README.md": page})
    assert decision.command[-1] == "--fast"
    assert not any("server" in argv for argv in decision.command_candidates)


def test_other_scripts_start_something(tree: Tree) -> None:
    """Its name is in the messages of one, and the other looks whether it is inside."""
    fetched = "rsync -a host@robot.local:data/ data/\nCUDA_VISIBLE_DEVICES=$1 python3 run.py\n"
    for script in (
        "echo 'in singularity exec it'\npython3 run.py",
        'test -n "$SINGULARITY_NAME"\npython3 run.py',
        fetched,
        "scp host@robot.local:model.pt .\nmpirun -n 4 python3 run.py\n",
        "pip install -r requirements.txt\nPYTHONPATH=$(pwd) python3 run.py\n",
        "pip install -r requirements.txt\nXLA_FLAGS=--a=true DATA=~/data SIZE=${SIZE:-1} python3 run.py\n",
        'pip install -r requirements.txt\nPYTHONPATH="$(dirname $0)/..":$PYTHONPATH python3 run.py\n',
    ):
        assert tree({**PYTHON, "README.md": ALONE, "start.sh": script}).command == ("bash", "start.sh")


def test_python_beside_a_script_of_the_shell_is_no_less(tree: Tree) -> None:
    beside = {**ROS, "README.md": PAGE, "start.sh": "roscore\n"}
    assert tree(beside).command == ("python3", "run.py", "--world", "0")
    node = {"README.md": PAGE.replace("./start.sh python3 run.py", "rosrun demo node")}
    assert tree({**ROS, **node}).command == ("rosrun", "demo", "node")


@pytest.mark.parametrize("engine", ["docker run --rm", "singularity exec --nv", "apptainer run"])
def test_what_a_page_starts_in_a_container_is_the_program(tree: Tree, engine: str) -> None:
    page = f"## Run\n```\n{engine} demo.sif python3 run.py --fast\n```\n"
    assert tree({**PYTHON, "README.md": page}).command == ("python3", "run.py", "--fast")
