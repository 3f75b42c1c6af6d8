"""Links stand where scripts or launch files name a Python of the author's machine."""

from __future__ import annotations

from pathlib import Path

from roslab.pipeline import plan_repository
from roslab.render.dockerfile import dockerfile

PACKAGE = "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend></package>"


def test_the_link_is_made_before_the_workspace(tmp_path: Path) -> None:
    files = {
        "package.xml": PACKAGE,
        "CMakeLists.txt": "project(demo)\nfind_package(catkin REQUIRED)\n",
        "scripts/a.py": "#!/home/somebody/venv/bin/python\n",
        "launch/a.launch": '<launch><node pkg="demo" type="a.py" name="a"/></launch>',
        "README.md": "ROS Noetic\n",
    }
    for path, written in files.items():
        (tmp_path / path).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / path).write_text(written, encoding="utf-8")
    text = dockerfile(plan_repository(tmp_path).plan)
    made = "mkdir --parents /home/somebody/venv/bin"
    link = 'ln --symbolic --force "$(command -v python3)" /home/somebody/venv/bin/python'
    assert text.index(made) < text.index(link) < text.index("catkin_make -j")
