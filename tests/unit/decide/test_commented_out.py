"""Commands that a block of a page comments out are not the reader's."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]


@pytest.mark.parametrize(
    ("block", "installed"),
    [
        ("# pip install tqdm\npip install rich", {"rich"}),
        ("  # pip install tqdm\n  pip install rich", {"rich"}),
        ("# the progress\npip install tqdm", {"tqdm"}),
        ("# pip install tqdm\n# pip install rich", {"tqdm", "rich"}),  # the prompt of root
        ("# pip install tqdm\nCollecting tqdm", {"tqdm"}),
        ("pip install rich # pip install tqdm", {"rich"}),
        ("# pip install tqdm\n```\n```\npip install rich", {"tqdm", "rich"}),
    ],
)
def test_what_a_block_comments_out_is_not_installed(tree: Tree, block: str, installed: set[str]) -> None:
    python = tree({"a.py": "import numpy\n", "README.md": f"# Install\n```bash\n{block}\n```\n"}).python
    assert {each.key for each in (*python.pip, *python.pip_guessed)} == {"numpy", *installed}


@pytest.mark.parametrize("other", ["pip install torch==1.10.1+cpu", "pip install numpy"])
def test_a_pytorch_that_a_block_comments_out_tells_no_cuda(tree: Tree, other: str) -> None:
    page = f"# Install\n```bash\n# pip install torch==1.10.1\n{other}\n```\n"
    assert tree({"a.py": "import numpy\n", "README.md": page}).base_image.startswith("ubuntu:")


MESH = "<mesh filename='package://arm_description/meshes/a.dae'/>"


@pytest.mark.parametrize(
    ("said", "found"),
    [
        (MESH, True),
        (f"<!--collision>\n{MESH}\n</collision-->", False),
        (f"<!-- {MESH}", True),  # it is never closed
        (f"<!-- a --> {MESH} <!-- b -->", True),
    ],
)
def test_what_a_robot_description_comments_out_is_no_package(tree: Tree, said: str, found: bool) -> None:
    package = "<package><name>arm</name><buildtool_depend>catkin</buildtool_depend></package>"
    cmake = "project(arm)\nfind_package(catkin REQUIRED)\ncatkin_package()\n"
    decision = tree(
        {
            "README.md": "ROS Melodic\n",
            "package.xml": package,
            "CMakeLists.txt": cmake,
            "urdf/arm.xacro": f"<robot>{said}</robot>\n",
            "launch/arm.launch": "<launch><param name='r' command='xacro $(find arm)/urdf/arm.xacro'/></launch>\n",
            ".git/config": '[remote "origin"]\n\turl = https://github.com/lab/arm.git\n',
        }
    )
    assert any("arm_description" in source.holding for source in decision.source) == found
