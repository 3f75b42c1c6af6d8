"""Variables that the author's Dockerfile sets, where the image is made without it."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
ROS2 = {
    "package.xml": "<package><name>demo</name><export><build_type>ament_cmake</build_type></export></package>",
    "CMakeLists.txt": "project(demo)\nfind_package(ament_cmake REQUIRED)\n",
}
CYCLONE = "RMW_IMPLEMENTATION=rmw_cyclonedds_cpp"
APT = "RUN apt-get update && apt-get install -y ros-humble-rmw-cyclonedds-cpp\n"


def _set(tree: Tree, dockerfile: str, **more: str) -> dict[str, str]:
    given = {"docker/Dockerfile": f"FROM ros:humble\n{dockerfile}", **more}
    return dict(tree({**ROS2, **given}).variables)


@pytest.mark.parametrize(
    ("dockerfile", "there"),
    [
        ("ENV ROS_DOMAIN_ID=30 TURTLEBOT3_MODEL=burger\n", {"ROS_DOMAIN_ID": "30", "TURTLEBOT3_MODEL": "burger"}),
        ("ENV ROS_DOMAIN_ID 30\n", {"ROS_DOMAIN_ID": "30"}),
        ("ENV RMW_IMPLEMENTATION=rmw_fastrtps_cpp\n", {"RMW_IMPLEMENTATION": "rmw_fastrtps_cpp"}),
        (f"ENV {CYCLONE}\n", {}),
        (f"{APT}ENV {CYCLONE}\n", {"RMW_IMPLEMENTATION": "rmw_cyclonedds_cpp"}),
        ("ENV DISPLAY=:0 HOME=/root ROS_MASTER_URI=http://robot:11311 ROS_IP=10.0.0.2 API_KEY=abc\n", {}),
        ("ENV ROS_DOMAIN_ID=$DOMAIN\n", {}),
        ("FROM ubuntu:22.04 AS other\nENV ROS_DOMAIN_ID=3\nFROM ros:humble\n", {}),
    ],
)
def test_what_ros_reads(tree: Tree, dockerfile: str, there: dict[str, str]) -> None:
    assert _set(tree, dockerfile) == there


def test_what_the_tree_reads(tree: Tree) -> None:
    launch = {"launch/a.launch.py": "import os\nos.environ['GRIPPER']\n"}
    assert _set(tree, "ENV GRIPPER=soft OTHER=hard\n", **launch) == {"GRIPPER": "soft"}


@pytest.mark.parametrize(
    ("program", "there"),
    [
        ({"scripts/grip.py": "import os\nprint(os.getenv('GRIPPER'))\n"}, True),
        ({"src/grip.cpp": '#include <cstdlib>\nint main() { std::getenv("GRIPPER"); }\n'}, True),
        ({"scripts/grip.py": "print('GRIPPER')\n"}, False),
        (
            {"scripts/grip.py": "import os\nos.environ['GRIPPER']\n", "setup.py": "import os\nos.getenv('GRIPPER')\n"},
            False,
        ),
    ],
)
def test_what_programs_read(tree: Tree, program: dict[str, str], *, there: bool) -> None:
    assert _set(tree, "ENV GRIPPER=soft USER=root OMP_NUM_THREADS=4\n", **program) == (
        {"GRIPPER": "soft"} if there else {}
    )


def test_what_cmake_reads_is_a_switch_of_that_image(tree: Tree) -> None:
    switch = 'project(demo)\nif("$ENV{WITH_CUDA}" STREQUAL "ON")\nfind_package(CUDA REQUIRED)\nendif()\n'
    assert _set(tree, "ENV WITH_CUDA=ON CXX=clang++\n", **{"CMakeLists.txt": switch}) == {}


@pytest.mark.parametrize(
    ("ros", "middleware", "depends", "there"),
    [
        ("humble", "rmw_cyclonedds_cpp", "<depend>rmw_cyclonedds_cpp</depend>", True),
        ("humble", "rmw_cyclonedds_cpp", "", False),
        ("galactic", "rmw_cyclonedds_cpp", "", True),
        ("galactic", "rmw_fastrtps_cpp", "", False),
        ("noetic", "rmw_fastrtps_cpp", "", False),
    ],
)
def test_a_middleware_that_is_there(tree: Tree, ros: str, middleware: str, depends: str, *, there: bool) -> None:
    files = {
        "docker/Dockerfile": f"FROM ros:{ros}\nENV RMW_IMPLEMENTATION={middleware}\n",
        "package.xml": f"<package><name>demo</name>{depends}<buildtool_depend>ament_cmake</buildtool_depend></package>",
        "README.md": f"ROS {ros}\n",
    }
    if ros == "noetic":
        files["CMakeLists.txt"] = "project(demo)\nfind_package(catkin REQUIRED)\n"
        files["package.xml"] = "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend></package>"
    assert ("RMW_IMPLEMENTATION" in _set(tree, "", **files)) == there


def test_two_that_differ(tree: Tree) -> None:
    more = {"robot/Dockerfile": "FROM ros:humble\nENV ROS_DOMAIN_ID=7 TURTLEBOT3_MODEL=burger\n"}
    assert _set(tree, "ENV ROS_DOMAIN_ID=30\n", **more) == {"TURTLEBOT3_MODEL": "burger"}


def test_the_service_of_compose(tree: Tree) -> None:
    composed = "services:\n  a:\n    build:\n      context: .\n      dockerfile: docker/Dockerfile\n    environment:\n"
    composed += "      - ROS_DOMAIN_ID=${ROS_DOMAIN_ID:-12}\n      - DISPLAY=${DISPLAY}\n"
    more = {"docker-compose.yml": composed, "README.md": "```bash\ndocker compose up -d\n```\n"}
    assert _set(tree, "ENV ROS_DOMAIN_ID=30\n", **more) == {"ROS_DOMAIN_ID": "12"}


def test_a_name_of_no_variable(tree: Tree) -> None:
    composed = "services:\n  a:\n    build: {context: ., dockerfile: docker/Dockerfile}\n    environment:\n"
    composed += '      - "A(B=1"\n      - ROS_DOMAIN_ID=12\n'
    more = {"docker-compose.yml": composed, "README.md": "```bash\ndocker compose up -d\n```\n"}
    assert _set(tree, "", **more) == {"ROS_DOMAIN_ID": "12"}


def test_the_form_for_one_variable(tree: Tree) -> None:
    assert _set(tree, "ENV ROS_DOMAIN_ID 30\nENV NOTE see ROS_LOCALHOST_ONLY=1\n") == {"ROS_DOMAIN_ID": "30"}
