"""ROS repositories, decided from small trees: kind, distribution, base, tool, sources, packages."""

from __future__ import annotations

import shlex
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest

from roslab.config.model import Base, Config, Source
from roslab.decide import decide
from roslab.decide.decision import Decision
from roslab.errors import NothingToBuildError
from roslab.evidence.gather import gather
from roslab.plan.plan import make_plan
from roslab.repository.checkout import Repository
from roslab.values.origin import Place
from trees import tree_of

Tree = Callable[[dict[str, str]], Decision]
CATKIN = (
    "<package><name>{name}</name><buildtool_depend>catkin</buildtool_depend>"
    "<build_depend>roscpp</build_depend></package>"
)
AMENT = (
    '<package format="3"><name>{name}</name><buildtool_depend>ament_cmake</buildtool_depend><depend>rclcpp</depend>'
    "<export><build_type>ament_cmake</build_type></export></package>"
)
CMAKE = "project({name})\nfind_package(catkin REQUIRED)\n"


def decided(tmp_path: Path, files: dict[str, str], config: Config | None = None, branch: str | None = None) -> Decision:
    tree_of(tmp_path, files)
    evidence = gather(Repository.open(tmp_path, branch=branch))
    return decide(evidence, config or Config(), folder_name="demo")


def package(name: str = "demo", xml: str = CATKIN, folder: str = "") -> dict[str, str]:
    prefix = f"{folder}/" if folder else ""
    return {f"{prefix}package.xml": xml.format(name=name), f"{prefix}CMakeLists.txt": CMAKE.format(name=name)}


def test_catkin_is_ros1_and_the_default_is_said(tmp_path: Path) -> None:
    found = decided(tmp_path, package())
    assert (found.kind, found.ros_distro, found.ubuntu, found.base_image) == (
        "ros1",
        "noetic",
        "focal",
        "ros:noetic-ros-base",
    )
    assert (found.build_tool, found.workspace, found.packages) == ("catkin_make", "overlay", ("package.xml",))
    assert any("nothing says which ROS" in warning.message for warning in found.warnings)


def test_ament_is_ros2(tmp_path: Path) -> None:
    found = decided(tmp_path, package(xml=AMENT), branch="jazzy")
    assert (found.kind, found.ros_distro, found.build_tool, found.base_image) == (
        "ros2",
        "jazzy",
        "colcon",
        "ros:jazzy-ros-base",
    )


@pytest.mark.parametrize(
    ("files", "branch", "distro"),
    [
        ({"README.md": "Tested on Ubuntu 16.04 with ROS Kinetic"}, "melodic-devel", "melodic"),
        ({"README.md": "ROS kinetic kinetic kinetic kinetic", "Dockerfile": "FROM ros:melodic\nCOPY . /ws/src\n"}, None, "melodic"),  # noqa: E501
        ({"README.md": "Prerequisites: ROS Kinetic or Melodic"}, None, "melodic"),
        ({"README.md": "Tested with ROS Melodic. For Noetic see the noetic branch."}, None, "melodic"),
        ({"README.md": "Prerequisites: Ubuntu 18.04"}, None, "melodic"),
        ({"README.md": "    sudo apt install ros-kinetic-tf"}, None, "kinetic"),
        ({".github/workflows/ci.yml": "jobs:\n  a:\n    container: ros:kinetic-ros-base\n", "README.md": "ROS melodic"}, None, "kinetic"),  # noqa: E501
        ({"third_party/x/Dockerfile": "FROM ros:kinetic\n", "README.md": "needs ROS melodic"}, None, "melodic"),
        ({"README.md": "a video of the MIT bionic arm"}, None, "noetic"),
        ({"README.md": "[ROS Melodic](https://github.com/ros/ros/blob/noetic-devel/LICENSE)"}, None, "melodic"),
        ({"README.md": "On Ubuntu 20.04\n\nIt takes an [Image](http://docs.ros.org/en/melodic/api/sensor_msgs/msg.html)"}, None, "noetic"),  # noqa: E501
        ({"README.md": "Install [ROS](http://wiki.ros.org/kinetic/Installation) on Ubuntu"}, None, "kinetic"),
        ({"README.md": "See the [code](https://github.com/lab/ros-arm/tree/kinetic-devel)"}, None, "kinetic"),
    ],
)  # fmt: skip
def test_where_a_distribution_is_written_ranks_it(
    tmp_path: Path, files: dict[str, str], branch: str | None, distro: str
) -> None:
    found = decided(tmp_path, {**package(), **files}, branch=branch)
    assert found.ros_distro == distro
    (reason,) = [r for r in found.reasons if r.question == "ros_distro" and r.decisive]
    assert reason.answer == distro


def test_a_dockerfile_older_than_the_declared_keys_is_not_believed(tmp_path: Path) -> None:
    xml = AMENT.replace("<depend>rclcpp</depend>", "<depend>rclcpp</depend><depend>ros_gz_bridge</depend>")
    found = decided(
        tmp_path, {**package(xml=xml), "Dockerfile": "FROM ros:eloquent\nCOPY . /ws/src\n", "README.md": "ROS 2 jazzy"}
    )
    assert found.ros_distro == "jazzy"
    assert any("eloquent has no ros_gz_bridge" in reason.reason for reason in found.reasons)


@pytest.mark.parametrize(
    ("line", "distro"),
    [
        ("RUN apt-get install -y ros-eloquent-ros-gz-bridge", "eloquent"),
        ("RUN apt-get install -y ros-eloquent-ros-gz", "jazzy"),
    ],
)
def test_a_key_that_the_authors_apt_has_from_elsewhere_rules_nothing_out(
    tmp_path: Path, line: str, distro: str
) -> None:
    xml = AMENT.replace("<depend>rclcpp</depend>", "<depend>rclcpp</depend><depend>ros_gz_bridge</depend>")
    recipe = f"FROM ros:eloquent\n{line}\nCOPY . /ws/src\n"
    found = decided(tmp_path, {**package(xml=xml), "Dockerfile": recipe, "README.md": "ROS 2 jazzy"})
    assert found.ros_distro == distro


def test_a_family_of_images_is_a_list(tmp_path: Path) -> None:
    files = {
        f"docker/{name}/Dockerfile": f"FROM ros:{name}\nCOPY . /ws/src\n"
        for name in ("foxy", "galactic", "humble", "jazzy")
    }
    assert decided(tmp_path, {**package(xml=AMENT), **files}).ros_distro == "jazzy"


def test_the_development_branch_of_ros2_follows_rolling(tmp_path: Path) -> None:
    assert decided(tmp_path, package(xml=AMENT), branch="ros2").ros_distro == "rolling"


def test_configuration_wins_and_names_its_place(tmp_path: Path) -> None:
    config = Config(
        file="roslab.yaml",
        base=Base(ros="melodic-desktop-full"),
        build="catkin_tools",
        origins=(("base.ros", Place(file="roslab.yaml", line=3)),),
    )
    found = decided(tmp_path, package(), config, branch="noetic-devel")
    assert (found.ros_distro, found.base_image, found.build_tool) == ("melodic", "ros:melodic-ros-base", "catkin_tools")
    assert "ros-melodic-desktop-full" in found.apt
    (reason,) = [r for r in found.reasons if r.question == "ros_distro" and r.decisive]
    assert (reason.file, reason.line) == ("roslab.yaml", 3)
    assert [r.answer for r in found.reasons if r.question == "ros_distro" and not r.decisive] == ["noetic"]


def test_a_named_image_wins_over_everything(tmp_path: Path) -> None:
    found = decided(tmp_path, package(), Config(base=Base(image="lab/ros:melodic", ros="melodic")))
    assert (found.base_image, found.ubuntu, found.ros_distro) == ("lab/ros:melodic", "bionic", "melodic")


def test_a_repository_for_both_leans_to_its_branch(tmp_path: Path) -> None:
    both = (
        '<package format="3"><name>a</name><export><build_type condition="$ROS_VERSION == 1">catkin</build_type>'
        '<build_type condition="$ROS_VERSION == 2">ament_cmake</build_type></export></package>'
    )
    files = {"package.xml": both, "CMakeLists.txt": "project(a)\n"}
    assert decided(tmp_path, files, branch="noetic").kind == "ros1"
    assert decided(tmp_path, files, branch="humble").kind == "ros2"


def test_a_robots_description_makes_no_ros_repository(tmp_path: Path) -> None:
    files = {
        "assets/robot/package.xml": CATKIN.format(name="robot"),
        "setup.py": "from setuptools import setup\nsetup(name='x')\n",
    }
    assert decided(tmp_path, files).kind == "python"


@pytest.mark.parametrize(("tool", "kind"), [("ament_cmake", "ros2"), ("catkin", "ros1")])
def test_a_description_alone_is_of_the_ros_that_its_manifest_names(tmp_path: Path, tool: str, kind: str) -> None:
    export = f"<export><build_type>{tool}</build_type></export>"
    text = f'<package format="3"><name>robot</name><buildtool_depend>{tool}</buildtool_depend>{export}</package>'
    assert decided(tmp_path, {"package.xml": text}).kind == kind


LIBRARY = "from setuptools import setup\nsetup(name='demo', install_requires={})\n"
RUNS = "if __name__ == '__main__':\n    main()\n"


@pytest.mark.parametrize(
    ("page", "more", "kind"),
    [
        ("pip install .", {}, "python"),
        ("pip install -e .", {"tools/node.py": f"import rospy\n{RUNS}"}, "python"),
        ("catkin_make", {}, "ros1"),
        ("pip install .", {"setup.py": LIBRARY.format([])}, "ros1"),
        ("pip install .", {"CMakeLists.txt": CMAKE.format(name="demo") + "add_executable(a a.cpp)\n"}, "ros1"),
        ("pip install .", {"node.py": f"import rospy\n{RUNS}", "other.py": f"import rospy\n{RUNS}"}, "ros1"),
    ],
)
def test_a_package_at_the_root_of_a_python_library_makes_no_ros_repository(
    tmp_path: Path, page: str, more: dict[str, str], kind: str
) -> None:
    files = {
        "package.xml": CATKIN.format(name="demo"),
        "CMakeLists.txt": CMAKE.format(name="demo"),
        "setup.py": LIBRARY.format(["numpy"]),
        "README.md": f"```\n{page}\n```\n",
        "tools/train.py": f"import numpy\n{RUNS}",
        "tools/plan.py": f"import numpy\n{RUNS}",
    }
    assert decided(tmp_path, files | more).kind == kind


def test_a_wrapper_beside_a_python_program_makes_no_ros_repository(tmp_path: Path) -> None:
    files = {
        **package(folder="ros/wrapper"),
        "requirements.txt": "torch==1.7.1\n",
        "train.py": "import torch\n",
        "demo.py": "import numpy\n",
        "ros/wrapper/node.py": "import rospy\n",
    }
    assert decided(tmp_path, files).kind == "cuda"


def test_plain_cmake_with_a_package_xml_is_cpp(tmp_path: Path) -> None:
    xml = "<package format='3'><name>lib</name><export><build_type>cmake</build_type></export></package>"
    files = {
        "package.xml": xml,
        "CMakeLists.txt": "project(lib CXX)\nfind_package(Eigen3 REQUIRED)\n",
        "README.md": "Ubuntu 20.04",
    }
    found = decided(tmp_path, files)
    assert (found.kind, found.build_tool, found.base_image, found.apt) == (
        "cpp",
        "cmake",
        "ubuntu:20.04",
        ("libeigen3-dev",),
    )


def test_packages_inside_packages_and_below_markers_are_not_built(tmp_path: Path) -> None:
    files = {
        **package("a", folder="a"),
        **package("b", folder="a/test/b"),
        **package("c", folder="c"),
        "c/CATKIN_IGNORE": "",
    }
    found = decided(tmp_path, files)
    assert (found.packages, found.package_names) == (("a/package.xml",), ("a",))


def test_a_metapackage_is_built_but_rospack_cannot_find_it(tmp_path: Path) -> None:
    meta = "<package><name>all</name><export><metapackage/></export></package>"
    files = {**package("a", folder="a"), "all/package.xml": meta, "all/CMakeLists.txt": "catkin_metapackage()\n"}
    found = decided(tmp_path, files)
    assert (found.packages, found.package_names) == (("a/package.xml", "all/package.xml"), ("a",))


@pytest.mark.parametrize(
    ("line", "branch", "there"),
    [
        ("#!/usr/bin/env python", "noetic-devel", True),
        ("#!/usr/bin/python", "noetic-devel", True),
        ("#!/usr/bin/env python3", "noetic-devel", False),
        ("#!/usr/bin/env python", "melodic-devel", False),
    ],
)
def test_programs_that_start_python_find_one(tmp_path: Path, line: str, branch: str, there: bool) -> None:
    files = {**package("a"), "nodes/talk.py": line + "\nimport rospy\n"}
    assert ("python-is-python3" in decided(tmp_path, files, branch=branch).apt_guessed) is there


def test_a_repository_that_is_the_workspace(tmp_path: Path) -> None:
    assert decided(tmp_path, {**package("a", folder="src/a"), **package("b", folder="src/b")}).workspace == "root"


def test_a_workspace_that_catkin_make_refuses_is_a_folder_of_one(tmp_path: Path) -> None:
    files = {
        **package("a", folder="src/a"),
        "CMakeLists.txt": "cmake_minimum_required(VERSION 3.5)\nproject(library)\n",
    }
    assert decided(tmp_path, files).workspace == "overlay"


def test_plain_cmake_packages_need_catkin_tools(tmp_path: Path) -> None:
    xml = "<package format='2'><name>lib</name><export><build_type>cmake</build_type></export></package>"
    files = {**package("a", folder="a"), "lib/package.xml": xml, "lib/CMakeLists.txt": "project(lib)\n"}
    assert decided(tmp_path, files).build_tool == "catkin_tools"
    assert decided(tmp_path, {"README.md": "```\ncatkin_make\n```\n"}).build_tool == "catkin_make"


def test_packages_that_a_page_builds_one_by_one_are_built_so(tmp_path: Path) -> None:
    page = {"README.md": "```\ncatkin_make_isolated -DCMAKE_BUILD_TYPE=Release\n```\n"}
    assert decided(tmp_path, {**package("a", folder="a"), **page}).build_tool == "catkin_make_isolated"
    xml = "<package format='2'><name>lib</name><export><build_type>cmake</build_type></export></package>"
    plain = {"lib/package.xml": xml, "lib/CMakeLists.txt": "project(lib)\n"}
    found = decided(tmp_path, plain)
    assert (found.build_tool, found.package_names) == ("catkin_make_isolated", ("a",))
    (tmp_path / "lib/package.xml").unlink()
    both = {"README.md": f"{page['README.md']}Or\n```\ncatkin_make\n```\n"}
    assert decided(tmp_path, both).build_tool == "catkin_make"


def test_two_levels_of_trust(tmp_path: Path) -> None:
    files = {
        "package.xml": CATKIN.format(name="demo").replace(
            "<build_depend>", "<build_depend>tf</build_depend><build_depend>", 1
        ),
        "CMakeLists.txt": "project(demo)\nfind_package(catkin REQUIRED COMPONENTS roscpp cv_bridge)\nfind_package(Armadillo REQUIRED)\nfind_package(HDF5 QUIET)\n",  # noqa: E501
        "src/a.cpp": "#include <nlopt.hpp>\n#include <pcl_ros/point_cloud.h>\n",
        "launch/a.launch": '<launch><node pkg="map_server" type="map_server"/><node pkg="demo"/></launch>',
        "README.md": "```\nsudo apt-get install ros-YOUR_DISTRO-teb-local-planner libpcap-dev nvidia-driver-535\n```\n",
    }
    found = decided(tmp_path, files, branch="melodic")
    assert found.rosdep == ("catkin", "roscpp", "tf")
    assert found.apt == ("libarmadillo-dev",)
    assert {
        "ros-melodic-cv-bridge",
        "libhdf5-dev",
        "libnlopt-dev",
        "ros-melodic-pcl-ros",
        "ros-melodic-map-server",
        "libpcap-dev",
    } <= set(found.apt_guessed)
    assert not {"ros-melodic-demo", "nvidia-driver-535", "ros-melodic-roscpp"} & {*found.apt, *found.apt_guessed}


def test_a_key_that_is_a_librarys_name_is_translated_and_an_unknown_one_named(tmp_path: Path) -> None:
    xml = "<package>\n<name>demo</name><buildtool_depend>catkin</buildtool_depend>\n<build_depend>OpenCV</build_depend>\n<build_depend>sensors_msgs</build_depend></package>"  # noqa: E501
    found = decided(tmp_path, {"package.xml": xml, "CMakeLists.txt": CMAKE.format(name="demo")})
    assert ("OpenCV" in found.skip_keys, "OpenCV" in found.rosdep) == (True, False)
    assert "libopencv-dev" in found.apt_guessed
    warning = next(w for w in found.warnings if "sensors_msgs" in w.message)
    assert (warning.file, warning.line) == ("package.xml", 4)


def test_a_cloned_key_is_built_and_flagged(tmp_path: Path) -> None:
    xml = CATKIN.format(name="demo").replace("roscpp", "global_planner")
    readme = "```\ncd ~/ws/src\ngit clone -b v1.2 git@github.com:lab/global_planner.git\ngit clone https://github.com/lab/unrelated.git\n```\n"
    found = decided(tmp_path, {"package.xml": xml, "CMakeLists.txt": CMAKE.format(name="demo"), "README.md": readme})
    assert [(s.name, s.repo, s.ref) for s in found.source] == [
        ("global_planner", "https://github.com/lab/global_planner.git", "v1.2")
    ]
    assert "global_planner" in found.skip_keys
    assert any("another one" in warning.message for warning in found.warnings)


def test_vcs_files_for_the_distribution_without_the_repository_itself(tmp_path: Path) -> None:
    def listed(name: str, ref: str) -> str:
        return (
            f"repositories:\n  {name}: {{type: git, url: 'git@github.com:lab/{name}.git', version: {ref}}}\n"
            "  demo: {type: git, url: 'https://github.com/lab/demo.git', version: main}\n"
        )

    files = {**package("a", xml=AMENT), "demo.humble.repos": listed("x", "1.0"), "demo.foxy.repos": listed("y", "2.0")}
    found = decided(tmp_path, files, branch="humble")
    assert found.vcs == ("demo.humble.repos",)
    assert [(s.name, s.repo, s.ref, s.build) for s in found.source] == [
        ("x", "https://github.com/lab/x.git", "1.0", "colcon")
    ]


@pytest.mark.parametrize(
    ("distro", "xml", "there", "found"),
    [
        ("humble", AMENT, (".rosinstall_ros1", ".rosinstall_ros2"), (".rosinstall_ros2",)),
        ("noetic", CATKIN, (".rosinstall_ros1", ".rosinstall_ros2"), (".rosinstall_ros1",)),
        ("humble", AMENT, ("lab.repos", "lab_ros2.repos"), ("lab_ros2.repos",)),
        ("humble", AMENT, ("lab.repos", "arms-ros-2.repos"), ("arms-ros-2.repos", "lab.repos")),
        ("noetic", CATKIN, ("lab.repos", "lab_ros2.repos"), ("lab.repos",)),
        ("humble", AMENT, ("ros1_bridge.repos",), ("ros1_bridge.repos",)),
        ("humble", AMENT, ("ros1.repos",), ()),
    ],
)
def test_a_list_that_names_the_other_ros_is_of_another_workspace(
    tmp_path: Path, distro: str, xml: str, there: tuple[str, ...], found: tuple[str, ...]
) -> None:
    files = {**package("a", xml=xml), **{name: _sister(f"x{at}") for at, name in enumerate(there)}}
    files["setup.sh"] = "vcs import . < .rosinstall_ros2\n"
    files["README.md"] = "# Lab\n\n```bash\nvcs import ../ < .rosinstall_ros1\n```\n"
    assert decided(tmp_path, files, branch=distro).vcs == found


def test_of_lists_side_by_side_the_one_that_ci_builds_upstream_is_imported(tmp_path: Path) -> None:
    lists = {"lists/sim.repos": _sister("x"), "lists/sonar.repos": _sister("y")}
    files = {**package("a", xml=AMENT.replace("rclcpp", "some_unknown")), **lists}
    assert decided(tmp_path, files, branch="jazzy").vcs == ("lists/sim.repos", "lists/sonar.repos")
    ci = "on: push\nenv:\n  UPSTREAM_WORKSPACE: lists/sim.repos -c\njobs:\n  build:\n    runs-on: ubuntu-24.04\n"
    ci += "    steps:\n      - uses: ros-industrial/industrial_ci@master\n"
    assert decided(tmp_path, {".github/workflows/b.yml": ci}, branch="jazzy").vcs == ("lists/sim.repos",)


@pytest.mark.parametrize(
    ("distro", "name", "apt"),
    [
        ("jazzy", "gz-sim8", "ros-jazzy-gz-sim-vendor"),
        ("kilted", "gz-sim9", "ros-kilted-gz-sim-vendor"),
        ("humble", "ignition-gazebo6", "libignition-gazebo6-dev"),
        ("humble", "ignition-plugin1", "libignition-plugin-dev"),
    ],
)
def test_gazebos_libraries_have_their_version_in_their_name(tmp_path: Path, distro: str, name: str, apt: str) -> None:
    cmake = f"project(demo)\nfind_package(ament_cmake REQUIRED)\nfind_package({name} REQUIRED)\n"
    found = decided(tmp_path, {"package.xml": AMENT.format(name="demo"), "CMakeLists.txt": cmake}, branch=distro)
    assert apt in {*found.apt, *found.apt_guessed}
    assert not [warning.message for warning in found.warnings if name in warning.message]


def test_a_list_does_not_clone_what_the_tree_has_itself(tmp_path: Path) -> None:
    listed = "".join(
        f"- git: {{local-name: {name}, uri: 'https://github.com/lab/{name}.git'}}\n" for name in ("a", "b-b", "c")
    )
    files = {**package("a", folder="src/a"), **package("b_b", folder="src/more/b"), "src/more/x.rosinstall": listed}
    files["src/a/package.xml"] = CATKIN.format(name="a").replace("roscpp", "c")
    assert [source.name for source in decided(tmp_path, files).source] == ["c"]


UPSTREAM = (
    "on: push\njobs:\n  build:\n    uses: lab/ci/.github/workflows/b.yml@v1\n    with: {upstream_workspace: %s}\n"
)


@pytest.mark.parametrize(
    ("needed", "page", "found"),
    [
        ("rclcpp", "", ()),
        ("lab_x", "", ("sisters.repos",)),
        ("rclcpp", "```\nvcs import src < src/demo/sisters.repos\n```\n", ("sisters.repos",)),
    ],
)
def test_a_list_that_ci_alone_builds_is_needed_for_what_no_distribution_has(
    tmp_path: Path, needed: str, page: str, found: tuple[str, ...]
) -> None:
    files = {"sisters.repos": _sister("x"), ".github/workflows/b.yml": UPSTREAM % "sisters.repos"}
    manifest = AMENT.replace("rclcpp", needed)
    readme = {"README.md": f"ROS 2 Jazzy\n{page}"}
    assert decided(tmp_path, {**package(xml=manifest), **files, **readme}).vcs == found


def test_a_list_of_the_root_that_ci_builds_comes_before_one_that_a_page_below_names(tmp_path: Path) -> None:
    below = {"sim/README.md": "```\nwstool merge sim/more.rosinstall\n```\n", "sim/more.rosinstall": "[]\n"}
    for name, file in (("lab_x", "all.rosinstall"), ("lab_y", "sim/more.rosinstall")):
        below[file] = f"- git: {{local-name: {name}, uri: 'https://github.com/lab/{name}.git'}}\n"
    files = {
        **package(xml=CATKIN.replace("roscpp", "lab_x")),
        **below,
        ".github/workflows/b.yml": UPSTREAM % "all.rosinstall",
    }
    assert decided(tmp_path, files).vcs == ("all.rosinstall",)


def test_a_clone_into_the_folder_of_its_own_package_is_the_repository(tmp_path: Path) -> None:
    line = "cd ~/ws/src\ngit clone -b ros2 https://github.com/lab/former_name.git {}\n"
    for folder, names in (("demo", []), ("src/demo", []), ("lab_z", ["former_name"]), ("", ["former_name"])):
        files = {**package(xml=AMENT.replace("rclcpp", "lab_unknown")), "README.md": f"```\n{line.format(folder)}```\n"}
        assert [source.name for source in decided(tmp_path, files).source] == names


def test_packages_of_both_whose_build_type_is_named_for_ros_2_alone(tmp_path: Path) -> None:
    both = (
        '<package format="3"><name>{name}</name>'
        '<buildtool_depend condition="$ROS_VERSION == 1">catkin</buildtool_depend>'
        '<buildtool_depend condition="$ROS_VERSION == 2">ament_cmake</buildtool_depend>'
        '<export><build_type condition="$ROS_VERSION == 2">ament_cmake</build_type></export></package>'
    )
    files = {**package("a", xml=both, folder="a"), **package("b", folder="b")}
    assert decided(tmp_path, files).kind == "ros1"
    assert decided(tmp_path, package("b", xml=AMENT, folder="b")).kind == "ros2"
    assert decided(tmp_path, package("b", xml=both, folder="b")).kind == "ros2"


def test_a_cmakelists_beside_a_package_of_python_is_of_another_ros(tmp_path: Path) -> None:
    manifest = "<package format='3'><name>demo</name><export><build_type>ament_python</build_type></export></package>"
    files = {
        "package.xml": manifest,
        "setup.py": "from setuptools import setup\nsetup(name='demo')\n",
        "CMakeLists.txt": CMAKE.format(name="demo") + "find_package(CUDA REQUIRED)\nfind_package(xy REQUIRED)\n",
        "README.md": "ROS 2 Humble",
    }
    found = decided(tmp_path, files)
    assert (found.kind, found.apt_guessed, found.warnings) == ("ros2", (), ())
    both = manifest.replace("<build_type>", "<build_type condition='$ROS_VERSION == 1'>catkin</build_type><build_type>")
    assert "xy" in " ".join(warning.message for warning in decided(tmp_path, {"package.xml": both}).warnings)


def _sister(name: str) -> str:
    return f"repositories:\n  {name}: {{type: git, url: 'https://github.com/lab/{name}.git', version: main}}\n"


def test_a_list_that_ci_builds_downstream_names_who_needs_the_repository(tmp_path: Path) -> None:
    ci = "on: push\njobs:\n  build:\n    uses: lab/ci/.github/workflows/b.yml@v1\n    with:\n"
    ci += "      upstream_workspace: sisters.jazzy.repos\n      downstream_workspace: users.jazzy.repos\n"
    files = {"sisters.jazzy.repos": _sister("x"), "users.jazzy.repos": _sister("y"), ".github/workflows/b.yml": ci}
    needing = AMENT.replace("rclcpp", "lab_x")
    found = decided(tmp_path, {**package("a", xml=needing), **files}, branch="jazzy")
    assert found.vcs == ("sisters.jazzy.repos",)
    both = ci + "      extra: {upstream_workspace: users.jazzy.repos}\n"
    again = decided(tmp_path, {".github/workflows/b.yml": both}, branch="jazzy")
    assert again.vcs == ("sisters.jazzy.repos", "users.jazzy.repos")


@pytest.mark.parametrize(
    ("plain", "extra"),
    [("toolbox.repos", "tools.repos"), ("all.repos", "all_simulation.repos"), ("a.repos", "a-ci.repos")],
)
def test_a_list_for_tools_or_tests_is_known_by_whole_words(tmp_path: Path, plain: str, extra: str) -> None:
    files = {**package("a", xml=AMENT), plain: _sister("x"), extra: _sister("y")}
    assert decided(tmp_path, files, branch="jazzy").vcs == (plain,)


def test_the_repositorys_own_name_says_nothing_of_its_lists(tmp_path: Path) -> None:
    files = {
        **package("test_tools", xml=AMENT),
        "test_tools.repos": _sister("x"),
        "test_tools_extra.repos": _sister("y"),
    }
    assert decided(tmp_path, files, branch="jazzy").vcs == ("test_tools.repos",)


def test_the_repositorys_own_name_may_be_spelled_in_another_way(tmp_path: Path) -> None:
    page = "```\nvcs import src < arm_tools_alone.repos\n```\n"
    files = {
        **package("armtools", xml=AMENT),
        "arm_tools_alone.repos": _sister("x"),
        "build_depends.repos": _sister("y"),
        "README.md": page,
    }
    assert decided(tmp_path, files, branch="jazzy").vcs == ("arm_tools_alone.repos",)


def test_a_library_without_a_package_is_built_from_the_table(tmp_path: Path) -> None:
    files = {**package(), "CMakeLists.txt": CMAKE.format(name="demo") + "find_package(Pangolin REQUIRED)\n"}
    (source,) = decided(tmp_path, files).source
    assert (source.name, source.ref, source.build) == ("pangolin", "v0.6", "cmake")
    config = Config(source=(Source(name="pangolin", repo="https://example.org/mine.git", ref="v9"),))
    (mine,) = decided(tmp_path, files, config).source
    assert mine.ref == "v9"


def test_cuda_under_ros_starts_from_nvidia(tmp_path: Path) -> None:
    files = {
        **package(),
        "Dockerfile": "FROM nvidia/cuda:11.8.0-devel-ubuntu20.04\nRUN apt-get install -y ros-noetic-ros-base\nCOPY . /ws/src\n",  # noqa: E501
    }
    found = decided(tmp_path, files)
    assert (found.kind, found.ros_distro) == ("ros1", "noetic")
    assert found.base_image.startswith("nvidia/cuda:11.8")
    assert "ros-noetic-ros-base" in found.apt


@pytest.mark.parametrize(
    ("line", "names"),
    [
        ("ros-noetic-map-server*", {"ros-noetic-map-server"}),
        ("ros-melodic-velodyne-pcl*", {"ros-noetic-velodyne-pcl"}),
        ("'ros-$ROS_DISTRO-octomap-m*'", {"ros-noetic-octomap-mapping", "ros-noetic-octomap-msgs"}),
        ("ros-noetic-moveit*", {"ros-noetic-moveit"}),
        ("ros-noetic-nothing-of-it*", set()),
        ("ros-noetic-*", set()),
    ],
)
def test_packages_of_ros_that_a_page_names_by_a_pattern(tmp_path: Path, line: str, names: set[str]) -> None:
    page = f"ROS Noetic\n```\nsudo apt-get install {line}\n```\n"
    assert {*decided(tmp_path, {**package(), "README.md": page}).apt_guessed} == names


@pytest.mark.parametrize(
    ("launch", "apt"),
    [
        ('<launch><node pkg="demo" type="a" launch-prefix="xterm -e" /></launch>', ["xterm"]),
        ("<launch><node pkg='demo' type='a' launch-prefix='gdb -ex run --args'/></launch>", ["gdb"]),
        ('<launch><node pkg="demo" type="a" launch-prefix="nice" /></launch>', []),
        ('<launch><node if="$(arg d)" pkg="demo" type="a" launch-prefix="gdb --args" /></launch>', []),
        ('<launch><!-- <node pkg="demo" type="a" launch-prefix="xterm -e" /> --></launch>', []),
        ('<launch><node pkg="demo" type="a"> #launch-prefix="xterm -e"\n</node></launch>', []),
        ('<launch><node pkg="demo" type="a" args="a > b" launch-prefix="xterm -e" /></launch>', ["xterm"]),
    ],
)
def test_a_program_that_starts_a_node_in_its_place(tmp_path: Path, launch: str, apt: list[str]) -> None:
    def named(name: str) -> list[str]:
        files = {**package(), f"launch/{name}": launch, "README.md": "ROS noetic\n"}
        found = decided(tmp_path / name, files).apt_guessed
        return [each for each in found if not each.startswith("ros-")]

    assert named("a.launch") == apt
    assert named("a_gdb.launch") == []


@pytest.mark.parametrize(
    ("name", "launch", "apt"),
    [
        ("a.launch", "<launch><param name='a' command=\"xacro --inorder '$(arg b)'\"/></launch>", True),
        ("a.launch", "<launch>\n<param name='a'\n command='xacro.py a'/></launch>", True),
        ("a.launch", "<launch><param name='a' command='cat a.urdf'/></launch>", False),
        ("a.launch", "<launch><!-- <param name='a' command='xacro a'/> --></launch>", False),
        ("a.launch.xml", "<launch><let name='a' value=\"$(command 'xacro $(var b)')\"/></launch>", True),
        ("a.launch.py", 'LaunchDescription([Command(["xacro ", path])])', True),
        ("a.launch.py", 'LaunchDescription([Command([FindExecutable(name="xacro"), " ", path])])', True),
    ],
)
def test_a_program_that_makes_a_parameter(tmp_path: Path, name: str, launch: str, *, apt: bool) -> None:
    xml, distro = (AMENT, "humble") if name != "a.launch" else (CATKIN, "noetic")
    files = {**package(xml=xml), f"launch/{name}": launch, "README.md": f"ROS {distro}\n"}
    assert (f"ros-{distro}-xacro" in decided(tmp_path, files).apt_guessed) is apt


@pytest.mark.parametrize(
    ("script", "apt"),
    [
        ("x-terminal-emulator -e roslaunch demo a.launch &\nroslaunch demo b.launch\n", ["xterm"]),
        ("# x-terminal-emulator -e roslaunch demo a.launch &\nroslaunch demo b.launch\n", []),
    ],
)
def test_a_terminal_that_a_script_of_the_page_opens(tmp_path: Path, script: str, apt: list[str]) -> None:
    page = "ROS noetic\n```\n./start.sh\n```\n"
    found = decided(tmp_path, {**package(), "start.sh": script, "README.md": page})
    assert [name for name in found.apt_guessed if not name.startswith("ros-")] == apt


CUDA = "nvidia-cuda-toolkit"
GPU = "option(WITH_GPU 'a' OFF)\n"


@pytest.mark.parametrize(
    ("cmake", "asked"),
    [
        ("find_package(CUDA REQUIRED)\n", True),
        ("enable_language(CUDA)\n", True),
        ("find_package(CUDA)\n", False),
        ("if(WITH_GPU)\n  find_package(CUDA REQUIRED)\nendif()\n", False),
        (f"{GPU}if(WITH_GPU)\n  cuda_add_library(a a.cu)\nendif()\n", False),
        (f"{GPU}if(WITH_GPU)\n  enable_language(CUDA)\nendif()\n", False),
        (f"{GPU}if(WITH_GPU AND UNIX)\n  enable_language(CUDA)\nendif()\n", False),
        (f"{GPU}if(NOT WITH_GPU)\nelse()\n  enable_language(CUDA)\nendif()\n", False),
        (f"{GPU}if(NOT WITH_GPU)\n  enable_language(CUDA)\nendif()\n", True),
        (f"{GPU}set(WITH_GPU ON)\nif(WITH_GPU)\n  enable_language(CUDA)\nendif()\n", True),
        ("option(WITH_GPU 'a' ON)\nif(WITH_GPU)\n  enable_language(CUDA)\nendif()\n", True),
    ],
)
def test_cuda_that_a_package_of_ros_cannot_do_without(tmp_path: Path, cmake: str, asked: bool) -> None:
    made = "cmake_minimum_required(VERSION 3.8)\nproject(demo)\nfind_package(catkin REQUIRED)\n"
    files = {**package(), "CMakeLists.txt": made + cmake, "README.md": "ROS noetic\n"}
    found = decided(tmp_path, files)
    assert (CUDA in (*found.apt, *found.apt_guessed)) == asked
    assert (CUDA in found.apt) == (asked and "if(" not in cmake)
    assert found.gpu == asked
    files["Dockerfile"] = "FROM nvidia/cuda:11.8.0-devel-ubuntu20.04\nRUN apt-get install -y ros-noetic-ros-base\n"
    found = decided(tmp_path, files)
    assert CUDA not in (*found.apt, *found.apt_guessed)


@pytest.mark.parametrize(
    ("page", "asked"),
    [
        ("catkin_make -DWITH_GPU=ON", True),
        ("catkin_make\n```\nOn a GPU:\n```\ncatkin_make -DWITH_GPU=ON", False),
    ],
)
def test_cuda_of_an_option_that_the_page_turns_on(tmp_path: Path, page: str, asked: bool) -> None:
    cmake = f"project(demo)\nfind_package(catkin REQUIRED)\n{GPU}if(WITH_GPU)\n  enable_language(CUDA)\nendif()\n"
    files = {**package(), "CMakeLists.txt": cmake, "README.md": f"ROS noetic\n```\n{page}\n```\n"}
    assert (CUDA in decided(tmp_path, files).apt_guessed) == asked


@pytest.mark.parametrize(
    ("release", "language", "compiler"),
    [("melodic", "CUDA", "g++-6"), ("noetic", "CUDA", "g++-8"), ("kinetic", "CUDA", ""), ("melodic", "CXX", "")],
)
def test_ubuntus_own_cuda_gets_a_compiler_that_it_takes(
    tmp_path: Path, release: str, language: str, compiler: str
) -> None:
    made = "cmake_minimum_required(VERSION 3.5)\nproject(demo)\nfind_package(catkin REQUIRED)\n"
    cmake = f"{made}enable_language({language})\n"
    found = decided(tmp_path, {**package(), "CMakeLists.txt": cmake, "README.md": f"ROS {release}\n"})
    options = {f"-D{name}=/usr/bin/{compiler}" for name in ("CUDA_HOST_COMPILER", "CMAKE_CUDA_HOST_COMPILER")}
    assert {*found.cuda_options} == (options if compiler else set())
    assert [name for name in found.apt if name.startswith("g++")] == ([compiler] if compiler else [])
    written = make_plan(found, Config(), folder_name="demo").workspace.ros
    assert written is not None
    assert {*found.cuda_options} <= {*written.cmake_options}
    said = replace(Config(), cmake_options="-DCUDA_HOST_COMPILER=gcc-5")
    again = make_plan(found, said, folder_name="demo").workspace.ros
    assert again is not None
    assert f"-DCUDA_HOST_COMPILER=/usr/bin/{compiler}" not in again.cmake_options


@pytest.mark.parametrize(
    ("node", "asked"),
    [
        ("import rospy\nimport torch\n", True),
        ("import rospy\n\n\ndef plan():\n    import torch\n", False),
        ("import rospy\n", False),
    ],
)
def test_a_framework_that_a_node_imports(tmp_path: Path, node: str, asked: bool) -> None:
    code = {"scripts/node.py": node, "a.py": "import torch\n", "README.md": "ROS noetic\n"}
    found = decided(tmp_path, {**package(), **code})
    assert [each.name for each in found.python.pip_guessed] == (["torch"] if asked else [])
    told = [each for each in found.warnings if "nothing asks for torch by its name" in each.message]
    assert [(each.file, each.line) for each in told] == ([] if asked else [("a.py", 1)])


def test_the_same_tree_gives_the_same_decision(tmp_path: Path) -> None:
    files = {**package(), "README.md": "ROS kinetic, melodic\n", "src/a.cpp": "#include <Eigen/Core>\n"}
    assert decided(tmp_path, files) == decided(tmp_path, {})


def test_nothing_to_build(tmp_path: Path) -> None:
    with pytest.raises(NothingToBuildError, match=r"package\.xml"):
        decided(tmp_path, {"notes.txt": "hello"})
    assert decided(tmp_path, {}, replace(Config(), file="roslab.yaml", apt=("figlet",))).apt == ("figlet",)


def test_a_clone_answers_for_packages_whose_names_begin_like_it(tmp_path: Path) -> None:
    readme = "```\ngit clone https://github.com/lab/p3dx.git\ngit clone https://github.com/lab/rviz.git\n```\n"
    files = {
        **package(),
        "a.launch": '<launch><include file="$(find p3dx_gazebo)/b.launch"/></launch>',
        "README.md": readme,
    }
    found = decided(tmp_path, files)
    assert [source.name for source in found.source] == ["p3dx"]
    assert any("without a fixed ref: p3dx" in warning.message for warning in found.warnings)


def test_a_key_that_only_an_older_distribution_released_rules_nothing_out(tmp_path: Path) -> None:
    xml = AMENT.replace("<depend>rclcpp</depend>", "<depend>rclcpp</depend><depend>px4_msgs</depend>")
    assert decided(tmp_path, package(xml=xml)).ros_distro == "humble"


def test_well_known_unreleased_packages_come_from_their_table(tmp_path: Path) -> None:
    xml = (
        CATKIN.format(name="demo")
        .replace("roscpp", "livox_ros_driver")
        .replace("</package>", "<depend>glog_catkin</depend></package>")
    )
    found = decided(tmp_path, {"package.xml": xml, "CMakeLists.txt": CMAKE.format(name="demo")})
    assert [s.name for s in found.source] == [
        "livox-sdk",
        "catkin_simple",
        "gflags_catkin",
        "glog_catkin",
        "livox_ros_driver",
    ]
    assert all(source.ref for source in found.source)
    assert not [warning for warning in found.warnings if "rosdep has no key" in warning.message]
    # Its headers lack an #include that compilers from Ubuntu 22.04 on want
    assert shlex.split(found.source[0].cmake_options) == ["-DCMAKE_CXX_FLAGS=-include memory"]


def test_a_package_of_the_table_brings_what_it_needs_and_is_built_as_its_authors_do(tmp_path: Path) -> None:
    xml = CATKIN.format(name="demo").replace("roscpp", "voxblox_ros")
    found = decided(tmp_path, {"package.xml": xml, "CMakeLists.txt": CMAKE.format(name="demo")})
    names = [source.name for source in found.source]
    assert names[-2:] == ["voxblox", "minkindr_ros"]
    assert {"catkin_simple", "eigen_catkin", "glog_catkin", "protobuf_catkin"} < {*names}
    assert found.build_tool == "catkin_make"
    (kindr,) = (source for source in found.source if source.name == "minkindr")
    assert "minkindr_python/CATKIN_IGNORE" in kindr.prepare  # its bindings need what nobody asked for
    wrapper = xml.replace("voxblox_ros", "yaml_cpp_catkin")
    assert decided(tmp_path, {"package.xml": wrapper}).build_tool == "catkin_tools"
    simple = xml.replace(
        "<buildtool_depend>", "<buildtool_depend>catkin_simple</buildtool_depend><buildtool_depend>", 1
    )
    assert decided(tmp_path, {"package.xml": simple}).build_tool == "catkin_tools"
    page = {"package.xml": simple, "README.md": "```\ncatkin_make\n```\n"}
    assert decided(tmp_path, page).build_tool == "catkin_make"


AMENT_PYTHON = (
    '<package format="3"><name>{name}</name><exec_depend>rclpy</exec_depend>'
    "<export><build_type>ament_python</build_type></export></package>"
)


def test_pip_leaves_colcon_a_setuptools_that_it_can_use(tmp_path: Path) -> None:
    tree = {"package.xml": AMENT_PYTHON.format(name="demo"), "setup.py": "from setuptools import setup\nsetup()\n"}
    assert decided(tmp_path, tree).python.pip == ()  # nothing is installed: nothing can replace it
    found = decided(tmp_path, tree | {"requirements.txt": "open3d\n"})
    assert [asked.text for asked in found.python.pip] == ["setuptools<80"]
    reason = next(reason for reason in found.reasons if reason.answer == "setuptools<80")
    assert (reason.file, "ament_python" in reason.reason) == ("package.xml", True)
    pinned = decided(tmp_path, tree | {"requirements.txt": "setuptools==58.2.0\nopen3d\n"})
    assert pinned.python.pip == ()  # the author's own pin stands


@pytest.mark.parametrize(("xml", "branch", "option"), [(CATKIN, "noetic", "ROS1"), (AMENT, "humble", "ROS2")])
def test_a_driver_with_a_manifest_for_each_ros_is_made_a_package_of_this_one(
    tmp_path: Path, xml: str, branch: str, option: str
) -> None:
    files = package(xml=xml.replace("</package>", "<depend>livox_ros_driver2</depend></package>"))
    found = decided(tmp_path, files, branch=branch)
    driver = next(source for source in found.source if source.name == "livox_ros_driver2")
    assert (driver.ref, f"package_{option}.xml package.xml" in driver.prepare) == ("1.2.6", True)
    assert driver.cmake_options.split()[0] == f"-DROS_EDITION={option}"
    assert [source.name for source in found.source] == ["livox-sdk2", "livox_ros_driver2"]
    cloned = decided(
        tmp_path,
        {"README.md": "git clone https://github.com/Livox-SDK/livox_ros_driver2.git -b 1.2.4\n"},
        branch=branch,
    )
    driver = next(source for source in cloned.source if source.name == "livox_ros_driver2")
    assert (driver.ref, driver.prepare != "") == ("1.2.4", True)


def test_what_the_base_or_another_package_brings_is_not_named(tmp_path: Path) -> None:
    bridge = CATKIN.replace("</package>", "<depend>cv_bridge</depend><exec_depend>tf</exec_depend></package>")
    files = {
        **package(xml=bridge),
        "CMakeLists.txt": CMAKE.format(name="demo") + "find_package(OpenCV REQUIRED)\nfind_package(Eigen3 REQUIRED)\n",
        "a.cpp": "#include <visualization_msgs/Marker.h>\n#include <pcl_ros/point_cloud.h>\n",
        "README.md": "```\nsudo apt install ros-noetic-nav-msgs\n```\n",
    }
    found = decided(tmp_path, files)
    assert {"libopencv-dev", "ros-noetic-visualization-msgs"}.isdisjoint({*found.apt, *found.apt_guessed})
    assert "libeigen3-dev" in found.apt
    assert {"ros-noetic-nav-msgs", "ros-noetic-pcl-ros"} <= {*found.apt_guessed}  # the author names one


def test_a_library_built_from_source_gets_the_headers_that_a_ros_package_brings_later(tmp_path: Path) -> None:
    files = {
        **package(xml=CATKIN.replace("</package>", "<depend>cv_bridge</depend></package>")),
        "CMakeLists.txt": CMAKE.format(name="demo") + "find_package(OpenCV REQUIRED)\n"
        "find_package(odd_library REQUIRED)\n",
        "README.md": "```\ngit clone https://github.com/someone/odd_library\ncd odd_library/build\ncmake ..\n"
        "sudo make install\n```\n",
    }
    found = decided(tmp_path, files)
    assert "libopencv-dev" not in found.apt
    assert ["libopencv-dev" in source.depends for source in found.source if source.name == "odd_library"] == [True]


@pytest.mark.parametrize("module", ["serial", "can"])
def test_an_import_of_another_projects_module_brings_no_library_of_ros(tmp_path: Path, module: str) -> None:
    package = "<package format='2'><name>demo</name><buildtool_depend>catkin</buildtool_depend></package>"
    files = {
        "package.xml": package,
        "CMakeLists.txt": "project(demo)\nfind_package(catkin REQUIRED)\ncatkin_package()\n",
        "scripts/node.py": f"#!/usr/bin/env python3\nimport {module}\nimport tf2_ros\n",
        "README.md": "For ROS Noetic.\n",
    }
    decision = decided(tmp_path, files)
    asked = (*decision.apt, *decision.apt_guessed)
    assert f"ros-noetic-{module}" not in asked
    assert "ros-noetic-tf2-ros" in asked


@pytest.mark.parametrize(
    ("needs", "page", "vcs"),
    [
        ("rclcpp", "", ()),
        ("acme_msgs", "", ("config/board.repos",)),
        ("rclcpp", "vcs import src < src/demo/config/board.repos\n", ("config/board.repos",)),
    ],
)
def test_a_list_below_the_root_is_imported_where_something_is_lacking_or_a_page_names_it(
    tmp_path: Path, needs: str, page: str, vcs: tuple[str, ...]
) -> None:
    board = "repositories:\n  acme_msgs: {type: git, url: 'https://github.com/lab/acme_msgs.git', version: '1.0'}\n"
    readme = f"```\n{page}ros2 run micro_board agent\n```\n"
    package_xml = AMENT.format(name="a").replace("rclcpp", needs)
    files = {**package(xml=package_xml), "config/board.repos": board, "README.md": readme}
    assert decided(tmp_path, files, branch="humble").vcs == vcs


def test_messages_that_no_distribution_released_are_cloned_as_of_the_last_commit(tmp_path: Path) -> None:
    found = decided(tmp_path, package(xml=AMENT.replace("rclcpp", "px4_msgs")), branch="humble")
    assert [(s.name, s.ref) for s in found.source] == [("px4_msgs", None)]


def test_the_dockerfiles_of_copied_packages_are_no_family(tmp_path: Path) -> None:
    copied: dict[str, str] = {}
    for name, distro in (("x", "humble"), ("y", "foxy"), ("z", "iron")):
        copied |= package(name, AMENT, f"src/lib/{name}") | {
            f"src/lib/{name}/Dockerfile": f"FROM ros:{distro}\nCOPY . /w\n"
        }
        copied |= {f"src/lib/{name}/README.md": "A.\n", f"src/lib/{name}/LICENSE": "MIT\n"}
    files = {**copied, **package("b", AMENT, "src/b"), "README.md": "[![ROS Version Jazzy](https://x/ROS-Jazzy)](x)\n"}
    assert decided(tmp_path, files, branch="main").ros_distro == "jazzy"


def test_the_channel_of_conda_s_packages_names_the_distribution(tmp_path: Path) -> None:
    pixi = '[workspace]\nchannels = ["robostack-jazzy", "conda-forge"]\n[dependencies]\nros-jazzy-desktop = "*"\n'
    files = {**package(xml=AMENT), "pixi.toml": pixi, "README.md": "Tested with ROS 2 Humble.\n"}
    assert decided(tmp_path, files, branch="main").ros_distro == "jazzy"


def test_the_packages_that_pixi_takes_name_the_distribution(tmp_path: Path) -> None:
    pixi = '[project]\nchannels = ["robostack-staging", "conda-forge"]\n[dependencies]\nros-humble-desktop = ">=0.10"\n'
    assert decided(tmp_path, {**package(xml=AMENT), "pixi.toml": pixi}, branch="main").ros_distro == "humble"


@pytest.mark.parametrize("name", ["ros-core", "ros-x"])
def test_a_package_of_ros_without_a_distribution_in_its_name(tree: Tree, name: str) -> None:
    page = f"# Install on ROS Noetic\n```\nsudo apt install {name} libfoo-dev\n```\n"
    manifest = "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend></package>"
    decision = tree({"package.xml": manifest, "CMakeLists.txt": "find_package(catkin REQUIRED)\n", "README.md": page})
    assert {name, "libfoo-dev"} <= {*decision.apt, *decision.apt_guessed}


def test_what_the_table_knows_of_an_unreleased_package_is_cloned_with_its_needs(tree: Tree) -> None:
    manifest = "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend><depend>mrs_lib</depend></package>"
    cmake = "find_package(catkin REQUIRED COMPONENTS mrs_lib)\n"
    decision = tree({"package.xml": manifest, "CMakeLists.txt": cmake, "README.md": "For ROS Noetic."})
    assert [source.name for source in decision.source] == ["mrs_msgs", "mrs_lib"]


@pytest.mark.parametrize(
    ("distro", "sources"),
    [("Melodic", []), ("Noetic", ["mav_comm", "rotors_simulator"])],
)
def test_what_the_distribution_released_is_not_cloned_for_a_package_of_the_table(
    tree: Tree, distro: str, sources: list[str]
) -> None:
    needs = "<buildtool_depend>catkin</buildtool_depend><depend>rotors_control</depend>"
    cmake = "find_package(catkin REQUIRED COMPONENTS rotors_control)\n"
    manifest = f"<package><name>demo</name>{needs}</package>"
    decision = tree({"package.xml": manifest, "CMakeLists.txt": cmake, "README.md": f"For ROS {distro}."})
    assert [source.name for source in decision.source] == sources
    assert not [warning for warning in decision.warnings if "rotors_control" in warning.message]


@pytest.mark.parametrize(
    "load",
    [
        '<include file="$(find turtlebot_gazebo)/launch/turtlebot_world.launch"/>',
        '<param name="robot" command="xacro $(find demo)/robot.xacro"/>',
    ],
)
def test_what_only_a_launch_file_or_a_description_needs_comes_from_the_table(tree: Tree, load: str) -> None:
    cmake = "find_package(catkin REQUIRED COMPONENTS roscpp)\nadd_executable(demo main.cpp)\n"
    needs = "<buildtool_depend>catkin</buildtool_depend><depend>roscpp</depend>"
    include = '<xacro:include filename="$(find turtlebot_gazebo)/urdf/turtlebot.xacro"/>'
    files = {
        "package.xml": f"<package><name>demo</name>{needs}</package>",
        "CMakeLists.txt": cmake,
        "main.cpp": "int main() {}\n",
        "launch/demo.launch": f'<launch><node pkg="demo" type="demo" name="demo"/>{load}</launch>',
        "robot.xacro": f"<robot>{include}</robot>",
        "README.md": "ROS Melodic\n```\nroslaunch demo demo.launch\n```\n",
    }
    decision = tree(files)
    assert {source.name for source in decision.source} >= {"kobuki", "turtlebot", "turtlebot_simulator"}
    assert "yujin_ocs" not in {source.name for source in decision.source}  # Melodic released it
    assert not [w for w in decision.warnings if "needs the package" in w.message]


@pytest.mark.parametrize(
    ("name", "told"),
    [
        (
            "gazebo_ros_link_attacher",
            "https://github.com/pal-robotics/gazebo_ros_link_attacher has a package of that name",
        ),
        ("acme_link_attacher", "nothing here says where it comes from"),
    ],
)
def test_where_a_package_is_that_only_the_manifest_names_is_told(tree: Tree, name: str, told: str) -> None:
    needs = f"<buildtool_depend>catkin</buildtool_depend><depend>roscpp</depend><exec_depend>{name}</exec_depend>"
    files = {
        "package.xml": f"<package><name>demo</name>{needs}</package>",
        "CMakeLists.txt": "find_package(catkin REQUIRED COMPONENTS roscpp)\n",
        "README.md": "ROS Noetic\n",
    }
    decision = tree(files)
    assert not decision.source
    assert [told in w.message for w in decision.warnings if name in w.message] == [True]


@pytest.mark.parametrize(
    ("library", "sources"),
    [("libgazebo_grasp_fix.so", ["gazebo-pkgs"]), ("libgazebo_ros_camera.so", []), ("libacme.so", [])],
)
def test_a_plugin_of_gazebo_that_no_distribution_released_comes_from_the_table(
    tree: Tree, library: str, sources: list[str]
) -> None:
    plugin = f'<gazebo><plugin name="plugin" filename="{library}"/></gazebo>'
    files = {
        "package.xml": "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend></package>",
        "CMakeLists.txt": "find_package(catkin REQUIRED)\n",
        "urdf/robot.xacro": f"<robot>{plugin}</robot>",
        "README.md": "ROS Noetic, in Gazebo\n",
    }
    assert [source.name for source in tree(files).source] == sources


def test_an_unknown_key_that_an_install_line_of_apt_has_is_left_to_apt(tree: Tree) -> None:
    manifest = (
        "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend><depend>libgmp-dev</depend></package>"
    )
    files = {"package.xml": manifest, "CMakeLists.txt": "find_package(catkin REQUIRED)\n", "README.md": "ROS Noetic"}
    decision = tree(files)
    assert "libgmp-dev" in decision.rosdep
    assert any("libgmp-dev" in each.message for each in decision.warnings)
    decision = tree({**files, "README.md": "# Install on ROS Noetic\n`sudo apt install libgmp-dev`\n"})
    assert "libgmp-dev" in decision.apt_guessed
    assert "libgmp-dev" in decision.skip_keys
    assert not any("libgmp-dev" in each.message for each in decision.warnings)


def test_an_unknown_key_that_cmake_needs_as_a_package_of_apt_is_left_to_it(tree: Tree) -> None:
    manifest = (
        "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend><depend>libpcl-dev</depend></package>"
    )
    files = {"package.xml": manifest, "CMakeLists.txt": "find_package(catkin REQUIRED)\n", "README.md": "ROS Noetic"}
    assert any("libpcl-dev" in each.message for each in tree(files).warnings)
    decision = tree({**files, "CMakeLists.txt": f"{files['CMakeLists.txt']}find_package(PCL REQUIRED)\n"})
    assert "libpcl-dev" in decision.apt
    assert "libpcl-dev" in decision.skip_keys
    assert not any("libpcl-dev" in each.message for each in decision.warnings)


@pytest.mark.parametrize(("branch", "refs"), [("humble", "humble"), ("jazzy", "jazzy"), ("foxy", None)])
def test_an_unreleased_family_is_cloned_at_the_branch_of_its_distribution(
    tmp_path: Path, branch: str, refs: str | None
) -> None:
    xml = AMENT.replace("rclcpp", "rmw_microxrcedds")
    found = decided(tmp_path, package(xml=xml), branch=branch)
    cloned = [(source.name, source.ref) for source in found.source]
    assert cloned == (
        [
            ("Micro-CDR", "ros2"),
            ("Micro-XRCE-DDS-Client", "ros2"),
            ("rosidl_typesupport_microxrcedds", refs),
            ("rmw-microxrcedds", refs),
        ]
        if refs
        else []
    )
    assert any("rmw_microxrcedds" in warning.message for warning in found.warnings) is (refs is None)


def test_a_module_that_a_ros_package_brings_is_not_guessed_from_pip_too(tmp_path: Path) -> None:
    launch = "import xacro\nimport gtsam\nfrom launch import LaunchDescription\n"
    found = decided(tmp_path, {**package(xml=AMENT), "launch/a.launch.py": launch}, branch="humble")
    assert "ros-humble-xacro" in found.apt_guessed
    assert [each.name for each in found.python.pip_guessed] == ["gtsam"]  # ROS's is a library of C++


def test_without_ros_the_module_comes_from_pip(tmp_path: Path) -> None:
    found = decided(tmp_path, {"main.py": "import xacro\nif __name__ == '__main__':\n    print(xacro)\n"})
    assert [each.name for each in found.python.pip_guessed] == ["xacro"]


@pytest.mark.parametrize(("distro", "told"), [("kinetic", False), ("melodic", False), ("noetic", True)])
def test_keys_of_python_2_are_of_the_tables_of_its_time(tmp_path: Path, distro: str, told: bool) -> None:
    files = package(xml=CATKIN.replace("roscpp", "python-pymongo-of-then"))
    found = decided(tmp_path, {**files, "README.md": f"ROS {distro.title()}\n"})
    assert found.ros_distro == distro
    assert any("python-pymongo-of-then" in each.message for each in found.warnings) is told


@pytest.mark.parametrize(
    ("line", "branch", "brought"),
    [
        ("#!/usr/bin/env python3", "melodic-devel", {"python3-tk", "python3-matplotlib"}),
        ("#!/usr/bin/python3", "kinetic-devel", {"python3-tk", "python3-matplotlib"}),
        ("#!/usr/bin/env python", "melodic-devel", set()),
        ("# python3", "melodic-devel", set()),
    ],
)
def test_programs_of_python_3_find_their_modules_beside_python_2(
    tmp_path: Path, line: str, branch: str, brought: set[str]
) -> None:
    imports = "import os\nimport matplotlib.pyplot as plt\nimport rosbag\nimport catkin_pkg\n"
    files = {**package("a"), "tools/plot.py": f"{line}\n{imports}"}
    guessed = decided(tmp_path, files, branch=branch).apt_guessed
    assert {name for name in guessed if name.startswith("python3-")} == brought
    assert ("python-matplotlib" in guessed) == (not brought)


def test_so_do_the_modules_of_the_tree_that_they_import(tmp_path: Path) -> None:
    files = {
        **package("a"),
        "nodes/talk.py": "#!/usr/bin/env python3\nimport sys\nsys.path.append('shared')\nfrom driver import Driver\n",
        "nodes/older.py": "#!/usr/bin/env python\nimport other\n",
        "shared/driver/__init__.py": "from .port import Driver\n",
        "shared/driver/port.py": "import serial\n",
        "shared/other.py": "import termcolor\n",
    }
    guessed = decided(tmp_path, files, branch="melodic-devel").apt_guessed
    assert "python3-serial" in guessed
    assert "python3-termcolor" not in guessed


def test_what_two_programs_reach_is_of_the_first(tmp_path: Path) -> None:
    started = "#!/usr/bin/env python3\nimport {}\n"
    files = {**package("a"), "src/b.py": started.format("shared"), "src/a.py": started.format("shared")}
    files |= {"src/c.py": started.format("more"), "src/more.py": "import shared\nimport termcolor\n"}
    decision = decided(tmp_path, files | {"src/shared.py": "import serial\n"}, branch="melodic-devel")
    reasons = {reason.answer: reason.file for reason in decision.reasons}
    assert (reasons["python3-serial"], reasons["python3-termcolor"]) == ("src/a.py", "src/c.py")


def test_a_node_of_python_3_finds_what_ros_itself_imports(tmp_path: Path) -> None:
    files = {**package("a"), "nodes/talk.py": "#!/usr/bin/env python3\nimport rospy\n"}
    here = decided(tmp_path, files, branch="melodic-devel").apt_guessed
    assert {"python3-yaml", "python3-rospkg-modules"} <= {*here}
    there = decided(tmp_path, files, branch="noetic-devel").apt_guessed
    assert "python3-rospkg-modules" not in there
