"""Trees from before package.xml: packages of rosbuild, their distribution, what builds them."""

from __future__ import annotations

import os
import subprocess
from pathlib import Path

import pytest

from roslab.config.model import Config
from roslab.decide import decide
from roslab.decide.decision import Decision
from roslab.evidence.gather import gather
from roslab.plan.plan import Plan, make_plan
from roslab.render.dockerfile import dockerfile
from roslab.repository.checkout import Repository
from trees import tree_of

CMAKE = (
    "include($ENV{ROS_ROOT}/core/rosbuild/rosbuild.cmake)\nrosbuild_init()\nrosbuild_add_executable(track src/a.cpp)\n"
)
MANIFEST = (
    '<package>\n<description brief="tracker">Tracks</description>\n<depend package="roscpp"/>\n'
    '<depend package="opencv2" />\n<rosdep name="eigen"/>\n</package>\n'
)


def decided(folder: Path, files: dict[str, str], branch: str | None = None) -> Decision:
    tree_of(folder, files)
    return decide(gather(Repository.open(folder, branch=branch)), Config(), folder_name="Tracker")


def planned(found: Decision) -> Plan:
    return make_plan(found, Config(), folder_name="Tracker")


def test_a_package_of_rosbuild_is_built_with_rosmake_under_its_own_name(tmp_path: Path) -> None:
    found = decided(tmp_path, {"manifest.xml": MANIFEST, "CMakeLists.txt": CMAKE, "README.md": "Tested in ROS Indigo"})
    assert (found.kind, found.ros_distro, found.build_tool) == ("ros1", "indigo", "rosmake")
    assert (found.packages, found.package_names) == (("manifest.xml",), ("tracker",))
    assert {"roscpp", "eigen"} <= set(found.rosdep)
    assert "libopencv-dev" in found.apt_guessed
    assert found.ended == ("opencv2",)
    plan = planned(found)
    assert plan.workspace.folder == "ws/src/tracker"
    text = dockerfile(plan)
    assert "rosmake-workspace --without=opencv2 tracker" in text
    assert "write-package-xml /tmp/manifests" in text
    assert 'source "/home/${NB_USER}/ws/setup.bash" --' in text
    assert "rosbuild's packages" not in "".join(warning.message for warning in found.warnings)


def test_what_a_makefile_of_rosbuild_clones_is_cloned_by_https(tmp_path: Path) -> None:
    makefile = "GIT_URL = git://github.com/lab/track.git\ninclude $(shell rospack find mk)/git_checkout.mk\n"
    found = decided(tmp_path, {"manifest.xml": MANIFEST, "CMakeLists.txt": CMAKE, "Makefile": makefile})
    assert {"git", "ca-certificates"} <= {*found.apt_guessed}
    assert "git://github.com/" in {upstream.name for upstream in planned(found).upstreams}


def test_a_package_of_rosbuild_whose_page_runs_cmake_alone_is_still_of_ros(tmp_path: Path) -> None:
    page = "# Installation\n\n    mkdir build\n    cd build\n    cmake ..\n    make\n"
    files = {
        "manifest.xml": MANIFEST,
        "CMakeLists.txt": f"project(tracker)\n{CMAKE}",
        "src/a.cpp": "#include <opencv2/core.hpp>\n",
        "README.md": page,
    }
    found = decided(tmp_path, files)
    assert (found.kind, found.build_tool, found.package_names) == ("ros1", "rosmake", ("tracker",))


def test_a_stack_is_the_packages_below_it_and_their_launch_files_are_commands(tmp_path: Path) -> None:
    files = {
        "stack.xml": '<stack><description brief="robot">A robot</description><depend stack="ros_comm"/></stack>',
        "CMakeLists.txt": "include($ENV{ROS_ROOT}/core/rosbuild/rosbuild.cmake)\nrosbuild_make_distribution(0.1.0)\n",
        "base/manifest.xml": '<package><depend package="rospy"/></package>',
        "base/launch/base.launch": "<launch/>",
        "vision/manifest.xml": '<package><depend package="base"/></package>',
        "vision/CMakeLists.txt": CMAKE,
        "vision/inner/manifest.xml": "<package/>",
        "README.md": "# Usage\n\n    roslaunch base base.launch\n",
    }
    found = decided(tmp_path, files)
    assert found.package_names == ("base", "vision")  # rospack does not look below a package
    assert found.rosdep == ("rospy",)
    assert found.command == ("roslaunch", "base", "base.launch")


def test_a_part_that_rosbuild_builds_leaves_the_rest_what_it_is(tmp_path: Path) -> None:
    files = {
        "CMakeLists.txt": "project(slam)\nadd_executable(mono mono.cc)\n",
        "mono.cc": "int main() {}\n",
        "Examples/ROS/slam/manifest.xml": MANIFEST,
        "Examples/ROS/slam/CMakeLists.txt": CMAKE,
    }
    found = decided(tmp_path, files)
    assert (found.kind, found.build_tool, found.package_names) == ("cpp", "cmake", ())


@pytest.mark.parametrize(
    ("said", "branch", "line"), [("Works with ROS Fuerte.", None, "README.md"), ("", "groovy-devel", ".git/HEAD")]
)
def test_what_never_had_an_image_means_the_next_distribution_that_has_one(
    tmp_path: Path, said: str, branch: str | None, line: str
) -> None:
    files = {"manifest.xml": MANIFEST, "CMakeLists.txt": CMAKE, "README.md": said}
    found = decided(tmp_path, files, branch)
    assert found.ros_distro == "indigo"
    told = [warning for warning in found.warnings if "has no official image" in warning.message]
    assert [warning.file for warning in told] == [line]
    assert not any("nothing says which ROS" in warning.message for warning in found.warnings)


def test_a_script_installs_packages_of_what_never_had_an_image(tmp_path: Path) -> None:
    script = "sudo apt-get install xterm ros-fuerte-camera-umd\n"
    found = decided(tmp_path, {"manifest.xml": MANIFEST, "CMakeLists.txt": CMAKE, "install.sh": script})
    assert found.ros_distro == "indigo"
    assert [w.file for w in found.warnings if "fuerte has no official image" in w.message] == ["install.sh"]


def test_the_plural_of_a_distribution_is_its_name(tmp_path: Path) -> None:
    package = "<package><name>a</name><buildtool_depend>catkin</buildtool_depend></package>"
    files = {"package.xml": package, "CMakeLists.txt": "project(a)\n", "README.md": "Needs ROS KINETICS on Ubuntu.\n"}
    assert decided(tmp_path, files).ros_distro == "kinetic"


def test_a_page_that_goes_into_a_folder_compiles_what_lies_there(tmp_path: Path) -> None:
    page = "Go into `Thirdparty/g2o/` and execute:\n\n\tmkdir build\n\tcd build\n\tcmake .. -DFAST=ON\n\tmake\n"
    files = {
        "manifest.xml": MANIFEST,
        "CMakeLists.txt": CMAKE,
        "Thirdparty/g2o/CMakeLists.txt": "project(g2o)\nadd_library(g2o a.cpp)\n",
        "README.md": page,
    }
    assert decided(tmp_path, files).inside == (("Thirdparty/g2o", "-DFAST=ON"),)


def test_rosdep_is_given_what_a_manifest_of_rosbuild_names(tmp_path: Path) -> None:
    (tmp_path / "tracker").mkdir()
    (tmp_path / "tracker/manifest.xml").write_text(MANIFEST, encoding="utf-8")
    script = Path(__file__).parents[3] / "scripts/roslab/render/image_scripts/write-package-xml.sh"
    subprocess.run(["bash", script, tmp_path], check=True, timeout=60)
    written = (tmp_path / "tracker/package.xml").read_text(encoding="utf-8")
    assert "<name>tracker</name>" in written
    assert not (tmp_path / "tracker/manifest.xml").exists()
    assert "<description/>" not in written  # rosdep stops at one that is empty, and at an address without a host
    assert 'email="nobody@example.org"' in written
    assert [line for line in written.splitlines() if line.startswith("<depend>")] == [
        "<depend>eigen</depend>",
        "<depend>opencv2</depend>",
        "<depend>roscpp</depend>",
    ]


def test_rosmake_is_shown_no_name_in_a_manifest_since_it_would_build_nothing(tmp_path: Path) -> None:
    (tmp_path / "src/tracker").mkdir(parents=True)
    manifest = tmp_path / "src/tracker/manifest.xml"
    manifest.write_text(MANIFEST.replace("<package>", "<package>\n  <name>\n    tracker\n  </name>"), encoding="utf-8")
    assert "<name>" in manifest.read_text(encoding="utf-8")
    programs = {
        "rosmake": "grep --recursive '<name>' src && exit 1; echo \"$@\" >called",
        "rospack": "echo /opt/mk",
        "compile-jobs": "echo 1",
    }
    for name, text in programs.items():
        (tmp_path / name).write_text(f"#!/bin/bash\n{text}\n", encoding="utf-8")
        (tmp_path / name).chmod(0o755)
    script = Path(__file__).parents[3] / "scripts/roslab/render/image_scripts/rosmake-workspace.sh"
    path = {"PATH": f"{tmp_path}:{os.environ['PATH']}", "ROS_PACKAGE_PATH": "/opt/ros"}
    subprocess.run(["bash", script, "tracker"], check=True, timeout=60, cwd=tmp_path, env=path)
    assert (tmp_path / "called").read_text(encoding="utf-8").split()[-1] == "tracker"
    written = manifest.read_text(encoding="utf-8")
    assert "roscpp" in written
    assert "tracker\n" not in written
