"""Projects that poetry-core or flit_core refuses to install: what they need is installed all the same."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
POETRY = """[tool.poetry]
name = "my-paper"
{more}
[tool.poetry.dependencies]
python = "^3.9"
numpy = "^1.24"
[build-system]
requires = ["poetry-core"]
build-backend = "poetry.core.masonry.api"
"""
FLIT = """[build-system]
requires = ["flit_core"]
build-backend = "flit_core.buildapi"
[project]
name = "Docs"
dynamic = ["version", "description"]
{more}
"""
README = "# Paper\n## Usage\n```\npoetry install\npython train.py\n```\n"


@pytest.mark.parametrize(
    ("project", "files", "installed"),
    [
        (POETRY.format(more="package-mode = false"), {}, False),
        (POETRY.format(more="package-mode = false"), {"my_paper/__init__.py": ""}, False),
        (POETRY.format(more=""), {}, False),
        (POETRY.format(more=""), {"my_paper/main.cpp": ""}, False),
        (POETRY.format(more=""), {"my_paper/__init__.py": ""}, True),
        (POETRY.format(more=""), {"src/my_paper/core.py": ""}, True),
        (POETRY.format(more=""), {"my_paper.py": ""}, True),
        (POETRY.format(more="packages = [{include = 'core'}]"), {"core/__init__.py": ""}, True),
        (FLIT.format(more=""), {}, False),
        (FLIT.format(more=""), {"docs/__init__.py": ""}, True),
        (FLIT.format(more='[tool.flit.module]\nname = "core"'), {"core/__init__.py": ""}, True),
    ],
    ids=[
        "mode",
        "mode-with-module",
        "poetry",
        "poetry-without-python",
        "package",
        "src",
        "file",
        "packages",
        "flit",
        "flit-package",
        "flit-name",
    ],
)
def test_what_a_backend_refuses_is_not_installed(
    tree: Tree, project: str, files: dict[str, str], installed: bool
) -> None:
    decision = tree({"pyproject.toml": project, "train.py": "import numpy\n", "README.md": README, **files})
    assert bool(decision.python.projects) is installed
    if "numpy" in project and not installed:
        asked = [*decision.python.pip, *decision.python.pip_guessed]
        assert [str(each.specifier) for each in asked if each.key == "numpy"] == ["<2,>=1.24"]


def test_what_it_declares_must_install(tree: Tree) -> None:
    found = tree({"pyproject.toml": POETRY.format(more=""), "train.py": "import numpy\n", "README.md": README})
    assert [each.written for each in found.python.pip] == ["numpy>=1.24,<2"]
    assert found.python.pip_guessed == ()
    said = next(each for each in found.reasons if each.answer == "numpy>=1.24,<2" and "declares it" in each.reason)
    assert (said.file, said.line) == ("pyproject.toml", 6)


def test_a_requirements_file_beside_it_is_the_one_that_counts(tree: Tree) -> None:
    files = {"pyproject.toml": POETRY.format(more=""), "requirements.txt": "scipy\n", "train.py": "import numpy\n"}
    found = tree({**files, "README.md": README})
    assert found.python.requirements == ("requirements.txt",)
    assert found.python.pip == ()
    assert [each.key for each in found.python.pip_guessed] == ["numpy"]


def test_its_lock_is_heeded(tree: Tree) -> None:
    lock = '[[package]]\nname = "numpy"\nversion = "1.24.3"\n\n[[package]]\nname = "scipy"\nversion = "1.10.1"\n'
    files = {"pyproject.toml": POETRY.format(more=""), "poetry.lock": lock, "train.py": "import numpy\n"}
    assert [each.written for each in tree({**files, "README.md": README}).python.bounds] == ["numpy==1.24.3"]


def test_a_torch_of_the_lock_for_the_cuda_of_the_image(tree: Tree) -> None:
    project = POETRY.format(more="").replace('numpy = "^1.24"', 'torch = "^1.7"').replace('"^3.9"', '">=3.8,<3.10"')
    lock = '[[package]]\nname = "torch"\nversion = "1.10.1"\n'
    files = {"pyproject.toml": project, "poetry.lock": lock, "train.py": "import torch\ntorch.zeros(1).cuda()\n"}
    python = tree({**files, "README.md": README}).python
    assert [each.written for each in python.bounds] == ["torch==1.10.1", "numpy<2"]
    assert python.options == ("--find-links https://download.pytorch.org/whl/cu113/torch_stable.html",)


def test_what_it_needs_for_an_extra_is_declared_too(tree: Tree) -> None:
    more = POETRY.format(more="") + '[tool.poetry.extras]\nsim = ["acme-sim"]\n'
    more = more.replace('numpy = "^1.24"', 'numpy = "^1.24"\nacme-sim = {version = "^1.0", optional = true}')
    code = "import numpy\nimport acme_sim\nimport other_thing\n"
    found = tree({"pyproject.toml": more, "train.py": code, "README.md": README})
    assert not [each for each in (*found.python.pip, *found.python.pip_guessed) if each.key == "acme-sim"]
    (told,) = [each.message for each in found.warnings if "no table" in each.message]
    assert told.startswith("other_thing is imported")


FLAT = "[project]\nname='demo'\nversion='1'\ndependencies=['einops']\n"


@pytest.mark.parametrize(
    ("text", "files", "refused"),
    [
        (FLAT, ("core/a.py", "planners/b.py"), True),
        (FLAT, ("core/a.py", "models/arm.xml"), True),
        (FLAT, ("one.py", "two.py"), True),
        (FLAT, ("core/a.py", "tests/b.py", "docs/a.md", "my-data/c.csv", "one.py", "two.py"), False),
        (FLAT, ("src/core/a.py", "src/planners/b.py", "data/c.csv", "more/d.csv"), False),
        (FLAT, ("core/a.py", "planners/b.py", "setup.cfg"), False),
        (f"{FLAT}[tool.setuptools]\npackages=['core', 'planners']\n", ("core/a.py", "planners/b.py"), False),
        (f"{FLAT}[build-system]\nbuild-backend='setuptools.build_meta'\n", ("core/a.py", "planners/b.py"), True),
        (f"{FLAT}[build-system]\nbuild-backend='hatchling.build'\n", ("core/a.py", "planners/b.py"), False),
    ],
)
def test_setuptools_takes_no_one_of_several_packages(
    tree: Tree, text: str, files: tuple[str, ...], refused: bool
) -> None:
    python = tree({"pyproject.toml": text, **dict.fromkeys(files, "")}).python
    assert python.projects == (() if refused else (".",))
    assert [each.written for each in python.pip] == (["einops"] if refused else [])
