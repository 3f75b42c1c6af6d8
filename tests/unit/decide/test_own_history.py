"""Code that needs git, or the history of its own repository, which no image has."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

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
        ("import numpy\nclass Repo:\n    pass\nrepo = Repo()\n", 0),
    ],
)
def test_a_program_that_opens_its_own_repository_is_told(tree: Tree, code: str, line: int) -> None:
    found = [(w.file, w.line) for w in tree({"play.py": code}).warnings if "own git repository" in w.message]
    assert found == [("play.py", line)] * bool(line)
