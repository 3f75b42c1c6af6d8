"""Compiled files of the tree name the libraries that they are linked with."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.evidence.native import shared_objects
from roslab.knowledge.code_limits import version_of
from roslab.knowledge.shared_objects import package_of
from roslab.knowledge.table import rows
from roslab.pipeline import plan_repository
from roslab.repository.checkout import Repository


def compiled(*needed: str, machine: int = 0x3E, magic: bytes = b"\x7fELF") -> bytes:
    """Return as much of such a file as is read: its kind, its machine and the names."""
    names = b"".join(name.encode() + b"\0" for name in needed)
    return magic + bytes(14) + bytes([machine, 0]) + bytes(44) + b"\0" + names


@pytest.mark.parametrize(
    ("soname", "apt"),
    [
        ("libGLEW.so.2.0", "libglew2.0"),
        ("libdc1394.so.22", "libdc1394-22"),
        ("libavcodec.so.57", "libavcodec57"),
        ("libGL.so.1", "libgl1"),
        ("libpython3.8.so.1.0", "libpython3.8"),
        ("libpython3.6m.so.1.0", None),
        ("libstdc++.so.6", None),
        ("libcudart.so.11.0", None),
        ("libm.so.6", None),
        ("libown.so", None),
    ],
)
def test_the_package_of_a_library(soname: str, apt: str | None) -> None:
    assert package_of(soname) == apt


def test_what_compiled_files_of_the_tree_need(tmp_path: Path) -> None:
    files = {
        "lib/linux/slam.cpython-36m-x86_64-linux-gnu.so": compiled("libc.so.6", "libGLEW.so.2.0", "libown.so.1"),
        "lib/libown.so.1": compiled("libcholmod.so.3", machine=0xB7),
        "lib/macosx/slam.so": compiled("libother.so.1", magic=b"\xcf\xfa\xed\xfe"),
        "lib/arm/old.so": compiled("libother.so.1", machine=0x28),
        "lib/kept.so": b"version https://git-lfs.github.com/spec/v1\n",
        "tests/a.so": compiled("libother.so.1"),
    }
    for path, data in files.items():
        (tmp_path / path).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / path).write_bytes(data)
    found = shared_objects.read(Repository.open(tmp_path))
    assert {each.name: each.file.rpartition("/")[2] for each in found} == {
        "libcholmod3": "libown.so.1",
        "libglew2.0": "slam.cpython-36m-x86_64-linux-gnu.so",
    }


def test_it_is_installed_where_the_base_knows_it(tmp_path: Path) -> None:
    (tmp_path / "slam.so").write_bytes(compiled("libGLEW.so.2.0"))
    (tmp_path / "slam.py").write_text("import numpy\nimport slam\n")
    (tmp_path / "requirements.txt").write_text("numpy\n")
    assert "libglew2.0" in plan_repository(tmp_path).plan.apt_guessed


CV, BOOST, GLEW = "libopencv_core.so.3.2", "libboost_system.so.1.65.1", "libGLEW.so.2.0"


@pytest.mark.parametrize(
    ("files", "ubuntu"),
    [
        ({"lib/liba.so": (CV, BOOST, GLEW)}, ["bionic"]),
        ({"lib/liba.so": (CV, "libopencv_ml.so.3.2"), "lib/libb.so": (BOOST,)}, ["bionic"]),
        ({"lib/liba.so": ("libopencv_core.so.2.4", "libboost_system.so.1.58.0")}, ["xenial"]),
        ({"lib/liba.so": (CV, "libopencv_ml.so.3.2")}, []),  # it may be built from source
        ({"lib/liba.so": (CV, "libboost_system.so.1.58.0")}, []),
        ({"lib/liba.so": (CV, BOOST), "lib/libb.so": ("libboost_system.so.1.71.0",)}, []),
        ({"lib/liba.so": ("libc.so.6", "libm.so.6")}, []),
        ({"lib/liba.so": (CV, BOOST), "lib/libboost_system.so.1.65.1": ()}, []),
    ],
)
def test_the_ubuntu_that_compiled_files_were_made_on(
    tmp_path: Path, files: dict[str, tuple[str, ...]], ubuntu: list[str]
) -> None:
    (tmp_path / "lib").mkdir()
    for path, needed in files.items():
        (tmp_path / path).write_bytes(compiled(*needed))
    assert [each.value for each in shared_objects.made_on(Repository.open(tmp_path))] == ubuntu


@pytest.mark.parametrize(("page", "ubuntu"), [("Compile it.", "bionic"), ("Tested on Ubuntu 20.04.", "focal")])
def test_what_a_page_says_outweighs_it(tmp_path: Path, page: str, ubuntu: str) -> None:
    (tmp_path / "CMakeLists.txt").write_text("cmake_minimum_required(VERSION 3.5)\nproject(demo)\n")
    (tmp_path / "README.md").write_text(f"{page}\n")
    (tmp_path / "libdemo.so").write_bytes(compiled(CV, BOOST))
    assert plan_repository(tmp_path).decision.ubuntu == ubuntu


@pytest.mark.parametrize(("library", "begins"), [("OpenCV", "libopencv_"), ("Boost", "libboost_"), ("PCL", "libpcl_")])
def test_the_names_agree_with_the_versions_of_the_libraries(library: str, begins: str) -> None:
    for row in (each for each in rows("soname_ubuntus") if each["begins"] == begins):
        for ubuntu in row["ubuntus"].split():
            assert f"{version_of(library, ubuntu)}.".startswith(f"{row['version']}.")


@pytest.mark.parametrize(
    ("line", "machine", "distro", "platforms"),
    [
        ("set_target_properties(a PROPERTIES IMPORTED_LOCATION ${PROJECT_SOURCE_DIR}/lib/a.so)", 0x3E, "melodic", 1),
        ("target_link_libraries(demo ${CMAKE_CURRENT_SOURCE_DIR}/lib/a.so)", 0x3E, "melodic", 1),
        ("target_link_libraries(demo ${CMAKE_CURRENT_SOURCE_DIR}/lib/a.so)", 0xB7, "noetic", 2),
        ("target_link_libraries(demo ${CMAKE_CURRENT_SOURCE_DIR}/lib/a.a)", 0x3E, "noetic", 1),
        ("install(FILES lib/a.so DESTINATION lib)", 0x3E, "noetic", 2),
    ],
)
def test_a_library_that_is_linked_rules_out_processors_and_ubuntus(
    tmp_path: Path, line: str, machine: int, distro: str, platforms: int
) -> None:
    (tmp_path / "package.xml").write_text(
        "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend></package>"
    )
    (tmp_path / "CMakeLists.txt").write_text(
        f"project(demo)\nfind_package(catkin REQUIRED)\nadd_library(demo a.cpp)\n{line}\n"
    )
    (tmp_path / "a.cpp").write_text("int a;\n")
    (tmp_path / "lib").mkdir()
    data = compiled("libc.so.6", "libgfortran.so.3", machine=machine)
    (tmp_path / "lib/a.so").write_bytes(data)
    (tmp_path / "lib/a.a").write_bytes(b"!<arch>\n" + bytes(60) + data)
    decision = plan_repository(tmp_path).decision
    assert (decision.ros_distro, len(decision.platforms)) == (distro, platforms)


def test_what_was_built_elsewhere_asks_for_nothing_but_tells_the_ubuntu(tmp_path: Path) -> None:
    for path, needed in {"devel/lib/liba.so": (CV, BOOST), "lib/libb.so": ("libGLEW.so.2.0",)}.items():
        (tmp_path / path).parent.mkdir(parents=True)
        (tmp_path / path).write_bytes(compiled(*needed))
    repository = Repository.open(tmp_path)
    assert len(shared_objects.read(repository)) == 3
    (tmp_path / "devel/.built_by").write_text("catkin_make\n")
    repository = Repository.open(tmp_path)
    assert [each.name for each in shared_objects.read(repository)] == ["libglew2.0"]
    assert [each.value for each in shared_objects.made_on(repository)] == ["bionic"]
