"""What plan and log together say about roslab.yaml: the value, who asked for it, and where nothing answers."""

from __future__ import annotations

import io
import subprocess
from collections.abc import Mapping
from pathlib import Path

import pytest

from failed_builds import log, repaired
from roslab.explain.answer import explain
from roslab.knowledge.failures import failures
from roslab.knowledge.repairs import repairs
from roslab.repair import dockerfile
from roslab.repair.ways import WAYS

PACKAGE = """\
<package format="2"><name>robot</name><version>1.0.0</version><description>d</description>
<maintainer email="a@example.org">a</maintainer><license>MIT</license><buildtool_depend>catkin</buildtool_depend>
<depend>robot_arm</depend></package>
"""
ROS = {"package.xml": PACKAGE, "CMakeLists.txt": "project(robot)\n", "roslab.yaml": "format: 3\nbase: {ros: noetic}\n"}
CPP = {"CMakeLists.txt": "project(robot CXX)\nadd_executable(robot main.cpp)\n", "main.cpp": "int main() {}\n"}
PYTHON = {"requirements.txt": "numpy\nexample==2.6.0\n", "main.py": "import numpy\nnumpy.array\nprint(1)\n"}


def made(folder: Path, files: Mapping[str, str]) -> Path:
    for name, text in files.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text)
    return folder


REFUSED = "ERROR: Package 'example' requires a different Python: 3.10.12 not in '<3.10,>=3.7'"
IGNORED = (
    "ERROR: Ignored the following versions that require a different python version: "
    "1.0.0 Requires-Python <3.8; 2.6.0 Requires-Python <3.9,>=3.6"
)


@pytest.mark.parametrize(
    ("files", "text", "wanted", "place"),
    [
        (
            {**CPP, "main.cpp": "#include <glog/logging.h>\nint main() {}\n"},
            log("make", "/home/jovyan/robot/main.cpp:1:10: fatal error: glog/logging.h: No such file or directory"),
            ["apt: [libgoogle-glog-dev]"],
            "main.cpp:1",
        ),
        (
            {**CPP, "CMakeLists.txt": CPP["CMakeLists.txt"] + "find_package(Ceres REQUIRED)\n"},
            log("cmake .", "CMake Error at CMakeLists.txt:3 (find_package):", 'By not providing "FindCeres.cmake" in'),
            ["apt: [libceres-dev]"],
            "CMakeLists.txt:3",
        ),
        (PYTHON, log("pip install .", REFUSED), ["base.python: 3.8"], "requirements.txt:2"),
        (
            PYTHON,
            log("pip install -r requirements.txt", IGNORED, "ERROR: No matching distribution found for example==2.6.0"),
            ["base.python: 3.8"],
            "requirements.txt:2",
        ),
        (
            PYTHON,
            log(
                "python3 main.py",
                "Traceback (most recent call last):",
                '  File "/home/jovyan/robot/main.py", line 2, in <module>',
                "AttributeError: module 'numpy' has no attribute 'float'.",
            ),
            ["pip: [numpy<1.24]"],
            "main.py:2",
        ),
        (
            ROS,
            log("rosdep install", "apt: Failed to detect successful installation of [ros-noetic-robot-arm]"),
            ["skip_keys: [robot_arm]"],
            "package.xml:3",
        ),
        (
            ROS,
            log("install-rosdep-keys /tmp/manifests", "E: Unable to locate package ros-noetic-robot-arm"),
            ["skip_keys: [robot_arm]"],
            "package.xml:3",
        ),
        (
            ROS,
            log(
                "catkin_make",
                "Could not find a package configuration file provided by",
                '  "cv_bridge" with any of the following names: /opt/ros/noetic',
            ),
            ["apt: [ros-noetic-cv-bridge]"],
            None,
        ),
        (
            {**ROS, "roslab.yaml": "format: 3\nbase: {ros: humble}\nbuild: colcon\n"},
            log("colcon build", "c++: fatal error: Killed signal terminated program cc1plus"),
            ["build_args: [--executor]", "build_args: [sequential]"],
            None,
        ),
        (
            {**CPP, "roslab.yaml": "format: 3\napt: [bc=1.06-1]\n"},
            log("apt-get install bc=1.06-1", "E: Version '1.06-1' for 'bc' was not found"),
            ["apt: [bc=1.06-1 becomes bc]"],
            "roslab.yaml:2:7",
        ),
        (
            {**CPP, "roslab.yaml": "format: 3\napt:\n  - libeigen2-dev\n"},
            log("apt-get install libeigen2-dev", "E: Unable to locate package libeigen2-dev"),
            ["apt: [libeigen2-dev becomes libeigen3-dev]"],
            "roslab.yaml:3:5",
        ),
        (
            CPP,
            log("cmake .", "  CMake 3.31 or higher is required.  You are running version 3.22.1"),
            ["base.cmake_update: 3.31.0"],
            None,
        ),
        (CPP, log("make", "a.hpp:2:2: error: #error C++20 or newer"), ["cmake_options: -DCMAKE_CXX_STANDARD=20"], None),
        (CPP, log("make", "b.hpp:2:2: error: #error requires C++20"), ["cmake_options: -DCMAKE_CXX_STANDARD=20"], None),
    ],
)  # fmt: skip
def test_plan_and_log_give_the_value_and_who_asked(
    tmp_path: Path, files: Mapping[str, str], text: str, wanted: list[str], place: str | None
) -> None:
    found = repaired(made(tmp_path, files), text)
    assert [str(change) for change in found.changes] == wanted, found
    assert all(change.certain for change in found.changes)
    assert str(found.changes[0].asked.place) == str(place), found


GLIBC = "./tool: /lib/libc.so.6: version `GLIBC_2.38' not found"
GENERIC = "TypeError: 'type' object is not subscriptable"
CATKIN = 'By not providing "Findcatkin.cmake" in CMAKE_MODULE_PATH'
BOOST = 'Could not find a package configuration file provided by "boost_system" (requested version 1.90.0)'
SOURCED = "source /opt/ros/lyrical/setup.bash && colcon build"
GONE = 'Unknown CMake command "ament_target_dependencies".'
GONE_HEADER = "a.cpp:2:10: fatal error: message_filters/subscriber.h: No such file or directory"
ASIO = "a.cpp:2:16: error: 'io_service' is not a member of 'boost::asio'"


@pytest.mark.parametrize(
    ("yaml", "text", "wanted"),
    [
        ("base: {ros: humble}", log("colcon build", CATKIN), "base.ros: humble becomes noetic"),
        (
            "base: {ros: noetic}",
            log("rosdep install -y", "arm: No definition of [ament_cmake] for OS version [jammy]"),
            "base.ros: noetic becomes humble",
        ),
        ("base: {ubuntu: '22.04'}", log("./tool", GLIBC), "base.ubuntu: 22.04 becomes 24.04"),
        ("kind: python\nbase: {python: '3.8'}", log("./tool", GENERIC), "base.python: 3.8 becomes 3.9"),
        ("base: {ros: lyrical}", log("colcon build", BOOST), "base.ros: lyrical becomes kilted"),
        ("base: {ros: lyrical}", log("colcon build", ASIO), "base.ros: lyrical becomes kilted"),
        ("base: {ros: lyrical}", log(SOURCED, GONE), "base.ros: lyrical becomes kilted"),
        ("base: {ros: lyrical}", log(SOURCED, GONE_HEADER), "base.ros: lyrical becomes kilted"),
    ],
)
def test_another_base_is_likely_and_never_certain(tmp_path: Path, yaml: str, text: str, wanted: str) -> None:
    found = repaired(made(tmp_path, {**CPP, "roslab.yaml": f"format: 3\n{yaml}\n"}), text)
    assert [str(change) for change in found.changes] == [wanted]
    assert found.certain.changes == ()


@pytest.mark.parametrize(
    ("files", "text", "why"),
    [
        (ROS, log("pip install .", REFUSED), "the Python of ROS noetic cannot be exchanged"),
        (
            ROS,
            log(
                "catkin_make",
                "Could not find a package configuration file provided by",
                '  "my_own_msgs" with any of the following names: /opt/ros/noetic',
            ),
            "my_own_msgs is not released for ROS noetic",
        ),
        (
            {f"robot/{path}": text for path, text in ROS.items()}
            | {"msgs/package.xml": "<package><name>my_own_msgs</name></package>", "README.md": "ROS Noetic\n"},
            log(
                "catkin_make",
                "Could not find a package configuration file provided by",
                '  "my_own_msgs" with any of the following names: /opt/ros/noetic',
            ),
            "my_own_msgs is a package of this repository: it is built after what asks for it, or not at all",
        ),
        (
            {**CPP, "roslab.yaml": "format: 3\napt: [libgoogle-glog-dev]\n"},
            log("make", "main.cpp:1:10: fatal error: glog/logging.h: No such file or directory"),
            "roslab.yaml has libgoogle-glog-dev already",
        ),
        (CPP, log("make", "main.cpp:1:1: error: what is this"), "no known cause"),
        (ROS, log("catkin_make", CATKIN), "ROS noetic has it: source /opt/ros/noetic/setup.bash"),
        (ROS, log("make", GLIBC), "ROS noetic belongs to its Ubuntu"),
        (CPP, log("make", ASIO), "the image has no ROS, which another one could take the place of"),
        (ROS, log("./tool", GENERIC), "the Python of ROS noetic cannot be exchanged"),
        (
            {"main.py": "import numpy\n", "roslab.yaml": "format: 3\nbase: {python: '3.11'}\n"},
            log("./tool", GENERIC),
            "the image has Python 3.11 already",
        ),
        (
            ROS,
            log(
                "catkin_make",
                "Could not find a package configuration file provided by",
                '  "minkindr" with any of the following names: /opt/ros/noetic',
            ),
            "minkindr is not released for ROS noetic: name its repository under `source`: https://github.com/",
        ),
    ],
)
def test_where_nothing_answers_it_says_why(tmp_path: Path, files: Mapping[str, str], text: str, why: str) -> None:
    found = repaired(made(tmp_path, files), text)
    assert found.changes == ()
    assert why in "".join(reason for _, reason in found.refused)


def test_the_python_that_uv_does_not_find_is_taken_and_no_newer_one(tmp_path: Path) -> None:
    text = log("uv sync", "error: No interpreter found for Python 3.9 in managed installations or search path")
    (change,) = repaired(tmp_path, text, PYTHON).changes
    assert (change.key, change.value) == ("base.python", "3.9")


def test_a_submodule_that_is_not_checked_out(tmp_path: Path) -> None:
    made(tmp_path, CPP)
    module = '[submodule "maths"]\n\tpath = third_party/maths\n\turl = https://example.org/maths\n'
    (tmp_path / ".gitmodules").write_text(module)
    subprocess.run(["git", "init", "--quiet", str(tmp_path)], check=True)
    said = [
        "CMake Error at CMakeLists.txt:3 (add_subdirectory):",
        "  The source directory",
        "    /home/jovyan/robot/third_party/maths",
        "  does not contain a CMakeLists.txt file.",
    ]
    found = repaired(tmp_path, log("cmake .", *said))
    assert [str(change) for change in found.changes] == ["submodules: required"]
    stopped = "/home/jovyan/robot/third_party/maths/a.cpp:3:10: fatal error: {}: No such file or directory".format
    found = repaired(tmp_path, log("make", stopped("curl/curl.h")))
    assert [str(change) for change in found.changes] == ["apt: [libcurl4-openssl-dev]"], "a file of it was compiled"
    (tmp_path / ".gitmodules").write_text(module.replace("maths", "nav_core"))
    found = repaired(tmp_path, log("make", "main.cpp:3:10: fatal error: nav_core/arm.h: No such file or directory"))
    assert [str(change) for change in found.certain.changes] == ["submodules: required"]
    (tmp_path / ".gitmodules").write_text(module)
    (tmp_path / "third_party" / "maths").mkdir(parents=True)
    (tmp_path / "third_party" / "maths" / "README").write_text("here")
    assert repaired(tmp_path, log("cmake .", *said)).changes == (), "it is there: something else is wrong"


INSTALL = "apt-get install -y --no-install-recommends"
OWN = """\
FROM ubuntu:22.04
USER robot
# What the robot needs
RUN apt-get update && \\
    apt-get install -y git
RUN make
"""


@pytest.mark.parametrize(
    ("text", "wanted"),
    [
        (
            log("make", "a.cpp:1:10: fatal error: glog/logging.h: No such file or directory"),
            f"+USER root\n+RUN apt-get update && {INSTALL} libgoogle-glog-dev\n+USER robot\n RUN make\n",
        ),
        (
            "Dockerfile:4\n"
            + log("apt-get update &&     apt-get install -y git", "E: Version '1.06-1' for 'git' was not found"),
            None,
        ),
        (log("make", "error: externally-managed-environment"), "+ENV PIP_BREAK_SYSTEM_PACKAGES=1\n RUN make\n"),
    ],
)
def test_an_own_dockerfile_gets_a_diff(text: str, wanted: str | None) -> None:
    edits = dockerfile.edits(explain(io.BytesIO(text.encode())), OWN)
    diff = dockerfile.diff("Dockerfile", OWN, edits)
    assert (diff == "") if wanted is None else (wanted in diff), diff


def test_a_word_of_an_own_dockerfile_is_replaced() -> None:
    own = "FROM ubuntu:22.04\nRUN apt-get update && \\\n    apt-get install -y bc=1.06-1 git\n"
    said = log("apt-get update &&     apt-get install -y bc=1.06-1 git", "E: Version '1.06-1' for 'bc' was not found")
    diff = dockerfile.diff("Dockerfile", own, dockerfile.edits(explain(io.BytesIO(said.encode())), own))
    assert "-    apt-get install -y bc=1.06-1 git\n+    apt-get install -y bc git\n" in diff


def broken(command: str, *said: str) -> str:
    """Return a log of the classic builder, whose steps are on one line."""
    return "\n".join(
        [f"Step 3/4 : RUN {command}", *said, f"The command '/bin/sh -c {command}' returned a non-zero code: 1"]
    )


@pytest.mark.parametrize(
    ("text", "wanted"),
    [
        (
            broken(
                "apt-get update &&     apt-get install -y         git         libpng12-dev",
                "Fetched 9 kB",
                "E: Unable to locate package libpng12-dev",
            ),
            "     git \\\n-    libpng12-dev\n+    libpng-dev\n",
        ),
        (
            broken(
                "apt-get update && apt-get install -y     oracle-java8-installer     oracle-java8-set-default     git",
                "Fetched 9 kB",
                "E: Unable to locate package oracle-java8-installer",
                "E: Unable to locate package oracle-java8-set-default",
            ),
            "-    oracle-java8-installer \\\n-    oracle-java8-set-default \\\n+    openjdk-8-jdk \\\n     git\n",
        ),
        (
            broken(
                "conda install numpy=0.1 scipy",
                "PackagesNotFoundError: The following packages are missing:",
                "",
                "  - numpy=0.1",
            ),
            "-RUN conda install numpy=0.1 scipy\n+RUN conda install numpy scipy\n",
        ),
        (
            broken(
                "curl -fO https://www.apache.org/dist/a/a-1.tgz", "curl: (22) The requested URL returned error: 404"
            ),
            "+RUN curl -fO https://archive.apache.org/dist/a/a-1.tgz\n",
        ),
        (
            broken("python3.6 setup.py build", "language_level directive must be set to an integer, got '3str'"),
            '+RUN python3.6 -m pip install "cython>=0.29"\n RUN python3.6 setup.py build\n',
        ),
        (
            broken("x", "")
            .replace("RUN x", "FROM nvidia/cuda:11.3.0-cudnn8-devel-ubuntu20.04")
            .replace(
                "\n\n", "\nmanifest for nvidia/cuda:11.3.0-cudnn8-devel-ubuntu20.04 not found: manifest unknown\n"
            ),
            "-FROM nvidia/cuda:11.3.0-cudnn8-devel-ubuntu20.04\n+FROM nvidia/cuda:11.3.1-cudnn8-devel-ubuntu20.04\n",
        ),
        (
            broken("rosdep install --from-paths src", "your rosdep installation has not been initialized yet"),
            " || rosdep init && rosdep update --include-eol-distros\n RUN rosdep install --from-paths src\n",
        ),
        (
            broken(
                "rosdep update && rosdep install --from-paths src",
                'Skip end-of-life distro "kinetic"',
                "robot: Cannot locate rosdep definition for [roscpp]",
            ),
            "+RUN rosdep update --include-eol-distros && rosdep install --from-paths src\n",
        ),
        (
            broken("pip install .[dev, sim] --no-deps", "ERROR: Invalid requirement: '.[dev,'"),
            "-RUN pip install .[dev, sim] --no-deps\n+RUN pip install .[dev,sim] --no-deps\n",
        ),
        (broken("./test", "/bin/sh: 1: ./test: not found"), ""),
    ],
)
def test_a_log_alone_shows_the_lines_of_an_own_dockerfile(text: str, wanted: str) -> None:
    said = dockerfile.suggested(explain(io.BytesIO(text.encode())))
    assert wanted in said
    assert wanted or not said


def test_a_tag_that_nvidia_never_renewed_is_not_guessed() -> None:
    gone = "manifest for nvidia/cuda:9.0-devel-ubuntu16.04 not found: manifest unknown"
    answer = explain(io.BytesIO(f"Step 1/4 : FROM nvidia/cuda:9.0-devel-ubuntu16.04\n{gone}\n".encode()))
    assert [found.id for found in answer.explanations] == ["image-tag-gone"]
    assert dockerfile.suggested(answer) == ""


@pytest.mark.parametrize("name", sorted(repairs()))
def test_a_repair_belongs_to_a_failure_and_says_how(name: str) -> None:
    row = repairs()[name]
    assert name in {failure.id for failure in failures()}
    assert bool(row.value or row.way) == bool(row.key)
    assert row.way in {"", *WAYS}
    assert row.key or row.dockerfile or row.find or row.image or row.files
    assert bool(row.image) == bool(row.tag)
    assert row.find or not row.replace
    assert row.source
    assert row.date


def _shown(*lines: str) -> str:
    return "".join(f"{line}\n" for line in lines)


NODE = 'error tar@6.0.2: The engine "node" is incompatible with this module. Expected version ">= 10". Got "6.17.1"'
RUST = "error: package `clap v4.5` cannot be built because it requires rustc 1.74 or newer, while the current is 1.60"
PYTHON_REFUSED = "ERROR: Package 'example' requires a different Python: 3.6.15 not in '>=3.8,<3.12'"


@pytest.mark.parametrize(
    ("base", "error", "wanted"),
    [
        ("node:6.17-alpine3.9", NODE, "node:10-alpine"),
        ("rust:1.60-slim-buster", RUST, "rust:1.74-slim"),
        ("python:3.6", PYTHON_REFUSED, "python:3.8"),
        ("python:3.7", f"{IGNORED}\n#6 1.2 ERROR: No matching distribution found for example==2.6.0", ""),
        ("python:3.9", f"{IGNORED}\n#6 1.2 ERROR: No matching distribution found for example==2.6.0", "python:3.6"),
        ("ubuntu:xenial", "a.cpp:1:10: fatal error: filesystem: No such file or directory", "ubuntu:22.04"),
        ("ubuntu:18.04", PYTHON_REFUSED, ""),
    ],
)
def test_the_log_shows_the_base_image_that_fits(base: str, error: str, wanted: str) -> None:
    command = {"node": "yarn add tar", "rust": "cargo build", "pyth": "pip install example"}.get(base[:4], "make")
    hub = "docker.io/library/"
    text = _shown(
        f"#5 [builder 1/2] FROM {hub}{base}@sha256:{'0a' * 32}",
        "#5 DONE 1.0s",
        f"#6 [builder 2/2] RUN {command}",
        f"#6 1.2 {error}",
        f'#6 ERROR: process "/bin/sh -c {command}" did not complete: exit code: 1',
    )
    answer = explain(io.BytesIO(text.encode()))
    assert [found.base for found in answer.explanations] == [f"FROM {base} AS builder"]
    said = dockerfile.suggested(answer)
    assert (f"-FROM {base} AS builder\n+FROM {wanted} AS builder\n" in said) == bool(wanted)
    own = f"FROM {base} AS builder\nRUN {command}\n"
    changed = dockerfile.edited(own, dockerfile.edits(answer, own))
    assert changed == own.replace(base, wanted or base)


def test_the_base_image_is_that_of_the_failed_stage() -> None:
    text = _shown(
        "Step 1/4 : FROM golang:1.13 AS tools",
        " ---> 0123456789ab",
        "Step 2/4 : FROM node:6",
        " ---> 0123456789ac",
        "Step 3/4 : RUN yarn",
        " ---> Running in 0123456789ad",
        NODE,
        "The command '/bin/sh -c yarn' returned a non-zero code: 1",
    )
    assert dockerfile.suggested(explain(io.BytesIO(text.encode()))) == "-FROM node:6\n+FROM node:10\n RUN yarn\n"


def test_a_log_without_steps_has_the_instructions_to_insert() -> None:
    text = "LibMambaUnsatisfiableError: Encountered problems while solving:\n"
    text += "  - package python-3.7.13-haa1d7c7_1 is excluded by strict repo priority\n"
    said = dockerfile.suggested(explain(io.BytesIO(text.encode())))
    assert said == "+RUN conda config --set channel_priority flexible\n"


@pytest.mark.parametrize(
    ("command", "error", "wanted"),
    [
        (
            "bower install",
            "bower  ECONFLICT Unable to find suitable version for angular",
            "+RUN bower install --force-latest",
        ),
        ("npm i", "npm ERR! code ERESOLVE", "+RUN npm i --legacy-peer-deps"),
        (
            "go get github.com/a/b && b",
            "go: 'go get' is no longer supported outside a module",
            "+RUN go install github.com/a/b@latest && b",
        ),
        (
            "gpg --keyserver ha.pool.sks-keyservers.net --recv-keys A",
            "gpg: keyserver receive failed: No name",
            "+RUN gpg --keyserver hkp://keyserver.ubuntu.com:80 --recv-keys A",
        ),
        (
            "make",
            "nvcc fatal   : Unsupported gpu architecture 'compute_86'",
            '+ENV TORCH_CUDA_ARCH_LIST="6.1;7.0;7.5;8.0+PTX"',
        ),
        ("make", "nvcc fatal   : Unsupported gpu architecture 'compute_20'", ""),
        (
            "apk add python py-pip",
            "  py-pip (no such package):\n#6 1.2 ERROR: unable to select packages:",
            "+RUN apk add python py3-pip",
        ),
        (
            "apk add py-pip robot",
            "  py-pip (missing):\n#6 1.2   robot (missing):\n#6 1.2 ERROR: unable to select packages:",
            "",
        ),
    ],
)
def test_a_step_is_shown_as_it_should_be(command: str, error: str, wanted: str) -> None:
    said = dockerfile.suggested(explain(io.BytesIO(log(command, *error.split("\n#6 1.2 ")).encode())))
    assert wanted in said.splitlines() if wanted else not said


@pytest.mark.parametrize(
    ("image", "wanted"),
    [
        ("vault:1.13", "hashicorp/vault:1.13"),
        ("vault", "hashicorp/vault"),
        ("bitnami/spark:3.5", "bitnamilegacy/spark:3.5"),
        ("example/vault:1.13", ""),
    ],
)
def test_an_image_that_moved_is_named_anew(image: str, wanted: str) -> None:
    tagged = image if ":" in image else f"{image}:latest"
    text = (
        f"#2 [internal] load metadata for docker.io/library/{tagged}\n#2 ERROR: docker.io/library/{tagged}: not found\n"
    )
    answer = explain(
        io.BytesIO(text.replace("library/bitnami", "bitnami").replace("library/example", "example").encode())
    )
    own = f"FROM {image}\nRUN true\n"
    changed = dockerfile.edited(own, dockerfile.edits(answer, own, likely=True))
    assert changed == own.replace(image, wanted or image)


def test_an_image_with_a_compiler_is_taken_where_one_is_wanted() -> None:
    text = log("pip install flash-attn", "OSError: CUDA_HOME environment variable is not set.").replace(
        "#6 [3/4]", "#6 [2/2]"
    )
    base = "#5 [1/2] FROM docker.io/nvidia/cuda:12.2.0-runtime-ubuntu22.04\n#5 DONE 0.1s\n"
    said = dockerfile.suggested(explain(io.BytesIO((base + text).encode())))
    assert "+FROM nvidia/cuda:12.2.0-devel-ubuntu22.04" in said.splitlines()
