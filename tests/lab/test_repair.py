"""The repairs of ``roslab build``: what lacks one thing in each repository builds with exactly the missing lines."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from subprocess import CompletedProcess
from typing import Any

import pytest

from . import doors
from .act import run_workflow
from .laboratory import Laboratory

RECIPE = Path(__file__).with_name("repair")
SCRIPTS = Path(__file__).resolve().parent.parent.parent / "scripts"
BASES = {
    "repro-lab/repair:native": "ros:noetic-ros-base",
    "repro-lab/repair:python": "python:3.11",
    "repro-lab/ros:jazzy": "ros:jazzy-ros-base",
}
NATIVE = "format: 3\nkind: cpp\nbase:\n  image: repro-lab/repair:native\n"
PYTHON = "format: 3\nkind: python\nbase:\n  image: repro-lab/repair:python\n"
WHOLE = "format: 3\nkind: cpp\nbase:\n  image: ros:noetic-ros-base\n"
"""A base whose apt has all packages of its distribution, and the index of their files."""
ROS = "format: 3\nbase:\n  ros: jazzy\n  image: repro-lab/ros:jazzy\n"
CMAKE = "cmake_minimum_required(VERSION 3.5)\nproject(robot CXX)\n"
MAIN = "int main() { return 0; }\n"
PACKAGE = """\
<package format="2"><name>robot</name><version>1.0.0</version><description>d</description>
<maintainer email="a@example.org">a</maintainer><license>MIT</license><buildtool_depend>ament_cmake</buildtool_depend>{}
<export><build_type>ament_cmake</build_type></export></package>
"""


@dataclass(frozen=True, kw_only=True)
class Broken:
    """A repository that lacks something that nothing in it declares in a way that can be read."""

    config: str
    files: Mapping[str, str]
    lines: str = ""
    """What ``--write`` adds to its roslab.yaml, or for a change inside it the whole file."""
    rounds: int = 1
    why: str = ""
    """For one that cannot be mended, the reason."""
    proof: bool = False

    @property
    def written(self) -> str:
        """The repaired roslab.yaml."""
        return self.lines if self.lines.startswith("format: ") else self.config + self.lines


# A name that a macro or a variable holds is not found by reading: only the build tells that it is needed
INCLUDES = "#define LIBRARY <glog/logging.h>\n#include LIBRARY\n"
EXECUTABLE = f"{CMAKE}add_executable(robot main.cpp)\n"
FINDS = "file(STRINGS needs.txt library)\nfind_package(${library} REQUIRED)\n"
NEEDS = {"needs.txt": "Eigen3\n", "links.txt": "modbus\n"}
PKG_CONFIG = "find_package(PkgConfig)\nfile(STRINGS m m)\npkg_check_modules(M REQUIRED ${m})\n"
LINKS = "file(STRINGS links.txt library)\ntarget_link_libraries(robot ${library})\n"
CALLS = "set(program bc)\nadd_custom_target(table ALL COMMAND ${program} ${CMAKE_SOURCE_DIR}/needs.txt)\n"
GLOG = "  - libgoogle-glog-dev  # for the header glog/logging.h (main.cpp:1)\n"
MENDED = {
    "header": Broken(
        config=NATIVE, files={"CMakeLists.txt": EXECUTABLE, "main.cpp": INCLUDES + MAIN}, lines=f"apt:\n{GLOG}"
    ),
    "cmake-package": Broken(
        config=NATIVE,
        files={"CMakeLists.txt": CMAKE + FINDS, **NEEDS},
        lines="apt:\n  - libeigen3-dev  # for the package Eigen3 (CMakeLists.txt:4)\n",
    ),
    "pkg-config": Broken(
        config=NATIVE,
        files={
            "CMakeLists.txt": CMAKE + PKG_CONFIG,
            "m": "jsoncpp\n",
        },
        lines="apt:\n  - libjsoncpp-dev  # for the module jsoncpp (CMakeLists.txt:5)\n",
    ),
    "library": Broken(
        config=NATIVE,
        files={"CMakeLists.txt": EXECUTABLE + LINKS, "main.cpp": MAIN, **NEEDS},
        lines="apt:\n  - libmodbus-dev  # for the library modbus\n",
    ),
    "library-of-no-table": Broken(
        config=WHOLE,
        files={"CMakeLists.txt": EXECUTABLE + LINKS, "main.cpp": MAIN, **NEEDS, "links.txt": "fstrcmp\n"},
        lines="apt:\n  - libfstrcmp-dev  # for the library fstrcmp\n",
    ),
    "program": Broken(
        config=NATIVE, files={"CMakeLists.txt": CMAKE + CALLS, **NEEDS}, lines="apt:\n  - bc  # for the program bc\n"
    ),
    "standard": Broken(
        config=NATIVE,
        files={
            "CMakeLists.txt": EXECUTABLE,
            "main.cpp": f"#if __cplusplus < 202002L\n#error C++20 or newer is needed here\n#endif\n{MAIN}",
        },
        lines='cmake_options: "-DCMAKE_CXX_STANDARD=20"  # for cxx standard (main.cpp:2)\n',
    ),
    "renamed": Broken(
        config=f"{NATIVE}apt: [libeigen2-dev]\n",
        files={"CMakeLists.txt": EXECUTABLE, "main.cpp": MAIN},
        lines=f"{NATIVE}apt: [libeigen3-dev]\n",
    ),
    "version-gone": Broken(
        config=f"{NATIVE}apt:\n  - bc=1.06-1  # for the tables\n",
        files={"CMakeLists.txt": EXECUTABLE, "main.cpp": MAIN},
        lines=f"{NATIVE}apt:\n  - bc  # for the tables\n",
    ),
    "three-things": Broken(
        config=f"{NATIVE}apt:\n  - bc\n",
        files={
            "CMakeLists.txt": CMAKE + FINDS + "add_executable(robot main.cpp)\n" + LINKS,
            "main.cpp": INCLUDES + MAIN,
            **NEEDS,
        },
        lines="  - libeigen3-dev  # for the package Eigen3 (CMakeLists.txt:4)\n"
        f"{GLOG}  - libmodbus-dev  # for the library modbus\n",
        rounds=3,
    ),
    "rosdep-key": Broken(
        config=ROS,
        files={
            "package.xml": PACKAGE.format("\n<depend>bison</depend>"),
            "CMakeLists.txt": f"{CMAKE}find_package(ament_cmake REQUIRED)\nament_package()\n",
        },
        lines="skip_keys:\n  - bison  # for the package bison (package.xml:3)\n",
    ),
    "ros-package": Broken(
        config=ROS,
        files={
            "package.xml": PACKAGE.format(""),
            "CMakeLists.txt": f"{CMAKE}find_package(ament_cmake REQUIRED)\n{FINDS}ament_package()\n",
            "needs.txt": "angles\n",
        },
        lines="apt:\n  - ros-jazzy-angles  # for the package angles (CMakeLists.txt:5)\n",
    ),
    "python-module": Broken(
        config=f"{PYTHON}test: python3 main.py\n",
        files={"main.py": 'import importlib\n\nimportlib.import_module("ya" + "ml")\n'},
        lines="pip:\n  - PyYAML  # for the module yaml (main.py:3)\n",
        proof=True,
    ),
    "shared-library": Broken(
        config=f"{PYTHON}test: python3 main.py\n",
        files={"main.py": 'import ctypes\n\nctypes.CDLL("libusb-" + "1.0.so.0")\n'},
        lines="apt:\n  - libusb-1.0-0  # for the library libusb-1.0.so.0 (main.py:3)\n",
        proof=True,
    ),
    "numpy-too-new": Broken(
        config=f"{PYTHON}test: python3 main.py\n",
        files={"requirements.txt": "numpy\n", "main.py": 'import numpy\n\nkind = getattr(numpy, "float")\n'},
        lines='pip:\n  - "numpy<1.24"  # for numpy without float (main.py:3)\n',
        proof=True,
    ),
    "python-version": Broken(
        config="format: 3\nkind: python\n",
        files={
            "setup.py": 'from setuptools import setup\n\nsetup(name="robot", python_requires="<3." + str(10))\n',
            "robot.py": "print(1)\n",
        },
        lines='base:\n  python: "3.8"  # for the package robot\n',
    ),
}
OF_TWO = PACKAGE.replace("<name>robot<", "<name>{name}<").replace("{}", "")
BUILT = f"{CMAKE}find_package(ament_cmake REQUIRED)\nadd_executable(node main.cpp)\n"
BUILT += "install(TARGETS node DESTINATION lib/${PROJECT_NAME})\nament_package()\n"
TWO = {
    "README.md": "# Robot\n\n```\nros2 run robot_demo node\n```\n",
    "robot_demo/package.xml": OF_TWO.replace("{name}", "robot_demo"),
    "robot_demo/CMakeLists.txt": BUILT.replace("robot", "robot_demo"),
    "robot_demo/main.cpp": MAIN,
    "robot_extra/package.xml": OF_TWO.replace("{name}", "robot_extra"),
    "robot_extra/CMakeLists.txt": BUILT.replace("robot", "robot_extra"),
    "robot_extra/main.cpp": "int main() { return grip(); }\n",
}
LEFT_OUT = "robot_extra, which does not compile: 'grip' was not declared in this scope at robot_extra/main.cpp:1; "
LEFT = {
    "a mistake in the code": Broken(
        config=NATIVE,
        files={"CMakeLists.txt": EXECUTABLE, "main.cpp": "int main() { return 1 +; }\n"},
        why="error: expected primary-expression before",
    ),
    "a header of no known package": Broken(
        config=WHOLE,
        files={"CMakeLists.txt": EXECUTABLE, "main.cpp": f"#include <no_such/thing.hpp>\n{MAIN}"},
        why="not repaired: no package of the image's sources holds the header no_such/thing.hpp (main.cpp:1)",
    ),
    "a header that apt cannot be asked for": Broken(
        config=NATIVE,
        files={"CMakeLists.txt": EXECUTABLE, "main.cpp": f"#include <no_such/thing.hpp>\n{MAIN}"},
        why="not repaired: apt was not asked which package holds it: ",
    ),
    "what was added does not help": Broken(
        config=NATIVE,
        files={"CMakeLists.txt": EXECUTABLE, "main.cpp": f"#define E <Eigen/Core>\n#include E\n{MAIN}"},
        rounds=1,
        why="the same cause is back",
    ),
    "a package that nobody has": Broken(
        config=f"{PYTHON}pip: [no-such-package-of-anybody-at-all]\n",
        files={"main.py": "print(1)\n"},
        why="pip's index has no release of no-such-package-of-anybody-at-all",
    ),
    "a Dockerfile of the author's": Broken(
        config="format: 3\ndockerfile: Dockerfile\n",
        files={
            "Dockerfile": "FROM repro-lab/repair:native\nCOPY . /src\nRUN g++ /src/main.cpp\n",
            "main.cpp": INCLUDES + MAIN,
        },
        why="+RUN apt-get update && apt-get install -y --no-install-recommends libgoogle-glog-dev\n RUN g++ /src/",
    ),
}


DYNAMIC = "import importlib\n\nimportlib.import_module({})\n"
"""Reading does not tell what this imports."""
PAGE = {"README.md": "# Robot\n\n```\npython3 main.py\n```\n"}
STARTS = {
    "a module, without a roslab.yaml": Broken(
        config="",
        files={**PAGE, "main.py": DYNAMIC.format('"ya" + "ml"')},
        lines="format: 3\npip:\n  - PyYAML  # for the module yaml (main.py:3)\n",
    ),
    "a module of its own": Broken(
        config="",
        files={**PAGE, "main.py": DYNAMIC.format('"uti" + "ls"'), "lib/robot/utils.py": "print(1)\n"},
        lines="format: 3\nenv:\n  PYTHONPATH: {}  # for the module utils (main.py:3)\n".format(
            '"/home/jovyan/repair-starts/lib/robot"'
        ),
    ),
    "a library, beside a test": Broken(
        config=f'{PYTHON}command: [python3, main.py]\ntest: "true"\n',
        files={"main.py": 'import ctypes\n\nctypes.CDLL("libusb-" + "1.0.so.0")\n'},
        lines="apt:\n  - libusb-1.0-0  # for the library libusb-1.0.so.0 (main.py:3)\n",
    ),
    "a module of ROS": Broken(
        config=f'{ROS}command: [python3, main.py]\ntest: "true"\n',
        files={
            "package.xml": PACKAGE.format(""),
            "CMakeLists.txt": f"{CMAKE}find_package(ament_cmake REQUIRED)\nament_package()\n",
            "main.py": DYNAMIC.format('"tf_" + "transformations"'),
        },
        lines="apt:\n  - ros-jazzy-tf-transformations  # for the module tf_transformations (main.py:3)\n",
    ),
}
PARSES = """\
import argparse

words = argparse.ArgumentParser()
words.add_argument("--bag", required=True)
words.parse_args()
"""
STAYS = {
    "a GPU": (
        'import sys\n\nsys.exit("RuntimeError: No CUDA GPUs are available")\n',
        "roslab: The program needs a device",
    ),
    "an argument": (PARSES, "roslab: The command ends because it was not given --bag"),
    "what does not help": (
        "import sys\n\nprint(sys.path)\nraise ModuleNotFoundError(\"No module named 'yaml'\")\n",
        "stays as it was before pip: [PyYAML]: its command does not start for the same cause",
    ),
}


@pytest.fixture(scope="module")
def bases(lab: Laboratory) -> Iterator[None]:
    """Make the bases with the small packages."""
    for name, base in BASES.items():
        command = ["docker", "build", "--quiet", "--tag", name, "--build-arg", f"BASE={base}", str(RECIPE)]
        subprocess.run(command, env=dict(lab.environment), check=True, capture_output=True)
    yield
    subprocess.run(["docker", "image", "rm", *BASES], env=dict(lab.environment), check=False, capture_output=True)


def repository(folder: Path, broken: Broken) -> Path:
    for name, text in {**broken.files, **({"roslab.yaml": broken.config} if broken.config else {})}.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text)
    return folder


def build(lab: Laboratory, folder: Path, *options: str) -> CompletedProcess[str]:
    """Run ``roslab build``; a proof's own traceback is no error of its."""
    command = [sys.executable, "-I", str(SCRIPTS), "build", str(folder), "--tag", "repro-lab"]
    names = {name: value for name, value in lab.environment.items() if not name.startswith(("GITHUB_", "ROSLAB_"))}
    return subprocess.run([*command, *options], env=names, capture_output=True, text=True, timeout=1800, check=False)


@pytest.mark.usefixtures("bases")
@pytest.mark.parametrize("name", list(MENDED))
def test_it_builds_with_what_was_missing(lab: Laboratory, tmp_path: Path, name: str) -> None:
    broken = MENDED[name]
    folder = repository(tmp_path / f"repair-{name}", broken)
    words = [] if broken.proof else ["--no-proof"]
    answer = build(lab, folder, "--write", *words)
    assert answer.returncode == 0, answer.stderr[-8000:]
    assert (folder / "roslab.yaml").read_text() == broken.written
    assert "roslab: these lines are written to roslab.yaml:\n--- a/roslab.yaml\n" in answer.stderr
    assert (folder / "roslab.yaml.old").read_text() == broken.config
    assert f"roslab: repair {broken.rounds} adds" in answer.stderr
    assert f"roslab: repair {broken.rounds + 1} adds" not in answer.stderr
    subprocess.run(["docker", "image", "rm", answer.stdout.strip()], env=dict(lab.environment), check=False)


@pytest.mark.usefixtures("bases")
@pytest.mark.parametrize("needed", [False, True])
def test_a_package_that_does_not_compile_is_left_out_unless_the_command_needs_it(
    lab: Laboratory, tmp_path: Path, needed: bool
) -> None:
    other = {"README.md": TWO["README.md"].replace("_demo", "_extra")} if needed else {}
    folder = repository(tmp_path / "repair-two", Broken(config=ROS, files={**TWO, **other}))
    answer = build(lab, folder, "--write", "--no-proof")
    if needed:
        assert answer.returncode == 5, answer.stderr[-4000:]
        assert "(package robot_extra)" in answer.stderr
        assert "not repaired: robot_extra does not compile, and the command needs robot_extra" in answer.stderr
        assert (folder / "roslab.yaml").read_text() == ROS
        return
    assert answer.returncode == 0, answer.stderr[-8000:]
    assert f"roslab: repair 1 leaves out {LEFT_OUT}the command does not need it" in answer.stderr
    line = LEFT_OUT.replace(", which", "  #")
    assert (folder / "roslab.yaml").read_text() == f"{ROS}skip_packages:\n  - {line}the command does not need it\n"
    subprocess.run(["docker", "image", "rm", answer.stdout.strip()], env=dict(lab.environment), check=False)


@pytest.mark.usefixtures("bases")
@pytest.mark.parametrize("name", list(STARTS))
def test_a_command_that_died_starts(lab: Laboratory, tmp_path: Path, name: str) -> None:
    """Its image is good enough without it, and is built again all the same."""
    broken = STARTS[name]
    folder = repository(tmp_path / "repair-starts", broken)
    answer = build(lab, folder, "--write")
    assert answer.returncode == 0, answer.stderr[-8000:]
    assert "rung 1, starts, does not hold" in answer.stderr
    assert "rung 1, starts, holds" in answer.stderr.rpartition("roslab: repair 1 adds")[2]
    assert "roslab: repair 2 adds" not in answer.stderr
    assert (folder / "roslab.yaml").read_text() == broken.written
    image = answer.stdout.strip()
    assert image == "repair-starts:repro-lab"
    assert "roslab-before" not in tags(lab, "repair-starts")
    subprocess.run(["docker", "run", "--rm", image], env=dict(lab.environment), check=True, capture_output=True)
    subprocess.run(["docker", "image", "rm", image], env=dict(lab.environment), check=False)


@pytest.mark.parametrize("name", list(STAYS))
def test_an_image_that_is_good_enough_is_never_lost(lab: Laboratory, tmp_path: Path, name: str) -> None:
    code, why = STAYS[name]
    folder = repository(tmp_path / "repair-stays", Broken(config="", files={**PAGE, "main.py": code}))
    answer = build(lab, folder, "--write")
    assert answer.returncode == 0, answer.stderr[-8000:]
    assert why in answer.stderr
    assert not (folder / "roslab.yaml").exists()
    image = answer.stdout.strip()
    assert image == "repair-stays:repro-lab"
    assert tags(lab, "repair-stays") == "repro-lab\n"
    imports = ["docker", "run", "--rm", image, "python3", "-c", "import yaml"]
    assert subprocess.run(imports, env=dict(lab.environment), check=False, capture_output=True).returncode
    subprocess.run(["docker", "image", "rm", image], env=dict(lab.environment), check=False)


def tags(lab: Laboratory, name: str) -> str:
    command = ["docker", "image", "ls", "--format", "{{.Tag}}", name]
    return subprocess.run(command, env=dict(lab.environment), check=True, capture_output=True, text=True).stdout


@pytest.mark.usefixtures("bases")
def test_the_first_failure_stands_where_that_is_asked_for(lab: Laboratory, tmp_path: Path) -> None:
    folder = repository(tmp_path / "repair-once", MENDED["header"])
    answer = build(lab, folder, "--no-proof", "--no-repair")
    assert answer.returncode == 5, answer.stderr[-4000:]
    assert "Add libgoogle-glog-dev under `apt`" in answer.stderr
    assert "roslab: repair" not in answer.stderr
    assert "not repaired" not in answer.stderr


@pytest.mark.usefixtures("bases")
@pytest.mark.parametrize("name", list(LEFT))
def test_what_cannot_be_mended_stops_with_the_reason(lab: Laboratory, tmp_path: Path, name: str) -> None:
    broken = LEFT[name]
    folder = repository(tmp_path / "repair-left", broken)
    answer = build(lab, folder, "--write", "--no-proof")
    assert answer.returncode == 5, answer.stderr[-4000:]
    assert broken.why in answer.stderr
    assert (folder / "roslab.yaml").read_text() == broken.config
    assert sorted(path.name for path in folder.iterdir()) == sorted([*broken.files, "roslab.yaml"])


def test_a_failed_run_hands_over_the_lines(lab: Laboratory, tmp_path: Path) -> None:
    """Annotation, summary, and in a pull request of the repository's own a suggestion on a line of its diff."""
    includes = INCLUDES.replace("glog/logging.h", "fstrcmp.h")  # no table knows it: apt is asked
    files = {"roslab.yaml": WHOLE, "CMakeLists.txt": EXECUTABLE, "main.cpp": includes + MAIN}
    inputs = {"registry": lab.registry, "platforms": "linux/amd64"}
    caller = doors.through_action(tmp_path, inputs, files, base={})
    posted: list[tuple[str, dict[str, Any]]] = []
    patch = "@@ -0,0 +1,4 @@\n" + "".join(f"+{line}\n" for line in WHOLE.splitlines())
    github = {"posted": posted, "files": [{"filename": "roslab.yaml", "patch": patch}]}
    event = doors.payload("robot", head=f"{doors.OWNER}/robot")
    ran = run_workflow(lab, caller, "pull_request", event, env=doors.builder(lab), github=github)
    assert ran.exit_code != 0
    line = "  - libfstrcmp-dev  # for the header fstrcmp.h (main.cpp:1)\n"
    assert "::error file=main.cpp,line=1::The header fstrcmp.h is missing" in ran.log
    assert f"Lines to add to `roslab.yaml`:\n\n```yaml\napt:\n{line}```" in ran.summary
    ((path, body),) = posted
    assert path == f"/repos/{doors.OWNER}/robot/pulls/7/comments"
    assert (body["path"], body["line"]) == ("roslab.yaml", 4)
    assert f"```suggestion\n  image: ros:noetic-ros-base\napt:\n{line}```" in body["body"]


def test_a_run_tells_why_the_command_of_a_good_image_died(lab: Laboratory, tmp_path: Path) -> None:
    """Nothing fails: a warning at the line that asked, and the lines in the summary."""
    broken = STARTS["a module, without a roslab.yaml"]
    inputs = {"registry": lab.registry, "platforms": "linux/amd64"}
    caller = doors.through_action(tmp_path, inputs, dict(broken.files), base={})
    event = doors.payload("robot", head=f"{doors.OWNER}/robot")
    ran = run_workflow(lab, caller, "pull_request", event, env=doors.builder(lab))
    assert ran.exit_code == 0, ran.log[-8000:]
    assert "::warning file=main.py,line=3::the default command does not start on linux/amd64: Python finds" in ran.log
    assert "So that the default command starts: lines for the new file `roslab.yaml`:\n" in ran.summary
    assert f"```yaml\n{broken.lines}```" in ran.summary
    assert "No tag was made or moved" not in ran.summary
