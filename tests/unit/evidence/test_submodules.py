"""A submodule that is checked out says nothing about the whole of a Python repository."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.config.model import Config
from roslab.decide import decide
from roslab.decide.decision import Decision
from roslab.evidence.gather import gather
from roslab.repository.checkout import Repository

TREE = {
    "README.md": "# Demo\n```\npip install numpy\npython play.py\n```\n",
    "play.py": "import numpy\n\nprint(1)\n",
    ".gitmodules": '[submodule "planner"]\n\tpath = planner\n\turl = https://github.com/a/planner.git\n',
    "planner/README.md": "Python 2.7, CUDA 9.0.\n```\npython setup_all.py\n```\n",
    "planner/requirements.txt": "torch==0.4.0\n",
    "planner/environment.yml": "name: a\ndependencies:\n  - python=2.7\n",
    "planner/a.py": "print 'a'\n",
    "planner/b.py": "print 'b'\n",
    "planner/c.py": "print 'c'\n",
}


def decided(folder: Path, files: dict[str, str]) -> Decision:
    for path, text in files.items():
        (folder / path).parent.mkdir(parents=True, exist_ok=True)
        (folder / path).write_text(text)
    return decide(gather(Repository.open(folder)), Config(), folder_name="demo")


def test_a_submodule_that_is_checked_out_is_a_project_of_its_own(tmp_path: Path) -> None:
    found = decided(tmp_path, TREE)
    assert (found.kind, found.python.version, found.python.manager) == ("python", "3.10", "venv")
    assert (found.python.requirements, found.python.conda_file, found.command) == ((), None, ("python", "play.py"))


@pytest.mark.parametrize(
    "line", ["pip install -r planner/requirements.txt", "cd planner\npip install -r requirements.txt"]
)
def test_what_a_page_installs_from_it_is_installed(tmp_path: Path, line: str) -> None:
    found = decided(tmp_path, {**TREE, "README.md": f"# Demo\n```\n{line}\n```\n"})
    assert found.python.requirements == ("planner/requirements.txt",)


def test_the_submodules_of_a_workspace_are_a_part_of_it(tmp_path: Path) -> None:
    manifest = "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend></package>"
    files = {**TREE, "package.xml": manifest, "CMakeLists.txt": "project(demo)\nfind_package(catkin)\n"}
    decided(tmp_path, files)
    found = gather(Repository.open(tmp_path))
    assert [file.file for file in found.requirements] == ["planner/requirements.txt"]


def test_an_entry_of_a_folder_in_which_others_lie_is_none(tmp_path: Path) -> None:
    stale = '[submodule "deps"]\n\tpath = deps\n\turl = https://github.com/a/old.git\n'
    lists = "".join(
        f'[submodule "deps/{name}"]\n\tpath = deps/{name}\n\turl = https://github.com/a/{name}.git\n' for name in "xy"
    )
    found = decided(tmp_path, {"README.md": "# Demo\n", "play.py": "print(1)\n", ".gitmodules": stale + lists})
    assert [source.name for source in found.submodules] == ["deps/x", "deps/y"]
