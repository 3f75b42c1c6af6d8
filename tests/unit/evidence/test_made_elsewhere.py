"""A cache of CMake that was written on another machine is found, named and hidden from the build."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.evidence.native import made_elsewhere
from roslab.pipeline import plan_repository
from roslab.render.ignore import ignore, keeps_out
from roslab.repository.checkout import Repository

CACHE = "# This is the CMakeCache file.\n//Build\nCMAKE_BUILD_TYPE:STRING=\nCMAKE_CACHEFILE_DIR:INTERNAL={}\n"


def tree(root: Path, folders: dict[str, str]) -> Repository:
    (root / "CMakeLists.txt").write_text("cmake_minimum_required(VERSION 3.5)\nproject(a)\nadd_executable(a a.cpp)\n")
    for folder, made_in in folders.items():
        (root / folder / "CMakeFiles").mkdir(parents=True)
        (root / folder / "CMakeFiles/a.o").write_text("")
        (root / folder / "CMakeCache.txt").write_text(CACHE.format(made_in))
    return Repository.open(root)


def test_a_cache_is_named_with_the_folder_that_it_was_made_in(tmp_path: Path) -> None:
    repository = tree(tmp_path, {"build": "/home/ann/a/build", "": "/home/ann/a"})
    (message, file, line), *more = made_elsewhere.read(repository)
    assert (file, line, more) == ("CMakeCache.txt", 4, [])
    assert message.startswith("CMake wrote it in /home/ann/a, and so is one more: ")


@pytest.mark.parametrize("folder", ["", "build"])
def test_it_is_hidden_with_what_lies_beside_it(tmp_path: Path, folder: str) -> None:
    tree(tmp_path, {folder: f"/home/ann/a/{folder}"})
    planned = plan_repository(tmp_path)
    lines = ignore(planned.plan, ()).splitlines()
    below = f"{folder}/".lstrip("/")
    assert keeps_out(lines, f"{below}CMakeCache.txt")
    assert keeps_out(lines, f"{below}CMakeFiles/a.o")
    assert not keeps_out(lines, f"{below}CMakeLists.txt")
    assert any(warning.file == f"{below}CMakeCache.txt" for warning in planned.plan.warnings)


def test_what_was_compiled_here_is_hidden_without_a_word(tmp_path: Path) -> None:
    repository = tree(tmp_path, {"build": f"{tmp_path}/build"})
    assert made_elsewhere.names(repository) == ("build/CMakeFiles", "build/CMakeCache.txt")
    assert not list(made_elsewhere.read(repository))


def test_a_file_of_that_name_alone_is_none(tmp_path: Path) -> None:
    repository = tree(tmp_path, {})
    (tmp_path / "CMakeCache.txt").write_text("What a cache of CMake holds\n")
    assert made_elsewhere.names(Repository.open(tmp_path)) == made_elsewhere.names(repository) == ()


def test_a_space_of_a_workspace_is_hidden_as_a_whole(tmp_path: Path) -> None:
    (tmp_path / "src/a").mkdir(parents=True)
    (tmp_path / "src/a/package.xml").write_text("<package><name>a</name></package>")
    for folder, tool in {
        "build": "catkin_make",
        "devel": "catkin build",
        "install": "colcon",
        "src/a": "catkin",
    }.items():
        (tmp_path / folder).mkdir(parents=True, exist_ok=True)
        (tmp_path / folder / ".built_by").write_text(f"{tool}\n")
    (tmp_path / "build/CMakeCache.txt").write_text(CACHE.format("/home/ann/ws/build"))
    (tmp_path / "notes").mkdir()
    (tmp_path / "notes/.built_by").write_text("Ann and Bob\n")
    assert made_elsewhere.names(Repository.open(tmp_path)) == ("build", "devel", "install")


MANIFEST = "<package><name>{}</name><buildtool_depend>catkin</buildtool_depend>{}</package>"
MARKS = {
    "catkin": {"build/.built_by": "catkin_make\n", "devel/.built_by": "catkin_make\n"},
    "old catkin": {
        "build/catkin_make.cache": "",
        "build/CMakeCache.txt": "",
        "devel/.catkin": "/home/ann/ws/src",
        "devel/_setup_util.py": "",
    },
    "colcon": {
        "build/.built_by": "colcon\n",
        "devel/.colcon_install_layout": "isolated\n",
        "log/build_2024-01-01_10-00-00/logger_all.log": "",
    },
}


def workspace(root: Path, marks: dict[str, str], *, packages: str) -> Repository:
    made = {
        "build/arm/catkin_generated/installspace/node.py": "import smbus\n",
        "devel/share/arm/package.xml": MANIFEST.format("arm", "<depend>sound_play</depend>"),
        "devel/share/arm/launch/b.launch": '<launch><node pkg="joy" type="joy_node" name="a"/></launch>',
        "log/build_2024-01-01_10-00-00/a.sh": "sudo apt install libzbar-dev\n",
        "README.md": "ROS Noetic\n",
    }
    sources = {
        f"{packages}/package.xml": MANIFEST.format("arm", "<depend>rospy</depend>"),
        f"{packages}/CMakeLists.txt": "project(arm)\nfind_package(catkin REQUIRED)\n",
    }
    for path, text in {**made, **sources, **marks}.items():
        (root / path).parent.mkdir(parents=True, exist_ok=True)
        (root / path).write_text(text)
    return Repository.open(root)


@pytest.mark.parametrize("tool", MARKS)
def test_nothing_is_read_in_such_a_space(tmp_path: Path, tool: str) -> None:
    repository = workspace(tmp_path, MARKS[tool], packages="src/arm")
    kept = {file.path for file in made_elsewhere.without(repository).files}
    assert not [path for path in kept if path.startswith(("build/", "devel/"))]
    assert any(path.startswith("log/") for path in kept) == ("log" not in made_elsewhere.names(repository))
    assert kept >= {"src/arm/package.xml", "src/arm/CMakeLists.txt", "README.md"}
    plan = plan_repository(tmp_path).plan
    assert plan.rosdep is not None
    assert plan.rosdep.manifests == ("src/arm/package.xml",)
    installed = f"{plan.apt} {plan.apt_guessed} {plan.python}"
    assert not [each for each in ("smbus", "joy", "sound_play") if each in installed]


def test_folders_of_these_names_alone_are_sources(tmp_path: Path) -> None:
    repository = workspace(tmp_path, {}, packages="src/arm")
    assert made_elsewhere.without(repository) is repository


def test_where_all_packages_lie_in_one_it_is_read(tmp_path: Path) -> None:
    repository = workspace(tmp_path, MARKS["catkin"], packages="build/arm")
    assert made_elsewhere.without(repository) is repository
