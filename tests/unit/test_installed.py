"""Rung 0: what is asked of an image's packages, and of the libraries of what was compiled."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

from roslab.pipeline import plan_repository
from roslab.plan.installed import AMENT_SCRIPT, FIND_SCRIPT, IMPORT_SCRIPT, LIBRARIES_SCRIPT, PREFIXES, SHOW_SCRIPT
from roslab.plan.proof import Proof
from trees import tree_of

MANIFEST = (
    '<package format="2"><name>robot</name><version>1.0.0</version><description>x</description>'
    '<maintainer email="a@example.org">a</maintainer><license>MIT</license>'
    "<buildtool_depend>catkin</buildtool_depend></package>"
)
CMAKE = "cmake_minimum_required(VERSION 3.0.2)\nproject(robot)\nfind_package(catkin REQUIRED)\ncatkin_package()\n"
TREE = {"package.xml": MANIFEST, "CMakeLists.txt": CMAKE + "add_executable(driver driver.cpp)\n"}
FOUND, LIBRARIES = "the workspace's packages are found", "the compiled programs find their libraries"


def rung_0(folder: Path, **files: str) -> list[Proof]:
    tree_of(folder, {**TREE, **files})
    return [proof for proof in plan_repository(folder, branch=None).plan.proofs if proof.rung == 0]


def test_a_workspace(tmp_path: Path) -> None:
    assert [proof.name for proof in rung_0(tmp_path)] == [FOUND, LIBRARIES]


def test_a_workspace_that_compiles_only_tests(tmp_path: Path) -> None:
    files = {"CMakeLists.txt": CMAKE, "test/CMakeLists.txt": "add_executable(check check.cpp)\n"}
    assert [proof.name for proof in rung_0(tmp_path, **files)] == [FOUND]


def test_an_authors_dockerfile_is_asked_the_same_and_nothing_depends_on_it(tmp_path: Path) -> None:
    """Its entry point may be the program, and its workspace known to its command alone."""
    recipe = 'FROM ros:noetic-ros-base\nCOPY . /ws/src/robot\nRUN cd /ws && catkin_make\nCMD ["roslaunch", "robot"]\n'
    asked = {"Dockerfile": recipe, "requirements.txt": "numpy\n", "roslab.yaml": "format: 3\ndockerfile: Dockerfile\n"}
    found = rung_0(tmp_path, **asked)
    assert [proof.name for proof in found] == [FOUND, "declared Python packages import", LIBRARIES]
    assert not any(proof.required or proof.entrypoint for proof in found)
    assert all("(devel|install)(_isolated)?/setup.bash" in proof.command[2] for proof in (found[0], found[2]))


@pytest.mark.parametrize(
    ("library", "code", "told"),
    [(b"libc.so.6", 0, "programs looked at: 1"), (b"libq.so.6", 1, "libq.so.6 => not found")],
)
def test_libraries(tmp_path: Path, library: bytes, code: int, told: str) -> None:
    """A program whose library is gone is found, among scripts and shared objects, in a folder of the environment."""
    place = tmp_path / "devel/lib/robot"
    place.mkdir(parents=True)
    (place / "driver").write_bytes(Path("/bin/true").read_bytes().replace(b"libc.so.6", library))
    (place / "script").write_text("#!/bin/sh\n")
    (place / "libplugin.so").write_bytes(b"\x7fELF")
    for file in place.iterdir():
        file.chmod(0o755)
    answer = subprocess.run(
        ["bash", "-c", PREFIXES + LIBRARIES_SCRIPT, "proof"],
        env={"PATH": "/usr/bin:/bin", "CMAKE_PREFIX_PATH": f"{tmp_path}/devel:/opt/ros/noetic"},
        capture_output=True,
        text=True,
        check=False,
    )
    assert (answer.returncode, told in answer.stdout) == (code, True), answer


@pytest.mark.parametrize(
    ("listed", "written", "failed"),
    [
        ("debian\nthing\n", {"thing/__init__.py": ""}, ""),
        ("thing\nextra\n", {"thing/__init__.py": "", "extra.py": "import no_such_module\n"}, ""),
        ("thing\nbroken\n", {"thing/__init__.py": "", "broken.py": "1 / 0\n"}, "import broken: "),
        ("other\nbroken\n", {"other/__init__.py": "", "broken.py": "import no_such_module\n"}, "import broken: "),
        ("thing\nextra\n", {"thing/__init__.py": "import no_such_module\n", "extra.py": ""}, "import thing: "),
        ("thing\n", {}, "import thing: ModuleNotFoundError"),
    ],
)
def test_what_a_package_lists_and_what_of_it_is_there(
    tmp_path: Path, listed: str, written: dict[str, str], failed: str
) -> None:
    """Debian's setuptools lists a folder of its build; what every Python package of ROS 2 asks for is setuptools."""
    metadata = {"thing.egg-info/PKG-INFO": "Metadata-Version: 2.1\nName: thing\nVersion: 1\n"}
    tree_of(tmp_path, {**written, **metadata, "thing.egg-info/top_level.txt": listed})
    words = [sys.executable, "-c", IMPORT_SCRIPT, "thing"]
    answer = subprocess.run(words, env={"PYTHONPATH": str(tmp_path)}, capture_output=True, text=True, check=False)
    assert (answer.returncode == 0) == (not failed), answer.stderr
    assert failed in answer.stderr


@pytest.mark.parametrize(
    ("files", "code"),
    [
        ((), 1),  # never built
        (("share/colcon-core/packages/empty", "share/empty/package.sh", "share/empty/hook/a.dsv"), 0),
        (("share/colcon-core/packages/empty", "share/empty/package.sh", "lib/empty/program"), 1),
        (("share/colcon-core/packages/empty", "share/empty/package.xml"), 1),
        (("share/ament_index/resource_index/packages/empty", "share/empty/package.xml"), 0),
    ],
)
def test_a_package_that_was_built_and_installs_nothing_is_told_and_does_not_fail(
    tmp_path: Path, files: tuple[str, ...], code: int
) -> None:
    """Its CMakeLists.txt returns where something optional is absent: no fault, where another package is found."""
    for file in ("full/share/ament_index/resource_index/packages/full", *(f"empty/{file}" for file in files)):
        (tmp_path / file).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / file).touch()

    def asked(*names: str) -> subprocess.CompletedProcess[str]:
        words = [sys.executable, "-c", AMENT_SCRIPT, *names]
        path = f"{tmp_path}/full:{tmp_path}/empty"
        return subprocess.run(words, env={"AMENT_PREFIX_PATH": path}, capture_output=True, text=True, check=False)

    answer = asked("full", "empty")
    assert answer.returncode == code, answer.stdout
    indexed = any("ament_index" in file for file in files)
    assert ("built and install nothing: empty\n" in answer.stdout) == (code == 0 and not indexed)
    assert asked("empty").returncode == (0 if indexed else 1)


@pytest.mark.parametrize(("ubuntu", "asked"), [("focal", ["attrdict", "numpy"]), ("jammy", ["numpy"])])
def test_what_this_python_cannot_import_is_not_imported(tmp_path: Path, ubuntu: str, asked: list[str]) -> None:
    config = f"format: 3\nbase:\n  ubuntu: {ubuntu}\n"
    (tmp_path / "main.py").write_text("import numpy\n")
    (tmp_path / "requirements.txt").write_text("numpy\nattrdict\n")
    (tmp_path / "roslab.yaml").write_text(config)
    proofs = plan_repository(tmp_path, branch=None).plan.proofs
    found = next(proof for proof in proofs if proof.name == "declared Python packages import")
    assert list(found.command[3:]) == asked


def test_a_framework_that_the_code_can_do_without_is_imported(tmp_path: Path) -> None:
    (tmp_path / "main.py").write_text("try:\n    import torch\nexcept ImportError:\n    torch = None\n")
    (tmp_path / "requirements.txt").write_text("numpy\ntorch\n")
    proofs = plan_repository(tmp_path, branch=None).plan.proofs
    assert "torch" in next(proof for proof in proofs if proof.name == "declared Python packages import").command


def test_what_stops_without_a_display_is_not_imported(tmp_path: Path) -> None:
    (tmp_path / "main.py").write_text("import numpy\n")
    (tmp_path / "requirements.txt").write_text("numpy\nPyAutoGUI\npynput\npygame\n")
    proofs = plan_repository(tmp_path, branch=None).plan.proofs
    found = next(proof for proof in proofs if proof.name == "declared Python packages import")
    assert list(found.command[3:]) == ["numpy", "pygame"]


TRIED = "try:\n    import RPi.GPIO as GPIO\nexcept (ImportError, RuntimeError):\n    GPIO = None\n"
SHOWN = "declared Python packages that the code can do without are installed"


@pytest.mark.parametrize(
    ("code", "without"),
    [
        (TRIED, ["RPi.GPIO"]),
        ("def blink():\n" + "".join(f"    {line}\n" for line in TRIED.splitlines()), ["RPi.GPIO"]),
        (TRIED.replace("GPIO = None", "raise SystemExit('no pins')"), []),
        (TRIED.replace("\n    GPIO = None", " raise SystemExit('no pins')"), []),
        (TRIED.replace("GPIO = None", "print('no pins'); sys.exit(1)"), []),
        (TRIED.replace("\n    GPIO = None", " GPIO = None"), ["RPi.GPIO"]),
        (TRIED.replace("try:\n", "try:\n# the pins\n"), ["RPi.GPIO"]),
        (TRIED + "def blink():\n    import RPi.GPIO\n", []),
        (TRIED.replace("try:\n    ", "").partition("except")[0], []),
        ("if True:\n    import RPi.GPIO\n", []),
    ],
)
def test_what_the_code_can_do_without_is_not_imported(tmp_path: Path, code: str, without: list[str]) -> None:
    """A library of a device's may be there, and stop where the device is not."""
    (tmp_path / "main.py").write_text("import numpy\n" + code)
    (tmp_path / "requirements.txt").write_text("numpy\nRPi.GPIO\n")
    proofs = plan_repository(tmp_path, branch=None).plan.proofs
    shown = [list(proof.command[3:]) for proof in proofs if proof.name == SHOWN]
    assert shown == ([without] if without else [])
    imported = next(proof for proof in proofs if proof.name == "declared Python packages import")
    assert ("RPi.GPIO" in imported.command) is not bool(without)
    assert all(proof.required for proof in proofs if proof.rung == 0)


@pytest.mark.parametrize("old", [False, True])
def test_each_of_several_packages_has_to_be_there(tmp_path: Path, *, old: bool) -> None:
    """``old``: as a Python before 3.8, which has no importlib.metadata and asks pip."""
    script = SHOW_SCRIPT.replace("from importlib import metadata", "raise ImportError") if old else SHOW_SCRIPT
    tree_of(tmp_path, {"thing.egg-info/PKG-INFO": "Metadata-Version: 2.1\nName: thing\nVersion: 1\n"})

    def asked(*names: str) -> subprocess.CompletedProcess[str]:
        words = [sys.executable, "-c", script, *names]
        return subprocess.run(words, env={"PYTHONPATH": str(tmp_path)}, capture_output=True, text=True, check=False)

    assert asked("thing").returncode == 0
    answer = asked("thing", "no-such-thing")
    assert answer.returncode == 1
    assert "not installed: no-such-thing\n" in answer.stderr


PROGRAM = "import os\nimport cv2\nimport sim.core\nif os.environ.get('X'):\n    import lazy\nimport bullet\n"


@pytest.mark.parametrize(
    ("readme", "found"),
    [
        (
            "```\npip install git+https://github.com/lab/sim\npip install lazy opencv-python\npython run.py\n```\n",
            ("cv2", "sim"),
        ),
        ("```\npython run.py\n```\n", ()),
        ("```\npip install git+https://github.com/lab/sim\npython other.py\n```\n", ()),
    ],
)
def test_what_the_command_imports_and_the_readme_installs_must_be_there(
    tmp_path: Path, readme: str, found: tuple[str, ...]
) -> None:
    """What no line installs is a guess, whose name may be wrong."""
    main = "if __name__ == '__main__':\n    print()\n"
    files = {"README.md": f"# Robot\n\n{readme}", "run.py": PROGRAM + main, "other.py": main}
    tree_of(tmp_path, files)
    proofs = plan_repository(tmp_path, branch=None).plan.proofs
    asked = [proof for proof in proofs if proof.name == "the default command finds the modules of its imports"]
    assert [proof.command[3:] for proof in asked] == ([found] if found else [])
    assert all(proof.required for proof in asked)


GUARD = "if __name__ == '__main__':\n    run()\n"
PROGRAMS = {
    "main.py": f"import numpy\nfrom lib.load import run\nif True:\n    import cv2\n{GUARD}",
    "lib/__init__.py": "",
    "lib/load.py": "import os\nimport foosim\nimport yaml\ndef run():\n    import scipy\n",
    "other.py": f"import pandas\n{GUARD}",
}
LINK = "## Install\nFollow [it](https://github.com/lab/foosim-api).\n"
STARTS = "```\n{}\n```\n"


@pytest.mark.parametrize(
    ("files", "found"),
    [
        ({"README.md": LINK + STARTS.format("python main.py")}, ("numpy", "foosim", "yaml")),
        ({"README.md": LINK + STARTS.format("python -m main")}, ("numpy", "foosim", "yaml")),
        (
            {
                "README.md": LINK + STARTS.format("bash run.sh"),
                "run.sh": "set -e\nCUDA_VISIBLE_DEVICES=0 python main.py \\\n --a b\n",
            },
            ("numpy", "foosim", "yaml"),
        ),
        ({"README.md": STARTS.format("python other.py")}, ("pandas",)),
        ({"README.md": STARTS.format("cd lib\npython go.py"), "lib/go.py": f"import pandas\n{GUARD}"}, ("pandas",)),
        ({"README.md": STARTS.format("python main.py"), "requirements.txt": "numpy\npyyaml\n"}, ("foosim",)),
        ({"README.md": STARTS.format("pip install numpy\npython main.py")}, ("foosim", "yaml")),
        ({"README.md": "# A\n", "main.py": "import numpy\n", "other.py": "import pandas\n"}, ()),  # nothing is started
        ({"README.md": STARTS.format("python main.py"), "roslab.yaml": "format: 3\nbase:\n  python: '2.7'\n"}, ()),
    ],
)
def test_what_guesses_bring_to_the_files_of_the_command_is_told_where_it_is_not_there(
    tmp_path: Path, files: dict[str, str], found: tuple[str, ...]
) -> None:
    tree_of(tmp_path, {**PROGRAMS, **files})
    proofs = plan_repository(tmp_path, branch=None).plan.proofs
    asked = [proof for proof in proofs if proof.name == "the default command finds what its files import"]
    assert [proof.command[3:] for proof in asked] == ([found] if found else [])
    assert not any(proof.required for proof in asked)


def test_modules_are_looked_for_and_not_imported(tmp_path: Path) -> None:
    (tmp_path / "gpu.py").write_text("raise RuntimeError\n")
    call = (sys.executable, "-c", FIND_SCRIPT, "gpu", "absent_module")
    found = subprocess.run(call, cwd=tmp_path, capture_output=True, text=True, check=False)
    assert (found.returncode, found.stdout, found.stderr) == (
        1,
        "found 1 of 2 modules\n",
        "no module absent_module\n",
    )
