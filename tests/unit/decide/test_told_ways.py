"""What the code tells to install where an import of no table fails: under another name, or from git."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
CODE = "{indent}try:\n{indent}    {statement}\n{indent}except ImportError as error:\n{indent}    {says}\n"
MAIN = "if __name__ == '__main__':\n    main()\n"


def guessed(found: Decision) -> list[str]:
    return [each.text for each in found.python.pip_guessed]


@pytest.mark.parametrize("statement", ["import brumby", "from brumby.arm import (\n        Arm,\n    )"])
@pytest.mark.parametrize(
    ("says", "packages"),
    [
        ("raise ImportError('Install with `pip install git+https://github.com/lab/Brumby-Py.git`.') from error",
         ["git+https://github.com/lab/Brumby-Py.git"]),
        ("raise ImportError(\n        'It is needed: '\n        'pip install brumby-tools'\n    )", ["brumby-tools"]),
        ("raise ImportError('Please install it: pip install brumby-tools')", ["brumby-tools"]),
        ("print('Please pip install brumby-tools==1.2.')\n    raise", ["brumby-tools==1.2"]),
        ("print('pip install brumby-tools or pip install brumby_other')\n    raise", []),
        ("raise ImportError('pip install the package of your arm')", []),
        ("raise ImportError('pip install -r requirements.txt')", []),
        ("# 'pip install brumby-tools'\n    raise", []),
        ("raise", []),
    ],
)  # fmt: skip
def test_what_the_handler_says(tree: Tree, statement: str, says: str, packages: list[str]) -> None:
    code = CODE.format(indent="", statement=statement, says=says)
    found = tree({"drive.py": code + MAIN, "requirements.txt": "scipy\n"})
    assert guessed(found) == packages
    unknown = [each.message for each in found.warnings if "no table knows which package brings it" in each.message]
    assert bool(unknown) is not bool(packages)


def test_one_that_only_a_function_imports(tree: Tree) -> None:
    code = "def load():\n" + CODE.format(
        indent="    ", statement="import brumby", says="raise OSError('pip install brumby-tools')"
    )
    assert guessed(tree({"drive.py": code + MAIN, "requirements.txt": "scipy\n"})) == ["brumby-tools"]


@pytest.mark.parametrize(
    "more",
    [
        {"requirements.txt": "brumby-tools==1.0\n"},
        {"pyproject.toml": "[project]\nname = 'brumby-tools'\nversion = '1'\n"},
        {"brumby/__init__.py": ""},
        {
            "package.xml": "<package><name>a</name><buildtool_depend>catkin</buildtool_depend></package>",
            "CMakeLists.txt": "project(a)\nfind_package(catkin REQUIRED)\n",
        },
    ],
)
def test_what_is_there_or_not_to_be_had(tree: Tree, more: dict[str, str]) -> None:
    code = CODE.format(indent="", statement="import brumby", says="raise OSError('pip install brumby-tools')")
    assert guessed(tree({"drive.py": code + MAIN, "requirements.txt": "scipy\n", **more})) == []


def test_another_handler_says_it_of_another_module(tree: Tree) -> None:
    code = CODE.format(indent="", statement="import brumby", says="brumby = None")
    code += CODE.format(indent="", statement="import waler", says="raise OSError('pip install waler-tools')")
    assert guessed(tree({"drive.py": code + MAIN, "requirements.txt": "scipy\n"})) == ["waler-tools"]
