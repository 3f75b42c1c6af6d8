"""Messages of tools that one failure has in several words, each with the cause that they share."""

from __future__ import annotations

import io

import pytest

from roslab.explain.answer import Explanation, explain


def found(lines: str, step: str = "") -> Explanation:
    """Explain what a step of a build printed; without a step, a log of its own."""
    said = lines.splitlines()
    if step:
        end = f'process "/bin/sh -c {step}" did not complete successfully: exit code: 1'
        said = [f"#8 [3/4] RUN {step}", *(f"#8 1.0 {line}" for line in said), f"#8 ERROR: {end}"]
    (one,) = explain(io.BytesIO("".join(f"{line}\n" for line in said).encode())).explanations
    return one


WORDS = """
connection: rosdep init
ERROR: cannot download default sources list from:
https://raw.githubusercontent.com/ros/a.list

connection: rosdep update
Failed to download target platform data for gbpdistro:
The read operation timed out

connection: git clone https://example.org/a
fatal: unable to access 'https://example.org/a/': GnuTLS recv error (-110)

git-lfs: git lfs pull
git: 'lfs' is not a git command. See 'git --help'.

git-lfs-refused: git clone https://example.org/a
error: external filter 'git-lfs filter-process' failed
fatal: arm.stl: smudge filter lfs failed

git-lfs-quota: git lfs pull
batch response: This repository is over its data quota. Account responsible for LFS bandwidth should purchase more

conda-unsatisfiable: mamba install ros-noetic-desktop
Encountered problems while solving:
  - package ros-noetic-desktop-1.5.0-py39_15 requires ros-noetic-viz, but none of the providers can be installed

python-api-removed: python train.py
RuntimeError: Failed to import diffusers.models because of the following error (look up to see its traceback):
module 'torch' has no attribute 'float8_e4m3fn'

git-ssh: git clone --recursive https://example.org/a
git@example.org: Permission denied (publickey).
fatal: Could not read from remote repository.
fatal: clone of 'git@example.org:a/b.git' into submodule path '/a/b' failed

memory: make
collect2: fatal error: ld terminated with signal 9 [Killed]

numpy-too-new: python3 t.py
RuntimeError: Numpy is not available

pip-wheel-tool-missing: pip install dlib
  ERROR: CMake must be installed to build the following extensions: _dlib

conda-packages-not-found: mamba env create
error    libmamba Could not solve for environment specs
    └─ fast-robot 0.3.0** does not exist (perhaps a typo or a missing channel).

api-known: make
a.cpp:3:10: fatal error: tf2_eigen/tf2_eigen.h: No such file or directory

ros-header-missing: make
a.cpp:3:10: fatal error: tf2_eigen/tf2_eigen.hpp: No such file or directory

api-known: make
a.cpp:3:10: error: 'usleep' was not declared in this scope

api-known: make
a.cpp:3:10: error: aggregate 'std::stringstream said' has incomplete type

ros-package-not-found:
RLException: Invalid <arg> tag: gazebo_ros
ROS path [0]=/opt/ros/noetic/share/ros

push-denied:
denied: installation not allowed to Create organization package

connection: uv sync
  Caused by: error sending request for url (https://example.org/simple/numpy/)

no-compiler: catkin_make
/bin/sh: 1: /usr/bin/c++: not found

compiler-option-unknown: make
cc1plus: error: unknown value 'native' for '-march'

setuptools-new-for-colcon: colcon build
error: error in setup.cfg: command 'develop' has no such option 'script_dir'

tests-fail: colcon test-result --verbose
Summary: 3 tests, 0 errors, 2 failures, 0 skipped

source-refuses: make
a.hpp:3:4: error: static assertion failed: YOU_MIXED_DIFFERENT_NUMERIC_TYPES

api-call: make
a.hpp:12:7: error: 'void arm::Driver::stop()' marked 'override', but does not override

api-call: make
a.cpp:12:7: error: 'int arm::Driver::speed' is private within this context

file-missing: vcs import src < arm.repos
/bin/sh: 1: cannot open arm.repos: No such file

host-unknown: apt-get update; apt-get install -y git
W: Failed to fetch http://example.org/jammy/InRelease  Temporary failure resolving 'example.org'
E: Unable to locate package git

systemd: systemctl enable ros
System has not been booted with systemd as init system (PID 1). Can't operate.
Failed to connect to bus: Host is down

dds-no-domain:
Starting
[ERROR] [rmw_fastrtps_cpp]: failed to create participant

argument-missing:
Included launch description missing required argument 'map' (description: 'no description given'), given: []

cuda-without-driver:
CUDA driver version is insufficient for CUDA runtime version

own-messages-not-first: catkin_make
fatal error: arm/Grip.h: No such file or directory
compilation terminated.
make[2]: *** [arm/CMakeFiles/arm.dir/build.make:63: arm/CMakeFiles/arm.dir/src/arm.cpp.o] Error 1

api-member: colcon build
error: 'armBuffer' has no member named 'offset'

pkg-config: bazel build //arm
Error in fail: error 1 from [/usr/bin/pkg-config, "spdlog"]:
ERROR: /app/WORKSPACE:10:22: fetching spdlog_repository rule //external:spdlog: Traceback

bazel-download-gone: bazel build //arm
java.io.IOException: Error downloading [https://example.org/a.tgz] to /root/a.tgz: GET returned 404 Not Found

cuda-home-is-list: pip install .
FileNotFoundError: [Errno 2] No such file or directory: '/usr/local/cuda:/opt/cuda/bin/nvcc'

cuda-architecture-notation: make
nvcc fatal   : Unsupported gpu architecture 'compute_native'

pip-editable-no-folder: pip install -e ./arm
ERROR: ./arm is not a valid editable requirement. It should either be a path to a local project

link-two-versions: make
/usr/bin/ld: warning: libcam.so.1, needed by /usr/lib/libarmmap.so, may conflict with libcam.so.2
a.cpp:(.text+0x1): undefined reference to `cam::open(bool)'

ros-message-header: catkin_make
fatal error: arm_msgs/Grip.h: No such file or directory

ros1-linked-in-ros2: build.sh
--- stderr: arm_interface
libarm.so: undefined reference to `ros::console::initialize()'

api-known: colcon build
a.cc:3:10: fatal error: gz/common/av/Util.hh: No such file or directory

api-known: colcon build
a.cc:4:10: fatal error: gz/common/ffmpeg_inc.hh: No such file or directory

bazel-newer-than-rules: bazel build //arm
Error: trying to mutate a frozen list value

ros-core-key: rosdep install --from-paths src
arm: Cannot locate rosdep definition for [std_msgs]

file-truncated: make
cmake -E tar: error: ZIP decompression failed (-5)

download-no-archive: make
cmake -E tar: error: Problem with a: Unrecognized archive format

cmake-needs-newer-install: cmake .
CMake Error at /opt/arm.cmake:77 (add_library):
  add_library INTERFACE library requires no source arguments.

api-known: make
error: no matching function for call to 'rclcpp::Duration::Duration(int)'

api-known: make
a.c:3:9: error: 'AVCodecParameters' has no member named 'ch_layout'

api-known: make
a.c:3:9: error: 'AV_OPT_TYPE_CHANNEL_LAYOUT' undeclared (first use in this function)

link-torch-library: pip install .
/usr/bin/ld: cannot find -lc10_cuda

conda-file-of-linux: conda env create
ResolvePackageNotFound:
  - _libgcc_mutex=0.1

shell-cannot-read-command: make
/bin/sh: 1: Syntax error: Unterminated quoted string
make[2]: *** [arm.o] Error 2

pkg-config: cmake .
CMake Error at /usr/share/cmake-3.5/Modules/FindPkgConfig.cmake:578 (message):
  None of the required 'apriltag' found

cmake-target-missing: cmake .
CMake Error at CMakeLists.txt:24 (add_library):
Target "grip" links to target "arm::arm" but the target
was not found.

colcon-needed-not-built: colcon build --packages-select arm
[0.6s] ERROR:colcon.colcon_cmake.task.cmake.build:Failed to find the following files:
- ws/install/arm_msgs/share/arm_msgs/package.sh
Check that the following packages have been built:
- arm_msgs

api-known: make
a.hpp:3:9: error: 'csc' has not been declared

api-known: make
a.cpp:3:9: error: cannot convert 'OSQPWorkspace**' to 'const OSQPData*' for argument '1'

api-known: make
a.hpp:3:9: error: 'const class Eigen::Matrix<float, -1, -1>' has no member named 'minCoeffOfFinites'

header-of-protobuf: make
fatal error: arm/Block.pb.h: No such file or directory

ros-header-missing: make
<command-line>: fatal error: grid_map_core/eigen_plugins/FunctorsPlugin.hpp: No such file or directory
"""
"""Each failure with the step that ended, and what it printed; without a step, a log of its own."""


@pytest.mark.parametrize("case", WORDS.strip().split("\n\n"))
def test_each_of_its_words(case: str) -> None:
    head, _, lines = case.partition("\n")
    known, _, step = head.partition(":")
    assert found(lines, step.strip()).id == known


def test_a_command_of_cmake_is_found_with_its_package() -> None:
    one = found('CMake Error at CMakeLists.txt:2 (x):\n  Unknown CMake command "add_message_files".', "catkin_make")
    assert "`find_package(catkin REQUIRED COMPONENTS message_generation)`" in one.fix
    assert "the package that defines robot_add" in found('  Unknown CMake command "robot_add".', "cmake .").fix


@pytest.mark.parametrize(
    ("name", "package"),
    [
        ("ament_package", "ament_cmake REQUIRED"),
        ("ament_add_gtest_executable", "ament_cmake_gtest REQUIRED"),
        ("ament_lint_auto_find_test_dependencies", "ament_lint_auto REQUIRED"),
        ("catkin_generate_virtualenv", "catkin REQUIRED COMPONENTS catkin_virtualenv"),
        ("catkin_install_python", "catkin REQUIRED"),
    ],
)
def test_a_command_is_that_of_its_own_package(name: str, package: str) -> None:
    assert f"find_package({package})" in found(f'  Unknown CMake command "{name}".', "cmake .").fix


def test_whose_a_command_of_some_linter_is_stays_open() -> None:
    assert "the package that defines ament_cpplint" in found('  Unknown CMake command "ament_cpplint".', "cmake .").fix


def test_a_package_that_all_ubuntus_call_the_same_needs_no_ubuntu() -> None:
    one = found("CMake Error at a.cmake:2 (message):\n  Could NOT find Python3 (missing: Development)", "cmake .")
    assert one.repair == (("apt", ("python3-dev",)),)


def test_a_header_that_all_ubuntus_have_in_one_package_needs_none() -> None:
    one = found("a.cpp:3:10: fatal error: fmt/core.h: No such file or directory", "make")
    assert one.repair == (("apt", ("libfmt-dev",)),)


def test_a_log_without_steps_shows_its_ros() -> None:
    one = found("Caught exception in launch: \"package 'nav2_bringup' not found, searching: ['/opt/ros/humble']\"")
    assert one.repair == (("apt", ("ros-humble-nav2-bringup",)),)


def test_a_file_that_a_server_refuses_is_no_image() -> None:
    for name in ("no such package: /root/a.tgz", "https://example.org/a.tgz"):
        assert found(f"ERROR: {name}: All mirrors are down: [GET returned 403 Forbidden]\n").id != "image-refused"
    assert found("ERROR: arm/base:1: unexpected status: 403 Forbidden\n").id == "image-refused"


def test_what_no_name_fills_leaves_no_gap() -> None:
    assert found("FileNotFoundError: [Errno 2] No such file or directory: 'arm.txt'\n").cause.endswith(" archive.")
    said = "no such target '//a:b': target 'b' not declared in package 'a' defined by /a/BUILD"
    one = found(f"{said}\n", "bazel build //a")
    assert one.fix.endswith(" is called now.")
    assert "which the build asks for: " in one.cause


def test_an_object_of_this_build_was_not_compiled_before() -> None:
    said = "/usr/bin/ld: {}: relocation R_X86_64_PC32 against undefined hidden symbol `{}' can not be used\n"
    assert found(said.format("lib/libarm.a(a.o)", "_ZTC3arm"), "make").id == "link-hidden-gone"
    assert found(said.format("CMakeFiles/a.dir/a.cpp.o", "_ZTC3arm"), "make").id != "link-hidden-gone"
    assert found(said.format("a.o", "__dso_handle"), "make").id != "link-hidden-gone"


def test_a_server_that_wants_a_pause_still_has_the_file() -> None:
    said = (
        "java.io.IOException: Error downloading [https://example.org/a.tgz] to /a: GET returned 429 Too Many Requests"
    )
    assert found(f"{said}\n", "bazel build //a").id == "rate-limit"


def test_what_cmake_only_warns_of_is_not_listed_as_needed() -> None:
    listed = "-- BUILD {0}: \n-- \tMissing: {1}.\n-- END BUILD {0}\n"
    said = listed.format("WARNINGS", "the window") + listed.format("ERRORS", "libarm")
    said = said.replace("ERRORS: ", "ERRORS: These must be resolved before compiling.")
    said += "CMake Error at CMakeLists.txt:2 (message):\n  Errors encountered in build.\n"
    assert dict(found(said, "cmake ..").names)["name"] == "libarm"


def test_a_module_that_no_table_has_may_be_of_the_project() -> None:
    said = "ModuleNotFoundError: No module named '{}'\n"
    assert "PYTHONPATH" in found(said.format("armwrap")).fix
    assert "PYTHONPATH" not in found(said.format("cv2")).fix


def test_a_library_of_the_system_is_of_another_release_and_not_of_this_build() -> None:
    said = "{}libarm.so: undefined reference to `arm::{}'\ncollect2: error: ld returned 1 exit status"
    assert found(said.format("../lib/", "move()"), "make").id == "link-own-library"
    assert found(said.format("/usr/lib/", "move()"), "make").id == "link-undefined"
    assert found(said.format("../lib/lib", "move()"), "make").id == "link-library-incomplete"


@pytest.mark.parametrize(
    "path",
    [
        "//usr/lib/x86_64-linux-gnu/libarm.so.0",
        "/lib/x86_64-linux-gnu/libarm.so.0",
        "/root/miniconda3/lib/libarm.so",
        "/home/arm/.local/lib/python3.8/site-packages/arm/lib/libarm.so",
    ],
)
def test_a_library_that_was_installed_is_none_of_this_build(path: str) -> None:
    for symbol in ("arm::move()", "uuid_generate@UUID_1.0"):
        said = f"{path}: undefined reference to `{symbol}'\ncollect2: error: ld returned 1 exit status"
        assert found(said, "make").id == "link-undefined"


def test_a_wheel_that_is_not_ready_is_not_why_its_code_does_not_compile() -> None:
    tried = "urllib.error.HTTPError: HTTP Error 404: Not Found\n\nDuring handling of the above exception, another\n"
    ninja = "subprocess.CalledProcessError: Command '['ninja', '-v']' returned non-zero exit status 1."
    broken = "a.cpp:3:1: error: 'arm' is not a member of 'grip'\n"
    assert found(f"{tried}{ninja}", "pip install .").id == "ready-wheel-not-found"
    assert found(f"{broken}{tried}{ninja}", "pip install .").id == "api-member"
    assert found(tried, "python get.py").id == "download-gone"


def test_a_library_that_the_project_brings_is_named() -> None:
    assert "DBoW2" in found("liba.so: undefined reference to `DBoW2::FORB::L'", "make").cause.partition("(")[2]


def test_a_header_of_the_package_itself_is_of_no_other() -> None:
    said = "/ws/src/{}/src/a.cpp:3:10: fatal error: nav_core/arm.h: No such file or directory"
    assert found(said.format("arm"), "catkin_make").id == "ros-header-missing"
    assert found(said.format("nav_core"), "catkin_make").id == "header-missing"


@pytest.mark.parametrize(
    ("header", "line", "known"),
    [
        ("filters/kalman.h", "", "header-missing"),
        ("octomap/octomap.h", "", "header-missing"),
        ("filters/kalman.h", "source /opt/ros/noetic/setup.bash", "ros-header-missing"),
        ("octomap/octomap.h", "source /opt/ros/noetic/setup.bash", "ros-header-missing"),
        ("wheel_parameters.hpp", "", "header-missing"),
        ("wheel_parameters.hpp", "source /opt/ros/humble/setup.bash", "generated-parameters-header"),
        ("rclcpp/node_interfaces/node_parameters.hpp", "source /opt/ros/humble/setup.bash", "ros-header-missing"),
    ],
)
def test_a_plain_word_is_a_package_of_ros_where_the_log_shows_ros(header: str, line: str, known: str) -> None:
    said = f"{line}\na.cpp:3:10: fatal error: {header}: No such file or directory"
    one = found(said, "make")
    assert one.id == known
    assert header != "octomap/octomap.h" or one.repair, "apt or ROS has it"


def test_a_function_of_a_ros_package_is_told_by_its_namespace() -> None:
    said = "a.cpp:(.text+0x1): undefined reference to `{}::Arm::move()'"
    assert "(the ROS package nav_core)" in found(said.format("nav_core"), "make").cause
    assert "ROS package" not in found(said.format("arm_of_ours"), "make").cause
    assert "(MoveIt)" in found(said.format("moveit::core"), "make").cause
    assert "(the ROS package nav_core)" in found(said.format("vtable for nav_core"), "make").cause
    assert "(a class of the project itself)" in found(said.format("vtable for arm_of_ours"), "make").cause


def test_a_build_type_that_colcon_does_not_know_is_named() -> None:
    needed = (
        "Failed to find the following files:\n- a/package.sh\nCheck that the following packages have been built:\n- a"
    )
    said = "[0.9s] WARNING:colcon.colcon_core.verb:No task extension to 'build' a 'ros.ament_cargo' package\n"
    assert "(ros.ament_cargo)" in found(f"{said}{needed}", "colcon build").cause
    assert "build type and" in found(needed, "colcon build").cause


def test_what_the_build_types_of_others_export_is_not_of_ament_cmake() -> None:
    said = '  Unknown CMake command "ament_export_{}".'
    assert "find_package(ament_cmake REQUIRED)" in found(said.format("libraries"), "cmake .").fix
    assert "find_package(ament_cmake_export_jars REQUIRED)" in found(said.format("jars"), "cmake .").fix
    assert "the package that defines ament_export_arms" in found(said.format("arms"), "cmake .").fix


@pytest.mark.parametrize(
    ("call", "variable", "words", "package"),
    [
        ("library", "ZMQ", "names: zmq", "libzmq3-dev"),
        ("path", "YAML_INCLUDE_DIR", "files: yaml-cpp/yaml.h", "libyaml-cpp-dev"),
        ("program", "PROTOC", "names: protoc", "protobuf-compiler"),
        ("program", "CLANG", "names: clang", "clang"),
    ],
)
def test_what_cmake_looks_for_is_a_library_a_header_or_a_program(
    call: str, variable: str, words: str, package: str
) -> None:
    said = f"CMake Error at CMakeLists.txt:3 (find_{call}):\n  Could not find {variable} using the following {words}\n"
    assert found(said, "cmake .").repair == (("apt", (package,)),)


def test_an_f_string_is_too_new_for_an_old_python_3_as_well() -> None:
    said = '  File "a.py", line 3\n    print({}"arm", file=log)\n                 ^\nSyntaxError: invalid syntax'
    assert found(said.format("f"), "python3 a.py").id == "python-too-old-syntax"
    assert found(said.format(""), "python a.py").id == "python2-runs-python3"


def test_what_only_begins_with_the_name_of_a_framework_has_its_source() -> None:
    said = "distutils.errors.DistutilsError: Could not find suitable distribution for Requirement.parse('{}>=2')"
    assert found(said.format("torch"), "python setup.py install").id == "setup-requires-wheel-alone"
    assert found(said.format("torch-scatter"), "python setup.py install").id == "pip-nothing-old-index"


def test_keys_of_every_ubuntu_are_not_to_be_skipped() -> None:
    said = "arm: Cannot locate rosdep definition for [{}]\n"
    one = found(said.format("std_msgs") + said.format("python3-yaml"), "rosdep install --from-paths src")
    assert (one.id, one.repair) == ("rosdep-tables-missing", ())


def test_what_stopped_a_build_from_outside_is_found_around_its_steps() -> None:
    building = "#9 [3/4] RUN make\n#9 20.2 [ 71%] Building CXX object a.o\n"
    end = "##[error]The job running on runner GitHub 12 has exceeded the maximum execution time of 360 minutes.\n"
    (one,) = explain(io.BytesIO((building + end).encode())).explanations
    assert (one.id, dict(one.names)) == ("job-time-over", {"time": "360 minutes"})
    (one,) = explain(io.BytesIO((building + "##[error]The robot is tired.\n").encode())).explanations
    assert (one.id, one.step) == (None, "RUN make")


@pytest.mark.parametrize(
    ("line", "cause"),
    [
        ("The Compose file './compose.yml' is invalid because:", "has a key that this Docker Compose does not know"),
        ("remote: Write access to repository not granted.", "git may not write to the repository: the token of"),
        (
            "Invalid workflow file: .github/workflows/a.yml#L12",
            "cannot read the workflow .github/workflows/a.yml (line",
        ),
        ("Are you trying to mount a directory onto a file?", "A volume is mounted onto something of another kind: of"),
        ("The launch file may have a syntax error, or its format is unknown", "A launch file cannot be read."),
        ("CUDA error: out of memory", "has no room for what was asked for: the model"),
    ],
)
def test_a_cause_is_a_sentence_where_a_message_has_no_name(line: str, cause: str) -> None:
    assert cause in found(f"{line}\n").cause


HARMLESS = """
-- Could NOT find CUDA (missing: CUDA_TOOLKIT_ROOT_DIR CUDA_NVCC_EXECUTABLE)
%
-- Checking for module 'libusb-1.0'
--   No package 'libusb-1.0' found
-- Checking for module 'zmq'
%
CMake Warning at CMakeLists.txt:12 (find_package):
  By not providing "FindPCL.cmake" in CMAKE_MODULE_PATH this project has
  asked CMake to find a package configuration file provided by "PCL", but

  Could not find a package configuration file provided by "PCL" with any of
%
CMake Warning at CMakeLists.txt:12 (find_package):
  By not providing "FindPCL.cmake" in CMAKE_MODULE_PATH this project has
fatal: not a git repository (or any of the parent directories): .git
%
WARNING: Retrying (Retry(total=4)) after connection broken by 'ReadTimeoutError("HTTPSConnectionPool(
%
System has not been booted with systemd as init system (PID 1). Can't operate.
fatal: not a git repository (or any of the parent directories): .git
"""
"""What builds print and survive."""
STOPS = {
    "header-missing": "a.cpp:3:10: fatal error: glog/logging.h: No such file or directory",
    "cmake-own-check": "CMake Error at CMakeLists.txt:40 (message):\n  The robot needs an arm\nCall Stack:",
    "cmake-package": 'CMake Error at a/CMakeLists.txt:3 (find_package):\n  By not providing "Findglog.cmake" in',
    "pkg-config": "--   No package 'zmq' found\nCMake Error at /a/FindPkgConfig.cmake:603 (message):\n  A package",
    "program-crashed": "Segmentation fault (core dumped)",
    "pip-no-network": "WARNING: Retrying (Retry(total=0, connect=None)) after connection broken by 'X'\n"
    "ERROR: No matching distribution found for numpy",
}


@pytest.mark.parametrize("said", HARMLESS.strip().split("\n%\n"))
@pytest.mark.parametrize("known", STOPS)
def test_what_builds_survive_outweighs_nothing(said: str, known: str) -> None:
    one = found(f"{said}\n{STOPS[known]}", "make")
    assert one.id == known
    assert "PCL" not in one.cause
    assert "libusb" not in one.cause


def test_a_warning_is_the_cause_where_nothing_else_is_known() -> None:
    warning = 'CMake Warning at CMakeLists.txt:12 (find_package):\n  By not providing "FindPCL.cmake" in CMAKE_X this'
    one = found(f"{warning}\n-- Configuring incomplete, errors occurred!", "cmake .")
    assert (one.id, dict(one.names)["name"]) == ("cmake-package", "PCL")


def test_the_frame_that_raised_an_exception_is_told() -> None:
    frames = 'File "/app/move.py", line 4, in <module>\n    arm.load()\n  File "/app/arm.py", line 9, in load'
    one = found(f"Traceback (most recent call last):\n  {frames}\n    f.read()\narm.ArmError: no arm at 3")
    assert (one.id, one.cause.partition("(")[2]) == (
        "python-exception",
        "arm.ArmError, raised in /app/arm.py:9): no arm at 3.",
    )


def test_a_package_whose_metadata_cannot_be_made_is_the_last_collected() -> None:
    said = (
        "Collecting numpy\n  Downloading numpy.whl\nCollecting arm==1.0\n  error: subprocess-exited-with-error\n  stop"
    )
    assert dict(found(said, "pip install -r a.txt").names)["package"] == "arm==1.0".partition("=")[0]


def test_a_library_is_named_once_where_it_lacks_the_symbol_itself() -> None:
    one = found("/opt/ros/a/talker: symbol lookup error: /opt/ros/a/talker: undefined symbol: rcutils_strnlen")
    assert one.cause.startswith(
        "/opt/ros/a/talker and a library that it loads are of different releases: rcutils_strnlen,"
    )


def test_functions_of_cuda_are_in_no_packaged_opencv() -> None:
    said = "a.o: undefined reference to `cv::cuda::createStereoBM(int)'\ncollect2: error: ld returned 1 exit status"
    assert "OpenCV with CUDA" in found(said, "make").cause


def test_the_release_of_osqp_that_code_is_written_for_is_told_by_what_it_is_compiled_with() -> None:
    said = "a.cpp:3:9: error: too few arguments to function '{}')'"
    old = found(said.format("c_int osqp_setup(OSQPWorkspace**, const OSQPData*, const OSQPSettings*"), "make")
    new = found(said.format("OSQPInt osqp_setup(OSQPSolver**, const OSQPCscMatrix*, const OSQPFloat*"), "make")
    assert ("the older OSQP" in old.fix, "OSQP 0.6.3" in new.fix) == (True, True)
