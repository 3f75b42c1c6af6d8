"""What is compiled for the processor of the machine that builds is compiled for all of its platform."""

from __future__ import annotations

import platform
import re
import subprocess
from pathlib import Path

import pytest

from roslab.pipeline import plan_repository
from roslab.render import image_scripts
from roslab.render.dockerfile import dockerfile

NATIVE = 'set(CMAKE_CXX_FLAGS "-O3 -march=native")\n'
CPP = {"CMakeLists.txt": f"project(demo)\n{NATIVE}add_executable(a a.cpp)\n", "a.cpp": "int main() {}\n"}
ROS1 = {
    "package.xml": "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend></package>",
    "CMakeLists.txt": f"project(demo)\nfind_package(catkin REQUIRED)\n{NATIVE}",
}


def written(folder: Path, files: dict[str, str]) -> str:
    for path, text in files.items():
        (folder / path).write_text(text, encoding="utf-8")
    return dockerfile(plan_repository(folder).plan)


@pytest.mark.parametrize(("files", "folder"), [(CPP, "/home/${NB_USER}/"), (ROS1, "/home/${NB_USER}/ws/src\n")])
def test_the_option_is_replaced_before_anything_is_compiled(tmp_path: Path, files: dict[str, str], folder: str) -> None:
    text = written(tmp_path, files)
    assert f"\nRUN any-processor {folder}" in text
    compiled = text.index("catkin_make -j") if files is ROS1 else text.index(" && cmake -D")
    assert text.index("\nRUN any-processor") < compiled


def test_nothing_is_replaced_where_nothing_is_said(tmp_path: Path) -> None:
    files = {name: text.replace("-march=native", "-O2") for name, text in CPP.items()}
    assert "any-processor" not in written(tmp_path, files)


MAKE = {
    "Makefile": "include flags.mk\nTARGET = a\n$(TARGET): a.cpp\n\t$(CXX) $(CXXFLAGS) -o $@ $<\n",
    "flags.mk": "CXXFLAGS += -O3 -march=native\n",
    "a.cpp": "int main() {}\n",
}


def test_the_option_of_a_makefile_is_replaced_before_make(tmp_path: Path) -> None:
    text = written(tmp_path, MAKE)
    assert text.index("\nRUN any-processor /home/${NB_USER}/") < text.index("\n && make")


def test_makefiles_beside_cmake_are_not_read(tmp_path: Path) -> None:
    assert "any-processor" not in written(
        tmp_path, MAKE | {"CMakeLists.txt": CPP["CMakeLists.txt"].replace(NATIVE, "")}
    )


@pytest.mark.skipif(platform.machine() != "x86_64", reason="the words are those of a PC")
def test_the_script_replaces_the_option_in_build_files_only(tmp_path: Path) -> None:
    said = "add_compile_options(-march=native -mtune=native -marchnative)\n"
    (tmp_path / "a folder").mkdir()
    for name in ("a folder/CMakeLists.txt", "flags.cmake", "flags.mk", "README.md"):
        (tmp_path / name).write_text(said, encoding="utf-8")
    script = Path(image_scripts.__path__[0]) / "any-processor.sh"
    subprocess.run(["bash", str(script), str(tmp_path)], check=True)
    other = "add_compile_options(-march=core-avx2 -mtune=native -marchnative)\n"
    found = [
        (tmp_path / name).read_text() for name in ("a folder/CMakeLists.txt", "flags.cmake", "flags.mk", "README.md")
    ]
    assert found == [other, other, other, said]


@pytest.mark.parametrize(("machine", "option"), [("x86_64", "-msse4.2"), ("aarch64", "-pipe")])
def test_an_option_of_x86_is_replaced_on_arm_alone(tmp_path: Path, machine: str, option: str) -> None:
    """A stand-in of ``uname`` says which processor the machine has."""
    said = 'set(FLAGS "-msse {0} {0} -O3")\nadd_compile_options({0})\n'
    kept = "check_cxx_compiler_flag(-msse4.2 HAS_IT)\n# -msse4.20 and --msse4.2\n"
    file, uname = tmp_path / "CMakeLists.txt", tmp_path / "bin/uname"
    file.write_text(said.format("-msse4.2") + kept, encoding="utf-8")
    uname.parent.mkdir()
    uname.write_text(f"#!/bin/sh\necho {machine}\n", encoding="utf-8")
    uname.chmod(0o755)
    script = Path(image_scripts.__path__[0]) / "any-processor.sh"
    call = ["bash", str(script), str(tmp_path), "-msse4.2", "-msse4"]
    subprocess.run(call, check=True, env={"PATH": f"{uname.parent}:/usr/bin:/bin"})
    assert file.read_text(encoding="utf-8") == said.format(option) + kept


def test_the_dockerfile_names_the_options(tmp_path: Path) -> None:
    files = {name: text.replace("-march=native", "-mssse3") for name, text in CPP.items()}
    assert re.search(r"\nRUN any-processor /home/\S+ -mssse3\n", written(tmp_path, files))
