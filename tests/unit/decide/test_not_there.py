"""What packages install and git does not hold is made before the build: ``cmake --install`` ends without it."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from roslab.decide.decision import Decision
from roslab.pipeline import plan_repository
from roslab.render.dockerfile import dockerfile

Tree = Callable[[dict[str, str]], Decision]


def package(tool: str, *lines: str, name: str = "arm") -> dict[str, str]:
    xml = f"<package><name>{name}</name><buildtool_depend>{tool}</buildtool_depend></package>"
    code = "\n".join((f"project({name})", f"find_package({tool} REQUIRED)", *lines, ""))
    return {f"{name}/package.xml": xml, f"{name}/CMakeLists.txt": code, f"{name}/config/a.yaml": ""}


FOLDERS = "install(DIRECTORY launch config rviz/ DESTINATION share/${PROJECT_NAME})"
FILE = "install(FILES .setup_assistant DESTINATION share)"


@pytest.mark.parametrize(
    ("lines", "made"),
    [
        ((FOLDERS,), ("arm/launch/", "arm/rviz/")),
        ((FILE,), ("arm/.setup_assistant",)),
        (("install(PROGRAMS bin/go DESTINATION lib)",), ("arm/bin/go",)),
        (("install(DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}/worlds DESTINATION share)",), ("arm/worlds/",)),
        (("install(DIRECTORY ${PROJECT_NAME}_data DESTINATION share)",), ("arm/arm_data/",)),
        (("ament_auto_package(INSTALL_TO_SHARE launch config)",), ("arm/launch/",)),
        (("install(DIRECTORY launch DESTINATION share OPTIONAL)",), ()),
        (("install(DIRECTORY ${CMAKE_BINARY_DIR}/doc ${X}/y /opt/z DESTINATION share)",), ()),
        (("if(WITH_GUI)", FOLDERS, "endif()"), ()),
        (("install(TARGETS node DESTINATION lib)", "install(EXPORT node DESTINATION lib)"), ()),
        (("configure_file(a.in ${CMAKE_CURRENT_SOURCE_DIR}/a.h)", "install(FILES a.h DESTINATION include)"), ()),
        (("if(NOT EXISTS ${DATA})", "file(DOWNLOAD ${URL} ${DATA}/a.onnx)", "endif()", FOLDERS), ()),
        (("install(DIRECTORY config DESTINATION share)",), ()),
        (("install(DIRECTORY . ../../elsewhere DESTINATION share)",), ()),
    ],
)
def test_what_is_installed_is_made(tree: Tree, lines: tuple[str, ...], made: tuple[str, ...]) -> None:
    decision = tree(package("ament_cmake", *lines))
    assert decision.not_there == made
    told = [each.message for each in decision.warnings if "made empty" in each.message]
    assert len(told) == bool(made)
    assert all(path in told[0] for path in made)


@pytest.mark.parametrize("named", ["arm", "${MY_NAME}"])
def test_the_folder_of_the_project_is_that_of_the_file_which_begins_it(tree: Tree, named: str) -> None:
    """A file below it that begins none installs from there."""
    install = "install(DIRECTORY ${PROJECT_SOURCE_DIR}/config/ DESTINATION share)\n"
    xml = "<package><name>arm</name><buildtool_depend>ament_cmake</buildtool_depend></package>"
    made = f"set(MY_NAME arm)\nproject({named})\nfind_package(ament_cmake REQUIRED)\nadd_subdirectory(src)\n"
    files = {"package.xml": xml, "CMakeLists.txt": made, "src/CMakeLists.txt": install, "config/a.yaml": ""}
    assert tree(files).not_there == ()
    files["CMakeLists.txt"] += install.replace("config", "launch")
    assert tree(files).not_there == ("launch/",)


def test_the_devel_space_needs_none(tree: Tree) -> None:
    assert tree(package("catkin", FOLDERS)).not_there == ()


def test_what_is_not_built_needs_none(tree: Tree) -> None:
    decision = tree(package("ament_cmake", FOLDERS) | package("ament_cmake", name="b") | {"arm/COLCON_IGNORE": ""})
    assert (decision.packages, decision.not_there) == (("b/package.xml",), ())


def test_a_link_and_a_submodule_are_there(tree: Tree, tmp_path: Path) -> None:
    (tmp_path / "arm").mkdir()
    (tmp_path / "arm/launch").symlink_to("config")
    modules = '[submodule "arm/rviz"]\n\tpath = arm/rviz\n\turl = https://github.com/a/rviz.git\n'
    assert tree(package("ament_cmake", FOLDERS) | {".gitmodules": modules}).not_there == ()


def test_they_are_made_before_the_build(tmp_path: Path) -> None:
    for path, text in package("ament_cmake", FOLDERS, "install(FILES doc/a.pdf DESTINATION share)").items():
        target = tmp_path / path
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text(text, encoding="utf-8")
    text = dockerfile(plan_repository(tmp_path).plan)
    made, touched = text.index("arm/doc "), text.index("arm/doc/a.pdf")
    assert text.rindex("mkdir --parents", 0, made) < made < touched < text.index("colcon build")
