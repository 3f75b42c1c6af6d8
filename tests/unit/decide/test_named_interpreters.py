"""A launch file that starts programs by a Python of the author's machine: a link there leads to the image's."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
VENV = "/home/somebody/venv/bin/python3"
NODES = "[Node(package='demo', executable='a.py', prefix='{}')]"
PYTHON = "from launch import LaunchDescription\ndef generate_launch_description():\n    return LaunchDescription({})\n"
YAML = (
    "launch:\n- arg:\n    name: python\n    default: {}\n"
    "- node:\n    pkg: demo\n    exec: a.py\n    launch-prefix: $(var python)\n"
)
XML = (
    '<launch><arg name="p" default="{}"/>'
    '<node pkg="demo" exec="a.py" type="a.py" name="a" launch-prefix="$(arg p)"/></launch>'
)


def package(ament: str) -> dict[str, str]:
    build = "<export><build_type>ament_cmake</build_type></export>" if ament == "ament_cmake" else ""
    return {
        "package.xml": f"<package><name>demo</name><buildtool_depend>{ament}</buildtool_depend>{build}</package>",
        "CMakeLists.txt": f"project(demo)\nfind_package({ament} REQUIRED)\n"
        "install(DIRECTORY launch DESTINATION share/demo)\n",
        "scripts/a.py": "print(1)\n",
    }


@pytest.mark.parametrize(
    ("name", "text", "linked"),
    [
        ("demo.launch.yaml", YAML.format(VENV), [VENV]),
        ("demo.launch.xml", XML.format(VENV), [VENV]),
        ("demo.launch.py", PYTHON.format(NODES.format(f"{VENV} -u")), [VENV]),
        ("demo.launch.py", PYTHON.format(f"[ExecuteProcess(cmd=['{VENV}', '-m', 'demo.a'])]"), [VENV]),
        (
            "demo.launch.py",
            PYTHON.format(NODES.format("/opt/venvs/gpu/bin/python3.10")),
            ["/opt/venvs/gpu/bin/python3.10"],
        ),
        ("demo.launch.py", f"# {VENV}\n" + PYTHON.format("[]"), []),
        ("demo.launch.py", PYTHON.format(NODES.format("/usr/bin/python3")), []),
        ("demo.launch.py", PYTHON.format(NODES.format("/usr/local/bin/python3")), []),
        ("demo.launch.py", PYTHON.format(NODES.format("/opt/conda/envs/a/bin/python")), []),
        ("demo.launch.py", PYTHON.format(NODES.format("~/venv/bin/python3")), []),
        ("demo.launch.py", PYTHON.format(NODES.format("/root/venv/bin/python3")), []),
        ("demo.launch.py", PYTHON.format(NODES.format("/home/me/venv/bin/python3/x")), []),
        ("demo.launch.py", PYTHON.format(NODES.format("/home/me/../venv/bin/python3")), []),
    ],
)
def test_it_is_linked_and_no_more_told(tree: Tree, name: str, text: str, linked: list[str]) -> None:
    page = f"ROS 2 Humble\n```\ncolcon build\nros2 launch demo {name}\n```\n"
    decision = tree({**package("ament_cmake"), f"launch/{name}": text, "README.md": page})
    assert decision.command == ("ros2", "launch", "demo", name)
    assert decision.interpreters == tuple((path, "python3") for path in linked)
    assert not any(VENV in warning.message for warning in decision.warnings)


def test_what_the_image_s_user_cannot_reach_is_told(tree: Tree) -> None:
    page = "ROS 2 Humble\n```\ncolcon build\nros2 launch demo demo.launch.yaml\n```\n"
    path = "/root/venv/bin/python3"
    decision = tree({**package("ament_cmake"), "launch/demo.launch.yaml": YAML.format(path), "README.md": page})
    assert not decision.interpreters
    assert [each.line for each in decision.warnings if path in each.message] == [4]


@pytest.mark.parametrize(
    ("page", "path", "meant"),
    [
        ("ROS Noetic\n", VENV, "python3"),
        ("ROS Melodic\n", "/home/somebody/anaconda2/bin/python", "python2"),
        ("ROS Melodic\n", VENV, ""),
    ],
)
def test_of_ros_1_it_is_the_distribution_s(tree: Tree, page: str, path: str, meant: str) -> None:
    files = {**package("catkin"), "launch/demo.launch": XML.replace("exec", "output").format(path), "README.md": page}
    assert tree(files).interpreters == (((path, meant),) if meant else ())


def test_none_is_made_where_the_tree_itself_is_linked(tree: Tree) -> None:
    inside = "/home/me/ws/src/demo"
    files = {**package("ament_cmake"), "config/a.yaml": f"file: {inside}/config/b.yaml\n", "config/b.yaml": "a: 1\n"}
    files["launch/demo.launch.yaml"] = YAML.format(f"{inside}/venv/bin/python3")
    decision = tree({**files, "README.md": "ROS 2 Humble\n"})
    assert [folder for folder, _ in decision.author_folders] == [inside]
    assert not decision.interpreters
