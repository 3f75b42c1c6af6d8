"""What CMake requires and nothing brings: the package is left out where the others do without, else it is told."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from roslab.decide.decision import Decision
from roslab.pipeline import plan_repository
from roslab.plan.plan import Plan

Tree = Callable[[dict[str, str]], Decision]


def package(name: str, cmake: str = "", needs: str = "", tool: str = "ament_cmake") -> dict[str, str]:
    depends = f"<depend>{needs}</depend>" if needs else ""
    xml = f"<package format='3'><name>{name}</name><buildtool_depend>{tool}</buildtool_depend>{depends}</package>"
    made = f"cmake_minimum_required(VERSION 3.8)\nproject({name})\nfind_package({tool} REQUIRED)\n{cmake}"
    return {f"{name}/package.xml": xml, f"{name}/CMakeLists.txt": made}


SDK = "find_package(acme_robot_sdk REQUIRED)\n"
ROBOT = package("driver", SDK) | package("planner")


def test_a_package_that_no_other_needs_is_left_out(tree: Tree) -> None:
    decision = tree(ROBOT)
    assert decision.left_out == ("driver",)
    assert decision.package_names == ("planner",)
    assert decision.packages == ("planner/package.xml",)
    told = next(warning for warning in decision.warnings if "acme_robot_sdk" in warning.message)
    assert "driver is left out of the build" in told.message
    assert (told.file, told.line) == ("driver/CMakeLists.txt", 4)


def test_all_that_a_package_lacks_is_told(tree: Tree) -> None:
    both = f"{SDK}find_package(acme_messages REQUIRED)\nfind_package(acme_robot_sdk REQUIRED)\n"
    decision = tree(package("driver", both) | package("planner"))
    assert decision.left_out == ("driver",)
    told = [(warning.message, warning.line) for warning in decision.warnings if "acme_" in warning.message]
    assert [line for _, line in told] == [4, 5]
    assert all("driver is left out of the build" in message for message, _ in told)


@pytest.mark.parametrize(
    "files",
    [
        package("driver", SDK),
        ROBOT | package("planner", needs="driver"),
        ROBOT | {"README.md": "```\nros2 run driver node\n```\n"},
    ],
)
def test_a_package_that_is_needed_is_told(tree: Tree, files: dict[str, str]) -> None:
    decision = tree(files)
    assert decision.left_out == ()
    assert any("colcon will stop at driver" in warning.message for warning in decision.warnings)


@pytest.mark.parametrize(
    "more",
    [
        {"driver/cmake/Findacme_robot_sdk.cmake": ""},
        {"driver/acme_robot_sdkConfig.cmake.in": ""},
        {"README.md": "```\nsudo apt install libacme-robot-sdk-dev\n```\n"},
        {"README.md": "It links to [the SDK](https://github.com/acme/acme_robot_sdk).\n"},
        {"driver/README.md": "It links to [the SDK](https://github.com/acme/acme_robot_sdk).\n"},
        {
            "a.repos": "repositories:\n  acme_robot_sdk:\n    type: git\n    url: https://github.com/acme/acme_robot_sdk\n"
        },
        package("driver", "find_package(acme_robot_sdk)\n"),
    ],
)
def test_what_may_come_from_somewhere_is_built(tree: Tree, more: dict[str, str]) -> None:
    decision = tree(ROBOT | more)
    assert decision.left_out == ()
    assert not any("acme_robot_sdk, which CMake requires" in warning.message for warning in decision.warnings)


def test_a_clone_that_is_read_and_not_planned_brings_nothing(tree: Tree) -> None:
    clone = "git clone https://github.com/acme/acme_robot_sdk.git\ncd acme_robot_sdk\nqmake\nmake install\n"
    decision = tree(ROBOT | {"setup.sh": clone})
    assert (decision.left_out, decision.source) == (("driver",), ())
    assert any("nothing is known that brings acme_robot_sdk" in warning.message for warning in decision.warnings)


def planned(folder: Path, files: dict[str, str]) -> Plan:
    for path, text in files.items():
        target = folder / path
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text(text, encoding="utf-8")
    return plan_repository(folder).plan


@pytest.mark.parametrize(
    ("tool", "arguments"),
    [("ament_cmake", ("--packages-skip", "driver")), ("catkin", ("-DCATKIN_BLACKLIST_PACKAGES=driver",))],
)
def test_how_the_build_tool_is_told(tmp_path: Path, tool: str, arguments: tuple[str, ...]) -> None:
    plan = planned(tmp_path, package("driver", SDK, tool=tool) | package("planner", tool=tool))
    assert plan.workspace.ros
    assert plan.workspace.ros.arguments == arguments


def test_a_program_that_requires_what_nothing_brings_is_told_with_its_line(tree: Tree) -> None:
    files = {"CMakeLists.txt": "project(walk)\nfind_package(OddLibrary REQUIRED)\nadd_executable(walk a.cpp)\n"}
    found = tree(files | {"a.cpp": "int main() {}\n"})
    told = [(w.message, w.line) for w in found.warnings if "OddLibrary" in w.message]
    assert [line for _, line in told] == [2]
    assert "cmake will stop at walk" in told[0][0]


def catkin(name: str, components: str = "", needs: str = "") -> dict[str, str]:
    found = f"find_package(catkin REQUIRED COMPONENTS roscpp {components})\n"
    return {f"src/{path}": text for path, text in package(name, found, needs, "catkin").items()}


MADE = {"README.md": "ROS Noetic\n```\ncatkin build\n```\n"}


@pytest.mark.parametrize("page", [{}, MADE])
def test_a_ros_package_that_nobody_released(tree: Tree, page: dict[str, str]) -> None:
    decision = tree(catkin("driver", "acme_msgs") | catkin("planner") | page)
    assert decision.left_out == ("driver",)
    assert decision.ignored == (("src/driver",) if page else ())
    assert any("acme_msgs, which CMake requires: driver is left out" in w.message for w in decision.warnings)


def test_what_a_cloned_repository_may_hold(tree: Tree) -> None:
    listed = "- git: {local-name: acme, uri: 'https://github.com/acme/acme.git', version: main}\n"
    decision = tree(catkin("driver", "acme_msgs") | catkin("planner") | {"a.rosinstall": listed})
    assert decision.left_out == ()
    told = [each for each in decision.warnings if "acme_msgs" in each.message]
    assert [(each.file, each.line) for each in told] == [("src/driver/CMakeLists.txt", 4)]
    assert "one of the cloned repositories may hold it" in told[0].message


@pytest.mark.parametrize(
    ("known", "asked", "left_out"),
    [
        ("kindr", "kindr_msgs", ("driver",)),  # it is the only one in its repository
        ("vikit_common", "vikit_msgs", ()),
        ("vikit_common", "acme_msgs", ("driver",)),  # of another family
    ],
)
def test_what_a_repository_of_the_table_cannot_hold(
    tree: Tree, known: str, asked: str, left_out: tuple[str, ...]
) -> None:
    decision = tree(catkin("driver", asked) | catkin("planner", known, known))
    assert decision.left_out == left_out
    assert any(each.build == "catkin_make" for each in decision.source)
    may_hold = any("one of the cloned repositories may hold it" in each.message for each in decision.warnings)
    assert may_hold is not bool(left_out)


def test_what_a_clone_of_another_name_that_is_asked_for_cannot_hold(tree: Tree) -> None:
    listed = "repositories:\n  serial_acme: {type: git, url: 'https://github.com/ann/serial_acme.git', version: main}\n"
    files = package("driver", "find_package(serial_acme REQUIRED)\n", needs="serial_acme") | package("planner")
    studio = package("studio", "find_package(moving_studio REQUIRED)\n", needs="moving_studio")
    found = tree({**files, **studio, "a.repos": listed})
    assert found.left_out == ("studio",)
    assert not any("one of the cloned repositories" in each.message for each in found.warnings)
    alike = package("studio", "find_package(acme_serial REQUIRED)\n", needs="acme_serial")
    assert tree({**files, **alike, "a.repos": listed}).left_out == ()
    other = listed.replace("serial_acme", "common_things")
    assert tree({**files, **studio, "a.repos": other}).left_out == ()


def test_what_needs_a_package_that_is_left_out(tree: Tree) -> None:
    decision = tree(catkin("driver", "acme_msgs") | catkin("user", "driver", "driver") | catkin("planner"))
    assert decision.left_out == ("driver", "user")
    assert any("driver is left out of the build, and with it user" in w.message for w in decision.warnings)


def test_a_package_that_only_starts_another(tree: Tree) -> None:
    files = catkin("driver", "acme_msgs") | catkin("planner")
    files["src/planner/package.xml"] = files["src/planner/package.xml"].replace(
        "</package>", "<exec_depend>driver</exec_depend></package>"
    )
    assert tree(files).left_out == ("driver",)


@pytest.mark.parametrize(("key", "left_out"), [("acme_client", ()), ("rclcpp", ("driver",))])
def test_what_a_cloned_package_brings_may_have_another_name_for_cmake(
    tree: Tree, key: str, left_out: tuple[str, ...]
) -> None:
    listed = "repositories:\n  acme: {type: git, url: 'https://github.com/acme/acme.git', version: '1.0'}\n"
    files = package("driver", "find_package(AcmeClientLibrary REQUIRED)\n", needs=key) | package("planner")
    assert tree({**files, "a.repos": listed}).left_out == left_out


@pytest.mark.parametrize(
    ("more", "left_out"),
    [
        ({"README.md": "```\ncolcon build --packages-skip driver other --symlink-install\n```\n"}, ("driver",)),
        ({"docs/build.md": "```\ncolcon build --packages-skip driver\n```\n"}, ()),
        ({"README.md": "```\ncolcon build --packages-skip driver\nros2 run driver node\n```\n"}, ()),
        (
            {
                "pixi.toml": '[workspace]\nchannels = ["robostack-humble"]\n[dependencies]\npython = "*"\n'
                '[tasks.build]\ncmd = "colcon build --packages-skip driver"\n'
            },
            ("driver",),
        ),
    ],
)
def test_what_the_author_s_build_skips_is_not_built(
    tree: Tree, more: dict[str, str], left_out: tuple[str, ...]
) -> None:
    assert tree({**package("driver"), **package("planner"), **more}).left_out == left_out


def ci(*lines: str) -> dict[str, str]:
    steps = "".join(f"      - run: {line}\n" for line in lines)
    return {".github/workflows/build.yml": f"jobs:\n  build:\n    steps:\n{steps}"}


def industrial(*values: str) -> dict[str, str]:
    rows = "".join(f"          - {{ROS_DISTRO: humble, TARGET_WORKSPACE: '{value}'}}\n" for value in values)
    return {".github/workflows/build.yml": f"jobs:\n  build:\n    strategy:\n      matrix:\n        env:\n{rows}"}


@pytest.mark.parametrize(
    ("more", "left_out"),
    [
        (industrial(". -driver"), ("driver",)),
        (industrial(". -ws/driver"), ("driver",)),
        (industrial(". -other"), ()),
        (industrial(". -driver", "."), ()),
        (industrial(". -driver") | package("planner", needs="driver"), ()),
        (industrial(". -driver") | {"README.md": "```\nros2 run driver node\n```\n"}, ()),
        (ci("colcon build --packages-ignore driver"), ("driver",)),
        (ci("colcon test --packages-skip driver"), ()),
        (ci("colcon build --packages-skip driver", "colcon build"), ()),
        (ci("colcon build --packages-skip driver", "colcon build --packages-select planner"), ("driver",)),
        (ci("touch src/driver/COLCON_IGNORE"), ("driver",)),
        (ci("touch src/driver/COLCON_IGNORE\n        if: matrix.small"), ()),
        (ci("touch src/acme/driver_msgs/COLCON_IGNORE"), ()),
        ({"README.md": "```\ncd ~/ws/src\ntouch driver/COLCON_IGNORE\n```\n"}, ("driver",)),
        ({"docs/build.md": "```\ntouch driver/COLCON_IGNORE\n```\n"}, ()),
    ],
)
def test_what_ci_takes_out_of_the_workspace_is_not_built(
    tree: Tree, more: dict[str, str], left_out: tuple[str, ...]
) -> None:
    found = tree({**package("driver"), **package("planner"), **more})
    assert found.left_out == left_out
    told = [reason.answer for reason in found.reasons if reason.question == "workspace" and "build" in reason.reason]
    assert "driver" in told if left_out else "driver" not in told


def test_a_folder_of_packages_that_ci_takes_out(tree: Tree) -> None:
    inside = {f"extra/{path}": text for path, text in (package("driver") | package("viewer")).items()}
    assert tree(inside | package("planner") | ci("touch src/extra/CATKIN_IGNORE")).left_out == ("driver", "viewer")
    assert tree(inside | package("planner") | ci("touch src/acme/extra/CATKIN_IGNORE")).left_out == ()


@pytest.mark.parametrize(
    ("asked", "told"),
    [
        ("OpenCV 4.99.0 REQUIRED", True),
        ("OpenCV 4 REQUIRED", False),
        ("OpenCV 4.99.0", False),
        ("Unheard 9 QUIET", False),
    ],
)
def test_a_version_that_the_ubuntu_does_not_have(tree: Tree, asked: str, told: bool) -> None:
    page = {"README.md": "For ROS 2 Humble.\n", ".github/workflows/a.yml": "container: ros:humble\n"}
    found = tree(package("driver", f"find_package({asked})\n") | package("planner") | page)
    warnings = [warning for warning in found.warnings if "this Ubuntu" in warning.message]
    assert len(warnings) == told
    for warning in warnings:
        assert "4.99.0, and this Ubuntu (jammy) has 4.5" in warning.message
        assert (warning.file, warning.line) == ("driver/CMakeLists.txt", 4)


def test_a_version_that_a_folder_of_the_program_requires(tree: Tree) -> None:
    top = "cmake_minimum_required(VERSION 3.5)\nproject(demo)\nadd_subdirectory(src)\n"
    below = "find_package(OpenCV 3.0 REQUIRED)\nfind_package(Boost 1.72 REQUIRED)\nadd_executable(a a.cpp)\n"
    found = tree({"CMakeLists.txt": top, "src/CMakeLists.txt": below, "README.md": "Ubuntu 18.04\n"})
    assert [w.line for w in found.warnings if "Boost 1.72, and this Ubuntu (bionic) has 1.65" in w.message] == [2]


CAMERA = """\
cmake_minimum_required(VERSION 3.8)
project(tracker)
option(USE_CAMERA "Take a camera" {value})
if(USE_CAMERA)
  find_package({package} REQUIRED)
endif()
add_executable(track track.cpp)
"""


@pytest.mark.parametrize(
    ("value", "package", "page", "options"),
    [
        ("ON", "acme_camera_sdk", "", ("-DUSE_CAMERA=OFF",)),
        ("ON", "crocoddyl", "", ("-DUSE_CAMERA=OFF",)),  # ROS has it, and this is an Ubuntu without
        ("ON", "zmqpp", "", ("-DUSE_CAMERA=OFF",)),  # only older Ubuntus have it
        ("ON", "Eigen3", "", ()),
        ("ON", "OpenMP", "", ()),  # the compiler's own
        ("OFF", "acme_camera_sdk", "", ()),
        ("ON", "acme_camera_sdk", "    cmake -DUSE_CAMERA=ON ..\n    make\n", ("-DUSE_CAMERA=ON",)),
    ],
)
def test_an_option_that_only_asks_for_what_nothing_brings_is_off(
    tree: Tree, value: str, package: str, page: str, options: tuple[str, ...]
) -> None:
    code = {
        "track.cpp": "int main() {}\n",
        "README.md": f"# Build\n\nOn Ubuntu 22.04:\n\n    mkdir build\n    cd build\n{page}",
    }
    decision = tree(code | {"CMakeLists.txt": CAMERA.format(value=value, package=package)})
    assert (decision.kind, decision.cmake_options) == ("cpp", options)
    told = [w for w in decision.warnings if "-DUSE_CAMERA=OFF" in w.message]
    assert bool(told) == (options == ("-DUSE_CAMERA=OFF",))
    assert not told or (told[0].file, told[0].line) == ("CMakeLists.txt", 5)


def test_the_programs_that_doxygen_calls_are_installed(tree: Tree) -> None:
    cmake = "project(tracker)\nadd_executable(track track.cpp)\nadd_subdirectory(doc)\n"
    files = {"doc/CMakeLists.txt": "find_package(Doxygen REQUIRED dot)\n", "track.cpp": "int main() {}\n"}
    decision = tree(files | {"CMakeLists.txt": cmake})
    assert {"doxygen", "graphviz"} <= {*decision.apt, *decision.apt_guessed}


@pytest.mark.parametrize(("required", "installed"), [("", False), (" REQUIRED", True)])
def test_what_only_writes_documentation_is_installed_where_cmake_requires_it(
    tree: Tree, required: str, installed: bool
) -> None:
    cmake = (
        f"project(tracker)\nadd_executable(track track.cpp)\nfind_package(Doxygen{required})\nfind_package(Eigen3)\n"
    )
    ci = "install:\n  - sudo apt-get install -y doxygen\n"
    decision = tree({"CMakeLists.txt": cmake, "track.cpp": "int main() {}\n", ".travis.yml": ci})
    assert ("doxygen" in {*decision.apt, *decision.apt_guessed}) == installed
    page = "## Install\n```\nsudo apt-get install doxygen\n```\n"
    by_page = tree({"CMakeLists.txt": cmake, "track.cpp": "int main() {}\n", "README.md": page})
    assert "doxygen" in {*by_page.apt, *by_page.apt_guessed}, "its CMakeLists.txt may stop by a message without it"
    assert "libeigen3-dev" in {*decision.apt, *decision.apt_guessed}


@pytest.mark.parametrize(
    ("line", "told"),
    [
        ("ros-melodic-kobuki-driver", True),
        ("ros-$ROS1_DISTRO-kobuki-driver", True),
        ("ros-humble-kobuki-driver", False),
        ("ros-foxy-kobuki-driver", True),
    ],
)
def test_a_package_that_another_distribution_released_is_not_there(tree: Tree, line: str, told: bool) -> None:
    page = f"For ROS 2 Humble\n```\nexport ROS1_DISTRO=melodic\nsudo apt install {line}\n```\n"
    clones = "repositories:\n  more:\n    type: git\n    url: https://github.com/lab/more\n"
    files = package("driver", "find_package(kobuki_driver REQUIRED)\n") | {"README.md": page}
    for more in ({}, {"a.repos": clones} | package("driver", "find_package(kobuki_driver REQUIRED)\n", "lab_msgs")):
        decision = tree(files | more)
        assert any("kobuki_driver" in warning.message for warning in decision.warnings) == told
        assert "ros-humble-kobuki-driver" not in decision.apt or not told or "foxy" in line


@pytest.mark.parametrize(
    ("needed", "told"),
    [("ACME", True), ("Eigen3", False), ("fmt", False)],
)
def test_what_the_cmake_of_a_setup_py_requires_is_told(tree: Tree, needed: str, told: bool) -> None:
    setup = "from setuptools import setup, Extension\nimport subprocess\n"
    setup += "class CMakeExtension(Extension):\n    pass\nsubprocess.check_call(['cmake', '.'])\n"
    files = {
        "setup.py": f"{setup}setup(name='bound', ext_modules=[CMakeExtension('bound')], install_requires=['pyacme'])\n",
        "CMakeLists.txt": f"project(bound)\nfind_package({needed} REQUIRED)\n",
        "bound/__init__.py": "import numpy\n",
    }
    decision = tree(files)
    said = [warning.message for warning in decision.warnings if "pip will stop at bound" in warning.message]
    assert bool(said) is told
    lost = [(folder, [each.written for each in asked]) for folder, asked in decision.python.lost_extensions]
    assert lost == ([(".", ["pyacme"])] if told else [])


def test_what_a_package_requires_of_another_one_without_saying_so(tree: Tree) -> None:
    manifest = "<package><name>{}</name><buildtool_depend>catkin</buildtool_depend>{}</package>"
    cmake = "project({})\nfind_package(catkin REQUIRED COMPONENTS {})\n"
    files = {
        "a/package.xml": manifest.format("a", ""),
        "a/CMakeLists.txt": cmake.format("a", "utils"),
        "utils/package.xml": manifest.format("utils", ""),
        "utils/CMakeLists.txt": cmake.format("utils", "roscpp"),
    }
    found = tree(files)
    assert found.undeclared
    assert any("CMake of a requires utils" in each.message for each in found.warnings)
    named = tree({"a/package.xml": manifest.format("a", "<depend>utils</depend>")})
    assert not named.undeclared


@pytest.mark.parametrize(
    ("code", "more", "names"),
    [
        ("from acme_msgs.msg import Arm\n", {}, ["acme_msgs"]),
        ("from acme_interfaces.msg import Arm\n", {}, ["acme_interfaces"]),
        ("from std_msgs.msg import String\n", {}, []),
        ("try:\n    from acme_msgs.msg import Arm\nexcept ImportError:\n    Arm = None\n", {}, []),
        ("from acme_msgs.msg import Arm\n", package("acme_msgs"), []),
        ("from acme_msgs.msg import Arm\n", package("other", needs="acme_msgs"), []),
    ],
)
def test_messages_that_the_code_imports_and_nothing_brings(
    tree: Tree, code: str, more: dict[str, str], names: list[str]
) -> None:
    files = {**package("arm"), **more, "arm/scripts/a.py": f"import rclpy\n{code}rclpy.init()\n"}
    told = [warning for warning in tree(files).warnings if "imports messages of" in warning.message]
    assert [warning.message.split("messages of ")[1].split(",")[0] for warning in told] == names
    assert all((warning.file, warning.line) == ("arm/scripts/a.py", 2) for warning in told)


@pytest.mark.parametrize(
    ("made", "skipped"),
    [
        ("add_library(acme_input src/input.cpp)\n", True),
        ("add_library(acme_input SHARED IMPORTED)\n", False),
        ("", False),
    ],
)
def test_a_key_that_is_a_library_of_its_own_package(tree: Tree, made: str, skipped: bool) -> None:
    files = package("driver", "add_subdirectory(src)\n", "acme_input") | {"README.md": "ROS Humble\n"}
    files |= {
        "driver/src/CMakeLists.txt": f"{made}add_executable(a a.cpp)\n",
        ".git/config": '[remote "origin"]\n\turl = https://github.com/lab/a\n',
    }
    decision = tree(files | {".git/HEAD": "ref: refs/heads/a\n"})
    assert ("acme_input" in decision.skip_keys) is skipped
    assert ("acme_input" not in decision.rosdep) is skipped
    assert (not any("acme_input" in warning.message for warning in decision.warnings)) is skipped
    assert (not decision.source) is skipped


def test_the_library_of_a_robot_is_built_where_no_ros_brings_it(tree: Tree) -> None:
    made = (
        "cmake_minimum_required(VERSION 3.5)\nproject(x CXX)\nfind_package(Franka REQUIRED)\nadd_executable(a a.cpp)\n"
    )
    decision = tree({"CMakeLists.txt": made, "a.cpp": "int main() {}\n", "README.md": "Ubuntu 22.04\n"})
    assert [(each.name, each.ref) for each in decision.source] == [("libfranka", "0.9.2")]
    assert "libpoco-dev" in (*decision.apt, *decision.apt_guessed)


@pytest.mark.parametrize(("repository", "told"), [("abseil/abseil-cpp", False), ("lab/other", True)])
def test_a_library_that_a_page_builds_has_other_names_in_cmake(tree: Tree, repository: str, told: bool) -> None:
    """No package of this Ubuntu has it: https://packages.ubuntu.com/search?keywords=libabsl-dev."""
    manifest = "<package><name>odometry</name><buildtool_depend>catkin</buildtool_depend></package>"
    clone = f"git clone --branch 20220623.0 https://github.com/{repository}.git\ncd {repository.split('/')[1]}\n"
    build = "mkdir build && cd build\ncmake -DCMAKE_CXX_STANDARD=17 ..\nsudo make install\n"
    files = {
        "package.xml": manifest,
        "CMakeLists.txt": "project(odometry)\nfind_package(catkin REQUIRED)\nfind_package(absl REQUIRED)\n",
        "README.md": f"# Installation\nFor ROS Noetic.\n```bash\n{clone}{build}```\n",
    }
    assert any("brings absl" in each.message for each in tree(files).warnings) is told


@pytest.mark.parametrize(
    ("options", "out"),
    [
        ("", ("driver",)),
        (" --cmake-args -DUSE_ARM=OFF", ()),
        (" --cmake-args -DUSE_ARM:BOOL=OFF -DA=1", ()),
        (" --cmake-args -DUSE_ARM=ON", ("driver",)),
        (" --cmake-args -DUSE_LEG=OFF", ("driver",)),
    ],
)
def test_what_the_pages_build_switches_off_is_not_required(tree: Tree, options: str, out: tuple[str, ...]) -> None:
    cmake = f"option(USE_ARM 'with it' ON)\nif(USE_ARM)\n{SDK}else()\nfind_package(rclcpp REQUIRED)\nendif()\n"
    page = {"README.md": f"ROS 2 Humble\n```\ncolcon build{options}\n```\nWith it:\n```\ncolcon build\n```\n"}
    decision = tree(package("driver", cmake) | package("planner") | page)
    assert decision.left_out == out
    assert any("acme_robot_sdk" in warning.message for warning in decision.warnings) is bool(out)
