"""Whose the environment of Python is in an image."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.pipeline import plan_repository
from roslab.render.dockerfile import dockerfile
from trees import tree_of

PROGRAM = {"main.py": "import numpy\n", "requirements.txt": "numpy\n"}
PROJECT = {"pyproject.toml": '[project]\nname = "a"\nversion = "1"\n[build-system]\nrequires = ["setuptools"]\n'}
CONDA = {"environment.yml": "name: a\nchannels: [conda-forge]\ndependencies: [python=3.9, numpy]\n", "main.py": "\n"}
NODE = {
    "package.xml": "<package><name>a</name><buildtool_depend>catkin</buildtool_depend></package>",
    "CMakeLists.txt": "cmake_minimum_required(VERSION 3.0)\nproject(a)\nfind_package(catkin REQUIRED)\n",
}
OWNED = 'RUN find {} -type d -exec chown "${{NB_UID}}:${{NB_UID}}" {{}} +\n'


@pytest.mark.parametrize(
    ("files", "folder"),
    [
        (PROGRAM, "/opt/venv"),
        (PROGRAM | PROJECT, "/opt/venv"),
        (CONDA, "/opt/conda"),
        (NODE, None),
    ],
)
def test_an_environment_is_the_users_after_all_that_root_installs(
    tmp_path: Path, files: dict[str, str], folder: str | None
) -> None:
    tree_of(tmp_path, files)
    text = dockerfile(plan_repository(tmp_path).plan)
    if folder is None:
        assert "-type d -exec chown" not in text
        return
    before, owned, after = text.partition(OWNED.format(folder))
    assert owned, "the environment stays root's"
    assert before.rsplit("\nUSER ", 1)[1].startswith("root\n")
    assert " -m pip install" not in after
    assert "micromamba create" not in after
