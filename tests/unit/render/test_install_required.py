"""What a library that nobody has read requires by its own CMakeLists.txt is installed before CMake configures it."""

from __future__ import annotations

import os
import subprocess
from pathlib import Path

import pytest

from roslab.knowledge.libraries import cmake_packages
from roslab.knowledge.library_names import library_names
from roslab.pipeline import plan_repository
from roslab.render import image_scripts
from roslab.render.dockerfile import dockerfile

pytestmark = pytest.mark.usefixtures("scripts_on_path")
SCRIPT = Path(image_scripts.__path__[0]) / "install-required.sh"


def required(folder: Path, files: dict[str, str], *options: str) -> list[str]:
    """Return the names that are required of a library of these files, with options of CMake."""
    for name, text in files.items():
        (folder / "lib" / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / "lib" / name).write_text(text)
    command = ["required-by-cmake", "--library", str(folder / "lib"), *options]
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout.split()


@pytest.mark.parametrize(
    ("cmake", "names"),
    [
        ("find_package(VISP REQUIRED)\nfind_package(Ceres 1.14 REQUIRED)\nfind_package(Qt5)", ["Ceres", "VISP"]),
        ("project(VISP)\nfind_package(VISP REQUIRED)", []),
        ("find_package(gsl CONFIG)\ninclude_directories(x ${gsl_INCLUDE_DIRS})", ["gsl"]),
        ("find_package(gsl)\ntarget_link_libraries(x PUBLIC ${GSL_LIBRARIES})", ["gsl"]),
        ("find_package(GSL)\ntarget_link_libraries(x GSL::gsl)", ["GSL"]),
        ("find_package(GSL)\nif(GSL_FOUND)\ntarget_link_libraries(x GSL::gsl)\nendif()", []),
        ("if(A)\nfind_package(GSL)\nendif()\ntarget_link_libraries(x ${GSL_LIBRARIES})", []),
        ("find_package(GSL QUIET)\ntarget_link_libraries(x ${GSL_LIBRARIES})", []),
        ("find_package(GSL)\nif(NOT GSL_FOUND)\nmessage(FATAL_ERROR no)\nendif()", ["GSL"]),
        ("find_package(Gsl)\nif(NOT GSL_FOUND)\nmessage(FATAL_ERROR no)\nendif()", ["Gsl"]),
        ("find_package(GSL)\nif(NOT GSL_FOUND)\nmessage(WARNING no)\nendif()", []),
        ("find_package(GSL)\nif(NOT GSL_FOUND)\nelse()\nmessage(FATAL_ERROR no)\nendif()", []),
        ("pkg_check_modules(A REQUIRED IMPORTED_TARGET fmt>=3 eigen3 >= 3.2)", ["pkg:eigen3", "pkg:fmt"]),
        ("pkg_check_modules(A fmt)\nif(NOT A_FOUND)\nmessage(FATAL_ERROR no)\nendif()", ["pkg:fmt"]),
        ("pkg_check_modules(A fmt)", []),
        ("pkg_search_module(A REQUIRED sdl2 sdl)", ["pkg:sdl2"]),
        ("find_library(A NAMES libusb-1.0 usb)\ntarget_link_libraries(x ${A})", ["link:usb-1.0"]),
        ("find_library(A usb)", []),
        ("find_library(A usb)\nif(A)\ntarget_link_libraries(x ${A})\nendif()", []),
        ("find_library(A usb REQUIRED)", ["link:usb"]),
        ("find_path(A NAMES b/c.h PATHS /x)\ninclude_directories(${A})", ["header:b/c.h"]),
        (
            "find_package(Qt5 5.6 COMPONENTS Core\n  OpenGL REQUIRED OPTIONAL_COMPONENTS Svg)",
            ["Qt5", "Qt5Core", "Qt5OpenGL"],
        ),
        ("find_package(Qt6 REQUIRED Widgets)", ["Qt6", "Qt6Widgets"]),
        ("find_package(Qt5 COMPONENTS Svg)", []),
        (
            "add_library(x a.c)\nadd_library(usb b.c)\ntarget_link_libraries(x PUBLIC usb curl -lm)",
            ["link:curl", "link:m"],
        ),
        ("if(A)\ntarget_link_libraries(x curl)\nendif()", []),
        ("project(curl)\nlink_libraries(curl ${B} b::c /d/e.so -pthread)", []),
    ],
)
def test_what_is_required_and_what_is_only_tried(tmp_path: Path, cmake: str, names: list[str]) -> None:
    assert required(tmp_path, {"CMakeLists.txt": cmake}) == names


OPTIONS = 'option(GUI "a (slow) one" OFF)\noption(SPEED "s" ON)\nset(LOG OFF CACHE BOOL "")\n'
FOLDERS = "if(GUI)\nadd_subdirectory(gui)\nendif()\nif(SPEED)\nadd_subdirectory(${PROJECT_SOURCE_DIR}/speed)\nendif()\n"


@pytest.mark.parametrize(
    ("options", "names"),
    [
        ((), ["Deep", "Speed"]),
        (("-DGUI=ON", "-DSPEED:BOOL=OFF"), ["Deep", "Shown"]),
        (("-DLOG=ON",), ["Deep", "Log", "Speed"]),
    ],
)
def test_files_that_it_adds_are_read_as_its_options_have_it(
    tmp_path: Path, options: tuple[str, ...], names: list[str]
) -> None:
    files = {
        "CMakeLists.txt": f"{OPTIONS}if(LOG)\nfind_package(Log REQUIRED)\nendif()\n{FOLDERS}include(Needs)\n",
        "gui/CMakeLists.txt": "project(gui)\nfind_package(GUI REQUIRED)\nfind_package(Shown REQUIRED)",
        "speed/CMakeLists.txt": "find_package(Speed REQUIRED)",
        "cmake/Needs.cmake": "include(cmake/deep.cmake)\ninclude(Needs)",
        "cmake/deep.cmake": "find_package(Deep REQUIRED)",
        "examples/CMakeLists.txt": "find_package(Example REQUIRED)",
    }
    assert required(tmp_path, files, *options) == names


def test_a_folder_that_adds_itself_is_read_once(tmp_path: Path) -> None:
    files = {
        "CMakeLists.txt": "add_subdirectory(src)\n",
        "src/CMakeLists.txt": "find_package(Deep REQUIRED)\n" + "add_subdirectory(src)\n" * 8,
    }
    assert required(tmp_path, files) == ["Deep"]


class Stage:
    """A stand-in of the stage in which a library is built: its apt knows these packages, and installs them all."""

    def __init__(
        self, folder: Path, *known: str, ubuntu: str = "focal", ros: str = "noetic", git: str = "exit 1"
    ) -> None:
        """Make the programs and tables that the script uses; no host answers this git unless ``git`` says otherwise."""
        self.folder, self.ros = folder, ros
        (folder / "share").mkdir()
        (folder / "local/lib").mkdir(parents=True)
        (folder / "share/cmake-x.txt").write_text(cmake_packages(ubuntu))
        (folder / "share/libraries-x.txt").write_text(library_names(ubuntu))
        (folder / "bin").mkdir()
        programs = {
            "apt-get": ":",
            "apt-cache": f'[[ " {" ".join(known)} " = *" ${{!#}} "* ]]',
            "install-optional-apt": f'echo "$*" >>{folder}/calls',
            "git": git,
        }
        programs |= {tool: f'echo "{tool} $*" >>{folder}/built' for tool in ("cmake", "make", "ldconfig")}
        for name, body in programs.items():
            (folder / "bin" / name).write_text(f"#!/bin/bash\n{body}\n")
            (folder / "bin" / name).chmod(0o755)
        text = SCRIPT.read_text().replace("/usr/local/share/roslab", f"{folder}/share")
        text = text.replace("/usr/local/{lib,share}", f"{folder}/local/lib").replace(
            "/installed$", f"{folder}/installed$"
        )
        text = text.replace("/tmp/apt-", f"{folder}/apt-").replace("/tmp/required", f"{folder}/required")
        (folder / "script").write_text(text)

    def run(self, *arguments: str) -> tuple[list[list[str]], str]:
        """Return the calls that install, each sorted list of packages, and what was said of what is not known."""
        path = f"{self.folder / 'bin'}:{os.environ['PATH']}"
        environment = os.environ | {"ROS_DISTRO": self.ros, "PATH": path}
        command = ["bash", str(self.folder / "script"), *arguments]
        ran = subprocess.run(command, env=environment, capture_output=True, text=True, check=True)
        calls = self.folder / "calls"
        return [line.split() for line in calls.read_text().splitlines()] if calls.exists() else [], ran.stderr

    def library(self, cmake: str, name: str = "acme") -> tuple[list[list[str]], str]:
        """Run the script for a library."""
        (self.folder / name).mkdir()
        (self.folder / name / "CMakeLists.txt").write_text(cmake)
        return self.run(name, str(self.folder / name))


BOTH = "find_package(VISP REQUIRED)\nfind_package(Eigen3 REQUIRED)\nfind_package(OpenMP REQUIRED)\n"


def test_ubuntu_and_ros_bring_what_is_required(tmp_path: Path) -> None:
    stage = Stage(tmp_path, "ros-noetic-visp", "libeigen3-dev")
    assert stage.library(BOTH) == ([["libeigen3-dev", "ros-noetic-visp"]], "")
    kept = tmp_path / "installed" / f"{tmp_path}/share/required/acme.txt".lstrip("/")
    assert kept.read_text() == "libeigen3-dev\nros-noetic-visp\n"


def test_a_package_that_cmake_asks_apt_about_is_installed(tmp_path: Path) -> None:
    asks = "execute_process(COMMAND apt-cache show debian-policy)\n# COMMAND apt-cache show cowsay\n"
    asks += "execute_process(COMMAND apt-cache search ${NAME})\nexecute_process(COMMAND apt-cache show gone)\n"
    stage = Stage(tmp_path, "debian-policy", "cowsay", "libeigen3-dev", "ros-noetic-visp")
    calls, _ = stage.library(BOTH + asks)
    assert calls == [["debian-policy", "libeigen3-dev", "ros-noetic-visp"]]


def test_what_no_package_brings_is_told(tmp_path: Path) -> None:
    calls, said = Stage(tmp_path, "libeigen3-dev").library(BOTH + "find_package(Nowhere REQUIRED)\n")
    assert calls == [["libeigen3-dev"]]
    assert "roslab: acme requires Nowhere, and no package of this image's sources is known to bring it\n" in said
    assert "roslab: acme requires VISP, and this image's sources do not have libvisp-dev, which brings it\n" in said


@pytest.mark.parametrize(
    ("wanted", "known", "taken"),
    [
        ("find_package(FooBar REQUIRED)", ("libfoobar-dev", "foobar-dev"), ["libfoobar-dev"]),
        ("find_package(FooBar REQUIRED)", ("foobar-dev",), ["foobar-dev"]),
        ("find_package(libfoo_bar REQUIRED)", ("libfoo-bar-dev",), ["libfoo-bar-dev"]),
        ("pkg_check_modules(F REQUIRED foobar)", ("libfoobar-dev",), ["libfoobar-dev"]),
        ("find_package(FooBar REQUIRED)", ("libfoobar2-dev",), []),
        ("find_package(FB REQUIRED)", ("libfb-dev",), []),
        ("find_library(F foobar REQUIRED)", ("libfoobar-dev",), []),
        ("find_package(VISP REQUIRED)", ("visp-dev",), []),  # a table knows what brings it
    ],
)
def test_what_no_table_knows_is_taken_by_debians_custom(
    tmp_path: Path, wanted: str, known: tuple[str, ...], taken: list[str]
) -> None:
    calls, said = Stage(tmp_path, *known).library(f"{wanted}\n")
    assert calls == ([taken] if taken else [])
    assert (f"which no table knows: {' '.join(taken)} is taken" in said) is bool(taken)


def test_names_of_pkg_config_links_and_headers(tmp_path: Path) -> None:
    cmake = (
        "pkg_check_modules(A REQUIRED eigen3)\nfind_library(B glog REQUIRED)\nfind_path(C assimp/scene.h REQUIRED)\n"
    )
    stage = Stage(tmp_path, "libeigen3-dev", "libgoogle-glog-dev", "libassimp-dev")
    assert stage.library(f"{cmake}find_library(D nowhere REQUIRED)") == (
        [["libassimp-dev", "libeigen3-dev", "libgoogle-glog-dev"]],
        "",
    )


def test_components_of_qt_and_what_is_linked_by_its_name_alone(tmp_path: Path) -> None:
    stage = Stage(tmp_path, "qtbase5-dev", "libqt5opengl5-dev", "libcurl4-openssl-dev")
    cmake = "find_package(Qt5 COMPONENTS Gui OpenGL REQUIRED)\nadd_library(x a.cc)\n"
    assert stage.library(f"{cmake}target_link_libraries(x Qt5::OpenGL curl m other)") == (
        [["libcurl4-openssl-dev", "libqt5opengl5-dev", "qtbase5-dev"]],
        "",
    )


CODE = """\
#include <nlohmann/json.hpp>
 # include "yaml-cpp/yaml.h"
#include <glog/logging.h>
#include <opencv2/core.hpp>
#include <own/part.h>
#include <QWidget>
#include <vector>
// #include <assimp/scene.h>
"""


@pytest.mark.parametrize(
    ("file", "cmake", "installed"),
    [
        (
            "src/a.cpp",
            "project(acme)\n",
            ["libgoogle-glog-dev", "libopencv-dev", "libyaml-cpp-dev", "nlohmann-json3-dev"],
        ),
        ("src/a.cpp", "find_package(OpenCV)\nfind_package(Glog QUIET)\n# YAML-CPP\n", ["nlohmann-json3-dev"]),
        ("tests/a.cpp", "project(acme)\n", []),
        ("extern/json/a.h", "project(acme)\n", []),
        ("a.txt", "project(acme)\n", []),
    ],
)
def test_headers_that_only_the_code_names(tmp_path: Path, file: str, cmake: str, installed: list[str]) -> None:
    known = (
        "nlohmann-json3-dev",
        "libyaml-cpp-dev",
        "libgoogle-glog-dev",
        "libopencv-dev",
        "qtbase5-dev",
        "libassimp-dev",
    )
    stage = Stage(tmp_path, *known)
    (tmp_path / "acme" / file).parent.mkdir(parents=True)
    (tmp_path / "acme" / file).write_text(CODE)
    (tmp_path / "acme" / "CMakeLists.txt").write_text(cmake)
    assert stage.run("acme", str(tmp_path / "acme")) == ([installed] if installed else [], "")


def test_what_only_looks_like_a_file_of_cmake_stops_nothing(tmp_path: Path) -> None:
    (tmp_path / "acme/ws/json.cmake").mkdir(parents=True)
    (tmp_path / "acme/ws/CMakeLists.txt").symlink_to("/opt/ros/nowhere/toplevel.cmake")
    (tmp_path / "acme/a.h").write_text("#include <nlohmann/json.hpp>\n")
    (tmp_path / "acme/CMakeLists.txt").write_text("project(acme)\n")
    assert Stage(tmp_path, "nlohmann-json3-dev").run("acme", str(tmp_path / "acme")) == ([["nlohmann-json3-dev"]], "")


def test_a_header_of_its_own_is_not_installed(tmp_path: Path) -> None:
    (tmp_path / "acme/extern/nlohmann").mkdir(parents=True)
    (tmp_path / "acme/a.h").write_text("#include <nlohmann/json.hpp>\n")
    (tmp_path / "acme/CMakeLists.txt").write_text("project(acme)\n")
    assert Stage(tmp_path, "nlohmann-json3-dev").run("acme", str(tmp_path / "acme")) == ([], "")


def test_what_is_built_already_is_not_installed(tmp_path: Path) -> None:
    stage = Stage(tmp_path, "libceres-dev")
    (tmp_path / "local/lib/CeresConfig.cmake").touch()
    assert stage.library("find_package(Ceres REQUIRED)") == ([], "")


@pytest.mark.parametrize(
    ("cmake", "installed"),
    [
        (
            "execute_process(COMMAND ./bootstrap-vcpkg.sh)\n",
            ["curl", "ninja-build", "pkg-config", "tar", "unzip", "zip"],
        ),
        ("include(vcpkg)\n", []),
    ],
)
def test_what_starts_vcpkg_is_installed_where_cmake_fetches_it(
    tmp_path: Path, cmake: str, installed: list[str]
) -> None:
    calls, said = Stage(tmp_path).library(cmake)
    assert (calls, said) == ([installed] if installed else [], "")


CLONES = 'cat >/dev/null; if [ "$1" = clone ]; then mkdir --parents "${!#}"; fi'
GTEST = "https://github.com/google/googletest.git"


def test_what_only_its_source_brings_is_built_before_it(tmp_path: Path) -> None:
    stage = Stage(
        tmp_path, "libeigen3-dev", ubuntu="bionic", ros="melodic", git=f'echo "$*" >>{tmp_path}/git\n{CLONES}'
    )
    _, said = stage.library("find_package(GTest REQUIRED)\nfind_package(Eigen3 REQUIRED)\n")
    assert "write into roslab.yaml" not in said
    asked = (tmp_path / "git").read_text().splitlines()
    assert asked[0] == f"clone --quiet {GTEST} {tmp_path}/required/googletest"
    assert asked[1].endswith(" checkout --quiet ec44c6c1675c25b9827aacd08c02433cccde7780")
    built = (tmp_path / "built").read_text().splitlines()
    assert built[0] == "cmake -DCMAKE_BUILD_TYPE=Release -DBUILD_SHARED_LIBS=ON .."
    assert built[-3:] == ["make install", "make install DESTDIR=/installed", "ldconfig "]
    assert not (tmp_path / "required").exists()


def test_so_is_what_that_needs_and_apt_brings_its_packages(tmp_path: Path) -> None:
    stage = Stage(tmp_path, "libeigen3-dev", ubuntu="bionic", ros="melodic", git=CLONES)
    calls, said = stage.library("find_package(OsqpEigen REQUIRED)\nfind_package(Sophus REQUIRED)\n")
    assert said.count("no package of this image's sources") == 2
    assert "write into" not in said
    assert (tmp_path / "built").read_text().count("make install\n") == 3
    assert calls == [["libeigen3-dev"], ["libeigen3-dev"]]
    kept = tmp_path / "installed" / f"{tmp_path}/share/required/acme.txt".lstrip("/")
    assert set(kept.read_text().splitlines()) == {"libeigen3-dev"}


def test_but_not_what_needs_more_than_cmake(tmp_path: Path) -> None:
    _, said = Stage(tmp_path, ubuntu="bionic", ros="melodic", git=CLONES).library("find_package(raisim REQUIRED)\n")
    assert "roslab: it can be built before acme; write into roslab.yaml:" in said
    assert not (tmp_path / "built").exists()


def test_what_two_names_ask_for_is_tried_once(tmp_path: Path) -> None:
    stage = Stage(tmp_path, git=f'echo "$*" >>{tmp_path}/git; exit 1')
    _, said = stage.library("find_package(GTSAM REQUIRED)\nfind_package(gtsam REQUIRED)\n")
    assert said.count("no package of this image's sources") == 2
    assert said.count("write into roslab.yaml") == 1
    assert len((tmp_path / "git").read_text().splitlines()) == 1


def test_a_library_that_can_be_built_before_is_told_with_what_to_write(tmp_path: Path) -> None:
    calls, said = Stage(tmp_path, "libeigen3-dev").library("find_package(GTSAM REQUIRED)")
    assert calls == []
    first, second, *written = said.splitlines()
    assert first == "roslab: acme requires GTSAM, and no package of this image's sources is known to bring it"
    assert second == "roslab: it can be built before acme; write into roslab.yaml:"
    tree = tmp_path / "tree"
    tree.mkdir()
    (tree / "roslab.yaml").write_text("\n".join(written))
    (tree / "CMakeLists.txt").write_text("project(demo)\nfind_package(acme REQUIRED)\nadd_executable(a a.cpp)\n")
    (tree / "a.cpp").write_text("int main() {}\n")
    (tree / "README.md").write_text("Needs [acme](https://github.com/lab/acme)\n")
    assert [(s.name, s.ref) for s in plan_repository(tree).plan.libraries] == [("gtsam", "4.0.3"), ("acme", None)]


def test_what_earlier_libraries_required_is_installed_for_a_later_one_and_in_the_image(tmp_path: Path) -> None:
    stage = Stage(tmp_path, "libeigen3-dev", "libceres-dev")
    stage.library("find_package(Eigen3 REQUIRED)")
    calls, _ = stage.library("project(other)\n", name="other")
    assert calls[1:] == [["libeigen3-dev"]]
    assert stage.run()[0][2:] == [["libeigen3-dev"]]


def test_what_could_not_be_cloned_requires_nothing(tmp_path: Path) -> None:
    assert Stage(tmp_path).run("acme", str(tmp_path / "nowhere")) == ([], "")


@pytest.mark.parametrize(("asked", "reads"), [("acme_lidar", True), ("Pangolin", False)])
def test_the_image_calls_it_between_the_clone_and_cmake(tmp_path: Path, asked: str, reads: bool) -> None:
    made = f"project(demo)\nfind_package({asked} REQUIRED)\nadd_executable(a a.cpp)\n"
    page = "Needs [acme_lidar](https://github.com/lab/acme_lidar)"
    for name, text in {"CMakeLists.txt": made, "a.cpp": "int main() {}\n", "README.md": page}.items():
        (tmp_path / name).write_text(text)
    text = dockerfile(plan_repository(tmp_path).plan)
    called = "install-required acme_lidar /tmp/sources/acme_lidar -DCMAKE_BUILD_TYPE=Release\n"
    assert (called in text) == reads
    assert ("\n    install-required\n" in text) == reads
    if reads:
        before, after = text.split(called)
        assert "git clone https://github.com/lab/acme_lidar" in before
        assert "configure-library -DCMAKE_BUILD_TYPE=Release ../" in after
        which = "acme_lidar of https://github.com/lab/acme_lidar, which README.md:1 names, cannot be"
        assert f"roslab: {which} cloned: the build stops" in before
        assert f"roslab: {which} compiled: the build stops" in after


MODULES = """\
[submodule "third/acme"]
path = third/acme
url = https://github.com/lab/acme.git
"""


@pytest.mark.parametrize(
    ("made", "reads"),
    [("project(demo)\nadd_subdirectory(third/acme)\nadd_executable(a a.cpp)\n", True), (None, False)],
)
def test_the_image_calls_it_for_submodules_that_it_clones_where_cmake_compiles_the_tree(
    tmp_path: Path, made: str | None, reads: bool
) -> None:
    files = {".gitmodules": MODULES, "a.py": "import numpy\n", "README.md": "Run `python a.py`\n"}
    for name, text in (files | ({"CMakeLists.txt": made, "a.cpp": "int main() {}\n"} if made else {})).items():
        (tmp_path / name).write_text(text)
    (tmp_path / "third/acme").mkdir(parents=True)
    text = dockerfile(plan_repository(tmp_path).plan)
    folder = f"/home/${{NB_USER}}/{tmp_path.name}/third/acme"
    assert (f"install-required third-acme {folder}\n" in text) == reads
    if reads:
        assert text.index("git clone https://github.com/lab/acme.git") < text.index("install-required third-acme")
        assert text.index("install-required third-acme") < text.index("# The program")


def test_the_folder_of_a_project_below_its_root_is_to_be_written_too() -> None:
    told = next(line for line in library_names("noble").splitlines() if line.startswith("argos = "))
    assert '"cmake_options": "-DARGOS_DOCUMENTATION=OFF", "cmake_folder": "../src"' in told
