"""Programs that import, by its bare name, a module of another folder of the tree."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
PROGRAM = "{}\nif __name__ == '__main__':\n    main()\n"
FACTORY = {
    "train.py": PROGRAM.format("from factory.manager import Manager"),
    "factory/manager.py": "import numpy\nimport handler as h\n",
    "factory/handler.py": "",
}
SHARED = {"tools/run.py": PROGRAM.format("import poses"), "shared/poses.py": "import frames\n", "shared/frames.py": ""}


@pytest.mark.parametrize(
    ("files", "folders"),
    [
        (FACTORY, ("factory",)),
        (SHARED, ("shared",)),
        (SHARED | {"tools/run.py": PROGRAM.format("from poses import Pose")}, ("shared",)),
        (SHARED | {"shared/poses.py": "import turns", "maths/turns.py": ""}, ("shared", "maths")),
        ({**SHARED, "deep/in/run.py": "import poses", "README.md": "```\npython deep/in/run.py\n```\n"}, ("shared",)),
    ],
)
def test_the_folder_is_on_the_path(tree: Tree, files: dict[str, str], folders: tuple[str, ...]) -> None:
    assert tree(files).python_path == folders


@pytest.mark.parametrize(
    "more",
    [
        {"other/poses.py": ""},
        {"poses/net.py": ""},
        {"tools/poses.py": ""},
        {"shared/logging.py": ""},
        {"shared/torch/__init__.py": ""},
        {"shared/rarely.py": "", "requirements.txt": "rarely\n"},
        {"shared/poses.py": "from .frames import Frame\n"},
        {"tools/run.py": PROGRAM.format("import sys\nsys.path.append('..')\nimport poses")},
        {"tools/run.py": PROGRAM.format("def main():\n    import poses")},
        {"tools/run.py": "import poses\n", "other.py": PROGRAM.format("")},
        {"setup.py": "from setuptools import setup\nsetup(name='walk', packages=['shared'])\n"},
    ],
)
def test_where_the_name_is_not_plain_or_the_folder_hides_another(tree: Tree, more: dict[str, str]) -> None:
    assert tree({**SHARED, **more}).python_path == ()


def test_a_module_of_the_standard_library_is_no_file_of_another_folder(tree: Tree) -> None:
    assert tree({"run.py": PROGRAM.format("import code"), "shared/code.py": ""}).python_path == ()


def test_python_2_looks_beside_the_module_that_imports(tree: Tree) -> None:
    page = {"README.md": "# Install\nPython 2.7\n"}
    decision = tree({**FACTORY, **page, "train.py": f"print 'a'\n{FACTORY['train.py']}"})
    assert (decision.python.version, decision.python_path) == ("2.7", ())
