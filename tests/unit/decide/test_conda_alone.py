"""What only conda has and a page installs by it comes from conda, with the Python of the page."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from roslab.decide.decision import Decision
from roslab.pipeline import plan_repository
from roslab.render.dockerfile import dockerfile

Tree = Callable[[dict[str, str]], Decision]
PAGE = "# Install\n```\nconda create -n a python=3.8 -y\n{}\n```\n"
BY_CONDA = "conda install habitat-sim=0.2.2 -c conda-forge -c aihabitat"
CODE = {"run.py": "import numpy\nimport habitat_sim\n", "requirements.txt": "numpy==1.22.0\n"}


@pytest.mark.parametrize("files", [{}, {"install.bash": f"{BY_CONDA}\npip install -r requirements.txt\n"}])
def test_a_page_installs_it_by_conda(tree: Tree, files: dict[str, str]) -> None:
    page = PAGE.format("bash install.bash" if files else BY_CONDA)
    decision = tree({**CODE, **files, "README.md": page})
    python = decision.python
    assert (python.manager, python.version) == ("conda", "3.8")
    assert python.conda_specs == ("python=3.8", "habitat-sim=0.2.2")
    assert python.conda_channels == ("conda-forge", "aihabitat")
    assert python.requirements == ("requirements.txt",)
    assert decision.platforms == ("linux/amd64",)
    assert not any("habitat" in each.message for each in decision.warnings)


@pytest.mark.parametrize("install", [BY_CONDA, "pip install habitat-sim"])
def test_for_another_python_it_is_told_and_left_out(tree: Tree, install: str) -> None:
    page = f"# Install\nPython 3.8\n```\n{install}\n```\n"
    decision = tree({**CODE, "README.md": page})
    assert decision.python.conda_specs == ()
    assert [each.line for each in decision.warnings if "pip cannot install habitat-sim" in each.message] == [4]


def test_the_environment_is_created_with_it(tmp_path: Path) -> None:
    for name, text in {**CODE, "README.md": PAGE.format(BY_CONDA)}.items():
        (tmp_path / name).write_text(text, encoding="utf-8")
    text = dockerfile(plan_repository(tmp_path).plan)
    assert "--channel conda-forge --channel aihabitat" in text
    assert "      habitat-sim=0.2.2 \\\n" in text


FROM_CONDA = {"run.py": "import yarp\nimport bipedal_locomotion_framework as blf\n"}


def test_the_channel_of_an_import_that_conda_alone_has_is_told(tree: Tree) -> None:
    decision = tree({**FROM_CONDA, "requirements.txt": "numpy\n"})
    told = [each for each in decision.warnings if "from conda-forge, by an environment file" in each.message]
    assert [(each.message.split()[3], each.line) for each in told] == [
        ("yarp,", 1),
        ("bipedal_locomotion_framework,", 2),
    ]


def test_nothing_is_told_where_an_environment_brings_it(tree: Tree) -> None:
    environment = "name: a\nchannels: [conda-forge]\ndependencies: [python=3.10, yarp, bipedal-locomotion-framework]\n"
    decision = tree({**FROM_CONDA, "environment.yml": environment})
    assert not [each for each in decision.warnings if "the code imports" in each.message]
