"""What a conda file has for pip gets the repairs of a list of requirements."""

from __future__ import annotations

import posixpath
from collections.abc import Callable
from pathlib import Path

import pytest

from roslab.decide.decision import Decision
from roslab.pipeline import plan_repository
from roslab.render.dockerfile import dockerfile
from trees import tree_of

Tree = Callable[[dict[str, str]], Decision]


def environment(*lines: str) -> str:
    listed = "".join(f"    - {line}\n" for line in lines)
    return f"name: a\nchannels: [conda-forge]\ndependencies:\n  - python=3.8\n  - pip\n  - pip:\n{listed}"


@pytest.mark.parametrize(
    ("lines", "off", "instead", "told"),
    [
        (("click", "scipy==1.5.2+computecanada"), "scipy", ["scipy==1.5.2"], "no index has scipy==1.5.2+computecanada"),
        (("torch==1.6.0", "torchvision==0.7.0a0+78ed10c"), "torchvision", ["torchvision"], "no index has torchvision"),
        (("pyserial", "serial"), "serial", [], "serial is left out: serial of pip's index is another package"),
        (("click", "tensorflow==2.16.1"), "tensorflow", ["tensorflow"], "needs Python 3.9, and the image has 3.8"),
        (("click", "'numpy @ file:///home/conda/numpy_1'"), "numpy", ["numpy"], ""),
        (("torch==1.8.0+cu111", "click"), "", [], ""),
        (("git+https://github.com/openai/CLIP.git", "click"), "", [], ""),
    ],
)  # fmt: skip
def test_a_line_that_pip_would_refuse_is_taken_out_and_another_stands_for_it(
    tree: Tree, lines: tuple[str, ...], off: str, instead: list[str], told: str
) -> None:
    decision = tree({"environment.yml": environment(*lines), "run.py": "import json\n"})
    python = decision.python
    assert python.conda_local == ((off,) if off else ())
    assert [each.text for each in python.conda_instead] == instead
    assert [each.text for each in python.pip] == instead
    assert python.conda_pip
    assert not told or [each for each in decision.warnings if told in each.message and each.line == 8]


def test_one_call_of_pip_chooses_it_and_the_rest_of_the_part(tmp_path: Path) -> None:
    (tmp_path / "environment.yml").write_text(environment("torch==1.6.0", "torchvision==0.7.0a0+78ed10c"))
    (tmp_path / "run.py").write_text("import torch\n")
    text = dockerfile(plan_repository(tmp_path).plan)
    assert "--upgrade --requirement environment.yml.pip torchvision" in text
    assert "Python packages that are declared" not in text


def test_the_only_line_of_a_part_is_installed_by_itself(tmp_path: Path) -> None:
    (tmp_path / "environment.yml").write_text(environment("scipy==1.5.2+computecanada"))
    (tmp_path / "run.py").write_text("import scipy\n")
    plan = plan_repository(tmp_path).plan
    assert (plan.python.conda_pip, plan.python.conda_instead, plan.python.pip) == (False, (), ("scipy==1.5.2",))
    assert "--requirement environment.yml.pip" not in dockerfile(plan)


def test_what_another_manifest_takes_from_git_is_taken_from_there(tree: Tree) -> None:
    address = "git+https://github.com/lab/tool-own@v1"
    files = {
        "environment.yml": environment("click", "tool-own==0.1"),
        "other/environment.yml": environment(f"'tool-own @ {address}'"),
        "run.py": "import tool_own\n",
    }
    python = tree(files).python
    assert python.conda_file == "environment.yml"
    assert [each.url for each in python.conda_instead] == [address]
    assert python.conda_local == ("tool-own",)


def test_the_project_of_the_tree_is_not_asked_of_the_index(tree: Tree) -> None:
    setup = "from setuptools import setup\nsetup(name='grasp-net', packages=['grasp_net'])\n"
    files = {"environment.yml": environment("click", "grasp-net==0.0.1", "-e ."), "setup.py": setup}
    decision = tree({**files, "grasp_net/__init__.py": ""})
    assert "grasp-net" in decision.python.conda_local
    assert any(each.message.startswith("grasp-net==0.0.1 is left out: it is a project") for each in decision.warnings)


@pytest.mark.parametrize(
    "text",
    [
        "dependencies: [python=3.8, pip, {pip: [click, pytorch3d]}]\n",
        "dependencies:\n  - python=3.8\n  - pip: [click,\n      pytorch3d]\n",
    ],
)
def test_lists_in_brackets_are_unfolded_before_lines_are_changed(tmp_path: Path, text: str) -> None:
    (tmp_path / "environment.yml").write_text(text)
    (tmp_path / "run.py").write_text("import click\n")
    plan = plan_repository(tmp_path).plan
    assert plan.python.conda_local == ("pytorch3d",)
    steps = ["unfold-lists /tmp/manifests/environment.yml", "take-pip-part /tmp", "(pytorch3d)"]
    found = [dockerfile(plan).index(step) for step in steps]
    assert found == sorted(found)


@pytest.mark.parametrize(("channel", "unfolded"), [("conda-forge", False), ("https://anaconda.org/a/b", True)])
def test_channels_in_brackets_are_unfolded_where_one_of_them_is_none(
    tmp_path: Path, channel: str, unfolded: bool
) -> None:
    (tmp_path / "environment.yml").write_text(f"channels: [{channel}]\ndependencies:\n  - python=3.8\n  - scipy\n")
    (tmp_path / "run.py").write_text("import scipy\n")
    assert ("unfold-lists" in dockerfile(plan_repository(tmp_path).plan)) is unfolded


@pytest.mark.parametrize(
    ("file", "list_", "line", "lines", "whole"),
    [
        ("environment.yml", "requirements.txt", "-r requirements.txt", "click\n./sub/knn\n", False),
        ("environment.yml", "requirements.txt", "--requirement ./requirements.txt", "click\n-e ./sub/knn\n", False),
        ("environment.yml", "requirements-dev.txt", "-r requirements-dev.txt", "click\n-e .\n", False),
        ("conda/environment.yml", "conda/requirements.txt", "-r requirements.txt", "click\nserial\npyserial\n", False),
        ("environment.yml", "requirements.txt", "-r requirements.txt", "click\nscipy>=1.5\n", True),
    ],
)
def test_a_list_that_pip_would_refuse_is_not_included_by_the_environment(
    tmp_path: Path, file: str, list_: str, line: str, lines: str, *, whole: bool
) -> None:
    setup = "from setuptools import setup\nsetup(name='{}', packages=['a'])\n"
    texts = {file: environment(line, "numpy"), list_: lines, "setup.py": setup.format("a"), "a/__init__.py": ""}
    tree_of(tmp_path, {**texts, "sub/knn/setup.py": setup.format("knn")})
    python = plan_repository(tmp_path, config_text=f"format: 3\nconda: {file}\n").plan.python
    assert (posixpath.basename(list_) in python.conda_local) is not whole
    assert ("click" in python.pip) is not whole
    assert ("sub/knn" in python.projects) is ("sub/knn" in lines)
    assert python.conda_pip
