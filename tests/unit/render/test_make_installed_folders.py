"""The script that makes the folders which cloned packages install and git does not keep."""

from __future__ import annotations

import subprocess
from pathlib import Path

import pytest

from roslab.pipeline import plan_repository
from roslab.render.dockerfile import dockerfile

pytestmark = pytest.mark.usefixtures("scripts_on_path")
FOLDERS = "install(DIRECTORY launch config rviz/\n  DESTINATION share/${PROJECT_NAME}) # all (of them)"


def _made(root: Path, cmake: str) -> set[str]:
    folder = root / "src/arm/arm_description"
    (folder / "config").mkdir(parents=True)
    (folder / "CMakeLists.txt").write_text(f"project(arm)\n{cmake}\n")
    before = {path for path in root.rglob("*") if path.is_dir()}
    said = subprocess.run(["make-installed-folders", "src"], cwd=root, capture_output=True, text=True, check=True)
    made = {str(path.relative_to(folder)) for path in root.rglob("*") if path.is_dir() and path not in before}
    told = {line.partition("arm_description/")[2].partition(",")[0] for line in said.stdout.splitlines()}
    assert told <= made
    assert bool(told) == bool(made)
    return made


@pytest.mark.parametrize(
    ("cmake", "made"),
    [
        (FOLDERS, {"launch", "rviz"}),
        ('install(\n  DIRECTORY\n  "meshes"\n  DESTINATION "share/arm")', {"meshes"}),
        ("install(DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}/worlds/a DESTINATION share)", {"worlds", "worlds/a"}),
        ("install(DIRECTORY include/${PROJECT_NAME} DESTINATION include)", {"include", "include/arm"}),
        ("ament_auto_package(INSTALL_TO_SHARE launch config)", {"launch"}),
        ("install(DIRECTORY launch DESTINATION share OPTIONAL)", set()),
        ("install(DIRECTORY ${CMAKE_BINARY_DIR}/doc ${X}/y /opt/z . ../b DESTINATION share)", set()),
        (f"if(WITH_GUI)\n{FOLDERS}\nendif()", set()),
        (f"if(WITH_GUI)\nendif()\n{FOLDERS}", {"launch", "rviz"}),
        (f"function(f)\n{FOLDERS}\nendfunction()", set()),
        (f"execute_process(COMMAND make_launch)\n{FOLDERS}", set()),
        (f"# {FOLDERS.partition(chr(10))[0]} DESTINATION share)", set()),
        ("install(TARGETS node DESTINATION lib)\ninstall(FILES doc/a.pdf DESTINATION share)", set()),
        ("install(DIRECTORY launch FILES_MATCHING PATTERN scripts EXCLUDE)", {"launch"}),
    ],
)
def test_what_is_installed_is_made(tmp_path: Path, cmake: str, made: set[str]) -> None:
    assert _made(tmp_path, cmake) == made


def test_the_folder_of_the_project_is_that_of_the_file_which_begins_it(tmp_path: Path) -> None:
    (tmp_path / "src/arm/launch").mkdir(parents=True)
    (tmp_path / "src/arm/lib").mkdir()
    install = "install(DIRECTORY ${PROJECT_SOURCE_DIR}/launch/ ${PROJECT_SOURCE_DIR}/rviz DESTINATION share)\n"
    (tmp_path / "src/arm/CMakeLists.txt").write_text(f"project(arm)\nadd_subdirectory(lib)\n{install}")
    (tmp_path / "src/arm/lib/CMakeLists.txt").write_text(install)
    subprocess.run(["make-installed-folders", "src"], cwd=tmp_path, check=True)
    assert {each.name for each in (tmp_path / "src/arm").iterdir() if each.is_dir()} == {"launch", "lib", "rviz"}
    assert [each.name for each in (tmp_path / "src/arm/lib").iterdir()] == ["CMakeLists.txt"]


def test_a_link_stays(tmp_path: Path) -> None:
    (tmp_path / "src/arm/arm_description").mkdir(parents=True)
    (tmp_path / "src/arm/arm_description/launch").symlink_to("nowhere")
    (tmp_path / "src/arm/arm_description/CMakeLists.txt").write_text("install(DIRECTORY launch DESTINATION share)\n")
    subprocess.run(["make-installed-folders", "src"], cwd=tmp_path, check=True)
    assert (tmp_path / "src/arm/arm_description/launch").is_symlink()


@pytest.mark.parametrize(
    ("tool", "page", "called"),
    [
        ("ament_cmake", "git clone https://github.com/lab/drivers\n    ", True),
        ("ament_cmake", "", False),
        ("catkin", "git clone https://github.com/lab/drivers\n    ", False),  # the devel space needs none
    ],
)
def test_it_runs_where_packages_are_cloned_and_installed(tmp_path: Path, tool: str, page: str, called: bool) -> None:
    build = "colcon build" if tool == "ament_cmake" else "catkin_make"
    files = {
        "package.xml": f"<package><name>arm</name><buildtool_depend>{tool}</buildtool_depend>"
        "<depend>drivers</depend></package>",
        "CMakeLists.txt": f"project(arm)\nfind_package({tool} REQUIRED)\n",
        "README.md": f"ROS {'2 humble' if 'ament' in tool else 'noetic'}\n\n    cd ws/src\n    {page}{build}\n",
    }
    for name, text in files.items():
        (tmp_path / name).write_text(text)
    text = dockerfile(plan_repository(tmp_path).plan)
    assert ("make-installed-folders src" in text) == called
    if called:
        assert text.index("clone-listed ") < text.index("make-installed-folders src") < text.index("colcon build")
        assert " /make-installed-folders " in text
