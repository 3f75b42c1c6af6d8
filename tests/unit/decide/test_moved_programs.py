"""Programs that a page runs and that the package of Python which it names does not install."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]


def _package(name: str, entries: str) -> dict[str, str]:
    return {
        f"{name}/package.xml": f"<package format='3'><name>{name}</name><depend>rclpy</depend>"
        "<export><build_type>ament_python</build_type></export></package>",
        f"{name}/setup.py": f"from setuptools import setup\nsetup(name='{name}', packages=['{name}'], "
        f"data_files=[('share/{name}', ['package.xml'])], entry_points={{'console_scripts': {entries}}})\n",
        f"{name}/{name}/__init__.py": "",
        f"{name}/{name}/camera.py": "import rclpy\n\n\ndef main():\n    rclpy.init()\n",
        f"{name}/{name}/lens.py": "import rclpy\n\n\ndef main():\n    rclpy.init()\n",
    }


def _command(tree: Tree, page: str, **more: str) -> str:
    files = _package("eye", "['eye_node = eye.camera:main', 'lens = eye.lens:main']")
    files |= _package("arm", "['arm_node = arm.camera:main']")
    return " ".join(
        tree({**files, **more, "README.md": f"# Eye\nFor ROS Humble.\n## Usage\n```\n{page}\n```\n"}).command
    )


@pytest.mark.parametrize(
    ("page", "command"),
    [
        ("ros2 run eye eye_node", "ros2 run eye eye_node"),
        ("ros2 run eye arm_node --ros-args -p a:=1", "ros2 run arm arm_node --ros-args -p a:=1"),
        ("ros2 run eye camera", "ros2 run eye eye_node"),
        ("ros2 run eye camera.py", "ros2 run eye eye_node"),
        ("ros2 run eye eye_node.py", "ros2 run eye eye_node"),
        ("ros2 run eye eye_nod", "ros2 run eye eye_node"),
        ("ros2 run eye see_it\nros2 run eye lens", "ros2 run eye lens"),
    ],
)
def test_the_one_that_is_meant(tree: Tree, page: str, command: str) -> None:
    assert _command(tree, page) == command


@pytest.mark.parametrize(
    ("entries", "more"),
    [
        ("[f'{each} = eye.{each}:main' for each in listed()]", ""),
        ("['eye_node = eye.camera:main'] + others()", ""),
        ("['eye_node = eye.camera:main', *others()]", ""),
        ("['eye_node = eye.camera:main']", "('lib/eye', glob('scripts/*')), "),
        ("['eye_node = eye.camera:main']", "(os.path.join('lib', 'eye'), ['scripts/see_it']), "),
    ],
)
def test_what_setup_py_computes_or_puts_into_lib_may_be_any(tree: Tree, entries: str, more: str) -> None:
    setup = _package("eye", entries)["eye/setup.py"].replace("data_files=[", f"data_files=[{more}")
    page = "ros2 run eye see_it\nros2 run arm arm_node"
    assert _command(tree, page, **{"eye/setup.py": setup}) == "ros2 run eye see_it"


def test_a_package_that_cmake_builds_may_have_any(tree: Tree) -> None:
    more = {"eye/CMakeLists.txt": "project(eye)\nfind_package(ament_cmake REQUIRED)\nament_package()\n"}
    more["eye/package.xml"] = _package("eye", "[]")["eye/package.xml"].replace("ament_python", "ament_cmake")
    assert _command(tree, "ros2 run eye see_it\nros2 run arm arm_node", **more) == "ros2 run eye see_it"
