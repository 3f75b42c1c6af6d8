"""With the author's Dockerfile, no package of the tree is started that none of its steps builds."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
PACKAGE = "<package format='3'><name>{}</name><export><build_type>ament_cmake</build_type></export></package>"
CMAKE = "project({0})\nfind_package(ament_cmake REQUIRED)\nadd_executable({0}_node a.cpp)\n"
FILES = {
    "ros2/first/package.xml": PACKAGE.format("first"),
    "ros2/first/CMakeLists.txt": CMAKE.format("first"),
    "ros2/second/package.xml": PACKAGE.format("second"),
    "ros2/second/CMakeLists.txt": CMAKE.format("second"),
    "ros2/README.md": "## Running\n\n```\nros2 run first first_node\n```\n",
    "README.md": "## Run\n\n```\n./scripts/all.sh\n```\n",
    "scripts/all.sh": "echo all\n",
    "scripts/build.sh": "cmake -B build .\n",
    "scripts/ros.sh": "# all of it\ncolcon build --symlink-install\n",
}
IMAGE = "FROM ros:humble\nCOPY . /project\n"
FIRST = ("ros2", "run", "first", "first_node")
WHOLE = "cd project && exec bash scripts/all.sh"


def nodes(decision: Decision) -> bool:
    return FIRST in decision.command_candidates


@pytest.mark.parametrize(
    ("step", "built"),
    [
        ("RUN cd /project && ./scripts/build.sh", False),
        ("RUN cd /project && ./scripts/ros.sh", True),
        ("RUN pip install -U colcon-common-extensions && cd /project && make", False),
        ("RUN cd /project && colcon \\\n  build", True),
        ("RUN cd /project && colcon build --packages-select second", False),
        ("RUN cd /project && colcon build --packages-select second first --symlink-install", True),
        ("RUN cd /project && colcon build --packages-up-to second", True),  # the first may be among those
        ("RUN cd /project/ros2/first && cmake . && make install", True),
        ("WORKDIR /project/ros2/first\nRUN cmake . && make install", True),
        ("RUN apt-get update && apt-get install -y ros-humble-first", True),
        ("RUN curl https://example.org/install | bash", True),  # what that does is not known
        ("RUN /opt/others/compile.sh", True),
        ("RUN . /opt/ros/humble/setup.sh && cmake --version", False),
    ],
)
def test_a_package_is_started_only_where_a_step_builds_it(tree: Tree, step: str, *, built: bool) -> None:
    decision = tree(FILES | {"Dockerfile": f"{IMAGE}{step}\n"})
    assert decision.dockerfile == "Dockerfile"
    assert nodes(decision) is built


def test_a_makefile_of_the_tree_may_build_the_workspace(tree: Tree) -> None:
    made = {"Makefile": "all:\n\tcolcon build\n", "Dockerfile": f"{IMAGE}RUN cd /project && make\n"}
    assert nodes(tree(FILES | made))


def test_a_base_that_somebody_made_may_have_the_package(tree: Tree) -> None:
    image = IMAGE.replace("ros:humble", "somebody/robot-humble:1.2")
    assert nodes(tree(FILES | {"Dockerfile": f"{image}RUN cd /project && ./scripts/build.sh\n"}))


@pytest.mark.parametrize("step", ["cd /project && ./scripts/build.sh", "cd /project && colcon build"])
def test_what_the_page_at_the_root_runs_comes_first_in_the_folder_of_the_image(tree: Tree, step: str) -> None:
    assert tree(FILES | {"Dockerfile": f"{IMAGE}RUN {step}\n"}).command == WHOLE


def test_what_a_container_starts_by_itself_goes_nowhere(tree: Tree) -> None:
    image = f'{IMAGE}RUN cd /project && colcon build\nCMD ["bash", "scripts/all.sh"]\n'
    assert tree(FILES | {"Dockerfile": image}).command == ("bash", "scripts/all.sh")
