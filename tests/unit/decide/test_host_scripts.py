"""A script of the page that starts a container is for the host: what it starts inside is the command, if known."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
LAUNCH = "def generate_launch_description():\n    return LaunchDescription([])\n"
FILES = {
    "package.xml": "<package><name>demo</name><buildtool_depend>ament_cmake</buildtool_depend></package>",
    "CMakeLists.txt": "project(demo)\nfind_package(ament_cmake REQUIRED)\n",
    "launch/a.launch.py": LAUNCH,
    "launch/b.launch.py": LAUNCH,
    "Makefile": "sim-gui:\n\tros2 launch demo a.launch.py\n",
    "README.md": "# Demo\n## Run\n```\n./scripts/run_sim.sh\n```\n",
}
ROOT = 'root="$(dirname "$0")/.."\n'
CONTAINER = """#!/bin/bash
tty=(-i)
if [ -t 0 ]; then
  tty=(-it)
fi
docker run --rm "${tty[@]}" \\
  demo:latest bash -c "$setup" bash "$@"
"""


@pytest.mark.parametrize(
    ("script", "command"),
    [
        (f'{ROOT}exec "${{root}}/scripts/container.sh" make sim-gui\n', ("make", "sim-gui")),
        (
            f'{ROOT}"${{root}}/scripts/container.sh" ros2 launch demo b.launch.py\n',
            ("ros2", "launch", "demo", "b.launch.py"),
        ),
        (f'{ROOT}exec "${{root}}/scripts/container.sh" make fly\n', ("bash",)),
        (f'{ROOT}exec "${{root}}/scripts/container.sh" ./start\n', ("bash",)),
        ("docker run --rm -it demo ros2 launch demo b.launch.py\n", ("ros2", "launch", "demo", "b.launch.py")),
        ("xhost +\ndocker compose up\n", ("bash",)),
        ("docker run -d redis\nros2 launch demo b.launch.py\n", ("bash",)),
        ("ros2 launch demo b.launch.py\n", ("bash", "scripts/run_sim.sh")),
        ("ros2 launch demo b.launch.py\n./scripts/container.sh\n", ("bash", "scripts/run_sim.sh")),
    ],
)
def test_a_script_of_the_host_is_no_command(tree: Tree, script: str, command: tuple[str, ...]) -> None:
    files = {"scripts/run_sim.sh": f"#!/bin/bash\nset -e\n{script}", "scripts/container.sh": CONTAINER}
    assert tree(FILES | files).command == command


def test_the_next_command_of_the_page_comes_then(tree: Tree) -> None:
    page = "# Demo\n## Run\n```\n./scripts/run_sim.sh\nros2 launch demo b.launch.py\n```\n"
    files = {"scripts/run_sim.sh": "docker compose up\n", "README.md": page}
    assert tree(FILES | files).command == ("ros2", "launch", "demo", "b.launch.py")
