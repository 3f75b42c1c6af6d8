"""All files together: which there are, where they point, and that each is known again as roslab's own."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Callable, Iterable
from dataclasses import replace
from pathlib import Path

import pytest

from roslab.plan.author_dockerfile import AuthorDockerfile
from roslab.plan.plan import Plan
from roslab.render import FILES, OutputFile, render_all
from roslab.render.output import generated
from roslab.render.script import script

Plans = Callable[..., Plan]


def _text(files: Iterable[OutputFile], path: str) -> str:
    return next(file.text for file in files if file.path == path)


def test_the_files_of_a_plan(plan: Plans) -> None:
    files = render_all(plan(), readme="# x", output_is_root=True, context="ignored")
    assert [file.path for file in files] == [file.path for file in FILES if file.goes_with != "bases"]
    assert {file.path for file in files if file.executable} == {"docker_build.sh", "docker_run.sh"}
    assert all(generated(file.path, file.text.encode()) for file in files)
    assert all(file.text.endswith("\n") and not file.text.endswith("\n\n") for file in files)
    assert "context=.\n" in _text(files, "docker_build.sh")


def test_elsewhere_the_scripts_name_the_repository(plan: Plans) -> None:
    files = render_all(plan(), readme=None, output_is_root=False, context="../repo")
    assert "context=../repo\n" in _text(files, "docker_build.sh")
    assert "context=../repo\n" in _text(files, "docker_run.sh")


def test_an_authors_dockerfile_gets_no_dockerfile(plan: Plans) -> None:
    authored = AuthorDockerfile(dockerfile="docker/Dockerfile", context=".")
    files = render_all(plan(author_dockerfile=authored), readme=None, output_is_root=True, context=".")
    left_out = {file.path for file in FILES} - {file.path for file in files}
    assert left_out == {"Dockerfile", "Dockerfile.dockerignore", "Dockerfile.bases"}
    assert "dockerfile=./docker/Dockerfile\n" in _text(files, "docker_build.sh")


def test_a_head_of_other_names_is_a_mistake_of_ours() -> None:
    with pytest.raises(KeyError):
        script("docker_build.sh", {"image": "x"})


def test_nothing_slow_is_imported_where_nothing_is_rendered() -> None:
    code = "import sys, roslab.render; sys.exit('nbformat' in sys.modules or 'markdown_it' in sys.modules)"
    scripts = Path(__file__).resolve().parents[3] / "scripts"
    subprocess.run([sys.executable, "-c", code], cwd=scripts, check=True)


@pytest.mark.parametrize("version", ["2.7", "3.7"])
def test_an_environment_of_conda_is_called_by_a_name_that_it_has(plan: Plans, version: str) -> None:
    python = replace(plan().python, manager="conda", version=version, pip=("numpy",), pip_guessed=("scipy",))
    files = render_all(plan(python=python), readme="# x", output_is_root=True, context="ignored")
    name = f"python{version[0]}"
    for part in (f'{name} -m pip install "$(pip-cache)" numpy', f'install-optional-pip {name} "$(pip-cache)" -- scipy'):
        assert part in _text(files, "Dockerfile")
