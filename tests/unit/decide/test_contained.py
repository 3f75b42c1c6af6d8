"""What a container of an author's Dockerfile starts where its source is mounted and pages run nothing."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
LAUNCH = "from launch import LaunchDescription\ndef generate_launch_description():\n    return LaunchDescription([])\n"
PACKAGE = "<package><name>demo</name><buildtool_depend>ament_cmake</buildtool_depend></package>"
ROS = {
    "sim/src/ws/demo/package.xml": PACKAGE,
    "sim/src/ws/demo/CMakeLists.txt": "project(demo)\nfind_package(ament_cmake REQUIRED)\n"
    "install(DIRECTORY launch DESTINATION share/demo)\nament_package()\n",
    "sim/src/ws/demo/launch/one.launch.py": LAUNCH,
    "sim/src/ws/demo/launch/two.launch.py": LAUNCH,
    "sim/src/launch/launch.py": LAUNCH,
}
DOCKER = 'FROM osrf/ros:humble-desktop\nCOPY ./entrypoint.sh /entrypoint.sh\nCMD [ "./entrypoint.sh" ]\n'
SCRIPT = "#!/bin/bash\nsource /app/src/ws/install/setup.bash\ncd /app/src\n\n{}\n"
WHOLE = "ros2 launch ./launch/launch.py"


@pytest.mark.parametrize(
    ("docker", "line", "command"),
    [
        (DOCKER, WHOLE, "ros2 launch sim/src/launch/launch.py"),
        (DOCKER, "exec ros2 launch /app/src/launch/launch.py", "ros2 launch sim/src/launch/launch.py"),
        (DOCKER, "ros2 launch demo two.launch.py", "ros2 launch demo two.launch.py"),
        (f"FROM osrf/ros:humble-desktop\nCMD cd /app/src && {WHOLE}\n", "", "ros2 launch sim/src/launch/launch.py"),
        (DOCKER, 'exec "$@"', "bash"),
        (DOCKER, "ros2 launch demo three.launch.py", "bash"),
        (DOCKER, "ros2 launch demo one.launch.py &\nros2 launch demo two.launch.py", "bash"),
        (DOCKER, "ros2 run rviz2 rviz2", "bash"),
        (DOCKER, "python3 /app/src/ws/demo/web.py", "bash"),
    ],
)
def test_the_start_of_a_container(tree: Tree, docker: str, line: str, command: str) -> None:
    web = {"sim/src/ws/demo/web.py": "if __name__ == '__main__':\n    pass\n"}
    found = tree({**ROS, **web, "sim/Dockerfile": docker, "sim/entrypoint.sh": SCRIPT.format(line)})
    assert " ".join(found.command) == command


def test_a_page_comes_before_it(tree: Tree) -> None:
    page = "# Demo\n## Usage\n```\nros2 launch demo two.launch.py\n```\n"
    found = tree({**ROS, "README.md": page, "sim/Dockerfile": DOCKER, "sim/entrypoint.sh": SCRIPT.format(WHOLE)})
    assert found.command == ("ros2", "launch", "demo", "two.launch.py")


def test_two_containers_that_start_different_programs_tell_nothing(tree: Tree) -> None:
    other = "FROM osrf/ros:humble-desktop\nCMD ros2 launch demo two.launch.py\n"
    files = {"sim/Dockerfile": DOCKER, "sim/entrypoint.sh": SCRIPT.format(WHOLE), "robot/Dockerfile": other}
    assert tree({**ROS, **files}).command == ("bash",)


def test_a_program_of_python(tree: Tree) -> None:
    program = "import numpy\nif __name__ == '__main__':\n    pass\n"
    docker = "FROM python:3.10\nRUN pip install numpy\nWORKDIR /work\nCMD python serve.py --port 80\n"
    found = tree({"one.py": program, "serve.py": program, "requirements.txt": "numpy\n", "Dockerfile": docker})
    assert found.dockerfile is None
    assert found.command == ("python", "serve.py", "--port", "80")


@pytest.mark.parametrize(
    ("end", "command"),
    [
        ("python prepare.py", "python prepare.py"),
        ('python prepare.py\nexec "$@"', "python3 main.py"),
        ("python prepare.py\nexec $@", "python3 main.py"),
    ],
)
def test_what_an_entry_script_does_before_the_command_only_prepares_it(tree: Tree, end: str, command: str) -> None:
    program = "import numpy\nif __name__ == '__main__':\n    print(1)\n"
    docker = (
        'FROM python:3.10\nRUN pip install numpy\nCOPY entry.sh /entry.sh\nENTRYPOINT ["/entry.sh"]\nCMD ["bash"]\n'
    )
    files = {"main.py": program, "prepare.py": "import numpy\nnumpy.zeros(1)\n", "README.md": "# Demo\n"}
    found = tree({**files, "Dockerfile": docker, "entry.sh": f"#!/bin/bash\nset -e\n{end}\n"})
    assert " ".join(found.command) == command
