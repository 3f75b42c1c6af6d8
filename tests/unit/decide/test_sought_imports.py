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
