"""The build context of a Dockerfile that copies a folder as a whole, told by what it gives pip of that."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.evidence.facts import AuthorDockerfile
from roslab.evidence.prose import author_dockerfile
from roslab.evidence.prose.installed_context import context_of
from roslab.repository.checkout import Repository

FILE = "lab/docker/gpu/Dockerfile"
TREE = (
    "lab/pyproject.toml",
    "lab/setup.py",
    "lab/requirements/gpu.txt",
    "lab/src/lab/main.py",
    "robot/setup.py",
    "README.md",
)


def read(tmp_path: Path, steps: str, more: tuple[str, ...] = ()) -> AuthorDockerfile:
    for path in (FILE, *TREE, *more):
        (tmp_path / path).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / path).write_text("")
    (tmp_path / FILE).write_text(f"FROM python:3.10\n{steps}\n")
    return author_dockerfile.read(Repository.open(tmp_path))[0]


@pytest.mark.parametrize(
    "steps",
    [
        'COPY . /app\nWORKDIR /app\nRUN pip install --upgrade pip && /opt/venv/bin/pip install ".[test, sim]"',
        "WORKDIR /app\nCOPY . .\nRUN python3 -m pip install -e .",
        "COPY . /app\nWORKDIR /app\nRUN python setup.py develop",
        "COPY . /app\nWORKDIR /app/requirements\nRUN pip install -r gpu.txt",
        "COPY . /app\nRUN pip install -r /app/requirements/gpu.txt",
        "COPY . /app\nRUN pip install /app",
    ],
)
def test_it_is_the_folder_above_that_has_what_pip_is_given(tmp_path: Path, steps: str) -> None:
    authored = read(tmp_path, steps)
    assert (authored.context, authored.copies_repository, authored.problem) == ("lab", True, None)


@pytest.mark.parametrize(
    ("steps", "more"),
    [
        ("COPY . /app\nWORKDIR /app\nRUN pip install .", ("setup.py",)),  # the root has it, too
        ("COPY . /app\nWORKDIR /app\nRUN pip install ./lab -r lab/requirements/gpu.txt", ()),
        ("COPY . /app\nWORKDIR /app\nRUN cd lab && pip install .", ()),
        ("COPY . /app\nWORKDIR /app\nRUN cd /opt/other && pip install .", ()),
        ("COPY . /app\nWORKDIR /opt/other\nRUN pip install .", ()),
        ("COPY . /app\nWORKDIR /app\nRUN pip install -r written.txt", ()),  # a step may write it
        ("COPY . /app\nWORKDIR /app\nRUN pip install numpy", ()),
        ("COPY lab/src /app\nWORKDIR /app\nRUN pip install .", ()),
    ],
)
def test_it_stays_the_root(tmp_path: Path, steps: str, more: tuple[str, ...]) -> None:
    assert read(tmp_path, steps, more).context == ""


def test_a_folder_whose_name_begins_with_a_dot_keeps_it(tmp_path: Path) -> None:
    for path in (".devcontainer/setup.py", "devcontainer/pyproject.toml"):
        (tmp_path / path).parent.mkdir()
        (tmp_path / path).write_text("")
    repository = Repository.open(tmp_path)
    assert context_of(repository, ".devcontainer", ["."]) == ".devcontainer"
    assert context_of(repository, ".devcontainer", ["setup.py"]) == ".devcontainer"
