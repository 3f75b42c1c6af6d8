"""Settings that a page copies from another file of the tree are copied in the image."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from roslab.decide.decision import Decision
from roslab.pipeline import plan_repository
from roslab.render.dockerfile import dockerfile
from trees import tree_of

Tree = Callable[[dict[str, str]], Decision]
FILES = {
    "main.py": "import numpy\nif __name__ == '__main__':\n    print('a')\n",
    "requirements.txt": "numpy\n",
    "config/config.example.yaml": "speed: 1\n",
    ".env.example": "A=1\n",
}
COPY = "cp config/config.example.yaml config/config.yaml"
RUN = "python main.py --config config/config.yaml"


@pytest.mark.parametrize(
    ("page", "copied"),
    [
        (f"```\n{COPY}\n{RUN}\n```\n", [COPY]),
        (f"1. `{COPY}`\n2. Edit it\n", [COPY]),
        (
            "Rename `config/config.example.yaml` to `config/config.yaml`.\n",
            ["cp config/config.example.yaml config/config.yaml"],
        ),
        ("```\ncd config\ncp config.example.yaml config.yaml\n```\n", [COPY]),
        ("```\ncd config && cp config.example.yaml config.yaml && cd ..\n```\n", [COPY]),
        ("Run `cd config; cp config.example.yaml config.yaml`.\n", [COPY]),
        ("```\ncd config && cp .env.example .env\n```\n", []),  # it is not there
        ("```\ncp .env.example .env  # and edit it\n```\n", ["cp .env.example .env"]),
        ("```\ncp config/config.example.yaml .\n```\n", ["cp config/config.example.yaml config.example.yaml"]),
        (f"```\n{COPY}\n```\n```\ncp .env.example config/config.yaml\n```\n", [COPY]),
        ("Do not rename `config/config.example.yaml` to `config/config.yaml`.\n", []),
        ("```\ncp config/config.example.yaml ~/config.yaml\n```\n", []),
        ("```\ncp config/config.example.yaml ../config.yaml\n```\n", []),
        ("```\ncp config/config.example.yaml gone/config.yaml\n```\n", []),
        ("```\ncp config/gone.yaml config/config.yaml\n```\n", []),
        ("```\ncp main.py setup.py\n```\n", []),
        ("```\ncp main.py requirements.txt\n```\n", []),
        ("```\ncp config/config.example.yaml config/$NAME.yaml\n```\n", []),
    ],
)
def test_what_a_page_copies(tree: Tree, page: str, copied: list[str]) -> None:
    decision = tree({**FILES, "README.md": f"# A\n\n{page}"})
    assert [script.command for script in decision.scripts] == copied


def test_the_command_names_the_copy(tmp_path: Path) -> None:
    tree_of(tmp_path, {**FILES, "README.md": f"# A\n\n```\n{COPY}\n{RUN}\n```\n"})
    plan = plan_repository(tmp_path).plan
    assert plan.run.command == tuple(RUN.split())
    assert not plan.warnings
    assert "# What is copied or written before it is compiled or run" in dockerfile(plan)


def test_a_file_of_the_folder_that_a_page_goes_to_and_not_its_namesake(tree: Tree) -> None:
    files = {**FILES, "other/config.example.yaml": "a: 1\n", "config.example.yaml": "a: 1\n"}
    page = "# A\n```\ncd config && cp config.example.yaml config.yaml\n```\n"
    assert [script.command for script in tree({**files, "README.md": page}).scripts] == [COPY]
