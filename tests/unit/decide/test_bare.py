"""What is installed from git without its own list, which names what pip cannot install, and what it needs beside."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision
from roslab.decide.python.bare import bare
from roslab.values.requirement_line import stated

Tree = Callable[[dict[str, str]], Decision]
GIT = "argoverse @ git+https://github.com/argoverse/argoverse-api"
OLD = "git+https://github.com/argoai/argoverse-api.git"
"""The same repository at its first owner's, to whom most pages link."""
CODE = {"run.py": "import numpy\nfrom argoverse.map_representation.map_api import ArgoverseMap\n"}


def names(decision: Decision, *, declared: bool = False) -> set[str]:
    return {each.key for each in (decision.python.pip if declared else decision.python.pip_guessed)}


def lines(decision: Decision) -> list[str]:
    return [each.written for each in decision.python.pip_guessed if bare(each)]


@pytest.mark.parametrize(
    ("line", "taken"),
    [
        (GIT, True),
        (OLD, True),
        (f"{OLD}@v1.1#egg=argoverse", True),
        ("argoverse", True),
        ("git+https://github.com/argoverse/av2-api", False),
        ("argoverse @ https://example.org/argoverse-1.1-py3-none-any.whl", False),
        ("git+https://github.com/facebookresearch/detectron2", False),  # its own list can be installed
        ("detectron2", False),
    ],
)
def test_it_is_known_by_its_name_and_by_its_repository(line: str, *, taken: bool) -> None:
    assert bool(bare(stated(line))) == taken


@pytest.mark.parametrize(
    ("page", "line"),
    [("# A\n", GIT), (f"```\npip install {OLD}\n```\n", OLD), ("```\npip install argoverse\n```\n", GIT)],
)
def test_what_its_modules_import_is_guessed_with_it(tree: Tree, page: str, line: str) -> None:
    decision = tree({**CODE, "README.md": page})
    assert lines(decision) == [line]
    assert {"numpy", "descartes", "colour", "shapely"} <= names(decision)
    assert not [each for each in decision.warnings if "argoverse" in each.message]


def test_what_is_declared_or_has_another_build_is_not_asked_for_again(tree: Tree) -> None:
    decision = tree({**CODE, "requirements.txt": "opencv-python-headless\nShapely<2\n"})
    assert lines(decision) == [GIT]
    assert "descartes" in names(decision)
    assert not {"opencv-python", "shapely"} & names(decision)


@pytest.mark.parametrize(
    "manifest",
    [
        {"requirements.txt": "argoverse==1.1\ntqdm==4.1\n"},
        {"setup.py": "from setuptools import setup\nsetup(name='a', install_requires=['argoverse', 'tqdm==4.1'])\n"},
    ],
)
def test_of_a_list_it_is_installed_alone_and_its_needs_are_declared(tree: Tree, manifest: dict[str, str]) -> None:
    decision = tree({**CODE, **manifest})
    assert lines(decision) == [GIT]
    assert "argoverse" not in names(decision, declared=True)
    assert {"descartes", "shapely"} <= names(decision, declared=True)
    assert [each.written for each in decision.python.pip if each.key == "tqdm"] == ["tqdm==4.1"]
    assert any("pip cannot install argoverse" in each.message for each in decision.warnings)


@pytest.mark.parametrize(
    ("manifest", "line"),
    [
        ("requirements.txt", OLD),
        ("requirements.txt", f"{OLD}@v1.1#egg=argoverse"),
        ("requirements.txt", f"argoverse @ {OLD}"),
        ("setup.py", f"argoverse @ {OLD}"),
    ],
)
def test_a_list_that_names_its_repository_is_installed_line_by_line(tree: Tree, manifest: str, line: str) -> None:
    setup = f"from setuptools import setup\nsetup(name='a', install_requires=['{line}', 'tqdm==4.1'])\n"
    listed = manifest == "requirements.txt"
    decision = tree({**CODE, manifest: f"{line}\ntqdm==4.1\n" if listed else setup})
    assert lines(decision) == [line]
    assert decision.python.requirements == ()
    assert decision.python.alone == (() if listed else (".",))
    assert {"tqdm", "descartes"} <= names(decision, declared=True)
    assert not [each for each in decision.python.pip if bare(each)]
    (said,) = [each for each in decision.warnings if "asks for itself" in each.message]
    assert (said.file, "without the old versions that its setup.py pins" in said.message) == (manifest, True)


def test_of_a_conda_environment_it_is_tried_with_its_needs(tree: Tree) -> None:
    listed = "name: a\ndependencies:\n  - python=3.8\n  - pip:\n    - argoverse\n    - shapely<2\n"
    decision = tree({**CODE, "environment.yml": listed})
    assert lines(decision) == [GIT]
    assert "descartes" in names(decision)
    assert "shapely" not in names(decision)
    assert decision.python.conda_local == ("argoverse",)


def test_without_it_nothing_of_it_is_installed(tree: Tree) -> None:
    assert "descartes" not in names(tree({"run.py": "import numpy\nimport av2\n"}))


@pytest.mark.parametrize(("module", "channel"), [("manifpy", "conda-forge"), ("habitat_sim", "aihabitat")])
@pytest.mark.parametrize("manifest", [{}, {"requirements.txt": "numpy\n"}])
def test_a_module_that_conda_alone_has_is_told_though_a_table_knows_its_package(
    tree: Tree, module: str, channel: str, manifest: dict[str, str]
) -> None:
    decision = tree({"run.py": f"import numpy\nimport {module}\n", **manifest})
    assert names(decision) <= {"numpy"}
    (said,) = [each.message for each in decision.warnings if module in each.message]
    assert channel in said
    assert "by an environment file" in said
