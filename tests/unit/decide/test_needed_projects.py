"""Of several Python projects in one tree, those that the installed ones need by name are installed too, before them."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
BUILD = "[build-system]\nrequires = ['setuptools']\n"
APP = "[project]\nname = 'app'\nversion = '1'\ndependencies = [{needs}]\n" + BUILD
CORE = "[project]\nname = 'Robot_Core'\nversion = '1'\ndependencies = ['numpy']\n" + BUILD
PAGE = "```\npip install -e app\n```\n"


@pytest.mark.parametrize(
    ("folder", "needs", "page", "projects"),
    [
        ("app", "'robot-core'", "", ("libs/core", "app")),
        ("app", "'robot-core>=1'", PAGE, ("libs/core", "app")),
        ("", "'robot-core'", "", ("libs/core", ".")),
        ("app", "'scipy'", PAGE, ("app",)),
        ("app", "'robot-core @ git+https://example.org/core.git'", PAGE, ("app",)),
        ("app", "'robot-core'", "```\npip install -e app\npip install -e libs/core\n```\n", ("libs/core", "app")),
    ],
)
def test_projects_that_others_need(tree: Tree, folder: str, needs: str, page: str, projects: tuple[str, ...]) -> None:
    app = f"{folder}/pyproject.toml".lstrip("/")
    files = {app: APP.format(needs=needs), "libs/core/pyproject.toml": CORE, "run.py": "import numpy\n"}
    assert tree({**files, "README.md": page}).python.projects == projects


def test_projects_that_need_each_other(tree: Tree) -> None:
    core = CORE.replace("'numpy'", "'app'")
    files = {"app/pyproject.toml": APP.format(needs="'robot-core'"), "libs/core/pyproject.toml": core}
    assert set(tree({**files, "run.py": "import numpy\n"}).python.projects) == {"app", "libs/core"}


def test_all_that_a_page_installs_is_installed(tree: Tree) -> None:
    names = [f"part{number}" for number in range(9)]
    files = {f"lib/{name}/setup.py": f"from setuptools import setup\nsetup(name='{name}')\n" for name in names}
    page = "".join(f"pip install -e lib/{name}\n" for name in names)
    found = tree({**files, "run.py": "import numpy\n", "README.md": f"```\n{page}```\n"})
    assert found.python.projects == tuple(f"lib/{name}" for name in names)


SIMULATOR = "from setuptools import setup\nsetup(name='isaacgym', packages=['isaacgym'], install_requires=['numpy'])\n"
APP_ALONE = {"pyproject.toml": APP.format(needs="'scipy'"), "run.py": "from isaacgym import gymapi\n"}


@pytest.mark.parametrize(
    ("more", "projects", "told"),
    [
        ({}, (".",), True),
        (
            {"isaacgym/python/setup.py": SIMULATOR, "isaacgym/python/isaacgym/gymapi.py": ""},
            (".", "isaacgym/python"),
            False,
        ),
        ({"isaacgym/python/setup.py": SIMULATOR.replace("isaacgym", "other")}, (".",), False),
    ],
)
def test_an_archive_that_was_unpacked_in_the_tree_is_installed(
    tree: Tree, more: dict[str, str], projects: tuple[str, ...], *, told: bool
) -> None:
    decision = tree({**APP_ALONE, **more})
    assert decision.python.projects == projects
    assert any("run roslab again, which installs it" in each.message for each in decision.warnings) is told
