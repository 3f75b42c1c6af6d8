"""What only x86 has rules out ARM, or is left out for it where it only tunes."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision
from roslab.decide.platforms import AMD64, ARM64

Tree = Callable[[dict[str, str]], Decision]
MAIN = {"a.cpp": "int main() {}\n"}
SSE = "#include <xmmintrin.h>\nint main() { _mm_pause(); }\n"


def cmake(*lines: str) -> dict[str, str]:
    return {"CMakeLists.txt": "\n".join(["project(demo CXX)", *lines, "add_executable(a a.cpp)", ""])}


@pytest.mark.parametrize(
    "line",
    [
        "add_definitions(-msse -msse4.2)",
        'set(CMAKE_CXX_FLAGS "${CMAKE_CXX_FLAGS} -mavx2 -mfma")',
        "add_compile_options(-march=haswell)",
        'set(SSE_FLAGS "-mssse3")\nset(CMAKE_CXX_FLAGS "${CMAKE_CXX_FLAGS} ${SSE_FLAGS}")',
        "if(CMAKE_HOST_UNIX)\nadd_compile_options(-march=core2)\nendif()",
        "if(CMAKE_COMPILER_IS_GNUCXX AND NOT WIN32)\nadd_compile_options(-msse3)\nendif()",
        "option(USE_SSE ON)\nif(USE_SSE)\nelse()\nendif()\nadd_compile_options(-m64)",
        "if(TUNED_BY_HAND)\nelse()\nadd_compile_options(-msse4a)\nendif()",
        'if(CMAKE_SYSTEM_PROCESSOR MATCHES "armv7")\nelse()\nadd_compile_options(-mavx)\nendif()',
        'option(NO_TUNING "as (in images) for all" OFF)\nif(NOT NO_TUNING)\nadd_compile_options(-mavx2)\nendif()',
        'option(NO_TUNING "for all")\nif(NOT NO_TUNING)\nadd_compile_options(-mavx2)\nendif()',
        "if(DEFINED ENV{ARM_ARCHITECTURE})\nelse()\nadd_compile_options(-mavx)\nendif()",
    ],
)
def test_an_option_that_only_tunes_is_left_out_for_arm(tree: Tree, line: str) -> None:
    decision = tree(cmake(line) | MAIN)
    assert decision.platforms == (AMD64, ARM64)
    assert decision.without
    assert all(word in line for word in decision.without)
    told = [w for w in decision.warnings if "only x86" in w.message]
    assert [w.file for w in told] == ["CMakeLists.txt"]
    assert line.splitlines()[(told[0].line or 0) - 2].count("-m")


@pytest.mark.parametrize(
    "line",
    [
        'if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86|AMD64")\nadd_compile_options(-msse4.2)\nendif()',
        "if(CMAKE_SYSTEM_PROCESSOR STREQUAL aarch64)\nelse()\nadd_compile_options(-msse4.2)\nendif()",
        'check_cxx_compiler_flag("-mavx2" HAS_AVX2)\nif(HAS_AVX2)\nadd_compile_options(-mavx2)\nendif()',
        'option(USE_SSE "with SSE" OFF)\nif(USE_SSE)\nadd_compile_options(-msse)\nendif()',
        'option(NO_TUNING "for all" ON)\nif(NOT NO_TUNING)\nadd_compile_options(-mavx2)\nendif()',
        'option(X "x" OFF)\ncheck_it(X)\nif(NOT X)\nadd_compile_options(-mavx2)\nendif()',
        "if(MSVC)\nadd_compile_options(-mavx)\nendif()",
        "if(CMAKE_HOST_APPLE)\nadd_compile_options(-march=core2)\nendif()",
        "if(TUNED_BY_HAND)\nadd_compile_options(-msse)\nendif()",
        'set(SSE_FLAGS "-msse")\nif(FOUND_SSE)\nadd_compile_options(${SSE_FLAGS})\nendif()\ncheck_sse(FOUND_SSE)',
        'check_it(HAS_IT)\nif(HAS_IT)\nset(MORE "-msse")\nendif()\nset(CMAKE_CXX_FLAGS "${CMAKE_CXX_FLAGS} ${MORE}")',
        "# add_compile_options(-msse)",
        "add_compile_options(-mno-outline-atomics -Wall)",
        "function(tune name)\ntarget_compile_options(${name} PRIVATE -mavx)\nendfunction()",
    ],
)
def test_an_option_of_a_branch_for_x86_is_none_for_arm(tree: Tree, line: str) -> None:
    decision = tree(cmake(line) | MAIN)
    assert decision.platforms == (AMD64, ARM64)
    assert not decision.without
    assert not [w for w in decision.warnings if "only x86" in w.message]


@pytest.mark.parametrize(
    ("code", "line"),
    [
        (SSE, 1),
        (f"#ifndef _WIN32\n{SSE}#endif\n", 2),
        (f"#ifdef _MSC_VER\n#include <intrin.h>\n#else\n{SSE}#endif\n", 4),
        (f"#if defined(__GNUC__) && !defined(__APPLE__)\n{SSE}#endif\n", 2),
        (f"#ifdef WITH_SSE\n{SSE}#endif\n", 2),
    ],
)
def test_a_header_of_x86_rules_arm_out_with_its_place(tree: Tree, code: str, line: int) -> None:
    decision = tree(cmake("add_definitions(-msse -DWITH_SSE)") | {"a.cpp": code})
    assert decision.platforms == (AMD64,)
    assert not decision.without
    assert "xmmintrin.h" in dict(decision.platforms_refused)[ARM64]
    assert [(r.file, r.line) for r in decision.reasons if r.question == "platforms"] == [("a.cpp", line)]


@pytest.mark.parametrize(
    "code",
    [
        f"#ifdef __SSE2__\n{SSE}#endif\n",
        f"#if defined(__x86_64__) || defined(_M_X64)\n{SSE}#endif\n",
        f'#ifdef __aarch64__\n#include "sse2neon.h"\n#else\n{SSE}#endif\n',
        f"#ifdef _WIN32\n{SSE}#endif\n",
        f"#if __has_include(<xmmintrin.h>)\n{SSE}#endif\n",
        f"#ifdef WITH_SSE\n{SSE}#endif\n",
        f"// {SSE}",
    ],
)
def test_a_header_behind_a_condition_rules_nothing_out(tree: Tree, code: str) -> None:
    assert tree(cmake() | {"a.cpp": code}).platforms == (AMD64, ARM64)


def test_a_header_that_nothing_includes_or_that_a_test_has_rules_nothing_out(tree: Tree) -> None:
    assert tree(cmake() | MAIN | {"unused.h": SSE, "test/b.cpp": SSE}).platforms == (AMD64, ARM64)
    assert tree(cmake() | {"a.cpp": '#include "unused.h"\n', "unused.h": SSE}).platforms == (AMD64,)


def test_copied_code_counts_where_options_are_passed(tree: Tree) -> None:
    copied = {"thirdparty/fast/fast.cpp": SSE}
    assert tree(cmake("add_compile_options(-msse)") | MAIN | copied).platforms == (AMD64,)


@pytest.mark.parametrize(
    ("flags", "platforms"),
    [
        ("-mavx2", (AMD64,)),
        ("-mno-avx2", (AMD64,)),
        ("$(if $(filter x86_64,$(shell uname -m)),-mavx2)", (AMD64, ARM64)),
        ("-O2", (AMD64, ARM64)),
    ],
)
def test_what_make_compiles_is_not_changed(tree: Tree, flags: str, platforms: tuple[str, ...]) -> None:
    made = f"FLAGS = {flags}\na: a.cpp\n\tg++ $(FLAGS) -o a a.cpp\n"
    assert tree({"Makefile": made, "a.cpp": "#include <Eigen/Dense>\nint main() {}\n"}).platforms == platforms


def test_an_extension_of_python_with_such_an_option(tree: Tree) -> None:
    setup = (
        "from setuptools import setup, Extension\n"
        "setup(name='demo', ext_modules=[Extension('demo', ['a.cpp'], extra_compile_args=['-mavx2'])])\n"
    )
    decision = tree({"setup.py": setup, "a.cpp": "int main() {}\n", "demo.py": "print(1)\n"})
    assert decision.platforms == (AMD64,)
    assert "-mavx2" in dict(decision.platforms_refused)[ARM64]


def test_only_packages_that_are_built_count(tree: Tree) -> None:
    manifest = "<package><name>{}</name><buildtool_depend>catkin</buildtool_depend></package>"
    lists = "project({})\nfind_package(catkin REQUIRED)\ncatkin_package()\n"
    files = {
        "core/package.xml": manifest.format("core"),
        "core/CMakeLists.txt": lists.format("core"),
        "old/package.xml": manifest.format("old"),
        "old/CMakeLists.txt": lists.format("old") + "add_compile_options(-msse)\n",
        "old/a.cpp": SSE,
    }
    assert tree(files).platforms == (AMD64,)
    assert tree(files | {"old/CATKIN_IGNORE": ""}).platforms == (AMD64, ARM64)


SDK = "https://example.org/sdk-1.2-linux-x86_64-gcc.tar.gz"
LINKED = "target_link_libraries(a ${PROJECT_SOURCE_DIR}/lib/lin-x86_64/libsdk.so)"


@pytest.mark.parametrize(
    ("line", "only"),
    [
        (f"FetchContent_Declare(sdk URL {SDK})", True),
        (f"file(DOWNLOAD {SDK} sdk.tar.gz)", True),
        (f'set(URL "{SDK}")\nExternalProject_Add(sdk URL ${{URL}})', True),
        (LINKED, True),
        ("link_directories(lib/lin-x86_64)\nadd_executable(a a.cpp)\ntarget_link_libraries(a sdk)", True),
        (f"# FetchContent_Declare(sdk URL {SDK})", False),
        ("link_directories(/usr/lib/x86_64-linux-gnu)", False),  # apt's
        ("target_link_libraries(a other/x86_64/libsdk.so)", False),  # the tree has no such library
        (f"if(CMAKE_SYSTEM_PROCESSOR MATCHES x86_64)\n{LINKED}\nendif()", False),
        (f"if(WIN32)\n{LINKED}\nendif()", False),
        (f'option(SDK "with it" OFF)\nif(SDK)\n{LINKED}\nendif()', False),
        (f"FetchContent_Declare(sdk URL {SDK.replace('x86_64', 'noarch')})", False),
    ],
)
def test_libraries_for_amd64_rule_out_arm(tree: Tree, line: str, only: bool) -> None:
    found = tree(cmake(line) | MAIN | {"lib/lin-x86_64/libsdk.so": "binary"})
    assert found.platforms == ((AMD64,) if only else (AMD64, ARM64))


def test_a_library_that_lies_beside_that_of_arm_is_chosen(tree: Tree) -> None:
    line = "set(ARCH x86_64)\nif(ON_BOARD)\nset(ARCH aarch64)\nendif()\ntarget_link_libraries(a lib/x86_64/libsdk.so)"
    assert tree(cmake(line) | MAIN | {"lib/x86_64/libsdk.so": "binary"}).platforms == (AMD64, ARM64)


def test_a_cloned_vendor_package_may_be_for_amd64_alone(tree: Tree) -> None:
    lists = (
        "repositories:\n  sdk:\n    type: git\n    url: https://github.com/ICube-Robotics/{}.git\n    version: main\n"
    )
    package = '<package format="3"><name>demo</name><export><build_type>ament_cmake</build_type></export></package>'
    files = {"package.xml": package, "CMakeLists.txt": "project(demo)\nfind_package(ament_cmake REQUIRED)\n"}
    assert tree({**files, "demo.repos": lists.format("fd_sdk_vendor")}).platforms == (AMD64,)
    assert tree({**files, "demo.repos": lists.format("others")}).platforms == (AMD64, ARM64)


COPY = "configure_file(${{CMAKE_CURRENT_SOURCE_DIR}}/sdk/libCamx64.so ${{CMAKE_CURRENT_BINARY_DIR}}/libCam.so {how})"
X86_64 = "\x7fELF\x02\x01\x01" + "\0" * 9 + "\x03\0\x3e\0"


@pytest.mark.parametrize(
    ("lines", "platforms"),
    [
        (f"{COPY.format(how='COPYONLY')}\ntarget_link_libraries(demo Cam)", (AMD64,)),
        (f"{COPY.format(how='COPYONLY')}\ntarget_link_libraries(demo Other)", (AMD64, ARM64)),  # a plugin
        (f"if(WIN32)\n{COPY.format(how='COPYONLY')}\nendif()\ntarget_link_libraries(demo Cam)", (AMD64, ARM64)),
    ],
)
def test_a_library_that_is_copied_to_be_linked_rules_out_arm(
    tree: Tree, lines: str, platforms: tuple[str, ...]
) -> None:
    assert tree(cmake(lines) | MAIN | {"sdk/libCamx64.so": X86_64}).platforms == platforms


ARM = X86_64.replace("\x3e", "\xb7")
FOUND = "find_library(SOLVER_LIBRARY {} NO_DEFAULT_PATH)\n"
HERE = FOUND.format('solver PATHS "${PROJECT_SOURCE_DIR}/copied/lib"')


@pytest.mark.parametrize(
    ("lines", "more", "platforms"),
    [
        (f"{HERE}target_link_libraries(a ${{SOLVER_LIBRARY}})", {}, (AMD64,)),
        (HERE, {}, (AMD64, ARM64)),  # nothing links it
        (f"if(WIN32)\n{HERE}endif()\ntarget_link_libraries(a ${{SOLVER_LIBRARY}})", {}, (AMD64, ARM64)),
        (
            "find_library(FOUND dl PATHS copied/lib)\ntarget_link_libraries(a ${FOUND})",
            {},
            (AMD64, ARM64),
        ),  # the system's
        ("link_directories(copied/lib)\nadd_executable(b a.cpp)\ntarget_link_libraries(b solver)", {}, (AMD64,)),
        ("link_directories(copied/lib)\nadd_executable(b a.cpp)\ntarget_link_libraries(b dl)", {}, (AMD64, ARM64)),
        ("find_package(Solver REQUIRED)", {"cmake/FindSolver.cmake": HERE}, (AMD64,)),
        ("", {"cmake/FindSolver.cmake": HERE}, (AMD64, ARM64)),  # nothing asks for it
    ],
)
def test_a_library_of_the_tree_that_cmake_finds_by_its_name_rules_out_arm(
    tree: Tree, lines: str, more: dict[str, str], platforms: tuple[str, ...]
) -> None:
    files = {"copied/lib/libsolver.so": X86_64, "copied/lib/libdl.so": ARM}
    assert tree(cmake(lines) | MAIN | files | more).platforms == platforms


@pytest.mark.parametrize(("manifest", "platforms"), [(True, (AMD64,)), (False, (AMD64, ARM64))])
def test_a_package_in_a_folder_of_copied_code_is_built_as_the_others(
    tree: Tree, *, manifest: bool, platforms: tuple[str, ...]
) -> None:
    package = '<package format="3"><name>{}</name><export><build_type>ament_cmake</build_type></export></package>'
    lists = "project(demo)\nfind_package(ament_cmake REQUIRED)\nadd_library(demo a.cpp)\n"
    link = "set(SDK ${CMAKE_CURRENT_SOURCE_DIR}/sdk/libsdk.so)\ntarget_link_libraries(demo ${SDK})\n"
    files = {"src/own/package.xml": package.format("own"), "src/own/CMakeLists.txt": lists}
    files |= {"src/third_party/driver/CMakeLists.txt": lists + link, "src/third_party/driver/sdk/libsdk.so": X86_64}
    files |= {"src/third_party/driver/package.xml": package.format("demo")} if manifest else {}
    assert tree(files).platforms == platforms


NAME = '#define LIBRARY "libArm.so"\n'
OPENS = "void open() { dlopen(LIBRARY, RTLD_NOW); }\n"


@pytest.mark.parametrize(
    ("files", "platforms"),
    [
        ({"a.h": NAME, "b.cpp": OPENS, "lib/libArm.so": X86_64}, (AMD64,)),
        ({"a.h": NAME, "lib/libArm.so": X86_64}, (AMD64, ARM64)),  # nothing opens one
        ({"a.h": NAME.replace("Arm", "c"), "b.cpp": OPENS, "lib/libArm.so": X86_64}, (AMD64, ARM64)),
        ({"a.h": f"#ifdef __aarch64__\n{NAME}#endif\n", "b.cpp": OPENS, "lib/libArm.so": X86_64}, (AMD64, ARM64)),
        ({"a.h": NAME, "b.cpp": OPENS, "x64/libArm.so": X86_64, "arm/libArm.so": ARM}, (AMD64, ARM64)),
    ],
)
def test_a_library_of_the_tree_that_code_opens_rules_out_arm(
    tree: Tree, files: dict[str, str], platforms: tuple[str, ...]
) -> None:
    assert tree(cmake("") | MAIN | files).platforms == platforms


CDLL = "import ctypes, os\nlib = ctypes.CDLL(os.path.join('lib', 'libArm.so'))\n"


@pytest.mark.parametrize(
    ("files", "platforms"),
    [
        ({"arm.py": CDLL, "lib/libArm.so": X86_64}, (AMD64,)),
        ({"arm.py": "from ctypes import cdll\ncdll.LoadLibrary('./libArm.so')\n", "libArm.so": X86_64}, (AMD64,)),
        ({"arm.py": CDLL, "lib/libArm.so": ARM}, (AMD64, ARM64)),
        ({"arm.py": CDLL, "x64/libArm.so": X86_64, "arm/libArm.so": ARM}, (AMD64, ARM64)),
        ({"arm.py": f"import platform\nplatform.machine()\n{CDLL}", "lib/libArm.so": X86_64}, (AMD64, ARM64)),
        ({"arm.py": "import ctypes\nNAME = 'libArm.so'\n", "lib/libArm.so": X86_64}, (AMD64, ARM64)),
        ({"arm.py": CDLL, "lib/libArm.so": X86_64, "lib/Makefile": "libArm.so: a.c\n\tgcc -shared\n"}, (AMD64, ARM64)),
    ],
)
def test_a_library_of_the_tree_that_python_opens_rules_out_arm(
    tree: Tree, files: dict[str, str], platforms: tuple[str, ...]
) -> None:
    assert tree({"requirements.txt": "numpy\n", "run.py": "import numpy\n"} | files).platforms == platforms


FLAG = "-march=native compiles for the processor of the machine"
MAKE = "CXX = g++\nall:\n\t$(CXX) -march=native -o slam main.cpp\n"
CMAKE = "cmake_minimum_required(VERSION 3.10)\nproject(demo CXX)\nadd_executable(demo main.cpp)\n"
OTHER = f"{CMAKE.replace('demo', 'other')}add_compile_options(-march=native)\n"


@pytest.mark.parametrize(
    ("files", "compiled"),
    [
        ({"Makefile": MAKE}, True),
        ({"Makefile": "all:\n\tmake -C lib\n", "lib/Makefile": MAKE, "lib/main.cpp": "int main() {}\n"}, True),
        ({"Makefile": MAKE, "requirements.txt": "numpy\n", "a.py": "import numpy\n", "b.py": ""}, False),
        ({"CMakeLists.txt": f"{CMAKE}add_compile_options(-march=native)\n"}, True),
        ({"CMakeLists.txt": f"{CMAKE}add_subdirectory(other)\n", "other/CMakeLists.txt": OTHER}, True),
        ({"CMakeLists.txt": CMAKE, "tools/other/CMakeLists.txt": OTHER}, False),
    ],
)
def test_what_the_build_does_about_it_is_said_where_it_is_compiled(
    tree: Callable[[dict[str, str]], Decision], files: dict[str, str], *, compiled: bool
) -> None:
    found = tree({"main.cpp": "int main() {}\n", **files})
    (said,) = [each.message for each in found.warnings if each.message.startswith(FLAG)]
    assert ("in its place" in said) is compiled
    assert ("the image does not compile it" in said) is not compiled


def test_the_first_that_is_compiled_is_told(tree: Callable[[dict[str, str]], Decision]) -> None:
    top = f"{CMAKE}add_subdirectory(deep/er)\n"
    files = {"CMakeLists.txt": top, "main.cpp": "int main() {}\n", "a/CMakeLists.txt": OTHER}
    found = tree({**files, "deep/er/CMakeLists.txt": "add_compile_options(-march=native)\n"})
    assert [each.file for each in found.warnings if each.message.startswith(FLAG)] == ["deep/er/CMakeLists.txt"]


CPUID = "#include <cpuid.h>\nint main() { unsigned a; __get_cpuid(0, &a, &a, &a, &a); }\n"


@pytest.mark.parametrize(
    ("code", "more", "refused"),
    [
        (CPUID, {}, True),
        ("#if defined(__x86_64__)\n#include <cpuid.h>\n#endif\nint main() {}\n", {}, False),
        (CPUID.replace("<cpuid.h>", '"cpuid.h"'), {"cpuid.h": "#pragma once\n"}, False),
    ],
    ids=["always", "guarded", "its own"],
)
def test_the_header_of_an_instruction_of_x86_rules_out_arm(
    tree: Tree, code: str, more: dict[str, str], *, refused: bool
) -> None:
    decision = tree(cmake() | {"a.cpp": code} | more)
    assert (decision.platforms == (AMD64,)) is refused
    if refused:
        assert "includes cpuid.h" in dict(decision.platforms_refused)[ARM64]
