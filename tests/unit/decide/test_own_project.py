"""A CMake project as its page builds it: its options, where its programs are, and what only /usr/local has."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from roslab.decide.decision import Decision
from roslab.pipeline import plan_repository
from roslab.render.dockerfile import dockerfile
from trees import tree_of

Tree = Callable[[dict[str, str]], Decision]
MADE = (
    "cmake_minimum_required(VERSION 3.10)\nproject(Demo)\nadd_executable(solve a.cpp)\n"
    "option(DEMO_GUI 'windows' OFF)\noption(DEMO_FAST 'fast' OFF)\noption(DEMO_CUDA 'CUDA' OFF)\n"
)
CODE = {"CMakeLists.txt": MADE, "a.cpp": "#include <vector>\nint main() {}\n"}


@pytest.mark.parametrize(
    ("page", "options"),
    [
        ("mkdir build\ncd build\ncmake -DDEMO_GUI=ON ..\nmake", ("-DDEMO_GUI=ON",)),
        ("cd demo\nmkdir build && cd build\ncmake .. -DDEMO_GUI:BOOL=ON\nmake", ("-DDEMO_GUI:BOOL=ON",)),
        ("mkdir build\ncd build\ncmake -DDEMO_GUI:=ON ..\nmake", ("-DDEMO_GUI=ON",)),
        ("mkdir release\ncd release\ncmake -DDEMO_GUI=ON ..\nmake", ("-DDEMO_GUI=ON",)),
        ("```\nBuild it by `cd lib/a; ./make.sh 3`.\n```\ncd target\ncmake -DDEMO_GUI=ON ..", ("-DDEMO_GUI=ON",)),
        ("cd lib/release\ncmake -DDEMO_GUI=ON ..", ()),
        ("cmake -S . -B build -DDEMO_GUI=ON -DCMAKE_BUILD_TYPE=Debug\ncmake --build build", ("-DDEMO_GUI=ON",)),
        ("cmake ..\nmake\n```\nWith CUDA:\n```\ncmake -DDEMO_CUDA=ON ..", ()),
        ("cmake -DWITH_QT=OFF ..\n```\nThen:\n```\ncmake -DDEMO_GUI=ON ..", ("-DDEMO_GUI=ON",)),
        ("git clone https://github.com/a/other\ncd other/build\ncmake -DOTHER=ON ..", ()),
        ("cmake -DQt5_DIR=/opt/qt -DACME_ROOT=/home/me -DDEMO_DATA=/data ..", ()),
        ("cmake -DCMAKE_CXX_COMPILER=clang++-12 -DCMAKE_INSTALL_PREFIX=out ..", ()),
    ],
)
def test_the_options_of_the_page(tree: Tree, page: str, options: tuple[str, ...]) -> None:
    assert tree(CODE | {"README.md": f"```\n{page}\n```\n"}).cmake_options == options


def test_the_options_of_roslab_yaml_win(tmp_path: Path) -> None:
    page = {"README.md": "```\ncmake -DDEMO_GUI=ON -DDEMO_FAST=ON ..\n```\n"}
    yaml = {"roslab.yaml": "format: 3\ncmake_options: -DDEMO_GUI=OFF\n"}
    for path, text in (CODE | page | yaml).items():
        (tmp_path / path).write_text(text, encoding="utf-8")
    text = dockerfile(plan_repository(tmp_path).plan)
    assert "cmake -DCMAKE_BUILD_TYPE=Release -DDEMO_GUI=OFF -DDEMO_FAST=ON" in text


@pytest.mark.parametrize("written", ["include(Options)", "include(cmake/Options.cmake)"])
def test_a_file_that_is_included_places_the_programs(tree: Tree, written: str) -> None:
    place = "set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/${CMAKE_INSTALL_BINDIR})\n"
    files = CODE | {"CMakeLists.txt": f"{MADE}{written}\n", "cmake/Options.cmake": place}
    assert tree(files).program_folders == ("build/bin",)


@pytest.mark.parametrize(
    ("place", "folder", "path"),
    [
        ("set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/../bin)\n", "beside/bin", "/bin"),
        (
            "set_target_properties(solve PROPERTIES RUNTIME_OUTPUT_DIRECTORY_RELEASE ${CMAKE_BINARY_DIR}/../release)\n",
            "beside/release",
            "/release",
        ),
    ],
)
def test_programs_that_are_written_beside_the_build_folder(tmp_path: Path, place: str, folder: str, path: str) -> None:
    top = "set" if place.startswith("set(") else ""
    made = f"{place}{MADE}" if top else f"{MADE}{place}"
    for name, text in (CODE | {"CMakeLists.txt": made}).items():
        (tmp_path / name).write_text(text, encoding="utf-8")
    planned = plan_repository(tmp_path)
    assert planned.decision.program_folders == (folder,)
    assert f":/home/${{NB_USER}}{path}:${{PATH}}" in dockerfile(planned.plan)
    assert not planned.plan.compiled_apart  # the image gets nothing but the build folder of that stage


def test_a_root_that_names_no_project(tree: Tree) -> None:
    root = "cmake_minimum_required(VERSION 3.5)\nadd_subdirectory(sim)\n"
    files = {
        "CMakeLists.txt": root,
        "sim/CMakeLists.txt": "add_executable(sim a.cpp)\n",
        "sim/a.cpp": "#include <vector>\n#include <Eigen/Core>\n",
        "scripts/read_log.py": "import scipy\nif __name__ == '__main__':\n    pass\n",
    }
    decision = tree(files)
    assert (decision.kind, decision.build_tool, decision.program_folders) == ("cpp", "cmake", ("build/sim",))


BY_HAND = "```\ngit clone -b v2.7.1 https://github.com/a/nlopt.git\ncd nlopt/build\ncmake ..\nsudo make install\n```\n"


@pytest.mark.parametrize(
    ("cmake", "built"),
    [
        ('set(NLOPT_LIBRARY "/usr/local/lib/libnlopt.so")', ["nlopt"]),
        ("target_link_libraries(solve /usr/local/lib/libnlopt.a)", ["nlopt"]),
        ("target_link_libraries(solve nlopt)", []),
        ("if(APPLE)\nset(NLOPT_LIBRARY /usr/local/lib/libnlopt.so)\nendif()", []),
    ],
)
def test_a_library_that_is_named_by_its_file(tree: Tree, cmake: str, built: list[str]) -> None:
    files = CODE | {"CMakeLists.txt": f"{MADE}{cmake}\n", "README.md": BY_HAND}
    assert [source.name for source in tree(files).source] == built


@pytest.mark.parametrize(
    ("page", "kind"),
    [
        ("pip install the-demo", "python"),
        ("pip install .", "python"),
        ("pip install the-demo\n```\nFrom source:\n```\nmkdir build\ncd build\ncmake ..\nmake", "cpp"),
        ("pip install numpy", "cpp"),
    ],
)
def test_bindings_that_the_page_has_pip_compile(tree: Tree, page: str, kind: str) -> None:
    setup = (
        "from setuptools import Extension, setup\nfrom setuptools.command.build_ext import build_ext\n\n\n"
        "class CMakeExtension(Extension):\n    pass\n\n\n"
        "setup(name='the_demo', ext_modules=[CMakeExtension('the_demo')], cmdclass={'build_ext': build_ext})\n"
    )
    code = CODE | {f"{name}.cpp": "#include <Eigen/Dense>\n" for name in "bcd"}
    assert tree(code | {"setup.py": setup, "README.md": f"```\n{page}\n```\n"}).kind == kind


@pytest.mark.parametrize(("command", "told"), [("make", True), ("sudo make install", False)])
def test_what_a_script_clones_and_does_not_install_brings_no_newer_version(
    tmp_path: Path, command: str, told: bool
) -> None:
    files = {
        **CODE,
        "CMakeLists.txt": f"{MADE}find_package(PCL 1.8 REQUIRED)\n",
        "build.sh": f"git clone -b pcl-1.8.1 https://github.com/lab/pcl.git\ncd pcl/build\ncmake ..\n{command}\n",
        "roslab.yaml": "format: 3\nbase: {ubuntu: 16.04}\n",
    }
    for path, text in files.items():
        (tmp_path / path).write_text(text, encoding="utf-8")
    warnings = plan_repository(tmp_path).plan.warnings
    assert any("CMake requires PCL 1.8" in warning.message for warning in warnings) == told


def test_the_documentation_is_no_program(tree: Tree) -> None:
    project = "cmake_minimum_required(VERSION 3.5)\nproject({0})\nadd_{1}\n"
    files = {
        "doc/CMakeLists.txt": project.format("documentation", "custom_target(pages ALL)"),
        "src/planner/CMakeLists.txt": project.format("planner", "executable(planner main.cpp)"),
        "src/planner/main.cpp": "#include <vector>\nint main() {}\n",
    }
    assert tree(files).cmake_folder == "src/planner"


ONLY, FAST = "-DCATKIN_WHITELIST_PACKAGES", "-DA_FAST=ON"
ROBOT = "<package format='3'><name>a</name><buildtool_depend>{0}</buildtool_depend></package>"


@pytest.mark.parametrize(
    ("tool", "page", "options"),
    [
        ("ament_cmake", "colcon build --symlink-install --cmake-args -DA_VIEW=OFF", ("-DA_VIEW=OFF",)),
        ("ament_cmake", "colcon build --cmake-args -DCMAKE_BUILD_TYPE=Debug -D A_FAST=ON", ("-DA_FAST=ON",)),
        ("ament_cmake", "colcon test --cmake-args -DA_VIEW=OFF\ncolcon build", ()),
        ("ament_cmake", "colcon build\n```\nWith a view:\n```\ncolcon build --cmake-args -DA_VIEW=ON", ()),
        ("ament_cmake", "colcon build --cmake-args -DA_CUDA=ON -DB_DIR=/opt/b -DC=<yours>", ()),
        ("ament_cmake", "colcon build --cmake-args -DA_CUDA=OFF", ("-DA_CUDA=OFF",)),
        ("catkin", "catkin_make -DA_VIEW=OFF", ("-DA_VIEW=OFF",)),
        ("catkin", "catkin_make -DA_VIEW:=OFF", ("-DA_VIEW=OFF",)),
        ("catkin", f"catkin_make {ONLY}=a_msgs\ncatkin_make {ONLY}=", ()),
        (
            "catkin",
            f'catkin_make {ONLY}="a_msgs" -DA_VIEW=OFF\ncatkin_make {ONLY}="" -DA_FAST=ON',
            ("-DA_VIEW=OFF", FAST),
        ),
        ("catkin", f"catkin_make {ONLY}=a_msgs -DA_VIEW=OFF", ("-DA_VIEW=OFF",)),
        ("catkin", f"catkin_make --pkg a_msgs -DA_FAST=OFF\ncatkin_make {FAST}\ncatkin_make -DA_FAST=2", (FAST,)),
        ("catkin", f"catkin_make --only-pkg-with-deps a_msgs\ncatkin_make {FAST}", (FAST,)),
        ("catkin", f"catkin_make\ncatkin_make {FAST}", ()),
        ("ament_cmake", f"colcon build --packages-select a_msgs\ncolcon build --cmake-args {FAST}", (FAST,)),
        ("ament_cmake", f"colcon build --packages-up-to b\ncolcon build --packages-up-to a --cmake-args {FAST}", ()),
    ],
)
def test_the_options_of_a_workspace(tmp_path: Path, tool: str, page: str, options: tuple[str, ...]) -> None:
    kind = "\n".join((f"find_package({tool} REQUIRED)", f"{tool}_package()"))
    (tmp_path / "package.xml").write_text(ROBOT.format(tool))
    (tmp_path / "CMakeLists.txt").write_text(f"cmake_minimum_required(VERSION 3.5)\nproject(a)\n{kind}\n")
    (tmp_path / "README.md").write_text(f"# A\n```\n{page}\n```\n")
    planned = plan_repository(tmp_path)
    assert planned.plan.workspace.ros is not None
    assert planned.plan.workspace.ros.cmake_options == ("-DCMAKE_BUILD_TYPE=Release", *options)


def test_path_has_the_folders_of_many_programs_and_first_those_that_a_page_runs(tmp_path: Path) -> None:
    names = [f"tool_{number:02}" for number in range(30)]
    made = "project(demo)\n" + "".join(f"add_subdirectory({name})\n" for name in names)
    files = {"CMakeLists.txt": made, "README.md": "# Run\n```\n./tool_29 --fast\n```\n"}
    for name in names:
        files |= {f"{name}/CMakeLists.txt": f"add_executable({name} a.cpp)\n", f"{name}/a.cpp": "int main() {}\n"}
    tree_of(tmp_path / "demo", files)
    planned = plan_repository(tmp_path / "demo")
    assert planned.decision.command[0] == "tool_29"
    assert planned.decision.program_folders[:2] == ("build/tool_29", "build/tool_00")
    assert planned.plan.workspace.program
    assert planned.plan.workspace.program.programs[:2] == ("demo-build/tool_29", "demo-build/tool_00")
    assert "demo-build/tool_20" in planned.plan.workspace.program.programs
