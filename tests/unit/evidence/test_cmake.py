"""CMakeLists.txt as researchers write them."""

from __future__ import annotations

from pathlib import Path

import pytest

from hanging import ends
from roslab.evidence.cmake_project import CMakeProject
from roslab.evidence.native import cmake
from roslab.repository.checkout import Repository


def read(tmp_path: Path, text: str, **more: str) -> tuple[CMakeProject, ...]:
    for path, content in {"CMakeLists.txt": text, **more}.items():
        target = tmp_path / path
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text(content, encoding="utf-8")
    return cmake.read(Repository.open(tmp_path))


def one(tmp_path: Path, text: str) -> CMakeProject:
    (project,) = read(tmp_path, "project(demo)\n" + text)
    return project


def found(project: CMakeProject) -> list[tuple[str, str, str]]:
    return [(d.namespace, d.name, d.strength) for d in project.dependencies]


@pytest.mark.parametrize(
    "call",
    [
        "find_package(catkin REQUIRED COMPONENTS roscpp\n  cv_bridge)",
        "find_package(catkin REQUIRED roscpp cv_bridge)",
        "FIND_PACKAGE( catkin COMPONENTS roscpp cv_bridge REQUIRED )",
        "set(NEEDED roscpp cv_bridge)\nfind_package(catkin REQUIRED COMPONENTS ${NEEDED})",
        "find_package(catkin REQUIRED COMPONENTS # the usual\n roscpp #tf\n cv_bridge)",
    ],
)
def test_components_of_catkin_are_ros_packages(tmp_path: Path, call: str) -> None:
    project = one(tmp_path, call)
    assert found(project) == [("ros", "roscpp", "declared"), ("ros", "cv_bridge", "declared")]
    assert project.macros == ("catkin",)


@pytest.mark.parametrize(
    ("call", "apart"),
    [
        (
            "find_package(DART 6.8 REQUIRED COMPONENTS optimizer-nlopt utils CONFIG)",
            ["DART optimizer-nlopt", "DART utils"],
        ),
        ("find_package(Qt5 REQUIRED COMPONENTS Core SerialPort)", ["Qt5Core", "Qt5SerialPort"]),
        ("find_package(VTK REQUIRED COMPONENTS CommonCore GUISupportQt)", ["VTK GUISupportQt"]),
        ("find_package(Doxygen REQUIRED dot)", ["Doxygen dot"]),
        ("find_package(Boost REQUIRED COMPONENTS system)", []),
        ("find_package(DART REQUIRED PATHS utils)", []),
    ],
)
def test_components_with_packages_of_their_own_are_asked_for(tmp_path: Path, call: str, apart: list[str]) -> None:
    _, *others = found(one(tmp_path, call))
    assert others == [("cmake", name, "declared") for name in apart]


def test_an_optional_component_is_optional(tmp_path: Path) -> None:
    project = one(tmp_path, "find_package(DART REQUIRED COMPONENTS utils OPTIONAL_COMPONENTS utils-urdf CONFIG)")
    assert found(project)[1:] == [("cmake", "DART utils", "declared"), ("cmake", "DART utils-urdf", "optional")]


def test_a_foreach_over_a_list_is_unrolled(tmp_path: Path) -> None:
    text = "set(DEPS rclcpp tf2)\nforeach(Dependency IN ITEMS ${DEPS})\n  find_package(${Dependency} REQUIRED)\nendforeach()"  # noqa: E501
    assert found(one(tmp_path, text)) == [("cmake", "rclcpp", "declared"), ("cmake", "tf2", "declared")]


@pytest.mark.parametrize(
    ("text", "strength"),
    [
        ("find_package(Ceres REQUIRED)", "declared"),
        ("find_package(Ceres)", "used"),
        ("find_package(Ceres QUIET)", "optional"),
        ("find_package(Ceres REQUIRED QUIET)", "declared"),
        ("if(WITH_CERES)\nfind_package(Ceres REQUIRED)\nendif()", "optional"),
        ("if(NOT WIN32)\nfind_package(Ceres REQUIRED)\nendif()", "declared"),
        ("if(UNIX)\nfind_package(Ceres REQUIRED)\nendif()", "declared"),
        ("if(WIN32)\nelse()\nfind_package(Ceres REQUIRED)\nendif()", "declared"),
        ("if(APPLE)\nfind_package(Ceres REQUIRED)\nendif()", "optional"),
        ("if(A)\nendif()\nfind_package(Ceres REQUIRED)", "declared"),
        ("if(ANDROID)\nfind_package(Ceres REQUIRED)\nendif()", "optional"),
        ("if(ANDROID)\nelse()\nfind_package(Ceres REQUIRED)\nendif()", "declared"),
        ("if(ANDROID OR IOS)\nelse()\nfind_package(Ceres REQUIRED)\nendif()", "declared"),
        ("if(WIN32)\nelseif(EMSCRIPTEN)\nelse()\nfind_package(Ceres REQUIRED)\nendif()", "declared"),
        ("if(ANDROID OR WITH_A)\nelse()\nfind_package(Ceres REQUIRED)\nendif()", "optional"),
        ('if(CMAKE_SYSTEM_NAME STREQUAL "Linux")\nfind_package(Ceres REQUIRED)\nendif()', "declared"),
        ('if(${CMAKE_SYSTEM_NAME} MATCHES "Linux")\nfind_package(Ceres REQUIRED)\nendif()', "declared"),
        ('if(CMAKE_SYSTEM_NAME STREQUAL "Darwin")\nfind_package(Ceres REQUIRED)\nendif()', "optional"),
        ('if(CMAKE_SYSTEM_NAME STREQUAL "Darwin")\nelse()\nfind_package(Ceres REQUIRED)\nendif()', "declared"),
        ("if(UNIX AND NOT APPLE)\nfind_package(Ceres REQUIRED)\nendif()", "declared"),
        ("if(UNIX AND APPLE)\nfind_package(Ceres REQUIRED)\nendif()", "optional"),
    ],
)
def test_what_is_behind_a_condition_is_optional(tmp_path: Path, text: str, strength: str) -> None:
    assert found(one(tmp_path, text)) == [("cmake", "Ceres", strength)]


def test_what_is_for_tests_is_marked(tmp_path: Path) -> None:
    project = one(tmp_path, "if(BUILD_TESTING)\nfind_package(GTest REQUIRED)\nendif()")
    assert [d.role for d in project.dependencies] == ["test"]


def test_comments_and_strings_hide_calls(tmp_path: Path) -> None:
    text = '# find_package(A)\n#[[\nfind_package(B)\n]]\nmessage("find_package(C)")\nfind_package(D)\n'
    project = one(tmp_path, text)
    assert [(d.name, d.line) for d in project.dependencies] == [("D", 7)]


def test_a_binding_of_swig_links_as_a_library_does(tmp_path: Path) -> None:
    project = one(
        tmp_path, "set(LIBS zmq)\nswig_add_library(api LANGUAGE python SOURCES a.i)\nswig_link_libraries(api ${LIBS})"
    )
    assert ("link", "zmq", "used") in found(project)


def test_link_names_and_pkg_config_modules(tmp_path: Path) -> None:
    text = (
        "pkg_check_modules(YAML REQUIRED yaml-cpp>=0.5)\nadd_library(mine a.cpp)\nadd_executable(node b.cpp)\n"
        "target_link_libraries(node PRIVATE mine zmq -lnlopt ${catkin_LIBRARIES} Foo::Bar)"
    )
    assert found(one(tmp_path, text)) == [
        ("pkg-config", "yaml-cpp", "declared"),
        ("link", "zmq", "used"),
        ("link", "nlopt", "used"),
    ]


def test_what_is_fetched_while_configuring(tmp_path: Path) -> None:
    text = "FetchContent_Declare(fmt GIT_REPOSITORY https://github.com/fmtlib/fmt.git GIT_TAG 9.1.0)"
    (source,) = one(tmp_path, text).sources
    assert (source.name, source.ref, source.kind) == ("fmt", "9.1.0", "fetch")


@pytest.mark.parametrize(
    ("include", "module", "strength"),
    [
        ("include(cmake/Needs.cmake)", "cmake/Needs.cmake", "declared"),
        ("include(Needs)", "cmake/Needs.cmake", "declared"),
        ("include(${CMAKE_CURRENT_SOURCE_DIR}/cmake/Needs.cmake)", "cmake/Needs.cmake", "declared"),
        ("include(cmake/All.cmake)", "cmake/Needs.cmake", "declared"),
        ("if(WITH_MAPS)\ninclude(cmake/Needs.cmake)\nendif()", "cmake/Needs.cmake", "optional"),
        ("include(${SOMEWHERE}/Needs.cmake)", "cmake/Needs.cmake", ""),
        ("include(Needs)", "third_party/lib/Needs.cmake", ""),
        ("include(FindNeeds)", "cmake/FindNeeds.cmake", "declared"),
        ("include(FindPackageNeeds)", "cmake/FindPackageNeeds.cmake", ""),
        ("message(Needs)", "cmake/Needs.cmake", ""),
    ],
)
def test_what_an_included_file_looks_for(tmp_path: Path, include: str, module: str, strength: str) -> None:
    text = "macro(later)\nfind_package(Later REQUIRED)\nendmacro()\nfind_package(Acme 2.1 REQUIRED)\n"
    more = {
        module: text,
        "cmake/All.cmake": "include(${CMAKE_CURRENT_LIST_DIR}/Needs.cmake)\ninclude(cmake/All.cmake)\n",
    }
    (project,) = read(tmp_path, f"project(demo)\n{include}\n", **more)
    assert found(project) == ([("cmake", "Acme", strength)] if strength else [])
    assert all((d.file, d.line, d.version) == (module, 4, "2.1") for d in project.dependencies)


def test_the_project_of_an_option_that_is_on_names_its_program(tmp_path: Path) -> None:
    text = "".join(
        f'option(FOR_{name} "" {on})\nif(FOR_{name})\n  project({name.lower()}-slam)\nendif()\n'
        for name, on in (("CAR", "OFF"), ("DRONE", "ON"), ("DATA", "OFF"))
    )
    (project,) = read(tmp_path, f"{text}add_executable(${{PROJECT_NAME}} src/${{PROJECT_NAME}}.cpp)\n")
    assert (project.name, [name for name, _ in project.executables]) == ("drone-slam", ["drone-slam"])


def test_added_folders_are_not_top_level(tmp_path: Path) -> None:
    projects = read(tmp_path, "project(a CXX CUDA)\nadd_subdirectory(lib)", **{"lib/CMakeLists.txt": "project(b)"})
    assert [(p.name, p.top_level) for p in projects] == [("a", True), ("b", False)]
    assert projects[0].macros == ("cuda",)


def test_folders_of_the_older_command_are_added(tmp_path: Path) -> None:
    folders = {f"{name}/CMakeLists.txt": "add_executable(x x.cpp)\n" for name in ("one", "two", "three")}
    projects = read(tmp_path, "project(a)\nSUBDIRS(one PREORDER two)\n", **folders)
    assert {each.file: each.always for each in projects if each.executables} == {
        "one/CMakeLists.txt": True,
        "two/CMakeLists.txt": True,
        "three/CMakeLists.txt": False,
    }


@pytest.mark.parametrize(
    "text",
    [
        "find_package(" * 100_000,
        'find_package("a\n' * 100_000,
        "if(A)\n" * 50_000 + "find_package(B)\n" * 10_000,
        "set(A0 x x)\n" + "".join(f"set(A{i} ${{A{i - 1}}} ${{A{i - 1}}})\nset(B{i} \"${{A{i}}}${{B{i - 1}}}${{B{i - 1}}}\")\n" for i in range(1, 500)),  # noqa: E501
        "find_package(Foo REQUIRED)\n" * 80_000,
    ],
    ids=["never-closed", "unbalanced-quotes", "deep-conditions", "doubling-variables", "very-long"],
)  # fmt: skip
def test_hostile_files_end_soon(tmp_path: Path, text: str) -> None:
    with ends():
        read(tmp_path, "project(demo)\n" + text)
