"""The extras with which a page first installs the repository's own project come with it."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
OWN = (
    "[project]\nname='demo'\nversion='1'\ndependencies=['numpy']\n[project.optional-dependencies]\n"
    "sim=['mujoco==3.1.0', 'numpy']\ngui=['viser']\nall=['demo[sim,gui,dev]']\ndev=['pytest-cov']\nmac=['viser']\n"
)
SIM, GUI, DEV = "mujoco==3.1.0", "viser", "pytest-cov"


@pytest.mark.parametrize(
    ("page", "more"),
    [
        ('pip install -e ".[sim]"', [SIM]),
        ("pip install -e .[dev]", [DEV]),  # for all readers
        ("uv sync --extra dev", [DEV]),
        ("pip install -e .[dev]\npip install -e .[dev]", [DEV]),
        ("pip install -e .[dev]\npip install -e .", []),
        ("pip install .[sim,gui]", [SIM, GUI]),
        ('pip install -e ".[all]"', [SIM, GUI]),
        ("cd demo\npip install -e .[sim,dev]", [SIM, DEV]),
        ("pip install -e .[sim,dev]\npip install -e .[sim]", [SIM]),
        ("pip install -e .\npip install -e .[sim]", [SIM]),  # it adds to the line before
        ("pip install -e .\npip install -e .[dev]\npip install -e .[gui,dev]\npip install -e .[sim]", [GUI]),
        ("pip install -e .\npip install -e .[mac]", []),
        ("pip install other[sim]", []),
        (
            "git clone https://github.com/lab/other\ncd other\npip install -e .[sim]\ncd ..\npip install -e .[gui]",
            [GUI],
        ),
        ("pip install -r requirements.txt", [GUI]),
        ("uv sync", []),
        ("uv sync --extra sim", [SIM]),
        ("uv sync --frozen --extra=sim --extra gui", [SIM, GUI]),
        ("uv sync --all-extras", [SIM, GUI]),
        ("uv run --extra gui python main.py", [GUI]),
        ("uv sync\nuv run --extra gui python main.py", [GUI]),
        ("poetry install -E sim", [SIM]),
        ("poetry install --extras 'sim gui'", [SIM, GUI]),
        ("pdm install -G gui", [GUI]),
    ],
)
def test_extras_of_the_first_line_that_has_any_are_installed(tree: Tree, page: str, more: list[str]) -> None:
    files = {"pyproject.toml": OWN, "demo/__init__.py": "", "README.md": f"# Install\n```\n{page}\n```\n"}
    if "requirements" in page:
        files["requirements.txt"] = "-e .[gui]\n"
    python = tree(files).python
    assert python.projects == (".",)
    assert {each.written for each in python.pip_guessed if each.key in {"mujoco", "viser", "pytest-cov"}} == {*more}


@pytest.mark.parametrize(
    ("listed", "page", "more"),
    [
        ("jax==0.4.13", 'pip install "jax[gpu]==0.4.13" -f https://a.org\npip install "jax[tpu]"', "jax[gpu]==0.4.13"),
        ("jax==0.4.13", 'pip install "jax[cuda12]"', "jax[cuda12]==0.4.13"),
        ("jax", "pip install -U jax[cuda12]", "jax[cuda12]"),
        ("jax >= 0.2.27", 'pip install --upgrade "jax[cuda]>=0.2.27" -f https://a.org/x.html', "jax[cuda]>=0.2.27"),
        ("jax>=0.2.27", 'pip install "jax[cuda]"', "jax[cuda]>=0.2.27"),
        ("jax[cuda12]==0.4.13", 'pip install "jax[cuda12]"', None),
        ("jax==0.4.13", 'pip install "jax[cuda12]==0.4.20"', None),
        ("jax==0.4.13", 'pip install "jax[dev]"', None),
        ("jax==0.4.13", "pip install jax", None),
    ],
)
def test_what_a_page_adds_to_a_package_of_a_list(
    tree: Callable[[dict[str, str]], Decision], listed: str, page: str, more: str | None
) -> None:
    files = {"requirements.txt": f"{listed}\n", "a.py": "import jax\n", "README.md": f"```\n{page}\n```\n"}
    python = tree(files).python
    found = (*python.pip, *python.pip_guessed)
    assert [each.written for each in found if each.extras and each.key == "jax"] == ([more] if more else [])
    assert python.beside_files == tuple(each for each in python.pip_guessed if each.extras)


@pytest.mark.parametrize(
    ("needs", "page", "more"),
    [
        ("'jax'", 'uv pip install -U "jax[cuda12]" --index-url https://index.example.org/simple', ["jax[cuda12]"]),
        ("'jax>=0.4'", 'pip install "jax[cuda12]"\npip install "jax[tpu]"', ["jax[cuda12]>=0.4"]),
        ("'jax==0.4.13'", 'pip install "jax[cuda12]==0.4.20"', []),
        ("'jax[cuda12]'", 'pip install "jax[cuda12]"', []),
        ("'jax'", 'pip install "jax[dev]"', []),
        ("", 'pip install "jax[cuda12]"', ["jax[cuda12]"]),
    ],
)
@pytest.mark.parametrize("file", ["pyproject.toml", "setup.py"])
def test_what_a_page_adds_to_a_package_of_the_project(
    tree: Tree, needs: str, page: str, more: list[str], file: str
) -> None:
    own = "[project]\nname='demo'\nversion='1'\ndependencies=[{}]\n"
    if file == "setup.py":
        own = "from setuptools import setup\nsetup(name='demo', version='1', install_requires=[{}])\n"
    files = {file: own.format(needs), "demo/__init__.py": "import jax\n"}
    python = tree({**files, "README.md": f"```\n{page}\npip install -e .\n```\n"}).python
    assert python.projects == (".",)
    assert [each.written for each in (*python.pip, *python.pip_guessed) if each.key == "jax"] == more
    assert python.beside_files == ()


GROUPS = """\
[dependency-groups]
sim = ["mujoco==3.1.0", {include-group = "draw"}]
draw = ["viser"]
dev = ["pytest-cov"]
"""
OF_POETRY = """\
[tool.poetry]
name = "demo"
version = "1"
[tool.poetry.dependencies]
numpy = "*"
[tool.poetry.group.draw.dependencies]
viser = "*"
[tool.poetry.group.sim]
optional = true
[tool.poetry.group.sim.dependencies]
mujoco = "3.1.0"
[tool.poetry.group.dev.dependencies]
pytest-cov = "*"
[build-system]
requires = ["poetry-core"]
build-backend = "poetry.core.masonry.api"
"""


@pytest.mark.parametrize(
    ("project", "page", "more"),
    [
        (OWN + GROUPS, "uv sync", set()),
        (OWN + GROUPS, "uv sync --group sim", {SIM, GUI}),
        (OWN + GROUPS, "uv sync --group draw --group dev", {GUI}),
        (OWN + GROUPS, "pip install .[draw]", set()),  # a group is no extra
        (OWN + GROUPS, "uv sync --only-group sim", set()),  # without the project
        (OF_POETRY, "poetry install", {GUI}),
        (OF_POETRY, "poetry install --with sim,dev", {SIM, GUI}),
    ],
)
def test_groups_that_a_page_names(tree: Tree, project: str, page: str, more: set[str]) -> None:
    files = {"pyproject.toml": project, "demo/__init__.py": "", "README.md": f"# Install\n```\n{page}\n```\n"}
    python = tree(files).python
    assert python.projects == (".",)
    asked = {each.written for each in python.pip_guessed if each.key in {"mujoco", "viser", "pytest-cov"}}
    assert asked == more


@pytest.mark.parametrize(
    ("extra", "found", "why"),
    [
        ("pygame-ce>=2.5", "pygame-ce>=2.5", "imported, only an extra declares it"),
        ("pygame>=2", "pygame>=2", "imported, only an extra declares it"),
        ("viser", "pygame", "imported, declared nowhere"),
        ("pygame-ce', 'pygame", "pygame", "imported, declared nowhere"),
    ],
)
def test_what_is_imported_comes_as_an_extra_asks_for_it(tree: Tree, extra: str, found: str, why: str) -> None:
    project = f"[project]\nname='demo'\nversion='1'\n[project.optional-dependencies]\nui=['{extra}']\n"
    files = {
        "pyproject.toml": project,
        "demo/__init__.py": "import pygame\n",
        "README.md": "```\npip install -e .\n```\n",
    }
    decision = tree(files)
    assert [each.written for each in decision.python.pip_guessed] == [found]
    assert [each.reason for each in decision.reasons if each.answer == found] == [why]


@pytest.mark.parametrize(
    ("extras", "code", "found"),
    [
        ("test=['opencv-python-headless<4.6']", "cv2.imread('a')", "opencv-python"),
        ("dev=['opencv-python-headless<4.6']", "cv2.imread('a')", "opencv-python"),
        ("docs=['opencv-python<4.6']", "cv2.imread('a')", "opencv-python"),
        ("viz=['opencv-python-headless<4.6']", "cv2.imshow('a', x)", "opencv-python"),
        ("viz=['opencv-python-headless<4.6']", "cv2.imread('a')", "opencv-python-headless<4.6"),
        ("viz=['opencv-python<4.6']", "cv2.imshow('a', x)", "opencv-python<4.6"),
        ("viz=['opencv-python<4.6']\ntest=['opencv-python-headless']", "cv2.imread('a')", "opencv-python<4.6"),
    ],
)
def test_no_extra_for_tests_or_without_windows_tells_how(tree: Tree, extras: str, code: str, found: str) -> None:
    project = f"[project]\nname='demo'\nversion='1'\n[project.optional-dependencies]\n{extras}\n"
    files = {"pyproject.toml": project, "demo/__init__.py": "", "run.py": f"import cv2\n{code}\n"}
    files["README.md"] = "```\npip install -e .\npython run.py\n```\n"
    assert [each.written for each in tree(files).python.pip_guessed] == [found]


def test_a_package_that_is_declared_under_another_name_is_not_guessed(tree: Tree) -> None:
    project = "[project]\nname='demo'\nversion='1'\ndependencies=['urdfdom-py']\n"
    files = {"pyproject.toml": project, "demo/__init__.py": "from urdf_parser_py.urdf import URDF\n"}
    assert not tree({**files, "README.md": "```\npip install -e .\n```\n"}).python.pip_guessed


@pytest.mark.parametrize("extra", ["PySide6-Essentials==6.11.1", "PySide6>=6.5", "PySide6-Addons"])
def test_a_module_that_parts_of_its_package_bring(tree: Tree, extra: str) -> None:
    project = f"[project]\nname='demo'\nversion='1'\n[project.optional-dependencies]\napp=['{extra}']\n"
    code = {"demo/__init__.py": "from PySide6.QtCore import QObject\n"}
    decision = tree({"pyproject.toml": project, **code, "README.md": "```\npip install -e .\n```\n"})
    assert [each.written for each in decision.python.pip_guessed] == [extra]


@pytest.mark.parametrize(
    ("extras", "page", "found"),
    [
        ("jax=['jax<=0.6.0']\nall=['jax']", "pip install jax", "jax<=0.6.0"),
        ("jax=['jax<=0.6.0']", "conda create -n demo -c conda-forge jax", "jax<=0.6.0"),
        ("jax=['jax<=0.6.0']", "pip install jax==0.4.30", "jax==0.4.30"),
        ("jax=['jax<=0.6.0']\nnew=['jax>=0.7']", "pip install jax", "jax"),
        ("test=['jax<=0.6.0']", "pip install jax", "jax"),
    ],
)
def test_what_a_page_leaves_open_comes_as_an_extra_asks_for_it(tree: Tree, extras: str, page: str, found: str) -> None:
    project = f"[project]\nname='walk'\nversion='1'\n[project.optional-dependencies]\n{extras}\n"
    files = {"pyproject.toml": project, "walk/__init__.py": "", "README.md": f"```\n{page}\npip install -e .\n```\n"}
    python = tree(files).python
    assert [each.written for each in (*python.pip, *python.pip_guessed)] == [found]


@pytest.mark.parametrize(
    ("extras", "code", "found"),
    [
        ("casadi=['lierare>=1']", {"walk/ik.py": "import lierare\n"}, ["lierare>=1"]),
        ("test=['lierare']", {"walk/ik.py": "import lierare\n"}, ["lierare"]),
        ("casadi=['lierare']", {"walk/ik.py": "try:\n    import lierare\nexcept ImportError:\n    pass\n"}, []),
        ("casadi=['lierare']", {"examples/ik.py": "import lierare\n"}, []),
        ("casadi=['lierare @ git+https://github.com/them/lierare']", {"walk/ik.py": "import lierare\n"}, []),
        ("casadi=['other']", {"walk/ik.py": "import lierare\n"}, []),
        ("casadi=['lierare']", {"ik.py": "import lierare\n"}, []),
    ],
)
def test_a_module_of_no_table_that_the_package_needs_is_the_extra_of_its_name(
    tree: Tree, extras: str, code: dict[str, str], found: list[str]
) -> None:
    project = f"[project]\nname='walk'\nversion='1'\n[project.optional-dependencies]\n{extras}\n"
    files = {"pyproject.toml": project, "walk/__init__.py": "", "README.md": "```\npip install -e .\n```\n", **code}
    assert [each.written for each in tree(files).python.pip_guessed] == found
