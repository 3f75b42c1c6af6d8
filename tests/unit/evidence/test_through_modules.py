"""Frameworks that nodes of ROS import by modules of the tree."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.evidence.python import imports
from roslab.repository.checkout import Repository

NODE = "import rospy\nfrom network import Network\n"
LEARNER = "learner/src/learner"
PACKAGE = {"node/src/network/__init__.py": "from .net import Network\n", f"{LEARNER}/__init__.py": ""}


@pytest.mark.parametrize(
    ("files", "place"),
    [
        ({"node/src/network/net.py": "import os\nimport keras\n"}, ("node/src/network/net.py", 2)),
        (
            {
                "node/src/network/net.py": "from learner.nets import (\n  small,\n)\n",
                f"{LEARNER}/nets.py": "import keras\n",
            },
            (f"{LEARNER}/nets.py", 1),
        ),
        (
            {"node/src/network/net.py": "from learner import nets\n", f"{LEARNER}/nets.py": "from keras import a\n"},
            (f"{LEARNER}/nets.py", 1),
        ),
        (
            {"node/src/network/net.py": "import learner.a as b\n", f"{LEARNER}/__init__.py": "import keras\n"},
            (f"{LEARNER}/__init__.py", 1),
        ),
        (
            {
                "node/src/network/net.py": "def run():\n    import learner.nets\n",
                f"{LEARNER}/nets.py": "import keras\n",
            },
            None,
        ),
        (
            {
                "node/src/network/net.py": "try:\n    import learner.nets\nexcept ImportError:\n    pass\n",
                f"{LEARNER}/nets.py": "import keras\n",
            },
            None,
        ),
        ({"node/src/network/net.py": "", f"{LEARNER}/train.py": "import keras\n"}, None),
    ],
)
def test_a_module_that_a_node_imports_is_part_of_it(
    tmp_path: Path, files: dict[str, str], place: tuple[str, int] | None
) -> None:
    for path, text in {"node/nodes/drive.py": NODE, **PACKAGE, **files}.items():
        (tmp_path / path).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / path).write_text(text)
    (found,) = (each for each in imports.read(Repository.open(tmp_path)) if each.name == "keras")
    assert found.role == ("node" if place else "")
    assert place in {None, (found.file, found.line)}


def test_without_a_node_nothing_is(tmp_path: Path) -> None:
    (tmp_path / "a.py").write_text("import b\n")
    (tmp_path / "b.py").write_text("import torch\n")
    assert [(each.name, each.role) for each in imports.read(Repository.open(tmp_path))] == [("torch", "")]
