"""What another planned package brings is not named again, unless an author names it."""

from __future__ import annotations

from collections.abc import Callable

from roslab.decide.decision import Decision
from roslab.decide.system.carried import brought
from roslab.decide.system.names import Target
from roslab.knowledge.table import rows

Tree = Callable[[dict[str, str]], Decision]
PACKAGE = "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend>{}</package>"
CMAKE = "cmake_minimum_required(VERSION 3.0)\nproject(demo)\nfind_package(catkin REQUIRED)\n{}add_executable(a a.cpp)\n"


def planned(tree: Tree, cmake: str = "", code: str = "", page: str = "", keys: str = "") -> set[str]:
    files = {
        "package.xml": PACKAGE.format(keys),
        "CMakeLists.txt": CMAKE.format(cmake),
        "a.cpp": f"{code}\nint main() {{}}\n",
        "README.md": f"Tested with ROS Noetic\n\n## Installation\n\n```bash\n{page}\n```\n",
    }
    decision = tree(files)
    return {*decision.apt, *decision.apt_guessed}


def test_a_library_that_another_brings(tree: Tree) -> None:
    asked = "find_package(CGAL REQUIRED)\n"
    found = planned(tree, asked, "#include <gflags/gflags.h>\n#include <glog/logging.h>")
    assert {"libcgal-dev", "libgoogle-glog-dev"} <= found
    assert not found & {"libgmp-dev", "libmpfr-dev", "libgflags-dev"}


def test_what_an_author_names_stays_whoever_asked_first(tree: Tree) -> None:
    asked = "find_package(CGAL REQUIRED)\n"
    assert "libgmp-dev" in planned(tree, asked, page="sudo apt-get install libgmp-dev")
    keys = "<depend>cv_bridge</depend>"
    asked = "find_package(OpenCV REQUIRED)\n"
    assert "libopencv-dev" not in planned(tree, asked, keys=keys)
    assert "libopencv-dev" in planned(tree, asked, page="sudo apt-get install libopencv-dev", keys=keys)


def test_what_a_metapackage_of_ros_brings(tree: Tree) -> None:
    code = "#include <tf2_msgs/TFMessage.h>\n#include <pcl_conversions/pcl_conversions.h>"
    without = planned(tree, code=code)
    found = planned(tree, code=code, page="sudo apt install ros-noetic-desktop-full")
    assert {"ros-noetic-tf2-msgs", "ros-noetic-pcl-conversions"} <= without
    assert "ros-noetic-desktop-full" in found
    assert not found & {"ros-noetic-tf2-msgs", "ros-noetic-pcl-conversions"}


def test_a_key_brings_through_others(tree: Tree) -> None:
    code = "#include <tf2_msgs/TFMessage.h>\n"
    assert "ros-noetic-tf2-msgs" in planned(tree, code=code)
    assert "ros-noetic-tf2-msgs" not in planned(tree, code=code, keys="<depend>tf</depend>")


def test_a_library_of_a_wheel_is_not_left_to_what_compiling_needs() -> None:
    target = Target(ros_distro=None, ubuntu="focal")
    assert "libgl1" in brought(["freeglut3-dev"], target)
    assert "libgl1" not in brought(["freeglut3-dev"], target, directly=True)


def test_a_wheel_beside_libraries(tree: Tree) -> None:
    found = tree(
        {"requirements.txt": "open3d\n", "a.py": "import open3d\n", "README.md": "apt install freeglut3-dev\n"}
    )
    assert "libgl1" in {*found.apt, *found.apt_guessed}


def test_a_desktop_of_ros_2_is_another() -> None:
    noetic = brought(["ros-noetic-desktop"], Target(ros_distro="noetic", ubuntu="focal"))
    foxy = brought(["ros-foxy-desktop"], Target(ros_distro="foxy", ubuntu="focal"))
    assert "ros-noetic-xacro" in noetic
    assert "ros-foxy-xacro" not in foxy


def test_nothing_brings_itself() -> None:
    for row in rows("carried"):
        package = row["package"].replace("ros-", "ros-noetic-", 1) if row["package"][:4] == "ros-" else row["package"]
        for ubuntu in row["only"].split() or ["focal"]:
            assert package not in brought([package], Target(ros_distro="noetic", ubuntu=ubuntu))
