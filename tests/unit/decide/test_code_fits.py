"""What the code cannot compile with rules out distributions and Ubuntus that a page names."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision
from roslab.knowledge.code_limits import fits, satisfies

Tree = Callable[[dict[str, str]], Decision]
GPU = "list(APPEND CUDA_NVCC_FLAGS -arch=sm_61)\n"
PACKAGE = "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend></package>"


def ros1(cmake: str = "", code: str = "", page: str = "Tested with ROS Kinetic") -> dict[str, str]:
    made = f"cmake_minimum_required(VERSION 2.8.3)\nproject(demo)\nfind_package(catkin REQUIRED)\n{cmake}"
    return {"package.xml": PACKAGE, "CMakeLists.txt": made, "src/a.cpp": code, "README.md": page}


@pytest.mark.parametrize(
    ("cmake", "code", "page", "distro"),
    [
        ("", "", "Tested with ROS Kinetic", "kinetic"),
        ("find_package(PCL 1.9 REQUIRED)\n", "", "Tested on **Ubuntu 16.04**", "noetic"),
        ("find_package(PCL 1.8 REQUIRED)\n", "", "Tested with ROS Kinetic", "melodic"),
        ("find_package(PCL 1.9 QUIET)\n", "", "Tested with ROS Kinetic", "kinetic"),
        ("find_package(OpenCV 3 REQUIRED)\n", "", "Tested with ROS Noetic", "melodic"),
        ("", "#include <opencv/cv.h>\n", "Tested with ROS Noetic", "melodic"),
        ("", "void f() { imread(a, CV_LOAD_IMAGE_COLOR); }\n", "Tested with ROS Noetic", "melodic"),
        ("", "// CV_LOAD_IMAGE_COLOR\n", "Tested with ROS Noetic", "noetic"),
        ("", "// a\nputs(CV_MAJOR_VERSION);\nint f = CV_LOAD_IMAGE_COLOR;\n", "Tested with ROS Noetic", "melodic"),
        ("", "#if CV_MAJOR_VERSION < 4\nint f = CV_LOAD_IMAGE_COLOR;\n#endif\n", "Tested with ROS Noetic", "noetic"),
        ("set(CMAKE_CXX_STANDARD 17)\n", "", "Tested with ROS Kinetic", "melodic"),
        ('set(CMAKE_CXX_FLAGS "-std=c++17")\n', "", "Tested with ROS Kinetic", "melodic"),
        ("# set(CMAKE_CXX_STANDARD 17)\n", "", "Tested with ROS Kinetic", "kinetic"),
        ("", "#include <filesystem>\n", "Tested with ROS Melodic", "noetic"),
        ("", "#if NEWER\nint a;\n#else\n#include <opencv/cv.h>\n#endif\n", "Tested with ROS Noetic", "noetic"),
        ("", "#ifdef OLD\nint f = CV_LOAD_IMAGE_COLOR;\n#endif\n", "Tested with ROS Noetic", "noetic"),
        ("", "#ifndef A_H\n#define A_H\n#include <opencv/cv.h>\n#endif\n", "Tested with ROS Noetic", "melodic"),
        ("", "#ifdef OLD\n#endif\n#include <opencv/cv.h>\n", "Tested with ROS Noetic", "melodic"),
        ("", "#include <string_view>\n", "Tested with ROS Kinetic", "melodic"),
        ("", "#if __cplusplus > 201402L\n#include <string_view>\n#endif\n", "Tested with ROS Kinetic", "kinetic"),
        ("", "#if _MSVC_LANG > 201402L\n#include <string_view>\n#endif\n", "Tested with ROS Kinetic", "kinetic"),
        ("", "#if __has_include(<any>)\n#include <any>\n#endif\n", "Tested with ROS Kinetic", "kinetic"),
        ("", "#ifdef __cplusplus\n#include <string_view>\n#endif\n", "Tested with ROS Kinetic", "melodic"),
        ("", "void f() { now = this->world_->GetSimTime(); }\n", "ROS Kinetic or Melodic", "kinetic"),
        ("", "gazebo::math::Pose p = q;\n", "ROS Kinetic or Melodic", "kinetic"),
        ("", "void f() { p = model->GetWorldPose(); }\n", "ROS Kinetic or Melodic", "kinetic"),
        ("", "#if GAZEBO_MAJOR_VERSION < 9\ngazebo::math::Pose p;\n#endif\n", "ROS Kinetic or Melodic", "melodic"),
        ("", "void f() { now = robot->GetSimTime(); }\n", "ROS Kinetic or Melodic", "melodic"),
        ("", "void f() { now = m->GetWorld()->GetSimTime(); }\n", "ROS Kinetic or Melodic", "kinetic"),
        ("", "void f() { now = this->world_->SimTime(); }\n", "Tested with ROS Kinetic", "melodic"),
        ("", "void f() { e = m->GetWorld()->Physics(); }\n", "Tested with ROS Kinetic", "melodic"),
        ("", "void f() { p = model->WorldPose(); }\n", "Tested with ROS Kinetic", "melodic"),
        ("", "void f() { now = robot->SimTime(); }\n", "Tested with ROS Kinetic", "kinetic"),
        ("", "#if GAZEBO_MAJOR_VERSION >= 8\nt = world->SimTime();\n#endif\n", "Tested with ROS Kinetic", "kinetic"),
        ("", "boost::shared_ptr<const urdf::Link> l = m.getLink(a);\n", "ROS Kinetic or Melodic", "kinetic"),
        ("", "boost::shared_ptr<urdf::Link> l(m.getLink(a));\nint v=CV_VERSION;\n", "ROS Kinetic, Melodic", "kinetic"),
        ("", "urdf::LinkConstSharedPtr l = m.getLink(a);\n", "ROS Kinetic or Melodic", "melodic"),
        (f"find_package(CUDA REQUIRED)\n{GPU}", "", "Tested with ROS Kinetic", "melodic"),
        (f"find_package(CUDA QUIET)\n{GPU}", "", "Tested with ROS Kinetic", "kinetic"),
        (f"find_package(CUDA REQUIRED)\n{GPU.replace('61', '86')}", "", "Tested with ROS Noetic", "noetic"),
        (f"find_package(CUDA REQUIRED)\n{GPU.replace('61', '50')}", "", "Tested with ROS Kinetic", "kinetic"),
    ],
)  # fmt: skip
def test_a_page_yields_to_the_code(tree: Tree, cmake: str, code: str, page: str, distro: str) -> None:
    assert tree(ros1(cmake, code, page)).ros_distro == distro


def test_a_name_that_the_code_defines_itself_is_no_sign(tree: Tree) -> None:
    files = ros1(code='#include "a.h"\nvoid f() { cvtColor(a, b, CV_GRAY2RGB); }\n', page="Tested with ROS Noetic")
    files["src/a.h"] = "#define  CV_GRAY2RGB cv::COLOR_GRAY2BGR\n"
    assert tree(files).ros_distro == "noetic"
    files["src/a.cpp"] = files["src/a.cpp"].replace("}", "imread(c, CV_LOAD_IMAGE_COLOR); }")
    assert tree(files).ros_distro == "melodic"


def test_an_ubuntu_whose_libraries_are_not_listed_has_no_older_ones() -> None:
    for ubuntu, old, new in (("bionic", True, True), ("noble", False, True), ("resolute", False, True)):
        assert fits("OpenCV", ubuntu, at_least=None, below="4") is old
        assert fits("OpenCV", ubuntu, at_least="3", below=None) is new


def test_a_newer_cmake_cannot_come_from_pip_everywhere(tree: Tree) -> None:
    files = ros1(page="Tested with ROS Indigo")
    files["CMakeLists.txt"] = files["CMakeLists.txt"].replace("2.8.3", "3.1.3")
    assert tree(files).ros_distro == "kinetic"
    files["CMakeLists.txt"] = files["CMakeLists.txt"].replace("3.1.3", "3.8")
    files["README.md"] = "Tested with ROS Kinetic"
    assert tree(files).ros_distro == "kinetic"


def test_ci_that_is_older_than_the_cmake_of_the_code(tree: Tree) -> None:
    files = ros1(page="Tested with ROS Indigo")
    files[".travis.yml"] = "dist: trusty\nbefore_install:\n  - export ROS_DISTRO=indigo\n"
    assert tree(files).ros_distro == "indigo"
    files["CMakeLists.txt"] = files["CMakeLists.txt"].replace("2.8.3", "3.10")
    assert tree(files).ros_distro == "noetic"


def test_what_ci_builds_has_its_libraries_from_elsewhere(tree: Tree) -> None:
    files = ros1("find_package(PCL 1.9 REQUIRED)\n")
    ci = "jobs:\n  a:\n    container: ros:kinetic\n    steps: []\n"
    assert tree({**files, ".github/workflows/ci.yml": ci}).ros_distro == "kinetic"


def test_code_of_cuda_and_copied_code_tell_nothing(tree: Tree) -> None:
    files = ros1(page="Tested with ROS Noetic")
    more = {"src/b.cu": "#include <opencv/cv.h>\n", "3rd/x/a.cpp": "#include <opencv/cv.h>\n"}
    assert tree({**files, **more}).ros_distro == "noetic"


@pytest.mark.parametrize(
    ("cmake", "page", "ubuntu"),
    [
        ("", "", "jammy"),
        ("", "Tested on Ubuntu 16.04", "xenial"),
        ("set(CMAKE_CXX_STANDARD 17)\n", "Tested on Ubuntu 16.04", "jammy"),
        ("find_package(OpenCV 3 REQUIRED)\n", "", "bionic"),
        ("find_package(OpenCV 3.4 REQUIRED)\n", "Tested on Ubuntu 20.04", "focal"),
        ("", "A* epsilon (also known as focal search) on Ubuntu", "jammy"),
    ],
)
def test_an_ubuntu_for_plain_code(tree: Tree, cmake: str, page: str, ubuntu: str) -> None:
    made = f"cmake_minimum_required(VERSION 2.8.3)\nproject(demo CXX)\n{cmake}add_executable(a a.cpp)\n"
    assert tree({"CMakeLists.txt": made, "a.cpp": "int main() {}\n", "README.md": page}).ubuntu == ubuntu


@pytest.mark.parametrize(
    ("file", "steps", "ubuntu"),
    [
        (".github/workflows/ci.yml", "cmake -B build", "jammy"),
        (".github/workflows/ci.yml", "clang-format -n a.cpp", "bionic"),
        (".travis.yml", "cmake -B build", "bionic"),
        (".github/workflows/ci.yml", "git clone https://github.com/opencv/opencv && cmake -B build", "bionic"),
    ],
)
def test_what_a_workflow_compiles_beside_a_newer_library_is_behind_an_option(
    tree: Tree, file: str, steps: str, ubuntu: str
) -> None:
    files = {
        "CMakeLists.txt": "project(demo CXX)\nadd_subdirectory(vision)\n",
        "vision/CMakeLists.txt": "find_package(OpenCV)\nadd_executable(a a.cpp)\n",
        "vision/a.cpp": "#include <opencv/cv.h>\nint main() {}\n",
        ".travis.yml": "dist: bionic\n",
    }
    files[file] = f"jobs:\n  a:\n    runs-on: ubuntu-22.04\n    steps:\n    - run: {steps}\n"
    assert tree(files).ubuntu == ubuntu


def test_an_ubuntu_without_a_library_has_no_older_one() -> None:
    assert not fits("Gazebo", "noble", at_least=None, below="9")
    assert fits("Gazebo", "noble", at_least="9", below=None)


def test_versions() -> None:
    assert satisfies("Boost", "focal", "1.58")
    assert not satisfies("OpenCV", "focal", "3.2")
    assert not satisfies("OpenCV", "xenial", "3")
    assert satisfies("OpenCV", "xenial", "3", ros=True)  # ros-kinetic-opencv3
    assert satisfies("Unknown", "focal", "3.2")
    assert not satisfies("OpenCV", "resolute", "3.4")  # a release that the table lacks has none older than the last
    assert satisfies("OpenCV", "resolute", "4.8")
    assert satisfies("Boost", "resolute", "1.58")
    assert fits("Ceres", "jammy", at_least=None, below="2.2")
    assert not fits("Ceres", "noble", at_least=None, below="2.2")


@pytest.mark.parametrize(("more", "distro"), [("", "noetic"), ("#include <types/wrapped.hpp>\n", "melodic")])
def test_a_header_that_nothing_includes_is_not_compiled(tree: Tree, more: str, distro: str) -> None:
    header = {"include/toolkit/types/wrapped.hpp": "#include <opencv/cv.h>\n"}
    assert tree({**ros1(code=more, page="Tested with ROS Noetic"), **header}).ros_distro == distro


@pytest.mark.parametrize(
    ("listed", "distro"),
    [("src/a.cpp", "noetic"), ("src/a.cpp src/b.cpp", "melodic"), ("${SOURCES}", "melodic")],
)
def test_a_header_that_no_compiled_source_reaches_requires_nothing(tree: Tree, listed: str, distro: str) -> None:
    code = {"src/b.cpp": "#include <outer.hpp>\n", "include/outer.hpp": "#include <inner.hpp>\n"}
    inner = {"include/inner.hpp": "#include <opencv/cv.h>\n"}
    cmake = f"add_library(demo {listed})\n"
    assert tree({**ros1(cmake, page="Tested with ROS Noetic"), **code, **inner}).ros_distro == distro


def test_headers_alone_are_for_who_includes_them(tree: Tree) -> None:
    files = {k: v for k, v in ros1(page="Tested with ROS Noetic").items() if k != "src/a.cpp"}
    more = {"include/outer.hpp": "#include <inner.hpp>\n", "include/inner.hpp": "#include <opencv/cv.h>\n"}
    assert tree({**files, **more}).ros_distro == "melodic"


@pytest.mark.parametrize(
    ("code", "page", "built"),
    [
        ("problem.EvaluateResidualBlock(id, false, &cost, nullptr, nullptr);\n", "ROS Noetic", [("ceres", "2.0.0")]),
        ("auto m = new ceres::SubsetManifold(3, {2});\n", "ROS Noetic", [("ceres", "2.1.0")]),
        ("problem.RemoveResidualBlock(id);\n", "ROS Noetic", []),
    ],
)
def test_a_library_that_is_too_old_on_the_ubuntu_of_ros_is_built(
    tree: Tree, code: str, page: str, built: list[tuple[str, str]]
) -> None:
    padded = "#include <ceres/ceres.h>\n" + "// padding\n" * 4000 + f"void f() {{ {code} }}\n"
    found = tree(ros1("find_package(Ceres REQUIRED)\n", padded, page))
    assert [(source.name, source.ref) for source in found.source] == built


@pytest.mark.parametrize(
    ("header", "name", "distro"),
    [
        ("#include <cv_bridge/cv_bridge.h>\n", "CV_BGR2GRAY", "noetic"),
        ("#include <cv_bridge/cv_bridge.h>\n", "CV_LOAD_IMAGE_COLOR", "melodic"),
        ("", "CV_BGR2GRAY", "melodic"),
    ],
)
def test_constants_that_cv_bridge_still_brings(tree: Tree, header: str, name: str, distro: str) -> None:
    files = ros1("", f'#include "b.h"\nvoid f() {{ g({name}); }}\n', "Tested with ROS Noetic")
    found = tree(files | {"src/b.h": '#include "c.h"\n', "src/c.h": header, "src/d.cpp": f"{header}int d;\n"})
    assert found.ros_distro == distro


@pytest.mark.parametrize(
    ("code", "ubuntu"),
    [
        ("#include <opencv2/core/core.hpp>\n", "xenial"),
        ("#include <opencv2/opencv.hpp>\n", "xenial"),
        ("#include <opencv2/calib3d.hpp>\n", "jammy"),
        ("#include <opencv2/videoio.hpp>\n", "jammy"),
        ("void f() { E = cv::findEssentialMat(a, b, K); }\n", "jammy"),
        ("void f() { cv::Mat E = findEssentialMat(a, b, K); }\n", "jammy"),
        ("cv::Mat findEssentialMat(int a);\n", "xenial"),
        ("#if __has_include(<opencv2/core.hpp>)\n#include <opencv2/core.hpp>\n#endif\n", "xenial"),
    ],
)
def test_what_the_opencv_of_an_old_ubuntu_lacks(tree: Tree, code: str, ubuntu: str) -> None:
    cmake = "cmake_minimum_required(VERSION 2.8.3)\nproject(demo)\nadd_executable(a a.cpp)\n"
    files = {"CMakeLists.txt": cmake, "a.cpp": code, "README.md": "Tested on Ubuntu 16.04.\n"}
    assert tree(files).ubuntu == ubuntu


@pytest.mark.parametrize(("ref", "ubuntu", "built"), [("2.1.0", "24.04", ["2.1.0"]), ("2.2.0", "22.04", [])])
def test_an_older_release_that_a_page_compiles_is_built(tree: Tree, ref: str, ubuntu: str, built: list[str]) -> None:
    page = "On Ubuntu 24.04\n```\ngit clone https://github.com/ceres-solver/ceres-solver\ncd ceres-solver\n"
    page += f"git checkout tags/{ref}\nmkdir build && cd build\ncmake .. && make\nsudo make install\n```\n"
    cmake = "project(demo)\nfind_package(Ceres REQUIRED)\nadd_executable(a a.cpp)\n"
    code = "class A : public ceres::LocalParameterization {};\nint main() {}\n"
    found = tree({"CMakeLists.txt": cmake, "a.cpp": code, "README.md": page})
    assert found.base_image == f"ubuntu:{ubuntu}"
    assert [source.ref for source in found.source if source.name == "ceres"] == built


@pytest.mark.parametrize(
    ("cmake", "distro"),
    [
        ('set(CMAKE_CXX_FLAGS "-std=c++11 ${CMAKE_CXX_FLAGS}")\nfind_package(PCL REQUIRED)\n', "melodic"),
        ("add_compile_options(-std=c++11)\n", "melodic"),
        ("set(CMAKE_CXX_STANDARD 11)\n", "melodic"),
        ("set(CMAKE_CXX_STANDARD 11)\nfind_package(PCL REQUIRED)\n", "noetic"),  # PCL's targets raise it
        ('set(CMAKE_CXX_FLAGS "-std=c++11")\nset(CMAKE_CXX_FLAGS "-std=c++14")\n', "noetic"),
        ('# set(CMAKE_CXX_FLAGS "-std=c++11")\n', "noetic"),
        ('CHECK_CXX_COMPILER_FLAG("-std=c++11" HAS_11)\n', "noetic"),
        ("", "noetic"),
    ],
)
def test_a_pcl_that_refuses_cpp11_is_too_new_for_code_compiled_so(tree: Tree, cmake: str, distro: str) -> None:
    code = "#include <pcl/point_types.h>\n"
    assert tree(ros1(cmake, code, "Tested with ROS Noetic")).ros_distro == distro


def test_a_package_compiled_as_cpp11_tells_nothing_of_another(tree: Tree) -> None:
    files = ros1("", "#include <pcl/point_types.h>\n", "Tested with ROS Noetic")
    other = ros1("add_compile_options(-std=c++11)\n", "#include <vector>\n", "")
    moved = {f"{folder}/{path}": text for folder, each in (("a", files), ("b", other)) for path, text in each.items()}
    moved["b/package.xml"] = PACKAGE.replace("demo", "other")
    assert tree(moved | {"README.md": "Tested with ROS Noetic"}).ros_distro == "noetic"


@pytest.mark.parametrize(
    ("adds", "distro"),
    [
        ("", "noetic"),
        ("add_subdirectory(sdk/other)\n", "noetic"),
        ("add_subdirectory(${CMAKE_CURRENT_SOURCE_DIR}/sdk)\n", "melodic"),
        ("add_subdirectory(${SDK})\n", "melodic"),
    ],
)
def test_cpp11_of_a_project_that_its_package_never_adds_tells_nothing(tree: Tree, adds: str, distro: str) -> None:
    files = ros1(f"add_executable(b sdk/cloud.cpp)\n{adds}", "#include <vector>\n", "Tested with ROS Noetic")
    files["sdk/CMakeLists.txt"] = 'project(sdk)\nset(CMAKE_CXX_FLAGS "-std=c++11")\nadd_library(sdk cloud.cpp)\n'
    files["sdk/cloud.cpp"] = "#include <pcl/point_types.h>\n"
    assert tree(files).ros_distro == distro


def test_a_newer_cmake_that_a_folder_asks_for_counts_where_pip_has_none(tree: Tree) -> None:
    files = ros1(page="Tested with ROS Indigo")
    assert tree(files).ros_distro == "indigo"
    files["CMakeLists.txt"] += "add_subdirectory(part)\n"
    files["part/CMakeLists.txt"] = "cmake_minimum_required(VERSION 3.1.3)\nadd_library(part part.cpp)\n"
    assert tree(files).ros_distro == "kinetic"
