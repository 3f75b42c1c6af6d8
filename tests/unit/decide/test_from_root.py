"""Programs in a folder that import what lies at the root."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
PROGRAM = "{imports}\nif __name__ == '__main__':\n    main()\n"
WALK = {"walk/__init__.py": "", "walk/net.py": "", "requirements.txt": "numpy\n"}
START = {"README.md": "```\npython start.py\n```\n", "start.py": "if __name__ == '__main__':\n    main()\n"}


def tools(imports: str) -> dict[str, str]:
    return {"tools/train.py": PROGRAM.format(imports=imports)}


@pytest.mark.parametrize(
    ("imports", "more"),
    [
        ("from walk.net import Net", {}),
        ("import numpy\nimport walk", {}),
        ("import numpy as np, walk", {}),
        ("from walk import (\n    net,\n)", {}),
        ("import shared", {"shared.py": ""}),
        ("from parts import arm", {"parts/arm.py": ""}),
        ("import walk", START),
        ("import walk", {"README.md": "```\npython -m tools.train\n```\n"}),  # its path is offered too
        ("import walk", {**START, "numpy/arm.py": ""}),  # without __init__.py it hides no package
        ("import walk", {**START, "tools/README.md": "```\npython train.py\n```\n"}),
        ("import walk", {"setup.py": "", "README.md": "```\npython tools/train.py --fast\n```\n"}),
    ],
)
def test_the_root_is_on_the_path(tree: Tree, imports: str, more: dict[str, str]) -> None:
    assert tree({**WALK, **tools(imports), **more}).python_path == (".",)


@pytest.mark.parametrize(
    ("imports", "more"),
    [
        ("import numpy", {}),
        ("import numpy  # of an arm, walk", {}),
        ("import sys\nsys.path.append('.')\nimport walk", {}),
        ("import _paths\nimport walk", {"tools/_paths.py": "import sys\nsys.path.insert(0, ROOT)\n"}),
        ("import walk", {"tools/walk.py": ""}),
        ("import walk", {"tools/walk/__init__.py": ""}),
        ("import walk", {"setup.py": "from setuptools import setup\nsetup(name='walk', packages=['walk'])\n"}),
        ("import code", {"code/__init__.py": ""}),
        ("import gym", {"gym/envs/arm.py": ""}),
        ("import walk", {**START, "queue.py": ""}),  # on the path it would hide Python's own
        ("import walk", {**START, "numpy/__init__.py": ""}),
    ],
)
def test_where_python_finds_it_or_nobody_starts_the_program(tree: Tree, imports: str, more: dict[str, str]) -> None:
    assert tree({**WALK, **tools(imports), **more}).python_path == ()


def test_the_page_of_a_folder_where_the_root_has_none(tree: Tree) -> None:
    pages = {
        "app/README.md": "# App\n## Run\n```\npython run.py\n```\n",
        "tools/README.md": "```\npython train.py\n```\n",
    }
    decision = tree({**WALK, **tools("import walk"), **pages, "app/run.py": PROGRAM.format(imports="import numpy")})
    assert decision.command == ("python", "app/run.py")
    assert decision.python_path == (".",)


def test_a_page_may_name_the_root_itself(tree: Tree) -> None:
    page = "```\nexport PYTHONPATH=$PWD:$PYTHONPATH\npython tools/train.py\n```\n"
    assert tree({**WALK, **tools("import walk"), "README.md": page}).python_path == (".",)


@pytest.mark.parametrize(
    ("imports", "more", "started"),
    [
        ("from tools.other import y", {}, ("python3", "-m", "tools.train")),
        (
            "from tools.other import y",
            {"setup.py": "from setuptools import setup\nsetup(name='walk')\n"},
            ("python3", "tools/train.py"),
        ),
        ("import walk", {}, ("python3", "tools/train.py")),
        ("import numpy", {}, ("python3", "tools/train.py")),
    ],
)
def test_a_program_that_imports_its_own_package_is_started_as_a_module(
    tree: Tree, imports: str, more: dict[str, str], started: tuple[str, ...]
) -> None:
    files = {**WALK, **tools(imports), "tools/other.py": "y = 1\n", **more}
    decision = tree({path: text for path, text in files.items() if path != "README.md"})
    assert decision.command == started


@pytest.mark.parametrize(("said", "variables"), [("`ROUTES=data/a.xml`", (("ROUTES", "data/a.xml"),)), ("a file", ())])
def test_a_variable_whose_value_a_page_gives_below_its_command(
    tree: Tree, said: str, variables: tuple[tuple[str, str], ...]
) -> None:
    page = f"## Usage\n```\nROUTES=[PATH TO ROUTES] ./run_all.sh\n```\nUse {said} for ours.\n"
    decision = tree({**WALK, "README.md": page, "run_all.sh": "python -m walk.net\n", "data/a.xml": ""})
    assert decision.variables == variables


WING = {"src/wing/__init__.py": "", "src/wing/net.py": "", "requirements.txt": "numpy\n"}


@pytest.mark.parametrize(
    ("files", "folders"),
    [
        ({"tools/train.py": PROGRAM.format(imports="from wing.net import Net")}, ("src",)),
        ({"train.py": PROGRAM.format(imports="import wing")}, ("src",)),
        (
            {
                "src/wing/train.py": PROGRAM.format(imports="from wing import net"),
                "README.md": "```\npython src/wing/train.py\n```\n",
            },
            ("src",),
        ),
        ({"src/train.py": PROGRAM.format(imports="import wing")}, ()),  # beside it
        ({"train.py": PROGRAM.format(imports="import wing"), "wing/__init__.py": ""}, ()),
        ({"tools/train.py": PROGRAM.format(imports="import wing\nimport leg"), "leg.py": ""}, ("src", ".")),
        ({"train.py": PROGRAM.format(imports="import sys\nsys.path.append('src')\nimport wing")}, ()),
        (
            {
                "tools/train.py": PROGRAM.format(
                    imports="import sys\nsys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))\nimport wing"
                )
            },
            ("src",),
        ),
        (
            {
                "tools/train.py": PROGRAM.format(
                    imports="import sys\nsys.path.insert(0, str(Path(__file__).resolve().parent.parent))\nimport wing"
                )
            },
            (),
        ),
        (
            {
                "train.py": PROGRAM.format(imports="import wing"),
                "pyproject.toml": "[project]\nname = 'wing'\nversion = '1'\n",
            },
            (),
        ),
    ],
)
def test_a_folder_for_packages_is_on_the_path_where_pip_does_not_install_them(
    tree: Tree, files: dict[str, str], folders: tuple[str, ...]
) -> None:
    assert tree({**WING, **files}).python_path == folders


TABLE = "[project]\nname = 'wing'\nversion = '1'\ndependencies = ['einops>=0.6']\nrequires-python = '>=3.9,<3.10'\n"
BACKEND = "[build-system]\nrequires = ['hatchling']\nbuild-backend = 'hatchling.build'\n"
TABLES = "[tool.hatch.build.targets.wheel]\npackages = [{include = 'wing', from = 'src'}]\n"


@pytest.mark.parametrize(
    ("manifest", "line", "why"),
    [
        (TABLE + BACKEND + TABLE, 9, "is no valid TOML (Cannot declare"),
        ("<<<<<<< HEAD\n" + TABLE + BACKEND, 1, "is no valid TOML"),
        (TABLE + "[tool.isort]\nprofile = black\n", 7, "is no valid TOML"),
        (TABLE + BACKEND + TABLES, 1, "hatchling refuses it"),
        (TABLE + BACKEND, 0, ""),
        (TABLE + BACKEND + TABLES.replace("{include = 'wing', from = 'src'}", "'src/wing'"), 0, ""),
    ],
)
def test_a_manifest_that_pip_refuses_is_told_and_read(tree: Tree, manifest: str, line: int, why: str) -> None:
    files = {key: text for key, text in WING.items() if key != "requirements.txt"}
    decision = tree({**files, "pyproject.toml": manifest, "train.py": PROGRAM.format(imports="import wing")})
    said = [(each.line, each.message) for each in decision.warnings if each.file == "pyproject.toml"]
    assert [number for number, _ in said] == [line] * bool(why)
    assert all(why in message and "is on PYTHONPATH instead" in message for _, message in said)
    assert decision.python.projects == (() if why else (".",))
    assert decision.python_path == ((".", "src") if why else ())
    assert decision.python.version == "3.9"
    asked = [each.written for each in (*decision.python.pip, *decision.python.pip_guessed)]
    assert asked == (["einops>=0.6"] if why else [])
