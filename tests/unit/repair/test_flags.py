"""What the compiler is told after an error that a flag answers, behind the flags that are there."""

from __future__ import annotations

from pathlib import Path

import pytest

from failed_builds import log, repaired
from roslab.config.addition import added
from roslab.config.reader import read

CPP = {"CMakeLists.txt": "project(robot CXX)\nadd_executable(robot main.cpp)\n", "main.cpp": "int main() {}\n"}
OPENCV = "-I/usr/local/include/opencv4 -I/usr/include/opencv4 -include"
LOADED = " ".join(
    f"-DCV_LOAD_IMAGE_{name}" for name in ("COLOR=1", "GRAYSCALE=0", "UNCHANGED=-1", "ANYDEPTH=2", "ANYCOLOR=4")
)
TWICE = "multiple definition of `{}'; {}: first defined here"
NOTE = "main.cpp:1:1: note: '{}' is defined in header '<{}>'; did you forget to '#include <a>'?"
STREAMSIZE = (
    "main.cpp:1:3: error: invalid conversion from 'std::streamsize' to 'std::ios_base::fmtflags' [-fpermissive]"
)
WARNINGS = """\
main.cpp:1:3: error: \u2018arm()\u2019 is deprecated [-Werror=deprecated-declarations]
b.c:1:3: error: unused variable \u2018b\u2019 [-Werror=unused-variable]
main.cpp:4:3: error: writing 3 bytes [-Werror=stringop-overflow=]
"""
NO_ERRORS = "-Wno-error=deprecated-declarations -Wno-error=stringop-overflow"
CSTDINT = "main.cpp:1:3: error: 'uint32_t' does not name a type"


@pytest.mark.parametrize(
    ("said", "wanted"),
    [
        (CSTDINT, "env.CXXFLAGS: -include cstdint, for what is said of uint32_t (main.cpp:1)"),
        (
            "main.cpp:1:3: error: 'numeric_limits' is not a member of 'std'",
            "env.CXXFLAGS: -include limits, for what is said of numeric_limits (main.cpp:1)",
        ),
        (
            "main.cpp:1:3: error: 'auto_ptr' is not a member of 'std'",
            "cmake_options: -DCMAKE_CXX_STANDARD=14, for what is said of auto_ptr (main.cpp:1)",
        ),
        (
            "main.cpp:1:3: error: 'optional' is not a member of 'std'",
            "cmake_options: -DCMAKE_CXX_STANDARD=17, for cxx standard too old (main.cpp:1)",
        ),
        (
            "main.cpp:1:3: error: 'make_unique' is not a member of 'std'",
            "cmake_options: -DCMAKE_CXX_STANDARD=14, for cxx standard too old (main.cpp:1)",
        ),
        (
            "main.cpp:1:3: error: 'CV_BGR2GRAY' was not declared in this scope",
            f"env.CXXFLAGS: {OPENCV} opencv2/imgproc/types_c.h, for what is said of CV_BGR2GRAY (main.cpp:1)",
        ),
        (
            "main.cpp:1:3: error: 'CV_AA' was not declared in this scope",
            f"env.CXXFLAGS: {OPENCV} opencv2/imgproc/imgproc_c.h, for what is said of CV_AA (main.cpp:1)",
        ),
        (
            "main.cpp:1:3: error: 'CV_LOAD_IMAGE_COLOR' was not declared in this scope",
            f"env.CXXFLAGS: {LOADED}, for what is said of CV_LOAD_IMAGE_COLOR (main.cpp:1)",
        ),
        ("main.cpp:1:3: error: 'CvMat' was not declared in this scope", ""),
        (
            f"{STREAMSIZE}\nmain.cpp:9:3: error: control reaches end of non-void function [-Werror=return-type]",
            "env.CXXFLAGS: -fpermissive, for what is said of std::streamsize (main.cpp:1)",
        ),
        (NOTE.format("std::vector", "vector"), "env.CXXFLAGS: -include vector, for the header vector (main.cpp:1)"),
        (NOTE.format("uint8_t", "stdint.h"), ""),  # of C, to which flags of C++ say nothing
        ("main.cpp:1:3: error: no 'a' [-fpermissive]\nmain.cpp:9:3: error: 'b' was not declared in this scope", ""),
        (
            "main.cpp:1:3: error: ISO C++17 does not allow 'register' storage class specifier [-Wregister]",
            "cmake_options: -DCMAKE_CXX_STANDARD=14, for what is said of register (main.cpp:1)",
        ),
        (
            "main.cpp:1:3: error: narrowing conversion of '-1' from 'int' to 'char' [-Wnarrowing]",
            "env.CXXFLAGS: -Wno-narrowing, for what is said of -1 (main.cpp:1)",
        ),
        (
            WARNINGS,
            f"env.CXXFLAGS: {NO_ERRORS}, for warnings are errors (main.cpp:1)",
        ),
        (
            "b.c:1:3: error: unused variable 'b' [-Werror,-Wunused-variable]",
            "env.CFLAGS: -Wno-error=unused-variable, for warnings are errors",
        ),
        ("cc1plus: all warnings being treated as errors", ""),
        (
            f"/usr/bin/ld: b.c.o:(.bss+0x0): {TWICE.format('arm', 'a.c.o:(.bss+0x0)')}",
            "env.CFLAGS: -fcommon, for what is said of arm",
        ),
        (f"/usr/bin/ld: b.cpp.o:(.bss+0x0): {TWICE.format('arm', 'libarm.a(a.cpp.o):(.bss+0x0)')}", ""),
        (f"b.o: in function `arm()': {TWICE.format('arm()', 'a.o:a.cpp:(.text+0x0)')}", ""),
    ],
)
def test_an_error_that_a_flag_answers_gets_the_flag(tmp_path: Path, said: str, wanted: str) -> None:
    found = repaired(tmp_path, log("make", *said.splitlines()), CPP)
    assert [change.told for change in found.certain.changes] == ([wanted] if wanted else [])


def test_code_for_a_newer_gazebo_is_built_for_the_next_ros(tmp_path: Path) -> None:
    files = {
        "package.xml": "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend></package>",
        "CMakeLists.txt": "project(demo)\nfind_package(catkin REQUIRED)\n",
        "README.md": "Tested with ROS Kinetic.\n",
    }
    said = "src/a.cpp:3:1: error: 'class gazebo::physics::World' has no member named 'Physics'"
    found = repaired(tmp_path, log("catkin_make", said), files)
    assert [(change.key, change.value) for change in found.certain.changes] == [("base.ros", "melodic")]
    assert read(added("format: 3\n", found.entries)).base.ros == "melodic"


@pytest.mark.parametrize(
    ("code", "flag"), [("#include <boost/function.hpp>\n", True), ("#include <functional>\n", False)]
)
def test_a_librarys_header_is_included_where_the_code_uses_the_library(
    tmp_path: Path, code: str, *, flag: bool
) -> None:
    said = "main.cpp:1:3: error: '_1' was not declared in this scope"
    found = repaired(tmp_path, log("make", said), {**CPP, "main.cpp": f"{code}int main() {{}}\n"})
    assert [change.value for change in found.certain.changes] == (["-include boost/bind.hpp"] if flag else [])


def test_a_flag_comes_behind_those_of_the_plan_and_of_roslab_yaml(tmp_path: Path) -> None:
    files = {**CPP, "main.cpp": "double most = DBL_MAX;\nint main() {}\n"}
    planned = repaired(tmp_path, log("make", CSTDINT), files)
    assert [change.value for change in planned.certain.changes] == ["-include cfloat -include cstdint"]
    text = "format: 3\nenv: {CXXFLAGS: -Wall}\n"
    own = repaired(tmp_path, log("make", CSTDINT), {"roslab.yaml": text})
    assert [change.value for change in own.certain.changes] == ["-Wall -include cstdint"]
    assert dict(read(added(text, own.entries)).env) == {"CXXFLAGS": "-Wall -include cstdint"}
    there = "format: 3\nenv: {CXXFLAGS: -include cstdint}\n"
    assert repaired(tmp_path, log("make", CSTDINT), {"roslab.yaml": there}).changes == ()


DSO = "/usr/bin/ld: {}: error adding symbols: DSO missing from command line"


@pytest.mark.parametrize(
    ("said", "wanted"),
    [
        (DSO.format("//lib/x86_64-linux-gnu/libpthread.so.0"), ["-DCMAKE_CXX_STANDARD_LIBRARIES=-Wl,-lpthread"]),
        (
            DSO.format("/usr/lib/x86_64-linux-gnu/libboost_system.so.1.71.0"),
            ["-DCMAKE_CXX_STANDARD_LIBRARIES=-Wl,-lboost_system"],
        ),
        (
            DSO.format("/opt/ros/noetic/lib/libtf.so"),
            ["-DCMAKE_CXX_STANDARD_LIBRARIES=-Wl,/opt/ros/noetic/lib/libtf.so"],
        ),
        (DSO.format("/home/jovyan/ws/devel/lib/libarm.so"), []),
        (
            "libcontrol.so: undefined reference to `LAPACKE_dgees'",
            ["-DCMAKE_CXX_STANDARD_LIBRARIES=-Wl,-llapacke", "-DCMAKE_C_STANDARD_LIBRARIES=-Wl,-llapacke"],
        ),
        (
            "main.c:(.text+0x1): undefined reference to `cbrt'",
            ["-DCMAKE_CXX_STANDARD_LIBRARIES=-Wl,-lm", "-DCMAKE_C_STANDARD_LIBRARIES=-Wl,-lm"],
        ),
        (
            "main.cpp:(.text+0x1): undefined reference to `pthread_create'",
            ["-DCMAKE_CXX_STANDARD_LIBRARIES=-Wl,-lpthread", "-DCMAKE_C_STANDARD_LIBRARIES=-Wl,-lpthread"],
        ),
        (
            "arm.so: undefined reference to `__atomic_fetch_add_8'",
            ["-DCMAKE_CXX_STANDARD_LIBRARIES=-Wl,-latomic", "-DCMAKE_C_STANDARD_LIBRARIES=-Wl,-latomic"],
        ),
        (
            "bus.c:(.text+0x1): undefined reference to `i2c_smbus_read_byte_data'",
            ["-DCMAKE_CXX_STANDARD_LIBRARIES=-Wl,-li2c", "-DCMAKE_C_STANDARD_LIBRARIES=-Wl,-li2c"],
        ),
        ("bus.cpp:(.text+0x1): undefined reference to `i2c_smbus_read_byte_data(int, unsigned char)'", []),
        ("main.cpp:(.text+0x1): undefined reference to `cv::imread(cv::String const&, int)'", []),
        ("main.cpp:(.text+0x1): undefined reference to `timer_callback'", []),
        (
            "main.cpp:(.text+0x1): undefined reference to `timer_create'",
            ["-DCMAKE_CXX_STANDARD_LIBRARIES=-Wl,-lrt", "-DCMAKE_C_STANDARD_LIBRARIES=-Wl,-lrt"],
        ),
        ("main.cpp:(.text+0x1): undefined reference to `mq_publish(int)'", []),
        ("main.cpp:(.text+0x1): undefined reference to `dlopen_plugin'", []),
    ],
)
def test_a_library_of_the_system_or_of_ros_is_linked(tmp_path: Path, said: str, wanted: list[str]) -> None:
    found = repaired(tmp_path, log("make", *said.split("\n")), CPP)
    assert [change.value for change in found.certain.changes] == wanted
    there = repaired(
        tmp_path, log("make", said), {"roslab.yaml": "format: 3\ncmake_options: -DCMAKE_CXX_STANDARD_LIBRARIES=-lm\n"}
    )
    assert there.changes == ()


def test_a_second_library_is_linked_beside_the_first(tmp_path: Path) -> None:
    first = "format: 3\ncmake_options: -DA=1 -DCMAKE_CXX_STANDARD_LIBRARIES=-Wl,-lboost_system\n"
    second = log("make", DSO.format("/usr/lib/x86_64-linux-gnu/libboost_thread.so.1.71.0"))
    found = repaired(tmp_path, second, {**CPP, "roslab.yaml": first})
    value = "-DCMAKE_CXX_STANDARD_LIBRARIES=-Wl,-lboost_system,-lboost_thread"
    assert [change.value for change in found.certain.changes] == [value]
    assert value in added(first, found.entries)
    again = log("make", DSO.format("/usr/lib/x86_64-linux-gnu/libboost_system.so.1.71.0"))
    assert repaired(tmp_path, again, {"roslab.yaml": first}).changes == ()


OLD = "cc1plus: error: unrecognized command line option '-std=c++{}'"
WITHOUT = "b.cpp:1:10: fatal error: {}: No such file or directory"


@pytest.mark.parametrize(
    ("ubuntu", "said", "wanted"),
    [
        ("xenial", OLD.format("17"), "apt: [g++-7], for cxx option unknown"),
        ("bionic", OLD.format("2a"), "apt: [g++-9], for cxx option unknown"),
        ("bionic", OLD.format("20"), "apt: [g++-11], for cxx option unknown"),
        ("bionic", OLD.format("23"), "apt: [g++-11], for cxx option unknown"),
        ("noble", OLD.format("29"), "base.ubuntu: 24.04 becomes 26.04, for cxx option unknown"),
        ("xenial", WITHOUT.format("optional"), "apt: [g++-7], for "),
        ("bionic", WITHOUT.format("filesystem"), "apt: [g++-8], for "),
        ("jammy", WITHOUT.format("format"), "apt: [g++-13], for "),
        ("jammy", WITHOUT.format("print"), "base.ubuntu: 22.04 becomes 24.04, "),
    ],
)
def test_what_the_compiler_is_too_old_for_wants_a_newer_one(
    tmp_path: Path, ubuntu: str, said: str, wanted: str
) -> None:
    files = {**CPP, "roslab.yaml": f"format: 3\nbase: {{ubuntu: {ubuntu}}}\n"}
    (found,) = repaired(tmp_path, log("make", said), files).changes
    assert found.told.startswith(wanted)
