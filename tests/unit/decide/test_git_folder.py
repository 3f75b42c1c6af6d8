"""Code that asks git where the repository begins finds a folder of git in the image."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.pipeline import plan_repository
from roslab.render.dockerfile import dockerfile

XML = (
    "<package><name>demo</name><buildtool_depend>ament_cmake</buildtool_depend>"
    "<export><build_type>ament_cmake</build_type></export></package>"
)
FOLDER = "/home/${NB_USER}/ws/src/demo"
MADE = f"RUN git init --quiet --template= {FOLDER} \\\n && GIT_AUTHOR_DATE="


@pytest.mark.parametrize(
    ("file", "code", "made"),
    [
        ("launch/a.launch.py", "top = check_output(['git', 'rev-parse', '--show-toplevel'])", True),
        ("core/a.py", "top = os.popen('git rev-parse --show-toplevel').read()", True),
        ("core/a.py", "repo = git.Repo(__file__, search_parent_directories=True)", True),
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
