"""A setup.py with which setuptools stops: what it needs is installed, and its folder is on PYTHONPATH."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
START = "from setuptools import setup, find_packages\n"
READS = START + "with open('core/README.md', encoding='utf-8') as page:\n    text = page.read()\n"
CALL = "setup(name='demo', long_description=text, packages=find_packages(), install_requires=['einops'])\n"
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
