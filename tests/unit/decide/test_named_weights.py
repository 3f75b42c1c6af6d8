"""Weights that the settings of the default command name, and that a script of the page downloads."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
GET = "python scripts/download_models.py\n"
FILES = {
    "run.py": "import numpy\n\nif __name__ == '__main__':\n    print(1)\n",
    "scripts/download_models.py": "import requests\n",
    "cfg/a.yaml": "speed: 1\nmodel_path: models/a.pt  # required\n",
}


@pytest.mark.parametrize(
    ("files", "before", "told"),
    [
        ({}, GET, True),
        ({}, "", False),  # nothing says that it is downloaded
        ({"models/a.pt": "weights"}, GET, False),
        ({"cfg/models/a.pt": "weights"}, GET, False),
        ({"cfg/a.yaml": "output_path: models/a.pt\n"}, GET, False),
        ({"cfg/a.yaml": "# model_path: models/a.pt\n"}, GET, False),
        ({"cfg/a.yaml": "model_path: /data/a.pt\n"}, GET, False),
        ({"cfg/b.yaml": "model_path: models/a.pt\n", "cfg/a.yaml": "speed: 1\n"}, GET, False),  # not its settings
    ],
)
def test_the_weights_of_the_settings(tree: Tree, files: dict[str, str], before: str, *, told: bool) -> None:
    page = f"# Demo\n## Install\n```\n{before}```\n## Run\n```\npython run.py --config cfg/a.yaml\n```\n"
    found = tree(FILES | files | {"README.md": page})
    assert found.command == ("python", "run.py", "--config", "cfg/a.yaml")
    said = [(w.file, w.line) for w in found.warnings if "settings name models/a.pt" in w.message]
    assert said == [("cfg/a.yaml", 2)] * told
