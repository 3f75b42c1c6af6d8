"""A setup.py with which setuptools stops: what it needs is installed, and its folder is on PYTHONPATH."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from roslab.config.model import Config
from roslab.decide import decide
from roslab.decide.decision import Decision
from roslab.evidence.gather import gather
from roslab.repository.checkout import Repository
from trees import commit, tree_of

Tree = Callable[[dict[str, str]], Decision]
START = "from setuptools import setup, find_packages\n"
READS = START + "with open('core/README.md', encoding='utf-8') as page:\n    text = page.read()\n"
CALL = "setup(name='demo', long_description=text, packages=find_packages(), install_requires=['einops'])\n"
ASKS = "import subprocess\ndef git(*words):\n    return subprocess.check_output(['git'] + list(words))\n"
HERE = START + "setup(name='demo', packages=find_packages(), install_requires=['einops'])\n"
BARE = START + "setup(name='demo', install_requires=['einops']{more})\n"
FOLDERS = {"core/__init__.py": "", "notebooks/a.ipynb": "{}"}


@pytest.mark.parametrize(
    ("setup", "files", "stopped"),
    [
        (READS + CALL, {"README.md": "# Demo\n"}, True),
        (READS + CALL, {"core/README.md": "# Demo\n"}, False),
        (START + "text = open('LONG').read()\n" + CALL, {}, True),
        (START + "import os\ntext = open('LONG').read() if os.path.exists('LONG') else ''\n" + CALL, {}, False),
        (START + "try:\n    text = open('LONG').read()\nexcept OSError:\n    text = ''\n" + CALL, {}, False),
        (START + "open('LONG', 'w').write('x')\ntext = open('LONG').read()\n" + CALL, {}, False),
        (START + "import shutil\nshutil.copy('a.md', 'LONG')\ntext = open('LONG').read()\n" + CALL, {}, False),
        (START + "import shutil\ntext = open('LONG').read()\nshutil.copy('a.md', 'B')\n" + CALL, {}, True),
        (ASKS + "git('describe', '--tags')\n" + HERE, {}, True),
        (ASKS + "git('rev-parse', '--show-toplevel')\n" + HERE, {}, False),
        (ASKS + "git('rev-parse', '--show-toplevel')\n" + READS + CALL, {}, True),
        (ASKS + "try:\n    git('describe')\nexcept OSError:\n    pass\n" + HERE, {}, False),
        (ASKS + "def version():\n    return git('describe')\n" + HERE, {}, False),
        (START + "import subprocess\nsubprocess.run('git log', shell=True, check=True)\n" + HERE, {}, True),
        (START + "import subprocess\nsubprocess.run('git log', shell=True)\n" + HERE, {}, False),
        (BARE.format(more=""), FOLDERS, True),
        (BARE.format(more=""), {"core/__init__.py": "", "docs/a.md": ""}, False),
        (BARE.format(more=", packages=['core']"), FOLDERS, False),
        (BARE.format(more=", **more"), FOLDERS, False),
        (BARE.format(more=""), {**FOLDERS, "setup.cfg": "[options]\npackages = core\n"}, False),
    ],
    ids=[
        "another-folder",
        "there",
        "nowhere",
        "if",
        "try",
        "written",
        "copied",
        "copied-later",
        "tags",
        "folder",
        "after-git",
        "may-fail",
        "never-called",
        "checked",
        "unchecked",
        "several",
        "one",
        "packages",
        "unknown",
        "setup.cfg",
    ],
)
def test_what_stops_is_not_installed(tree: Tree, setup: str, files: dict[str, str], stopped: bool) -> None:
    found = tree({"setup.py": setup, "train.py": "import core\n", **files})
    assert (found.python.projects == ()) is stopped
    assert [each.key for each in found.python.pip] == (["einops"] if stopped else [])
    assert any("setup.py" in each.message for each in found.warnings) is stopped
    assert ("." in found.python_path) is stopped


@pytest.mark.parametrize(("page", "stopped"), [("pip install -e env", True), ("python train.py", False)])
def test_below_the_root_where_a_page_installs_it(tree: Tree, page: str, stopped: bool) -> None:
    files = {"env/setup.py": BARE.format(more=""), **{f"env/{path}": text for path, text in FOLDERS.items()}}
    found = tree({"README.md": f"```\n{page}\n```\n", "train.py": "import core\n", **files})
    assert found.python.projects == ()
    assert ("env" in found.python_path) is stopped
    assert any("env/setup.py" in str(each.file) for each in found.warnings) is stopped


def test_setuptools_of_the_day_of_an_old_commit_looks_for_no_packages(tmp_path: Path) -> None:
    tree_of(tmp_path, {"setup.py": BARE.format(more=""), "train.py": "import core\n", **FOLDERS})
    commit(tmp_path, "2020-06-01")
    found = decide(gather(Repository.open(tmp_path)), Config(), folder_name="demo")
    assert found.python.projects == (".",)
