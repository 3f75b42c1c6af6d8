"""ROS packages that are an extra of a Python program."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
XML = "<package><name>{}</name><buildtool_depend>catkin</buildtool_depend></package>"
SETUP = 'from setuptools import setup\nsetup(name="{}", packages=["{}"])\n'
RUNS = 'if __name__ == "__main__":\n    run()\n'


def _package(folder: str, name: str) -> dict[str, str]:
    return {f"{folder}/package.xml": XML.format(name), f"{folder}/CMakeLists.txt": f"project({name})\n"}


@pytest.mark.parametrize(
    ("page", "kind", "projects"),
    [
        ("cd $HOME/demo/meshes\npython setup.py develop\ncd ../grasps\npip install -e .", "cuda", ["grasps", "meshes"]),
        ("cd meshes && pip install -e .", "ros1", []),
        ("pip install -e meshes\npip install -e grasps\ncatkin_make", "ros1", []),
        ("pip install -e meshes\npip install -e grasps\nroslaunch grasps grasp.launch", "ros1", []),
    ],
)
def test_packages_that_a_page_has_pip_install(tree: Tree, page: str, kind: str, projects: list[str]) -> None:
    files = {**_package("meshes", "meshes"), **_package("grasps", "grasps"), "train.py": f"import torch\n{RUNS}"}
    for name in ("meshes", "grasps"):
        files |= {f"{name}/setup.py": SETUP.format(name, name), f"{name}/{name}/__init__.py": "import numpy\n"}
        files |= {f"{name}/{name}/a.py": "import scipy\n", f"{name}/{name}/b.py": "import scipy\n"}
    found = tree(files | {"README.md": f"## Install\n```\n{page}\n```\n"})
    assert (found.kind, sorted(found.python.projects)) == (kind, projects)


@pytest.mark.parametrize(
    ("page", "kind"),
    [
        ("python train.py --epochs 10", "cuda"),
        ("python train.py\nroslaunch nodes fly.launch", "ros1"),
        ("python train.py\ncatkin build", "ros1"),
        ("python drone/nodes/fly.py", "ros1"),
        ("python other.py", "ros1"),
    ],
)
def test_the_program_that_the_page_at_the_root_runs(tree: Tree, page: str, kind: str) -> None:
    files = {**_package("drone/nodes", "nodes"), "drone/README.md": "```\nroslaunch nodes fly.launch\n```\n"}
    files |= {"drone/nodes/fly.py": f"import rospy\n{RUNS}", "train.py": f"import torch\n{RUNS}"}
    files |= {"models.py": "import torch\n", "README.md": f"## Training\n```\n{page}\n```\n"}
    assert tree(files).kind == kind


def test_a_page_without_ros_takes_no_packages_from_it_that_are_most_of_the_code(tree: Tree) -> None:
    files = {
        **_package("nodes", "nodes"),
        "plot.py": f"import numpy\n{RUNS}",
        "README.md": "```\npython plot.py\n```\n",
    }
    files |= {f"nodes/{name}.py": "import rospy\n" for name in ("a", "b")}
    assert tree(files).kind == "ros1"


@pytest.mark.parametrize(
    ("page", "asked"),
    [
        ("```\npython train.py\n```\n", ["torch==1.8.*", "tqdm==4.60.*"]),
        ("```\nroslaunch nodes fly.launch\n```\n", ["torch==1.8.*"]),  # apt has the other
    ],
)
def test_versions_that_the_page_lists_beside_packages_of_ros(tree: Tree, page: str, asked: list[str]) -> None:
    files = {**_package("nodes", "nodes"), "train.py": f"import torch, tqdm\n{RUNS}", "models.py": "import torch\n"}
    found = tree(files | {"README.md": f"## Requirements\n- PyTorch 1.8\n- tqdm 4.60\n\n## Training\n{page}"})
    assert [each.written for each in (*found.python.pip, *found.python.pip_guessed)] == asked
