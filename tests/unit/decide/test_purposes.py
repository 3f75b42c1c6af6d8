"""Words that say what a repository is there for, in the names of its programs."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
XML = (
    "<package><name>{}</name><version>1.0.0</version><description>d</description>"
    "<license>MIT</license><buildtool_depend>catkin</buildtool_depend></package>"
)
NODE = "#!/usr/bin/env python3\nimport rospy\nif __name__ == '__main__':\n    rospy.init_node('a')\n"


@pytest.mark.parametrize(
    ("package", "first", "second", "chosen"),
    [
        ("bag_recorder", "record", "fuse", "record"),
        ("path_plotter", "plot", "fuse", "plot"),
        ("map_converter", "convert", "fuse", "convert"),
        ("scene_reconstruction", "record", "fuse", "fuse"),
        ("convex_grasp", "convert", "grasp", "grasp"),
    ],
)
def test_a_helpers_name_counts_where_it_is_a_form_of_the_packages(
    tree: Tree, package: str, first: str, second: str, chosen: str
) -> None:
    page = f"ROS Noetic\n## Usage\n```\nrosrun {package} {first}.py\n```\n```\nrosrun {package} {second}.py\n```\n"
    cmake = "cmake_minimum_required(VERSION 3.0.2)\nproject(a)\nfind_package(catkin REQUIRED)\ncatkin_package()\n"
    nodes = {f"scripts/{name}.py": NODE for name in (first, second)}
    decision = tree({"package.xml": XML.format(package), "CMakeLists.txt": cmake, "README.md": page, **nodes})
    assert decision.command == ("rosrun", package, f"{chosen}.py")


@pytest.mark.parametrize(
    ("package", "command"),
    [
        ("torch_converter", "python3 scripts/slam_to_pcd.py --fast"),
        ("scene_conversion", "python3 scripts/slam_to_pcd.py --fast"),
        ("scene_grasp", "roslaunch scene_grasp a.launch"),
    ],
)
def test_what_writes_another_format_is_meant_in_a_converter(tree: Tree, package: str, command: str) -> None:
    files = {
        "package.xml": XML.format(package),
        "CMakeLists.txt": "cmake_minimum_required(VERSION 3.0.2)\nproject(a)\nfind_package(catkin REQUIRED)\n",
        "scripts/slam_to_pcd.py": "import numpy\nif __name__ == '__main__':\n    print(1)\n",
        "launch/a.launch": "<launch/>",
        "README.md": "ROS Noetic\n## Usage\n```\npython3 scripts/slam_to_pcd.py --fast\n```\n",
    }
    assert " ".join(tree(files).command) == command


@pytest.mark.parametrize(
    ("program", "title", "meant"),
    [
        ("generate_relevancy", "Multi-scale Relevancy Extractor", True),
        ("extract_meshes", "Meshes", True),
        ("generate_relevancy", "Usage", False),
        ("generate_relevancy", "Generate the relevancy", False),  # of which another section makes use
        ("generate_dataset", "Dataset", False),
        ("extract_features", "Features", False),
        ("generate_grasps", "Training with grasps", False),
        ("generate", "Relevancy", False),
    ],
)
def test_a_section_about_what_a_program_makes(tree: Tree, program: str, title: str, *, meant: bool) -> None:
    files = dict.fromkeys((f"{program}.py", "train.py"), "import numpy\nif __name__ == '__main__':\n    pass\n")
    page = f"# Demo\n## {title}\n```\npython {program}.py image\n```\n## Learning\n```\npython train.py\n```\n"
    found = tree({**files, "requirements.txt": "numpy\n", "README.md": page})
    assert found.command[:2] == ("python", f"{program if meant else 'train'}.py")
