"""A Pipfile says what the image installs, in the releases of its lock."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.evidence.python.project import read
from roslab.pipeline import plan_repository
from roslab.plan.plan import Plan
from roslab.repository.checkout import Repository

PIPFILE = """\
[[source]]
url = "https://index.example/simple"
name = "main"

[packages]
numpy = "==1.19.5"
opencv-python = "*"
gym = {git = "https://github.com/openai/gym.git", ref = "v0.21.0"}
"pyyaml" = {version = ">=5", extras = [], markers = "python_version > '3'"}
demo = {editable = true, path = "."}

[dev-packages]
pytest = "*"

[requires]
python_version = "3.8"
"""
LOCK = """\
{
    "default": {
        "numpy": {"version": "==1.19.5"},
        "opencv-python": {
            "markers": "python_version >= '3.6'",
            "version": "==4.5.1.48"
        },
        "gym": {"git": "https://github.com/openai/gym.git", "ref": "abc"}
    },
    "develop": {"pytest": {"version": "==6.0"}}
}
"""
MAIN = "import numpy\nif __name__ == '__main__':\n    print('a')\n"


def plan_of(folder: Path, **files: str) -> Plan:
    for path, text in {"main.py": MAIN, "Pipfile": PIPFILE, **files}.items():
        (folder / path).write_text(text)
    return plan_repository(folder).plan


def installed(plan: Plan) -> set[str]:
    return {*plan.python.pip}


def test_what_pipenv_installs(tmp_path: Path) -> None:
    plan = plan_of(tmp_path)
    gym = "gym @ git+https://github.com/openai/gym.git@v0.21.0"
    assert installed(plan) == {"numpy==1.19.5", "opencv-python", gym, 'pyyaml>=5; python_version > "3"'}
    assert plan.python.version == "3.8"


def test_a_package_is_told_at_its_own_line(tmp_path: Path) -> None:
    (tmp_path / "Pipfile").write_text("[packages]\nnumpy-stl = '*'\n'numpy' = '*'\n")
    found = {each.name: each.line for each in read(Repository.open(tmp_path))[0].requirements}
    assert found == {"numpy-stl": 2, "numpy": 3}


def test_the_lock_tells_the_releases(tmp_path: Path) -> None:
    plan = plan_of(tmp_path, **{"Pipfile.lock": LOCK})
    assert "opencv-python==4.5.1.48" in plan.python.bounds


@pytest.mark.parametrize("lock", ["{", "[]", '{"default": 3}', '{"default": {"numpy": 3}}', "[" * 100_000])
def test_a_lock_that_cannot_be_read_tells_nothing(tmp_path: Path, lock: str) -> None:
    assert "opencv-python==4.5.1.48" not in plan_of(tmp_path, **{"Pipfile.lock": lock}).python.bounds


def test_a_file_that_only_configures_tools_lies_beside_it(tmp_path: Path) -> None:
    assert "numpy==1.19.5" in installed(plan_of(tmp_path, **{"pyproject.toml": "[tool.black]\nline-length = 100\n"}))


def test_a_list_for_pip_beside_it_counts_alone(tmp_path: Path) -> None:
    assert "numpy==1.19.5" not in installed(plan_of(tmp_path, **{"requirements.txt": "numpy==1.21.0\n"}))


@pytest.mark.parametrize(
    "text", ["[packages\n", "packages = 3\n", "[packages]\nnumpy = 3\n", "[packages]\nnumpy = {extras = 3}\n"]
)
def test_a_pipfile_that_cannot_be_read_asks_for_nothing(tmp_path: Path, text: str) -> None:
    assert installed(plan_of(tmp_path, Pipfile=text)) <= {"numpy"}
