"""Programs that pip installs and that a page runs by their names, and projects that compile when they are imported."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from roslab.decide.decision import Decision
from roslab.pipeline import plan_repository
from roslab.render.dockerfile import dockerfile

Tree = Callable[[dict[str, str]], Decision]
PROJECT = """\
[build-system]
requires = ["{backend}"]
build-backend = "{backend}"
[project]
name = "acme"
version = "1"
[project.scripts]
acme-track = "acme.cli:main"
acme-dump = "acme.cli:dump"
"""


def project(page: str, backend: str = "hatchling") -> dict[str, str]:
    code = {"acme/__init__.py": "", "acme/cli.py": "import numpy\n"}
    return {"python/pyproject.toml": PROJECT.format(backend=backend), "README.md": page} | code


@pytest.mark.parametrize(
    ("page", "command"),
    [
        ("```\npip install acme\nacme-track --help\n```\n", ("acme-track", "--help")),
        ("```\nacme-track --help\n```\nThen:\n```\nacme-track --fast\n```\n", ("acme-track", "--fast")),
        ("```bash\n$ acme-track <your data>\n```\n", ("acme-track",)),
        ("The program acme-track does it.\n", ("bash",)),
        ("```\nother-track --help\n```\n", ("bash",)),
        ("## Windows\n```\nacme-track --fast\n```\n", ("bash",)),
        ("```\nacme-track (the core)\n  ├─ acme-dump\n  └─ acme-web\n```\n", ("bash",)),
        ("```\nacme-track\n|-- core\n`-- web\n```\n```\nacme-dump\n```\n", ("acme-dump",)),
    ],
)
def test_a_program_that_the_page_runs(tree: Tree, page: str, command: tuple[str, ...]) -> None:
    assert tree(project(page)).command == command


def test_a_compiled_program_by_its_name(tree: Tree) -> None:
    made = "cmake_minimum_required(VERSION 3.10)\nproject(a)\nadd_executable(solve a.cpp)\nadd_executable(mesh b.cpp)\n"
    files = {"CMakeLists.txt": made, "a.cpp": "#include <vector>\n", "README.md": "```\nsolve --iterations 9\n```\n"}
    assert tree(files).command == ("solve", "--iterations", "9")


SETUP = """\
from setuptools import setup
setup(name="acme", install_requires=["numpy"], {})
"""
FILES = {
    "bin/run_training.py": "#!/usr/bin/env python3\nimport numpy\n",
    "bin/run_node.py": "#!/usr/bin/env python3\nimport click\n@click.option('--weights', prompt='Path')\n",
    "bin/preprocess_data.py": "#!/usr/bin/env python3\nimport numpy\n",
    "scripts/time_network.py": "import numpy\n",
}
PAGE = """\
# Acme
## Data
```
preprocess_data.py
```
## Training
```
run_training.py
```
## Example: Mars
```
run_node.py --weights ~/Downloads/mars.pth
```
## Time the network
```
python scripts/time_network.py
```
"""


@pytest.mark.parametrize(
    ("manifest", "installed"),
    [
        (
            {"setup.py": SETUP.format("scripts=['bin/run_training.py', 'bin/run_node.py', 'bin/preprocess_data.py']")},
            True,
        ),
        (
            {
                "setup.py": "from setuptools import setup\nsetup()\n",
                "setup.cfg": "[metadata]\nname=acme\n[options]\nscripts=\n  bin/run_training.py\n  bin/run_node.py\n",
            },
            True,
        ),
        (
            {
                "pyproject.toml": "[project]\nname = 'acme'\nversion = '1'\n[tool.setuptools]\n"
                "script-files = ['bin/run_training.py', 'bin/run_node.py']\n"
            },
            True,
        ),
        ({"setup.py": SETUP.format("packages=['acme']")}, False),
    ],
)
def test_a_file_that_is_installed_as_a_program(tree: Tree, manifest: dict[str, str], installed: bool) -> None:
    command = tree({**manifest, **FILES, "README.md": PAGE}).command
    assert command == (("run_training.py",) if installed else ("python", "scripts/time_network.py"))


def test_files_that_no_page_runs_by_name_are_no_further_programs(tree: Tree) -> None:
    setup = SETUP.format("scripts=['bin/one.py', 'bin/two.py']")
    guard = "import numpy\nif __name__ == '__main__':\n    pass\n"
    assert tree({"setup.py": setup, "bin/one.py": "", "bin/two.py": "", "main.py": guard}).command == (
        "python3",
        "main.py",
    )


@pytest.mark.parametrize(
    ("backend", "installed"),
    [("hatchling", " --editable ./python"), ("scikit-build-core", " ./python"), ("meson-python", " ./python")],
)
def test_what_compiles_when_imported_is_not_editable(tmp_path: Path, backend: str, installed: str) -> None:
    for path, text in project("", backend).items():
        target = tmp_path / path
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text(text, encoding="utf-8")
    assert f'pip install "$(pip-cache)"{installed}' in dockerfile(plan_repository(tmp_path).plan)


@pytest.mark.parametrize(
    ("given", "files", "found"),
    [
        ("--config cfg/a.yaml", {"python/cfg/a.yaml": "a: 1\n"}, ("--config", "python/cfg/a.yaml")),
        ("--config=./cfg/a.yaml", {"python/cfg/a.yaml": "a: 1\n"}, ("--config=python/cfg/a.yaml",)),
        ("--config cfg/a.yaml", {"python/cfg/a.yaml": "a: 1\n", "cfg/a.yaml": "a: 2\n"}, ("--config", "cfg/a.yaml")),
        ("--config cfg/a.yaml", {"other/cfg/a.yaml": "a: 1\n"}, ("--config", "cfg/a.yaml")),
    ],
)
def test_a_file_in_the_folder_of_the_project(
    tree: Tree, given: str, files: dict[str, str], found: tuple[str, ...]
) -> None:
    decision = tree(project(f"```\ncd python\nuv run acme-track {given}\n```\n") | files)
    assert decision.command == ("acme-track", *found)
    assert any("neither the tree" in warning.message for warning in decision.warnings) == ("other/cfg/a.yaml" in files)
