"""Of the places of an import the one counts that tells most about the project: no script's, example's or test's."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
PROJECT = {"pyproject.toml": "[project]\nname = 'field'\nversion = '1'\ndependencies = ['numpy']\n"}


@pytest.mark.parametrize("folder", ["scripts", "examples", "tests", "tools"])
def test_a_package_that_imports_a_framework_needs_it(tree: Tree, folder: str) -> None:
    files = {f"{folder}/export.py": "import torch\n", "field/models/base.py": "import os\nimport torch\n"}
    decision = tree({**PROJECT, **files})
    assert decision.kind == "cuda"
    reason = next(each for each in decision.reasons if each.question == "kind" and "torch" in each.reason)
    assert (reason.file, reason.line) == ("field/models/base.py", 2)


@pytest.mark.parametrize(
    "text",
    ["import os\n", "try:\n    import torch\nexcept ImportError:\n    torch = None\n", "def f():\n    import torch\n"],
)
def test_one_that_only_its_scripts_import_is_not_the_package_s(tree: Tree, text: str) -> None:
    decision = tree({**PROJECT, "scripts/export.py": "import torch\n", "field/models/base.py": text})
    assert decision.kind == "python"


def test_what_a_node_in_python_imports_and_nothing_declares_is_tried(tree: Tree) -> None:
    manifest = (
        "<package format='3'><name>relay</name><depend>rclpy</depend><export><build_type>ament_python</build_type>"
    )
    setup = "from setuptools import setup\nsetup(name='relay', packages=['relay'], entry_points={'console_scripts': "
    files = {
        "relay/package.xml": f"{manifest}</export></package>",
        "relay/setup.py": f"{setup}['relay = relay.relay:main']}})\n",
        "relay/relay/__init__.py": "",
        "relay/relay/relay.py": "import rclpy\nimport zenoh\n",
    }
    assert [each.key for each in tree(files).python.pip_guessed] == ["eclipse-zenoh"]
