"""A module with relative imports is no script: Python starts it by its whole name, and others are meant first."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
GUARD = "\n\nif __name__ == '__main__':\n    print(np.zeros(3))\n"
PLAIN = f"import numpy as np{GUARD}"
RELATIVE = f"import numpy as np\nfrom .parts import a{GUARD}"
PARTS = {"air/__init__.py": "", "air/parts.py": "a = 1\n", "requirements.txt": "numpy\n"}


@pytest.mark.parametrize(
    ("files", "command"),
    [
        ({"air/load.py": RELATIVE}, "python3 -m air.load"),
        ({"air/load.py": RELATIVE.replace("from .parts", "from . import parts #")}, "python3 -m air.load"),
        ({"air/load.py": PLAIN}, "python3 air/load.py"),
        (
            {"air/load.py": f"try:\n    from .parts import a\nexcept ImportError:\n    from parts import a\n{PLAIN}"},
            "python3 air/load.py",
        ),
        ({"air/load.py": f"__package__ = 'air'\n{RELATIVE}"}, "python3 air/load.py"),
        ({"air/load.py": RELATIVE, "tell.py": PLAIN}, "python3 tell.py"),
        ({"air/load.py": RELATIVE, "examples/show.py": PLAIN}, "bash"),
        ({"load.py": RELATIVE}, "bash"),
        ({"my-air/load.py": RELATIVE}, "bash"),
    ],
)
def test_how_it_is_started(tree: Tree, files: dict[str, str], command: str) -> None:
    assert " ".join(tree({**PARTS, **files}).command) == command


def test_examples_are_named_before_it(tree: Tree) -> None:
    found = tree({**PARTS, "air/load.py": RELATIVE, "examples/show.py": PLAIN})
    assert found.command_candidates == (("python3", "examples/show.py"), ("python3", "-m", "air.load"))
