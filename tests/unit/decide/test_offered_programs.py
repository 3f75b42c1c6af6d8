"""Which programs of Python are offered, and which is one that others only import."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from roslab.decide.decision import Decision
from roslab.pipeline import plan_repository

Tree = Callable[[dict[str, str]], Decision]
MAIN = "{}\nif __name__ == '__main__':\n    main()\n"


def test_a_program_is_offered_once(tree: Tree) -> None:
    page = "# Data\n```\npython data/convert.py --all\n```\n"
    files = {"data/convert.py": MAIN.format(""), "a.py": MAIN.format(""), "b.py": MAIN.format("")}
    decision = tree({**files, "README.md": page})
    assert [" ".join(each) for each in decision.command_candidates] == [
        "python data/convert.py --all",
        "python3 a.py",
        "python3 b.py",
    ]


@pytest.mark.parametrize(
    "statement",
    [
        "import layers",
        "from layers import Net",
        "import numpy as np\nfrom nets import layers",
        "import nets.layers as l",
    ],
)
def test_one_that_another_imports_comes_behind_the_others(tree: Tree, statement: str) -> None:
    files = {"layers.py": MAIN.format("import numpy"), "nets/run.py": MAIN.format(statement)}
    assert programs(tree({**files, "use.py": MAIN.format("")})) == ["nets/run.py", "use.py", "layers.py"]


@pytest.mark.parametrize(
    ("importing", "more"),
    [
        ("from others import layered", {}),
        ("import numpy", {"tests/test_layers.py": "import layers\n"}),
        ("import layers", {"old/layers.py": ""}),
    ],
)
def test_what_nobody_imports_keeps_its_place(tree: Tree, importing: str, more: dict[str, str]) -> None:
    files = {"layers.py": MAIN.format("import numpy"), "nets/run.py": MAIN.format(importing)}
    assert programs(tree({**files, **more})) == ["layers.py", "nets/run.py"]


def programs(decision: Decision) -> list[str]:
    return [each[-1] for each in decision.command_candidates]


def test_a_package_is_not_required_and_tried(tmp_path: Path) -> None:
    (tmp_path / "README.md").write_text("# Install\n```\nsudo apt install python3-venv libusb-1.0-0\n```\n", "utf-8")
    (tmp_path / "main.py").write_text(MAIN.format("import numpy"), "utf-8")
    (tmp_path / "requirements.txt").write_text("numpy==1.22.0\n", "utf-8")
    (tmp_path / "roslab.yaml").write_text("format: 3\nbase:\n  ubuntu: jammy\n  python: '3.10'\n", "utf-8")
    plan = plan_repository(tmp_path).plan
    assert "python3-venv" in plan.apt
    assert set(plan.apt).isdisjoint(plan.apt_guessed)
    assert "libusb-1.0-0" in plan.apt_guessed
