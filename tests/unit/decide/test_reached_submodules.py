"""A submodule that nobody has seen and that plain Python imports by its folder: Python looks there behind all else."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

from roslab.pipeline import plan_repository
from roslab.render.layers.python_projects import projects
from trees import linked

COMMIT = "0123456789012345678901234567890123456789"
MODULES = '[submodule "a"]\n\tpath = data/brumby\n\turl = https://github.com/lab/brumby-models.git\n'
PLAY = "import numpy\nfrom brumby.models import load\nif __name__ == '__main__':\n    load()\n"


@pytest.mark.parametrize(
    ("there", "imported"),
    [
        ("models/__init__.py", "brumby.models"),
        ("brumby/models/__init__.py", "brumby.models"),
        ("setup.py", "brumby"),
    ],
)
def test_the_module_is_found_from_its_folder_and_from_above(tmp_path: Path, there: str, imported: str) -> None:
    files = {"play.py": PLAY, "requirements.txt": "numpy\n", "README.md": "```\npython play.py\n```\n"}
    linked(tmp_path / "tree", {**files, ".gitmodules": MODULES}, COMMIT, "data/brumby")
    plan = plan_repository(tmp_path / "tree").plan
    assert plan.python.imported == ("data/brumby", "data/brumby/brumby")
    block = projects(plan)
    command = block[block.index("if [ -e") :]
    python, site, place = tmp_path / "bin/python3", tmp_path / "site", tmp_path / "src"
    module = place / "data/brumby" / there
    for folder in (python.parent, site, module.parent):
        folder.mkdir(parents=True)
    module.touch()
    python.write_text(f'#!/bin/sh\nif [ "$1" = -c ]; then echo {site}; else echo "pip: $*"; fi\n', encoding="utf-8")
    python.chmod(0o755)
    env = {"PATH": f"{python.parent}:{os.environ['PATH']}"}
    subprocess.run(["bash", "-euc", f"pip-cache() {{ :; }}\n{command}"], cwd=place, env=env, check=True)
    (added,) = site.glob("*.pth")
    lines = added.read_text(encoding="utf-8").split()
    assert lines == [f"{place}/data/brumby", f"{place}/data"]
    look = f"import sys; sys.path += {lines}; import {imported}"
    subprocess.run([sys.executable, "-Ic", look], check=True)
