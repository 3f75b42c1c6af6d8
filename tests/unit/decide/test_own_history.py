"""Code that needs git, or the history of its own repository, which no image has."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from hanging import ends
from roslab.config.model import Config
from roslab.decide.decision import Decision
from trees import decided

Tree = Callable[[dict[str, str]], Decision]


@pytest.mark.parametrize("files", [{"requirements.txt": "gitpython\n"}, {"play.py": "import git\n"}])
def test_a_package_that_starts_git_brings_git(tree: Tree, files: dict[str, str]) -> None:
    found = tree({"play.py": "import numpy\n", **files})
    assert "git" in {*found.apt, *found.apt_guessed}


@pytest.mark.parametrize(
    ("code", "line"),
    [
        ("import git\nrepo = git.Repo(search_parent_directories=True)\n", 2),
        ("from git import Repo\n\ndef sha():\n    return Repo('.').head\n", 4),
        ("import git, os\nrepo = git.Repo(os.path.dirname(__file__))\n", 2),
        ("import git\ntry:\n    repo = git.Repo()\nexcept git.InvalidGitRepositoryError:\n    repo = None\n", 0),
        ("import git\n\ndef fetch(path):\n    return git.Repo(path)\n", 0),
        ("import git\nrepo = git.Repo.clone_from('https://github.com/a/b', 'b')\n", 0),
        ("try:\n    import git\n    repo = git.Repo()\nexcept (ImportError, ModuleNotFoundError):\n    exit()\n", 3),
        ("try:\n    import git\n    repo = git.Repo('.')\nexcept Exception:\n    pass\n", 0),
        ("import subprocess\nsha = subprocess.check_output(['git', 'rev-parse', 'HEAD'])\n", 2),
        ("import subprocess as sp\nsha = sp.check_output(\n    'git log -1', shell=True)\n", 2),
        ("import numpy, subprocess\n# subprocess.check_output(['git', 'rev-parse', 'HEAD'])\n", 0),
        ("import subprocess\ntry:\n    subprocess.check_output(['git', 'log'])\nexcept OSError:\n    pass\n", 0),
        ("import subprocess\nsha = subprocess.check_output(['git', 'log'], cwd='/opt/other')\n", 0),
        ("import subprocess\nsha = subprocess.check_output(['git', 'clone', 'https://github.com/a/b'])\n", 0),
        ("import subprocess\nsha = subprocess.getoutput('git rev-parse HEAD')\n", 0),
        ("import numpy\nclass Repo:\n    pass\nrepo = Repo()\n", 0),
    ],
)
def test_a_program_that_asks_its_own_repository_is_told(tree: Tree, code: str, line: int) -> None:
    decision = tree({"play.py": code})
    found = [(w.file, w.line) for w in decision.warnings if "own git repository" in w.message]
    assert found == [("play.py", line)] * bool(line)
    assert decision.git_folder is bool(line)
    assert ("git" in {*decision.apt, *decision.apt_guessed}) or not line


@pytest.mark.parametrize(
    "code",
    [
        "import numpy, subprocess\ntop = subprocess.check_output(['git', 'rev-parse', '--show-toplevel'])\n",
        "import git\ntop = git.Repo('.', search_parent_directories=True).working_tree_dir\n",
    ],
)
def test_a_program_that_asks_for_the_folder_alone_is_not_told(tree: Tree, code: str) -> None:
    decision = tree({"play.py": code})
    assert decision.git_folder
    assert not [w for w in decision.warnings if "own git repository" in w.message]


def test_a_program_without_the_ending_of_python(tree: Tree) -> None:
    code = "#!/usr/bin/env python3\nimport git\nrepo = git.Repo(__file__, search_parent_directories=True)\n"
    assert tree({"scripts/play": code}).git_folder


def test_the_image_of_an_old_configuration_has_none(tmp_path: Path) -> None:
    files = {"play.py": "import git\nrepo = git.Repo()\n"}
    found = decided(tmp_path, files, config=Config(compatible="later"))
    assert not found.git_folder
    assert not any("git repository" in warning.message for warning in found.warnings)


CALL = "check_output(['git', 'log'])\n"


@pytest.mark.parametrize(
    "code",
    [
        f"try:\n    {CALL}except{' ' * 200_000}x:\n    pass\n",
        f"try:\n    {CALL}except ImportError{' ' * 200_000}x:\n    pass\n",
    ],
    ids=["before the first name", "behind it"],
)
def test_a_hostile_module_takes_no_long_time(tree: Tree, code: str) -> None:
    with ends():
        tree({"play.py": f"import numpy, subprocess\n{code}"})
