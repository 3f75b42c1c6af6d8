"""A page that installs its own folder does not rule out the packages beside it."""

from __future__ import annotations

from collections.abc import Callable

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
BACKEND = '[build-system]\nrequires = ["setuptools"]\nbuild-backend = "setuptools.build_meta"\n'


def package(name: str, needs: str = "numpy") -> dict[str, str]:
    project = f'[project]\nname = "{name}"\nversion = "1"\ndependencies = ["{needs}"]\n{BACKEND}'
    return {f"{name}/pyproject.toml": project, f"{name}/{name}/__init__.py": "import numpy\n"}


TWO = {**package("cameras", "PyGObject<3.52"), **package("arms")}


def test_its_own_folder(tree: Tree) -> None:
    found = tree({**TWO, "arms/README.md": "## Install\n```\npip install -e ./arms\n```\n"})
    assert set(found.python.projects) == {"arms", "cameras"}


def test_the_page_at_the_root_says_which(tree: Tree) -> None:
    found = tree({**TWO, "README.md": "## Install\n```\npip install -e ./arms\n```\n"})
    assert found.python.projects == ("arms",)


def test_a_project_at_the_root_is_the_whole(tree: Tree) -> None:
    root = {path.partition("/")[2]: text for path, text in package("rig").items()}
    root["pyproject.toml"] += '[tool.setuptools]\npackages = ["rig"]\n'
    found = tree({**TWO, **root, "arms/README.md": "## Install\n```\npip install -e ./arms\n```\n"})
    assert set(found.python.projects) == {".", "arms"}


def test_what_an_installed_package_imports(tree: Tree) -> None:
    files = {**TWO, **package("extra"), "README.md": "## Install\n```\npip install -e ./arms\n```\n"}
    files["arms/arms/move.py"] = "from cameras.see import look\ntry:\n    import extra\nexcept ImportError:\n    pass\n"
    assert tree(files).python.projects == ("cameras", "arms")


def test_the_limit_of_a_package_that_is_not_installed_holds(tree: Tree) -> None:
    files = {**TWO, "README.md": "## Install\n```\npip install -e ./arms\n```\n", "look.py": "import gi\n"}
    found = tree(files).python
    assert found.projects == ("arms",)
    assert [each.written for each in found.pip_guessed] == ["PyGObject<3.52"]
