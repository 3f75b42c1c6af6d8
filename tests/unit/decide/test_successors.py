"""A module that was given up and is only tried, beside the one that took its place, is another way to do the same."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
TRIED = "import mujoco\n\ntry:\n    import mujoco_py\nexcept ImportError:\n    print('pip install mujoco-py')\n"


@pytest.mark.parametrize(
    ("code", "installed"),
    [
        (TRIED, False),
        (TRIED.replace("import mujoco\n", "", 1), True),  # nothing else does it
        ("import mujoco\nimport mujoco_py\n", True),
        ("try:\n    import mujoco\nexcept ImportError:\n    import mujoco_py\n", True),  # as before: both are tried
    ],
)
def test_what_took_its_place_is_enough(tree: Tree, code: str, installed: bool) -> None:
    found = {each.name for each in tree({"run.py": f"{code}print('runs')\n"}).python.pip_guessed}
    assert ("mujoco-py" in found) is installed
