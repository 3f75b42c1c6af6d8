"""Code that asks git where the repository begins finds a folder of git in the image."""

from __future__ import annotations

import os
import shutil
import subprocess
from pathlib import Path

import pytest

from roslab.pipeline import plan_repository
from roslab.render.dockerfile import dockerfile

XML = (
    "<package><name>demo</name><buildtool_depend>ament_cmake</buildtool_depend>"
    "<export><build_type>ament_cmake</build_type></export></package>"
)
MADE = "RUN git init --quiet --template= /home/${NB_USER}/ws/src/demo \\\n"


@pytest.mark.parametrize(
    ("file", "code", "made"),
    [
        ("launch/a.launch.py", "top = check_output(['git', 'rev-parse', '--show-toplevel'])", True),
        ("core/a.py", "top = os.popen('git rev-parse --show-toplevel').read()", True),
        ("core/a.py", "repo = git.Repo(__file__, search_parent_directories=True)", True),
        ("bin/a", "#!/usr/bin/env python3\nrepo = git.Repo(__file__, search_parent_directories=True)", True),
        ("bin/a", "#!/bin/sh\nrepo = git.Repo(__file__, search_parent_directories=True)", False),
        ("core/a.py", "repo = git.Repo(__file__)", False),
        ("core/a.py", "# git rev-parse --show-toplevel", False),
        ("core/a.py", "commit = os.popen('git rev-parse HEAD').read()", False),
        ("core/a.py", "import subprocess\ncommit = subprocess.check_output(['git', 'rev-parse', 'HEAD'])", True),
        ("test/a.py", "top = os.popen('git rev-parse --show-toplevel').read()", False),
    ],
)
def test_the_folder_of_git(tmp_path: Path, file: str, code: str, *, made: bool) -> None:
    root = tmp_path / "demo"
    files = {"package.xml": XML, "CMakeLists.txt": "project(demo)\nfind_package(ament_cmake REQUIRED)\n", file: code}
    for path, text in files.items():
        (root / path).parent.mkdir(parents=True, exist_ok=True)
        (root / path).write_text(text + "\n", encoding="utf-8")
    plan = plan_repository(root).plan
    assert (MADE in dockerfile(plan)) is made
    assert ("git" in plan.apt_guessed or "git" in plan.apt) or not made


def test_the_commit_of_the_image_is_one(tmp_path: Path) -> None:
    (tmp_path / "main.py").write_text("import git\ngit.Repo('.', search_parent_directories=True)\n", encoding="utf-8")
    text = dockerfile(plan_repository(tmp_path).plan)
    step = text.partition("RUN git init")[2].partition("\n\n")[0]
    made = []
    for name in ("a", "b"):
        folder = tmp_path / name
        folder.mkdir()
        script = f"git init{step}".replace(step.split()[2], str(folder))
        shell = shutil.which("bash") or pytest.skip("bash is not here")
        subprocess.run([shell, "-ec", script], check=True, env={"PATH": os.environ["PATH"], "HOME": str(tmp_path)})
        git = shutil.which("git") or pytest.skip("git is not here")
        head = subprocess.run([git, "-C", str(folder), "rev-parse", "HEAD"], check=True, capture_output=True, text=True)
        made.append(head.stdout)
    assert made[0] == made[1]


ASKED = "execute_process(COMMAND git rev-parse HEAD OUTPUT_VARIABLE ID)\n"
STOPS = "execute_process(COMMAND git rev-parse HEAD RESULT_VARIABLE R)\nif(R)\nmessage(FATAL_ERROR no)\nendif()\n"
BY_SHELL = "execute_process(COMMAND bash -c \"git rev-parse HEAD | awk '{print $1}'\" OUTPUT_VARIABLE ID)\n"


@pytest.mark.parametrize(
    ("cmake", "made"),
    [
        (f"{ASKED}add_definitions(-DCOMMIT=${{ID}})\n", True),
        (f"{BY_SHELL}add_compile_definitions(COMMIT=${{ID}})\n", True),
        (f"{ASKED}target_compile_definitions(demo PRIVATE\n  COMMIT=${{ID}})\n", True),
        (ASKED.replace("git", "${GIT_EXECUTABLE}") + "add_definitions(-DCOMMIT=${ID})\n", True),
        ("execute_process(COMMAND git log -1 COMMAND_ERROR_IS_FATAL ANY)\n", True),
        (f"{ASKED}if(ID)\nadd_definitions(-DCOMMIT=${{ID}})\nendif()\n", False),
        (STOPS, True),
        (STOPS.replace("rev-parse HEAD", "submodule update --init"), True),
        (STOPS.replace("FATAL_ERROR", "WARNING"), False),
        (STOPS.replace("if(R", "if(OTHER"), False),
        (f'{ASKED}add_definitions(-DCOMMIT="${{ID}}")\n', False),  # nothing is a value here
        (f'{ASKED}add_definitions("-DCOMMIT=\\"${{ID}}\\"")\n', False),
        (f"{ASKED}add_definitions(-DCOMMIT=${{OTHER}})\n", False),
        (f"{ASKED}message(STATUS ID=${{ID}})\n", False),
        (ASKED.replace("rev-parse HEAD", "describe") + "add_definitions(-DCOMMIT=${ID})\n", False),
        (f"if(EXISTS ${{CMAKE_SOURCE_DIR}}/.git)\n{ASKED}add_definitions(-DCOMMIT=${{ID}})\nendif()\n", False),
        (f"# {ASKED}add_definitions(-DCOMMIT=${{ID}})\n", False),
        ("execute_process(COMMAND digit rev-parse x OUTPUT_VARIABLE ID)\nadd_definitions(-DC=${ID})\n", False),
    ],
)
def test_cmake_that_needs_a_commit_is_called_where_there_is_one(tmp_path: Path, cmake: str, *, made: bool) -> None:
    root = tmp_path / "demo"
    root.mkdir()
    (root / "CMakeLists.txt").write_text(f"project(demo CXX)\n{cmake}add_executable(demo demo.cpp)\n", encoding="utf-8")
    (root / "demo.cpp").write_text("int main() {}\n", encoding="utf-8")
    text = dockerfile(plan_repository(root).plan)
    before, found, after = text.partition("RUN git init --quiet")
    assert bool(found) is made
    assert not made or ("&& cmake " in after and "&& cmake " not in before)
    assert not made or "\n      git \\" in before or " git" in before


@pytest.mark.parametrize("apart", [True, False])
def test_so_it_is_where_the_compilation_has_a_stage_of_its_own(tmp_path: Path, *, apart: bool) -> None:
    code = f"project(demo CXX)\n{ASKED}add_definitions(-DCOMMIT=${{ID}})\nadd_executable(demo demo.cpp)\n"
    own = {} if apart else {"roslab.yaml": 'format: 3\ncustom: ["true"]\n'}
    files = {"CMakeLists.txt": code, "demo.cpp": "int main() {}\n", **own}
    for path, text in files.items():
        (tmp_path / path).write_text(text, encoding="utf-8")
    plan = plan_repository(tmp_path).plan
    assert plan.compiled_apart is apart
    stages = dockerfile(plan).split("\nFROM ")
    assert [("&& cmake " in stage, "RUN git init --quiet" in stage) for stage in stages].count((True, True)) == 1


def test_cmake_finds_the_commit_from_the_build_folder_beside_the_source(tmp_path: Path) -> None:
    """CMake calls git in the folder where it was started."""
    code = f"project(demo CXX)\n{ASKED}add_definitions(-DCOMMIT=${{ID}})\nadd_executable(demo demo.cpp)\n"
    root = tmp_path / "demo"
    root.mkdir()
    for path, text in {"CMakeLists.txt": code, "demo.cpp": "int main() {}\n"}.items():
        (root / path).write_text(text, encoding="utf-8")
    step = dockerfile(plan_repository(root).plan).partition("RUN git init")[2].partition("\n#")[0]
    script = f"git init{step}".replace("/home/${NB_USER}/", f"{tmp_path}/image/")
    environment = {"PATH": os.environ["PATH"], "HOME": str(tmp_path)}
    subprocess.run(["bash", "-ec", script], check=True, env=environment)
    build = tmp_path / "image/demo-build"
    head = subprocess.run(["git", "rev-parse", "HEAD"], cwd=build, check=True, capture_output=True, env=environment)
    assert len(head.stdout.strip()) == 40
