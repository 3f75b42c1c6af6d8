"""What a message says and what it does not: the cause that is told, and none that the message rules out."""

from __future__ import annotations

import io

import pytest

from failed_builds import log
from roslab.explain.answer import explain

BOOST = (
    "CMake Error at /usr/share/cmake-3.28/Modules/FindPackageHandleStandardArgs.cmake:230 (message):",
    '  Could NOT find Boost (missing: {}) (found version "{}")',
)
DENIED = "Traceback (most recent call last):\nPermissionError: [Errno 13] Permission denied: '{}'\n"
PACKAGING = "ImportError: cannot import name 'packaging' from 'pkg_resources' ({}/pkg_resources/__init__.py)"
IGNORED = "ERROR: Ignored the following versions that require a different python version: "


@pytest.mark.parametrize(
    ("text", "cause"),
    [
        (
            log(
                "pip install .",
                f"{IGNORED}0.52.0 Requires-Python >=3.6,<3.9; 0.53.0 Requires-Python >=3.6,<3.10",
                "ERROR: Could not find a version that satisfies the requirement example>=1.23 (from versions: 0.1)",
                "ERROR: No matching distribution found for example>=1.23",
            ),
            "pip-no-version",
        ),
        (
            log(
                "pip install .",
                f"{IGNORED}1.23.0 Requires-Python >=3.12; 1.24.0 Requires-Python >=3.12",
                "ERROR: No matching distribution found for example>=1.23",
            ),
            "pip-version-needs-newer-python",
        ),
        (
            "resource not found: robot_description\nROS path [0]=/opt/ros/melodic/share/ros\n",
            "ros-package-not-found",
        ),
        (
            log(
                "pip install sim",
                "RuntimeError: SIM_PATH environment variable is not set",
                "ERROR: Failed building wheel for sim",
            ),
            "wheel-does-not-build",
        ),
        (
            log(
                "cmake .",
                "CMake Error: The following variables are used in this project, but they are set to NOTFOUND.",
                "Please set them or make sure they are set and tested correctly in the CMake files:",
                "/app/ARM_INTERFACES_INCLUDE_DIRECTORIES",
                "   used as include directory in directory /app",
            ),
            "cmake-notfound-variable",
        ),
        (DENIED.format("/dev/ttyUSB0"), "device-denied"),
        (DENIED.format("/opt/venv/share/robot/cache"), "start-write-denied"),
        (
            log("colcon build", "/ws/build/arm/_deps/six-src/six.hpp:30:3: error: expected ';' before '}' token"),
            None,
        ),
        (log("pip install arm", PACKAGING.format("/opt/venv/lib/python3.10/site-packages")), "python-name-dropped"),
        # What is installed is not what pip builds with, beside it
        (log("pip install arm", PACKAGING.format("/tmp/pip-build-env-a1/overlay")), "python-api-removed"),
        (log("make", "Failed to import jinja2: No module named 'jinja2'"), "python-module-missing"),
        (log("make", "a.cpp:3:1: error: 'CV_SVD_U_T' was not declared in this scope"), "api-known"),
        (log("make", "a.cpp:3:1: error: 'cvSolve' was not declared in this scope"), "api-known"),
        (log("make", "a.cpp:3:10: fatal error: cv.hpp: No such file or directory"), "api-known"),
        (log("make", "a.cpp:3:1: error: 'class gazebo::physics::World' has no member named 'Physics'"), "api-known"),
        (
            log("make", "a.cpp:3:1: error: 'class gazebo::physics::Link' has no member named 'GetWorldPose'"),
            "api-known",
        ),
        (log("make", "a.cpp:3:1: error: 'gazebo::math' has not been declared"), "api-known"),
        # What is compiled of a package is no part that another release moved
        (log("python a.py", "ModuleNotFoundError: No module named 'grasp_ops._ext'"), "python-extension-not-built"),
        # The archives of ROS have Debian's releases in the same folder
        (
            log(
                "apt-get update",
                "E: The repository 'http://apt.example.org/ros2/ubuntu trixie Release' does not have a Release file.",
            ),
            "repository-dropped-release",
        ),
        # A newer CMake says this too
        (
            log(
                "cmake .",
                "CMake Error at CMakeLists.txt:3 (target_link_libraries):",
                '  Attempt to add link library "m" to target "arm" which is not built in this',
                "  directory.",
                "",
                "  This is allowed only when policy CMP0079 is set to NEW.",
            ),
            "cmake-call-wrong",
        ),
        (
            log(
                "cmake .",
                "CMake Error at CMakeLists.txt:3 (install):",
                '  install TARGETS given no LIBRARY DESTINATION for module target "arm".',
            ),
            "cmake-call-wrong",
        ),
        # wget and make go on after these
        (log("cmake .", "CMake Error at Find.cmake:310 (message):", "  Missing executable groff!"), "program-missing"),
        (
            log("./get", "WARNING: The certificate of 'example.org' is not trusted.", "/bin/sh: 1: screen: not found"),
            "program-missing",
        ),
        (
            log(
                "make",
                "arm.cpp:3:1: error: expected ';' at end of declaration",
                "make: warning:  Clock skew detected.  Your build may be incomplete.",
            ),
            None,
        ),
        # apt brings no Python of that folder
        (
            log("./arm", "/bin/sh: ./arm: /usr/local/bin/python3: bad interpreter: No such file or directory"),
            "line-endings",
        ),
        (
            log(
                "cmake .",
                "CMake Error at CMakeLists.txt:44 (add_subdirectory):",
                '  add_subdirectory given source "/mnt/d/arm" which is not an existing directory.',
            ),
            "cmake-authors-folder",
        ),
    ],
)
def test_the_cause_is_what_the_message_says(text: str, cause: str | None) -> None:
    assert [found.id for found in explain(io.BytesIO(text.encode())).explanations] == [cause]


@pytest.mark.parametrize(
    ("missing", "version", "cause", "repair"),
    [
        ("program_options", "1.83.0", "boost-part-missing", ("libboost-all-dev",)),
        ("thread unit_test_framework", "1.65.1", "boost-part-missing", ("libboost-all-dev",)),
        ("python310", "1.74.0", "boost-part-missing", ("libboost-all-dev",)),
        ("python3", "1.65.1", "boost-part-missing", ("libboost-all-dev",)),
        ("signals", "1.65.1", "boost-part-missing", ("libboost-all-dev",)),
        ("thread signals", "1.83.0", "boost-part-gone", ()),
        ("python3 thread", "1.74.0", "boost-part-gone", ()),
    ],
)
def test_a_part_of_boost_that_no_package_has_is_not_asked_for(
    missing: str, version: str, cause: str, repair: tuple[str, ...]
) -> None:
    text = log("cmake .", BOOST[0], BOOST[1].format(missing, version))
    (found,) = explain(io.BytesIO(text.encode())).explanations
    assert (found.id, dict(found.repair).get("apt", ())) == (cause, repair)


def test_what_cmake_only_says_of_boost_is_no_cause() -> None:
    said = f"--{BOOST[1].format('signals', '1.83.0')[1:]}"
    text = log("make", said, "a.cpp:3:10: fatal error: arm/arm.h: No such file or directory")
    assert [found.id for found in explain(io.BytesIO(text.encode())).explanations] == ["header-missing"]


def test_a_package_of_ros_that_is_not_released_is_no_package_of_apt() -> None:
    said = "-- Could not find the required component '{}'. The following CMake error indicates that you either need to"
    distro = "CMake Error at /opt/ros/noetic/share/catkin/cmake/catkinConfig.cmake:83 (find_package):"
    for name, named in (("pluginlib", "ros-noetic-pluginlib under `apt`"), ("my_own_arm", "its repository under")):
        (found,) = explain(io.BytesIO(log("catkin_make", said.format(name), distro).encode())).explanations
        assert named in found.fix


def test_a_variable_that_is_not_found_names_its_library() -> None:
    said = (
        "CMake Error: The following variables are used in this project, but they are set to NOTFOUND.",
        "USB_LIBRARY",
    )
    text = log("cmake .", *said, '    linked by target "robot" in directory /app')
    assert "the library USB (" in explain(io.BytesIO(text.encode())).explanations[0].cause


@pytest.mark.parametrize(
    ("said", "cause"),
    [
        ("NameResolutionError(\"Failed to resolve 'data.acme.io'\"))", "host-unknown"),
        ("NewConnectionError('Failed to establish a new connection: [Errno 111] Connection refused'))", "connection"),
    ],
)
def test_a_request_of_the_program_is_none_to_the_index_of_pip(said: str, cause: str) -> None:
    begun = (
        "requests.exceptions.ConnectionError: HTTPSConnectionPool(host='data.acme.io', port=443): Max retries exceeded"
    )
    text = log("python get.py", f"{begun} with url: /a.zip (Caused by {said}")
    assert [found.id for found in explain(io.BytesIO(text.encode())).explanations] == [cause]


def test_a_function_of_unix_that_is_not_declared_names_its_header() -> None:
    said = "/app/src/master.hpp:58:9: error: '::close' has not been declared; did you mean 'pclose'?"
    (found,) = explain(io.BytesIO(log("make", said).encode())).explanations
    assert "CXXFLAGS: -include unistd.h" in found.fix


def test_the_library_of_a_plugin_is_of_its_package() -> None:
    said = "[FATAL] [1.5]: Failed to load nodelet '/grab' of type 'image_proc/debayer' : Could not find library"
    text = log(
        "./start", f"{said} corresponding to plugin image_proc/debayer. Make sure the plugin description XML file"
    )
    assert "image_proc" in explain(io.BytesIO(text.encode())).explanations[0].cause
