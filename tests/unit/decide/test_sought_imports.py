"""A module that a node imports and no table knows may be a package of the repository's owner."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
MANIFEST = (
    "<package format='2'><name>mapper</name><version>0.1.0</version><description>d</description>"
    "<maintainer email='a@b.c'>a</maintainer><license>MIT</license>"
    "<buildtool_depend>catkin</buildtool_depend>{}</package>"
)
CMAKE = "project(mapper)\nfind_package(catkin REQUIRED)\ncatkin_package()\n"
INSTALLED = "catkin_install_python(PROGRAMS\n  scripts/map.py\n  DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION}\n)\n"
LAUNCH = '<launch><node pkg="mapper" type="map.py" name="map"/></launch>\n'
GIT = {
    ".git/config": '[remote "origin"]\n\turl = https://github.com/lab/mapper.git\n',
    ".git/HEAD": "ref: refs/heads/main\n",
}
NODE = "#!/usr/bin/env python3\nimport rospy\n"
IMPORT = "from lab_converter.cloud import Cloud\n"


@pytest.mark.parametrize(
    ("files", "found"),
    [
        ({"CMakeLists.txt": CMAKE + INSTALLED, "scripts/map.py": NODE + IMPORT}, True),
        ({"launch/map.launch": LAUNCH, "scripts/map.py": NODE + IMPORT}, True),
        (
            {"launch/map.launch": LAUNCH, "scripts/map.py": NODE + "import parts\n", "scripts/parts.py": IMPORT},
            True,
        ),
        ({"scripts/map.py": NODE + IMPORT}, False),
        (
            {
                "launch/map.launch": LAUNCH,
                "scripts/map.py": f"{NODE}try:\n    {IMPORT}except ImportError:\n    a = 1\n",
            },
            False,
        ),
        ({"launch/map.launch": LAUNCH, "scripts/map.py": NODE + "import converter\n"}, False),
        ({"launch/map.launch": LAUNCH, "scripts/map.py": NODE + "import cv_bridge\n"}, False),
        ({"launch/map.launch": LAUNCH, "scripts/map.py": NODE + "import pytorch_lightning\n"}, False),
        (
            {
                "launch/map.launch": LAUNCH,
                "scripts/map.py": NODE + IMPORT,
                "package.xml": MANIFEST.format("<depend>lab_converter</depend>"),
            },
            False,
        ),
        (
            {
                "launch/map.launch": LAUNCH,
                "scripts/map.py": NODE + IMPORT,
                "README.md": "ROS Noetic\n```\npip install lab-converter\n```\n",
            },
            False,
        ),
    ],
)
def test_it_is_looked_for_with_the_owner(tree: Tree, files: dict[str, str], *, found: bool) -> None:
    base = {"package.xml": MANIFEST.format(""), "CMakeLists.txt": CMAKE, "README.md": "ROS Noetic\n"}
    decision = tree({**GIT, **base, **files})
    sought = [(s.repo, s.holding) for s in decision.source if s.holding]
    by_import = [r for r in decision.reasons if r.question == "source" and "nodes import" in r.reason]
    assert bool(by_import) == found
    if found:
        assert sought == [("https://github.com/lab/lab_converter.git", ("lab_converter",))]
        assert by_import[0].file in {"scripts/map.py", "scripts/parts.py"}


def test_nobody_is_the_owner_of_a_tree_without_an_origin(tree: Tree) -> None:
    files = {"package.xml": MANIFEST.format(""), "CMakeLists.txt": CMAKE + INSTALLED, "README.md": "ROS Noetic\n"}
    decision = tree({**files, "scripts/map.py": NODE + IMPORT})
    assert [s for s in decision.source if s.holding] == []


ROS2 = (
    "<package format='3'><name>mapper</name><version>0.1.0</version><description>d</description>"
    "<maintainer email='a@b.c'>a</maintainer><license>MIT</license><exec_depend>rclpy</exec_depend>"
    "<export><build_type>ament_python</build_type></export></package>"
)
SETUP = (
    "from setuptools import setup\nsetup(name='mapper', packages=['mapper'], "
    "entry_points={'console_scripts': ['map = mapper.map:main']})\n"
)
PYTHON = {"package.xml": ROS2, "setup.py": SETUP, "setup.cfg": "[install]\n", "mapper/__init__.py": "", **GIT}


@pytest.mark.parametrize(
    ("files", "repo"),
    [
        ({"mapper/map.py": "import rclpy\n" + IMPORT}, "https://github.com/lab/lab_converter.git"),
        (
            {"mapper/map.py": "import rclpy\nfrom mapper.parts import a\n", "mapper/parts.py": IMPORT},
            "https://github.com/lab/lab_converter.git",
        ),
        ({"mapper/map.py": "import rclpy\n", "mapper/parts.py": IMPORT}, None),  # no program imports it
        (
            {
                "setup.py": SETUP.replace(".map:", ".parts:"),
                "mapper/map.py": "import rclpy\n" + IMPORT,
                "mapper/parts.py": "",
            },
            None,
        ),
        (
            {"mapper/map.py": "import rclpy\n# https://github.com/acme/lab_converter/blob/main/cloud.py\n" + IMPORT},
            "https://github.com/acme/lab_converter.git",
        ),
        (
            {"mapper/map.py": "import rclpy\n# https://github.com/acme/other\n" + IMPORT},
            "https://github.com/lab/lab_converter.git",
        ),
    ],
)
def test_a_program_of_a_package_in_python_is_a_node(tree: Tree, files: dict[str, str], repo: str | None) -> None:
    decision = tree({**PYTHON, "README.md": "ROS Humble\n", **files})
    assert [(s.repo, s.holding) for s in decision.source] == ([(repo, ("lab_converter",))] if repo else [])


@pytest.mark.parametrize(("origin", "told"), [(True, True), (False, False)])
def test_what_no_table_knows_is_told_with_where_the_build_looks(tree: Tree, *, origin: bool, told: bool) -> None:
    files = {path: text for path, text in PYTHON.items() if origin or path != ".git/config"}
    decision = tree({**files, "README.md": "ROS Humble\n", "mapper/map.py": "import rclpy\n" + IMPORT})
    (said,) = [w.message for w in decision.warnings if "no table knows" in w.message]
    assert ("unless a repository of https://github.com/lab that is called like it, in which" in said) == told


@pytest.mark.parametrize(("distro", "ref"), [("Humble", "humble"), ("Jazzy", "jazzy"), ("Foxy", None)])
def test_a_table_knows_where_a_module_lies(tree: Tree, distro: str, ref: str | None) -> None:
    node = "import rclpy\nimport ros2_numpy\n"
    decision = tree({**PYTHON, "README.md": f"ROS 2 {distro}\n", "mapper/map.py": node})
    found = [(s.name, s.repo, s.ref) for s in decision.source if not s.holding]
    assert found == ([("ros2_numpy", "https://github.com/Box-Robotics/ros2_numpy.git", ref)] if ref else [])
    assert any("no table knows" in w.message for w in decision.warnings) == (ref is None)


@pytest.mark.parametrize(
    ("beside", "sought"),
    [
        ("lab_converter_flat.py", False),
        ("lab_converter.txt", True),
        ("lab_tools.py", True),
        ("lab_converter_tools/__init__.py", False),
        ("parts/lab_converter_flat.py", True),
    ],
)
def test_a_variant_of_what_lies_beside_it_is_a_lost_file(tree: Tree, beside: str, *, sought: bool) -> None:
    node = {"mapper/map.py": "import rclpy\n" + IMPORT, f"mapper/{beside}": ""}
    decision = tree({**PYTHON, "README.md": "ROS 2 Humble\n", **node})
    assert [s.name for s in decision.source] == ["lab_converter"] * sought
    told = [w for w in decision.warnings if "most likely it was not committed" in w.message]
    assert [(w.file, w.line) for w in told] == [("mapper/map.py", 2)] * (not sought)
    assert all("name the package under `pip` or its repository under `source`" in w.message for w in told)
    assert any("no table knows" in w.message for w in decision.warnings) == sought


@pytest.mark.parametrize("beside", ["lab_arm_node", "lab_arm_viewer"])
def test_one_of_a_family_of_packages_is_no_lost_file(tree: Tree, beside: str) -> None:
    node = {"mapper/map.py": "import rclpy\nimport lab_arm_sdk\n", f"mapper/{beside}.py": ""}
    decision = tree({**PYTHON, "README.md": "ROS 2 Humble\n", **node})
    assert not [w for w in decision.warnings if "not committed" in w.message]
    assert any("no table knows" in w.message and "lab_arm_sdk" in w.message for w in decision.warnings)
