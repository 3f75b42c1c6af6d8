"""The packages of a baseline in a folder of its own are not those of the repository."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
MAIN = 'import numpy\nif __name__ == "__main__":\n    print(1)\n'
PAGE = "# Arm\n```\n{}\n```\n## Run\n```\n{}\n```\n"
FILES = {
    "arm/train.py": MAIN,
    "baseline/train.py": MAIN,
    "baseline/environment.yml": "channels: [conda-forge]\ndependencies: [python=3.8, pip: [mujoco_py==2.0.2.13]]\n",
    "baseline/requirements.txt": "mujoco_py==2.0.2.13\n",
    "baseline/README.md": "```\npip install -r requirements.txt\nconda env create -f environment.yml\n```\n",
}


@pytest.mark.parametrize(
    ("installs", "runs", "other"),
    [
        ("pip install numpy ruamel.yaml", "python arm/train.py", False),
        ("pip install gdown", "python arm/train.py", True),
        ("pip install numpy ruamel.yaml", "python baseline/train.py", True),
        ("pip install numpy ruamel.yaml\npip install -r baseline/requirements.txt", "python arm/train.py", True),
    ],
)
@pytest.mark.parametrize("listed", ["baseline/environment.yml", "baseline/requirements.txt"])
def test_the_list_of_a_part(tree: Tree, listed: str, installs: str, runs: str, *, other: bool) -> None:
    files = {path: text for path, text in FILES.items() if path.endswith((".py", ".md")) or path == listed}
    if listed.endswith(".yml"):
        installs = installs.replace("pip install -r baseline/requirements.txt", f"conda env create -f {listed}")
    python = tree({**files, "README.md": PAGE.format(installs, runs)}).python
    assert (listed in {python.conda_file, *python.requirements}) is other


@pytest.mark.parametrize(
    ("folder", "compiled", "page", "installed"),
    [
        ("baselines/gail", True, "make", False),
        ("baselines/gail", True, "python baselines/gail/train.py", True),
        ("baselines/gail", True, "pip install -r baselines/gail/requirements.txt", True),
        ("baselines/gail", False, "make", True),
        ("learning/gail", True, "make", True),
    ],
)
def test_compiled_code_needs_nothing_of_what_it_is_compared_with(
    tree: Tree, folder: str, page: str, *, compiled: bool, installed: bool
) -> None:
    code = {"CMakeLists.txt": "project(a)\nadd_executable(a a.cpp)\n", "a.cpp": "int main() {}\n"} if compiled else {}
    files = {f"{folder}/train.py": "import seals\nimport sacred\n", f"{folder}/requirements.txt": "sacred==0.8.4\n"}
    found = tree({**code, **files, "README.md": f"# Demo\n```\n{page}\n```\n"})
    guessed = {each.key for each in found.python.pip_guessed}
    assert bool(found.python.requirements) is installed
    assert ("seals" in guessed, "sacred" in guessed) == (installed, False)
    assert any("is compared with" in warning.message for warning in found.warnings) is not installed


def test_why_the_environment_of_a_part_is_not_made(tree: Tree) -> None:
    files = {path: text for path, text in FILES.items() if path != "baseline/requirements.txt"}
    found = tree({**files, "README.md": PAGE.format("pip install numpy ruamel.yaml", "python arm/train.py")})
    assert any("for a part of the tree" in warning.message for warning in found.warnings)


def test_what_the_root_lists_leaves_all_as_it_is(tree: Tree) -> None:
    page = PAGE.format("pip install numpy ruamel.yaml", "python arm/train.py")
    found = tree({**FILES, "environment.yml": "dependencies: [python=3.9, numpy]\n", "README.md": page}).python
    assert found.conda_file == "environment.yml"


SETUP = "from setuptools import setup\nsetup(name='demo', packages=['net'], install_requires=[{}])\n"
VIEWER = {"net/__init__.py": "", "net/viewer/requirements.txt": "sshconf==0.2.5\n", "README.md": "# Demo\n"}


@pytest.mark.parametrize(
    ("needs", "page", "installed"),
    [
        ("'numpy'", "# Demo\n", ()),
        ("'numpy'", "# Demo\n```\npip install -r net/viewer/requirements.txt\n```\n", ("net/viewer/requirements.txt",)),
        ("", "# Demo\n", ("net/viewer/requirements.txt",)),  # nothing else says what it needs
    ],
)
def test_a_list_below_a_project_that_says_what_it_needs(
    tree: Tree, needs: str, page: str, installed: tuple[str, ...]
) -> None:
    found = tree({**VIEWER, "setup.py": SETUP.format(needs), "README.md": page})
    assert found.python.requirements == installed


@pytest.mark.parametrize(("listed", "said"), [("requirements.txt", False), ("notes.txt", True)])
def test_what_the_dockerfile_of_an_example_installs(tree: Tree, listed: str, *, said: bool) -> None:
    example = "FROM python:3.9\nRUN pip install torch==1.3.0\nCOPY model.py /app/\n"
    files = {"main.py": "import numpy, torch\n", listed: "numpy\n", "examples/small/model.py": MAIN}
    python = tree({**files, "examples/small/Dockerfile": example, "README.md": "# Demo\n"}).python
    asked = (*python.pip, *python.pip_guessed, *python.bounds)
    assert any(each.release == "1.3.0" for each in asked if each.key == "torch") is said
