"""A key that only package.xml names does no harm, and nobody needs a repository for it."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
MANIFEST = (
    "<package format='2'><name>demo</name><version>0.1.0</version><description>d</description>"
    "<maintainer email='a@b.c'>a</maintainer><license>MIT</license>"
    "<buildtool_depend>catkin</buildtool_depend><depend>vikit_ros</depend>{}</package>"
)
CMAKE = "project(demo)\nfind_package(catkin REQUIRED COMPONENTS roscpp{})\nadd_executable(demo src/demo.cpp)\n"
BASE = {
    "README.md": "ROS Noetic\n",
    "package.xml": MANIFEST.format(""),
    "CMakeLists.txt": CMAKE.format(""),
    "src/demo.cpp": "#include <ros/ros.h>\n",
}


@pytest.mark.parametrize(
    ("files", "harmless"),
    [
        ({}, True),
        ({"CMakeLists.txt": CMAKE.format(" # vikit_ros\n")}, True),
        ({"src/demo.cpp": "// #include <vikit_ros/output.h>\n/* vikit_ros */\n"}, True),
        ({"launch/a.launch": "<launch><!-- $(find vikit_ros) --></launch>\n"}, True),
        ({"package.xml": MANIFEST.format("<export><metapackage/></export>")}, False),
        ({"CMakeLists.txt": CMAKE.format(" vikit_ros")}, False),
        ({"CMakeLists.txt": CMAKE.format("") + "catkin_package(CATKIN_DEPENDS vikit_ros)\n"}, False),
        ({"CMakeLists.txt": "project(demo)\nfind_package(catkin_simple REQUIRED)\ncatkin_simple()\n"}, False),
        ({"src/demo.cpp": "#include <vikit_ros/output.h>\n"}, False),
        ({"scripts/a.py": "import vikit_ros\n"}, False),
        ({"scripts/a": "#!/usr/bin/env python3\nimport vikit_ros\n"}, False),
        ({"launch/a.launch": "<launch><include file='$(find vikit_ros)/a.launch'/></launch>\n"}, False),
        (
            {
                "package.xml": MANIFEST.format("").replace(
                    "<depend>vikit_ros</depend>", "<exec_depend>vikit_ros</exec_depend>"
                )
            },
            False,
        ),
        ({"worlds/a.world": "<plugin filename='libvikit_ros_camera.so'/>\n"}, False),
        ({"config/plugins.yaml": "plugin: vikit_ros/Camera\n"}, False),
    ],
)
def test_what_nothing_else_names(tree: Tree, files: dict[str, str], *, harmless: bool) -> None:
    told = [w.message for w in tree({**BASE, **files}).warnings if "vikit_ros" in w.message]
    assert [("does no harm" in message, "rpg_vikit" in message) for message in told if "no key" in message][:1] in (
        [[(True, False)]] if harmless else [[], [(False, True)], [(False, False)]]
    )


def test_of_several_one_thing_is_said(tree: Tree) -> None:
    more = MANIFEST.format("<depend>svo_plans_msgs</depend>")
    told = [w.message for w in tree({**BASE, "package.xml": more}).warnings if "no key" in w.message]
    said = (
        "rosdep has no keys svo_plans_msgs and vikit_ros for ROS noetic: nothing else of their packages names them, "
        "so that they do no harm; remove them there"
    )
    assert told == [said]


def test_what_one_package_uses_is_told_as_before(tree: Tree) -> None:
    other = {
        "other/package.xml": MANIFEST.format("").replace("demo", "other"),
        "other/CMakeLists.txt": CMAKE.format(" vikit_ros").replace("demo", "other"),
    }
    files = {f"demo/{path}": text for path, text in BASE.items() if path != "README.md"}
    decision = tree({"README.md": BASE["README.md"], **files, **other})
    assert not any("does no harm" in w.message for w in decision.warnings)


@pytest.mark.parametrize(
    ("code", "harmless"),
    [
        ("int last_bspline_phase;\n", True),
        ("#include <bspline/curve.h>\n", False),
        ("BsplineCurve curve;\n", False),
    ],
)
def test_a_name_of_one_word(tree: Tree, code: str, *, harmless: bool) -> None:
    more = MANIFEST.format("<depend>bspline</depend>")
    told = [
        w.message for w in tree({**BASE, "package.xml": more, "src/demo.cpp": code}).warnings if "no key" in w.message
    ]
    assert any("bspline" in message and "no harm" in message for message in told) == harmless
