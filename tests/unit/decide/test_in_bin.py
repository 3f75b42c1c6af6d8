"""Programs of ROS 2 packages of Python are installed where ros2 looks for them."""

from __future__ import annotations

import shutil
import subprocess
from pathlib import Path

import pytest

from roslab.pipeline import plan_repository
from roslab.render.dockerfile import dockerfile

SETUP = (
    "from setuptools import setup\n"
    "setup(name='demo', packages=['demo'], entry_points={'console_scripts': ['a = demo.a:main']})\n"
)
LAUNCH = "LaunchDescription([Node(package='demo', executable='a')])\n"
SAID = "[develop]\nscript_dir=$base/lib/demo\n[install]\ninstall_scripts=$base/lib/demo\n"


def _dockerfile(root: Path, more: dict[str, str], tool: str = "ament_python") -> str:
    files = {
        "src/demo/package.xml": "<package><name>demo</name><depend>rclpy</depend>"
        f"<export><build_type>{tool}</build_type></export></package>",
        "src/demo/setup.py": SETUP,
        "src/demo/demo/__init__.py": "",
        "src/demo/demo/a.py": "import rclpy\n\n\ndef main():\n    pass\n",
        "README.md": "ROS 2 Humble\n\n```bash\nros2 run demo a\n```\n",
        **more,
    }
    for name, text in files.items():
        (root / name).parent.mkdir(parents=True, exist_ok=True)
        (root / name).write_text(text, encoding="utf-8")
    return dockerfile(plan_repository(root).plan)


@pytest.mark.parametrize(
    ("more", "told"),
    [
        ({}, True),
        ({"src/demo/setup.cfg": "[metadata]\nname = demo"}, True),
        ({"src/demo/setup.cfg": SAID}, False),
        ({"src/demo/setup.cfg": "[install]\nuser = 1\n"}, False),  # a section that is named twice is refused
        (
            {"src/demo/setup.py": SETUP.replace("packages", "options={'install': {'install_scripts': 'x'}}, packages")},
            False,
        ),
        ({"src/demo/setup.py": SETUP.replace("packages", "data_files=[('lib/demo', ['demo/a.py'])], packages")}, False),
        ({"src/demo/setup.py": SETUP.replace("console_scripts", "rqt_plugins")}, False),
        ({"README.md": "ROS 2 Humble\n\n```bash\na\n```\n"}, False),  # it is called by its name, from bin
        ({"README.md": "ROS 2 Humble\n", "src/demo/launch/a.launch.py": LAUNCH}, True),
        ({"README.md": "ROS 2 Humble\n", "run.sh": "ros2 run demo a\n"}, True),
    ],
)
def test_where_nothing_says_it(tmp_path: Path, more: dict[str, str], *, told: bool) -> None:
    assert ("install_scripts=" in _dockerfile(tmp_path, more)) is told


def test_cmake_installs_its_own(tmp_path: Path) -> None:
    more = {"src/demo/CMakeLists.txt": "project(demo)\nfind_package(ament_cmake REQUIRED)\nament_package()\n"}
    assert "install_scripts=" not in _dockerfile(tmp_path, more, "ament_cmake")


def test_the_step_does_so(tmp_path: Path) -> None:
    text = _dockerfile(tmp_path / "demo", {})
    assert text.index("install_scripts=") < text.index("colcon build --")
    step = next(line for line in text.splitlines() if "install_scripts=" in line).removeprefix(" && ").rstrip(" \\")
    step = step.replace("/home/${NB_USER}/ws/", "")
    shell = shutil.which("bash") or pytest.skip("bash is not here")
    (tmp_path / "src/demo").mkdir(parents=True)
    (tmp_path / "src/demo/setup.cfg").write_text("[metadata]\nname = demo")
    subprocess.run([shell, "-ec", step], cwd=tmp_path, check=True)
    assert (tmp_path / "src/demo/setup.cfg").read_text() == f"[metadata]\nname = demo\n{SAID}"
