"""What a page has conda install and the code imports by the same name, pip installs under it."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
PAGE = "# Install\n```\nconda install -c conda-forge python=3.9 tqdm {}\n```\n"
DOCS = "```\npip install -U git+https://github.com/acme/docs.git\n```\n"


@pytest.mark.parametrize(
    ("named", "code", "installed"),
    [
        ("ontoreader2=0.36 tomlparts", "import ontoreader2\nimport tomlparts\n", ["ontoreader2==0.36", "tomlparts"]),
        ("ontoreader2", "import os\n", []),
        ("onto-reader", "import onto_reader\n", ["onto-reader"]),
        ("ontoreader2", "try:\n    import ontoreader2\nexcept ImportError:\n    pass\n", []),
        ("utils", "import utils\n", []),
    ],
)
def test_conda_names(tree: Tree, named: str, code: str, installed: list[str]) -> None:
    decision = tree({"README.md": PAGE.format(named), "run.py": f"import tqdm\n{code}"})
    found = [each.text for each in decision.python.pip_guessed if each.key != "tqdm"]
    assert found == installed
    assert ("no table knows" in str(decision.warnings)) == (named == "utils" and not installed)


@pytest.mark.parametrize(("module", "told"), [("acme_docs", False), ("acme_maps", True), ("docs", False)])
def test_a_module_called_after_an_owner_and_a_repository(tree: Tree, module: str, *, told: bool) -> None:
    decision = tree({"README.md": f"# Install\n{DOCS}", "run.py": f"import numpy\nimport {module}\n"})
    assert ("no table knows" in str(decision.warnings)) is told
