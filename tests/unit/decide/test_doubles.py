"""Packages of one name in several folders: a build tool stops at them, so that one of each is built."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from roslab.decide.decision import Decision
from roslab.pipeline import plan_repository
from roslab.render.dockerfile import dockerfile

Tree = Callable[[dict[str, str]], Decision]


def package(folder: str, name: str) -> dict[str, str]:
    xml = f"<package><name>{name}</name><buildtool_depend>catkin</buildtool_depend></package>"
    return {
        f"{folder}/package.xml": xml,
        f"{folder}/CMakeLists.txt": f"project({name})\nfind_package(catkin REQUIRED)\n",
    }


MAIN = package("play/main_ws/src/planner", "planner")
SWARM = package("play/a_ws/src/planner", "planner") | package("play/a_ws/src/map", "map")


@pytest.mark.parametrize(
    ("files", "built", "ignored"),
    [
        (MAIN | SWARM, ("play/main_ws/src/planner/package.xml",), ("play/a_ws",)),
        (package("test/ws/src/b", "b") | package("ros/src/a", "a"), ("ros/src/a/package.xml",), ("test/ws",)),
        (package("test/ws/src/b", "b"), ("test/ws/src/b/package.xml",), ()),
        (
            SWARM | package("play/b_ws/src/planner", "planner"),
            ("play/a_ws/src/map/package.xml", "play/a_ws/src/planner/package.xml"),
            ("play/b_ws",),
        ),
        (
            SWARM | package("play/b_ws/src/other", "other"),
            (*(f"play/a_ws/src/{name}/package.xml" for name in ("map", "planner")), "play/b_ws/src/other/package.xml"),
            (),
        ),
        (package("a", "map") | package("copy/a", "map"), ("a/package.xml",), ("copy/a",)),
        (package("a", "map") | package("a/inner", "map"), ("a/package.xml",), ()),
        (package("build/map", "map") | package("src/nav/map", "map"), ("src/nav/map/package.xml",), ("build/map",)),
        (package("build/map", "map"), ("build/map/package.xml",), ()),
    ],
)
def test_one_of_each_name_is_built(tree: Tree, files: dict[str, str], built: object, ignored: object) -> None:
    decision = tree(files)
    assert (decision.packages, decision.ignored) == (built, ignored)


def launch(folder: str, name: str = "map.launch") -> dict[str, str]:
    return {f"{folder}/launch/{name}": '<launch><node pkg="map" type="map" name="map"/></launch>'}


THREE = {
    path: text
    for name in ("a_ws", "b_ws", "c_ws")
    for path, text in (package(f"{name}/src/map", "map") | launch(f"{name}/src/map", f"{name}.launch")).items()
}
BOTH_HAVE_IT = launch("b_ws/src/map") | launch("c_ws/src/map")


@pytest.mark.parametrize(
    ("page", "built"),
    [
        ("roslaunch map c_ws.launch", "c_ws"),
        ("roslaunch map map.launch", "b_ws"),
        ("cd c_ws\nroslaunch map map.launch", "c_ws"),
        ("cd ~/demo/c_ws\ncatkin_make\nroslaunch map map.launch", "c_ws"),
        ("cd a_ws\nroslaunch map map.launch", "b_ws"),
        ("roslaunch map absent.launch", "a_ws"),
    ],
)
def test_the_workspace_that_a_page_starts_is_built(tree: Tree, page: str, built: str) -> None:
    decision = tree(THREE | BOTH_HAVE_IT | {"README.md": f"```\n{page}\n```\n"})
    assert decision.packages == (f"{built}/src/map/package.xml",)
    (told,) = [each.message for each in decision.warnings if each.message.startswith("not built: ")]
    assert all((f"{name}_ws" in told) == (name != built[0]) for name in "abc")
    started = {argv[2] for argv in decision.command_candidates if argv[0] == "roslaunch"}
    assert started == {f"{built}.launch"} | ({"map.launch"} if built != "a_ws" else set())


def test_the_copy_that_a_page_starts_is_built(tree: Tree) -> None:
    copies = package("a/map", "map") | package("b/map", "map") | launch("b/map")
    decision = tree(copies | {"README.md": "```\nroslaunch map map.launch\n```\n"})
    assert (decision.packages, decision.ignored) == (("b/map/package.xml",), ("a/map",))


def test_what_else_a_page_starts_leaves_the_others_as_they_are(tree: Tree) -> None:
    other = package("z_ws/src/arm", "arm") | launch("z_ws/src/arm", "arm.launch")
    decision = tree(MAIN | SWARM | other | {"README.md": "```\nroslaunch arm arm.launch\n```\n"})
    assert decision.packages == ("play/main_ws/src/planner/package.xml", "z_ws/src/arm/package.xml")


def test_tests_of_what_is_not_built_are_no_proof(tree: Tree) -> None:
    tests = {f"{name}_ws/tests/test_map.py": "def test_map():\n    assert True\n" for name in "abc"}
    decision = tree(THREE | tests)
    assert [test.file for test in decision.tests] == ["a_ws/tests/test_map.py"]


def test_the_tool_does_not_look_into_the_others(tmp_path: Path) -> None:
    for path, text in (MAIN | SWARM).items():
        target = tmp_path / path
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text(text, encoding="utf-8")
    text = dockerfile(plan_repository(tmp_path).plan)
    assert "/play/a_ws/CATKIN_IGNORE \\\n && " in text


AMENT = {
    "node_ros2/package.xml": (
        "<package><name>node_ros2</name><buildtool_depend>ament_cmake</buildtool_depend><depend>map_msgs</depend>"
        "<export><build_type>ament_cmake</build_type></export></package>"
    ),
    "node_ros2/CMakeLists.txt": "project(node_ros2)\nfind_package(ament_cmake REQUIRED)\n",
}
BOTH = {
    "lib/package.xml": (
        '<package format="3"><name>lib</name><buildtool_depend condition="$ROS_VERSION == 1">catkin</buildtool_depend>'
        '<buildtool_depend condition="$ROS_VERSION == 2">ament_cmake</buildtool_depend>'
        "<export><build_type>cmake</build_type></export></package>"
    ),
    "lib/CMakeLists.txt": "project(lib)\n",
}


def test_what_is_made_for_the_other_ros_alone_is_not_built(tree: Tree) -> None:
    decision = tree(package("node_ros1", "node_ros1") | AMENT | BOTH)
    assert decision.kind == "ros2"
    assert (decision.packages, decision.ignored) == (
        ("lib/package.xml", "node_ros2/package.xml"),
        ("node_ros1",),
    )
    assert not any("catkin" in warning.message for warning in decision.warnings)


def test_a_manifest_that_names_the_wrong_build_tool(tree: Tree) -> None:
    late = package("late", "late") | {"late/CMakeLists.txt": "project(late)\nfind_package(ament_cmake REQUIRED)\n"}
    decision = tree(late | AMENT | BOTH)
    assert (decision.kind, decision.ignored) == ("ros2", ())
    assert "late/package.xml" in decision.packages


def test_a_package_of_ros_1_is_built_with_ros_1(tree: Tree) -> None:
    more = package("node_ros1", "node_ros1") | package("a", "a") | package("b", "b")
    decision = tree(more | AMENT | BOTH | {"README.md": "Install ROS noetic.\n"})
    assert (decision.kind, decision.ignored) == ("ros1", ("node_ros2",))


def test_what_a_package_of_the_other_ros_looks_for_is_not_built(tree: Tree) -> None:
    ament = "<package><name>tools</name><buildtool_depend>ament_cmake</buildtool_depend></package>"
    page = "[odd](https://github.com/ros2/oddslam) and [odd_ros](https://github.com/ros2/odd_ros)\n"
    other = {
        "tools/package.xml": ament,
        "tools/CMakeLists.txt": "project(tools)\nfind_package(ament_cmake REQUIRED)\nfind_package(oddslam REQUIRED)\n",
        "tools/README.md": page,
    }
    own = package("a", "a") | package("b", "b")
    needs = own["a/package.xml"].replace("</package>", "<depend>odd_ros</depend></package>")
    found = tree(own | other | {"a/package.xml": needs, "README.md": "For ROS Noetic\n"})
    assert found.ros_distro == "noetic"
    assert found.source == ()
    found = tree(own | other | {"a/package.xml": needs, "README.md": f"For ROS Noetic\n{page}"})
    assert [source.name for source in found.source] == ["odd_ros"]
