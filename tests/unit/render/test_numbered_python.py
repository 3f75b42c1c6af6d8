"""A page may start ``python3.8``: in the image it is the virtual environment's, which has the packages."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.pipeline import plan_repository
from roslab.render.dockerfile import dockerfile


@pytest.mark.parametrize(("ubuntu", "python", "linked"), [("20.04", "3.8", True), ("22.04", "3.10", False)])
def test_an_older_venv_has_the_name_with_the_number(tmp_path: Path, ubuntu: str, python: str, *, linked: bool) -> None:
    (tmp_path / "requirements.txt").write_text("numpy\n", encoding="utf-8")
    (tmp_path / "play.py").write_text("import numpy\nif __name__ == '__main__':\n    print(numpy)\n", encoding="utf-8")
    page = f"# Play\nUbuntu {ubuntu}, Python {python}\n```\npython{python} play.py\n```\n"
    (tmp_path / "README.md").write_text(page, encoding="utf-8")
    text = dockerfile(plan_repository(tmp_path).plan)
    assert f'CMD ["python{python}", "play.py"]' in text
    link = f"ln --symbolic python3 /opt/venv/bin/python{python}"
    assert ("--without-pip /opt/venv" in text, link in text) == (True, linked)
