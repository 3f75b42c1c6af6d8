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


def test_a_package_for_another_ubuntus_python_is_the_images(tree: Tree) -> None:
    asked = "robotpkg-py35-{pinocchio,example-robot-data} acme-py35-tool"
    page = PAGE.format("20.04").replace("robotpkg-py3*-pinocchio", asked)
    decision = tree({**CODE, "README.md": page})
    named = {"robotpkg-py38-pinocchio", "robotpkg-py38-example-robot-data", "acme-py35-tool"}
    assert {name for name in decision.apt_guessed if "-py3" in name} == named


@pytest.mark.parametrize(("code", "python"), [("time.clock()", "3.6"), ("assert (n := 1)", "3.10")])
def test_a_python_program_is_on_an_ubuntu_for_whose_python_the_source_has_modules(
    tree: Tree, code: str, python: str
) -> None:
    page = PAGE.partition("## Install")[2].replace("py3*", "py35")
    decision = tree({"README.md": page, "walk.py": f"import time\nimport pinocchio\n{code}\n"})
    assert (decision.python.version, decision.ubuntu) == (python, {"3.6": "bionic", "3.10": "jammy"}[python])
    assert f"robotpkg-py{python.replace('.', '')}-pinocchio" in decision.apt_guessed


def test_the_repositorys_own_modules_come_before_theirs(tmp_path: Path) -> None:
    for name, text in {**CODE, "README.md": PAGE.format("20.04")}.items():
        (tmp_path / name).write_text(text)
    plan = plan_repository(tmp_path).plan
    text = dockerfile(replace(plan, workspace=replace(plan.workspace, python_path=("python",))))
    own = f"/home/${{NB_USER}}/{tmp_path.name}/python"
    assert f'PYTHONPATH="{own}:/opt/openrobots/lib/python3.8/site-packages"' in text
    other = dockerfile(replace(plan, python=replace(plan.python, version="3.11")))
    assert "PATH=/opt/openrobots" in other
    assert "PYTHONPATH" not in other.partition("FROM ubuntu")[2], "its modules are for Ubuntu's Python"


def test_no_other_source_sets_a_variable(tree: Tree, tmp_path: Path) -> None:
    page = "Tested on Ubuntu 22.04\n```\nsudo apt install libgz-sim8-dev\n```\n"
    for name, text in {**CODE, "README.md": page}.items():
        (tmp_path / name).write_text(text)
    assert "CMAKE_PREFIX_PATH" not in dockerfile(plan_repository(tmp_path).plan).partition("FROM ubuntu")[2]
    decision = tree({**CODE, "README.md": "```\nsudo apt install acme-py3*-tool\n```\n"})
    assert not [name for name in decision.apt_guessed if "*" in name]


def test_what_only_that_source_may_have_is_asked_of_it(tree: Tree) -> None:
    cmake = CODE["CMakeLists.txt"].replace("find_package", "find_package(eigenpy REQUIRED)\nfind_package", 1)
    decision = tree({**CODE, "CMakeLists.txt": cmake, "README.md": PAGE.format("20.04")})
    assert {"robotpkg-py38-eigenpy", "robotpkg-eigenpy"} <= {*decision.apt_guessed}
    assert "robotpkg-pinocchio" not in decision.apt_guessed, "the page installs it for Python"
    assert not [warning for warning in decision.warnings if "eigenpy" in warning.message]
    without = tree({**CODE, "CMakeLists.txt": cmake, "README.md": "Tested on Ubuntu 20.04\n"})
    assert not [name for name in without.apt_guessed if "robotpkg" in name]
    assert [warning for warning in without.warnings if "eigenpy" in warning.message]


def test_a_library_that_the_page_links_to_is_compiled_only_where_that_source_has_it_not(tree: Tree) -> None:
    cmake = CODE["CMakeLists.txt"].replace("pinocchio", "acme-legs")
    link = "Needs [acme-legs](https://github.com/lab/acme-legs)\n"
    page = PAGE.format("20.04").replace("py3*-pinocchio", "py3*-acme-legs")
    decision = tree({**CODE, "CMakeLists.txt": cmake, "README.md": link + page})
    assert [(each.name, each.instead) for each in decision.source] == [("acme-legs", ("robotpkg-py38-acme-legs",))]
