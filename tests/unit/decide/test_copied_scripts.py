"""Scripts that CMake copies among the programs of ROS 2 get the right to be executed, which a copy does not have."""

from __future__ import annotations

import shutil
import subprocess
from pathlib import Path

import pytest

from hanging import ends
from roslab.pipeline import plan_repository
from roslab.render.dockerfile import dockerfile

FOLDER = "install(DIRECTORY scripts/ DESTINATION lib/${PROJECT_NAME})"
SCRIPT = "#!/usr/bin/env python3\nimport rclpy\n"


def _dockerfile(root: Path, install: str, **more: str) -> str:
    root = root / "demo"
    files = {
        "package.xml": "<package><name>demo</name><buildtool_depend>ament_cmake</buildtool_depend>"
        "<depend>rclpy</depend><export><build_type>ament_cmake</build_type></export></package>",
        "CMakeLists.txt": f"project(demo)\nfind_package(ament_cmake REQUIRED)\n{install}\nament_package()\n",
        "README.md": "ROS 2 Humble\n",
        "scripts/eye.py": SCRIPT,
        "scripts/eye.yaml": "eye: 1\n",
        "scripts/deep/ear": SCRIPT,
        "config/eye.py": SCRIPT,
        **more,
    }
    for name, text in files.items():
        (root / name).parent.mkdir(parents=True, exist_ok=True)
        (root / name).write_text(text, encoding="utf-8")
    return dockerfile(plan_repository(root).plan)


@pytest.mark.parametrize(
    ("install", "names"),
    [
        (FOLDER, "-name ear -o -name eye.py"),
        (FOLDER.replace("scripts/", "${CMAKE_CURRENT_SOURCE_DIR}/scripts"), "-name ear -o -name eye.py"),
        ("install(FILES scripts/eye.py\n  scripts/eye.yaml DESTINATION lib/demo)", "-name eye.py"),
        (FOLDER.replace("DESTINATION", "USE_SOURCE_PERMISSIONS DESTINATION"), ""),
        (FOLDER.replace(")", " FILE_PERMISSIONS OWNER_EXECUTE)"), ""),
        (FOLDER.replace("lib/", "share/"), ""),
        (FOLDER.replace("scripts/", "launch"), ""),
        ("install(PROGRAMS scripts/eye.py DESTINATION lib/${PROJECT_NAME})", ""),
        (f"# {FOLDER}", ""),
    ],
)
def test_they_get_it_once_they_are_installed(tmp_path: Path, install: str, names: str) -> None:
    step = f"find ../built/install -path '*/lib/*' -xtype f \\( {names} \\) -exec chmod +x {{}} +"
    text = _dockerfile(tmp_path, install)
    assert (step in text) is bool(names)
    assert ("chmod +x {} +" in text) is bool(names)
    assert not names or text.index("colcon build") < text.index(step)


def test_a_file_below_the_project_installs_from_its_folder(tmp_path: Path) -> None:
    install = FOLDER.replace("scripts/", "${PROJECT_SOURCE_DIR}/scripts/deep/")
    assert "\\( -name ear \\)" in _dockerfile(tmp_path, "add_subdirectory(src)", **{"src/CMakeLists.txt": install})


@pytest.mark.parametrize("config", ["build_args: [--install-base, /opt/demo]", "build_args: [--merge-install]"])
def test_where_colcon_installs_elsewhere_nothing_is_looked_for(tmp_path: Path, config: str) -> None:
    text = _dockerfile(tmp_path, FOLDER, **{"roslab.yaml": f"format: 3\n{config}\n"})
    assert ("built/install -path" in text) is ("merge" in config)


@pytest.mark.parametrize("apart", [True, False])
def test_the_step_does_so(tmp_path: Path, *, apart: bool) -> None:
    """What is compiled in a stage of its own is moved once it is compiled."""
    text = _dockerfile(tmp_path, FOLDER, **({} if apart else {"roslab.yaml": 'format: 3\ncustom: ["true"]\n'}))
    step = next(line for line in text.splitlines() if "-exec chmod" in line).removeprefix(" && ").rstrip(" \\")
    installed = tmp_path / ("built/install" if apart else "ws/install")
    (tmp_path / "ws").mkdir()
    for name in ("demo/lib/demo/eye.py", "demo/share/demo/eye.py"):
        (installed / name).parent.mkdir(parents=True)
        (installed / name).write_text(SCRIPT)
        (installed / name).chmod(0o644)
    (tmp_path / "ear").write_text(SCRIPT)
    (tmp_path / "ear").chmod(0o644)
    (installed / "demo/lib/demo/ear").symlink_to(tmp_path / "ear")
    shell = shutil.which("bash") or pytest.skip("bash is not here")
    subprocess.run([shell, "-ec", step], cwd=tmp_path / "ws", check=True)
    made = [path.relative_to(installed).as_posix() for path in installed.rglob("eye.py") if path.stat().st_mode & 0o100]
    assert made == ["demo/lib/demo/eye.py"]
    assert (tmp_path / "ear").stat().st_mode & 0o100


def test_a_file_that_is_one_long_call_ends(tmp_path: Path) -> None:
    with ends():
        _dockerfile(tmp_path, "install(FILES a\n" * 2_000)
