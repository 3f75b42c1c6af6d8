"""What a block leaves in the background serves the program that it starts then."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
FILES = {
    "serve.sh": "#!/bin/bash\npython3 -m http.server\n",
    "serve.py": "import numpy\n",
    "record_ui.py": "import numpy\n",
    "play.py": "import numpy\n",
    "main.py": "import numpy\n",
    "plot_all.py": "import numpy\n",
    "client.py": "import numpy\n",
    "settings/a.yaml": "a: 1\n",
}
UI = ("python", "record_ui.py")


@pytest.mark.parametrize(
    ("block", "command"),
    [
        ("bash serve.sh > /tmp/log 2>&1 &\npython record_ui.py\n", UI),
        ("python serve.py &  # waits\n./serve.sh &\npython record_ui.py\n", UI),
        ("python serve.py &\n```\n\n```\npython play.py\n", ("python", "serve.py")),  # another block
        ("python serve.py\npython play.py\n", ("python", "serve.py")),
        ("nohup python serve.py > log &\npython play.py\n", ("python", "serve.py")),
        ("python serve.py &&\npython play.py\n", ("python", "serve.py")),
        ("python serve.py &\n", ("python", "serve.py")),
        ("python serve.py &\npython client.py\n", ("python", "serve.py")),
        ("python serve.py &\npython plot_all.py --dir results\n", ("python", "serve.py")),
        (
            "python main.py --seed 0 &\npython main.py --seed 1 &\npython play.py\n",
            ("python", "main.py", "--seed", "0"),
        ),
    ],
)
def test_what_comes_after_it_is_meant(tree: Tree, block: str, command: tuple[str, ...]) -> None:
    assert tree(FILES | {"README.md": f"# Demo\n## Run\n```\n{block}```\n"}).command == command


@pytest.mark.parametrize(
    ("between", "command"),
    [("\nUsage\n-----\n\nThen::\n\n", ("python", "serve.py")), ("", UI), ("\n", UI)],
)
def test_a_block_without_fences_ends_at_the_next_text(tree: Tree, between: str, command: tuple[str, ...]) -> None:
    page = f"Demo\n====\n\nRun\n---\n\nRun::\n\n    python serve.py &\n{between}    python record_ui.py\n"
    assert tree(FILES | {"README.rst": page}).command == command


@pytest.mark.parametrize(
    ("later", "command"),
    [
        ("python play.py --config settings/a.yaml", ("python", "play.py", "--config", "settings/a.yaml")),
        ("python play.py --config b.yaml", ("python", "play.py", "--config", "my.yaml")),
        ("python play.py --seed settings/a.yaml", ("python", "play.py", "--config", "my.yaml")),
    ],
)
def test_a_file_of_the_tree_in_place_of_an_absent_one(tree: Tree, later: str, command: tuple[str, ...]) -> None:
    page = f"# Demo\n## Install\n```\npython play.py --config my.yaml\n```\n## Usage\n```\n{later}\n```\n"
    assert tree(FILES | {"README.md": page.replace("Install", "Quick start")}).command == command


@pytest.mark.parametrize(
    ("script", "command"),
    [
        ("set -e\nsource /home/me/miniconda3/etc/profile.d/conda.sh\npython play.py\n", ("python", "play.py")),
        ("source /home/me/miniconda3/etc/profile.d/conda.sh\npython play.py\n", ("bash", "serve.sh")),  # it goes on
        ("set -e\nsource venv/bin/activate\npython play.py\n", ("bash", "serve.sh")),
    ],
)
def test_a_conda_of_the_authors_home(tree: Tree, script: str, command: tuple[str, ...]) -> None:
    page = "# Demo\n## Run\n```\nbash serve.sh\npython play.py\n```\n"
    assert tree(FILES | {"serve.sh": script, "README.md": page}).command == command
