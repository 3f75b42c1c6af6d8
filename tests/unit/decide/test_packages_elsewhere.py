"""Packages of apt that lie in a folder of their own, from a source that is added for them."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from roslab.decide.decision import Decision
from roslab.pipeline import plan_repository
from roslab.render.dockerfile import dockerfile
from roslab.values.dataclass import replace

Tree = Callable[[dict[str, str]], Decision]
SOURCE = "deb [arch=amd64] http://robotpkg.openrobots.org/packages/debian/pub $(lsb_release -cs) robotpkg"
PAGE = f"""\
Tested on Ubuntu {{}}
## Install
```
sudo sh -c "echo '{SOURCE}' > /etc/apt/sources.list.d/robotpkg.list"
curl http://robotpkg.openrobots.org/packages/debian/robotpkg.key | sudo apt-key add -
sudo apt update
sudo apt install robotpkg-py3*-pinocchio
```
"""
SAID = (
    "Tested on Ubuntu {}\n1. Add robotpkg to apt.\n2. `sudo apt update && sudo apt install robotpkg-py3\\*-pinocchio`\n"
)
CODE = {
    "CMakeLists.txt": "project(demo)\nfind_package(pinocchio REQUIRED)\nadd_executable(demo a.cpp)\n",
    "a.cpp": "int main() {}\n",
}


@pytest.mark.parametrize("page", [PAGE, SAID], ids=["source", "words"])
@pytest.mark.parametrize(("ubuntu", "python"), [("20.04", "3.8"), ("22.04", "3.10")])
def test_they_are_found_where_they_lie(tmp_path: Path, page: str, ubuntu: str, python: str) -> None:
    for name, text in {**CODE, "README.md": page.format(ubuntu)}.items():
        (tmp_path / name).write_text(text)
    plan = plan_repository(tmp_path).plan
    (line,) = plan.repositories
    assert "signed-by=https://robotpkg.openrobots.org/" in line
    package = f"robotpkg-py{python.replace('.', '')}-pinocchio"
    assert package in plan.apt_guessed
    assert [each.instead for each in plan.libraries if each.name == "pinocchio"] == [(package,)]
    text = dockerfile(plan)
    _, variables = text.split("add-package-sources 'deb ")
    said = variables[variables.index("ENV PATH=/opt/openrobots/sbin:/opt/openrobots/bin:${PATH} ") :].partition("\n\n")[
        0
    ]
    assert "CMAKE_PREFIX_PATH=/opt/openrobots${CMAKE_PREFIX_PATH:+:${CMAKE_PREFIX_PATH}} " in said
    assert f"PYTHONPATH=/opt/openrobots/lib/python{python}/site-packages" in said


def test_the_repositorys_own_modules_come_before_theirs(tmp_path: Path) -> None:
    for name, text in {**CODE, "README.md": PAGE.format("20.04")}.items():
        (tmp_path / name).write_text(text)
    plan = plan_repository(tmp_path).plan
    text = dockerfile(replace(plan, workspace=replace(plan.workspace, python_path=("python",))))
    own = f"/home/${{NB_USER}}/{tmp_path.name}/python"
    assert f'PYTHONPATH="{own}:/opt/openrobots/lib/python3.8/site-packages"' in text


def test_no_other_source_sets_a_variable(tree: Tree, tmp_path: Path) -> None:
    page = "Tested on Ubuntu 22.04\n```\nsudo apt install libgz-sim8-dev\n```\n"
    for name, text in {**CODE, "README.md": page}.items():
        (tmp_path / name).write_text(text)
    assert "CMAKE_PREFIX_PATH" not in dockerfile(plan_repository(tmp_path).plan).partition("FROM ubuntu")[2]
    decision = tree({**CODE, "README.md": "```\nsudo apt install acme-py3*-tool\n```\n"})
    assert not [name for name in decision.apt_guessed if "*" in name]
