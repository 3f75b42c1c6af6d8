"""Includes, launch files, plugin names, vcs lists, and what names say."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.evidence.native import cpp
from roslab.evidence.ros import distro_names as names
from roslab.evidence.ros import launch, plugins, vcs
from roslab.knowledge.table import rows
from roslab.repository.checkout import Repository


def tree(tmp_path: Path, files: dict[str, str], branch: str | None = None) -> Repository:
    for path, text in files.items():
        target = tmp_path / path
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text(text, encoding="utf-8")
    return Repository.open(tmp_path, branch=branch)


def test_headers_of_the_tree_and_the_language_are_left_out(tmp_path: Path) -> None:
    repository = tree(
        tmp_path,
        {
            "include/demo/own.h": "",
            "src/a.cpp": '#include <vector>\n#include <stdio.h>\n#include "demo/own.h"\n#include <Eigen/Core>\n  #  include <ceres/ceres.h>\n',  # noqa: E501
            "third_party/x/b.cpp": "#include <other/thing.h>\n",
        },
    )
    assert [(d.name, d.line) for d in cpp.read(repository)] == [("Eigen/Core", 4), ("ceres/ceres.h", 5)]


def test_a_header_that_is_included_where_it_is_there_is_no_need(tmp_path: Path) -> None:
    code = (
        "#if __has_include(<mkl/mkl.h>)\n#include <mkl/mkl.h>\n#else\n#include <fftw3.h>\n#endif\n"
        "#if defined(A) && __has_include(<a/a.h>)\n#if B\n#include <a/a.h>\n#endif\n#endif\n"
        "#ifdef C\n#include <c/c.h>\n#endif\n"
    )
    files = {"a.cpp": code, "b.cpp": "#include <b/b.h>\n"}
    assert [(d.name, d.line) for d in cpp.read(tree(tmp_path, files))] == [("fftw3.h", 4), ("c/c.h", 12), ("b/b.h", 1)]
    files["b.cpp"] = "#include <mkl/mkl.h>\n"
    assert "mkl/mkl.h" in [d.name for d in cpp.read(tree(tmp_path, files))]


def test_a_header_of_another_systems_or_an_options_code_is_no_need(tmp_path: Path) -> None:
    code = (
        "#ifndef A_H\n#define A_H\n#include <sndfile.h>\n"
        "#ifdef USE_GNUTLS\n#include <gnutls/gnutls.h>\n#include <fftw3.h>\n#endif\n#endif\n"
    )
    assert [d.name for d in cpp.read(tree(tmp_path, {"a.h": code}))] == ["sndfile.h", "fftw3.h"]


@pytest.mark.parametrize("row", rows("includes"), ids=lambda row: row["header"])
def test_every_header_of_the_table_is_read(row: dict[str, str], tmp_path: Path) -> None:
    """``<armadillo>`` looks like the standard library's, ``linux/videodev2.h`` like the kernel's."""
    name = row["header"] + ("x.h" if row["header"].endswith("/") else "")
    found = cpp.read(
        tree(tmp_path, {"src/a.cpp": f"#include <{name}>\n#include <algorithm>\n#include <linux/can.h>\n"})
    )
    assert [d.name for d in found] == [name]


@pytest.mark.parametrize(
    ("path", "text", "expected", "ros"),
    [
        ("launch/a.launch", '<launch><!-- <node pkg="old"/> --><node pkg="map_server" type="x"/><include file="$(find demo_nav)/b.launch"/></launch>', {"map_server", "demo_nav"}, 1),  # noqa: E501
        ("launch/a.launch", '<launch><node pkg="nodelet" args="load depth_image_proc/point_cloud_xyz m"/></launch>', {"nodelet", "depth_image_proc"}, 1),  # noqa: E501
        ("launch/a.launch", '<launch><node pkg="nodelet" args="load pcl/CropBox m"/></launch>', {"nodelet", "pcl_ros"}, 1),  # noqa: E501
        ("launch/a.launch", '<launch><node pkg="nodelet" args="load pcl_filters/Crop m"/></launch>', {"nodelet", "pcl_filters"}, 1),  # noqa: E501
        ("launch/a.launch.xml", '<launch><node pkg="tf2_ros" exec="x"/><include file="$(find-pkg-share nav2_bringup)/l"/></launch>', {"tf2_ros", "nav2_bringup"}, 2),  # noqa: E501
        ("launch/a.launch.py", 'LaunchDescription([Node(package="rviz2", executable="rviz2")])\nFindPackageShare("ur_description")\n# package="no"\n', {"rviz2", "ur_description"}, 2),  # noqa: E501
        ("launch/b_launch.yaml", "launch:\n- node:\n    pkg: demo_nodes_cpp\n    exec: talker\n", {"demo_nodes_cpp"}, 2),  # noqa: E501
    ],
)  # fmt: skip
def test_packages_of_launch_files(tmp_path: Path, path: str, text: str, expected: set[str], ros: int) -> None:
    (found,) = launch.read(tree(tmp_path, {path: text, "package.xml": "<package><name>demo</name></package>"}))
    assert ({d.name for d in found.dependencies}, found.ros, found.package) == (expected, ros, "demo")


def test_the_condition_of_another_element_is_not_one_of_an_element_without_an_end_nearby(tmp_path: Path) -> None:
    text = f'<launch><node pkg="always" type="x" args="{"0 " * 300}"/><node pkg="sometimes" if="$(arg x)"/></launch>'
    (found,) = launch.read(tree(tmp_path, {"a.launch": text}))
    assert {each.name: each.strength for each in found.dependencies} == {"always": "used", "sometimes": "optional"}


def test_a_launch_file_with_rviz_has_windows(tmp_path: Path) -> None:
    (found,) = launch.read(tree(tmp_path, {"a.launch": '<launch><node pkg="rviz" type="rviz"/></launch>'}))
    assert found.gui


def test_plugins_of_parameter_files(tmp_path: Path) -> None:
    text = "base_local_planner: teb_local_planner/TebLocalPlannerROS\nplugins:\n  - {name: s, type: 'costmap_2d::StaticLayer'}\nx: a/B\n"  # noqa: E501
    solver = "#  kinematics_solver: own_ik/Plugin\narm:\n  kinematics_solver: trac_ik_kinematics_plugin/TRAC_IK\n"
    files = {"params/move_base.yaml": text, "config/kinematics.yaml": solver, "a.rviz": "Class: rviz/Grid"}
    found = plugins.read(tree(tmp_path, files))
    assert {d.name for d in found} == {"teb_local_planner", "costmap_2d", "rviz", "trac_ik_kinematics_plugin"}


@pytest.mark.parametrize(
    ("plugin", "found"),
    [
        ("dwb_core::DWBLocalPlanner", ["dwb_core", "dwb_critics", "dwb_plugins"]),
        (
            "nav2_regulated_pure_pursuit_controller::RegulatedPurePursuitController",
            ["nav2_regulated_pure_pursuit_controller"],
        ),
    ],
)
def test_plugins_that_a_plugin_loads_by_short_names(tmp_path: Path, plugin: str, found: list[str]) -> None:
    text = f'FollowPath:\n  plugin: "{plugin}"\n  critics: ["RotateToGoal", "PathAlign"]\n'
    assert [each.name for each in plugins.read(tree(tmp_path, {"a.yaml": text}))] == found


@pytest.mark.parametrize(
    ("path", "text"),
    [
        ("demo.repos", "repositories:\n  glim:\n    type: git\n    url: git@github.com:koide3/glim.git\n    version: v1.0\n"),  # noqa: E501
        ("install/deps.yaml", "repositories:\n  glim: {type: git, url: 'https://github.com/koide3/glim.git', version: v1.0}\n"),  # noqa: E501
        (".rosinstall", "- git: {local-name: glim, uri: 'ssh://git@github.com/koide3/glim.git', version: v1.0}\n"),
        ("p.repos", "repositories: {glim: {url: 'http://git.example.org/https://github.com/koide3/glim.git', version: v1.0}}\n"),  # noqa: E501
        ("q.repos", "repositories: {glim: {url: 'https://clone.example.org/github.com/koide3/glim.git', version: v1.0}}\n"),  # noqa: E501
        ("x_https.rosinstall", "- git:\n    local-name: glim\n    uri: git://github.com/koide3/glim.git\n    version: v1.0\n"),  # noqa: E501
    ],
)  # fmt: skip
def test_vcs_files_of_any_name_give_https(tmp_path: Path, path: str, text: str) -> None:
    (found,) = vcs.read(tree(tmp_path, {path: text}))
    assert (found.name, found.url, found.ref, found.kind) == (
        "glim",
        "https://github.com/koide3/glim.git",
        "v1.0",
        "vcs",
    )


@pytest.mark.parametrize(
    "text",
    [
        "repositories: null\n", "repositories:\n  a: 1\n", "", "- git: 3\n", "a: [", "repositories: {a: {url: x}}",
        "repositories: {a: {url: 'https://github.com/.git'}}", "repositories: {a: {url: 'git@github.com:lab/.git'}}",
    ],
)  # fmt: skip
def test_empty_and_broken_vcs_files_list_nothing(tmp_path: Path, text: str) -> None:
    assert vcs.read(tree(tmp_path, {"underlay.repos": text, "b": ""})) == ()


def test_submodules_of_the_root_only_and_relative_urls(tmp_path: Path) -> None:
    text = '[submodule "x"]\n\tpath = deps/x\n\turl = ../x.git\n'
    repository = tree(
        tmp_path,
        {
            ".gitmodules": text,
            "copied/.gitmodules": text,
            ".git/config": '[remote "origin"]\n url = git@github.com:lab/demo.git\n',
        },
    )
    (found,) = vcs.read(repository)
    assert (found.name, found.url, found.kind) == ("deps/x", "https://github.com/lab/x.git", "submodule")


def test_branches_and_file_names(tmp_path: Path) -> None:
    repository = tree(
        tmp_path,
        {"docker/Dockerfile.noetic": "", "demo.foxy.repos": "", "kinetic.md": "", "u.repos": "", "u.jazzy.repos": ""},
        branch="melodic-devel",
    )
    assert [(m.value, m.source) for m in names.read(repository)] == [
        ("melodic", "branch"),
        ("foxy", "filename"),
        ("noetic", "filename"),
    ]


def test_a_branch_for_a_ros_version(tmp_path: Path) -> None:
    assert [m.value for m in names.read(tree(tmp_path, {"a": ""}, branch="ros2"))] == ["ros2"]
