"""An old torch gets a setuptools that it can read, whoever makes the environment."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.pipeline import plan_repository
from roslab.render.dockerfile import dockerfile

CONDA = "name: a\ndependencies:\n  - python=3.8\n  - pytorch=1.10.1\n"
BY_CUDA = "```\nconda install pytorch pytorch-cuda=11.6 -c pytorch -c nvidia\n```\n"


@pytest.mark.parametrize(
    ("files", "setuptools"),
    [
        ({"requirements.txt": "torch==1.10.1\n"}, "setuptools<59.6"),
        ({"requirements.txt": "torch==1.13.1\n"}, "setuptools<70"),
        ({"requirements.txt": "torch==2.2.0\n"}, ""),
        ({"requirements.txt": "torch==1.10.1\nsetuptools==58.0\n"}, ""),
        ({"requirements.txt": "torch\n"}, ""),
        ({"environment.yml": CONDA}, "setuptools<59.6"),
        ({"environment.yml": CONDA + "  - setuptools=58\n"}, ""),
        ({"requirements.txt": "torch==1.10.1\n", "README.md": "Needs Python 3.7.\n"}, "setuptools<59.6"),
        ({"README.md": BY_CUDA}, "setuptools<70"),
    ],
)
def test_an_old_torch(tmp_path: Path, files: dict[str, str], setuptools: str) -> None:
    for name, text in {**files, "run.py": "import torch\n"}.items():
        (tmp_path / name).write_text(text, encoding="utf-8")
    plan = plan_repository(tmp_path).plan
    assert plan.python.setuptools == setuptools
    text = dockerfile(plan)
    assert setuptools in text
    if setuptools:
        made = "micromamba create" if plan.python.manager == "conda" else "-m venv"
        assert text.index(made) < text.index(f"'{setuptools}'") < text.index("CMD")
        assert f"\n{setuptools}\n" not in text, "it is no constraint"
