"""conda environment files."""

from __future__ import annotations

from pathlib import Path

from roslab.evidence.python import conda
from roslab.repository.checkout import Repository

TEXT = """
name: robodiff
channels: [pytorch, conda-forge]
dependencies:
  - python=3.9.15
  - pytorch::pytorch=1.12.1
  - pip:
    - ray[default]==2.2.0
    - git+https://github.com/a/b.git
    - -r requirements.txt
    - --extra-index-url https://e.org
"""


def test_packages_and_pip(tmp_path: Path) -> None:
    (tmp_path / "conda_environment.yaml").write_text(TEXT)
    (environment,) = conda.read(Repository.open(tmp_path))
    assert (environment.name, environment.python) == ("robodiff", "3.9")
    assert [(p.name, p.release) for p in environment.packages] == [("python", "3.9.15"), ("pytorch", "1.12.1")]
    assert [(asked.written, asked.role, asked.line) for asked in environment.requirements] == [
        ("ray[default]==2.2.0", "", 8),
        ("git+https://github.com/a/b.git", "", 9),
        ("requirements.txt", "file", 10),
        ("--extra-index-url https://e.org", "option", 11),
    ]


def test_other_yaml_and_hostile_yaml_are_passed_over(tmp_path: Path) -> None:
    (tmp_path / "environment.yaml").write_text("dependencies: " + "[" * 50_000)
    (tmp_path / "env_bomb.yml").write_text("a: &a [x]\nb: &b [*a, *a]\ndependencies: {k: *b}\n")
    (tmp_path / "environments.yml").write_text("world: empty\n")
    (tmp_path / "env_deep.yml").write_text("dependencies:\n" + "- " * 20_000 + "x\n")
    assert conda.read(Repository.open(tmp_path)) == ()
