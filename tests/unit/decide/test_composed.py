"""The image that a page has Docker Compose build and start."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
PAGE = "# Demo\n## Run the simulation\n```\ndocker compose up --build\n```\n"
COMPOSE = """services:
  simulation:
    build:
      context: .
      dockerfile: Dockerfile.simulator
    ports:
      - "9090:9090"
    environment:
      - WORLD=${WORLD:-house}
      - DISPLAY=${DISPLAY:-:0}
      - ROS_MASTER_URI=http://localhost:11311
      - SIMULATION_API_TOKEN=abc
      - STORE=http://database:5432
  database:
    image: postgres
"""
SIMULATOR = "FROM ros:humble-ros-base\nCOPY . /ws/src/demo\nRUN cd /ws && colcon build\nCMD /ws/src/demo/start.sh\n"
PLAIN = "FROM ros:humble-ros-base\nCOPY . /ws/src/demo\nRUN cd /ws && colcon build\n"
FILES = {
    "package.xml": "<package><name>demo</name><buildtool_depend>ament_cmake</buildtool_depend></package>",
    "CMakeLists.txt": "project(demo)\nfind_package(ament_cmake REQUIRED)\n",
    "start.sh": "exec ros2 launch demo a.launch.py world:=$WORLD\n",
    "Dockerfile.simulator": SIMULATOR,
    "Dockerfile.robot": PLAIN,
    "docker-compose.yml": COMPOSE,
}


@pytest.mark.parametrize(
    ("page", "changed", "dockerfile"),
    [
        (PAGE, {}, "Dockerfile.simulator"),
        (PAGE.replace("docker compose", "docker-compose -f docker-compose.yml"), {}, "Dockerfile.simulator"),
        ("# Demo\n", {}, "Dockerfile.robot"),
        (PAGE, {"docker-compose.yml": "services:\n  a:\n    image: b\n"}, "Dockerfile.robot"),
        (PAGE, {"docker-compose.yml": COMPOSE.replace("simulator", "robot")}, "Dockerfile.robot"),
        (PAGE, {"docker-compose.yml": "services: [\n"}, "Dockerfile.robot"),
    ],
)
def test_the_dockerfile_of_compose_is_the_projects_whatever_its_name(
    tree: Tree, page: str, changed: dict[str, str], dockerfile: str
) -> None:
    assert tree(FILES | {"README.md": page} | changed).dockerfile == dockerfile


@pytest.mark.parametrize(
    ("page", "compose", "dockerfile"),
    [
        ("docs/guides/docker.md", "docker-compose.yml", "Dockerfile.simulator"),
        ("docker/README.md", "docker-compose.yml", "Dockerfile.simulator"),
        ("docker/README.md", "docker/compose.yaml", "Dockerfile.simulator"),
        ("docs/upkeep.md", "docker-compose.yml", "Dockerfile.robot"),
    ],
)
def test_a_page_about_containers_says_it_where_none_at_the_root_does(
    tree: Tree, page: str, compose: str, dockerfile: str
) -> None:
    files = {name: text for name, text in FILES.items() if name != "docker-compose.yml"}
    text = COMPOSE.replace("context: .", "context: ..") if "/" in compose else COMPOSE
    assert tree(files | {"README.md": "# Demo\n", page: PAGE, compose: text}).dockerfile == dockerfile


def test_of_two_files_of_compose_that_of_the_page_counts(tree: Tree) -> None:
    robot = COMPOSE.replace("simulator", "robot").replace("context: .", "context: ..")
    files = FILES | {"README.md": "# Demo\n", "docker/compose.yml": robot, "docker/README.md": PAGE}
    assert tree(files).dockerfile == "Dockerfile.robot"
    assert tree(files).ports == ("9090:9090",)


def test_a_container_gets_its_ports_and_variables(tree: Tree) -> None:
    decision = tree(FILES | {"README.md": PAGE})
    assert decision.command == ("env", "WORLD=house", "bash", "-c", "/ws/src/demo/start.sh")
    assert decision.ports == ("9090:9090",)
    assert decision.command_given


def test_the_command_of_compose_comes_before_that_of_the_dockerfile(tree: Tree) -> None:
    compose = COMPOSE.partition("    ports")[0] + "    command: ros2 launch demo b.launch.py\n"
    decision = tree(FILES | {"README.md": PAGE, "docker-compose.yml": compose})
    assert decision.command == ("ros2", "launch", "demo", "b.launch.py")
    assert decision.command_given


def test_a_command_that_only_waits_leaves_that_of_the_dockerfile(tree: Tree) -> None:
    compose = COMPOSE.partition("    ports")[0] + "    command: sleep infinity\n"
    decision = tree(FILES | {"README.md": PAGE, "docker-compose.yml": compose})
    assert decision.command == ("bash", "-c", "/ws/src/demo/start.sh")
    assert not decision.command_given


def test_of_two_services_with_one_dockerfile_none_tells_how_it_starts(tree: Tree) -> None:
    compose = COMPOSE + COMPOSE.partition("\n")[2].replace("simulation:", "other:").replace("house", "garden")
    decision = tree(FILES | {"README.md": PAGE, "docker-compose.yml": compose})
    assert decision.dockerfile == "Dockerfile.simulator"
    assert decision.command == ("bash", "-c", "/ws/src/demo/start.sh")
    assert not decision.ports


@pytest.mark.parametrize(
    ("calls", "world"),
    [
        ("docker compose up other", "garden"),
        ("docker compose build\ndocker compose up -d other", "garden"),
        ("docker compose run --rm simulation", "house"),
        ("docker compose up other  # no simulation", "garden"),
        ("docker compose -f gone.yml up\ndocker compose run other", "garden"),
        ("docker compose up other simulation", None),
        ("docker compose up", None),
        ("docker compose up\ndocker compose run other", None),
    ],
)
def test_of_several_services_that_counts_which_a_page_names(tree: Tree, calls: str, world: str | None) -> None:
    compose = COMPOSE + COMPOSE.partition("\n")[2].replace("simulation:", "other:").replace("house", "garden")
    page = f"# Demo\n## Run\n```\n{calls}\n```\n"
    command = tree(FILES | {"README.md": page, "docker-compose.yml": compose}).command
    assert command == (*(("env", f"WORLD={world}") if world else ()), "bash", "-c", "/ws/src/demo/start.sh")


def test_the_dockerfile_of_a_named_service_is_taken(tree: Tree) -> None:
    compose = COMPOSE + COMPOSE.partition("\n")[2].replace("simulation:", "robot:").replace("simulator", "robot")
    page = PAGE.replace("up --build", "up --build robot")
    assert tree(FILES | {"README.md": page, "docker-compose.yml": compose}).dockerfile == "Dockerfile.robot"


def test_packages_that_compose_starts_are_more_than_a_wrapper(tree: Tree) -> None:
    files = {f"ros/{name}": text for name, text in FILES.items() if name in {"package.xml", "CMakeLists.txt"}}
    files |= {"setup.py": "from setuptools import setup\nsetup(name='demo')\n", "demo/__init__.py": "import requests\n"}
    files |= {"Dockerfile.simulator": SIMULATOR.replace("COPY . /ws/src/demo", "COPY ros /ws/src/ros")}
    files |= {"docker-compose.yml": COMPOSE}
    assert tree(files).kind == "python"
    assert tree(files | {"README.md": PAGE}).kind == "ros2"


def test_what_a_recipe_of_make_starts_in_a_container_is_the_command(tree: Tree) -> None:
    launch = "def generate_launch_description():\n    return LaunchDescription([])\n"
    inside = (
        '\tdocker exec -it lab bash -c "source install/setup.bash; ros2 launch demo all.launch.py robot:=$(ROBOT)"\n'
    )
    files = {
        "package.xml": "<package><name>demo</name><buildtool_depend>ament_cmake</buildtool_depend></package>",
        "CMakeLists.txt": "project(demo)\nfind_package(ament_cmake REQUIRED)\n",
        "launch/all.launch.py": launch,
        "launch/some.launch.py": launch,
        "Makefile": f"ROBOT = 0\nbuild:\n\tdocker build . -t lab\nrun:\n\tdocker run -d lab\nsensors:\n{inside}",
        "README.md": "# Lab\n\nTo start sensors:\n\n```\nmake build\nmake run\nmake sensors\n```\n",
    }
    assert tree(files).command == ("ros2", "launch", "demo", "all.launch.py", "robot:=0")
