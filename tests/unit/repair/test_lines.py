"""The lines of a Dockerfile that a log alone calls for: what is written, and where nothing is sure."""

from __future__ import annotations

import io

import pytest

from roslab.explain.answer import explain
from roslab.repair import dockerfile


def shown(text: str) -> list[str]:
    """Return the changed lines of what is suggested."""
    said = dockerfile.suggested(explain(io.BytesIO(text.encode())))
    return [line for line in said.splitlines() if line.startswith(("+", "-"))]


def step(command: str, *lines: str, base: str = "", user: str = "") -> str:
    """Return a classic builder's log of a step that failed."""
    above = [one for one in (f"FROM {base}" if base else "", f"USER {user}" if user else "") if one]
    known = "".join(f"Step {at}/9 : {one}\n ---> 0123456789ab\n" for at, one in enumerate(above, 1))
    said = "".join(f"{line}\n" for line in lines)
    return f"{known}Step 8/9 : RUN {command}\n{said}The command '/bin/sh -c {command}' returned a non-zero code: 1\n"


GCC = "unable to execute 'gcc': No such file or directory\nerror: command 'gcc' failed with exit status 1"


@pytest.mark.parametrize(
    ("base", "wanted"),
    [
        ("python:3.11-slim", ["+RUN apt-get update && apt-get install -y --no-install-recommends build-essential"]),
        ("python:3.11-alpine", ["+RUN apk add --no-cache build-base"]),
        ("fedora:40", []),
        ("amazonlinux:2", []),
    ],
)
def test_packages_come_from_the_manager_of_the_base_image(base: str, wanted: list[str]) -> None:
    assert shown(step("pip install thing", GCC, base=base)) == wanted


def test_what_apk_calls_otherwise_is_not_guessed() -> None:
    assert (
        shown(step("make", "a.cpp:1:10: fatal error: glog/logging.h: No such file or directory", base="alpine")) == []
    )


CONFLICT = """\
ERROR: Cannot install -r list.txt (line 3) and alpha==2.6 because these package versions have conflicting dependencies.

The conflict is caused by:
    The user requested alpha==2.6
    beta 1.0 depends on alpha<=2.5 and >=2.4
"""


def test_a_pin_becomes_what_pip_says_it_has_to_be() -> None:
    wanted = "+RUN sed -i -E 's/^alpha==[^ ;#]+/alpha<=2.5,>=2.4/I' list.txt"
    assert shown(step("pip install -r list.txt", CONFLICT)) == [wanted]


@pytest.mark.parametrize(
    "more",
    [
        "    gamma 1.0 depends on delta<3\n",  # of two packages, either pin may give way
        "    gamma 1.0 depends on alpha==2.3\n    delta 1.0 depends on alpha==2.4\n",
    ],
)
def test_pins_that_no_version_fits_are_left(more: str) -> None:
    text = CONFLICT.replace("    beta 1.0 depends on alpha<=2.5 and >=2.4\n", more)
    assert shown(step("pip install -r list.txt", text)) == []


@pytest.mark.parametrize(
    ("command", "wanted"),
    [
        ("make && ctest -L fast", ["-RUN make && ctest -L fast", "+RUN make"]),
        ("ctest", ["-RUN ctest"]),
        ("ctest && make install", ["-RUN ctest && make install", "+RUN make install"]),
        ("./run-all", []),
    ],
)
def test_an_image_is_built_without_its_tests(command: str, wanted: list[str]) -> None:
    text = step(command, "50% tests passed, 1 tests failed out of 2", "Errors while running CTest", base="ubuntu:22.04")
    assert shown(text) == wanted


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("https://downloads.apache.org/a/1.0/a.tgz", "https://archive.apache.org/dist/a/1.0/a.tgz"),
        ("http://eu.mirror.example.org/pub/apache/a/a.tgz", "https://archive.apache.org/dist/a/a.tgz"),
        ("https://dl.bintray.com/boostorg/release/1.7/b.tgz", "https://archives.boost.io/release/1.7/b.tgz"),
        ("https://zlib.net/zlib-1.2.11.tar.gz", "https://zlib.net/fossils/zlib-1.2.11.tar.gz"),
        (
            "https://cran.r-project.org/src/contrib/abc_1.0.tar.gz",
            "https://cran.r-project.org/src/contrib/Archive/abc/abc_1.0.tar.gz",
        ),
    ],
)
def test_a_file_is_fetched_from_where_all_its_kind_have_moved(old: str, new: str) -> None:
    text = step(f"wget -q {old}", f"--2026-- {old}", "ERROR 404: Not Found.", base="ubuntu:22.04")
    assert shown(text) == [f"-RUN wget -q {old}", f"+RUN wget -q {new}"]


@pytest.mark.parametrize(
    "address",
    ["https://github.com/apache/thing/archive/1.0.tar.gz", "https://archive.apache.org/dist/a/a.tgz"],
)
def test_other_addresses_that_name_apache_are_left(address: str) -> None:
    assert shown(step(f"wget -q {address}", f"--2026-- {address}", "ERROR 404: Not Found.", base="ubuntu:22.04")) == []


def test_an_address_in_a_variable_is_set_anew() -> None:
    address = "http://mirror.example.org/pub/apache/a/a.tgz"
    text = step('wget -O a.tgz "$A_URL"', f"--2026-- {address}", "ERROR 404: Not Found.", base="ubuntu:22.04")
    assert shown(text) == ["+ENV A_URL=https://archive.apache.org/dist/a/a.tgz"]


def test_an_image_of_one_processor_is_taken_for_any() -> None:
    text = step("npm install", "standard_init_linux.go:190: exec format error", base="arm32v7/node:20-slim")
    assert shown(text) == ["-FROM arm32v7/node:20-slim", "+FROM node:20-slim"]
    assert shown(text.replace("arm32v7/node", "somebody/rpi-node")) == []


def test_a_step_for_root_gives_the_user_back() -> None:
    text = step("mkdir logs", "mkdir: cannot create directory 'logs': Permission denied", base="ubuntu", user="robot")
    assert shown(text) == ["+USER root", "+USER robot"]


def test_a_user_without_a_number_gets_the_usual_one() -> None:
    text = step('useradd -u "${USER_ID}" robot', "useradd: invalid user ID ''", base="ubuntu:22.04")
    assert shown(text) == ["+ARG USER_ID=1000"]
    other = step("git clone -b ${TAG} https://example.org/a", "fatal: Remote branch  not found in upstream origin")
    assert shown(other) == []


def test_a_newer_release_of_the_same_series_is_taken() -> None:
    error = 'error a@4.0.0: The engine "node" is incompatible with this module. Expected version ">= 10.16".'
    assert shown(step("yarn install", error, base="node:10.8")) == ["-FROM node:10.8", "+FROM node:10"]


def test_a_go_is_taken_that_has_the_symbol() -> None:
    assert shown(step("go build", "a.go:3:9: undefined: errors.As", base="golang:1.11")) == [
        "-FROM golang:1.11",
        "+FROM golang:1.13",
    ]


def test_a_key_is_fetched_by_its_number() -> None:
    error = (
        "W: GPG error: https://apt.example.org stable InRelease: The following signatures couldn't be verified because "
        "the public key is not available: NO_PUBKEY 0123456789ABCDEF\n"
        "E: The repository 'https://apt.example.org stable InRelease' is not signed."
    )
    lines = shown(step("apt-get update", error, base="ubuntu:22.04"))
    assert len(lines) == 1
    assert lines[0].endswith("--recv-keys 0123456789ABCDEF")


def test_a_ros_package_is_named_as_the_images_of_ros_do() -> None:
    text = """Starting >>> robot
--- stderr: robot
CMake Error at CMakeLists.txt:10 (find_package):
  By not providing "Find{}.cmake" in CMAKE_MODULE_PATH this project has asked CMake to find it.
"""
    wanted = "RUN apt-get update && apt-get install -y --no-install-recommends ros-$ROS_DISTRO-robot-localization"
    assert shown(text.format("robot_localization")) == [f"+{wanted}"]
    assert shown(text.format("robot_that_nobody_released")) == []


def test_old_tools_are_taken_for_an_old_release() -> None:
    error = "error in arm setup command: 'extras_require' must be a dictionary"
    assert shown(step("pip3 install arm", error)) == ['+RUN pip3 install "setuptools<66" "pip<24.1" "wheel<0.40"']


def test_a_pip_that_does_not_know_the_wheels_is_renewed() -> None:
    error = (
        "No matching distribution found for torch==1.4.0\nYou are using pip version 9.0.1, however 20.0 is available."
    )
    assert shown(f"{error}\n") == ['+RUN pip install --upgrade "pip<21"']
