"""ROS repositories whose pages, lists and layouts are unlike most: what is read all the same, what is not believed."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from roslab.decide.decision import Decision
from trees import decided

CATKIN = (
    "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend><build_depend>roscpp</build_depend>"
    "{more}</package>"
)
AMENT = (
    '<package format="3"><name>demo</name><buildtool_depend>ament_cmake</buildtool_depend>'
    "<export><build_type>ament_cmake</build_type></export></package>"
)


def catkin(more: str = "") -> dict[str, str]:
    return {"package.xml": CATKIN.format(more=more), "CMakeLists.txt": "project(demo)\nfind_package(catkin REQUIRED)\n"}


def ament() -> dict[str, str]:
    return {"package.xml": AMENT, "CMakeLists.txt": "project(demo)\nfind_package(ament_cmake REQUIRED)\n"}


SUBMODULE = '[submodule "planner"]\n\tpath = planner\n\turl = https://github.com/x/planner.git\n'
REPOS = "repositories:\n  a:\n    type: git\n    url: https://github.com/x/a.git\n    version: main\n"
ROSBUILD = "include($ENV{ROS_ROOT}/core/rosbuild/rosbuild.cmake)\nrosbuild_init()\nrosbuild_add_executable(a a.cpp)\n"


@pytest.mark.parametrize(
    ("files", "kind"),
    [
        ({"requirements.txt": "numpy\n", "team.repos": REPOS}, "ros2"),
        ({"requirements.txt": "numpy\n", "tools/team.repos": REPOS}, "python"),
        ({".gitmodules": SUBMODULE, "README.md": "ROS Noetic\n\n    catkin_make\n"}, "ros1"),
        ({".gitmodules": SUBMODULE, "README.md": "Shown at a ROS Noetic meeting\n", "a.py": "import x\n"}, "python"),
        ({"core/CMakeLists.txt": ROSBUILD, "core/manifest.xml": "<package/>"}, "ros1"),
        ({"CMakeLists.txt": "project(a)\n", "Examples/ROS/CMakeLists.txt": ROSBUILD}, "cpp"),
    ],
)  # fmt: skip
def test_what_a_repository_without_a_manifest_is(tmp_path: Path, files: dict[str, str], kind: str) -> None:
    assert decided(tmp_path, files).kind == kind


def test_rosbuild_is_not_built_and_that_is_said(tmp_path: Path) -> None:
    found = decided(tmp_path, {"core/CMakeLists.txt": ROSBUILD, "README.md": "    apt install ros-indigo-libg2o\n"})
    assert (found.ros_distro, found.packages) == ("indigo", ())
    assert any("rosmake" in warning.message for warning in found.warnings)


def test_a_macro_of_qt_build_makes_no_package_of_rosbuild(tmp_path: Path) -> None:
    calls = "find_package(catkin REQUIRED COMPONENTS qt_build roscpp)\nrosbuild_prepare_qt4(QtCore QtGui)\n"
    found = decided(tmp_path, catkin() | {"CMakeLists.txt": f"project(gui)\n{calls}catkin_package()\n"})
    assert not any("rosbuild" in warning.message for warning in found.warnings)


def test_a_tool_of_ros_is_no_package_of_a_distribution(tmp_path: Path) -> None:
    readme = "ROS noetic\n\n    sudo apt install ros-dev-tools ros-hydro-tf2 ros-noetic-joy\n"
    found = decided(tmp_path, {**catkin(), "README.md": readme})
    assert {"ros-dev-tools", "ros-noetic-joy"} <= set(found.apt_guessed)
    assert not {"ros-noetic-tools", "ros-noetic-tf2", "ros-hydro-tf2"} & set(found.apt_guessed)


def test_lines_for_another_distribution_count_where_there_are_none_for_this_one(tmp_path: Path) -> None:
    files = {
        "README.md": "    sudo apt install ros-melodic-joy libb\n",
        "INSTALL.md": "    apt install ros-kinetic-slam\n",
    }
    found = decided(tmp_path, {**catkin(), **files}, branch="melodic-devel")
    assert {"ros-melodic-joy", "ros-melodic-slam", "libb"} <= set(found.apt_guessed)


TRAVIS = "before_install:\n  - sudo apt-get install -y ros-{}-desktop {}\n"


@pytest.mark.parametrize(
    ("page", "found"),
    [
        ("ROS Noetic\n\n    sudo apt install ros-noetic-tf2-ros\n", ["libpopt-dev"]),
        ("ROS Noetic\n", ["gawk", "libpopt-dev"]),
    ],
)
def test_ci_for_another_distribution_where_a_page_is_for_this_one(tmp_path: Path, page: str, found: list[str]) -> None:
    files = {**catkin(), "README.md": page, ".travis.yml": TRAVIS.format("melodic", "gawk libpopt-dev")}
    decision = decided(tmp_path, files, branch="noetic-devel")
    assert sorted({*decision.apt, *decision.apt_guessed} & {"gawk", "libpopt-dev"}) == found


def test_ci_for_several_distributions_counts_whole(tmp_path: Path) -> None:
    page = "ROS Noetic\n\n    sudo apt install ros-noetic-tf2-ros\n"
    both = TRAVIS.format("noetic", "gawk") + "  - sudo apt-get install -y ros-melodic-joy\n"
    decision = decided(tmp_path, {**catkin(), "README.md": page, ".travis.yml": both}, branch="noetic-devel")
    assert "gawk" in {*decision.apt, *decision.apt_guessed}


def test_launch_files_of_the_other_ros_ask_for_nothing(tmp_path: Path) -> None:
    old = '<launch><node pkg="fancy_pkg" name="a" type="b"/><node pkg="turtlesim" name="c" type="d"/></launch>'
    assert "ros-humble-turtlesim" not in decided(tmp_path, {**ament(), "old/launch/a.launch": old}).apt_guessed
    new = "<launch><node pkg='turtlesim' exec='d'/></launch>"
    assert "ros-humble-turtlesim" in decided(tmp_path, {**ament(), "launch/b.launch.xml": new}).apt_guessed


@pytest.mark.parametrize(
    ("files", "branch", "distro"),
    [
        ({"README.md": "ROS >= Foxy (Recommend to use ROS-Humble)"}, "ros2", "humble"),
        ({"README.md": "Install ROS kinetic, lunar or melodic", "ros_lunar.rosinstall": "- git: {local-name: a, uri: 'https://x.org/a'}"}, None, "melodic"),  # noqa: E501
        ({"README.md": "Ubuntu 18.04~20.04"}, None, "noetic"),
        ({"README.md": "Ubuntu 18.04. Version 20.04.1 of the paper"}, None, "melodic"),
        ({"Jenkinsfile": "image 'x/ros-melodic:1'", ".github/workflows/ci.yml": "container: x/ros-noetic:1\n"}, None, "noetic"),  # noqa: E501
    ],
)  # fmt: skip
def test_what_counts_more_for_a_distribution(
    tmp_path: Path, files: dict[str, str], branch: str | None, distro: str
) -> None:
    made = ament() if branch == "ros2" else catkin()
    assert decided(tmp_path, {**made, **files}, branch=branch).ros_distro == distro


def test_an_unknown_key_that_a_submodule_or_a_slip_explains(tmp_path: Path) -> None:
    files = catkin("<build_depend>planner</build_depend><build_depend>tf_conversion</build_depend>")
    found = decided(tmp_path, {**files, ".gitmodules": SUBMODULE})
    assert any("planner" in w.message and "git submodule update" in w.message for w in found.warnings)
    assert any("is tf_conversions meant?" in w.message for w in found.warnings)


@pytest.mark.parametrize(
    ("line", "started"),
    [
        ("ros2 component standalone demo demo::Talker", True),
        ("Run `ros2 component standalone demo demo::Talker -p rate:=2` to start.", True),
        ("ros2 component standalone demo", False),  # of which class
        ("ros2 component standalone image_tools image_tools::ShowImage", False),  # another package's
        ("ros2 component load /Container demo demo::Talker", False),  # into what runs already
    ],
)
def test_a_component_that_a_page_starts(tmp_path: Path, line: str, started: bool) -> None:
    page = line if "`" in line else f"```\n{line}\n```"
    files = {**ament(), "README.md": f"# Demo\n## Usage\n{page}\n"}
    command = (
        "ros2",
        "component",
        "standalone",
        "demo",
        "demo::Talker",
        *(("-p", "rate:=2") if "rate" in line else ()),
    )
    assert decided(tmp_path, files).command == (command if started else ("bash",))


def test_a_viewer_beside_the_packages_is_no_default(tmp_path: Path) -> None:
    pages = {"README.md": "```\nros2 run rviz2 rviz2\n```\n"}
    assert decided(tmp_path, {**ament(), **pages}).command == ("bash",)
    own = {"README.md": "```\nros2 run rviz2 rviz2\nros2 launch demo a.launch.py\n```\n"}
    own["launch/a.launch.py"] = "from launch import LaunchDescription\n"
    assert decided(tmp_path, {**ament(), **own}).command == ("ros2", "launch", "demo", "a.launch.py")


def test_calls_that_leave_something_to_the_reader_are_no_candidates(tmp_path: Path) -> None:
    page = "```\nros2 launch demo a.launch.py host:=<sensor host name> # change <a> it\nros2 launch\n```\n"
    assert decided(tmp_path, {**ament(), "README.md": page}).command_candidates == ()


@pytest.mark.parametrize("asks", ["-s", "--show-args", "--ros-args"])
def test_a_call_that_only_asks_is_no_default(tmp_path: Path, asks: str) -> None:
    page = f"```\nros2 launch demo a.launch.py {asks}\n```\n"
    assert decided(tmp_path, {**ament(), "README.md": page}).command == ("bash",)


@pytest.mark.parametrize("asks", ["--ros-args", "--nodes"])
def test_a_call_of_roslaunch_that_only_asks_comes_after_what_starts(tmp_path: Path, asks: str) -> None:
    page = f"Run `roslaunch demo a.launch {asks}` to see more.\n\nRun `roslaunch demo a.launch` to start it.\n"
    files = {**catkin(), "launch/a.launch": "<launch/>", "launch/b.launch": "<launch/>", "README.md": page}
    assert decided(tmp_path, files).command == ("roslaunch", "demo", "a.launch")


@pytest.mark.parametrize(
    ("page", "command"),
    [
        ("demo/docs/source/start/usage.rst", "roslaunch demo b.launch"),
        ("docs/pages/Running-Demo.rst", "roslaunch demo b.launch"),
        ("docs/pages/history.rst", "bash"),
    ],
)
def test_a_page_of_the_documentation_about_running_it(tmp_path: Path, page: str, command: str) -> None:
    text = "Usage\n=====\n\nLaunch it:\n\n.. code-block:: bash\n\n    roslaunch demo b.launch\n"
    files = {**catkin(), "launch/a.launch": "<launch/>", "launch/b.launch": "<launch/>", page: text}
    assert " ".join(decided(tmp_path, files).command) == command


def test_requirements_of_a_second_folder_of_documentation(tmp_path: Path) -> None:
    found = decided(tmp_path, {**ament(), "docs2/requirements.txt": "furo\n", "nodes/requirements.txt": "rowan\n"})
    assert found.python.requirements == ("nodes/requirements.txt",)


def test_of_several_lists_the_one_that_the_page_names_is_imported(tmp_path: Path) -> None:
    files = {f"{name}.rosinstall": f"- git: {{local-name: {name}, uri: 'https://x.org/{name}'}}\n" for name in "abc"}
    assert len(decided(tmp_path, {**catkin(), **files}).source) == 3
    found = decided(tmp_path, {"README.md": "    wget https://x.org/raw/master/b.rosinstall\n"})
    assert ([source.name for source in found.source], found.vcs) == (["b"], ("b.rosinstall",))


def test_a_list_that_a_script_must_fill_in_is_not_imported(tmp_path: Path) -> None:
    template = REPOS.replace("version: main", "version: ${ROS_DISTRO}")
    found = decided(tmp_path, {**ament(), "docker/deps.repos": template})
    assert (found.source, found.vcs) == ((), ())


def test_clones_for_another_distribution_are_not_taken(tmp_path: Path) -> None:
    image = "FROM ros:{name}\nRUN git clone https://github.com/x/helper {ref}\nCOPY . /ws/src/demo\nRUN catkin_make\n"
    files = {
        "docker/noetic/Dockerfile": image.format(name="noetic", ref=""),
        "docker/melodic/Dockerfile": image.format(name="melodic", ref="-b melodic"),
        **catkin("<build_depend>helper</build_depend>"),
    }
    (source,) = decided(tmp_path, files, branch="noetic-devel").source
    assert (source.name, source.ref) == ("helper", None)


def test_a_clone_related_to_a_key_that_nobody_released(tmp_path: Path) -> None:
    page = "    git clone https://github.com/x/lab_vikit.git\n    git clone https://github.com/x/some_common.git\n"
    found = decided(tmp_path, {**catkin("<build_depend>vikit_ros</build_depend>"), "README.md": page})
    assert [source.name for source in found.source] == ["lab_vikit"]
    assert not any("the clone is used" in warning.message for warning in found.warnings)


@pytest.mark.parametrize(
    ("branch", "said", "version"), [("melodic", "2.7", "2.7"), ("melodic", "3.6", None), ("noetic", "2.7", None)]
)
def test_packages_go_to_the_python_of_the_nodes(tmp_path: Path, branch: str, said: str, version: str | None) -> None:
    files = {**catkin(), "requirements.txt": "rospkg\n", "README.md": f"It needs Python {said} of ROS.\n"}
    found = decided(tmp_path, files, branch=branch)
    assert (found.python.version, found.python.requirements) == (version, ("requirements.txt",))
    told = any(warning.message.startswith("Python 2.7 is asked for") for warning in found.warnings)
    assert told == (branch == "noetic")


def test_submodules_that_are_not_checked_out_are_said_to_be_missing(tmp_path: Path) -> None:
    gone = decided(tmp_path, {**catkin(), ".gitmodules": SUBMODULE})
    (warning,) = [w for w in gone.warnings if "not checked out" in w.message]
    assert (warning.file, warning.line) == (".gitmodules", 3)
    here = decided(tmp_path, {"planner/src/a.cpp": "int a;\n"})
    assert not any("not checked out" in w.message for w in here.warnings)


def test_a_sentence_about_an_error_names_no_distribution(tree: Callable[[dict[str, str]], Decision]) -> None:
    page = 'If using ROS melodic, you may get "error: expected constructor".\n\nWe develop in ROS kinetic.\n'
    files = {"package.xml": "<package><name>a</name><buildtool_depend>catkin</buildtool_depend></package>"}
    cmake = "project(a)\nfind_package(catkin REQUIRED)\n"
    assert tree({**files, "CMakeLists.txt": cmake, "README.md": page}).ros_distro == "kinetic"


def test_a_cloned_repository_holds_packages_that_begin_with_its_name(
    tree: Callable[[dict[str, str]], Decision],
) -> None:
    package = "<package><name>a</name><buildtool_depend>ament_cmake</buildtool_depend>"
    package += "<depend>moveit_task_constructor_core</depend></package>"
    page = "Tested on ROS 2 Humble.\n\n    git clone https://github.com/moveit/moveit_task_constructor.git\n"
    files = {"package.xml": package, "CMakeLists.txt": "project(a)\nfind_package(ament_cmake REQUIRED)\n"}
    assert tree({**files, "README.md": page}).ros_distro == "humble"


@pytest.mark.parametrize(
    ("page", "distro"),
    [("Dependencies: python 2.7\n", "melodic"), ("python 2.7 or Python 3.6\n", "noetic"), ("", "noetic")],
)
def test_python_2_names_the_last_distribution_that_has_it(tmp_path: Path, page: str, distro: str) -> None:
    cmake = "project(demo)\nfind_package(catkin REQUIRED)\n"
    files = {"package.xml": CATKIN.format(more=""), "CMakeLists.txt": cmake, "README.md": page}
    assert decided(tmp_path, files).ros_distro == distro


@pytest.mark.parametrize(
    ("page", "first", "python"),
    [
        ("ROS kinetic\n", "#!/usr/bin/env python", "2.7"),
        ("ROS kinetic\n", "#!/usr/bin/env python3", None),
        ("ROS kinetic with Python 3.5\n", "#!/usr/bin/env python", None),
        ("ROS noetic\n", "#!/usr/bin/env python", None),
    ],
)
def test_the_python_of_nodes_is_that_of_their_first_line(
    tmp_path: Path, page: str, first: str, python: str | None
) -> None:
    files = {"package.xml": CATKIN.format(more=""), "CMakeLists.txt": "project(demo)\nfind_package(catkin REQUIRED)\n"}
    files |= {"README.md": page, "scripts/node.py": f"{first}\nimport scipy\n", "requirements.txt": "scipy\n"}
    assert decided(tmp_path, files).python.version == python


CI = "jobs:\n  build:\n    runs-on: ubuntu-latest\n    container: ros:noetic\n    steps:\n      - run: catkin_make\n"


@pytest.mark.parametrize(
    ("ci", "distro"), [(CI, "noetic"), (CI.replace("noetic", "kinetic"), "kinetic"), ("", "kinetic")]
)
def test_the_name_of_a_branch_yields_to_a_ci_that_tests_only_others(tmp_path: Path, ci: str, distro: str) -> None:
    package = "<package><name>a</name><buildtool_depend>catkin</buildtool_depend></package>"
    files = {"package.xml": package, "CMakeLists.txt": "project(a)\nfind_package(catkin REQUIRED)\n"}
    found = decided(tmp_path, files | ({".github/workflows/ci.yml": ci} if ci else {}), branch="kinetic-devel")
    assert found.ros_distro == distro


IN_ROS2 = (
    "<package format='3'><name>a</name><version>1.0.0</version><description>x</description>"
    "<buildtool_depend>ament_cmake</buildtool_depend><export><build_type>ament_cmake</build_type></export></package>"
)
REF = "      ref_for_tests: {}\n"
TESTS = "jobs:\n  a:\n    uses: ./.github/workflows/ici.yml\n    with:\n      ros_distro: {distro}\n"


@pytest.mark.parametrize(
    ("branch", "files", "distro"),
    [
        ("main", {"new": ("rolling", REF.format("main")), "old": ("humble", REF.format("humble"))}, "rolling"),
        ("humble", {"new": ("rolling", REF.format("main")), "old": ("humble", REF.format("humble"))}, "humble"),
        ("main", {"old": ("humble", "on:\n  push:\n    branches: [humble]\n")}, "humble"),
        (
            "main",
            {"new": ("jazzy", ""), "old": ("humble", "on:\n  push:\n    branches:\n      - humble-devel\n")},
            "jazzy",
        ),
    ],
)
def test_ci_of_another_branch(tmp_path: Path, branch: str, files: dict[str, tuple[str, str]], distro: str) -> None:
    (tmp_path / ".github/workflows").mkdir(parents=True)
    for name, (tested, more) in files.items():
        text = TESTS.format(distro=tested)
        (tmp_path / f".github/workflows/{name}.yml").write_text(more + text if more.startswith("on") else text + more)
    made = {
        "package.xml": IN_ROS2,
        "CMakeLists.txt": "project(a)\nfind_package(ament_cmake REQUIRED)\nament_package()\n",
    }
    found = decided(tmp_path, made, branch=branch)
    assert found.ros_distro == distro


@pytest.mark.parametrize(
    "page",
    [
        "This is the `main/humble` branch, only for ROS 2 Humble. Switch over to `jazzy` branch for ROS 2 Jazzy.",
        "This branch is for ROS 2 Humble. For ROS 2 Jazzy, use the `jazzy` branch.",
    ],
)
def test_what_a_page_says_of_its_own_branch(tmp_path: Path, page: str) -> None:
    cmake = "project(a)\nfind_package(ament_cmake REQUIRED)\nament_package()\n"
    assert (
        decided(tmp_path, {"package.xml": IN_ROS2, "CMakeLists.txt": cmake, "README.md": page}).ros_distro == "humble"
    )


@pytest.mark.parametrize(
    ("branch", "tested", "distro"),
    [
        ("ros2-jazzy", "humble, iron, rolling", "jazzy"),
        ("ros2-humble", "iron, jazzy", "jazzy"),
        ("jazzy", "rolling", "rolling"),
    ],
)
def test_a_branch_for_a_newer_distribution_than_ci_has_is_no_old_name(
    tmp_path: Path, branch: str, tested: str, distro: str
) -> None:
    """It was just made, and its CI not yet changed."""
    package = "<package format='3'><name>a</name><version>1.0.0</version><description>x</description>"
    package += "<buildtool_depend>ament_cmake</buildtool_depend>"
    package += "<export><build_type>ament_cmake</build_type></export></package>"
    ci = f"jobs:\n  build:\n    strategy:\n      matrix:\n        distro: [{tested}]\n    runs-on: ubuntu-latest\n"
    cmake = "project(a)\nfind_package(ament_cmake REQUIRED)\nament_package()\n"
    files = {"package.xml": package, "CMakeLists.txt": cmake, ".github/workflows/ci.yml": ci}
    found = decided(tmp_path, files, branch=branch)
    assert found.ros_distro == distro


@pytest.mark.parametrize(
    ("page", "names"),
    [
        ("It needs [odd messages](https://github.com/lab/odd_msgs).", ["odd_msgs"]),
        ("It needs https://github.com/lab/odd_msgs and https://github.com/lab/odd.", ["odd_msgs"]),
        ("It needs [weird](https://github.com/lab/weird).", ["weird"]),
        ("See [a filter](https://github.com/lab/filters) and [roscpp](https://github.com/lab/roscpp).", []),
        (
            "git clone https://github.com/lab/odd_msgs.git -b v2\nOr [a fork](https://github.com/you/odd_msgs).",
            ["odd_msgs"],
        ),
        ("The camera's [driver](https://github.com/lab/odd_viewer).", []),
    ],
)
def test_what_a_page_links_to_is_cloned_for_a_package_that_no_distribution_has(
    tmp_path: Path, page: str, names: list[str]
) -> None:
    more = "<depend>odd_msgs</depend><depend>weird_filters</depend><test_depend>odd_viewer</test_depend>"
    found = decided(tmp_path, {**catkin(more), "README.md": f"ROS Noetic\n\n{page}\n"})
    assert [source.name for source in found.source if not source.holding] == names
    assert all(source.repo and source.repo.startswith("https://github.com/lab/") for source in found.source)


def test_a_package_whose_name_only_begins_like_one_of_ros_stops_no_plan(tmp_path: Path) -> None:
    page = "```\nsudo apt-get install ros-latest cmake\n```\n"
    files = {"CMakeLists.txt": "project(a)\nadd_executable(a a.cpp)\n", "a.cpp": "int main() {}\n", "README.md": page}
    assert "ros-latest" in decided(tmp_path, files).apt_guessed
