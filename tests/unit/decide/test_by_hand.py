"""What a page builds by hand, links to or clones, as a stage, a source, or nothing."""

from __future__ import annotations

import subprocess
from collections.abc import Callable
from pathlib import Path

import pytest

from roslab.decide.decision import Decision
from roslab.pipeline import plan_repository
from roslab.render.dockerfile import dockerfile

Tree = Callable[[dict[str, str]], Decision]
PACKAGE = "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend></package>"


def ros1(cmake: str, page: str) -> dict[str, str]:
    made = f"project(demo)\nfind_package(catkin REQUIRED)\n{cmake}"
    return {"package.xml": PACKAGE, "CMakeLists.txt": made, "README.md": f"ROS Noetic\n{page}"}


ARCHIVE = """\
```
wget -O gtsam.zip https://github.com/borglab/gtsam/archive/refs/tags/4.1.1.zip
unzip gtsam.zip
cd gtsam-4.1.1/
mkdir build && cd build
cmake -DGTSAM_BUILD_TESTS=ON -DGTSAM_POSE3_EXPMAP=ON ..
sudo make install -j16
```
"""
CLONE = """\
```
git clone https://github.com/borglab/gtsam.git
cd gtsam
git checkout 4.0.2
mkdir build
cd build
cmake ..
make install
```
"""


SITE = """\
```
wget http://ceres-solver.org/ceres-solver-2.0.0.tar.gz
tar zxf ceres-solver-2.0.0.tar.gz
mkdir ceres-bin && cd ceres-bin
cmake ../ceres-solver-2.0.0
make -j3 && sudo make install
```
"""


def test_an_archive_of_a_projects_site_is_the_tag(tree: Tree) -> None:
    (source,) = tree(ros1("find_package(Ceres 2.0 REQUIRED)\n", SITE)).source
    assert (source.name, source.ref, source.place and source.place.line) == ("ceres", "2.0.0", 3)


UNPACKED = """\
root="$HOME/wire"
source="$root/src"
curl -OL "https://github.com/lab/libwire/archive/refs/tags/v1.4.tar.gz"
mkdir -p "$source"
tar -xf v1.4.tar.gz {} "$source" --strip-components 1
cmake -S "$source" -B "$root/build" -DWIRE_TESTS=OFF
cmake --build "$root/build" --target install
"""


@pytest.mark.parametrize(
    ("into", "module", "built"),
    [
        ("-C", "find_package(libwire REQUIRED)\n", [("v1.4", "-DWIRE_TESTS=OFF")]),
        (
            "--directory",
            "find_package(PkgConfig)\nfind_package(libwire 1.2 REQUIRED)\n",
            [("v1.4", "-DWIRE_TESTS=OFF")],
        ),
        ("-X", "find_package(libwire REQUIRED)\n", []),
        ("-C", "if(WIN32)\nfind_package(libwire REQUIRED)\nendif()\n", []),
        ("-C", "find_package(libwire)\n", []),
    ],
)
def test_an_archive_that_is_unpacked_into_another_folder_is_compiled_there(
    tree: Tree, into: str, module: str, built: list[tuple[str, str]]
) -> None:
    files = {"CMakeLists.txt": "project(demo)\nfind_package(Cable REQUIRED)\nadd_executable(demo a.cpp)\n"}
    files |= {"cmake/FindCable.cmake": module, "a.cpp": "int main() {}\n", "ci/install_wire.sh": UNPACKED.format(into)}
    assert [(source.ref, source.cmake_options) for source in tree(files).source] == built


@pytest.mark.parametrize("into", ["", "-C /opt", "-C ."])
def test_an_archive_keeps_its_own_folder_beside_others(tree: Tree, into: str) -> None:
    """The folder of several is not the name of the last one."""
    fetched = "".join(
        f"wget https://github.com/lab/{name}/archive/v1.0.tar.gz\ntar -xf v1.0.tar.gz {into}\n"
        for name in ("libwire", "libcable")
    )
    script = f"cd /opt\n{fetched}cd /opt/libwire-1.0\ncmake -DWIRE_TESTS=OFF .\nmake install\n"
    files = {"CMakeLists.txt": "project(demo)\nfind_package(libwire REQUIRED)\nadd_executable(demo a.cpp)\n"}
    files |= {"a.cpp": "int main() {}\n", "ci/install.sh": script}
    assert [(source.name, source.cmake_options) for source in tree(files).source] == [("libwire", "-DWIRE_TESTS=OFF")]


@pytest.mark.parametrize(("page", "ref"), [("", "4.0.3"), (ARCHIVE, "4.1.1"), (CLONE, "4.0.2")])
def test_a_library_is_built_as_the_page_builds_it(tree: Tree, page: str, ref: str) -> None:
    decision = tree(ros1("find_package(GTSAM REQUIRED)\n", page))
    assert [(source.name, source.ref) for source in decision.source] == [("gtsam", ref)]
    assert "ros-noetic-gtsam" not in decision.apt_guessed


@pytest.mark.parametrize("host", ["https://github.com/", "git@github.com:", "ssh://git@github.com/"])
def test_a_library_that_is_cloned_into_a_folder_of_its_name_is_compiled_there(tree: Tree, host: str) -> None:
    page = f"git clone -b v2 {host}lab/fork.git acme_lidar\ncd acme_lidar/build\ncmake ..\nmake install\n"
    decision = tree(ros1("find_package(acme_lidar REQUIRED)\n", f"```\n{page}```\n"))
    assert [(each.repo, each.ref) for each in decision.source] == [("https://github.com/lab/fork.git", "v2")]


def test_a_package_that_is_cloned_into_a_folder_of_its_name_is_a_sister(tree: Tree) -> None:
    files = ros1("", "```\ncd ~/catkin_ws/src\ngit clone https://github.com/lab/ROS-drivers.git acme_driver\n```\n")
    files["package.xml"] = PACKAGE.replace("</package>", "<depend>acme_driver</depend></package>")
    assert [each.repo for each in tree(files).source] == ["https://github.com/lab/ROS-drivers.git"]


@pytest.mark.parametrize("library", ["Pangolin", "acme_lidar"])
def test_what_the_authors_dockerfile_installs_is_a_library_and_no_package(tree: Tree, library: str) -> None:
    run = f"git clone https://github.com/lab/{library}.git && cd {library} && mkdir build && cd build && cmake .."
    image = {"Dockerfile": f"FROM ros:noetic\nRUN {run} && make install\nCOPY . /ws/src/demo\n"}
    decision = tree(ros1(f"find_package({library} REQUIRED)\n", "") | image)
    assert [(each.name.lower(), each.build) for each in decision.source] == [(library.lower(), "cmake")]


@pytest.mark.parametrize("path", [".devcontainer/Dockerfile", "Dockerfile"])
@pytest.mark.parametrize("folder", ["/opt/acme_lidar/build", "acme_lidar/build"])
def test_what_a_dockerfile_for_an_editor_compiles_where_workdir_is(tree: Tree, path: str, folder: str) -> None:
    run = (
        "WORKDIR /opt\nRUN git clone -b v2.1 https://github.com/lab/acme_lidar.git\nRUN mkdir acme_lidar/build\n"
        f"WORKDIR {folder}\nRUN cmake .. -DBUILD_APPS=OFF\nRUN make -j4\nRUN make install\nWORKDIR /ws\n"
        "RUN git clone -b v3 https://github.com/lab/acme_radar.git\nRUN cmake -DX=1 . && make install\n"
    )
    files = ros1("find_package(acme_lidar REQUIRED)\nfind_package(acme_radar REQUIRED)\n", "")
    decision = tree(files | {path: f"FROM ros:noetic\n{run}"})
    found = [(each.name, each.ref, each.cmake_options) for each in decision.source if each.build == "cmake"]
    assert found == [("acme_lidar", "v2.1", "-DBUILD_APPS=OFF")]


LINKED = "add_executable(a a.cpp)\nif(WITH_G)\ntarget_link_libraries(a grasplib)\nendif()\n"
SWITCHED = "```\nmkdir build && cd build\ncmake -DWITH_G=ON ..\n```\n"


def test_the_options_of_the_page_win(tree: Tree) -> None:
    options = tree(ros1("find_package(GTSAM REQUIRED)\n", ARCHIVE)).source[0].cmake_options.split()
    assert "-DGTSAM_POSE3_EXPMAP=ON" in options
    assert [word for word in options if word.startswith("-DGTSAM_BUILD_TESTS")] == ["-DGTSAM_BUILD_TESTS=ON"]


@pytest.mark.parametrize(
    ("cmake", "page", "names"),
    [
        ("find_library(G NAMES grasplib PATHS /usr/local/lib)\n", "(https://github.com/lab/grasplib#a)", ["grasplib"]),
        ("find_package(grasplib REQUIRED)\n", "See https://github.com/lab/grasplib.", ["grasplib"]),
        ("find_package(GRASP REQUIRED)\n", "- `libGrasp`: (https://github.com/lab/libGrasp_base)", ["libGrasp_base"]),
        ("find_package(GRASP QUIET)\n", "- `libGrasp`: (https://github.com/lab/libGrasp_base)", []),
        ("find_package(other REQUIRED)\n", "- `libGrasp`: (https://github.com/lab/libGrasp_base)", []),
        ("find_package(scout REQUIRED)\n", "It runs on [a robot](https://github.com/lab/scout_base).", []),
        ("find_package(grasplib QUIET)\n", "See https://github.com/lab/grasplib.", []),
        ("find_package(grasplib REQUIRED)\n", "See https://github.com/lab/other.", []),
        ("find_package(grasplib REQUIRED)\n", "See https://github.com/lab/grasplib/issues/3.", []),
        ("find_package(Eigen3 REQUIRED)\n", "See https://github.com/lab/eigen3.", []),
        (f"option(WITH_G 'g' ON)\n{LINKED}", "See https://github.com/lab/grasplib.", ["grasplib"]),
        (f"option(WITH_G 'g' OFF)\n{LINKED}", "See https://github.com/lab/grasplib.", []),
        (f"option(WITH_G 'g' OFF)\n{LINKED}", f"{SWITCHED}See https://github.com/lab/grasplib.", ["grasplib"]),
    ],
)  # fmt: skip
def test_a_linked_library_that_cmake_asks_for(tree: Tree, cmake: str, page: str, names: list[str]) -> None:
    found = tree(ros1(cmake, page)).source
    assert [source.name for source in found] == names
    assert all(source.build == "cmake" for source in found)


def test_what_is_cloned_without_a_ref_is_taken_as_it_was(tmp_path: Path) -> None:
    files = ros1("find_package(grasplib REQUIRED)\n", "See https://github.com/lab/grasplib.")
    for path, text in files.items():
        (tmp_path / path).write_text(text, encoding="utf-8")
    for words in (("init",), ("add", "."), ("commit", "--message", "a", "--date", "2019-01-25T00:00:00Z")):
        identity = ("-c", "user.name=a", "-c", "user.email=a@example.org")
        environment = {"GIT_COMMITTER_DATE": "2019-01-25T00:00:00Z", "PATH": "/usr/local/bin:/usr/bin:/bin"}
        subprocess.run(
            ["git", "-C", str(tmp_path), *identity, *words], check=True, capture_output=True, env=environment
        )
    text = dockerfile(plan_repository(tmp_path).plan)
    assert "--before=2019-01-25T23:59:59Z HEAD" in text
    assert '"${commit:-HEAD}"' in text


LAUNCHED = """\
from launch import LaunchDescription
LaunchDescription([Node({more}package='lidar_driver', executable='a'{after})])
"""


@pytest.mark.parametrize(
    ("more", "after", "names"),
    [
        ("", "", ["lidar_driver"]),
        ("", ", condition=IfCondition(x)", []),
        ("condition=LaunchConfigurationEquals('a', 'b'), ", "", []),
    ],
)
def test_a_driver_that_is_started_under_a_condition_is_not_cloned(
    tree: Tree, more: str, after: str, names: list[str]
) -> None:
    files = {
        "package.xml": PACKAGE.replace("catkin", "ament_cmake"),
        "CMakeLists.txt": "project(demo)\nfind_package(ament_cmake REQUIRED)\n",
        "launch/a.launch.py": LAUNCHED.format(more=more, after=after),
        "README.md": "ROS Humble\n```\ngit clone https://github.com/lab/lidar_driver\n```\n",
    }
    assert [source.name for source in tree(files).source] == names


@pytest.mark.parametrize(
    ("update", "config", "file"),
    [
        ("rosdep update", "", "Dockerfile"),
        ("rosdep update", "repair: false\n", None),
        ("rosdep update --rosdistro kinetic", "repair: false\n", "Dockerfile"),
        ("rosdep update --include-eol-distros", "repair: false\n", "Dockerfile"),
        ("apt-get update", "repair: false\n", "Dockerfile"),
    ],
)
def test_an_authors_dockerfile_without_tables_is_built_where_they_are_brought(
    tmp_path: Path, update: str, config: str, file: str | None
) -> None:
    made = f"FROM ros:kinetic-ros-base\nCOPY . /ws/src/demo\nRUN {update}\nRUN cd /ws && catkin_make\n"
    files = {"README.md": "", "Dockerfile": made, "roslab.yaml": f"format: 3\n{config}"}
    for path, text in {**ros1("", ""), **files}.items():
        (tmp_path / path).write_text(text, encoding="utf-8")
    assert plan_repository(tmp_path).decision.dockerfile == file


def test_what_cmake_clones_needs_git(tree: Tree) -> None:
    files = {
        "CMakeLists.txt": "project(demo CXX)\ninclude(external/glow.cmake)\nadd_executable(a a.cpp)\n",
        "external/glow.cmake": "FetchContent_Declare(glow GIT_REPOSITORY https://github.com/x/glow.git)\n",
        "a.cpp": "int main() {}\n",
    }
    assert "git" in tree(files).apt_guessed
    files["external/glow.cmake"] = "# GIT_REPOSITORY\n"
    assert "git" not in tree(files).apt_guessed


def test_what_cmake_fetches_itself_is_not_built_beside_it(tree: Tree) -> None:
    page = "It needs [PoseLib](https://github.com/PoseLib/PoseLib).\n"
    git = "GIT_REPOSITORY https://github.com/PoseLib/PoseLib.git GIT_TAG v2"
    fetch = f"include(FetchContent)\nFetchContent_Declare(poselib {git})\n"
    asked = "find_package(PoseLib REQUIRED)\n"
    assert [source.name for source in tree(ros1(asked, page)).source] == ["PoseLib"]
    assert tree(ros1(fetch + asked, page)).source == ()
    assert tree(ros1(f"need(NAME poselib {git})\n{asked}", page)).source == ()


@pytest.mark.parametrize(("added", "built"), [("add_subdirectory(external/strange3)\n", []), ("", ["strange3"])])
def test_what_the_tree_compiles_for_itself_is_not_built_beside_it(tree: Tree, added: str, built: list[str]) -> None:
    page = "```\ngit clone https://github.com/lab/strange3.git\ncd strange3/build\ncmake ..\nsudo make install\n```\n"
    linked = f"{added}set(LIB strange3)\nadd_executable(demo main.cpp)\ntarget_link_libraries(demo ${{LIB}})\n"
    copy = {
        "external/strange3/CMakeLists.txt": "project(strange3)\nadd_subdirectory(src)\n",
        "external/strange3/src/CMakeLists.txt": "add_library(strange3 a.cpp)\n",
    }
    assert [source.name for source in tree(ros1(linked, page) | copy).source] == built


def test_a_linked_library_is_found_with_and_without_lib(tree: Tree) -> None:
    page = "Install [libstrange3](https://github.com/somebody/libstrange3) first.\n"
    sources = tree(ros1("find_package(strange3 REQUIRED)\n", page)).source
    assert [(source.name, source.repo) for source in sources] == [
        ("libstrange3", "https://github.com/somebody/libstrange3")
    ]


VIKIT = "find_package(catkin REQUIRED COMPONENTS vikit_common)\n"
NEEDS_VIKIT = PACKAGE.replace("</package>", "<build_depend>vikit_common</build_depend></package>")


def test_a_package_of_the_table_is_cloned_under_the_name_of_its_repository(tree: Tree) -> None:
    decision = tree(ros1(VIKIT, "") | {"package.xml": NEEDS_VIKIT})
    assert [source.name for source in decision.source] == ["sophus", "rpg_vikit"]
    assert "vikit_common" in decision.skip_keys  # no key of rosdep: the repository holds it


def test_a_copy_that_the_page_clones_is_the_only_one(tree: Tree) -> None:
    page = "```\ngit clone https://github.com/somebody/rpg_vikit.git\n```\n"
    decision = tree(ros1(VIKIT, page) | {"package.xml": NEEDS_VIKIT})
    cloned = [source.repo for source in decision.source if source.name == "rpg_vikit"]
    assert cloned == ["https://github.com/somebody/rpg_vikit.git"]


def test_what_only_a_package_xml_names_is_not_cloned(tree: Tree) -> None:
    listed = "find_package(catkin REQUIRED COMPONENTS roscpp)\n"
    assert tree(ros1(listed, "") | {"package.xml": NEEDS_VIKIT}).source == ()


@pytest.mark.parametrize(
    ("page", "names"),
    [
        ("| [acme_arm](https://github.com/lab/acme_arm) | [vikit_common](https://github.com/lab/vikit_common) |",
         ["sophus", "rpg_vikit", "acme_arm"]),
        ("| [acme_legs](https://github.com/lab/acme_legs) | acme_arm |", []),
    ],
)  # fmt: skip
def test_what_a_metapackage_names_and_its_page_links_to_is_cloned_with_its_own_needs(
    tree: Tree, page: str, names: list[str]
) -> None:
    needs = "<depend>acme_arm</depend><depend>vikit_common</depend><test_depend>acme_legs</test_depend>"
    listed = "find_package(catkin REQUIRED COMPONENTS rospy)\n"
    manifest = {"package.xml": PACKAGE.replace("</package>", f"{needs}</package>")}
    found = tree(ros1(listed, page) | manifest).source
    assert [source.name for source in found if not source.holding] == names


LISTED = """\
- git: {local-name: gtsam, uri: 'https://github.com/borglab/gtsam.git', version: VERSION}
- git: {local-name: acme, uri: 'https://github.com/lab/acme.git', version: v1}
"""


@pytest.mark.parametrize(("version", "ref"), [("4.1.1", "4.1.1"), ("develop", "develop"), ("master", "4.0.3")])
def test_a_library_in_a_list_is_built_before_the_workspace(tree: Tree, version: str, ref: str) -> None:
    files = ros1("find_package(GTSAM REQUIRED)\n", "") | {"demo.rosinstall": LISTED.replace("VERSION", version)}
    assert [(s.name, s.ref, s.build) for s in tree(files).source] == [
        ("gtsam", ref, "cmake"),
        ("acme", "v1", "catkin_make"),
    ]


@pytest.mark.parametrize(
    ("asked", "built"),
    [("acme REQUIRED", [("acme", "v1")]), ("acme QUIET", []), ("libacme REQUIRED", [("acme", "v1")]), ("beta", [])],
)
def test_a_library_in_a_list_of_a_project_without_ros(
    tree: Tree, asked: str, built: list[tuple[str, str | None]]
) -> None:
    listed = "repositories:\n  acme:\n    type: git\n    url: https://github.com/lab/Acme.git\n    version: v1\n"
    listed += "  beta:\n    type: git\n    url: https://github.com/lab/beta.git\n    version: v2\n"
    made = f"project(demo CXX)\nfind_package({asked})\nadd_executable(demo a.cpp)\n"
    files = {"CMakeLists.txt": made, "a.cpp": "int main() {}\n", ".ci/deps.yaml": listed}
    assert [(source.name, source.ref) for source in tree(files).source] == built


NEWER = """\
#!/bin/bash
DIR="/tmp/dependencies"
install_pcl()
{
  PCL_DIR="pcl"
  BUILD_DIR="build"
  cd $DIR
  git clone https://github.com/PointCloudLibrary/pcl.git
  cd $PCL_DIR
  git checkout pcl-1.11.1
  mkdir -p $BUILD_DIR
  cd $BUILD_DIR
  cmake .. -DBUILD_tools=OFF
  cd $DIR/$PCL_DIR/$BUILD_DIR
  sudo make install
}
"""


@pytest.mark.parametrize(("asked", "distro", "built"), [("1.11", "noetic", ["pcl"]), ("1.8", "melodic", [])])
def test_a_release_that_no_ubuntu_has_is_built_as_a_script_builds_it(
    tree: Tree, asked: str, distro: str, built: list[str]
) -> None:
    code = "" if asked == "1.8" else "#include <filesystem>\n"
    files = ros1(f"find_package(PCL {asked} REQUIRED)\n", "")
    files |= {"README.md": "Tested with ROS Melodic\n", "install_deps.sh": NEWER, "a.cpp": code}
    decision = tree(files)
    assert decision.ros_distro == distro
    assert [(source.name, source.build) for source in decision.source] == [(name, "cmake") for name in built]
    assert all(source.cmake_options == "-DBUILD_tools=OFF" for source in decision.source)


RELEASED = """\
WIRE="1.4.2"
wget https://github.com/lab/libwire/releases/download/v"${WIRE}"/wire-"${WIRE}".zip -O wire.zip
unzip wire.zip && cd "wire-${WIRE}"
mkdir build && cd build
cmake .. && sudo make -j4 install
cd ../..
wget https://github.com/open-source-parsers/jsoncpp/archive/1.9.4.zip
unzip 1.9.4.zip && cd jsoncpp-1.9.4
mkdir build && cd build
cmake .. && sudo make install
"""


@pytest.mark.parametrize(
    ("asked", "built"),
    [
        ("wire 1.4.2 REQUIRED", ["https://github.com/lab/libwire v1.4.2"]),
        (
            "jsoncpp 1.9.4 REQUIRED EXACT",
            ["https://github.com/lab/libwire v1.4.2", "https://github.com/open-source-parsers/jsoncpp 1.9.4"],
        ),
        ("jsoncpp 1.7 REQUIRED", []),
        ("jsoncpp REQUIRED", []),
    ],
)
def test_the_release_that_cmake_asks_for_is_built_where_a_script_builds_it(
    tree: Tree, asked: str, built: list[str]
) -> None:
    files = {**ros1(f"find_package({asked})\n", ""), "scripts/install/bridge.sh": RELEASED}
    assert [f"{source.repo} {source.ref}" for source in tree(files).source] == built


CAMERA = """\
```
wget https://github.com/luxonis/depthai-core/releases/download/v3.2.1/{}-v3.2.1.tar.gz
tar -xvf {}-v3.2.1.tar.gz
cd {}-v3.2.1
mkdir build && cd build
cmake ..
make && sudo make install
```
"""


@pytest.mark.parametrize(("archive", "built"), [("depthai-core", True), ("depthai-core-linux-x64", False)])
def test_a_release_that_is_called_like_its_repository_wins_over_the_package_of_ros(
    tree: Tree, archive: str, built: bool
) -> None:
    """CMake asks for it without the word behind the hyphen; of another name it is a file for one system."""
    made = "project(demo)\nfind_package(ament_cmake REQUIRED)\nfind_package(depthai CONFIG REQUIRED)\nament_package()\n"
    package = PACKAGE.replace("catkin", "ament_cmake")
    page = f"ROS 2 Humble\n{CAMERA.replace('{}', archive)}"
    decision = tree({"package.xml": package, "CMakeLists.txt": made, "README.md": page})
    assert [(source.name, source.ref) for source in decision.source] == [("depthai-core", "v3.2.1")] * built
    assert ("ros-humble-depthai" in decision.apt_guessed) is not built
    assert all("libudev-dev" in source.depends for source in decision.source)


@pytest.mark.parametrize("ubuntu", ["14.04", "20.04"])
def test_the_header_of_zeromq_is_built_where_ubuntu_has_it_without_its_package_of_cmake(
    tree: Tree, ubuntu: str
) -> None:
    """https://github.com/zeromq/cppzmq/issues/620"""
    wants = {"CMakeLists.txt": "project(demo)\nfind_package(cppzmq REQUIRED)\nadd_executable(demo a.cpp)\n"}
    header = {"a.cpp": "#include <zmq.hpp>\n"}
    older = tree({**wants, **header, "README.md": f"Tested on Ubuntu {ubuntu}\n"})
    assert [(source.name, source.ref) for source in older.source] == [("cppzmq", "v4.7.1")]
    assert {"libzmq3-dev", "pkg-config"} <= {*older.apt, *older.apt_guessed}
    newer = tree({**wants, **header, "README.md": "Tested on Ubuntu 24.04\n"})
    assert newer.source == ()
    assert "cppzmq-dev" in newer.apt


SOCKETS = {
    "CMakeLists.txt": "project(demo)\nadd_executable(demo main.cpp)\ntarget_link_libraries(demo z uWS)\n",
    "main.cpp": "#include <uWS/uWS.h>\nint main() {}\n",
}
PAGE = "```\ngit clone https://github.com/uWebSockets/uWebSockets\ncd uWebSockets\ngit checkout e94b6e1\n```\n"


def test_a_library_that_is_linked_and_cloned_is_built(tree: Tree, tmp_path: Path) -> None:
    decision = tree({**SOCKETS, "README.md": PAGE})
    assert [source.name for source in decision.source] == ["uwebsockets"]
    assert not [warning for warning in decision.warnings if "not cloned" in warning.message]
    for name, text in {**SOCKETS, "README.md": PAGE}.items():
        (tmp_path / name).write_text(text)
    # Where its own make install puts it, no program would find it
    assert 'mv "$DESTDIR"/usr/lib64/libuWS.* "$DESTDIR/usr/lib/"' in dockerfile(plan_repository(tmp_path).plan)


def test_a_library_that_is_the_repository_itself_is_not_built_beside_it(tree: Tree) -> None:
    own = SOCKETS["CMakeLists.txt"].replace("project(", "project(uWebSockets)\nproject(", 1)
    assert tree({**SOCKETS, "CMakeLists.txt": own, "README.md": PAGE}).source == ()


def test_a_library_that_is_only_linked_may_be_compiled_beside_it(tree: Tree) -> None:
    alone = {**SOCKETS, "main.cpp": "int main() {}\n", "README.md": "Run `./demo`\n"}
    assert tree(alone).source == ()
    own = SOCKETS["CMakeLists.txt"].replace("add_executable", "add_library(uWS all.cpp)\nadd_executable")
    assert tree({**SOCKETS, "CMakeLists.txt": own, "README.md": PAGE}).source == ()


@pytest.mark.parametrize("call", ["add_project_dependency", "ADD_PROJECT_PRIVATE_DEPENDENCY"])
def test_a_macro_that_finds_a_package_asks_for_it(tree: Tree, call: str) -> None:
    made = f"project(demo)\n{call}(yaml-cpp 0.5 REQUIRED)\nadd_executable(demo main.cpp)\n"
    assert "libyaml-cpp-dev" in tree({"CMakeLists.txt": made, "main.cpp": "int main() {}\n"}).apt


@pytest.mark.parametrize(
    ("asked", "built"),
    [("DLoopDetector", ["dlib-dorian3d", "dbow2", "dloopdetector"]), ("DLib", ["dlib-dorian3d"]), ("DBoW2", ["dbow2"])],
)
def test_a_library_of_places_is_built_with_what_its_own_cmake_requires(
    tree: Tree, asked: str, built: list[str]
) -> None:
    made = f"project(demo)\nfind_package({asked} REQUIRED)\nadd_executable(demo main.cpp)\n"
    page = f"It needs [{asked}](https://github.com/dorian3d/{asked}).\n"
    decision = tree({"CMakeLists.txt": made, "main.cpp": "int main() {}\n", "README.md": page})
    assert [source.name for source in decision.source] == built
    assert all("libopencv-dev" in source.depends for source in decision.source)


@pytest.mark.parametrize(
    ("said", "ref"),
    [
        ("* [odd](https://github.com/lab/oddlib) @ 84bfc56", "84bfc56"),
        (
            "[odd](https://github.com/lab/oddlib) (commit `84bfc56320371bed97cab8aad3aa9561ca931d3f`)",
            "84bfc56320371bed97cab8aad3aa9561ca931d3f",
        ),
        ("[odd](https://github.com/lab/oddlib), and https://github.com/lab/oddlib @ 84bfc56", "84bfc56"),
        ("[odd](https://github.com/lab/oddlib) @ defaced.example.org", None),
        (
            "* Install [odd](https://github.com/lab/oddlib), [Guide](https://a.org/odd) (Tested Commit: 84bfc56)",
            "84bfc56",
        ),
        (
            "* [odd](https://github.com/lab/oddlib),\n  tested with 84bfc56320371bed97cab8aad3aa9561ca931d3f\n",
            "84bfc56320371bed97cab8aad3aa9561ca931d3f",
        ),
        ("* [odd](https://github.com/lab/oddlib)\n* at commit 84bfc56", None),
        ("* [odd](https://github.com/lab/oddlib) and https://github.com/lab/even (commit 84bfc56)", None),
        (
            "[odd](https://github.com/lab/oddlib), see https://a.org/blob/84bfc56320371bed97cab8aad3aa9561ca931d3f/x",
            None,
        ),
        ("[odd](https://github.com/lab/oddlib) was tested with 1234567 points", None),
    ],
)
def test_a_link_is_taken_at_the_commit_behind_it(tree: Tree, said: str, ref: str | None) -> None:
    made = "project(demo)\nfind_package(oddlib REQUIRED)\nadd_executable(demo main.cpp)\n"
    decision = tree({"CMakeLists.txt": made, "main.cpp": "int main() {}\n", "README.md": f"# Needs\n{said}\n"})
    assert [(source.name, source.ref) for source in decision.source] == [("oddlib", ref)]


@pytest.mark.parametrize(("linked", "built"), [("sdd", ["sddlib"]), ("sddlib", ["sddlib"]), ("sddother", [])])
def test_a_library_may_be_linked_without_the_lib_at_its_end(tree: Tree, linked: str, built: list[str]) -> None:
    made = f"project(demo)\nadd_executable(demo main.cpp)\ntarget_link_libraries(demo {linked})\n"
    page = "```\ngit clone https://github.com/lab/sddlib.git\ncd sddlib\ncmake .\nmake\nsudo make install\n```\n"
    decision = tree({"CMakeLists.txt": made, "main.cpp": "int main() {}\n", "INSTALL.md": page})
    assert [source.name for source in decision.source if not source.unasked] == built


def test_a_repository_is_no_library_of_its_own_examples(tree: Tree) -> None:
    root = "cmake_minimum_required(VERSION 3.10)\nproject(acme_sdk)\nadd_library(acme_sdk a.cpp)\n"
    sample = "cmake_minimum_required(VERSION 3.10)\nproject(sample)\nfind_package(acme_sdk REQUIRED)\n"
    sample += "add_executable(walk walk.cpp)\n"
    files = {"CMakeLists.txt": root, "sample/CMakeLists.txt": sample, "README.md": "https://github.com/lab/acme_sdk\n"}
    assert [source.name for source in tree(files).source] == []
    other = files | {"CMakeLists.txt": f"{root.replace('acme_sdk', 'else')}add_subdirectory(sample)\n"}
    assert [source.name for source in tree(other).source] == ["acme_sdk"]


def test_a_library_that_another_is_made_for_is_built_before_it(tree: Tree) -> None:
    files = ros1("find_package(OsqpEigen REQUIRED)\n", "")
    found = tree(files)
    assert [source.name for source in found.source] == ["osqp", "osqp-eigen"]


@pytest.mark.parametrize(("on", "refs"), [("20.04", ["v0.15.3", "v3.7.2"]), ("22.04", ["v0.15.3", "v3.9.0"])])
def test_yarp_is_built_after_its_cmake_modules(tree: Tree, on: str, refs: list[str]) -> None:
    cmake = "project(demo)\nfind_package(YARP REQUIRED)\nadd_executable(a a.cpp)\n"
    page = f"On Ubuntu {on} it needs [YARP](https://github.com/robotology/yarp).\n"
    found = tree({"CMakeLists.txt": cmake, "a.cpp": "int main() {}\n", "README.md": page})
    assert [(source.name, source.ref) for source in found.source] == list(zip(["ycm", "yarp"], refs, strict=True))
    assert not [name for name in (*found.apt, *found.apt_guessed) if "osqp" in name]  # ROS has OSQP alone


def test_a_library_that_a_page_builds_has_the_headers_that_the_code_includes(tree: Tree) -> None:
    page = "```\nsudo apt install libnowhere-dev\ngit clone https://github.com/acme/acme.git\ncd acme\n"
    page += "mkdir build && cd build\ncmake ..\nsudo make install\n```\n"
    made = "project(demo)\nfind_package(acme REQUIRED)\nadd_executable(demo main.cpp)\n"
    found = tree({"CMakeLists.txt": made, "main.cpp": "#include <Eigen/Dense>\nint main() {}\n", "README.md": page})
    assert [(source.name, source.depends) for source in found.source] == [("acme", ("libeigen3-dev",))]


UVC = """\
```
sudo apt install libusb-1.0-0-dev libunheardof-dev
git clone https://github.com/lab/acmecam.git
cd acmecam && mkdir build && cd build
cmake .. && make -j4
sudo make install
```
"""


@pytest.mark.parametrize(
    ("asked", "names"),
    [
        ("pkg_search_module(CAM REQUIRED libacmecam)", ["acmecam"]),
        ("pkg_check_modules(CAM REQUIRED acmecam>=0.2)", ["acmecam"]),
        ("pkg_check_modules(CAM acmecam)", []),
        ("if(WITH_CAM)\npkg_check_modules(CAM REQUIRED acmecam)\nendif()", []),
    ],
)
def test_a_library_that_pkg_config_is_asked_for_is_built_as_the_page_builds_it(
    tree: Tree, asked: str, names: list[str]
) -> None:
    decision = tree(ros1(f"find_package(PkgConfig REQUIRED)\n{asked}\n", UVC))
    assert [source.name for source in decision.source] == names
    told = [each.message for each in decision.warnings if "acmecam" in each.message]
    assert bool(told) is not bool(names)


def test_a_library_built_by_hand_has_the_headers_that_the_page_installs_and_ubuntu_has(tree: Tree) -> None:
    decision = tree(ros1("find_package(PkgConfig REQUIRED)\npkg_search_module(CAM REQUIRED libacmecam)\n", UVC))
    assert "libusb-1.0-0-dev" in decision.source[0].depends
    assert "libunheardof-dev" not in decision.source[0].depends


def test_a_library_built_by_hand_is_built_with_what_apt_of_roslab_yaml_names(tmp_path: Path) -> None:
    pages = ros1("find_package(PkgConfig REQUIRED)\npkg_search_module(CAM REQUIRED libacmecam)\n", UVC)
    for name, text in {**pages, "roslab.yaml": "apt: [groff]\n"}.items():
        (tmp_path / name).write_text(text)
    assert "groff" in plan_repository(tmp_path).plan.libraries[0].depends


@pytest.mark.parametrize(
    ("lines", "ref"),
    [
        ("git clone https://github.com/lab/grasplib.git\ncd grasplib\ngit checkout 84bfc56 # the last\n", "84bfc56"),
        ("git clone https://github.com/lab/grasplib.git\ngit clone -b v2 https://github.com/lab/grasplib.git\n", None),
    ],
)
def test_a_library_that_a_page_clones_and_does_not_install_is_built_at_its_ref(
    tree: Tree, lines: str, ref: str | None
) -> None:
    page = f"```\n{lines}mkdir build && cd build\ncmake ..\n```\n"
    made = "project(demo)\nfind_package(grasplib REQUIRED)\nadd_executable(demo demo.cpp)\n"
    decision = tree({"CMakeLists.txt": made, "demo.cpp": "int main() {}\n", "README.md": page})
    assert [(source.name, source.ref) for source in decision.source] == [("grasplib", ref)]


BY_SCRIPT = """\
git clone https://github.com/lab/acmelib.git
cd acmelib
git checkout 0123456789abcdef0123456789abcdef01234567
mkdir build
cd build
cmake -G Ninja -DPIC=ON -DCMAKE_INSTALL_PREFIX=/usr/local/stow/acmelib ..
ninja
sudo ninja install
"""
SUBMODULE = '[submodule "mapping"]\n\tpath = mapping\n\turl = https://github.com/lab/mapping.git\n'


@pytest.mark.parametrize(
    ("more", "built"),
    [
        ({".gitmodules": SUBMODULE}, [("acmelib", "-DPIC=ON")]),
        ({".gitmodules": SUBMODULE, "mapping/CMakeLists.txt": "project(mapping)\n"}, []),  # read: it asks for nothing
        ({}, []),
    ],
)
def test_what_a_submodule_that_is_not_there_may_ask_for_is_built_as_the_script_builds_it(
    tree: Tree, more: dict[str, str], built: list[tuple[str, str]]
) -> None:
    decision = tree(ros1("", "") | {"install_acmelib.sh": BY_SCRIPT} | more)
    found = [(each.name, each.cmake_options) for each in decision.source if each.build == "cmake"]
    assert found == built
    assert all(each.unasked for each in decision.source)  # nothing that was read asks for it


def test_what_apt_has_is_not_built_for_a_submodule_that_is_not_there(tree: Tree) -> None:
    script = BY_SCRIPT.replace("lab/acmelib", "google/glog").replace("acmelib", "glog")
    decision = tree(ros1("", "") | {"install_glog.sh": script, ".gitmodules": SUBMODULE})
    assert [each.name for each in decision.source if each.build == "cmake"] == []


@pytest.mark.parametrize(("above", "needs"), [(True, True), (False, False)])
def test_what_a_page_compiles_above_a_library_is_what_that_may_need(tree: Tree, above: bool, needs: bool) -> None:
    eigen = "cd ~\ngit clone https://gitlab.com/libeigen/eigen.git\ncd eigen/build\ncmake ..\nmake install\n"
    acme = "cd ~\ngit clone https://github.com/lab/acme.git\ncd acme/build\ncmake ..\nmake install\n"
    page = f"```\n{eigen + acme if above else acme + eigen}```\n"
    (found,) = (each for each in tree(ros1("find_package(acme REQUIRED)\n", page)).source if each.name == "acme")
    assert ("libeigen3-dev" in found.depends) is needs


@pytest.mark.parametrize(
    ("line", "built", "warned"),
    [
        ("target_link_libraries(demo /usr/local/lib/libnlopt.so)", True, False),
        ("target_link_libraries(demo nlopt)", False, False),
        ("target_link_libraries(demo /usr/local/lib/libasound.so)", False, True),
        ("if(APPLE)\ntarget_link_libraries(demo /usr/local/lib/libnlopt.so)\nendif()", False, False),
    ],
)
def test_a_library_that_is_linked_by_its_file_below_usr_local(
    tree: Tree, line: str, *, built: bool, warned: bool
) -> None:
    package = "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend></package>"
    cmake = f"project(demo)\nfind_package(catkin REQUIRED)\nadd_library(demo a.cpp)\n{line}\n"
    decision = tree({"package.xml": package, "CMakeLists.txt": cmake, "a.cpp": "int a;\n"})
    assert ("nlopt" in {source.name for source in decision.source}) is built
    assert any("linked by its file" in each.message for each in decision.warnings) is warned


EXTENSION = """\
from setuptools import Extension, setup
setup(
    name="demo",
    install_requires=["torch==1.13.1+cu117"],
    ext_modules=[Extension("planner", ["a.cpp"], {linked})],
)
"""


@pytest.mark.parametrize(
    ("linked", "page", "built", "warned"),
    [
        ('extra_objects=["/usr/local/lib/libompl.so"]', True, ["ompl"], False),
        ('extra_objects=["/usr/local/lib/libompl.so"]', False, [], True),
        ('libraries=["ompl"]', True, [], False),
        ('# extra_objects=["/usr/local/lib/libompl.so"]\n', True, [], False),
    ],
)
def test_a_library_that_a_setup_py_links_by_its_file_below_usr_local(
    tree: Tree, linked: str, *, page: bool, built: list[str], warned: bool
) -> None:
    files = {"setup.py": EXTENSION.format(linked=linked), "a.cpp": "#include <ompl/util/Console.h>\nint a;\n"}
    if page:
        files["README.md"] = "```\ngit clone git@github.com:ompl/ompl.git ../ompl\ncd ../ompl\ncmake .\n"
        files["README.md"] += "sudo make install\n```\n"
    decision = tree(files)
    assert [source.name for source in decision.source] == built
    assert any("linked by its file" in each.message for each in decision.warnings) is warned


IN_ITS_SECTION = """\
# Dependencies
## {title}
`git clone https://github.com/RainerKuemmerle/g2o.git`

Tested until this commit: `git checkout 4b9c2f5b68d14ad479457b18c5a2a0bce1541a90`
```
mkdir build && cd build
cmake ..
make
sudo make install
```
"""


@pytest.mark.parametrize(
    ("title", "cmake", "built", "skipped"),
    [
        ("g2o", "find_package(G2O REQUIRED)\n", ["g2o"], ["libg2o"]),
        ("g2o", "find_package(G2O REQUIRED)\nfind_package(catkin REQUIRED libg2o)\n", ["g2o"], []),
        ("Build", "find_package(G2O REQUIRED)\n", [], None),
    ],
)
def test_what_stands_in_a_librarys_own_section_is_done_in_its_folder(
    tree: Tree, title: str, cmake: str, built: list[str], skipped: list[str] | None
) -> None:
    files = ros1(cmake, IN_ITS_SECTION.format(title=title))
    files["package.xml"] = PACKAGE.replace("</package>", "<depend>libg2o</depend></package>")
    decision = tree(files)
    assert [each.name for each in decision.source if each.build == "cmake"] == built
    assert skipped is None or list(decision.skip_keys) == skipped


@pytest.mark.parametrize(
    ("options", "cloned"),
    [
        ("", []),
        ("cmake -DUSE_LOOPS=ON ..", ["DLib"]),
        ("catkin_make -DUSE_LOOPS=ON", ["DLib"]),
        ("catkin_make -DTHREADS=ON\ncatkin_make -DUSE_LOOPS=ON", []),
    ],
)
def test_a_clone_that_waits_for_an_option_that_is_off_is_none_of_the_workspace(
    tree: Tree, options: str, cloned: list[str]
) -> None:
    cmake = "option(USE_LOOPS loops OFF)\nif(USE_LOOPS)\nfind_package(DLib REQUIRED)\nendif()\n"
    page = f"```\ncd ~/catkin_ws/src\ngit clone https://github.com/dorian3d/DLib.git\n```\n```\n{options}\n```\n"
    assert [each.name for each in tree(ros1(cmake, page)).source] == cloned


def test_a_clone_beside_the_key_of_another_name_is_told_as_such(tree: Tree) -> None:
    files = ros1("", "```\ncd ~/catkin_ws/src\ngit clone https://github.com/RainerKuemmerle/g2o.git\n```\n")
    files["package.xml"] = PACKAGE.replace("</package>", "<depend>libg2o</depend></package>")
    said = [warning.message for warning in tree(files).warnings if "is cloned from" in warning.message]
    assert len(said) == 1
    assert said[0].endswith("which is installed, too: the build may find either")


@pytest.mark.parametrize(("also", "cloned"), [(True, ["darknet_ros"]), (False, ["darknet"])])
def test_no_other_clone_stands_for_a_package_that_one_is_called_like(tree: Tree, also: bool, cloned: list[str]) -> None:
    line = "git clone https://github.com/lab/{}.git\n"
    page = "".join(map(line.format, ["darknet", "darknet_ros"] if also else ["darknet"]))
    files = ros1("", f"```\n{page}```\n")
    files["package.xml"] = PACKAGE.replace("</package>", "<depend>darknet_ros</depend></package>")
    assert [each.name for each in tree(files).source] == cloned


def test_the_reason_for_a_library_says_who_names_its_source(tree: Tree) -> None:
    page = "Needs [acme_lidar](https://github.com/lab/acme_lidar)\n"
    said = [each.reason for each in tree(ros1("find_package(acme_lidar REQUIRED)\n", page)).reasons]
    assert "acme_lidar is needed, and README.md:2 names its source" in said


LINKED = "Physics are those of [acme_solver](https://github.com/acme/acme_solver).\n"
MADE = "ExternalProject_Add(outside URL https://example.org/acme.zip)\nadd_library(acme_solver INTERFACE)\n"


@pytest.mark.parametrize(
    ("adds", "inner", "built"),
    [
        ("add_subdirectory(contrib)\n", MADE, []),
        ("", MADE, ["acme_solver"]),
        ("add_subdirectory(contrib)\n", MADE.replace("INTERFACE", "SHARED IMPORTED"), ["acme_solver"]),
    ],
)
def test_a_target_that_the_tree_makes_is_no_outside_library(
    tree: Tree, adds: str, inner: str, built: list[str]
) -> None:
    outer = f"project(demo)\n{adds}add_executable(demo main.cpp)\ntarget_link_libraries(demo acme_solver)\n"
    files = {"CMakeLists.txt": outer, "contrib/CMakeLists.txt": inner, "README.md": LINKED}
    decision = tree({**files, "main.cpp": "int main() {}\n"})
    assert [source.name for source in decision.source] == built
    assert all(source.unasked for source in decision.source)


def test_a_library_that_is_required_stops_the_build(tree: Tree) -> None:
    outer = "project(demo)\nfind_package(acme_solver REQUIRED)\nadd_executable(demo main.cpp)\n"
    (source,) = tree({"CMakeLists.txt": outer, "README.md": LINKED, "main.cpp": "int main() {}\n"}).source
    assert not source.unasked


PACKED = """\
FROM ubuntu:18.04
RUN git clone --branch v5.8.5 git://github.com/acme/bus.git /opt/bus && \\
    cd /opt/bus && mkdir build && cd build && \\
    cmake .. -DHAS_QT5=OFF && make && \\
    cpack -G DEB && dpkg -i _deploy/bus-*
"""
LOCAL = """\
git clone --branch v5.9.0 git://github.com/acme/bus.git ~/bus
cd ~/bus
mkdir build
cd build
cmake .. -D HAS_QT5=ON
cpack -G DEB
sudo dpkg -i _deploy/bus-*
"""
TOP = "cmake_minimum_required(VERSION 3.5)\nproject(demo)\nfind_package(bus REQUIRED)\nadd_executable(a a.cpp)\n"


@pytest.mark.parametrize(
    ("files", "built"),
    [
        ({"docker/base/Dockerfile": PACKED, "docker/base/local.sh": LOCAL}, ("v5.8.5", "-DHAS_QT5=OFF")),
        ({"install_bus.sh": LOCAL}, ("v5.9.0", "-DHAS_QT5=ON")),
        ({"install_bus.sh": LOCAL.replace("cmake .. -D HAS_QT5=ON\n", "")}, (None, "")),
    ],
)
def test_what_cpack_makes_and_dpkg_installs_is_built_as_it_is_there(
    tree: Tree, files: dict[str, str], built: tuple[str | None, str]
) -> None:
    page = {"README.md": "It talks over [bus](https://github.com/acme/bus).\n", "CMakeLists.txt": TOP, "a.cpp": ""}
    (library,) = tree(page | files).source
    assert (library.ref, library.cmake_options) == built
    assert (library.repo or "").startswith("https://github.com/acme/bus")


def test_the_sdk_of_a_camera_is_built_as_the_dockerfile_builds_it(tree: Tree) -> None:
    recipe = (
        "FROM ubuntu:18.04\nRUN git clone -b v2.35.2 https://github.com/IntelRealSense/librealsense.git /opt/r && "
        "cd /opt/r && mkdir build && cd build && cmake .. -DBUILD_GRAPHICAL_EXAMPLES=true && make install\n"
    )
    cmake = TOP.replace("bus", "realsense2")
    (library,) = tree({"docker/base/Dockerfile": recipe, "CMakeLists.txt": cmake, "a.cpp": ""}).source
    assert (library.name, library.ref) == ("librealsense", "v2.35.2")
    assert library.cmake_options.split()[-1] == "-DBUILD_GRAPHICAL_EXAMPLES=true"
    assert "-DBUILD_GRAPHICAL_EXAMPLES=OFF" not in library.cmake_options


def ros1_script(cmake: str, install: str, code: str = "int a;\n") -> dict[str, str]:
    clone = "cd ~\ngit clone https://github.com/lab/pid-control.git\ncd pid-control\n"
    return {**ros1(f"add_library(demo a.cpp)\n{cmake}", ""), "a.cpp": code, "setup.sh": clone + install}


BY_CMAKE = "mkdir build\ncd build\ncmake ..\nmake install\n"
FILE = "set_target_properties({} PROPERTIES IMPORTED_LOCATION /usr/local/lib/libpid-control.so)\n"


@pytest.mark.parametrize(
    ("cmake", "code", "built"),
    [
        ("add_library(pid-control SHARED IMPORTED)\n" + FILE.format("pid-control"), "int a;\n", ["pid-control"]),
        ("", "#include <PIDControl.h>\n", ["pid-control"]),
        ("", "#include <pid_control/loop.h>\n", ["pid-control"]),
        ("", "#include <PIDController.h>\n", []),
        ("add_library(pid-control b.cpp)\n" + FILE.format("demo"), "int a;\n", []),
    ],
)
def test_a_library_of_a_script_that_the_code_includes_or_whose_file_it_imports(
    tree: Tree, cmake: str, code: str, built: list[str]
) -> None:
    decision = tree(ros1_script(cmake, BY_CMAKE, code))
    assert [source.name for source in decision.source] == built


@pytest.mark.parametrize(
    ("cmake", "code", "unasked"),
    [
        ("", "#ifdef RASPBERRY_PI\n#include <PIDControl.h>\n#endif\n", True),
        ("find_package(pid-control REQUIRED)\n", "#include <PIDControl.h>\n", False),
    ],
)
def test_what_a_script_installs_for_an_include_alone_stops_nothing(
    tree: Tree, cmake: str, code: str, unasked: bool
) -> None:
    decision = tree(ros1_script(cmake, BY_CMAKE, code))
    assert [source.unasked for source in decision.source] == [unasked]
    why = "a.cpp includes PIDControl.h, and setup.sh installs what is called so"
    assert any(why in each.message for each in decision.warnings) == unasked


@pytest.mark.parametrize(
    ("install", "by_make"),
    [
        ("sudo make -j4 install\n", [True]),
        ("make\nsudo make install\n", [True]),
        (BY_CMAKE, [False]),
        ("./configure\nmake install\n", []),
        ("qmake\nmake install\n", []),
        ("make\n", [False]),
    ],
)
def test_a_library_with_a_makefile_of_its_own(tree: Tree, install: str, by_make: list[bool]) -> None:
    decision = tree(ros1_script("find_package(pid-control REQUIRED)\n", install))
    assert [source.by_make for source in decision.source] == by_make


def test_what_a_makefile_installs_is_copied_from_where_it_lies(tmp_path: Path) -> None:
    for name, text in ros1_script("find_package(pid-control REQUIRED)\n", "make install\n").items():
        (tmp_path / name).write_text(text)
    text = dockerfile(plan_repository(tmp_path).plan)
    assert "COPY --from=scripts /install-by-make /usr/local/bin/\n" in text
    assert ' && cd /tmp/sources/pid-control \\\n && install-by-make "$(compile-jobs)"' in text


@pytest.mark.parametrize(
    ("asked", "built"), [("acme", ["acme_sdk"]), ("acme_sdk", ["acme_sdk"]), ("sdk", []), ("acm", [])]
)
def test_a_library_is_asked_for_by_the_name_of_its_sdk(tree: Tree, asked: str, built: list[str]) -> None:
    page = f"```\ngit clone https://github.com/lab/acme_sdk\ncd acme_sdk\n{BY_CMAKE}```\n"
    decision = tree(ros1(f"find_package({asked} REQUIRED)\nadd_library(demo a.cpp)\n", f"## Optional\n{page}"))
    assert [source.name for source in decision.source] == built


STEPS = """\
on: push
jobs:
  build:
    runs-on: ubuntu-20.04
    steps:
    - run: sudo apt-get install build-essential libacme-dev libother-dev ros-noetic-desktop
    - run: |
        git clone https://github.com/{name}
        cd {folder}
        mkdir build && cd build
        cmake ..
        make install
    - run: sudo apt-get install liblater-dev
"""


@pytest.mark.parametrize(("name", "asked"), [("lab/acme_lidar", "acme_lidar"), ("robotology/idyntree", "iDynTree")])
def test_what_ci_installs_before_a_library_is_offered_where_it_is_built(tmp_path: Path, name: str, asked: str) -> None:
    (tmp_path / ".github/workflows").mkdir(parents=True)
    (tmp_path / ".github/workflows/ci.yml").write_text(STEPS.format(name=name, folder=name.partition("/")[2]))
    cmake = f"cmake_minimum_required(VERSION 3.5)\nproject(demo)\nfind_package({asked} REQUIRED)\n"
    (tmp_path / "CMakeLists.txt").write_text(f"{cmake}add_executable(demo main.cpp)\n")
    (tmp_path / "main.cpp").write_text("int main() {}\n")
    plan = plan_repository(tmp_path).plan
    assert [each.offered for each in plan.libraries] == [("build-essential", "libacme-dev", "libother-dev")]
    stage = dockerfile(plan).partition("AS library-1-")[2].partition("\nFROM ")[0]
    assert "    install-optional-apt \\\n      libacme-dev \\\n      libother-dev\n" in stage
    assert stage.index("install-optional-apt") < stage.index("git clone")


SET = """\
on: push
env:
  IDYN_TAG: ce1334ca4a3ef139f6fab72f767292b19c601e07
  VIEW: "OFF"
jobs:
  build:
    runs-on: ubuntu-20.04
    env:
      VIEW: "ON"
    steps:
    - run: {before}
    - env:
        {step}
      run: |
        git clone https://github.com/robotology/idyntree
        cd idyntree
        {checkout}
        mkdir build && cd build
        cmake -DIDYNTREE_USES_IRRLICHT:BOOL=$VIEW -DIDYNTREE_USES_ASSIMP:BOOL=OFF ..
        make install
"""


@pytest.mark.parametrize(
    ("checkout", "step", "ref"),
    [
        ("git checkout ${IDYN_TAG}", "A: b", "ce1334ca4a3ef139f6fab72f767292b19c601e07"),
        ("git checkout $IDYN_TAG", "IDYN_TAG: v1.0.0", "v1.0.0"),
        ("git checkout ${{ env.IDYN_TAG }}", "A: b", "ce1334ca4a3ef139f6fab72f767292b19c601e07"),
        ("git checkout ${{ env.IDYN_TAG }}", "IDYN_TAG: ${{ matrix.tag }}", "v12.3.3"),
        ("ls", "A: b", "v12.3.3"),
    ],
)
def test_ci_gives_a_library_of_the_table_its_ref_and_options(
    tmp_path: Path, checkout: str, step: str, ref: str
) -> None:
    (tmp_path / ".github/workflows").mkdir(parents=True)
    said = SET.format(checkout=checkout, step=step, before="./coinbrew fetch Ipopt@3.13.4 --no-prompt")
    (tmp_path / ".github/workflows/ci.yml").write_text(said)
    cmake = "cmake_minimum_required(VERSION 3.5)\nproject(demo)\nfind_package(iDynTree REQUIRED)\n"
    (tmp_path / "CMakeLists.txt").write_text(f"{cmake}add_executable(demo main.cpp)\n")
    (tmp_path / "main.cpp").write_text("int main() {}\n")
    (library,) = plan_repository(tmp_path).plan.libraries
    options = library.cmake_options.split()
    assert library.ref == ref
    assert "-DBUILD_TESTING=OFF" in options
    assert options[-2:] == ["-DIDYNTREE_USES_IRRLICHT:BOOL=ON", "-DIDYNTREE_USES_ASSIMP:BOOL=OFF"]
    assert "-DIDYNTREE_USES_ASSIMP=ON" not in options
    assert "coinor-libipopt-dev" in library.offered


@pytest.mark.parametrize(
    ("call", "offered"),
    [
        ("coinbrew/coinbrew build Ipopt --prefix=install/", ("coinor-libipopt-dev",)),
        ("bash coinbrew fetch Cbc Clp:stable/1.17", ("coinor-libcbc-dev", "coinor-libclp-dev")),
        ("coinbrew --help Ipopt", ()),
        ("coinbrew fetch Other", ()),
    ],
)
def test_what_coinbrew_builds_comes_from_apt(tmp_path: Path, call: str, offered: tuple[str, ...]) -> None:
    (tmp_path / ".github/workflows").mkdir(parents=True)
    (tmp_path / ".github/workflows/ci.yml").write_text(SET.format(checkout="ls", step="A: b", before=call))
    cmake = "cmake_minimum_required(VERSION 3.5)\nproject(demo)\nfind_package(iDynTree REQUIRED)\n"
    (tmp_path / "CMakeLists.txt").write_text(f"{cmake}add_executable(demo main.cpp)\n")
    (library,) = plan_repository(tmp_path).plan.libraries
    assert library.offered == offered


def in_dockerfile(repository: str) -> dict[str, str]:
    run = f"git clone https://github.com/lab/{repository}.git && cd {repository} && git checkout v1.1 && "
    run += "cmake -Bbuild -H. && cmake --build build/ --target install"
    return {"docker/base/Dockerfile": f"FROM ros:noetic\nRUN {run}\n"}


@pytest.mark.parametrize(
    ("asked", "repository"),
    [("FooMqttCpp", "foo.mqtt.cpp"), ("foo-mqtt-cpp", "FooMqttCpp"), ("PahoMqttCpp", "paho.mqtt.cpp")],
)
def test_what_a_dockerfile_installs_is_found_whatever_separates_the_words(
    tree: Tree, asked: str, repository: str
) -> None:
    decision = tree(ros1(f"find_package({asked} REQUIRED)\n", "") | in_dockerfile(repository))
    assert [(each.name, each.ref, each.unasked) for each in decision.source] == [(repository, "v1.1", False)]


def test_short_names_are_not_run_together(tree: Tree) -> None:
    decision = tree(ros1("find_package(AbCd REQUIRED)\n", "") | in_dockerfile("ab-cd"))
    assert [each.name for each in decision.source if not each.unasked] == []


def test_what_the_ubuntu_has_by_now_is_not_compiled(tree: Tree) -> None:
    files = ros1("find_package(PahoMqttCpp REQUIRED)\n", "") | in_dockerfile("paho.mqtt.cpp")
    files["package.xml"] = PACKAGE.replace("catkin<", "ament_cmake<")
    files |= {"README.md": "ROS 2 Humble\n", "CMakeLists.txt": files["CMakeLists.txt"].replace("catkin", "rclcpp")}
    files["docker/base/Dockerfile"] = (
        files["docker/base/Dockerfile"].replace("v1.1", "master").replace("noetic", "humble")
    )
    decision = tree(files)
    assert "libpaho-mqttpp-dev" in decision.apt_guessed or "libpaho-mqttpp-dev" in decision.apt


BESIDE = "git clone https://github.com/lab/acme.git {into}\ncd {into_or}\n{go}cmake {source}\nmake\nsudo make install\n"


@pytest.mark.parametrize(
    ("into", "go", "source", "folder"),
    [
        ("", "mkdir build && cd build\n", "../src", "../src"),
        ("/opt/acme_3", "mkdir build\ncd build\n", "../src/", "../src"),
        ("", "mkdir -p build/release && cd build/release\n", "../../lib/core", "../lib/core"),
        ("", "mkdir build && cd build\n", "../", None),
        ("", "mkdir -p build/release && cd build/release\n", "../..", None),
        ("", "", "../src", None),  # beside the clone: nothing is known of that
    ],
)
def test_a_folder_beside_the_build_folder_is_the_one_that_cmake_is_told(
    tree: Tree, into: str, go: str, source: str, folder: str | None
) -> None:
    page = BESIDE.format(into=into, into_or=into or "acme", go=go, source=source)
    made = "project(demo)\nfind_package(acme REQUIRED)\nadd_executable(demo demo.cpp)\n"
    files = {"CMakeLists.txt": made, "demo.cpp": "int main() {}\n"}
    in_page = tree(files | {"README.md": f"```\n{page}```\n"})
    run = page.replace("sudo ", "").strip().replace("\n", " && \\\n    ")
    in_dockerfile = tree(
        files | {"docker/Dockerfile": f"FROM ubuntu:24.04\nRUN {run}\nRUN git clone http://a.b/c.git\n"}
    )
    for decision in (in_page, in_dockerfile):
        assert [(each.name, each.cmake_folder) for each in decision.source] == [("acme", folder)]


OWN_IMAGE = """\
FROM ubuntu:24.04
RUN git clone https://github.com/lab/acme.git && cd acme && mkdir build && cd build && cmake .. && make install
RUN git clone https://github.com/lab/acme-hopper.git /opt/hop && \\
    cd /opt/hop && mkdir build && cd build && cmake ../src && make install
RUN git clone https://github.com/lab/acme-cloud.git && \\
    cd acme-cloud && mkdir build && cd build && cmake .. && make install
RUN git clone https://github.com/lab/own.git
"""


@pytest.mark.parametrize(
    ("header", "built"),
    [
        ("acme/plugins/robots/hopper/sensor.h", ["acme", "acme-hopper"]),
        ("acme/plugins/hopper_sensor.h", ["acme"]),
        ("other/acme/hopper/sensor.h", ["acme"]),
        ("sensor.h", ["acme"]),  # in no folder
    ],
)
def test_a_plugin_of_the_authors_image_whose_headers_are_included(tree: Tree, header: str, built: list[str]) -> None:
    made = "project(demo)\nfind_package(acme REQUIRED)\nadd_executable(demo demo.cpp)\n"
    code = f"#include <{header}>\nint main() {{}}\n"
    decision = tree({"CMakeLists.txt": made, "demo.cpp": code, "docker/Dockerfile": OWN_IMAGE})
    assert [each.name for each in decision.source] == built
    told = [w.message for w in decision.warnings if "installs what is called so" in w.message]
    assert len(told) == len(built) - 1


def test_what_the_table_switches_off_is_off_where_a_page_builds_it(tree: Tree) -> None:
    clone = "git clone https://github.com/ilpincy/argos3.git\ncd argos3\n"
    page = f"{clone}mkdir build\ncd build\ncmake {{}}../src\nmake\nmake install\n"
    made = "project(demo)\nfind_package(acme REQUIRED)\nadd_executable(demo demo.cpp)\n"
    more = "git clone https://github.com/lab/acme.git\ncd acme/build\ncmake ..\nmake install\n"
    files = {"CMakeLists.txt": made, "demo.cpp": "int main() {}\n"}
    for said, options in {
        "": "-DARGOS_DOCUMENTATION=OFF",
        "-DARGOS_DOCUMENTATION=ON ": "-DARGOS_DOCUMENTATION=ON",
    }.items():
        decision = tree(files | {"README.md": f"```\n{page.format(said)}cd ../..\n{more}```\n"})
        assert [(each.cmake_options, each.cmake_folder) for each in decision.source] == [
            (options, "../src"),
            ("", None),
        ]


def test_a_library_of_the_table_whose_project_lies_below_its_root(tmp_path: Path) -> None:
    (tmp_path / "CMakeLists.txt").write_text(
        "project(demo)\nfind_package(ARGoS REQUIRED)\nadd_executable(demo demo.cpp)\n"
    )
    (tmp_path / "demo.cpp").write_text("int main() {}\n")
    text = dockerfile(plan_repository(tmp_path).plan)
    assert " -DCMAKE_BUILD_TYPE=Release -DARGOS_DOCUMENTATION=OFF ../src" in text
