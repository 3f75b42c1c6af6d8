"""A module of no table is its own name's package where the index is known to have it, or the one that a link names."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision
from roslab.knowledge.on_index import named_like

Tree = Callable[[dict[str, str]], Decision]
INDEX = f"https://pypi{chr(46)}org/project/"
PAGE = "# Run\n```\npython run.py\n```\n"


def guessed(tree: Tree, code: str, **files: str) -> list[str]:
    found = tree({"play.py": f"import numpy\n{code}", "run.py": "import numpy\n", "README.md": PAGE, **files})
    told = any("no table knows" in warning.message for warning in found.warnings)
    names = [each.written for each in found.python.pip_guessed if each.key != "numpy"]
    assert told is not bool(names)
    return names


@pytest.mark.parametrize(
    ("module", "name"),
    [
        ("tifffile", "tifffile"),
        ("lazy_loader", "lazy-loader"),
        ("Pygments", "pygments"),
        ("opencv_python", None),  # its module has another name
        ("isaacgym", None),
        ("acme_arm", None),
    ],
)
def test_packages_that_tables_know(module: str, name: str | None) -> None:
    assert named_like(module) == name


@pytest.mark.parametrize(
    ("code", "page", "names"),
    [
        ("import tifffile\n", "", ["tifffile"]),
        ("import acme_arm\n", "", []),
        (f"# {INDEX}acme-arm-driver/\nimport acme_arm\n", "", ["acme-arm-driver"]),
        (f"import arm  # from {INDEX}acme-robot\n", "", ["acme-robot"]),
        ("import acme_arm\n", f"It needs [this]({INDEX}acme-arm-driver/).\n", ["acme-arm-driver"]),
        ("import acme_arm\n", f"It needs [this]({INDEX}Acme.Arm/1.2/).\n", ["Acme.Arm"]),
        ("import acme_arm\n", f"Thanks to [this]({INDEX}other-hand).\n", []),
        (f"# {INDEX}acme-robot\n\n\nimport arm\n", "", []),
    ],
)
def test_what_a_module_comes_from(tree: Tree, code: str, page: str, names: list[str]) -> None:
    assert guessed(tree, code, **{"README.md": f"{PAGE}{page}"}) == names


def test_a_module_of_the_tree_or_a_declared_one_is_no_guess(tree: Tree) -> None:
    page = f"{PAGE}[It]({INDEX}acme-arm) is there.\n"
    own = tree({"play.py": "import numpy\nimport acme_arm\n", "acme_arm.py": "", "README.md": page})
    listed = tree({"play.py": "import tifffile\n", "requirements.txt": "tifffile==2024.1.30\n", "README.md": page})
    assert [each.key for each in own.python.pip_guessed] == ["numpy"]
    assert not listed.python.pip_guessed
